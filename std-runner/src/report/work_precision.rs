//! The work-precision diagram: what each error costs.

use super::looks::look;
use crate::bench::{Bench, Contender, Peer, Point, Swept, winners};
use crate::chart::{Axis, Chart, Curve, Entry, GREY, Look, Scale, Sheet, grey};
use crate::scene::{CollisionForm, Precision, StepperName};
use crate::units::{metres, power_of_ten, seconds};

/// What a run costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// Of one core.
    Time,
    /// Of all forces.
    ForceEvaluations,
}

impl Work {
    fn of(self, point: &Point) -> f64 {
        match self {
            Self::Time => point.seconds,
            Self::ForceEvaluations => point.force_evaluations as f64,
        }
    }

    fn axis(self) -> Axis {
        match self {
            Self::Time => Axis::new("computing time", Scale::Logarithmic, seconds),
            Self::ForceEvaluations => Axis::new("force evaluations", Scale::Logarithmic, power_of_ten),
        }
    }
}

/// The diagrams of some scenes, one below the other; where there are planes, one for each form of collision.
#[must_use]
pub fn work_precision(benches: &[Bench], work: Work) -> Sheet {
    let peers = peer_names(benches);
    let peers = &peers;
    let charts =
        benches.iter().flat_map(|bench| forms(bench).into_iter().map(move |form| chart(bench, form, work, peers)));
    let swept = || benches.iter().flat_map(|bench| &bench.swept).map(|swept| swept.contender);
    let mut legend = legend(swept);
    if work == Work::Time && benches.iter().any(|bench| !bench.peers.is_empty()) {
        legend.push(Entry::Heading("others".to_owned()));
        let names = peer_names(benches).into_iter().enumerate();
        legend.extend(names.map(|(number, name)| Entry::Curve(grey(number), name.to_owned())));
    }
    Sheet { charts: charts.collect(), columns: 1, legend }
}

/// The forms of collision that were measured.
fn forms(bench: &Bench) -> Vec<Option<CollisionForm>> {
    let mut forms: Vec<Option<CollisionForm>> = Vec::new();
    for swept in &bench.swept {
        if !forms.contains(&swept.contender.collision) {
            forms.push(swept.contender.collision);
        }
    }
    forms
}

fn chart(bench: &Bench, form: Option<CollisionForm>, work: Work, peers: &[&str]) -> Chart {
    let all = || bench.swept.iter().flat_map(|swept| &swept.points).filter_map(|point| place(point, work));
    let fastest = winners(bench).into_iter().filter_map(|winner| winner.run);
    let ringed =
        fastest.filter(|(contender, _)| contender.collision == form).filter_map(|(_, point)| place(&point, work));
    let swept = bench.swept.iter().filter(|swept| swept.contender.collision == form);
    let mut x = Axis::new("largest error of a position", Scale::Logarithmic, metres);
    let mut y = work.axis();
    // The same axes for every form, so that they can be compared.
    x.reach = reach(all().map(|(error, _)| error));
    y.reach = reach(all().map(|(_, work)| work));
    Chart {
        title: form.map_or_else(|| bench.name.clone(), |form| format!("{}: {form}", bench.name)),
        x,
        y,
        curves: others(bench, work, peers).into_iter().chain(swept.map(|swept| curve(swept, work))).collect(),
        ringed: ringed.collect(),
        unknown: Some((bench.reference.floor(), "not known".to_owned())),
        orders: vec![1, 2, 4, 8],
    }
}

fn reach(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    values.map(|value| (value, value)).reduce(|(low, high), (value, _)| (low.min(value), high.max(value)))
}

fn place(point: &Point, work: Work) -> Option<(f64, f64)> {
    Some((point.error?, work.of(point)))
}

fn curve(swept: &Swept, work: Work) -> Curve {
    let points = swept.points.iter().filter_map(|point| place(point, work));
    Curve { points: points.collect(), look: look(swept.contender) }
}

/// Of all peers but Hooke itself, each once.
fn peer_names(benches: &[Bench]) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for peer in benches.iter().flat_map(|bench| &bench.peers).filter(|peer| peer.hooke.is_none()) {
        if !names.contains(&peer.label.as_str()) {
            names.push(&peer.label);
        }
    }
    names
}

/// Peers have times, and no force evaluations.
fn others(bench: &Bench, work: Work, names: &[&str]) -> Vec<Curve> {
    let others = bench.peers.iter().filter(|peer| peer.hooke.is_none() && work == Work::Time);
    let curve = |peer: &Peer| Curve {
        points: peer.runs.iter().map(|run| (run.error, run.seconds)).collect(),
        look: grey(names.iter().position(|name| *name == peer.label).unwrap_or(0)),
    };
    others.map(curve).collect()
}

/// What the curves of these are.
fn legend<I: Iterator<Item = Contender>>(ran: impl Fn() -> I) -> Vec<Entry> {
    let mut entries = vec![Entry::Heading("stepper".to_owned())];
    let mut methods: Vec<Contender> = Vec::new();
    for ran in ran().map(|ran| Contender { precision: Precision::F64, collision: None, ..ran }) {
        if !methods.contains(&ran) {
            methods.push(ran);
        }
    }
    methods.sort_by_key(|ran| (StepperName::ALL.iter().position(|known| *known == ran.stepper), ran.is_adaptive));
    entries.extend(methods.iter().map(|ran| Entry::Curve(look(*ran), ran.method())));
    entries.push(Entry::Heading("precision".to_owned()));
    for precision in Precision::ALL.iter().copied().filter(|precision| ran().any(|ran| ran.precision == *precision)) {
        let (stepper, is_adaptive, collision) = (StepperName::default(), false, None);
        let look = Look { colour: GREY, ..look(Contender { stepper, is_adaptive, precision, collision }) };
        entries.push(Entry::Curve(look, precision.to_string()));
    }
    entries.push(Entry::Ringed("fastest to an error".to_owned()));
    entries
}
