//! Collisions with planes, in three named forms, and flight from plane to plane.

mod bounce;
mod coast;
mod due;
mod events;
mod extent;
mod flights;
mod fly_along;
mod impacts;
mod locate;
mod parts;
mod pass;
mod project;
mod reflect;
mod stop;
mod time_of_impact;
mod together;

pub use flights::Flights;
pub use project::Project;
pub use reflect::Reflect;
pub use time_of_impact::TimeOfImpact;

pub(crate) use reflect::Answer;
