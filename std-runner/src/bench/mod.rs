//! Run time against error: every stepper on one scene, at time steps from the edge of stability down to where rounding
//! takes over, each run's error measured against a reference.

mod probe;
mod reference;
mod sweep;
mod winners;

use std::sync::atomic::AtomicBool;
use std::time::Duration;

use crate::model::Model;
use crate::scene::Settings;
use crate::simulate::RunError;

pub use reference::Reference;
pub use sweep::{Contender, Point, Swept};
pub use winners::{Winner, winners};

/// Everything that was measured.
#[derive(Clone, Debug)]
pub struct Bench {
    /// What errors are measured against.
    pub reference: Reference,
    /// Each contender's runs, from the longest time step to the shortest.
    pub swept: Vec<Swept>,
    /// Whether it was ended before all had run: what there is holds.
    pub interrupted: bool,
}

/// Measures all steppers on a scene, and tells of each when it is done. The first run of a stepper that is longer than
/// `longest` is its last.
///
/// # Errors
/// If the scene cannot be run at all.
pub fn bench(
    model: &Model,
    settings: &Settings,
    longest: Duration,
    interrupted: &AtomicBool,
    mut tell: impl FnMut(&Swept),
) -> Result<Option<Bench>, RunError> {
    let Some(reference) = Reference::of(model, settings, interrupted)? else { return Ok(None) };
    let mut bench = Bench { reference, swept: Vec::new(), interrupted: false };
    if bench.reference.positions.is_empty() {
        // There is nothing to measure errors against.
        return Ok(Some(bench));
    }
    for contender in Contender::all(model) {
        match sweep::sweep(model, settings, contender, &bench.reference, longest, interrupted) {
            Ok(Some(swept)) => {
                tell(&swept);
                bench.swept.push(swept);
            }
            Ok(None) => {
                bench.interrupted = true;
                break;
            }
            // Its precision cannot hold the scene.
            Err(RunError::Build(_)) => {}
            Err(error) => return Err(error),
        }
    }
    Ok(Some(bench))
}
