//! What a run is worth.

use hooke::StepError;

use super::case::{Case, Known};
use super::conserved::{energy, momentum};
use super::distance::{farthest, size};
use super::observe::{End, Moment, Observed};
use crate::bench::Vectors;
use crate::scene::Precision;
use crate::units::{counted, seconds};

/// So many roundings of the precision are none.
const ROUNDINGS: f64 = 1e3;
/// An error up to this part of the motion is small.
const SMALL: f64 = 0.01;
/// A motion of so many sizes of the scene that nobody expects is an explosion.
const FAR: f64 = 10.0;

/// The worth of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Right to rounding.
    Exact,
    /// Wrong by at most a hundredth of the motion, or of the energy or momentum that is to be kept.
    Accurate,
    /// Nothing grew, and no more than that is known.
    Stable,
    /// Wrong by more, and bounded.
    Wrong,
    /// It grew beyond bounds; a step that would have left the finite numbers was refused, and the state kept.
    Exploded,
    /// Not begun, or a step was not taken, and it was said why.
    Refused,
    /// Not done in the time it may take.
    TookTooLong,
    /// Something went wrong in silence: a defect of Hooke.
    Defect,
}

/// A verdict, and what it rests on.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// What it is worth.
    pub verdict: Verdict,
    /// Relative to the motion, the energy or the momentum; nothing where none can be given.
    pub error: Option<f64>,
    /// In words; nothing where all is well.
    pub reason: String,
}

impl Verdict {
    /// All, from the best on.
    pub const ALL: [Self; 8] = [
        Self::Exact,
        Self::Accurate,
        Self::Stable,
        Self::Wrong,
        Self::Exploded,
        Self::Refused,
        Self::TookTooLong,
        Self::Defect,
    ];

    /// As tables have it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Accurate => "accurate",
            Self::Stable => "stable",
            Self::Wrong => "stable but wrong",
            Self::Exploded => "exploded",
            Self::Refused => "refused",
            Self::TookTooLong => "took too long",
            Self::Defect => "DEFECT",
        }
    }
}

/// Judges a run of a case in a precision.
pub fn judge(case: &Case, precision: Precision, observed: &Observed) -> Judged {
    let told = |verdict, reason: String| Judged { verdict, error: None, reason };
    match observed {
        Observed::Interrupted => told(Verdict::TookTooLong, "interrupted".to_owned()),
        Observed::Hung => told(Verdict::TookTooLong, "a single step had not ended long after that".to_owned()),
        Observed::Refused(reason) => told(Verdict::Refused, reason.clone()),
        Observed::Ran { moments, end, hits, unconverged, degenerate } => match end {
            End::Silent(what) => told(Verdict::Defect, what.clone()),
            End::TookTooLong { time } => {
                told(Verdict::TookTooLong, format!("{:.0} % of it done", 100.0 * time / case.duration))
            }
            End::Refused { time, error: StepError::NonFinite { particle } } => {
                let reason = format!("particle {particle} in the step after {}; the state was kept", seconds(*time));
                told(Verdict::Exploded, reason)
            }
            End::Refused { time, error } => told(Verdict::Refused, format!("after {}: {error}", seconds(*time))),
            End::Finished => {
                let mut judged = finished(case, precision, moments);
                if let Some(most) = case.most_hits.filter(|most| hits > most) {
                    judged = told(Verdict::Wrong, format!("{hits} hits, where there can be no more than {most}"));
                }
                if judged.verdict > Verdict::Stable {
                    judged.reason += &remarks(case, *unconverged, *degenerate);
                }
                judged
            }
        },
    }
}

/// What the steps told of themselves.
fn remarks(case: &Case, unconverged: u64, degenerate: u32) -> String {
    let mut text = String::new();
    if unconverged > 0 {
        text += &format!("; {unconverged} of {} steps said that they were not solved", case.steps);
    }
    if degenerate > 0 {
        text += &format!("; steps said that {} had no length", counted(u64::from(degenerate), "spring"));
    }
    text
}

/// One that reached its end.
fn finished(case: &Case, precision: Precision, moments: &[Moment]) -> Judged {
    let defect = |reason: &str| Judged { verdict: Verdict::Defect, error: None, reason: reason.to_owned() };
    let [Some(first), Some(last)] = [moments.first(), moments.last()] else {
        return defect("there is no state at the end");
    };
    let mut numbers = moments.iter().flat_map(|moment| moment.position.iter().chain(&moment.velocity).flatten());
    if !numbers.all(|number| number.is_finite()) {
        return defect("a state is not finite, and nobody said so");
    }
    match &case.known {
        Known::Motion { positions, uncertainty } => in_motion(case, precision, moments, positions, *uncertainty),
        Known::NoMoreEnergy | Known::EnergyAndMomentum if is_torn(case, moments) => {
            let reason = format!("a spring became {FAR} times as long as the scene is large");
            Judged { verdict: Verdict::Exploded, error: None, reason }
        }
        Known::NoMoreEnergy => {
            let [before, after] = [first, last].map(|moment| energy(case, moment));
            let gained = (after.sum() - before.sum()).max(0.0);
            let judged = kept("energy", precision, gained, before.scale().max(after.scale()));
            // That it does not grow is all that is known.
            Judged { verdict: judged.verdict.max(Verdict::Stable), ..judged }
        }
        Known::Energy => {
            let [before, after] = [first, last].map(|moment| energy(case, moment));
            kept("energy", precision, after.sum() - before.sum(), before.scale().max(after.scale()))
        }
        Known::EnergyAndMomentum => {
            let [before, after] = [first, last].map(|moment| energy(case, moment));
            let energy = kept("energy", precision, after.sum() - before.sum(), before.scale().max(after.scale()));
            let ([before, _], [after, scale]) = (momentum(case, first), momentum(case, last));
            let change = before.iter().zip(after).map(|(before, after)| (after - before).abs()).fold(0.0, f64::max);
            let momentum = kept("momentum", precision, change, scale.into_iter().fold(0.0, f64::max));
            if momentum.verdict > energy.verdict { momentum } else { energy }
        }
    }
}

/// Whether a spring has become much longer than the scene is large.
fn is_torn(case: &Case, moments: &[Moment]) -> bool {
    let most = FAR * size(&case.model);
    let length = |moment: &Moment, [from, to]: [u32; 2]| {
        let ends = [from, to].map(|end| moment.position.get(end as usize).copied().unwrap_or_default());
        farthest(&ends[..1], &ends[1..])
    };
    moments.iter().any(|moment| case.model.springs.iter().any(|spring| length(moment, spring.between) > most))
}

fn in_motion(case: &Case, precision: Precision, moments: &[Moment], expected: &[Vectors], uncertainty: f64) -> Judged {
    let start: Vectors = case.model.particles.iter().map(|particle| particle.position).collect();
    let motion = expected.iter().map(|positions| farthest(positions, &start)).fold(0.0, f64::max);
    let pairs = moments.iter().skip(1).zip(expected);
    let error = pairs.map(|(moment, expected)| farthest(&moment.position, expected)).fold(0.0, f64::max);
    let size = size(&case.model);
    // Below the smallest normal number there are fewer digits.
    let digits = (epsilon(precision) * size.max(motion)).max(smallest(precision));
    let rounding = ROUNDINGS * digits + uncertainty;
    let scale = if motion > 0.0 { motion } else { size };
    let told = |verdict, reason| Judged { verdict, error: Some(error / scale), reason };
    if smallest(precision) > 1e-3 * size {
        told(Verdict::Wrong, format!("{precision} has no numbers so small"))
    } else if error <= rounding && error > SMALL * motion {
        told(Verdict::Stable, "it moves less than rounding lets one see".to_owned())
    } else if error <= rounding {
        told(Verdict::Exact, String::new())
    } else if error <= SMALL * motion + rounding {
        told(Verdict::Accurate, String::new())
    } else if error > FAR * size.max(motion) {
        told(Verdict::Exploded, format!("off by {}", of(error / scale, "the motion")))
    } else {
        told(Verdict::Wrong, format!("off by {}", of(error / scale, "the motion")))
    }
}

fn kept(what: &str, precision: Precision, change: f64, scale: f64) -> Judged {
    let error = if change == 0.0 { 0.0 } else { change.abs() / scale };
    let told = |verdict, reason| Judged { verdict, error: Some(error), reason };
    if error <= ROUNDINGS * epsilon(precision) {
        told(Verdict::Exact, String::new())
    } else if error <= SMALL {
        told(Verdict::Accurate, String::new())
    } else if error > FAR {
        told(Verdict::Exploded, format!("{what} up by {}", of(error, "what there was")))
    } else {
        let way = if change > 0.0 { "up" } else { "down" };
        told(Verdict::Wrong, format!("{what} {way} by {}", of(error, "what there is")))
    }
}

/// `3.1 % of the motion`, `120 times the motion`.
fn of(part: f64, what: &str) -> String {
    match part {
        0.0..0.0995 => format!("{:.1} % of {what}", 100.0 * part),
        0.0..9.995 => format!("{:.0} % of {what}", 100.0 * part),
        _ => format!("{part:.0e} times {what}"),
    }
}

/// Beside 0.
fn smallest(precision: Precision) -> f64 {
    match precision {
        Precision::F32 | Precision::F32Compensated => f64::from(f32::from_bits(1)),
        Precision::F64 => f64::from_bits(1),
    }
}

fn epsilon(precision: Precision) -> f64 {
    match precision {
        // Forces have no more digits than f32, whatever positions have.
        Precision::F32 | Precision::F32Compensated => f64::from(f32::EPSILON),
        Precision::F64 => f64::EPSILON,
    }
}
