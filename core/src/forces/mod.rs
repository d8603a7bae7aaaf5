//! Forces. One pass over tiles of particles: each spring's force is worked out once, subtracted at its upper end and
//! added at its lower one, in an order (`world/order.rs`) that no width of vectors and no tile changes.

mod acceleration;
mod diagonal;
pub(crate) mod energy;
mod law;
mod net;
mod scattered;
mod shared;
mod sweep;
mod tiles;
mod window;

use crate::Real;
use crate::shared::share;
use crate::types::StepReport;
use crate::vectors::{Columns, ColumnsMut};
use crate::world::System;

pub(crate) use acceleration::{Acceleration, Rest, Tile};
pub(crate) use net::pull;
pub(crate) use tiles::Then;

use tiles::{Accelerations, Keep};

impl<R: Real> System<'_, R> {
    /// a(x, v) of every particle, m/s²: gravity plus the spring forces over the mass; 0 where pinned or kinematic.
    pub(crate) fn accelerations(
        &self,
        position: Columns<'_, R>,
        velocity: Columns<'_, R>,
        out: ColumnsMut<'_, R>,
        report: &mut StepReport,
    ) {
        self.accelerations_then(position, velocity, out, report, Keep);
    }

    /// The same, and what follows for each tile of particles while it is at hand. Returns whether all of that is finite.
    pub(crate) fn accelerations_then(
        &self,
        position: Columns<'_, R>,
        velocity: Columns<'_, R>,
        out: ColumnsMut<'_, R>,
        report: &mut StepReport,
        then: impl Then<R>,
    ) -> bool {
        if self.plan.live() > 0 {
            report.force_evaluations += 1;
        }
        let slots = 0..self.plan.particles;
        let whole = Accelerations { system: self, position, velocity, slots, out, then, window: None };
        let outcome = share(whole, self.workers);
        report.degenerate_springs = outcome.degenerate;
        outcome.finite
    }
}
