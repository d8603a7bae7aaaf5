//! Adding particles, springs and planes.
#![allow(unsafe_code, reason = "this is the interface to another language")]
#![allow(clippy::missing_safety_doc, reason = "the header says it once for all of them")]
#![allow(clippy::too_many_arguments, reason = "vectors are three numbers")]

use super::chosen;
use crate::block::{HookeWorld, engine, items, items_if_any, with, write_if_asked};
use crate::code::{HOOKE_NOBODY, HookeCode};
use crate::options::HookeHold;

/// Adds a particle, at a position in m, with a velocity in m/s and a mass in kg. Its number is written to `number`: 0 for
/// the first, one more for each that follows. `number` may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_add_particle(
    world: *mut HookeWorld,
    x: f64,
    y: f64,
    z: f64,
    vx: f64,
    vy: f64,
    vz: f64,
    mass: f64,
    hold: u32,
    number: *mut u32,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            write_if_asked(number, HOOKE_NOBODY)?;
            let hold = chosen(HookeHold::numbered(hold))?;
            let added = engine!(engine, engine => engine.add_particle(&[x, y, z], &[vx, vy, vz], mass, hold))?;
            write_if_asked(number, added)
        })
    }
}

/// Adds `count` particles: three positions (m) and three velocities (m/s) each, a mass (kg), a hold. A null pointer in
/// place of velocities is 0 for all, of masses 1 kg, of holds `HOOKE_HOLD_FREE`. After an error, those before the culprit are
/// there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_add_particles(
    world: *mut HookeWorld,
    count: u32,
    position: *const f64,
    velocity: *const f64,
    mass: *const f64,
    hold: *const u32,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let length = count as usize;
            let position = items(position, 3 * length)?.as_chunks().0;
            let velocity = items_if_any(velocity, 3 * length)?.as_chunks().0;
            let (mass, hold) = (items_if_any(mass, length)?, items_if_any(hold, length)?);
            for (place, position) in position.iter().enumerate() {
                let velocity = velocity.get(place).unwrap_or(&[0.0; 3]);
                let mass = mass.get(place).copied().unwrap_or(1.0);
                let hold = hold.get(place).copied().unwrap_or_default();
                let added = chosen(HookeHold::numbered(hold))
                    .and_then(|hold| engine!(engine, engine => engine.add_particle(position, velocity, mass, hold)));
                added.map_err(|wrong| wrong.about(place as u32))?;
            }
            Ok(())
        })
    }
}

/// Adds a spring between two particles, with a stiffness in N/m, a damping in N s/m and a rest length in m. Its number is
/// written to `number`, which may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_add_spring(
    world: *mut HookeWorld,
    first: u32,
    second: u32,
    stiffness: f64,
    damping: f64,
    rest_length: f64,
    number: *mut u32,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            write_if_asked(number, HOOKE_NOBODY)?;
            let parameters = [stiffness, damping, rest_length];
            let added = engine!(engine, engine => engine.add_spring([first, second], &parameters))?;
            write_if_asked(number, added)
        })
    }
}

/// Adds `count` springs: two particles each, a stiffness (N/m), a damping (N s/m; null: 0 for all), a rest length (m).
/// After an error, those before the culprit are there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_add_springs(
    world: *mut HookeWorld,
    count: u32,
    between: *const u32,
    stiffness: *const f64,
    damping: *const f64,
    rest_length: *const f64,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let length = count as usize;
            let between = items(between, 2 * length)?.as_chunks().0;
            let (stiffness, rest_length) = (items(stiffness, length)?, items(rest_length, length)?);
            let damping = items_if_any(damping, length)?;
            for (place, between) in between.iter().enumerate() {
                let told = |column: &[f64]| column.get(place).copied().unwrap_or_default();
                let parameters = [told(stiffness), told(damping), told(rest_length)];
                let added = engine!(engine, engine => engine.add_spring(*between, &parameters));
                added.map_err(|wrong| wrong.about(place as u32))?;
            }
            Ok(())
        })
    }
}

/// Adds the plane through a point (m) across a normal of any length, with a restitution from 0 to 1. Particles live on
/// the side that the normal points to. Its number is written to `number`, which may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_add_plane(
    world: *mut HookeWorld,
    x: f64,
    y: f64,
    z: f64,
    normal_x: f64,
    normal_y: f64,
    normal_z: f64,
    restitution: f64,
    number: *mut u32,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            write_if_asked(number, HOOKE_NOBODY)?;
            let (point, normal) = ([x, y, z], [normal_x, normal_y, normal_z]);
            let added = engine!(engine, engine => engine.add_plane(&point, &normal, restitution))?;
            write_if_asked(number, added)
        })
    }
}

/// How many particles, springs and planes there are. Each of the pointers may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_counts(
    world: *mut HookeWorld,
    particles: *mut u32,
    springs: *mut u32,
    planes: *mut u32,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let counts = engine!(engine, engine => engine.counts());
            let [particle_count, spring_count, plane_count] = counts;
            write_if_asked(particles, particle_count)?;
            write_if_asked(springs, spring_count)?;
            write_if_asked(planes, plane_count)
        })
    }
}
