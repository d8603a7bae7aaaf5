//! The equation of an implicit step: how far a state is from solving it, and how far it has to be.

use super::evaluate::Impulse;
use super::workspace::Scratch;
use crate::Real;
use crate::compiled::HotLoops;
use crate::sums::sum;
use crate::types::StepReport;
use crate::vectors::{advance_columns, along, at, difference, dot, exact, scaled};
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
pub fn norm<R: Real>(system: &System<'_, R>, residual: &[[R; 3]]) -> f64 {
    let square = sum(system.plan.attached, |slot| {
        // The squares of small residuals would be 0 in `f32`, and look like a solution.
        let r = exact(at(residual, slot));
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
    let View { system, current, next, .. } = view;
    advance_columns(&mut next.position, &current.position, dt, &next.velocity);
    report.force_evaluations += 1;
    report.degenerate_springs = R::Loops::evaluate(scratch, system, next, dt);
    let slots = 0..system.plan.attached;
    let known = scratch.blocks.iter().zip(scratch.support.iter()).zip(system.mass);
    for ((slot, residual), ((impulse, support), mass)) in slots.zip(scratch.residual.iter_mut()).zip(known) {
        *residual = const { [R::ZERO; 3] };
        if system.is_dynamic(slot) {
            let change = difference(next.velocity_of(slot), current.velocity_of(slot));
            let change = along(change, -dt, system.gravity);
            let [x, y, z, ..] = *impulse;
            *residual = support.allow(difference(scaled(*mass, change), [x, y, z]));
        }
    }
    let [scale, rounding] = sizes(view, dt, scratch.blocks);
    Measured { norm: norm(&view.system, scratch.residual), scale, rounding }
}

/// The size of the terms of the residual: of the momenta and of the impulses of gravity and of each spring; and of
/// the roundings in them, which positions, far larger than the extensions that they give, dominate.
fn sizes<R: Real>(view: &View<'_, R>, dt: R, impulses: &[Impulse<R>]) -> [f64; 2] {
    let View { system, current, next, .. } = view;
    let fall = dt.to_f64() * length(system.gravity);
    let squares = sum(system.plan.attached, |slot| {
        let (before, after) = (current.velocity_of(slot), next.velocity_of(slot));
        let [.., impulse, strength, moment] = at(impulses, slot);
        let [impulse, strength, moment] = exact([impulse, strength, moment]);
        let size = at(system.mass, slot).to_f64() * (length(before) + length(after) + fall) + impulse;
        let noise = 2.0 * length(next.position_of(slot)) * strength + moment;
        let weight = at(system.inverse_mass, slot).to_f64();
        Two([weight * size * size, weight * noise * noise])
    });
    let Two([scale, noise]) = squares;
    let (scale, noise) = (Real::sqrt(scale), Real::sqrt(noise));
    [scale, R::EPSILON.to_f64() * (scale + noise)]
}

/// Two sums at once.
#[derive(Clone, Copy, Default)]
struct Two([f64; 2]);

impl core::ops::Add for Two {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let ([a, b], [c, d]) = (self.0, other.0);
        Self([a + c, b + d])
    }
}

fn length<R: Real>(vector: [R; 3]) -> f64 {
    let vector = exact(vector);
    Real::sqrt(dot(vector, vector))
}
