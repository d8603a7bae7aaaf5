//! How large and of what colour each particle is drawn.

use super::colours::{BALLS, Colour, JOINT};
use crate::model::{Hold, Model};

/// How one particle is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Look {
    /// Not at all: there are so many that the springs show it better.
    Hidden,
    /// A ball of this radius (m).
    Ball(f32, Colour),
    Pinned,
    OnTrack,
}

/// The looks of all particles, and the distance between neighbours.
#[derive(Clone, Debug)]
pub(super) struct Looks {
    pub(super) particles: Vec<Look>,
    /// The middle one of the springs' lengths, m.
    pub(super) spring_length: f64,
    /// Whether springs form lines rather than nets, and each of them has to be seen by itself.
    pub(super) is_sparse: bool,
    /// Of the largest ball, m.
    pub(super) largest: f64,
}

/// Beyond this many joined particles, balls would hide the springs.
const MANY_JOINTS: usize = 4000;

impl Looks {
    /// `extent` is the scene's, m.
    pub(super) fn new(model: &Model, extent: f64) -> Self {
        let count = model.particles.len();
        let mut joined = vec![false; count];
        for end in model.springs.iter().flat_map(|spring| spring.between) {
            if let Some(joined) = joined.get_mut(end as usize) {
                *joined = true;
            }
        }
        let spring_length = spring_length(model, extent);
        let joints = joined.iter().filter(|joined| **joined).count();
        let loose = gap(model, &joined, extent);
        let ball = (0.3 * loose).min(0.035 * extent);
        let joint = (0.11 * spring_length).min(0.03 * extent);
        let usual = middle_value(model.particles.iter().map(|particle| particle.mass).take(10_000).collect());
        let mut largest = 0.0f64;
        let particles = model.particles.iter().enumerate().map(|(number, particle)| match particle.hold {
            Hold::Pinned => Look::Pinned,
            Hold::Track(_) => Look::OnTrack,
            Hold::Free if joined[number] && joints > MANY_JOINTS => Look::Hidden,
            Hold::Free => {
                let (radius, colour) =
                    if joined[number] { (joint, JOINT) } else { (ball, BALLS[number % BALLS.len()]) };
                // Heavier ones are larger: of one density, but never so much that they cover others.
                let size = (particle.mass / usual.unwrap_or(1.0)).cbrt().clamp(0.6, 1.7);
                let radius = if size.is_finite() { radius * size } else { radius };
                largest = largest.max(radius);
                Look::Ball(radius as f32, colour)
            }
        });
        let particles = particles.collect();
        Self { particles, spring_length, is_sparse: model.springs.len() < 2 * joints, largest }
    }
}

/// The middle one of the springs' lengths, m.
fn spring_length(model: &Model, extent: f64) -> f64 {
    let stride = model.springs.len() / 10_000 + 1;
    let lengths = model.springs.iter().step_by(stride).map(|spring| {
        let [from, to] = spring.between.map(|end| model.particles.get(end as usize));
        match (from, to) {
            (Some(from), Some(to)) => {
                let squared = |axis: usize| (from.position[axis] - to.position[axis]).powi(2);
                (squared(0) + squared(1) + squared(2)).sqrt().max(spring.rest_length)
            }
            _ => spring.rest_length,
        }
    });
    middle_value(lengths.collect()).unwrap_or(extent).min(extent)
}

/// The middle one of some positive numbers.
fn middle_value(mut values: Vec<f64>) -> Option<f64> {
    values.retain(|value| value.is_finite() && *value > 0.0);
    values.sort_unstable_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}

/// The typical distance from a free particle to the nearest other one, m.
fn gap(model: &Model, joined: &[bool], extent: f64) -> f64 {
    let loose: Vec<[f64; 3]> = model
        .particles
        .iter()
        .zip(joined)
        .filter(|(particle, joined)| !**joined && particle.hold == Hold::Free)
        .map(|(particle, _)| particle.position)
        .collect();
    // A few hundred tell the typical distance; their nearest is looked for among all.
    let stride = loose.len() / 200 + 1;
    let nearest = loose.iter().step_by(stride).map(|here| {
        let squared = |there: &[f64; 3]| (0..3).map(|axis| (here[axis] - there[axis]).powi(2)).sum::<f64>();
        loose.iter().map(squared).filter(|squared| *squared > 0.0).fold(f64::INFINITY, f64::min).sqrt()
    });
    middle_value(nearest.collect()).unwrap_or(extent)
}
