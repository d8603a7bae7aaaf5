//! Forces, in two passes without a write conflict: first one scalar a spring, then one sum a particle.

mod accelerations;
mod densities;
pub(crate) mod energy;

use crate::Real;
use crate::contact::hold_up;
use crate::types::StepReport;
use crate::vectors::{Columns, ColumnsMut, lend};
use crate::world::{Coverage, System};

pub(crate) use accelerations::net_force;

impl<R: Real> System<'_, R> {
    /// a(x, v) of every particle, m/s²: gravity plus the spring forces over the mass; 0 where pinned or kinematic.
    pub(crate) fn accelerations(
        &self,
        position: Columns<'_, R>,
        velocity: Columns<'_, R>,
        force_density: &mut [R],
        mut out: ColumnsMut<'_, R>,
        report: &mut StepReport,
    ) {
        accelerations::set_gravity(self, lend(&mut out));
        if self.plan.springs > 0 {
            report.force_evaluations += 1;
            report.degenerate_springs = self.force_densities(position, velocity, force_density);
            accelerations::add_springs(self, position, force_density, lend(&mut out));
        }
        if self.support {
            hold_up(self, position, velocity, out);
        }
    }

    /// The force densities of all springs (N/m), reading no velocities where nothing is damped. Returns how many
    /// springs have length 0.
    pub(crate) fn force_densities(
        &self,
        position: Columns<'_, R>,
        velocity: Columns<'_, R>,
        force_density: &mut [R],
    ) -> u32 {
        if self.plan.damped == Coverage::None {
            densities::force_densities::<R, false>(self.springs, position, velocity, force_density)
        } else {
            densities::force_densities::<R, true>(self.springs, position, velocity, force_density)
        }
    }
}
