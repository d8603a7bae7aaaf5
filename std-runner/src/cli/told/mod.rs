//! What is told of a run after it.

mod ending;
mod ledger;
mod summary;

pub(super) use ending::outcome;
pub(super) use summary::summary;
