//! Pictures of a run: particles as balls, springs as lines coloured by strain, planes as tiled floors.
//!
//! [`Scenery`] is what can be known before the first step: the colours, the sizes and a camera that has
//! room for where things will plausibly go. [`Picture`] draws one frame after another from it; its memory
//! does not grow with the number of frames.
//!
//! What the marks mean:
//! - A spring's colour is its strain, (l − l_rest)/l_rest, on the scale shown at the bottom right.
//!   The scale starts at ±5 % and widens to the next round number when a fiftieth of the springs go beyond it;
//!   its ends are marked ≤ and ≥ while any spring does. Of rest length 0, any length is beyond.
//! - A diamond is pinned, a square follows its track; a ball is a free particle. A dense cloth's are left out.
//! - A plane is drawn lower than it is by the radius of the largest ball: a particle is a point, and a ball
//!   drawn around it then rests on its floor instead of sinking into it.
//! - Far things are paler; a shadow falls along gravity onto the plane below.

mod camera;
mod canvas;
mod colours;
mod floor;
mod hang;
mod islands;
mod legend;
mod looks;
mod order;
mod outlook;
mod picture;
mod reach;
mod scenery;
mod shadow;
mod shapes;
mod text;
mod view;

pub use camera::Camera;
pub use canvas::Canvas;
pub use colours::{BACKGROUND, Colour, StrainScale, blend, strain_colour};
pub use picture::Picture;
pub use scenery::Scenery;
