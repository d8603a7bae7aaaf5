//! The state, where it is kept, and what is worked out from it before it is stepped.

mod clock;
mod container;
mod cuthill_mckee;
mod dormancy;
mod islands;
mod layout;
mod order;
mod pieces;
mod plan;
mod prepare;
mod renumber;
mod rest;
mod sort;
mod storage;
mod view;

pub use container::{Container, World};
pub(crate) use layout::{Incidence, StateColumns};
pub use plan::{Coverage, Plan};
pub use storage::{Column, Fixed, Storage};
pub use view::View;

pub(crate) use clock::Clock;
pub(crate) use pieces::{Piece, TILE, Words, stretches, tiles};
pub(crate) use rest::Mark;
pub(crate) use sort::{Unsorted, exchange, sort};
pub(crate) use view::{Law, Springs, State, System};
