//! When steps end: a thousand of 1e-3 s end at 1 s, whatever their lengths add up to.

/// Steps of one length, counted from the time that the length was set at.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pace {
    /// The length of a step, s.
    dt: f64,
    /// Where they are counted from, s.
    start: f64,
    /// Those that have been taken.
    pub count: u64,
}

impl Pace {
    /// Steps of `dt` from the time `now` on, if they have not been of that length so far.
    pub fn keep(&mut self, dt: f64, now: f64) {
        if self.dt.to_bits() != dt.to_bits() {
            *self = Self { dt, start: now, count: 0 };
        }
    }

    /// When the next one ends, s.
    pub fn next_end(&self) -> f64 {
        self.start + (self.count + 1) as f64 * self.dt
    }
}
