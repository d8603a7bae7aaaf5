//! Other engines and solvers that were measured on the same scene: `benches/peers/run` writes their table.

use std::path::Path;

use super::Bench;
use super::rows::RowError;
use crate::scene::{Precision, StepperName};

/// How long they run, s: their errors are at its end.
pub const PEERS_RUN: f64 = 1.0;
/// The part of their table that has errors.
const ACCURACY: &str = "accuracy";

/// One of them.
#[derive(Clone, Debug)]
pub struct Peer {
    /// What it is called.
    pub label: String,
    /// If it is Hooke itself: how it stepped.
    pub hooke: Option<(StepperName, Precision)>,
    /// Its runs.
    pub runs: Vec<PeerRun>,
}

/// One run of it.
#[derive(Clone, Copy, Debug)]
pub struct PeerRun {
    /// Its time step, s, or its tolerance.
    pub setting: f64,
    /// s
    pub seconds: f64,
    /// The largest distance of any particle from the reference at the end, m.
    pub error: f64,
}

#[derive(serde::Deserialize)]
struct Row {
    table: String,
    scene: String,
    peer: String,
    name: String,
    setting: Option<f64>,
    unit: String,
    minimum: Option<f64>,
    error_m: Option<f64>,
}

impl Row {
    fn run(&self) -> Option<PeerRun> {
        let factor = match self.unit.as_str() {
            "s" => 1.0,
            "ms" => 1e-3,
            "us" | "µs" => 1e-6,
            _ => return None,
        };
        Some(PeerRun { setting: self.setting?, seconds: factor * self.minimum?, error: self.error_m? })
    }

    /// `hooke:stepper:precision`
    fn hooke(&self) -> Option<(StepperName, Precision)> {
        let mut parts = self.name.split(':');
        let [stepper, precision] = match (parts.next(), parts.next(), parts.next()) {
            (Some("hooke"), Some(stepper), Some(precision)) => [stepper, precision],
            _ => return None,
        };
        Some((stepper.parse().ok()?, precision.parse().ok()?))
    }
}

/// All that ran a scene, in the order of the table.
///
/// # Errors
/// If it is no such table.
pub fn peers(path: &Path, scene: &str) -> Result<Vec<Peer>, RowError> {
    let mut reader = csv::Reader::from_path(path)?;
    let mut peers: Vec<Peer> = Vec::new();
    for row in reader.deserialize() {
        let row: Row = row?;
        let is_asked = row.table == ACCURACY && row.scene == scene;
        // A stepper that has another name now is nobody's rival.
        let is_known = !row.name.starts_with("hooke:") || row.hooke().is_some();
        let Some(run) = row.run().filter(|_| is_asked && is_known) else { continue };
        match peers.iter_mut().find(|peer| peer.label == row.peer) {
            Some(peer) => peer.runs.push(run),
            None => peers.push(Peer { hooke: row.hooke(), label: row.peer, runs: vec![run] }),
        }
    }
    Ok(peers)
}

impl Bench {
    /// How many times as long as here one step of Hooke took where the peers were measured: the median of all runs of the
    /// same stepper and precision. Nothing where there are none.
    #[must_use]
    pub fn other_machine(&self) -> Option<f64> {
        let mut ratios: Vec<f64> = self
            .peers
            .iter()
            .filter_map(|peer| Some((peer.hooke?, &peer.runs)))
            .flat_map(|(how, runs)| runs.iter().filter_map(move |run| self.step_here(how, run)))
            .collect();
        ratios.sort_by(f64::total_cmp);
        ratios.get(ratios.len() / 2).copied()
    }

    /// The time of a step there, in those that one of nearly the same length takes here.
    fn step_here(&self, (stepper, precision): (StepperName, Precision), run: &PeerRun) -> Option<f64> {
        let is = |contender: super::Contender| {
            contender.stepper == stepper && contender.precision == precision && !contender.is_adaptive
        };
        let points = self.swept.iter().filter(|swept| is(swept.contender)).flat_map(|swept| &swept.points);
        let finished = points.filter(|point| point.error.is_some());
        let apart = |step: f64| (step / run.setting).ln().abs();
        let here = finished.min_by(|left, right| apart(left.time_step).total_cmp(&apart(right.time_step)))?;
        let steps_there = PEERS_RUN / run.setting;
        Some(run.seconds / steps_there / (here.seconds / here.steps as f64))
    }

    /// The cheapest run of a peer, other than Hooke, whose error is no larger, m.
    #[must_use]
    pub fn rival(&self, error: f64) -> Option<(&Peer, PeerRun)> {
        let others = self.peers.iter().filter(|peer| peer.hooke.is_none());
        let runs = others.flat_map(|peer| peer.runs.iter().map(move |run| (peer, *run)));
        runs.filter(|(_, run)| run.error <= error)
            .min_by(|(_, left), (_, right)| left.seconds.total_cmp(&right.seconds))
    }
}
