//! Steppers, one a file: they differ only where the mathematics does, and each owns what it needs to remember.

mod auto;
mod blanes_moan_s6;
mod combination;
mod euler;
mod explicit_euler;
mod implicit_euler;
mod implicit_euler_linearised;
mod implicit_midpoint;
mod runge_kutta;
mod semi_implicit_euler;
mod stage_sums;
mod tr_bdf2;
mod velocity_verlet;
mod verlet_stages;

pub use auto::{Auto, Choice, Chosen};
pub use blanes_moan_s6::BlanesMoanS6;
pub use explicit_euler::ExplicitEuler;
pub use implicit_euler::ImplicitEuler;
pub use implicit_euler_linearised::ImplicitEulerLinearised;
pub use implicit_midpoint::ImplicitMidpoint;
pub use runge_kutta::{
    Adaptive, AdaptiveDop853, AdaptiveDormandPrinceRkn8, DenseOutput, Dop853, DormandPrinceRkn8, Rk4, RungeKutta,
};
pub use semi_implicit_euler::SemiImplicitEuler;
pub use tr_bdf2::TrBdf2;
pub use velocity_verlet::VelocityVerlet;

pub(crate) use euler::{Along, Particles};
pub(crate) use stage_sums::Sums;
pub(crate) use verlet_stages::{Drift, Kick};
