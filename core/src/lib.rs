//! Physics-based animation: particles joined by springs, under gravity, bouncing on planes.
//!
//! `no_std`, without allocation, of fixed capacity: the same code steps eight particles on a microcontroller and a
//! million on a desktop, to the same bits.
//!
//! ```
//! use hooke::{Fixed, Particle, Plane, Spring, TimeOfImpact, VelocityVerlet, World};
//!
//! // Room for 4 particles, 4 springs and 1 plane.
//! let mut world = World::<f64, 4, 4, 1>::new();
//! world.set_gravity([0.0, 0.0, -9.81])?;
//! let ceiling = world.add_particle(Particle::at([0.0, 0.0, 2.0]).pinned())?;
//! let mass = world.add_particle(Particle::at([0.0, 0.0, 1.0]).with_mass(0.5))?;
//! world.add_spring(Spring::new([ceiling, mass], 40.0, 0.8).with_damping(0.2))?;
//! world.add_plane(Plane::through([0.0; 3], [0.0, 0.0, 1.0], 0.8)?)?;
//!
//! // A stepper and a response own whatever room they need, of the same capacity.
//! let mut stepper = VelocityVerlet::<f64, Fixed<4, 4, 1>>::new();
//! let mut response = TimeOfImpact::<f64, Fixed<4, 4, 1>>::new();
//! for _ in 0..1000 {
//!     world.step(&mut stepper, &mut response, 1e-3)?;
//! }
//! assert!((world.time() - 1.0).abs() < 1e-12);
//! assert!(world.position(mass).is_some_and(|position| position.z < 1.2));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
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
//!   tiles may be shared among threads ([`Workers`]).
//! - What no tile can reach is not tested for hits (`reach.rs`).
//! - Islands, the connected parts of the spring graph, sleep while they rest if [`Container::set_sleep`] allows it
//!   (`sleep.rs`): they are moved to the last slots (`world/islands.rs`), and steps see a view without those.
//! - A [`Stepper`] makes the next state from the current one, beside it; a [`Response`] answers the collisions on the way
//!   and makes the next state the current one. So a step that fails leaves the state as it was.
//! - An [`Observer`] such as the [`Ledger`] follows the parts of a step, and costs nothing where there is none.
//!
//! The same bits come out on every machine: every operation is rounded as IEEE 754 says, none is fused, and the order
//! of every sum is fixed when a world is prepared.
//!
//! # Features
//!
//! - `std`: square roots from the standard library. Without it they are the machine's own all the same, to the same bits,
//!   on x86-64, AArch64, WebAssembly and, in `f32`, on Arm with a floating-point unit (`eabihf`); elsewhere they are
//!   libm's.
//! - `small`: less code in place of speed, for flash. There are no second copies of loops, for diagonals, threads and springs
//!   without damping, and nothing that a program does can panic, on a Cortex-M at least. The same bits.
//!
//! On WebAssembly, build with `-C target-feature=+simd128`: without it roots are `f32.sqrt` too, one at a time.
#![cfg_attr(not(feature = "std"), no_std)]

mod carried;
mod collisions;
mod compensated;
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
