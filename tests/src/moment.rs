//! Where all particles are at one time, and how fast they go.

use hooke_runner::model::Model;

/// A state of all particles, in the scene's order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Moment {
    /// m
    pub position: Vec<[f64; 3]>,
    /// m/s
    pub velocity: Vec<[f64; 3]>,
}

impl Moment {
    /// The state that a flat scene starts from.
    #[must_use]
    pub fn start(model: &Model) -> Self {
        Self {
            position: model.particles.iter().map(|p| p.position).collect(),
            velocity: model.particles.iter().map(|p| p.velocity).collect(),
        }
    }

    /// One more particle, at `position` in m with `velocity` in m/s.
    #[must_use]
    pub fn with(mut self, position: [f64; 3], velocity: [f64; 3]) -> Self {
        self.position.push(position);
        self.velocity.push(velocity);
        self
    }
}
