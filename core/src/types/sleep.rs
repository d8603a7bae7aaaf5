//! When what rests may sleep.

use crate::Real;

/// When an island, a connected part of the spring graph, falls asleep: it then is not stepped until something from
/// outside wakes it.
///
/// All its particles must have been slower than `speed` for `time`, whenever they were looked at, eight times in that
/// time; and accelerated by less than would have taken them to that speed by the next look. So what swings does not fall
/// asleep where it turns round. Particles that hold it must stand still.
///
/// In `f32` the roundings of a stiff spring's length alone can accelerate a light particle by more than a small speed
/// allows: it then stays awake.
///
/// ```
/// use hooke::{Sleep, World};
///
/// let mut world = World::<f32, 8, 8, 1>::new();
/// world.set_sleep(Some(Sleep::below(0.01).after(0.5)))?; // slower than 1 cm/s for half a second
/// assert!(world.set_sleep(Some(Sleep::below(0.0))).is_err());
/// # Ok::<(), hooke::SetError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sleep<R> {
    /// m/s; positive and finite.
    pub speed: R,
    /// s; positive and finite.
    pub time: R,
}

impl<R: Real> Sleep<R> {
    /// Of what is slower than `speed` (m/s) for a second.
    #[must_use]
    pub fn below(speed: R) -> Self {
        Self { speed, time: R::ONE }
    }

    /// Of what is that slow for another `time`, s.
    #[must_use]
    pub fn after(self, time: R) -> Self {
        Self { time, ..self }
    }

    pub(crate) fn is_sound(&self) -> bool {
        [self.speed, self.time].into_iter().all(|value| value > R::ZERO && value.is_finite())
    }
}
