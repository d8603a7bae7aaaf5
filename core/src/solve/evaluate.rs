//! The springs at the end of a step that is sought: their forces, and the sizes of these.

use super::workspace::Scratch;
use crate::Real;
use crate::vectors::{difference, dot, fetch_inlined, read, scaled};
use crate::world::{Coverage, State, System};

/// The impulse of the springs on a particle in a step, kg·m/s, and what it is made of: Σ dt|tension|, then
/// s = Σ (dt·k + k_d), kg/s, and Σ (dt·k + k_d) l, kg·m/s.
pub type Impulse<R> = [R; 6];

impl<R: Real> Scratch<'_, R> {
    /// Evaluates all springs in a state, adds up their impulses by slot, and returns how many springs have length 0.
    pub fn evaluate(&mut self, system: &System<'_, R>, state: &State<'_, R>, dt: R) -> u32 {
        self.blocks.as_flattened_mut().fill(R::ZERO);
        let is_damped = system.plan.damped != Coverage::None;
        let springs = system.springs;
        let (position, velocity) = (read(&state.position), read(&state.velocity));
        let parameters = springs.stiffness.iter().zip(springs.damping).zip(springs.rest_length);
        let records = self.axis.iter_mut().zip(self.force_density.iter_mut());
        let mut degenerate = 0;
        for ((&[i, j], (axis, q)), ((&k, &k_d), &rest_length)) in springs.ends.iter().zip(records).zip(parameters) {
            let d = difference(fetch_inlined(position, j), fetch_inlined(position, i));
            let length = dot(d, d).sqrt();
            let mut strength = dt * k;
            if is_damped {
                strength += k_d;
            }
            let mut tension = R::ZERO;
            if length == R::ZERO {
                degenerate += 1;
                (*axis, *q) = (const { [R::ZERO; 3] }, R::ZERO);
            } else {
                let inverse_length = R::ONE / length;
                *axis = scaled(inverse_length, d);
                tension = k * (length - rest_length);
                if is_damped {
                    let rate = dot(difference(fetch_inlined(velocity, j), fetch_inlined(velocity, i)), *axis);
                    tension += k_d * rate;
                }
                *q = tension * inverse_length;
            }
            let impulse = dt * tension;
            let [x, y, z] = scaled(impulse, *axis);
            let mut impulse = [x, y, z, impulse.abs(), strength, strength * length];
            add(self.blocks, i, &impulse);
            impulse.iter_mut().take(3).for_each(|component| *component = -*component);
            add(self.blocks, j, &impulse);
        }
        degenerate
    }
}

#[inline(always)]
fn add<R: Real>(impulses: &mut [Impulse<R>], slot: u32, impulse: &Impulse<R>) {
    if let Some(sum) = impulses.get_mut(slot as usize) {
        for (sum, part) in sum.iter_mut().zip(impulse) {
            *sum += *part;
        }
    }
}
