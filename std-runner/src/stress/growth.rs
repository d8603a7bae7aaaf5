//! By how much a step amplifies a small change.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use hooke::{Reflect, StepReport};

use super::frozen::Frozen;
use super::noise::noise;
use crate::scene::StepperName;
use crate::simulate::{AnyStepper, BuildError, HeapWorld, world};

/// How large the change is at first, relative to the length of the springs: what it grows to is still small, and what
/// rounding adds to it smaller yet.
const CHANGE: f64 = 1e-7;
/// Growth by so much ends a run, and so does decay.
const PLAIN: f64 = 1e4;
/// And decay that they may feign: at first all are in step.
const FALLEN: f64 = 1.8;
/// What has become so many times smaller has faded.
const FADED: f64 = 1e3;
/// So many steps at least have to be as small.
const RECENT: usize = 6;
/// Implicit steps are solved to this: their error is not to pass for growth.
const TOLERANCE: f64 = 1e-12;
/// Growth from the second quarter of a run to the last that swings of many frequencies may feign.
const FEIGNED: f64 = 1.3;
/// What a force evaluation costs apart from particles and springs, as so many of them.
const OVERHEAD: f64 = 30.0;
/// Steps of a run, at most and at least.
const STEPS: [u64; 2] = [30_000, 48];

/// What becomes of a small change, step by step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Growth {
    /// What can be told.
    pub trend: Trend,
    /// The factor of one step, in the long run: the spectral radius of its amplification matrix. 1 where it cannot be told
    /// from that; infinite where a step left the finite numbers.
    pub factor: f64,
    /// The least logarithm of a factor that could have been told from 0.
    pub resolution: f64,
    /// The steps that it was measured over.
    pub steps: u64,
}

/// What becomes of it in the long run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trend {
    /// It fades.
    Damped,
    /// It stays as large as it is.
    Kept,
    /// It grows.
    Growing,
}

/// The growth in steps of `dt` seconds, in `f64`, of a scene whose highest frequency (rad/s) is given; nothing if it was
/// interrupted.
///
/// Particles are moved a little and let go. `work` is how many force evaluations, times particles and springs, it may cost:
/// the more, the smaller a growth can be told from none. The stepper goes on from what it remembers: single steps from states that were
/// set would not show what a kept acceleration does.
///
/// # Errors
/// If the scene cannot be stepped.
pub fn growth(
    frozen: &Frozen,
    highest: f64,
    stepper: StepperName,
    dt: f64,
    work: f64,
    interrupted: &AtomicBool,
) -> Result<Option<Growth>, BuildError> {
    let mut world = moved(frozen)?;
    let mut stepper = AnyStepper::<f64>::named(stepper, TOLERANCE);
    let mut course = Course::default();
    let mut most = STEPS[0];
    while course.steps() < most {
        if interrupted.load(Ordering::Relaxed) {
            return Ok(None);
        }
        let Ok(report) = world.view().step(stepper.any(), &mut Reflect, dt) else {
            return Ok(Some(course.exploded()));
        };
        if course.steps() == 0 {
            most = affordable(frozen, &report, work);
        }
        course.follow(frozen, highest, &mut world);
        if course.has_ended() {
            break;
        }
    }
    Ok(Some(course.judged()))
}

/// The scene with every free particle moved a little.
fn moved(frozen: &Frozen) -> Result<HeapWorld<f64>, BuildError> {
    let mut model = frozen.model.clone();
    for (number, particle) in model.particles.iter_mut().enumerate() {
        if frozen.is_free(number) {
            let by = noise(number as u64).map(|part| CHANGE * frozen.length * part);
            particle.position = [0, 1, 2].map(|axis| particle.position[axis] + by[axis]);
        }
    }
    world(&model, [0.0; 3])
}

/// So many steps as the first one.
fn affordable(frozen: &Frozen, first: &StepReport, work: f64) -> u64 {
    let evaluations = f64::from(first.force_evaluations + first.linear_iterations + 8 * first.factorisations).max(1.0);
    let items = (frozen.model.particles.len() + frozen.model.springs.len()) as f64 + OVERHEAD;
    ((work / (evaluations * items)) as u64).clamp(STEPS[1], STEPS[0])
}

/// How large the change is after each step: by the roots of masses, in which swings of different frequency are at right
/// angles, so that none can lend to another.
#[derive(Default)]
struct Course {
    /// The velocities alone, √kg m/s: what moves on as a whole, or lies aside on slack springs, has none, and what fades can
    /// be seen to.
    speed: Vec<f64>,
    /// With the displacements times the highest frequency, √kg m/s: no swing makes that larger than it is at first.
    size: Vec<f64>,
    /// The largest of all velocities, √kg m/s.
    fastest: f64,
}

impl Course {
    fn steps(&self) -> u64 {
        self.size.len() as u64
    }

    fn follow(&mut self, frozen: &Frozen, highest: f64, world: &mut HeapWorld<f64>) {
        let (mut speed, mut way) = (0.0, 0.0);
        for ((position, velocity), rest) in world.view().states().zip(&frozen.model.particles) {
            speed += rest.mass * velocity.length_squared();
            way += rest.mass * (position - glam::DVec3::from(rest.position)).length_squared();
        }
        self.speed.push(speed.sqrt());
        self.fastest = self.fastest.max(speed.sqrt());
        self.size.push((speed + highest * highest * way).sqrt());
    }

    fn has_ended(&self) -> bool {
        let (Some(first), Some(last)) = (self.size.first(), self.size.last()) else { return false };
        // What is small at one moment may only be turning round: then the last eighth is looked at.
        let has_faded = || {
            let recent = self.speed.len().saturating_sub((self.speed.len() / 8).max(RECENT));
            largest(&self.speed, recent..self.speed.len()) * PLAIN < self.fastest
        };
        let is_small =
            self.speed.len() > 2 * RECENT && self.speed.last().is_some_and(|speed| speed * PLAIN < self.fastest);
        *last > PLAIN * first || (is_small && has_faded())
    }

    fn exploded(&self) -> Growth {
        Growth { trend: Trend::Growing, factor: f64::INFINITY, resolution: 0.0, steps: self.steps() + 1 }
    }

    /// From the largest of the second quarter to the largest of the last; of so few steps that they have none, from the
    /// first to the last.
    fn judged(&self) -> Growth {
        let count = self.size.len();
        let (before, after, between) = match count {
            0..16 => (0..1, count.max(1) - 1..count, count.max(2) - 1),
            _ => (count / 4..count / 2, 3 * count / 4..count, count / 2),
        };
        let logarithm = |sizes: &[f64]| match (largest(sizes, before.clone()), largest(sizes, after.clone())) {
            (0.0, 0.0) => 0.0,
            (before, after) => (after / before).ln() / between as f64,
        };
        let resolution = FEIGNED.ln() / between as f64;
        let [speed, size] = [&self.speed, &self.size].map(|sizes| logarithm(sizes));
        let has_grown = largest(&self.size, after.clone()) > FEIGNED * largest(&self.size, 0..count.div_ceil(2));
        let (trend, factor) = if size > resolution && has_grown {
            (Trend::Growing, size.exp())
        } else if speed < -FALLEN.ln() / between as f64 {
            (Trend::Damped, speed.exp())
        } else if largest(&self.speed, after.clone()) * FADED < self.fastest {
            // It has faded into rounding, and what that makes stays.
            (Trend::Damped, FADED.powf(-1.0 / count as f64))
        } else {
            (Trend::Kept, 1.0)
        };
        Growth { trend, factor, resolution, steps: count as u64 }
    }
}

fn largest(sizes: &[f64], range: Range<usize>) -> f64 {
    sizes.get(range).unwrap_or_default().iter().fold(0.0, |largest, size| largest.max(*size))
}
