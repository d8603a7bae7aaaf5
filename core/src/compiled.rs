//! Where the hot loops are compiled: with this crate, once for each precision, and not again in every program that is
//! generic over it. Such a program may be compiled for size, or not be optimised at all, and they are fast all the same if this
//! crate is given another `opt-level`.

use crate::carried::Carried;
use crate::forces::{Damped, Damping, SpringsOf, Write};
use crate::lanes::{self, Present};
use crate::solve::Scratch;
use crate::steppers::{Along, Drift, Kick, Particles, Sums};
use crate::vectors::ColumnsMut;
use crate::world::{State, System};
use crate::{Compensated, Real};

/// The hot loops in one precision.
pub trait HotLoops: Sized {
    /// Columns as graphics take them.
    fn tell(columns: Carried<'_, Self>, slots: &[u32], to: &mut [[f32; 3]])
    where
        Self: Real;
    /// Forces of springs.
    fn pull(lanes: Present, springs: SpringsOf<'_, '_, '_, Self, Damped>) -> Option<u32>
    where
        Self: Real;
    /// What damping makes of any vectors.
    fn damp(lanes: Present, springs: SpringsOf<'_, '_, '_, Self, Damping>) -> Option<u32>
    where
        Self: Real;
    /// From forces to accelerations.
    fn write_accelerations(lanes: Present, accelerations: Write<'_, '_, Self>)
    where
        Self: Real;
    /// The Eulers' steps from accelerations, in one precision, along an axis and along all.
    fn update_explicitly(along: Along<'_, Self>) -> bool
    where
        Self: Real;
    fn update_semi_implicitly(along: Along<'_, Self>) -> bool
    where
        Self: Real;
    fn update_all(particles: Particles<'_, Self>, below: ColumnsMut<'_, Self>, next: ColumnsMut<'_, Self>) -> bool
    where
        Self: Real;
    /// Verlet's.
    fn drift(lanes: Present, drift: Drift<'_, Self>) -> Option<bool>
    where
        Self: Real;
    fn kick(lanes: Present, kick: Kick<'_, Self>) -> Option<bool>
    where
        Self: Real;
    /// Those of implicit steppers: all springs evaluated, and their resistance times a vector.
    fn evaluate(scratch: &mut Scratch<'_, Self>, system: &System<'_, Self>, state: &State<'_, Self>, dt: Self) -> u32
    where
        Self: Real;
    fn multiply(scratch: &mut Scratch<'_, Self>, system: &System<'_, Self>)
    where
        Self: Real;
    /// Those of steppers with stages.
    fn sum(lanes: Present, sums: Sums<'_, '_, Self>) -> Option<bool>
    where
        Self: Real;
}

macro_rules! compile_for {
    ($($real:ty),*) => {$(
        impl HotLoops for $real {
            #[inline(never)]
            fn tell(columns: Carried<'_, Self>, slots: &[u32], to: &mut [[f32; 3]]) {
                columns.tell(slots, to);
            }
            #[inline(never)]
            fn pull(lanes: Present, springs: SpringsOf<'_, '_, '_, Self, Damped>) -> Option<u32> {
                lanes::run(lanes, springs)
            }
            #[inline(never)]
            fn damp(lanes: Present, springs: SpringsOf<'_, '_, '_, Self, Damping>) -> Option<u32> {
                lanes::run(lanes, springs)
            }
            #[inline(never)]
            fn write_accelerations(lanes: Present, accelerations: Write<'_, '_, Self>) {
                lanes::run(lanes, accelerations);
            }
            #[inline(never)]
            fn update_explicitly(along: Along<'_, Self>) -> bool {
                along.update::<true>()
            }
            #[inline(never)]
            fn update_semi_implicitly(along: Along<'_, Self>) -> bool {
                along.update::<false>()
            }
            #[inline(never)]
            fn update_all(
                particles: Particles<'_, Self>,
                below: ColumnsMut<'_, Self>,
                next: ColumnsMut<'_, Self>,
            ) -> bool {
                particles.update(below, next)
            }
            #[inline(never)]
            fn drift(lanes: Present, drift: Drift<'_, Self>) -> Option<bool> {
                lanes::run(lanes, drift)
            }
            #[inline(never)]
            fn kick(lanes: Present, kick: Kick<'_, Self>) -> Option<bool> {
                lanes::run(lanes, kick)
            }
            #[inline(never)]
            fn evaluate(
                scratch: &mut Scratch<'_, Self>,
                system: &System<'_, Self>,
                state: &State<'_, Self>,
                dt: Self,
            ) -> u32 {
                scratch.evaluate(system, state, dt)
            }
            #[inline(never)]
            fn multiply(scratch: &mut Scratch<'_, Self>, system: &System<'_, Self>) {
                scratch.add_product(system);
            }
            #[inline(never)]
            fn sum(lanes: Present, sums: Sums<'_, '_, Self>) -> Option<bool> {
                lanes::run(lanes, sums)
            }
        }
    )*};
}

compile_for!(f32, f64, Compensated);
