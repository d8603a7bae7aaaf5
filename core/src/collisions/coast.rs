//! Particles in free flight between events.

use core::ops::Range;

use super::events::{Events, half};
use crate::Real;
use crate::lanes::{SixColumns, run_on_six};
use crate::vectors::{Columns, read, triples, triples_mut, window, window_mut};
use crate::world::{State, System, TILE, tiles};

/// Writes the states at a `time` to `next`, from the last events on.
pub fn coast<R: Real>(system: &System<'_, R>, events: &Events<'_, R>, time: f64, next: State<'_, R>) {
    let single = match *events.uniform {
        [true, true, _] => 2,
        [true, _, true] => 1,
        [_, true, true] => 0,
        _ => return run::<R, true, true>(system, events, time, next, 2),
    };
    if *events.uniform == [true; 3] {
        run::<R, false, false>(system, events, time, next, single);
    } else {
        run::<R, false, true>(system, events, time, next, single);
    }
}

/// With the acceleration of each particle read along all axes, or along the `last` one alone, or along none.
fn run<R: Real, const FIRST: bool, const LAST: bool>(
    system: &System<'_, R>,
    events: &Events<'_, R>,
    time: f64,
    next: State<'_, R>,
    last: usize,
) {
    let coast = Coast::<R, FIRST, LAST> {
        time,
        since: events.since,
        position: turned(read(&events.position), last),
        velocity: turned(read(&events.velocity), last),
        acceleration: turned(read(&events.acceleration), last),
        gravity: turned(system.gravity, last),
    };
    let ([x, y, z], [u, v, w]) = (turned(next.position, last), turned(next.velocity, last));
    run_on_six(system.lanes, coast, x, y, z, u, v, w);
}

/// The axes in an order in which this one is the last.
fn turned<T>([x, y, z]: [T; 3], last: usize) -> [T; 3] {
    match last {
        0 => [y, z, x],
        1 => [z, x, y],
        _ => [x, y, z],
    }
}

/// All axes in one loop: each column is one stream.
struct Coast<'a, R, const FIRST: bool, const LAST: bool> {
    time: f64,
    since: &'a [f64],
    position: Columns<'a, R>,
    velocity: Columns<'a, R>,
    /// Where the constants say that it is not everywhere gravity's.
    acceleration: Columns<'a, R>,
    gravity: [R; 3],
}

impl<R: Real, const FIRST: bool, const LAST: bool> SixColumns<R> for Coast<'_, R, FIRST, LAST> {
    type Output = ();

    #[inline(always)]
    fn run(self, x: &mut [R], y: &mut [R], z: &mut [R], u: &mut [R], v: &mut [R], w: &mut [R]) {
        // The times since the last events are differences of `f64`, whatever the states are: a loop with both in it would
        // run on as few lanes as `f64` has.
        let mut room = [R::ZERO; TILE as usize];
        for tile in tiles(0..self.since.len() as u32) {
            let [since] = window([self.since], tile.clone());
            for (tau, since) in room.iter_mut().zip(since) {
                *tau = R::from_f64(self.time - *since);
            }
            let position = window_mut([&mut *x, &mut *y, &mut *z], tile.clone());
            let velocity = window_mut([&mut *u, &mut *v, &mut *w], tile.clone());
            self.coast(&room, tile, State { position, velocity });
        }
    }
}

impl<R: Real, const FIRST: bool, const LAST: bool> Coast<'_, R, FIRST, LAST> {
    /// One tile of them, these times after their last events.
    #[inline(always)]
    fn coast(&self, elapsed: &[R], tile: Range<u32>, next: State<'_, R>) {
        let [g_x, g_y, g_z] = self.gravity;
        let position = triples(window(self.position, tile.clone()));
        let velocity = triples(window(self.velocity, tile.clone()));
        let acceleration = triples(window(self.acceleration, tile));
        let last = position.zip(velocity).zip(acceleration).zip(elapsed);
        let next = triples_mut(next.position).zip(triples_mut(next.velocity));
        for (((([x_0, y_0, z_0], [u_0, v_0, w_0]), [a_x, a_y, a_z]), tau), ([x, y, z], [u, v, w])) in last.zip(next) {
            (*x, *u) = after(x_0, u_0, *tau, if FIRST { a_x } else { g_x });
            (*y, *v) = after(y_0, v_0, *tau, if FIRST { a_y } else { g_y });
            (*z, *w) = after(z_0, w_0, *tau, if LAST { a_z } else { g_z });
        }
    }
}

/// x + τ (v + ½τ a) and v + τ a: one axis of [`Flight::after`](super::bounce::Flight::after).
#[inline(always)]
fn after<R: Real>(x: R, v: R, tau: R, a: R) -> (R, R) {
    (x + tau * (v + half::<R>() * tau * a), v + tau * a)
}
