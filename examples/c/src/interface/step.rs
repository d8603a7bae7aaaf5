//! Choosing how to step, and stepping.
#![allow(unsafe_code, reason = "this is the interface to another language")]
#![allow(clippy::missing_safety_doc, reason = "the header says it once for all of them")]

use hooke::StabilityBound;

use super::chosen;
use crate::block::{HookeWorld, engine, with, write, write_if_asked};
use crate::code::HookeCode;
use crate::engine::Choices;
use crate::options::{HookeCollision, HookeStepper};
use crate::report::HookeReport;

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

/// Writes what has been chosen, which `hooke_restore` may have changed: the stepper, its tolerance, the form of collision, and
/// 1 if a ledger is open, else 0. Each of the pointers may be null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_choices(
    world: *mut HookeWorld,
    stepper: *mut u32,
    tolerance: *mut f64,
    collision: *mut u32,
    has_ledger: *mut u32,
) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let (choices, is_followed) = engine!(engine, engine => (engine.choices, engine.ledger.0.is_some()));
            write_if_asked(stepper, choices.stepper as u32)?;
            write_if_asked(tolerance, choices.tolerance)?;
            write_if_asked(collision, choices.collision as u32)?;
            write_if_asked(has_ledger, u32::from(is_followed))
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

/// Writes the longest time step (s) at which a stepper is stable in the present state, as far as its springs tell:
/// infinite where nothing limits it. For explicit Euler it is only an upper limit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hooke_stable_step(world: *mut HookeWorld, stepper: u32, dt: *mut f64) -> HookeCode {
    // SAFETY: as the header says.
    unsafe {
        with(world, |engine| {
            let stepper = chosen(HookeStepper::numbered(stepper))?;
            let bound = engine!(engine, engine => engine.stability());
            write(dt, bound.map_or(f64::INFINITY, |bound| stable_step(stepper, &bound)))
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
