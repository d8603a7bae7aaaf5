//! Impacts of many particles at once, where each bounces on one plane and flies on, which is what nearly all do.

use super::bounce::{Flight, MOST_BOUNCES, Path, half_square};
use super::events::{SETTLES, SETTLING_TIME};
use crate::Real;
use crate::contact::lies_on;
use crate::types::Plane;
use crate::vectors::{at, dot, put};

/// Particles that are dealt with at once: a vector or two of them.
pub const TOGETHER: usize = 16;

/// Their numbers.
const LANES: core::ops::Range<u32> = 0..TOGETHER as u32;

pub type Lane<T> = [T; TOGETHER];

/// Three columns of so many.
#[derive(Clone, Copy)]
pub struct Vectors<R>(pub [Lane<R>; 3]);

impl<R: Real> Vectors<R> {
    const ZERO: Self = Self([[R::ZERO; TOGETHER]; 3]);

    #[inline(always)]
    pub fn at(&self, lane: u32) -> [R; 3] {
        let Self([x, y, z]) = self;
        [at(x, lane), at(y, lane), at(z, lane)]
    }

    #[inline(always)]
    pub fn put(&mut self, lane: u32, vector: [R; 3]) {
        for (column, component) in self.0.iter_mut().zip(vector) {
            put(column, lane, component);
        }
    }

    #[inline(always)]
    fn take(&mut self, new: &Self, wanted: &Lane<bool>) {
        for (old, new) in self.0.iter_mut().zip(&new.0) {
            take(old, new, wanted);
        }
    }
}

/// Particles, each followed from event to event for as long as it simply bounces.
pub struct Impacts<R> {
    /// As in [`Events`](super::events::Events): the last event of each, and the next one.
    pub position: Vectors<R>,
    pub velocity: Vectors<R>,
    pub acceleration: Vectors<R>,
    pub since: Lane<f64>,
    pub tau: Lane<R>,
    pub plane: Lane<u32>,
    /// The plane of the next event.
    normal: Vectors<R>,
    offset: Lane<R>,
    restitution: Lane<R>,
    /// What has happened to it since it was listed.
    pub hits: Lane<u32>,
    pub lost: Lane<f64>,
    /// After the next event.
    landed: Vectors<R>,
    leaves: Vectors<R>,
    /// Of the impact, m/s.
    speed: Lane<R>,
    /// How long the bounces after it go on, s.
    settling: Lane<R>,
    /// 1 if it is pressed against a plane that it does not leave.
    held: Lane<u32>,
    /// The event after the next one: how long after it, or infinite, and the plane.
    then: Lane<R>,
    next: Lane<u32>,
}

impl<R: Real> Impacts<R> {
    pub const NOWHERE: Self = Self {
        position: Vectors::ZERO,
        velocity: Vectors::ZERO,
        acceleration: Vectors::ZERO,
        since: [0.0; TOGETHER],
        tau: [R::ZERO; TOGETHER],
        plane: [0; TOGETHER],
        normal: Vectors::ZERO,
        offset: [R::ZERO; TOGETHER],
        restitution: [R::ZERO; TOGETHER],
        hits: [0; TOGETHER],
        lost: [0.0; TOGETHER],
        landed: Vectors::ZERO,
        leaves: Vectors::ZERO,
        speed: [R::ZERO; TOGETHER],
        settling: [R::ZERO; TOGETHER],
        held: [0; TOGETHER],
        then: [R::ZERO; TOGETHER],
        next: [0; TOGETHER],
    };

    #[inline(always)]
    pub fn set_plane(&mut self, lane: u32, plane: Option<&Plane<R>>) {
        if let Some(plane) = plane {
            self.normal.put(lane, plane.normal);
            put(&mut self.offset, lane, plane.offset);
            put(&mut self.restitution, lane, plane.restitution);
        }
    }

    /// Bounces each on its plane.
    #[inline(always)]
    pub fn bounce(&mut self, path: &Path<'_, R>) {
        for lane in LANES {
            let plane = Plane {
                normal: self.normal.at(lane),
                offset: at(&self.offset, lane),
                restitution: at(&self.restitution, lane),
            };
            let flight = Flight { position: self.position.at(lane), velocity: self.velocity.at(lane) };
            let (speed, mut flight) = path.impact(&flight, at(&self.tau, lane), &plane, self.acceleration.at(lane));
            flight.put_on(&plane, plane.restitution * speed);
            self.landed.put(lane, flight.position);
            self.leaves.put(lane, flight.velocity);
            put(&mut self.speed, lane, speed);
            put(&mut self.settling, lane, path.settling_time(&plane, speed).unwrap_or(R::INFINITY));
        }
    }

    /// Finds what each meets next if no plane holds it, and whether one does.
    #[inline(always)]
    pub fn look_on(&mut self, path: &Path<'_, R>) {
        self.held = [0; TOGETHER];
        self.next = [0; TOGETHER];
        self.then = [R::INFINITY; TOGETHER];
        for (number, plane) in (0..).zip(path.planes) {
            let plane = *plane;
            let presses = dot(plane.normal, path.gravity) < R::ZERO;
            for lane in LANES {
                let flight = Flight { position: self.landed.at(lane), velocity: self.leaves.at(lane) };
                let held = path.calms(&plane, &flight) | lies_on(&plane, flight.position, flight.velocity);
                let before = at(&self.held, lane);
                put(&mut self.held, lane, before | u32::from(presses & held));
                let (earliest, next) = (at(&self.then, lane), at(&self.next, lane));
                let tau = path.time_to(&plane, &flight, path.gravity).unwrap_or(R::INFINITY);
                put(&mut self.then, lane, if tau < earliest { tau } else { earliest });
                put(&mut self.next, lane, if tau < earliest { number } else { next });
            }
        }
    }

    /// The next event becomes the last one of those that simply bounce, or on a single plane begin to come to rest.
    /// Returns a bit for each that has another one due by `time` that can be dealt with here.
    #[inline(always)]
    pub fn advance(&mut self, path: &Path<'_, R>, uniform: [bool; 3], time: f64) -> u32 {
        let is_only_plane = path.planes.len() == 1;
        let mut bounced = [false; TOGETHER];
        let mut more = [0; TOGETHER];
        for lane in LANES {
            let settling = at(&self.settling, lane);
            let settles = settling.to_f64() <= SETTLING_TIME;
            let bounces = (at(&self.held, lane) == 0) & (!settles | is_only_plane);
            let (hits, since, tau) = (at(&self.hits, lane), at(&self.since, lane), at(&self.tau, lane));
            let speed = at(&self.speed, lane);
            let lost = half_square(speed) - half_square(at(&self.restitution, lane) * speed);
            let before = at(&self.lost, lane);
            let until = since + tau.to_f64();
            let then = if settles { -settling } else { at(&self.then, lane) };
            let (plane, next) = (at(&self.plane, lane), at(&self.next, lane));
            let next = if settles { plane | SETTLES } else { next };
            put(&mut self.hits, lane, hits + u32::from(bounces));
            put(&mut self.lost, lane, if bounces { before + lost } else { before });
            put(&mut self.since, lane, if bounces { until } else { since });
            put(&mut self.tau, lane, if bounces { then } else { tau });
            put(&mut self.plane, lane, if bounces { next } else { plane });
            let is_next = bounces & !settles & (until + then.to_f64() <= time) & (hits + 1 < MOST_BOUNCES);
            put(&mut more, lane, if is_next { 1_u32 << lane } else { 0 });
            put(&mut bounced, lane, bounces);
        }
        self.position.take(&self.landed, &bounced);
        self.velocity.take(&self.leaves, &bounced);
        for ((a, gravity), uniform) in self.acceleration.0.iter_mut().zip(path.gravity).zip(uniform) {
            if !uniform {
                take(a, &[gravity; TOGETHER], &bounced);
            }
        }
        more.iter().fold(0, |all, bit| all | bit)
    }
}

/// Takes new values where they are wanted.
#[inline(always)]
fn take<R: Real>(old: &mut Lane<R>, new: &Lane<R>, wanted: &Lane<bool>) {
    for ((old, new), wanted) in old.iter_mut().zip(new).zip(wanted) {
        *old = if *wanted { *new } else { *old };
    }
}
