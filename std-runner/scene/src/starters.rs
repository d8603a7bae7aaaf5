//! Scenes to start from, each a page with every line explained.

use super::names::choice;

choice! {
    /// A scene to start from.
    Starter: "starter" {
        /// A rope that is let go at one end.
        Rope = "rope",
        /// A sheet of cloth that hangs by two corners.
        Cloth = "cloth",
        /// A soft block that falls on a floor.
        Block = "block",
        /// A cloud of balls that bounce on a floor.
        Balls = "balls",
        /// A weight on a spring that swings.
        Pendulum = "pendulum",
    }
}

impl Starter {
    /// The scene, as TOML.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Rope => include_str!("starters/rope.toml"),
            Self::Cloth => include_str!("starters/cloth.toml"),
            Self::Block => include_str!("starters/block.toml"),
            Self::Balls => include_str!("starters/balls.toml"),
            Self::Pendulum => include_str!("starters/pendulum.toml"),
        }
    }
}
