//! The springs at the end of a step that is sought: their forces, and the sizes of these.

use crate::Real;
use crate::vectors::{Columns, at, difference, dot, fetch, put, scaled};
use crate::world::{Coverage, System};

/// What of each spring is known in a state.
pub struct Evaluated<'a, R> {
    /// d̂, or 0 for a spring of length 0.
    pub axis: &'a mut [[R; 3]],
    /// Tension over length, N/m; 0 for a spring of length 0.
    pub force_density: &'a mut [R],
}

/// The impulse of the springs on a particle in a step, kg·m/s, and what it is made of: Σ dt|tension|, then
/// s = Σ (dt·k + k_d), kg/s, and Σ (dt·k + k_d) l, kg·m/s.
pub type Impulse<R> = [R; 6];

impl<R: Real> Evaluated<'_, R> {
    /// Evaluates all springs, adds up their impulses by slot, and returns how many springs have length 0.
    pub fn springs(
        &mut self,
        system: &System<'_, R>,
        position: Columns<'_, R>,
        velocity: Columns<'_, R>,
        dt: R,
        impulses: &mut [Impulse<R>],
    ) -> u32 {
        impulses.fill([R::ZERO; 6]);
        if system.plan.damped == Coverage::None {
            self.each::<false>(system, position, velocity, dt, impulses)
        } else {
            self.each::<true>(system, position, velocity, dt, impulses)
        }
    }

    fn each<const DAMPED: bool>(
        &mut self,
        system: &System<'_, R>,
        position: Columns<'_, R>,
        velocity: Columns<'_, R>,
        dt: R,
        impulses: &mut [Impulse<R>],
    ) -> u32 {
        let springs = system.springs;
        let parameters = springs.stiffness.iter().zip(springs.damping).zip(springs.rest_length);
        let records = self.axis.iter_mut().zip(self.force_density.iter_mut());
        let mut degenerate = 0;
        for ((&[i, j], (axis, q)), ((&k, &k_d), &rest_length)) in springs.ends.iter().zip(records).zip(parameters) {
            let d = difference(fetch(position, j), fetch(position, i));
            let length = dot(d, d).sqrt();
            let mut strength = dt * k;
            if DAMPED {
                strength += k_d;
            }
            let mut tension = R::ZERO;
            if length == R::ZERO {
                degenerate += 1;
                (*axis, *q) = ([R::ZERO; 3], R::ZERO);
            } else {
                let inverse_length = R::ONE / length;
                *axis = scaled(inverse_length, d);
                tension = k * (length - rest_length);
                if DAMPED {
                    let rate = dot(difference(fetch(velocity, j), fetch(velocity, i)), *axis);
                    tension += k_d * rate;
                }
                *q = tension * inverse_length;
            }
            let impulse = dt * tension;
            let [x, y, z] = scaled(impulse, *axis);
            let sizes = [impulse.abs(), strength, strength * length];
            add(impulses, i, [x, y, z], sizes);
            add(impulses, j, [-x, -y, -z], sizes);
        }
        degenerate
    }
}

#[inline(always)]
fn add<R: Real>(impulses: &mut [Impulse<R>], slot: u32, [x, y, z]: [R; 3], [size, strength, moment]: [R; 3]) {
    let [a, b, c, d, e, f] = at(impulses, slot);
    put(impulses, slot, [a + x, b + y, c + z, d + size, e + strength, f + moment]);
}
