//! How error and energy go with time.

use super::looks::look;
use crate::bench::{Bench, Trace};
use crate::chart::{Axis, Chart, Curve, Entry, Look, Scale, Sheet};
use crate::units::{joules, metres, seconds};

/// The error of runs that cost about the same, over time.
#[must_use]
pub fn error_over_time(bench: &Bench) -> Sheet {
    let of = |trace: &Trace| trace.times.iter().copied().zip(trace.errors.iter().copied()).collect();
    let y = Axis::new("largest error of a position", Scale::Logarithmic, metres);
    sheet(bench, "error over time", y, of)
}

/// What their integrators have added to the energy or taken from it, over time.
#[must_use]
pub fn energy_over_time(bench: &Bench) -> Sheet {
    let of = |trace: &Trace| trace.times.iter().copied().zip(trace.energy.iter().map(|joules| joules.abs())).collect();
    let y = Axis::new("energy added or lost by the stepper", Scale::Logarithmic, joules);
    sheet(bench, "energy residual over time", y, of)
}

fn sheet(bench: &Bench, title: &str, y: Axis, of: impl Fn(&Trace) -> Vec<(f64, f64)>) -> Sheet {
    let curves = bench.traces.iter().map(|trace| Curve { points: of(trace), look: line(trace) });
    let chart = Chart {
        title: format!("{}: {title}", bench.name),
        x: Axis::new("simulated time", Scale::Linear, seconds),
        y,
        curves: curves.collect(),
        ringed: Vec::new(),
        unknown: None,
        orders: Vec::new(),
    };
    let mut legend = vec![Entry::Heading("stepper, time step, computing time".to_owned())];
    for trace in &bench.traces {
        let step = if trace.contender.is_adaptive { trace.asked.to_string() } else { seconds(trace.time_step) };
        let (method, cost) = (trace.contender.method(), seconds(trace.seconds));
        legend.push(Entry::Curve(line(trace), format!("{method}, {step}, {cost}")));
    }
    Sheet { charts: vec![chart], columns: 1, legend }
}

/// With a mark at each moment.
fn line(trace: &Trace) -> Look {
    Look { is_thin: true, ..look(trace.contender) }
}
