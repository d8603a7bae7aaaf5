//! Where a solve starts.

use super::workspace::Scratch;
use crate::Real;
use crate::contact::{Support, support};
use crate::types::StepReport;
use crate::vectors::{along, copy_columns, lend, read};
use crate::world::{System, View};

/// Starts from the velocities now; a particle without springs is at its solution v + dt·g at once. Leaves the
/// accelerations now in the direction, and what planes hold up in the supports.
pub fn start<R: Real>(view: &mut View<'_, R>, dt: R, scratch: &mut Scratch<'_, R>, report: &mut StepReport) {
    let View { system, current, next, .. } = view;
    // What planes hold up is decided by what presses, before they push back.
    let unsupported = System { support: None, ..*system };
    let (position, velocity) = (current.carried_position(), read(&current.velocity));
    unsupported.accelerations(position, velocity, lend(&mut next.velocity), report);
    let attached = system.plan.attached;
    let known = scratch.direction.iter_mut().zip(scratch.support.iter_mut());
    for (slot, (acceleration, held)) in (0..attached).zip(known) {
        let (velocity, a) = (current.velocity_of(slot), next.velocity_of(slot));
        next.set_velocity(slot, velocity);
        *acceleration = a;
        *held = Support::None;
        if system.support.is_some() {
            *held = support(system.planes, current.position_of(slot), velocity, a);
        }
    }
    for slot in attached..system.plan.particles {
        next.set_velocity(slot, along(current.velocity_of(slot), dt, next.velocity_of(slot)));
    }
    copy_columns(&mut next.position, &current.position, 0);
}
