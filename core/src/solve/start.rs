//! Where a solve starts.

use super::workspace::Scratch;
use crate::Real;
use crate::contact::support;
use crate::types::StepReport;
use crate::vectors::{along, copy_columns, fetch, lend, put, read, store};
use crate::world::{System, View};

/// Starts from the velocities now; a particle without springs is at its solution v + dt·g at once. Leaves the
/// accelerations now in the direction, and what planes hold up in the supports.
pub fn start<R: Real>(view: &mut View<'_, R>, dt: R, scratch: &mut Scratch<'_, R>, report: &mut StepReport) {
    let View { system, current, next, .. } = view;
    let (x, v) = (read(&current.position), read(&current.velocity));
    // What planes hold up is decided by what presses, before they push back.
    let unsupported = System { support: None, ..*system };
    unsupported.accelerations(current.carried_position(), v, lend(&mut next.velocity), report);
    for slot in 0..system.plan.particles {
        let (velocity, a) = (fetch(v, slot), fetch(read(&next.velocity), slot));
        if slot >= system.plan.attached {
            store(&mut next.velocity, slot, along(velocity, dt, a));
            continue;
        }
        store(&mut next.velocity, slot, velocity);
        put(scratch.direction, slot, a);
        let held = system.support.map(|_| support(system.planes, fetch(x, slot), velocity, a));
        put(scratch.support, slot, held.unwrap_or_default());
    }
    copy_columns(lend(&mut next.position), x);
}
