//! Particles in free flight between events.

use core::ops::Range;

use super::events::{Events, half};
use crate::Real;
use crate::lanes::{SixColumns, run_on_six};
use crate::vectors::{Columns, read, window, window_mut};
use crate::world::{State, System, TILE, tiles};

/// Writes the states at a `time` of some particles to `next`, from their last events on, along the axes that are asked
/// for.
pub fn coast<R: Real>(
    system: &System<'_, R>,
    events: &Events<'_, R>,
    particles: Range<u32>,
    time: f64,
    axes: [bool; 3],
    next: State<'_, R>,
) {
    let [since] = window([&*events.since], particles.clone());
    let coast = Coast {
        time,
        since,
        position: window(read(&events.position), particles.clone()),
        velocity: window(read(&events.velocity), particles.clone()),
        acceleration: window(read(&events.acceleration), particles.clone()),
        uniform: *events.uniform,
        gravity: system.gravity,
        axes,
    };
    let [x, y, z] = window_mut(next.position, particles.clone());
    let [u, v, w] = window_mut(next.velocity, particles);
    run_on_six(system.lanes, coast, x, y, z, u, v, w);
}

struct Coast<'a, R> {
    time: f64,
    since: &'a [f64],
    position: Columns<'a, R>,
    velocity: Columns<'a, R>,
    acceleration: Columns<'a, R>,
    /// Along which axes the acceleration is everywhere gravity's, and need not be read.
    uniform: [bool; 3],
    gravity: [R; 3],
    /// Along which axes to write.
    axes: [bool; 3],
}

impl<R: Real> SixColumns<R> for Coast<'_, R> {
    type Output = ();

    #[inline(always)]
    fn run(self, x: &mut [R], y: &mut [R], z: &mut [R], u: &mut [R], v: &mut [R], w: &mut [R]) {
        // The times since the last events are differences of `f64`, whatever the states are: a loop with both in it would
        // run on as few lanes as `f64` has.
        let mut room = [R::ZERO; TILE as usize];
        let [first, second, third] = self.along_axes();
        for tile in tiles(0..self.since.len() as u32) {
            let [since] = window([self.since], tile.clone());
            for (tau, since) in room.iter_mut().zip(since) {
                *tau = R::from_f64(self.time - *since);
            }
            let [x, u] = window_mut([&mut *x, &mut *u], tile.clone());
            first.coast(&room, tile.clone(), x, u);
            let [y, v] = window_mut([&mut *y, &mut *v], tile.clone());
            second.coast(&room, tile.clone(), y, v);
            let [z, w] = window_mut([&mut *z, &mut *w], tile.clone());
            third.coast(&room, tile, z, w);
        }
    }
}

impl<'a, R: Real> Coast<'a, R> {
    #[inline(always)]
    fn along_axes(&self) -> [Along<'a, R>; 3] {
        let [x, y, z] = self.position;
        let [u, v, w] = self.velocity;
        let [a, b, c] = self.acceleration;
        let [g_x, g_y, g_z] = self.gravity;
        let [is_x, is_y, is_z] = self.axes;
        let [uniform_x, uniform_y, uniform_z] = self.uniform;
        [
            Along { position: x, velocity: u, acceleration: a, gravity: g_x, is_uniform: uniform_x, is_asked: is_x },
            Along { position: y, velocity: v, acceleration: b, gravity: g_y, is_uniform: uniform_y, is_asked: is_y },
            Along { position: z, velocity: w, acceleration: c, gravity: g_z, is_uniform: uniform_z, is_asked: is_z },
        ]
    }
}

/// One axis.
struct Along<'a, R> {
    position: &'a [R],
    velocity: &'a [R],
    acceleration: &'a [R],
    gravity: R,
    is_uniform: bool,
    is_asked: bool,
}

impl<R: Real> Along<'_, R> {
    /// One tile, these times after the last events.
    #[cfg_attr(feature = "compact", inline(never))]
    #[cfg_attr(not(feature = "compact"), inline(always))]
    fn coast(&self, elapsed: &[R], tile: Range<u32>, position: &mut [R], velocity: &mut [R]) {
        if !self.is_asked {
            return;
        }
        let columns = [self.position, self.velocity, self.acceleration];
        let [last_position, last_velocity, acceleration] = window(columns, tile);
        let last = last_position.iter().zip(last_velocity).zip(elapsed);
        let next = position.iter_mut().zip(velocity);
        if self.is_uniform {
            for (((x, v), tau), next) in last.zip(next) {
                (*next.0, *next.1) = after(*x, *v, *tau, self.gravity);
            }
        } else {
            for ((((x, v), tau), a), next) in last.zip(acceleration).zip(next) {
                (*next.0, *next.1) = after(*x, *v, *tau, *a);
            }
        }
    }
}

/// x + τ (v + ½τ a) and v + τ a: one axis of [`Flight::after`](super::bounce::Flight::after).
#[inline(always)]
fn after<R: Real>(x: R, v: R, tau: R, a: R) -> (R, R) {
    (x + tau * (v + half::<R>() * tau * a), v + tau * a)
}
