//! The functions of the interface: each checks its pointers, and leaves the rest to the [`crate::engine`].
//!
//! What holds for all of them is said once, at the top of the header.
#![allow(unsafe_code, reason = "this is the interface to another language")]
#![allow(clippy::missing_safety_doc, reason = "the header says it once for all of them")]
#![allow(clippy::too_many_arguments, reason = "vectors are three numbers")]

use core::ffi::{c_char, c_void};

use hooke::{Plan, Real, Response, StabilityBound, Stepper};

use crate::arena::{Arena, Capacity};
use crate::block::{self, HookeWorld, engine, items, items_if_any, items_mut, real_bytes, with, write_if_asked};
use crate::code::{HookeCode, Outcome};
use crate::engine::{Choices, SpringGiven};
use crate::method::{AnyResponse, AnyStepper};
use crate::options::{HookeCollision, HookeHold, HookePrecision, HookeStepper};
use crate::report::{HookeLedger, HookeReport};

fn chosen<T>(choice: Option<T>) -> Outcome<T> {
    choice.ok_or(HookeCode::NoSuchOption.into())
}

fn coded(outcome: Outcome) -> HookeCode {
    outcome.map_or_else(|wrong| wrong.code, |()| HookeCode::Ok)
}

fn capacity(particles: u32, springs: u32, planes: u32) -> Capacity {
    Capacity { of: [particles, springs, planes].map(|count| count as usize) }
}

/// A code in words: a string that is always there.
#[unsafe(no_mangle)]
pub extern "C" fn hooke_message(code: i32) -> *const c_char {
    HookeCode::message(code).as_ptr()
}

/// The bytes of a world of so many particles, springs and planes, without a workspace for its stepper; 0 if there is no
/// such precision.
#[unsafe(no_mangle)]
pub extern "C" fn hooke_size_of(precision: u32, particles: u32, springs: u32, planes: u32) -> usize {
    let bytes = HookePrecision::numbered(precision)
        .and_then(|precision| block::bytes(precision, capacity(particles, springs, planes)));
    bytes.unwrap_or(0)
}

/// The bytes of the workspace that a stepper and a form of collision need in such a world; 0 if there is no such option.
///
/// Implicit steppers, and `HOOKE_AUTO` where it turns to one, solve their linear systems by a factorisation where that
/// is less work. A factor has blocks: as many as there are springs in ropes, chains and trees; about 8 times as many in a
/// cloth of 64 x 64. With less room than it needs, a step is refused, unless `hooke_set_workspace` allowed doing without.
#[unsafe(no_mangle)]
pub extern "C" fn hooke_workspace_size(
    precision: u32,
    stepper: u32,
    collision: u32,
    particles: u32,
    springs: u32,
    planes: u32,
    factor_blocks: u32,
) -> usize {
    let options = (HookePrecision::numbered(precision), HookeStepper::numbered(stepper), HookeCollision::numbered(collision));
    let (Some(precision), Some(stepper), Some(collision)) = options else { return 0 };
    let plan = |attached: u32| Plan { particles, attached, springs, planes, ..Plan::default() };
    let bytes = |attached: u32| match precision {
        #[cfg(feature = "f32")]
        HookePrecision::F32 => workspace::<f32>(stepper, collision, &plan(attached)),
        #[cfg(feature = "f64")]
        HookePrecision::F64 => workspace::<f64>(stepper, collision, &plan(attached)),
        #[allow(unreachable_patterns, reason = "which there are depends on the features")]
        _ => 0,
    };
    let factor = if stepper.may_factor() && springs > 0 {
        factor_bytes(real_bytes(precision).unwrap_or(0), particles as usize, springs as usize, factor_blocks as usize)
    } else {
        0
    };
    // What springs pull at takes room for one thing, what flies freely for another.
    let all = bytes(particles).max(bytes(0)).max(bytes(particles / 2));
    all.saturating_add(factor)
}

fn workspace<R: Real>(stepper: HookeStepper, collision: HookeCollision, plan: &Plan) -> usize {
    let arena = Arena::counting();
    let fitted = arena.lend(|| {
        AnyStepper::<R>::named(stepper, 1.0).fit(plan).and_then(|()| AnyResponse::<R>::named(collision).fit(plan))
    });
    if fitted.is_ok() { arena.counted() } else { usize::MAX }
}

/// As in the core's `solve/room.rs`.
fn factor_bytes(real: usize, particles: usize, springs: usize, blocks: usize) -> usize {
    let chunk = crate::method::FILL;
    let chunks = blocks.div_ceil(chunk).min(springs);
    // Entries are sought with room for as many as there are springs, then for twice as many, until it is enough.
    let mut sought = springs.div_ceil(chunk);
    while sought < chunks {
        sought = (2 * sought).min(springs);
    }
    [
        Arena::bytes_of(particles, 28),
        3 * Arena::bytes_of(particles, 4),
        Arena::bytes_of(springs, 8),
        Arena::bytes_of(sought, 4 * chunk),
        Arena::bytes_of(chunks, 12 * real * chunk),
        Arena::bytes_of(particles, 6 * real),
        Arena::bytes_of(particles, 3 * real),
    ]
    .into_iter()
    .fold(0, usize::saturating_add)
}

/// Makes a world in `size` bytes of memory, without anything in it, at 0 s. What `hooke_size_of` leaves of the memory is
/// its workspace. It steps with `HOOKE_SEMI_IMPLICIT_EULER` and `HOOKE_REFLECT`, which need none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_create(
    memory: *mut c_void,
    size: usize,
    precision: u32,
    particles: u32,
    springs: u32,
    planes: u32,
    world: *mut *mut HookeWorld,
) -> HookeCode {
    let create = || {
        let precision = chosen(HookePrecision::numbered(precision))?;
        // SAFETY: the caller supplies the memory, and a place for the address.
        unsafe {
            let world = items_mut(world, 1)?;
            let created = block::create(memory.cast(), size, precision, capacity(particles, springs, planes))?;
            world.fill(created);
        }
        Ok(())
    };
    coded(create())
}

/// Ends a world: its memory is the caller's again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_destroy(world: *mut HookeWorld) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { block::destroy(world) }
}

/// The number of the particle, spring or plane that the last error of a world was about; `UINT32_MAX` if of none.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_culprit(world: *const HookeWorld) -> u32 {
    // SAFETY: as the header says.
    unsafe { block::culprit(world) }
}

/// Gives a world another workspace; the stepper and the collisions begin anew. `without_factor` is 1 if implicit steps
/// may go on by conjugate gradients where a factor has no room, else 0.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_workspace(
    world: *mut HookeWorld,
    memory: *mut c_void,
    size: usize,
    without_factor: u32,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let arena = block::arena(memory.cast(), size, None)?;
            engine!(engine, engine => {
                engine.choices.may_do_without_factor = without_factor != 0;
                engine.set_workspace(arena);
            });
            Ok(())
        })
    }
}

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
            write_if_asked(number, crate::code::NOBODY)?;
            let hold = chosen(HookeHold::numbered(hold))?;
            let added = engine!(engine, engine => engine.add_particle([[x, y, z], [vx, vy, vz]], mass, hold))?;
            write_if_asked(number, added)
        })
    }
}

/// Adds `count` particles: three positions (m) and three velocities (m/s) each, a mass (kg), a hold. A null pointer in
/// place of velocities is 0 for all, of masses 1 kg, of holds `HOOKE_FREE`. After an error, those before the culprit are
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
            let velocity = items_if_any(velocity, 3 * length)?.map(|velocity| velocity.as_chunks().0);
            let (mass, hold) = (items_if_any(mass, length)?, items_if_any(hold, length)?);
            for (place, position) in position.iter().enumerate() {
                let velocity = velocity.and_then(|velocity| velocity.get(place)).copied().unwrap_or_default();
                let mass = mass.and_then(|mass| mass.get(place)).copied().unwrap_or(1.0);
                let hold = hold.and_then(|hold| hold.get(place)).copied().unwrap_or_default();
                let added = chosen(HookeHold::numbered(hold)).and_then(
                    |hold| engine!(engine, engine => engine.add_particle([*position, velocity], mass, hold)),
                );
                added.map_err(|wrong| wrong.code.about(place as u32))?;
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
            write_if_asked(number, crate::code::NOBODY)?;
            let spring = SpringGiven { between: [first, second], stiffness, damping, rest_length };
            let added = engine!(engine, engine => engine.add_spring(spring))?;
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
            let springs = between.iter().zip(stiffness.iter().zip(rest_length)).enumerate();
            for (place, (between, (stiffness, rest_length))) in springs {
                let damping = damping.and_then(|damping| damping.get(place)).copied().unwrap_or_default();
                let (stiffness, rest_length) = (*stiffness, *rest_length);
                let spring = SpringGiven { between: *between, stiffness, damping, rest_length };
                let added = engine!(engine, engine => engine.add_spring(spring));
                added.map_err(|wrong| wrong.code.about(place as u32))?;
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
            write_if_asked(number, crate::code::NOBODY)?;
            let (point, normal) = ([x, y, z], [normal_x, normal_y, normal_z]);
            let added = engine!(engine, engine => engine.add_plane(point, normal, restitution))?;
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
            [particles, springs, planes].into_iter().zip(counts).try_for_each(|(to, count)| write_if_asked(to, count))
        })
    }
}

/// Sets the gravitational acceleration, m/s^2.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_gravity(world: *mut HookeWorld, x: f64, y: f64, z: f64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { with(world, |engine| engine!(engine, engine => engine.set_gravity([x, y, z]))) }
}

/// Puts a particle somewhere else (m).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_position(world: *mut HookeWorld, particle: u32, x: f64, y: f64, z: f64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { with(world, |engine| engine!(engine, engine => engine.set_position(particle, [x, y, z]))) }
}

/// Gives a particle another velocity (m/s). A pinned particle becomes kinematic by it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_velocity(world: *mut HookeWorld, particle: u32, x: f64, y: f64, z: f64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { with(world, |engine| engine!(engine, engine => engine.set_velocity(particle, [x, y, z]))) }
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
    unsafe { with(world, |engine| engine!(engine, engine => engine.drive(particle, [x, y, z], [vx, vy, vz]))) }
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
        with(world, |engine| {
            let change = |spring| SpringGiven { stiffness, damping, rest_length, ..spring };
            engine!(engine, engine => engine.set_springs(Some(spring), change))
        })
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
            write_if_asked(stiffness, found.stiffness)?;
            write_if_asked(damping, found.damping)?;
            write_if_asked(rest_length, found.rest_length)
        })
    }
}

/// Multiplies the stiffness and the damping of all springs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_scale_springs(world: *mut HookeWorld, stiffness: f64, damping: f64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let change = |spring: SpringGiven| SpringGiven {
                stiffness: spring.stiffness * stiffness,
                damping: spring.damping * damping,
                ..spring
            };
            engine!(engine, engine => engine.set_springs(None, change))
        })
    }
}

/// Sets the restitution of a plane, from 0 to 1.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_restitution(world: *mut HookeWorld, plane: u32, restitution: f64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { with(world, |engine| engine!(engine, engine => engine.set_restitution(plane, restitution))) }
}

/// Chooses the stepper, which begins anew. Implicit ones solve to `tolerance`, relative to the size of the terms of their
/// equations: 1e-6, say.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_stepper(world: *mut HookeWorld, stepper: u32, tolerance: f64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let stepper = chosen(HookeStepper::numbered(stepper))?;
            if !(tolerance > 0.0 && tolerance.is_finite()) {
                return Err(HookeCode::Tolerance.into());
            }
            engine!(engine, engine => engine.choose(Choices { stepper, tolerance, ..engine.choices }));
            Ok(())
        })
    }
}

/// Chooses what happens at planes; the stepper begins anew.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_set_collision(world: *mut HookeWorld, collision: u32) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let collision = chosen(HookeCollision::numbered(collision))?;
            engine!(engine, engine => engine.choose(Choices { collision, ..engine.choices }));
            Ok(())
        })
    }
}

/// Takes `count` steps of `dt` seconds. After an error the state is that of the last step that could be taken; the report,
/// which may be null, is of those that were.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_step(
    world: *mut HookeWorld,
    dt: f64,
    count: u32,
    report: *mut HookeReport,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let mut told = HookeReport::default();
            write_if_asked(report, told)?;
            let outcome = engine!(engine, engine => engine.step(dt, count, &mut told));
            write_if_asked(report, told)?;
            outcome
        })
    }
}

/// The time of the state, s; NaN if there is no world.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_time(world: *mut HookeWorld) -> f64 {
    let mut time = f64::NAN;
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            time = engine!(engine, engine => engine.time());
            Ok(())
        })
    };
    time
}

/// Writes the positions (m) and the velocities (m/s) of all particles, three numbers each, in the order of their
/// numbers. Either pointer may be null. `length` is that of each array: three times the particles.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_read(
    world: *mut HookeWorld,
    position: *mut f64,
    velocity: *mut f64,
    length: usize,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe { with(world, |engine| engine!(engine, engine => read([position, velocity], length, engine.states(), |x| x))) }
}

/// The same, to single precision.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_read_single(
    world: *mut HookeWorld,
    position: *mut f32,
    velocity: *mut f32,
    length: usize,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| engine!(engine, engine => read([position, velocity], length, engine.states(), |x| x as f32)))
    }
}

unsafe fn read<T: Copy>(
    to: [*mut T; 2],
    length: usize,
    states: impl Iterator<Item = [[f64; 3]; 2]> + ExactSizeIterator,
    rounded: impl Fn(f64) -> T,
) -> Outcome {
    if length != 3 * states.len() {
        return Err(HookeCode::Length.into());
    }
    let [mut position, mut velocity] = [&mut [] as &mut [[T; 3]], &mut []];
    for (pointer, columns) in to.into_iter().zip([&mut position, &mut velocity]) {
        if !pointer.is_null() {
            // SAFETY: as the header says.
            *columns = unsafe { items_mut(pointer, length)? }.as_chunks_mut().0;
        }
    }
    for (number, [x, v]) in states.enumerate() {
        for (columns, vector) in [&mut *position, &mut *velocity].into_iter().zip([x, v]) {
            if let Some(place) = columns.get_mut(number) {
                *place = vector.map(&rounded);
            }
        }
    }
    Ok(())
}

/// Opens the energy ledger, or opens it anew: from now on it is followed through every step, which costs time.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_open_ledger(world: *mut HookeWorld) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            engine!(engine, engine => engine.open_ledger());
            Ok(())
        })
    }
}

/// Writes what the ledger says; if none is open, what one would that has just been opened.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_read_ledger(world: *mut HookeWorld, ledger: *mut HookeLedger) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let told = items_mut(ledger, 1)?;
            told.fill(engine!(engine, engine => engine.balance()));
            Ok(())
        })
    }
}

/// Writes the longest time step (s) at which a stepper is stable in the present state, as far as its springs tell:
/// infinite where nothing limits it. For explicit Euler it is only an upper limit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_stable_step(world: *mut HookeWorld, stepper: u32, dt: *mut f64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let stepper = chosen(HookeStepper::numbered(stepper))?;
            let bound = engine!(engine, engine => engine.stability());
            items_mut(dt, 1)?.fill(bound.map_or(f64::INFINITY, |bound| stable_step(stepper, &bound)));
            Ok(())
        })
    }
}

fn stable_step(stepper: HookeStepper, bound: &StabilityBound) -> f64 {
    match stepper {
        HookeStepper::ExplicitEuler => bound.explicit_euler,
        HookeStepper::SemiImplicitEuler => bound.semi_implicit_euler,
        HookeStepper::VelocityVerlet => bound.velocity_verlet,
        HookeStepper::Rk4 => bound.rk4(),
        HookeStepper::BlanesMoanS6 => bound.blanes_moan_s6(),
        HookeStepper::Dop853 => bound.dop853(),
        HookeStepper::DormandPrinceRkn8 => bound.dormand_prince_rkn8(),
        HookeStepper::ImplicitEuler
        | HookeStepper::ImplicitEulerLinearised
        | HookeStepper::ImplicitMidpoint
        | HookeStepper::TrBdf2
        | HookeStepper::Auto => f64::INFINITY,
    }
}

/// The bytes of a snapshot of a world; 0 if there is no world.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_snapshot_size(world: *mut HookeWorld) -> usize {
    let mut size = 0;
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            size = engine!(engine, engine => engine.snapshot_size());
            Ok(())
        })
    };
    size
}

/// Writes a snapshot: all that it takes to go on from here, the same on every machine. `size` is `hooke_snapshot_size`.
/// What the stepper remembers of earlier steps is forgotten, here as where the snapshot is put back: both go on to the
/// same bits.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_snapshot(world: *mut HookeWorld, bytes: *mut u8, size: usize) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let bytes = items_mut(bytes, size)?;
            engine!(engine, engine => engine.snapshot(bytes))
        })
    }
}

/// Puts a snapshot back: of a world with the same number of particles, the same springs and planes, in the same precision.
/// Other bytes are refused, and change nothing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_restore(world: *mut HookeWorld, bytes: *const u8, size: usize) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let bytes = items(bytes, size)?;
            engine!(engine, engine => engine.restore(bytes))
        })
    }
}

/// Writes one number for all positions and velocities, bit by bit: FNV-1a over them, by particle, as 64-bit numbers. It
/// is the same on every machine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_digest(world: *mut HookeWorld, digest: *mut u64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let told = items_mut(digest, 1)?;
            told.fill(engine!(engine, engine => engine.digest()));
            Ok(())
        })
    }
}

/// Ends the program: there is nothing left to do.
#[cfg(not(feature = "std"))]
pub(crate) fn halt() -> ! {
    #[cfg(target_arch = "wasm32")]
    core::arch::wasm32::unreachable();
    #[cfg(not(target_arch = "wasm32"))]
    {
        unsafe extern "C" {
            fn abort() -> !;
        }
        // SAFETY: it is the C library's.
        unsafe { abort() }
    }
}
