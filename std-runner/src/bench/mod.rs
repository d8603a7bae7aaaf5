//! Run time against error: every stepper on one scene, at time steps from the edge of stability down to where rounding
//! takes over, or at tolerances, each run's error measured against a reference.

mod asked;
mod bounces;
mod closed_form;
mod contender;
mod error;
mod finish;
mod kept;
mod peers;
mod point;
mod probe;
mod reference;
mod rows;
mod stamp;
mod sweep;
mod trace;
mod watch;
mod winners;

use std::sync::atomic::AtomicBool;
use std::time::Duration;

use crate::model::Model;
use crate::scene::Settings;
use crate::simulate::RunError;

pub use asked::Asked;
pub use bounces::Bounces;
pub use closed_form::ClosedForm;
pub use contender::Contender;
pub use error::{position_error, velocity_error};
pub use kept::Kept;
pub use peers::{PEERS_RUN, Peer, PeerRun, peers};
pub use point::{CHECKPOINTS, Compared, Point, measure};
pub use probe::{Probe, Probed, State, Vectors, probe, watched};
pub use reference::{MOMENTS, Reference, steps_of};
pub use rows::{RowError, kept, write_rows};
pub use stamp::{Stamp, machine};
pub use sweep::Swept;
pub use trace::{Trace, yardstick};
pub use watch::Seen;
pub use winners::{Recommended, Winner, recommended, winners};

/// A scene, and how it is to be measured.
pub struct Course<'a> {
    /// What is run.
    pub model: &'a Model,
    /// As the scene says; steppers, precisions and time steps are put in their place.
    pub settings: &'a Settings,
    /// When runs are compared with the reference.
    pub compared: Compared,
    /// The first run of a contender that takes longer is its last.
    pub longest: Duration,
    /// Points that need not be measured again.
    pub kept: &'a Kept,
    /// Whether runs are followed moment by moment at the end.
    pub is_traced: bool,
    /// Set from outside to end it, with what there is by then.
    pub interrupted: &'a AtomicBool,
}

/// Everything that was measured of a scene.
#[derive(Clone, Debug)]
pub struct Bench {
    /// The scene's.
    pub name: String,
    /// s
    pub duration: f64,
    /// The relative residual to which implicit steppers solved their steps.
    pub tolerance: f64,
    /// When runs were compared with the reference.
    pub compared: Compared,
    /// Of which scene, program and machine it holds.
    pub stamp: Stamp,
    /// What errors are measured against.
    pub reference: Reference,
    /// Each contender's runs, from the longest time step or the loosest tolerance to the shortest or the tightest.
    pub swept: Vec<Swept>,
    /// Error and energy over time of some of them.
    pub traces: Vec<Trace>,
    /// Others that were measured elsewhere; none but those that are put here.
    pub peers: Vec<Peer>,
    /// Whether it was ended before all had run: what there is holds.
    pub interrupted: bool,
}

/// What there is to tell while a scene is measured.
#[derive(Clone, Copy, Debug)]
pub enum News<'a> {
    /// A reference is being made.
    Reference,
    /// A contender begins: its number, from 1, and how many there are.
    Begins(Contender, usize, usize),
    /// One more run of it is done.
    Point(&'a Point),
    /// It is done.
    Swept(&'a Swept),
    /// All run once more, and those that may win several times.
    Finish,
    /// Runs are followed moment by moment.
    Traces,
}

/// Measures all contenders on a scene; nothing if it was interrupted before there was a reference.
///
/// # Errors
/// If the scene cannot be run at all.
pub fn bench(course: &Course<'_>, mut tell: impl FnMut(News<'_>)) -> Result<Option<Bench>, RunError> {
    tell(News::Reference);
    let Some(reference) = Reference::of(course.model, course.settings, course.interrupted)? else { return Ok(None) };
    let Settings { name, duration, tolerance, .. } = course.settings;
    let mut bench = Bench {
        name: name.clone(),
        duration: *duration,
        tolerance: *tolerance,
        compared: course.compared,
        stamp: Stamp::of(course.model, course.settings, course.compared),
        reference,
        swept: Vec::new(),
        traces: Vec::new(),
        peers: Vec::new(),
        interrupted: false,
    };
    if bench.reference.states.is_empty() {
        // There is nothing to measure errors against.
        return Ok(Some(bench));
    }
    let contenders = Contender::all(course.model);
    for (number, contender) in contenders.iter().enumerate() {
        tell(News::Begins(*contender, number + 1, contenders.len()));
        let mut swept = Swept { contender: *contender, points: Vec::new() };
        let ended = match sweep::sweep(course, &bench.reference, &mut swept, |point| tell(News::Point(point))) {
            Ok(ended) => ended,
            // Its precision cannot hold the scene.
            Err(RunError::Build(_)) => continue,
            Err(error) => return Err(error),
        };
        if ended {
            tell(News::Swept(&swept));
        }
        if !swept.points.is_empty() {
            bench.swept.push(swept);
        }
        if !ended {
            bench.interrupted = true;
            return Ok(Some(bench));
        }
    }
    tell(News::Finish);
    if !finish::finish(course, &bench.reference, &mut bench.swept)? {
        bench.interrupted = true;
        return Ok(Some(bench));
    }
    if course.is_traced {
        tell(News::Traces);
        match trace::traces(course, &bench.reference, &bench.swept)? {
            Some(traces) => bench.traces = traces,
            None => bench.interrupted = true,
        }
    }
    Ok(Some(bench))
}
