//! Physics-based animation: particles joined by springs.
#![cfg_attr(not(feature = "std"), no_std)]

pub mod real;
pub use real::Real;
