//! When a frame is shown, in the GIF's hundredths of a second.

/// Slots of time that frames go into, at most one each.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clock {
    /// Hundredths of a second a slot.
    unit: i64,
    start: Option<f64>,
}

/// Viewers show frames that are shorter than this many hundredths for longer.
const SHORTEST: i64 = 2;

impl Clock {
    pub(super) fn new(frame_rate: f64) -> Self {
        // Faster than viewers go: slots of the shortest time, and frames that find theirs taken are left out.
        let unit = if frame_rate > 100.0 / SHORTEST as f64 { SHORTEST } else { 1 };
        Self { unit, start: None }
    }

    /// The slot of a frame at this time, s; the first frame's is 0.
    pub(super) fn slot(&mut self, time: f64) -> i64 {
        let start = *self.start.get_or_insert(time);
        ((time - start) * 100.0 / self.unit as f64).round() as i64
    }

    /// The shortest time, slots.
    pub(super) fn shortest(&self) -> i64 {
        SHORTEST / self.unit
    }

    /// From one slot to another, hundredths of a second.
    pub(super) fn delay(&self, from: i64, to: i64) -> u16 {
        let delay = to.saturating_sub(from).saturating_mul(self.unit);
        u16::try_from(delay.max(0)).unwrap_or(u16::MAX)
    }
}
