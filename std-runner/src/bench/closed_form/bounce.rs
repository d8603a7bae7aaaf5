//! A particle without springs before a plane: its distance from it, flight by flight, to rest.

use super::{along, dot};
use crate::model::{ModelParticle, ModelPlane};

/// One flight is left as it is followed: more bounces than this are not.
const MOST: u32 = 100_000;

/// The motion along the normal of a plane.
#[derive(Clone, Debug)]
pub(super) struct Bounce {
    normal: [f64; 3],
    restitution: f64,
    /// m, m/s, m/s² along the normal.
    gap: f64,
    speed: f64,
    acceleration: f64,
}

impl Bounce {
    /// Nothing if it begins behind the plane, or on it.
    pub(super) fn of(particle: &ModelParticle, plane: &ModelPlane, gravity: [f64; 3]) -> Option<Self> {
        let gap = dot(along(particle.position, plane.point, -1.0), plane.normal);
        let (normal, restitution) = (plane.normal, plane.restitution);
        let (speed, acceleration) = (dot(particle.velocity, normal), dot(gravity, normal));
        (gap > 0.0).then_some(Self { normal, restitution, gap, speed, acceleration })
    }

    /// What the plane makes of a flight through it.
    pub(super) fn at(&self, (position, velocity): ([f64; 3], [f64; 3]), time: f64) -> ([f64; 3], [f64; 3]) {
        let (gap, speed) = self.along_normal(time);
        let free = self.gap + time * (self.speed + 0.5 * time * self.acceleration);
        let free_speed = self.speed + time * self.acceleration;
        (along(position, self.normal, gap - free), along(velocity, self.normal, speed - free_speed))
    }

    fn along_normal(&self, time: f64) -> (f64, f64) {
        let Self { acceleration, restitution, .. } = *self;
        let (mut gap, mut speed, mut left) = (self.gap, self.speed, time);
        for _ in 0..MOST {
            let inner = speed * speed - 2.0 * acceleration * gap;
            let root = inner.max(0.0).sqrt();
            let until = match () {
                () if inner < 0.0 => f64::INFINITY,
                () if speed < 0.0 => 2.0 * gap / (root - speed),
                () if acceleration < 0.0 => (speed + root) / -acceleration,
                () => f64::INFINITY,
            };
            if until >= left {
                return (gap + left * (speed + 0.5 * left * acceleration), speed + left * acceleration);
            }
            left -= until;
            (gap, speed) = (0.0, restitution * root);
            // All flights to come take 2 v / (g (1 − e)) together: at the end of bouncing it rests.
            if acceleration < 0.0 && 2.0 * speed <= left * -acceleration * (1.0 - restitution) {
                return (0.0, 0.0);
            }
        }
        (gap, speed)
    }
}
