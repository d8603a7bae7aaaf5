//! How far particles in free flight can have come: that their states are finite need not be looked for in each of them.

use crate::Real;
use crate::vectors::{read, size, triples};
use crate::world::View;

/// Bounds on the states of all particles in free flight. Planes only take speed from them, and gravity adds no more than
/// |g| t.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// The time that the flights began, s.
    begun: f64,
    /// No particle was further from the origin then, and no plane is, m.
    distance: f64,
    /// No particle was faster then, m/s.
    speed: f64,
    /// |g|, m/s²
    gravity: f64,
}

impl Extent {
    /// Of nothing known.
    pub const UNKNOWN: Self = Self { begun: 0.0, distance: f64::INFINITY, speed: f64::INFINITY, gravity: 0.0 };

    /// Of the current state, at the time `now`.
    pub fn of<R: Real>(view: &View<'_, R>, now: f64) -> Self {
        // A sum over all of them keeps what is not a number, which a maximum would lose. It is too large by a factor of
        // their number at most, which does not matter here.
        let slots = view.system.plan.attached as usize..view.system.plan.particles as usize;
        let sum = |columns: [&[R]; 3]| {
            let columns = columns.map(|column| column.get(slots.clone()).unwrap_or_default());
            triples(columns).fold(0.0, |sum, vector| sum + size(vector.map(R::to_f64)))
        };
        let (position, velocity) = (read(&view.current.position), read(&view.current.velocity));
        let planes = view.system.planes.iter().fold(0.0, |sum, plane| sum + plane.offset.abs().to_f64());
        Self {
            begun: now,
            distance: sum(position) + planes,
            speed: sum(velocity),
            gravity: size(view.system.gravity.map(R::to_f64)),
        }
    }

    /// Whether it is certain that no state at a time up to this one, nor any number on the way to it, overflows.
    pub fn is_finite_at<R: Real>(&self, time: f64) -> bool {
        let elapsed = time - self.begun;
        let speed = self.speed + self.gravity * elapsed;
        let largest = self.distance + speed * (1.0 + elapsed) + self.gravity;
        // Nothing is ever of a higher power than a discriminant, and a thousand is more than its factors and the
        // roundings of any number of bounces.
        let square = 1000.0 * largest * largest;
        R::from_f64(square).is_finite() && square.is_finite()
    }
}
