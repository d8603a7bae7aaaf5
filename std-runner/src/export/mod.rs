//! A scene as source of a program that steps it where there are no files.

mod firmware;
mod refused;
mod roles;
mod rows;

pub use firmware::firmware;
pub use refused::Refused;
