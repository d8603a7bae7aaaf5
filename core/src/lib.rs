#![doc = include_str!("../README.md")]
//!
//! # How it is built
//!
//! Imports point one way:
//! `real ← lanes ← types ← world ← roles, reach ← contact ← forces ← solve, collisions ← steppers ← step`.
//!
//! - [`Real`] is `f32` or `f64`; nothing else in here knows which.
//! - A [`Container`] holds columns, one a quantity (`world/layout.rs` lists them with their bytes), in whatever its
//!   [`Storage`] provides; [`World`] is the one of fixed capacity. A [`View`] is a world as slices. Kernels take slices,
//!   never a world, so one compiled copy serves every capacity.
//! - A world is prepared when it is first viewed: particles that springs pull at come before those in free flight, each
//!   gets a list of its springs, and a [`Plan`] says what there is, so that a step leaves out what there is not.
//! - Springs are sorted into the order in which their forces are added (`world/order.rs`). Those whose ends lie a constant
//!   number of slots apart, most of a rope, a cloth or a block, form pieces of diagonals (`world/pieces.rs`), along which
//!   nothing has to be gathered; the others are gathered a few at a time. Where most lie on none and reach far, particles
//!   are put in another order (`world/renumber.rs`).
//! - Forces take one pass over tiles of particles (`forces/tiles.rs`), each tile being stepped while it is in the first
//!   cache. The hot loop is in `forces/diagonal.rs`; it is compiled for several sets of vector instructions ([`Lanes`]), and
//!   tiles may be shared among threads ([`Workers`]). The loops over springs are compiled with this crate, once for each precision
//!   (`compiled.rs`), however the program is compiled that it is in.
//! - What no tile can reach is not tested for hits (`reach.rs`).
//! - Islands, the connected parts of the spring graph, sleep while they rest if [`Container::set_sleep`] allows it
//!   (`sleep.rs`): they are moved to the last slots (`world/islands.rs`), and steps see a view without those.
//! - A [`Stepper`] makes the next state from the current one, beside it; a [`Response`] answers the collisions on the way
//!   and makes the next state the current one. So a step that fails leaves the state as it was.
//! - An [`Observer`] such as the [`Ledger`] follows the parts of a step, and costs nothing where there is none.
//!
//! The same bits come out on every machine: every operation is rounded as IEEE 754 says, none is fused, and the order
//! of every sum is fixed when a world is prepared.
#![cfg_attr(not(feature = "std"), no_std)]

mod carried;
mod collisions;
mod compensated;
mod compiled;
mod contact;
mod forces;
mod lanes;
mod ledger;
mod reach;
mod real;
mod roles;
mod rounding;
mod shared;
mod sleep;
mod solve;
mod square_root;
mod stability;
mod step;
mod steppers;
mod sums;
mod types;
mod vectors;
mod workers;
mod world;

pub use collisions::{Project, Reflect, TimeOfImpact};
pub use compensated::Compensated;
pub use lanes::Lanes;
pub use ledger::{Balance, Ledger};
pub use real::Real;
pub use roles::{Observer, Response, Stepper};
pub use solve::{Elimination, LinearSolver};
pub use stability::StabilityBound;
pub use steppers::{
    Adaptive, AdaptiveDop853, AdaptiveDormandPrinceRkn8, Auto, BlanesMoanS6, Choice, Chosen, DenseOutput, Dop853,
    DormandPrinceRkn8, ExplicitEuler, ImplicitEuler, ImplicitEulerLinearised, ImplicitMidpoint, Rk4, RungeKutta,
    SemiImplicitEuler, TrBdf2, VelocityVerlet,
};
pub use types::*;
pub use workers::Workers;
pub use world::{Column, Container, Coverage, Fixed, Plan, Storage, View, World};
