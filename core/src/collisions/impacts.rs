//! Impacts of many particles at once, where each bounces on one plane and flies on, which is what nearly all do.

use super::bounce::{Bounces, Flight, MOST_BOUNCES, Path, half_square};
use super::events::{Events, SETTLES, SETTLING_TIME, half};
use crate::Real;
use crate::contact::lies_on;
use crate::types::Plane;
use crate::vectors::{ColumnsMut, at, dot, fetch, put, read, store};
use crate::world::System;

/// Particles that are dealt with at once: a vector or two of them.
pub const TOGETHER: usize = 16;

/// No plane.
const NONE: u32 = u32::MAX;

/// One event of each of so many particles.
struct Impacts<R> {
    position: [[R; TOGETHER]; 3],
    velocity: [[R; TOGETHER]; 3],
    acceleration: [[R; TOGETHER]; 3],
    tau: [R; TOGETHER],
    normal: [[R; TOGETHER]; 3],
    offset: [R; TOGETHER],
    restitution: [R; TOGETHER],
    /// Of the impact, m/s.
    speed: [R; TOGETHER],
    /// How long the bounces after it go on, s.
    settling: [R; TOGETHER],
    /// 1 if it is pressed against a plane that it does not leave.
    held: [u32; TOGETHER],
    /// The next plane, or [`NONE`].
    next: [u32; TOGETHER],
}

fn columns<R>(columns: &mut [[R; TOGETHER]; 3]) -> ColumnsMut<'_, R> {
    columns.each_mut().map(<[R; TOGETHER]>::as_mut_slice)
}

impl<R: Real> Impacts<R> {
    const NOWHERE: Self = Self {
        position: [[R::ZERO; TOGETHER]; 3],
        velocity: [[R::ZERO; TOGETHER]; 3],
        acceleration: [[R::ZERO; TOGETHER]; 3],
        tau: [R::ZERO; TOGETHER],
        normal: [[R::ZERO; TOGETHER]; 3],
        offset: [R::ZERO; TOGETHER],
        restitution: [R::ZERO; TOGETHER],
        speed: [R::ZERO; TOGETHER],
        settling: [R::ZERO; TOGETHER],
        held: [0; TOGETHER],
        next: [NONE; TOGETHER],
    };

    #[inline(always)]
    fn flight(&self, lane: u32) -> Flight<R> {
        let of = |[x, y, z]: &[[R; TOGETHER]; 3]| [at(x, lane), at(y, lane), at(z, lane)];
        Flight { position: of(&self.position), velocity: of(&self.velocity) }
    }

    #[inline(always)]
    fn set_flight(&mut self, lane: u32, flight: Flight<R>) {
        store(&mut columns(&mut self.position), lane, flight.position);
        store(&mut columns(&mut self.velocity), lane, flight.velocity);
    }

    /// Bounces each on its plane.
    #[inline(always)]
    fn bounce(&mut self, path: &Path<'_, R>) {
        for lane in 0..TOGETHER as u32 {
            let of = |[x, y, z]: &[[R; TOGETHER]; 3]| [at(x, lane), at(y, lane), at(z, lane)];
            let plane = Plane {
                normal: of(&self.normal),
                offset: at(&self.offset, lane),
                restitution: at(&self.restitution, lane),
            };
            let tau = at(&self.tau, lane);
            let (speed, mut flight) = path.impact(&self.flight(lane), tau, &plane, of(&self.acceleration));
            flight.put_on(&plane, plane.restitution * speed);
            self.set_flight(lane, flight);
            put(&mut self.speed, lane, speed);
            put(&mut self.settling, lane, path.settling_time(&plane, speed).unwrap_or(R::INFINITY));
        }
    }

    /// Finds what each meets next if no plane holds it, and whether one does.
    #[inline(always)]
    fn look_on(&mut self, path: &Path<'_, R>) {
        self.held = [0; TOGETHER];
        self.next = [NONE; TOGETHER];
        self.tau = [R::INFINITY; TOGETHER];
        for (number, plane) in (0..).zip(path.planes) {
            let presses = dot(plane.normal, path.gravity) < R::ZERO;
            for lane in 0..TOGETHER as u32 {
                let flight = self.flight(lane);
                let held = path.calms(plane, &flight) | lies_on(plane, flight.position, flight.velocity);
                let before = at(&self.held, lane);
                put(&mut self.held, lane, before | u32::from(presses & held));
                let (earliest, next) = (at(&self.tau, lane), at(&self.next, lane));
                if let Some(tau) = path.time_to(plane, &flight, path.gravity)
                    && (next == NONE || tau < earliest)
                {
                    put(&mut self.tau, lane, tau);
                    put(&mut self.next, lane, number);
                }
            }
        }
    }
}

impl<R: Real> Events<'_, R> {
    /// Passes the events of some particles up to a time, as [`Events::pass_until`] does to the bit, until one comes that
    /// is not simply a bounce.
    #[inline(always)]
    pub fn pass_together(&mut self, system: &System<'_, R>, particles: &[u32], time: f64, bounces: &mut [Bounces]) {
        // Held particles meet no planes: nothing of theirs is ever due.
        let path = Path { planes: system.planes, gravity: system.gravity, curvature: half() };
        let mut impacts = Impacts::<R>::NOWHERE;
        // Which of the particles are being dealt with; where one has nothing due any more, the next takes its place.
        let mut due = [0; TOGETHER];
        let mut left = 0;
        let mut waiting = 0..particles.len() as u32;
        loop {
            for (place, number) in due.iter_mut().skip(left as usize).zip(&mut waiting) {
                *place = number;
                left += 1;
            }
            if left == 0 {
                break;
            }
            for (lane, number) in (0..left).zip(due) {
                self.gather(&path, at(particles, number), &mut impacts, lane);
            }
            impacts.bounce(&path);
            impacts.look_on(&path);
            let mut still = 0;
            for (lane, number) in (0..left).zip(due) {
                let index = at(particles, number);
                let Some(bounces) = bounces.get_mut(number as usize) else { continue };
                if self.scatter(&path, index, &impacts, lane, bounces)
                    && at(self.due, index) <= time
                    && bounces.hits < MOST_BOUNCES
                {
                    put(&mut due, still, number);
                    still += 1;
                }
            }
            left = still;
        }
    }

    #[inline(always)]
    fn gather(&self, path: &Path<'_, R>, index: u32, impacts: &mut Impacts<R>, lane: u32) {
        impacts.set_flight(lane, self.last(index));
        store(&mut columns(&mut impacts.acceleration), lane, fetch(read(&self.acceleration), index));
        put(&mut impacts.tau, lane, R::from_f64(at(self.tau, index)));
        if let Some(plane) = path.planes.get(at(self.plane, index) as usize) {
            store(&mut columns(&mut impacts.normal), lane, plane.normal);
            put(&mut impacts.offset, lane, plane.offset);
            put(&mut impacts.restitution, lane, plane.restitution);
        }
    }

    /// Records what came of a particle; false, and nothing, if it did not simply bounce.
    #[inline(always)]
    fn scatter(
        &mut self,
        path: &Path<'_, R>,
        index: u32,
        impacts: &Impacts<R>,
        lane: u32,
        bounces: &mut Bounces,
    ) -> bool {
        let comes_to_rest = at(&impacts.held, lane) > 0 || at(&impacts.settling, lane).to_f64() <= SETTLING_TIME;
        if comes_to_rest || at(self.plane, index) & SETTLES != 0 {
            return false;
        }
        let speed = at(&impacts.speed, lane);
        bounces.hits += 1;
        bounces.lost += half_square(speed) - half_square(at(&impacts.restitution, lane) * speed);
        let until = at(self.since, index) + at(self.tau, index);
        let next = at(&impacts.next, lane);
        let next = (next != NONE).then(|| (at(&impacts.tau, lane), next));
        self.record(index, impacts.flight(lane), path.gravity, until, next);
        true
    }
}
