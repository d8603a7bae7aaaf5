//! Kinematic particles on their tracks.

use hooke::{Real, SetError};

use super::build::{HeapWorld, vector};
use crate::model::{Hold, Model, Track};

/// The particles of a model that follow tracks.
pub struct Tracks<'a> {
    followers: Vec<(u32, &'a Track)>,
}

impl<'a> Tracks<'a> {
    /// Of a model.
    pub fn of(model: &'a Model) -> Self {
        let followers = (0..).zip(&model.particles).filter_map(|(number, particle)| match particle.hold {
            Hold::Track(track) => Some((number, model.tracks.get(track as usize)?)),
            Hold::Free | Hold::Pinned => None,
        });
        Self { followers: followers.collect() }
    }

    /// The times after `from` and up to `to` at which a step has to end: those of keys in between, and `to`.
    pub fn stops(&self, from: f64, to: f64) -> Vec<f64> {
        // A key that is only rounding away from an end of the step is that end.
        let margin = 1e-9 * (to - from);
        let keys = self.followers.iter().flat_map(|(_, track)| {
            let first = track.keys.partition_point(|(time, _)| *time <= from + margin);
            let within = track.keys.iter().skip(first).map(|(time, _)| *time);
            within.take_while(|time| *time < to - margin)
        });
        let mut stops: Vec<f64> = keys.collect();
        stops.sort_by(f64::total_cmp);
        stops.dedup();
        stops.push(to);
        stops
    }

    /// Puts every follower where it is at the time `from`, moving to where it is at `to`; no key lies in between.
    pub fn drive<R: Real>(&self, world: &mut HeapWorld<R>, from: f64, to: f64) -> Result<(), SetError> {
        for (number, track) in &self.followers {
            let position = track.position(from);
            let velocity = track.velocity(0.5 * (from + to));
            world.drive(*number, vector::<R>(position), vector::<R>(velocity))?;
        }
        Ok(())
    }
}

impl Track {
    /// Where it is at a time, m: before the first key and after the last it stands still.
    #[must_use]
    pub fn position(&self, time: f64) -> [f64; 3] {
        match self.around(time) {
            (Some((t_0, x_0)), Some((t_1, x_1))) => {
                let s = (time - t_0) / (t_1 - t_0);
                let mut position = x_0;
                for (component, (a, b)) in position.iter_mut().zip(x_0.into_iter().zip(x_1)) {
                    *component = a + s * (b - a);
                }
                position
            }
            (Some((_, x)), None) | (None, Some((_, x))) => x,
            (None, None) => [0.0; 3],
        }
    }

    /// How fast it moves at a time between keys, m/s.
    #[must_use]
    pub fn velocity(&self, time: f64) -> [f64; 3] {
        match self.around(time) {
            (Some((t_0, x_0)), Some((t_1, x_1))) => {
                let mut velocity = x_1;
                for (component, before) in velocity.iter_mut().zip(x_0) {
                    *component = (*component - before) / (t_1 - t_0);
                }
                velocity
            }
            _ => [0.0; 3],
        }
    }

    /// The last key at or before a time, and the first after it.
    #[expect(clippy::type_complexity, reason = "two keys")]
    fn around(&self, time: f64) -> (Option<(f64, [f64; 3])>, Option<(f64, [f64; 3])>) {
        let after = self.keys.partition_point(|(key, _)| *key <= time);
        (after.checked_sub(1).and_then(|before| self.keys.get(before).copied()), self.keys.get(after).copied())
    }
}
