//! Where the loops over springs are compiled, and those that explicit steppers end in: with this crate, once for each precision,
//! and not again in every program that is generic over it. Such a program may be compiled for size, or not be optimised at all,
//! and they are fast all the same if this crate is given another `opt-level`.
//!
//! Factors, exact flight and numbers that carry their rounding are compiled where they are asked for.

use crate::carried::Carried;
use crate::forces::{Damped, Damping, SpringsOf, Write};
use crate::lanes::{self, Present};
use crate::solve::Scratch;
use crate::steppers::{Along, Drift, Kick, Particles, Sums};
use crate::vectors::ColumnsMut;
use crate::world::{State, System};
use crate::{Compensated, Real};

/// The loops, compiled here.
#[derive(Clone, Copy, Debug)]
pub struct Compiled;

/// The hot loops in one precision.
pub trait HotLoops<R: Real> {
    /// Columns as graphics take them.
    fn tell(columns: Carried<'_, R>, slots: &[u32], to: &mut [[f32; 3]]);
    /// Forces of springs.
    fn pull(lanes: Present, springs: SpringsOf<'_, '_, '_, R, Damped>) -> Option<u32>;
    /// What damping makes of any vectors.
    fn damp(lanes: Present, springs: SpringsOf<'_, '_, '_, R, Damping>) -> Option<u32>;
    /// From forces to accelerations.
    fn write_accelerations(lanes: Present, accelerations: Write<'_, '_, R>);
    /// The Eulers' steps from accelerations, in one precision, along an axis and along all.
    fn update_explicitly(along: Along<'_, R>) -> bool;
    fn update_semi_implicitly(along: Along<'_, R>) -> bool;
    fn update_all(particles: Particles<'_, R>, below: ColumnsMut<'_, R>, next: ColumnsMut<'_, R>) -> bool;
    /// Verlet's.
    fn drift(lanes: Present, drift: Drift<'_, R>) -> Option<bool>;
    fn kick(lanes: Present, kick: Kick<'_, R>) -> Option<bool>;
    /// Those of implicit steppers: all springs evaluated, and their resistance times a vector.
    fn evaluate(scratch: &mut Scratch<'_, R>, system: &System<'_, R>, state: &State<'_, R>, dt: R) -> u32;
    fn multiply(scratch: &mut Scratch<'_, R>, system: &System<'_, R>);
    /// Those of steppers with stages.
    fn sum(lanes: Present, sums: Sums<'_, '_, R>) -> Option<bool>;
}

macro_rules! compile_for {
    ($($real:ty),*) => {$(
        impl HotLoops<$real> for Compiled {
            #[inline(never)]
            fn tell(columns: Carried<'_, $real>, slots: &[u32], to: &mut [[f32; 3]]) {
                columns.tell(slots, to);
            }
            #[inline(never)]
            fn pull(lanes: Present, springs: SpringsOf<'_, '_, '_, $real, Damped>) -> Option<u32> {
                lanes::run(lanes, springs)
            }
            #[inline(never)]
            fn damp(lanes: Present, springs: SpringsOf<'_, '_, '_, $real, Damping>) -> Option<u32> {
                lanes::run(lanes, springs)
            }
            #[inline(never)]
            fn write_accelerations(lanes: Present, accelerations: Write<'_, '_, $real>) {
                lanes::run(lanes, accelerations);
            }
            #[inline(never)]
            fn update_explicitly(along: Along<'_, $real>) -> bool {
                along.update::<true>()
            }
            #[inline(never)]
            fn update_semi_implicitly(along: Along<'_, $real>) -> bool {
                along.update::<false>()
            }
            #[inline(never)]
            fn update_all(
                particles: Particles<'_, $real>,
                below: ColumnsMut<'_, $real>,
                next: ColumnsMut<'_, $real>,
            ) -> bool {
                particles.update(below, next)
            }
            #[inline(never)]
            fn drift(lanes: Present, drift: Drift<'_, $real>) -> Option<bool> {
                lanes::run(lanes, drift)
            }
            #[inline(never)]
            fn kick(lanes: Present, kick: Kick<'_, $real>) -> Option<bool> {
                lanes::run(lanes, kick)
            }
            #[inline(never)]
            fn evaluate(
                scratch: &mut Scratch<'_, $real>,
                system: &System<'_, $real>,
                state: &State<'_, $real>,
                dt: $real,
            ) -> u32 {
                scratch.evaluate(system, state, dt)
            }
            #[inline(never)]
            fn multiply(scratch: &mut Scratch<'_, $real>, system: &System<'_, $real>) {
                scratch.add_product(system);
            }
            #[inline(never)]
            fn sum(lanes: Present, sums: Sums<'_, '_, $real>) -> Option<bool> {
                lanes::run(lanes, sums)
            }
        }
    )*};
}

compile_for!(f32, f64, Compensated);
