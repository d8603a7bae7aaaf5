//! The equation of an implicit step: how far a state is from solving it, and how far it has to be.

use super::workspace::Scratch;
use crate::Real;
use crate::forces::net_force;
use crate::sums::sum;
use crate::types::StepReport;
use crate::vectors::{Columns, along, at, difference, dot, fetch, read, scaled, store};
use crate::world::{System, View};

/// How large the residual is, and what it is to be compared with; all in √kg·m/s.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// √(Σ |r|²/m)
    pub norm: f64,
    /// The size of the terms that make it up.
    pub scale: f64,
    /// What rounding alone may leave.
    pub rounding: f64,
}

impl Measured {
    /// The residual relative to its terms.
    pub fn relative(&self) -> f64 {
        if self.norm == 0.0 { 0.0 } else { self.norm / self.scale }
    }
}

/// √(Σ |r|²/m) over the particles that are not held.
pub fn norm<R: Real>(system: &System<'_, R>, residual: Columns<'_, R>) -> f64 {
    let square = sum(system.plan.attached, |slot| {
        // The squares of small residuals would be 0 in `f32`, and look like a solution.
        let r = fetch(residual, slot).map(Real::to_f64);
        at(system.inverse_mass, slot).to_f64() * dot(r, r)
    });
    Real::sqrt(square)
}

/// r = m (v' − v) − dt·f(x', v') at the view's next velocities, with x' = x + dt·v' written beside them.
pub fn residual<R: Real>(
    view: &mut View<'_, R>,
    dt: R,
    scratch: &mut Scratch<'_, R>,
    report: &mut StepReport,
) -> Measured {
    let View { system, current, next, force_density, .. } = view;
    crate::vectors::advance_columns(
        crate::vectors::lend(&mut next.position),
        read(&current.position),
        dt,
        read(&next.velocity),
    );
    let position = read(&next.position);
    report.force_evaluations += 1;
    report.degenerate_springs = system.force_densities(position, read(&next.velocity), force_density);
    for (slot, incidences) in system.springs.by_slot(system.plan.attached) {
        if !system.is_dynamic(slot) {
            store(&mut scratch.residual, slot, [R::ZERO; 3]);
            continue;
        }
        let change = difference(fetch(read(&next.velocity), slot), fetch(read(&current.velocity), slot));
        let change = along(change, -dt, system.gravity);
        let force = net_force(position, force_density, slot, incidences);
        let r = along(scaled(at(system.mass, slot), change), -dt, force);
        store(&mut scratch.residual, slot, at(scratch.support, slot).allow(r));
    }
    let [scale, rounding] = sizes(view, dt);
    Measured { norm: norm(&view.system, read(&scratch.residual)), scale, rounding }
}

/// The size of the terms of the residual: of the momenta and of the impulses of gravity and of each spring; and of
/// the roundings in them, which positions, far larger than the extensions that they give, dominate.
fn sizes<R: Real>(view: &View<'_, R>, dt: R) -> [f64; 2] {
    let View { system, current, next, force_density, .. } = view;
    let (position, springs) = (read(&next.position), system.springs);
    let dt = dt.to_f64();
    let g = length(system.gravity);
    let terms = |slot: u32| {
        let mass = at(system.mass, slot).to_f64();
        let (before, after) = (fetch(read(&current.velocity), slot), fetch(read(&next.velocity), slot));
        let momentum = mass * (length(before) + length(after) + dt * g);
        let here = fetch(position, slot);
        let reach = length(here);
        springs.of_slot(slot).iter().fold((momentum, 0.0), |(size, noise), incidence| {
            let d = difference(fetch(position, incidence.neighbour), here);
            let stiffness = at(springs.stiffness, incidence.spring).to_f64();
            let damping = at(springs.damping, incidence.spring).to_f64();
            let tension = at(force_density, incidence.spring).to_f64().abs() * length(d);
            let rounded = (stiffness + damping / dt) * (2.0 * reach + length(d));
            (size + dt * tension, noise + dt * rounded)
        })
    };
    let root_of_squares = |pick: fn((f64, f64)) -> f64| {
        let square = sum(system.plan.attached, |slot| {
            let size = pick(terms(slot));
            at(system.inverse_mass, slot).to_f64() * size * size
        });
        Real::sqrt(square)
    };
    let scale = root_of_squares(|(size, _)| size);
    [scale, R::EPSILON.to_f64() * (scale + root_of_squares(|(_, noise)| noise))]
}

fn length<R: Real>(vector: [R; 3]) -> f64 {
    let vector = vector.map(Real::to_f64);
    Real::sqrt(dot(vector, vector))
}
