//! Forces. One pass over tiles of particles: each spring's force is worked out once, subtracted at its upper end and
//! added at its lower one, in an order (`world/order.rs`) that no width of vectors and no tile changes.

mod acceleration;
mod diagonal;
pub(crate) mod energy;
mod law;
mod net;
mod plain;
mod scattered;
mod shared;
mod sweep;
mod tiles;
mod window;

use crate::Real;
use crate::carried::Carried;
use crate::shared::share;
use crate::types::StepReport;
use crate::vectors::{Columns, ColumnsMut, fetch, read};
use crate::world::{System, View};

pub(crate) use acceleration::{Falling, Known, Origin, Pulled, Rest, Rule, Tile, Write};
pub(crate) use law::{Damped, Damping};
pub(crate) use net::pull;
pub(crate) use tiles::{Follow, Keep, SpringsOf, Then};

use law::Pull;
use tiles::{Accelerations, Outcome, States};

impl<R: Real> System<'_, R> {
    /// a(x, v) of every particle, m/s²: gravity plus the spring forces over the mass; 0 where pinned or kinematic.
    pub(crate) fn accelerations(
        &self,
        position: Carried<'_, R>,
        velocity: Columns<'_, R>,
        out: ColumnsMut<'_, R>,
        report: &mut StepReport,
    ) {
        self.accelerations_then(position, velocity, out, report, Keep);
    }

    /// The same, and what follows for each tile of particles while it is at hand. Returns whether all of that is finite.
    pub(crate) fn accelerations_then(
        &self,
        position: Carried<'_, R>,
        velocity: Columns<'_, R>,
        out: ColumnsMut<'_, R>,
        report: &mut StepReport,
        then: impl Follow<R>,
    ) -> bool {
        if self.plan.live() > 0 {
            report.force_evaluations += 1;
        }
        let outcome = self.go_through(position, velocity, out, then, Damped);
        report.degenerate_springs = outcome.degenerate;
        outcome.finite
    }

    /// M⁻¹ C u: what damping alone makes of any vectors u of all particles in place of their velocities, and what follows.
    /// Where u lies along a plane that the particle is on, so does that. No roots are taken. Returns whether all of that is
    /// finite.
    pub(crate) fn damping_then(
        &self,
        position: Carried<'_, R>,
        vectors: Columns<'_, R>,
        out: ColumnsMut<'_, R>,
        then: impl Follow<R>,
    ) -> bool {
        let system = Self { gravity: [R::ZERO; 3], ..*self };
        system.go_through(position, vectors, out, then, Damping).finite
    }

    fn go_through(
        &self,
        position: Carried<'_, R>,
        velocity: Columns<'_, R>,
        out: ColumnsMut<'_, R>,
        then: impl Follow<R>,
        tension: impl Pull,
    ) -> Outcome {
        let slots = 0..self.plan.particles;
        let states = &States { position, velocity };
        let whole = Accelerations { system: self, states, slots, out, then, tension, window: None };
        share(whole, self.workers)
    }
}

impl<R: Real> View<'_, R> {
    /// How fast the velocities of all particles change (m/s²), in the order of their numbers: gravity and springs, and 0 for
    /// what is held or sleeps. It costs one evaluation of all forces. Impacts, and planes that hold up what rests on them,
    /// are not in it.
    pub fn accelerations(&mut self) -> impl Iterator<Item = R::Vec3> {
        // Nobody needs the next state between two steps.
        self.next.velocity.iter_mut().for_each(|column| column.fill(R::ZERO));
        let awake = self.awake();
        let system = System { support: None, ..awake.system };
        let (position, velocity) = (awake.current.carried_position(), awake.current.carried_velocity());
        system.accelerations(position, velocity.value, awake.next.velocity, &mut StepReport::default());
        let accelerations = read(&self.next.velocity);
        self.slot_of.iter().map(move |slot| fetch(accelerations, *slot).map(|a| a.told(R::NO_RESIDUAL)).into())
    }
}
