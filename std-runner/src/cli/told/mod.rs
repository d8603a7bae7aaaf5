//! What is told of a run after it.

mod accuracy;
mod aim;
mod ending;
mod ledger;
mod summary;

pub(super) use accuracy::held;
pub(super) use ending::outcome;
pub(super) use summary::{Sought, summary};
