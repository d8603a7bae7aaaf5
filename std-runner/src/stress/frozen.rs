//! The start of a scene made a point of rest, so that what becomes of a small change shows how steps amplify, and nothing
//! else.

use crate::model::{Hold, Model, ModelParticle, ModelSpring};

/// The stiffness of what holds a particle still, as a part of that of its own springs: too little to be felt.
const SOFT: f64 = 1e-9;

/// A scene at rest where it starts: without gravity, planes, velocities and motion from outside. What its springs pull at
/// the start is held by a soft, very long spring for each particle, which pulls the same wherever the particle is.
///
/// A spring that is compressed pushes sideways whatever leaves its line: that is buckling, it grows at any time step, and
/// is no fault of the stepper. It is left out by making such a spring as long as it is, as the block bound does.
#[derive(Clone, Debug)]
pub struct Frozen {
    /// The scene's particles in their order, then the far ends of the springs that hold them.
    pub model: Model,
    /// The scene's own particles.
    pub particles: usize,
    /// Those of its springs that are shorter than their rest length.
    pub compressed: usize,
    /// The length of the springs, on average, m: a small change is small beside it. 1 without any.
    pub length: f64,
}

impl Frozen {
    /// Of a scene's start.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        let particles = model.particles.iter().map(resting).collect();
        let springs: Vec<ModelSpring> = model.springs.iter().map(|spring| unbuckled(model, spring)).collect();
        let is_shorter = |now: f64, was: f64| now < was * (1.0 - 1e-12);
        let pairs = springs.iter().zip(&model.springs);
        let compressed = pairs.filter(|(now, was)| is_shorter(now.rest_length, was.rest_length));
        let compressed = compressed.count();
        let lengths: f64 = model.springs.iter().map(|spring| size(along(model, spring))).sum();
        let length = if lengths > 0.0 { lengths / model.springs.len() as f64 } else { 1.0 };
        let mut frozen = Self {
            particles: model.particles.len(),
            model: Model { particles, springs, ..Model::default() },
            compressed,
            length,
        };
        frozen.hold_still();
        frozen
    }

    /// Whether a particle moves.
    #[must_use]
    pub fn is_free(&self, particle: usize) -> bool {
        self.model.particles.get(particle).is_some_and(|particle| particle.hold == Hold::Free)
    }

    /// Takes the net force from every particle.
    fn hold_still(&mut self) {
        let mut force = vec![[0.0; 3]; self.particles];
        let mut stiffness = vec![0.0; self.particles];
        for spring in &self.model.springs {
            let d = along(&self.model, spring);
            let length = size(d);
            let pull = if length > 0.0 { spring.stiffness * (1.0 - spring.rest_length / length) } else { 0.0 };
            for (end, sign) in spring.between.into_iter().zip([1.0, -1.0]) {
                if let Some(force) = force.get_mut(end as usize) {
                    *force = [0, 1, 2].map(|axis| force[axis] + sign * pull * d[axis]);
                }
                if let Some(sum) = stiffness.get_mut(end as usize) {
                    *sum += spring.stiffness;
                }
            }
        }
        for (number, (force, stiffness)) in (0..).zip(force.into_iter().zip(stiffness)) {
            if force != [0.0; 3] && self.is_free(number as usize) {
                self.hold(number, force, SOFT * stiffness);
            }
        }
    }

    fn hold(&mut self, number: u32, force: [f64; 3], stiffness: f64) {
        let Some(particle) = self.model.particles.get(number as usize).copied() else { return };
        let far = [0, 1, 2].map(|axis| particle.position[axis] - force[axis] / stiffness);
        let end = self.model.particles.len() as u32;
        self.model.particles.push(ModelParticle { position: far, hold: Hold::Pinned, ..particle });
        self.model.springs.push(ModelSpring { between: [number, end], stiffness, damping: 0.0, rest_length: 0.0 });
    }
}

fn resting(particle: &ModelParticle) -> ModelParticle {
    let hold = if particle.hold == Hold::Free { Hold::Free } else { Hold::Pinned };
    ModelParticle { velocity: [0.0; 3], hold, ..*particle }
}

fn unbuckled(model: &Model, spring: &ModelSpring) -> ModelSpring {
    ModelSpring { rest_length: spring.rest_length.min(size(along(model, spring))), ..*spring }
}

/// From the first end to the second, m.
fn along(model: &Model, spring: &ModelSpring) -> [f64; 3] {
    let [from, to] =
        spring.between.map(|end| model.particles.get(end as usize).map_or([0.0; 3], |particle| particle.position));
    [0, 1, 2].map(|axis| to[axis] - from[axis])
}

fn size([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}
