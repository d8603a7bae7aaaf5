//! The time of a world.

/// Seconds since the start, summed with their rounding error kept aside (Neumaier), so that millions of small steps
/// add up to what they should. It is `f64` in every world: a second of 1e-3 s steps is beyond what `f32` can add.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Clock {
    sum: f64,
    residual: f64,
    /// What the steps so far have been short of it, s, where they are to add up to it.
    pub owed: f64,
}

impl Clock {
    /// At 0 s.
    pub const START: Self = Self { sum: 0.0, residual: 0.0, owed: 0.0 };

    /// At a time, s.
    pub fn at(seconds: f64) -> Self {
        Self { sum: seconds, residual: 0.0, owed: 0.0 }
    }

    /// s
    pub fn seconds(self) -> f64 {
        self.sum + self.residual
    }

    /// The clock `duration` seconds later.
    #[must_use]
    pub fn later(self, duration: f64) -> Self {
        let sum = self.sum + duration;
        // Numbers without a sign are in the order of their bits, which any machine can compare.
        let is_larger = self.sum.abs().to_bits() >= duration.abs().to_bits();
        let lost = if is_larger { (self.sum - sum) + duration } else { (duration - sum) + self.sum };
        Self { sum, residual: self.residual + lost, owed: self.owed }
    }
}
