//! What a person should know of a scene before it is run: what will go wrong in it, and what to do about it.

mod explicit;
mod frames;
mod planes;
mod precision;
mod skipped;
mod stability;

use crate::model::Model;
use crate::scene::Settings;
use crate::simulate::Start;

pub use precision::vanishing_time_step;
pub use skipped::{needed, skipped};
pub use stability::{Remedy, limit_in_words};

/// What a piece of advice is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topic {
    /// The time step is past the stability bound of the stepper.
    UnstableTimeStep,
    /// Explicit Euler adds energy to undamped springs.
    GrowingEnergy,
    /// `auto` has to step implicitly.
    ImplicitFallback,
    /// Positions in `f32` lie too far apart for the springs they belong to.
    CoarsePositions,
    /// A step moves particles by less than `f32` can tell.
    LostMotion,
    /// Shorter steps than `f32` gains anything by.
    BelowRounding,
    /// A tolerance that `f32` cannot keep.
    FineTolerance,
    /// Hits are looked for at frames only.
    HitsBetweenFrames,
    /// Particles start beyond a plane.
    BeyondPlane,
    /// `reflect` lets particles at rest sink.
    SinkingAtRest,
    /// There are more frames than steps.
    FramesBetweenSteps,
    /// The recordings are huge.
    LargeRecordings,
}

/// One piece of advice. None of them keeps a scene from running.
#[derive(Clone, Debug, PartialEq)]
pub struct Advice {
    /// What it is about.
    pub topic: Topic,
    /// What is the matter, with its numbers.
    pub message: String,
    /// What to do.
    pub remedy: String,
}

/// A scene that is about to be run.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    /// Its particles, springs and planes.
    pub model: &'a Model,
    /// How it is run.
    pub settings: &'a Settings,
    /// What is known of the run.
    pub start: &'a Start,
    /// The bytes that its recordings take together.
    pub recorded_bytes: u128,
}

/// All that there is to say about a scene.
#[must_use]
pub fn advise(subject: &Subject<'_>) -> Vec<Advice> {
    let mut all = Vec::new();
    all.extend(stability::unstable(subject));
    all.extend(explicit::growing(subject));
    all.extend(stability::implicit_fallback(subject));
    // The worst of what rounding does is enough.
    let rounding =
        [precision::coarse_positions, precision::lost_motion, precision::below_rounding, precision::fine_tolerance];
    all.extend(rounding.into_iter().find_map(|advice| advice(subject)));
    all.extend(planes::beyond(subject));
    all.extend(planes::sinking(subject));
    all.extend(planes::between_frames(subject));
    all.extend(frames::between_steps(subject));
    all.extend(frames::large(subject));
    all
}
