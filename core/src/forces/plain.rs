//! Forces spring by spring, for programs that have less flash than time: one loop in place of those over diagonals, for
//! springs with and without damping, and for what follows for particles that springs pull at and that fall.
//!
//! Every sum is taken in the order of `world/order.rs`, so that the bits are those of `tiles.rs`.

use super::acceleration::{Falling, Pulled, Tile, write_along};
use super::law::Tension;
use super::tiles::{Accelerations, Outcome, Then};
use crate::Real;
use crate::vectors::{
    ColumnsMut, along, cut, cut_mut, difference, fetch_inlined, lend, part, read, store_inlined, window_mut,
};
use crate::world::{Coverage, TILE};

/// Accelerations, and what follows, with room for the forces from above on the particles of a tile. Nothing if a column is
/// too short.
pub fn go_through<R: Real, F: Tension>(
    work: &mut Accelerations<'_, R, &mut dyn Then<R>, F>,
    mut above: ColumnsMut<'_, R>,
) -> Option<Outcome> {
    let Accelerations { system, states, slots, out, then, .. } = work;
    let plan = &system.plan;
    let reads_velocity = F::READS_VELOCITY && (plan.damped != Coverage::None || !F::PULLS_UNDAMPED);
    // With lengths that are known to be the same, an index is checked once for all columns.
    let particles = 0..plan.particles;
    let (position, velocity) = (states.position.cut(particles.clone())?, cut(states.velocity, particles.clone())?);
    let inverse_mass = part(system.inverse_mass, particles.clone())?;
    let mut out = cut_mut(lend(out), particles)?;
    let ends = part(system.springs.ends, 0..plan.live())?;
    let mut spring = 0;
    let mut outcome = Outcome { degenerate: 0, finite: true };
    lend(&mut out).into_iter().for_each(|column| column.fill(R::ZERO));
    let mut start = slots.start;
    while start < slots.end {
        let is_pulled = start < plan.attached;
        let end = start.saturating_add(TILE).min(if is_pulled { plan.attached } else { slots.end });
        window_mut(lend(&mut above), 0..end - start).into_iter().for_each(|column| column.fill(R::ZERO));
        while let Some(&[i, j]) = ends.get(spring as usize)
            && i < end
        {
            let d = position.difference(j, i);
            let v = if reads_velocity {
                difference(fetch_inlined(velocity, j), fetch_inlined(velocity, i))
            } else {
                [R::ZERO; 3]
            };
            let (q, has_direction) = F::force_density(system.springs.law(spring), d, v);
            outcome.degenerate += u32::from(!has_direction);
            let pulled = along(fetch_inlined(read(&above), i - start), q, d);
            store_inlined(&mut above, i - start, pulled);
            let pulled = along(fetch_inlined(read(&out), j), -q, d);
            store_inlined(&mut out, j, pulled);
            spring += 1;
        }
        let mut accelerations = cut_mut(lend(&mut out), start..end)?;
        let inverse_mass = part(inverse_mass, start..end)?;
        let axes = lend(&mut accelerations).into_iter().zip(read(&above)).zip(system.gravity);
        axes.for_each(|((below, above), g)| {
            if is_pulled {
                write_along(Pulled, g, inverse_mass, below, above);
            } else {
                write_along(Falling, g, inverse_mass, below, above);
            }
        });
        if let Some(hold_up) = system.support.filter(|_| is_pulled) {
            hold_up(system, start..end, position.value, velocity, lend(&mut accelerations));
        }
        outcome.finite &= then.then(Tile::known(system, start..end, accelerations)?);
        start = end;
    }
    Some(outcome)
}
