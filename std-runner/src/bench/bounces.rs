//! When particles bounce, and how deep they get into planes: seen from the states after each step.

use crate::model::{Hold, Model, ModelPlane};
use crate::record::{Frame, Sample};
use crate::scene::{CollisionForm, Settings};

/// Of each particle so many bounces are noted.
const MOST: usize = 16;
/// Two bounces that are fewer steps apart than this are not told apart.
const APART: f64 = 4.0;

/// What happened at planes.
#[derive(Clone, Debug, Default)]
pub struct Bounces {
    /// When each particle bounced, s: by its number, at most sixteen of each.
    pub times: Vec<Vec<f64>>,
    /// The largest depth beyond a plane after any step, m.
    pub penetration: f64,
}

impl Bounces {
    /// The largest difference between the times of the same bounce of the same particle, s; nothing if there is none to
    /// compare. Bounces that follow each other within a few steps of `time_step` seconds, and all later ones of that
    /// particle, are left out: a run cannot tell them apart.
    #[must_use]
    pub fn error(&self, reference: &Self, time_step: f64) -> Option<f64> {
        let particles = self.times.iter().zip(&reference.times);
        let errors = particles.flat_map(|(times, trusted)| {
            let apart = |number: usize| {
                let next = trusted.get(number + 1).copied().unwrap_or(f64::INFINITY);
                trusted.get(number).is_some_and(|time| next - time > APART * time_step)
            };
            let distinct = (0..times.len().min(trusted.len())).take_while(move |number| apart(*number));
            distinct.filter_map(|number| Some((times.get(number)? - trusted.get(number)?).abs()))
        });
        errors.reduce(f64::max)
    }
}

/// The state of one particle along the normal of a plane.
#[derive(Clone, Copy, Debug)]
struct Along {
    /// Distance from the plane, m.
    gap: f64,
    /// m/s
    speed: f64,
}

/// Looks at planes step by step.
pub(super) struct OnPlanes {
    planes: Vec<ModelPlane>,
    /// Along each plane's normal, m/s².
    gravity: Vec<f64>,
    /// Which particles are free, and which of them have springs.
    is_free: Vec<bool>,
    is_sprung: Vec<bool>,
    /// Whether hits are found inside steps, and not only answered at their ends.
    is_inside: bool,
    time: f64,
    /// By plane and particle, after the step before.
    before: Vec<Vec<Along>>,
    /// Of the step before, m/s²; nothing if it had a bounce.
    acceleration: Vec<Vec<Option<f64>>>,
    bounces: Bounces,
}

impl OnPlanes {
    pub(super) fn new(model: &Model, settings: &Settings) -> Self {
        let particles = model.particles.len();
        let mut is_sprung = vec![false; particles];
        for end in model.springs.iter().flat_map(|spring| spring.between) {
            if let Some(sprung) = is_sprung.get_mut(end as usize) {
                *sprung = true;
            }
        }
        let is_inside = settings.collision == CollisionForm::TimeOfImpact;
        Self {
            gravity: model.planes.iter().map(|plane| dot(settings.gravity, plane.normal)).collect(),
            is_free: model.particles.iter().map(|particle| particle.hold == Hold::Free).collect(),
            is_sprung,
            is_inside,
            time: 0.0,
            before: Vec::new(),
            acceleration: vec![vec![None; particles]; model.planes.len()],
            bounces: Bounces { times: vec![Vec::new(); particles], penetration: 0.0 },
            planes: model.planes.clone(),
        }
    }

    /// Given when hits cut steps, in order: where springs pull, the nearest of them is the time that was meant.
    pub(super) fn take(&mut self, cuts: &[f64]) -> Bounces {
        let mut bounces = std::mem::take(&mut self.bounces);
        let sprung =
            bounces.times.iter_mut().zip(&self.is_sprung).filter(|(_, is_sprung)| **is_sprung && self.is_inside);
        for time in sprung.flat_map(|(times, _)| times) {
            let after = cuts.partition_point(|cut| cut < time);
            let around = cuts.get(after.saturating_sub(1)..cuts.len().min(after + 1)).unwrap_or_default();
            let nearest = around.iter().min_by(|left, right| (*left - *time).abs().total_cmp(&(*right - *time).abs()));
            *time = nearest.copied().unwrap_or(*time);
        }
        bounces
    }

    pub(super) fn see<R: Sample>(&mut self, frame: &Frame<'_, R>) {
        let along = |plane: &ModelPlane| -> Vec<Along> {
            let states = frame.position.iter().zip(frame.velocity);
            states
                .map(|(position, velocity)| {
                    let (position, velocity) = (position.map(R::to_f64), velocity.map(R::to_f64));
                    let from = [0, 1, 2].map(|axis| position[axis] - plane.point[axis]);
                    Along { gap: dot(from, plane.normal), speed: dot(velocity, plane.normal) }
                })
                .collect()
        };
        let now: Vec<Vec<Along>> = self.planes.iter().map(along).collect();
        let step = frame.time - self.time;
        for particle in 0..frame.position.len() {
            if !self.is_free[particle] {
                continue;
            }
            let planes = now.iter().enumerate().filter_map(|(plane, after)| Some((plane, *after.get(particle)?)));
            // Planes that lie nearly in one another are one: a particle bounces once a step.
            let first = planes.filter_map(|(plane, after)| self.hit(plane, particle, after, step)).reduce(f64::min);
            if let Some((times, hit)) = self.bounces.times.get_mut(particle).zip(first)
                && times.len() < MOST
            {
                times.push(self.time + hit);
            }
        }
        (self.before, self.time) = (now, frame.time);
    }

    /// When a particle meets a plane in a step, s from its start; nothing if it does not.
    fn hit(&mut self, plane: usize, particle: usize, after: Along, step: f64) -> Option<f64> {
        self.bounces.penetration = self.bounces.penetration.max(-after.gap);
        let before = *self.before.get(plane)?.get(particle)?;
        let felt = self.acceleration.get_mut(plane)?.get_mut(particle)?;
        let acceleration = match *felt {
            Some(acceleration) if self.is_sprung[particle] => acceleration,
            _ => self.gravity[plane],
        };
        // What it would be without the plane. A bounce makes up for more than that, and nothing else does.
        let unhindered = before.speed + acceleration * step;
        let (hit, impact) = if self.is_inside {
            reached(before, acceleration, step)
        } else {
            // Put back on the plane, a particle may be a rounding above it.
            ((after.gap <= 1e-2 * -before.speed * step).then_some(step), -unhindered)
        };
        let is_bounce = before.speed < 0.0 && impact > 0.0 && after.speed - unhindered > 0.5 * impact;
        let hit = hit.filter(|_| is_bounce);
        *felt = if hit.is_none() { Some((after.speed - before.speed) / step) } else { None };
        hit
    }
}

/// When a particle meets a plane with so much acceleration, s, nothing if that is not within a step; and how fast, m/s.
fn reached(before: Along, acceleration: f64, step: f64) -> (Option<f64>, f64) {
    let Along { gap, speed } = before;
    let inner = speed * speed - 2.0 * acceleration * gap;
    let impact = inner.max(0.0).sqrt();
    // It starts towards the plane: the first time is this one, and it has no difference of nearly equal numbers.
    let time = 2.0 * gap / (impact - speed);
    ((inner >= 0.0 && time <= step * (1.0 + 1e-9)).then(|| time.max(0.0)), impact)
}

fn dot(left: [f64; 3], right: [f64; 3]) -> f64 {
    left.iter().zip(right).map(|(left, right)| left * right).sum()
}
