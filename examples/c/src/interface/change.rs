//! Changing what there is.
#![allow(unsafe_code, reason = "this is the interface to another language")]
#![allow(clippy::missing_safety_doc, reason = "the header says it once for all of them")]
#![allow(clippy::too_many_arguments, reason = "vectors are three numbers")]

use super::chosen;
use crate::block::{HookeWorld, engine, items_if_any, with, write_if_asked};
use crate::code::HookeCode;
use crate::engine::Parameters;
use crate::options::HookeHold;

/// Sets the gravitational acceleration, m/s^2.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_gravity(world: *mut HookeWorld, x: f64, y: f64, z: f64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { with(world, |engine| engine!(engine, engine => engine.set_gravity(&[x, y, z]))) }
}

/// Puts a particle somewhere else (m).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_position(
    world: *mut HookeWorld,
    particle: u32,
    x: f64,
    y: f64,
    z: f64,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { with(world, |engine| engine!(engine, engine => engine.set_position(particle, &[x, y, z]))) }
}

/// Gives a particle another velocity (m/s). A pinned particle becomes kinematic by it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_velocity(
    world: *mut HookeWorld,
    particle: u32,
    x: f64,
    y: f64,
    z: f64,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { with(world, |engine| engine!(engine, engine => engine.set_velocity(particle, &[x, y, z]))) }
}

/// Pins a particle, lets it go, or makes it kinematic. One that is pinned loses its velocity.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_hold(world: *mut HookeWorld, particle: u32, hold: u32) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let hold = chosen(HookeHold::numbered(hold))?;
            engine!(engine, engine => engine.set_hold(particle, hold))
        })
    }
}

/// Puts a particle where it should be (m) with the velocity it should have (m/s), and makes it kinematic if it was free.
/// Meant for every step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_drive(
    world: *mut HookeWorld,
    particle: u32,
    x: f64,
    y: f64,
    z: f64,
    vx: f64,
    vy: f64,
    vz: f64,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { with(world, |engine| engine!(engine, engine => engine.drive(particle, &[x, y, z], &[vx, vy, vz]))) }
}

/// Gives a spring other parameters: N/m, N s/m, m.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_spring(
    world: *mut HookeWorld,
    spring: u32,
    stiffness: f64,
    damping: f64,
    rest_length: f64,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| engine!(engine, engine => engine.set_spring(spring, &[stiffness, damping, rest_length])))
    }
}

/// What a spring's parameters are: N/m, N s/m, m. Each of the pointers may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_spring(
    world: *mut HookeWorld,
    spring: u32,
    stiffness: *mut f64,
    damping: *mut f64,
    rest_length: *mut f64,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let found = engine!(engine, engine => engine.spring(spring))?;
            let [found_stiffness, found_damping, found_rest_length] = found;
            write_if_asked(stiffness, found_stiffness)?;
            write_if_asked(damping, found_damping)?;
            write_if_asked(rest_length, found_rest_length)
        })
    }
}

/// Gives all springs other parameters, by number: N/m, N s/m, m. A null pointer leaves those as they are. `count` is how many
/// springs there are. It takes about as long as one `hooke_set_spring`. An error names the first spring that is refused; none
/// is changed then.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_springs(
    world: *mut HookeWorld,
    count: u32,
    stiffness: *const f64,
    damping: *const f64,
    rest_length: *const f64,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let [_, springs, _] = engine!(&*engine, engine => engine.counts());
            if count != springs {
                return Err(HookeCode::Length.into());
            }
            let length = count as usize;
            let told =
                [items_if_any(stiffness, length)?, items_if_any(damping, length)?, items_if_any(rest_length, length)?];
            let change = |number: u32, parameters: &mut Parameters| {
                for (parameter, column) in parameters.iter_mut().zip(told) {
                    if let Some(told) = column.get(number as usize) {
                        *parameter = *told;
                    }
                }
            };
            engine!(engine, engine => engine.change_springs(&change))
        })
    }
}

/// Multiplies the stiffness and the damping of all springs, as they are now.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_scale_springs(world: *mut HookeWorld, stiffness: f64, damping: f64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let change = |_, [k, c, _]: &mut Parameters| {
                *k *= stiffness;
                *c *= damping;
            };
            engine!(engine, engine => engine.change_springs(&change))
        })
    }
}

/// Sets the restitution of a plane, from 0 to 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_restitution(world: *mut HookeWorld, plane: u32, restitution: f64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { with(world, |engine| engine!(engine, engine => engine.set_restitution(plane, restitution))) }
}
