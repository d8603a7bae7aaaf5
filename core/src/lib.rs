//! Physics-based animation: particles joined by springs.
#![cfg_attr(not(feature = "std"), no_std)]

mod collisions;
mod forces;
mod ledger;
mod real;
mod solve;
mod stability;
mod step;
mod steppers;
mod sums;
mod types;
mod vectors;
mod world;

pub use collisions::{Project, Reflect, Response, TimeOfImpact};
pub use ledger::{Balance, Ledger};
pub use real::Real;
pub use stability::StabilityBound;
pub use step::Observer;
pub use steppers::{
    Auto, Choice, Chosen, ExplicitEuler, ImplicitEuler, ImplicitEulerLinearised, SemiImplicitEuler, Stepper,
    VelocityVerlet,
};
pub use types::*;
pub use world::{Column, Container, Coverage, Fixed, Plan, Storage, View, World};
