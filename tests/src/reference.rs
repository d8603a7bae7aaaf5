//! A reference integrator: Gragg-Bulirsch-Stoer extrapolation of order 16.
//!
//! Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I", section II.9:
//! the modified midpoint rule with an even number of substeps has an error in even powers of the substep only,
//! so extrapolating 8 such results to substep 0 leaves an error of order 16.
//! It shares no formula with any Runge-Kutta, splitting or Euler stepper.

use crate::moment::Moment;
use crate::problems::Impact;
use crate::right_hand_side::RightHandSide;
use glam::DVec3;
use hooke_runner::model::ModelPlane;

/// Substeps 2, 4, … 16 of one step.
const COLUMNS: usize = 8;

/// The state `duration` seconds after `start`, in `steps` equal steps.
#[must_use]
pub fn integrate(law: &RightHandSide, start: &Moment, duration: f64, steps: usize) -> Moment {
    let mut state = flat(start);
    for _ in 0..steps {
        state = advance(law, &state, duration / steps as f64);
    }
    unflat(&state)
}

/// The same with bounces on `planes`, each located to the last bit of its time;
/// returns the state at the end and the impacts on the way.
///
/// A step that dips below a plane and comes back within itself is not seen, so steps must be short beside the flights.
///
/// # Panics
/// A particle rests on a plane or its bounces pile up: then there is no next flight to integrate.
#[must_use]
pub fn integrate_bouncing(
    law: &RightHandSide,
    planes: &[ModelPlane],
    start: &Moment,
    duration: f64,
    steps: usize,
) -> (Moment, Vec<Impact>) {
    let mut state = flat(start);
    let mut impacts = Vec::new();
    let mut time = 0.0;
    while time < duration {
        let step = (duration / steps as f64).min(duration - time);
        let first = (0..law.particles())
            .filter(|&particle| law.mass(particle).is_some())
            .flat_map(|particle| (0..planes.len()).map(move |plane| (particle, plane)))
            .filter_map(|(particle, plane)| {
                let gap = |state: &[f64]| gap(&planes[plane], state, particle);
                crossing(law, &state, step, gap).map(|after| (after, particle, plane))
            })
            .min_by(|left, right| left.0.total_cmp(&right.0));
        let Some((after, particle, plane)) = first else {
            state = advance(law, &state, step);
            // Counting whole steps would drift from the flights' own times, and the last step ends the loop exactly.
            time = if step < duration / steps as f64 { duration } else { time + step };
            continue;
        };
        state = advance(law, &state, after);
        time += after;
        let (n, e) = (DVec3::from(planes[plane].normal), planes[plane].restitution);
        let velocity = vector(&state, law.particles() + particle);
        let speed = -n.dot(velocity);
        let bounced = velocity + (1.0 + e) * speed * n;
        let place = 3 * (law.particles() + particle);
        state[place..place + 3].copy_from_slice(&bounced.to_array());
        let mass = law.mass(particle).unwrap_or(0.0);
        impacts.push(Impact {
            time,
            particle,
            plane,
            speed,
            energy_lost: 0.5 * mass * (velocity.length_squared() - bounced.length_squared()),
        });
    }
    (unflat(&state), impacts)
}

/// When, within the next `step`, a gap closes, if it does.
fn crossing(law: &RightHandSide, state: &[f64], step: f64, gap: impl Fn(&[f64]) -> f64) -> Option<f64> {
    if gap(&advance(law, state, step)) >= 0.0 {
        return None;
    }
    // The step starts on the plane where it follows a bounce: find a time when the particle is above it.
    let mut open = 0.0;
    if gap(state) <= ON_THE_PLANE {
        open = step;
        while gap(&advance(law, state, open)) <= ON_THE_PLANE {
            open *= 0.5;
            assert!(open > 1e-9 * step, "no flight between two bounces");
        }
    }
    let mut shut = step;
    loop {
        let middle = 0.5 * (open + shut);
        if middle <= open || middle >= shut {
            return Some(shut);
        }
        if gap(&advance(law, state, middle)) >= 0.0 {
            open = middle;
        } else {
            shut = middle;
        }
    }
}

/// A gap below this, in m, is rounding left by a bounce located to the last bit: reference problems are metres in size.
const ON_THE_PLANE: f64 = 1e-13;

fn gap(plane: &ModelPlane, state: &[f64], particle: usize) -> f64 {
    DVec3::from(plane.normal).dot(vector(state, particle) - DVec3::from(plane.point))
}

/// One step of order 16.
fn advance(law: &RightHandSide, state: &[f64], step: f64) -> Vec<f64> {
    // Increments are extrapolated, not states: the rounding of an extrapolation is then as small as the step.
    let mut table: Vec<Vec<f64>> = Vec::with_capacity(COLUMNS);
    for row in 0..COLUMNS {
        let mut entry = modified_midpoint(law, state, step, substeps(row));
        // Aitken and Neville: entry k of this row from entry k − 1 of this row and of the one before.
        for column in 1..=row {
            let ratio = (substeps(row) as f64 / substeps(row - column) as f64).powi(2);
            let coarser = std::mem::replace(&mut table[column - 1], entry.clone());
            for (fine, coarse) in entry.iter_mut().zip(&coarser) {
                *fine += (*fine - coarse) / (ratio - 1.0);
            }
        }
        table.push(entry);
    }
    let increment = &table[COLUMNS - 1];
    state.iter().zip(increment).map(|(y, d)| y + d).collect()
}

const fn substeps(row: usize) -> usize {
    2 * (row + 1)
}

/// `z_1` = y + h f(y), `z_{m+1}` = `z_{m−1}` + 2 h f(`z_m`): what y grows by in `count` substeps.
fn modified_midpoint(law: &RightHandSide, state: &[f64], step: f64, count: usize) -> Vec<f64> {
    let substep = step / count as f64;
    let mut slope = vec![0.0; state.len()];
    let mut before = vec![0.0; state.len()];
    let mut now = vec![0.0; state.len()];
    let mut place = state.to_vec();
    for number in 0..count {
        derive(law, &place, &mut slope);
        let width = if number == 0 { substep } else { 2.0 * substep };
        for ((older, newer), rate) in before.iter_mut().zip(&mut now).zip(&slope) {
            let next = *older + width * rate;
            *older = std::mem::replace(newer, next);
        }
        for ((sum, start), grown) in place.iter_mut().zip(state).zip(&now) {
            *sum = start + grown;
        }
    }
    now
}

/// (x, v)˙ = (v, a(x, v))
fn derive(law: &RightHandSide, state: &[f64], slope: &mut [f64]) {
    let half = 3 * law.particles();
    let (position, velocity) = state.split_at(half);
    let (position_rate, velocity_rate) = slope.split_at_mut(half);
    position_rate.copy_from_slice(velocity);
    law.accelerate(position.as_chunks().0, velocity.as_chunks().0, velocity_rate.as_chunks_mut().0);
}

fn vector(state: &[f64], number: usize) -> DVec3 {
    DVec3::from_slice(&state[3 * number..])
}

fn flat(moment: &Moment) -> Vec<f64> {
    let both = [moment.position.as_flattened(), moment.velocity.as_flattened()];
    both.concat()
}

fn unflat(state: &[f64]) -> Moment {
    let (position, velocity) = state.split_at(state.len() / 2);
    Moment { position: position.as_chunks().0.to_vec(), velocity: velocity.as_chunks().0.to_vec() }
}
