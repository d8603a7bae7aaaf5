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
