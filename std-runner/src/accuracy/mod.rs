//! An accuracy instead of a time step: the cheapest stepper, precision and time step that keep every particle within a
//! distance of where it should be.
//!
//! Pilot runs over a short prefix (`pilot.rs`, `shown.rs`) show what to choose (`choose.rs`). Then two runs go side by side (`pair.rs`), one of them in
//! longer steps: as the error of a method of order p grows with the p-th power of the step, what lies between the two
//! tells how far off the finer one is (Richardson's extrapolation; `estimate.rs`). Where that is more than was asked for,
//! both go back to where it was well within, and on in shorter steps (`attempt.rs`); if that is of no use, they begin
//! anew. Frames are handed over once they are sure to be kept (`frames.rs`).
//!
//! Where nothing is asked for and the scene leaves its stepper and its time step open, the same pilots find what can be
//! expected to keep within a thousandth of its size (`aimed.rs`); nothing goes beside that run.

mod aimed;
mod attained;
mod attempt;
mod choice;
mod choose;
mod cost;
mod estimate;
mod frames;
mod pace;
mod pair;
mod pilot;
mod quintic;
mod run;
mod shown;
mod side;

pub use aimed::{Aim, Aimed, aim, aimed_at, leaves_open};
pub use attained::Attained;
pub use choice::{Choice, Ratio};
pub use cost::step_cost;
pub use estimate::Estimate;
pub use pace::Pace;
pub use quintic::{Knot, quintic};
pub use run::{Begin, Within, run};
