//! What implicit steppers solve with: Newton's method, and for its linear systems a factorisation or conjugate gradients.

mod block;
mod conjugate_gradients;
mod evaluate;
mod factor;
mod line_search;
mod linear;
mod linearised;
mod newton;
mod one_linearisation;
mod ordering;
mod preconditioner;
mod residual;
mod room;
mod start;
mod structure;
mod workspace;
mod worth;

pub(crate) use newton::{Tolerance, newton};
pub(crate) use one_linearisation::one_linearisation;
pub(crate) use workspace::{Scratch, Workspace};
pub use worth::{Elimination, LinearSolver};
