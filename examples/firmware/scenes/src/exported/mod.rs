//! Shipped scenes, and the rope of `hooke new`, as `hooke export --firmware` writes them, run through their whole duration.

#[rustfmt::skip]
mod damped_pendulum;
#[rustfmt::skip]
mod rope;
#[rustfmt::skip]
mod slung_rope;

use hooke::StepError;

use crate::compare::Tell;

/// Runs a module that was exported.
macro_rules! run {
    ($scene:ident, $world:expr) => {{
        let mut stepper = $scene::stepper();
        let mut response = $scene::response();
        let mut taken = $scene::fill($world).ok_or(StepError::TimeStep);
        for step in 1..=$scene::STEPS {
            taken = taken.and_then(|()| {
                let mut view = $world.view();
                let (length, end) = ($scene::length(step), $scene::end(step));
                view.step_to(&mut stepper, &mut response, length, end, &mut ()).map(|_| ())
            });
        }
        taken.map(|()| hooke_digest::of(&$world.view()))
    }};
}

/// The worlds of [`exported`].
pub struct Exported {
    slung_rope: slung_rope::Scene,
    damped_pendulum: damped_pendulum::Scene,
    rope: rope::Scene,
}

impl Exported {
    /// Empty ones.
    pub const EMPTY: Self = Self {
        slung_rope: slung_rope::Scene::new(),
        damped_pendulum: damped_pendulum::Scene::new(),
        rope: rope::Scene::new(),
    };
}

/// The scenes, by their own steppers: `hooke run SCENE --digest` tells the same, with the flags for the last that `hooke export`
/// tells.
pub fn exported(worlds: &mut Exported, tell: &mut impl Tell) {
    let Exported { slung_rope: slung, damped_pendulum: pendulum, rope: starter } = worlds;
    tell.tell("slung-rope.toml", "auto", run!(slung_rope, slung));
    tell.tell("damped-pendulum.toml", "velocity-verlet", run!(damped_pendulum, pendulum));
    tell.tell("rope.toml", "auto", run!(rope, starter));
}
