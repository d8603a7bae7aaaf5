//! Energies and powers, summed in `f64` whatever the precision of the world, and only when asked for.

use crate::Real;
use crate::sums::sum;
use crate::vectors::{at, difference, dot, exact, is_zero, scaled};
use crate::world::{Coverage, Incidence, Law, State, System};

/// Σ ½ m v² over the particles that are not held, J.
pub fn kinetic<R: Real>(system: &System<'_, R>, state: &State<'_, R>) -> f64 {
    sum(system.plan.particles, |slot| kinetic_of(system, state, slot))
}

/// ½ m v² of one particle, J; 0 if it is held.
pub fn kinetic_of<R: Real>(system: &System<'_, R>, state: &State<'_, R>, slot: u32) -> f64 {
    if !system.is_dynamic(slot) {
        return 0.0;
    }
    let v = state.exact_velocity(slot);
    0.5 * at(system.mass, slot).to_f64() * dot(v, v)
}

/// −Σ m g·x over the particles that are not held, J.
pub fn gravitational<R: Real>(system: &System<'_, R>, state: &State<'_, R>) -> f64 {
    if !system.plan.gravity {
        return 0.0;
    }
    let g = exact(system.gravity);
    sum(system.plan.particles, |slot| {
        if !system.is_dynamic(slot) {
            return 0.0;
        }
        -at(system.mass, slot).to_f64() * dot(g, state.exact_position(slot))
    })
}

/// Σ ½ k (l − l_rest)², J.
pub fn elastic<R: Real>(system: &System<'_, R>, state: &State<'_, R>) -> f64 {
    sum(system.plan.springs, |spring| {
        let (_, length, _) = stretch(state, at(system.springs.ends, spring));
        let law = system.springs.exact_law(spring);
        let extension = length - law.rest_length;
        0.5 * law.stiffness * extension * extension
    })
}

/// Elastic and gravitational, J.
pub fn potential<R: Real>(system: &System<'_, R>, state: &State<'_, R>) -> f64 {
    elastic(system, state) + gravitational(system, state)
}

/// The power that damping takes: Σ k_d l̇², W.
pub fn damping_power<R: Real>(system: &System<'_, R>, state: &State<'_, R>) -> f64 {
    if system.plan.damped == Coverage::None {
        return 0.0;
    }
    sum(system.plan.springs, |spring| {
        let (.., rate) = stretch(state, at(system.springs.ends, spring));
        system.springs.exact_law(spring).damping * rate * rate
    })
}

/// The power that moving pins put in: −Σ f·v over the held particles, f being what the springs pull them with, W.
pub fn pin_power<R: Real>(system: &System<'_, R>, state: &State<'_, R>) -> f64 {
    if system.plan.held == 0 {
        return 0.0;
    }
    -sum(system.plan.attached, |slot| {
        let v = state.exact_velocity(slot);
        if system.is_dynamic(slot) || is_zero(v) {
            return 0.0;
        }
        let springs = system.springs.of_slot(slot);
        springs.iter().fold(0.0, |power, incidence| power + dot(pull(system, state, slot, *incidence), v))
    })
}

/// The force of a spring on the particle in `slot`, N.
fn pull<R: Real>(system: &System<'_, R>, state: &State<'_, R>, slot: u32, incidence: Incidence) -> [f64; 3] {
    let Incidence { neighbour, spring } = incidence;
    let (d, length, rate) = stretch(state, [slot, neighbour]);
    if length == 0.0 {
        return const { [0.0; 3] };
    }
    let Law { stiffness, damping, rest_length } = system.springs.exact_law(spring);
    scaled((stiffness * (length - rest_length) + damping * rate) / length, d)
}

/// Along a spring from one end to the other, m; its length, m, and how fast that grows, m/s.
#[inline]
fn stretch<R: Real>(state: &State<'_, R>, [i, j]: [u32; 2]) -> ([f64; 3], f64, f64) {
    let d = difference(state.exact_position(j), state.exact_position(i));
    let v = difference(state.exact_velocity(j), state.exact_velocity(i));
    let length = Real::sqrt(dot(d, d));
    (d, length, if length > 0.0 { dot(v, d) / length } else { 0.0 })
}
