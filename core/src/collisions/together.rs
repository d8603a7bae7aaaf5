//! Particles that have something due, brought to the lanes in which many bounce at once, and taken back from there.

use super::bounce::{Flight, Path};
use super::due::Due;
use super::events::{Events, SETTLES, half};
use super::impacts::{Impacts, TOGETHER};
use crate::Real;
use crate::vectors::{at, fetch, put, read};
use crate::world::System;

impl<R: Real> Events<'_, R> {
    /// Passes the events of the listed particles up to a time, as [`Events::pass_until`] does to the bit, until one comes
    /// that is not simply a bounce.
    #[inline(always)]
    pub fn pass_together(&mut self, system: &System<'_, R>, due: &mut Due, time: f64) {
        let Some(mut events) = self.lend() else { return };
        let path = Path::of_dynamic(system, half());
        let mut impacts = Impacts::<R>::NOWHERE;
        for lane in 0..TOGETHER as u32 {
            impacts.acceleration.put(lane, path.gravity);
            impacts.set_plane(lane, path.planes.first());
        }
        // The place on the list of the particle in each lane, and a bit for each lane that has one.
        let mut places = [0; TOGETHER];
        let mut busy = 0_u32;
        let mut waiting = 0..due.listed();
        loop {
            // Where a particle has nothing due any more, the next takes its place: some bounce many times, most once.
            let mut idle = !busy & ((1 << TOGETHER) - 1);
            while idle != 0
                && let Some(place) = waiting.next()
            {
                let index = due.index(place);
                if at(events.plane, index) & SETTLES == 0 {
                    let lane = idle.trailing_zeros();
                    idle &= idle - 1;
                    busy |= 1 << lane;
                    put(&mut places, lane, place);
                    events.bring(index, &mut impacts, lane);
                }
            }
            if busy == 0 {
                break;
            }
            if path.planes.len() > 1 {
                for lane in 0..TOGETHER as u32 {
                    impacts.set_plane(lane, path.planes.get(at(&impacts.plane, lane) as usize));
                }
            }
            impacts.bounce(&path);
            impacts.look_on(&path);
            let more = impacts.advance(&path, *events.uniform, time);
            let mut done = busy & !more;
            busy &= more;
            while done != 0 {
                let lane = done.trailing_zeros();
                done &= done - 1;
                let place = at(&places, lane);
                events.take_back(due.index(place), &impacts, lane);
                if let Some(bounces) = due.bounces_mut(place) {
                    (bounces.hits, bounces.lost) = (at(&impacts.hits, lane), at(&impacts.lost, lane));
                }
            }
        }
    }

    #[inline(always)]
    fn bring(&self, index: u32, impacts: &mut Impacts<R>, lane: u32) {
        impacts.position.put(lane, fetch(read(&self.position), index));
        impacts.velocity.put(lane, fetch(read(&self.velocity), index));
        let accelerations = impacts.acceleration.0.iter_mut().zip(&self.acceleration).zip(*self.uniform);
        for ((lanes, column), uniform) in accelerations {
            if !uniform {
                put(lanes, lane, at(column, index));
            }
        }
        put(&mut impacts.since, lane, at(self.since, index));
        put(&mut impacts.tau, lane, at(self.tau, index));
        put(&mut impacts.plane, lane, at(self.plane, index));
        put(&mut impacts.hits, lane, 0);
        put(&mut impacts.lost, lane, 0.0);
    }

    #[inline(always)]
    fn take_back(&mut self, index: u32, impacts: &Impacts<R>, lane: u32) {
        let accelerations = self.acceleration.iter_mut().zip(&impacts.acceleration.0).zip(*self.uniform);
        for ((column, lanes), uniform) in accelerations {
            if !uniform {
                put(column, index, at(lanes, lane));
            }
        }
        let flight = Flight { position: impacts.position.at(lane), velocity: impacts.velocity.at(lane) };
        let (since, tau) = (at(&impacts.since, lane), at(&impacts.tau, lane));
        self.record(index, flight, since, tau, at(&impacts.plane, lane));
    }
}
