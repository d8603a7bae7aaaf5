//! What implicit steppers solve with: the linearised springs, a preconditioner, conjugate gradients, and Newton's
//! method around them.

mod conjugate_gradients;
mod linearised;
mod newton;
mod preconditioner;
mod residual;
mod workspace;

pub(crate) use newton::{Tolerance, newton, one_linearisation};
pub(crate) use workspace::Workspace;
