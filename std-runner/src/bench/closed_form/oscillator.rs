//! A particle that swings along a spring to a pinned particle.

use super::{along, dot};
use crate::model::{ModelParticle, ModelSpring};
use crate::scene::Settings;

/// How far from its direction a motion may be and still be along it, relative.
const ALONG: f64 = 1e-12;

/// A damped oscillator on a line through the pinned particle.
#[derive(Clone, Debug)]
pub(super) struct Oscillator {
    pin: [f64; 3],
    direction: [f64; 3],
    /// Where it would rest, m from the pin.
    rest: f64,
    /// From there at the start, m and m/s.
    offset: f64,
    speed: f64,
    /// Of the undamped spring, 1/s.
    frequency: f64,
    damping_ratio: f64,
}

impl Oscillator {
    /// Nothing if it moves across the spring, or may reach the pin.
    pub(super) fn of(
        particle: &ModelParticle,
        pin: [f64; 3],
        spring: &ModelSpring,
        settings: &Settings,
    ) -> Option<Self> {
        let apart = along(particle.position, pin, -1.0);
        let length = dot(apart, apart).sqrt();
        if length <= 0.0 || spring.stiffness <= 0.0 {
            return None;
        }
        let direction = apart.map(|part| part / length);
        let is_along = |vector: [f64; 3]| {
            let across = along(vector, direction, -dot(vector, direction));
            dot(across, across) <= ALONG * ALONG * dot(vector, vector)
        };
        if !is_along(particle.velocity) || !is_along(settings.gravity) {
            return None;
        }
        let frequency = (spring.stiffness / particle.mass).sqrt();
        let rest = spring.rest_length + dot(settings.gravity, direction) / (frequency * frequency);
        let (offset, speed) = (length - rest, dot(particle.velocity, direction));
        let damping_ratio = spring.damping / (2.0 * (spring.stiffness * particle.mass).sqrt());
        // Undamped it would not go farther than this, and damped it does not.
        let amplitude = offset.hypot(speed / frequency);
        (rest > amplitude).then_some(Self { pin, direction, rest, offset, speed, frequency, damping_ratio })
    }

    pub(super) fn at(&self, time: f64) -> ([f64; 3], [f64; 3]) {
        let (offset, speed) = self.along_spring(time);
        (along(self.pin, self.direction, self.rest + offset), self.direction.map(|part| part * speed))
    }

    fn along_spring(&self, time: f64) -> (f64, f64) {
        let Self { offset: x, speed: v, frequency, damping_ratio, .. } = *self;
        let decay = damping_ratio * frequency;
        let square = 1.0 - damping_ratio * damping_ratio;
        let root = frequency * square.abs().sqrt();
        let decayed = (-decay * time).exp();
        // cos and sin / root, or cosh and sinh / root, or 1 and t, decayed: each with the same equations.
        let (even, odd) = match () {
            () if square > 0.0 => (decayed * (root * time).cos(), decayed * (root * time).sin() / root),
            () if square < 0.0 => {
                // Written so that nothing overflows, and the slow one is no difference of nearly equal numbers.
                let slow = (-frequency / (damping_ratio + root / frequency) * time).exp();
                let fast = (-(decay + root) * time).exp();
                (0.5 * (slow + fast), 0.5 * (slow - fast) / root)
            }
            () => (decayed, decayed * time),
        };
        let push = v + decay * x;
        let offset = x * even + push * odd;
        // d even/dt = ∓root² odd, d odd/dt = even; root² = ±frequency² square.
        let turned = -frequency * frequency * square * odd;
        (offset, x * turned + push * even - decay * offset)
    }
}
