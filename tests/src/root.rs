//! The root of implicit Euler's own equation, found without any of Hooke's solvers:
//! v' = v + dt·a(x + dt·v', v') by Newton's method with a dense Jacobian from finite differences.

use crate::dense::solve;
use crate::moment::Moment;
use crate::right_hand_side::RightHandSide;

/// One implicit Euler step, solved as far as rounding allows.
#[derive(Clone, Debug)]
pub struct Root {
    /// x' and v'.
    pub moment: Moment,
    /// The largest component of v' − v − dt·a(x', v'), m/s.
    pub residual: f64,
    /// Newton iterations, all stages of the continuation together.
    pub iterations: usize,
}

/// Newton's method found no root.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoRoot;

/// A Newton step below this part of the velocities (and of the positions over dt, which are rounded too) is the last.
const TOLERANCE: f64 = 1e-13;
/// Newton either doubles its digits within a few iterations or wanders.
const MOST_ITERATIONS: usize = 40;
/// The continuation starts at the time step halved this often, where every scene is nearly linear.
const HALVINGS: i32 = 16;

/// x' and v' after one implicit Euler step of `time_step` in s, for up to some 30 particles (the work grows with the cube).
///
/// The equation can have several roots at large steps: a mass may as well land on the far side of its pin.
/// This is the one on the branch that starts from x and v at dt = 0, followed up to the whole step.
/// Where that branch folds back before, there is none.
///
/// # Errors
/// Newton fails on the way, however closely the time steps follow each other.
pub fn implicit_euler(law: &RightHandSide, start: &Moment, time_step: f64) -> Result<Root, NoRoot> {
    let mut iterations = 0;
    // How many stages double the time step.
    for stages in [1, 4, 16] {
        let factors = (0..=HALVINGS * stages).rev().map(|stage| (-f64::from(stage) / f64::from(stages)).exp2());
        let followed = factors.map(|factor| time_step * factor).try_fold(Moment::clone(start), |place, dt| {
            let equation = Equation { law, start, dt };
            // The place that the stage before reached, not its velocity: at large steps that would overshoot.
            let guess = equation.velocity_to(&place);
            let velocity = equation.newton(guess, &mut iterations)?;
            Some(equation.moment(&velocity))
        });
        if let Some(moment) = followed {
            let equation = Equation { law, start, dt: time_step };
            return Ok(equation.root(moment, iterations));
        }
    }
    Err(NoRoot)
}

/// The root that Newton reaches from `guess`, whose velocities it starts at: for judging a solver's own answer.
///
/// # Errors
/// It reaches none.
pub fn implicit_euler_near(
    law: &RightHandSide,
    start: &Moment,
    time_step: f64,
    guess: &Moment,
) -> Result<Root, NoRoot> {
    let equation = Equation { law, start, dt: time_step };
    let mut iterations = 0;
    let velocity = equation.newton(guess.velocity.concat(), &mut iterations).ok_or(NoRoot)?;
    Ok(equation.root(equation.moment(&velocity), iterations))
}

/// v' − v − dt·a(x + dt·v', v') = 0
struct Equation<'a> {
    law: &'a RightHandSide,
    start: &'a Moment,
    dt: f64,
}

impl Equation<'_> {
    /// The state with velocities v' and positions x + dt·v'.
    fn moment(&self, velocity: &[f64]) -> Moment {
        let start = self.start.position.as_flattened();
        let position: Vec<f64> = start.iter().zip(velocity).map(|(x, v)| x + self.dt * v).collect();
        Moment { position: position.as_chunks().0.to_vec(), velocity: velocity.as_chunks().0.to_vec() }
    }

    /// The velocities that lead from the start to these positions in dt.
    fn velocity_to(&self, place: &Moment) -> Vec<f64> {
        let start = self.start.position.as_flattened();
        let parts = place.position.as_flattened().iter().zip(start);
        parts.map(|(to, from)| (to - from) / self.dt).collect()
    }

    fn root(&self, moment: Moment, iterations: usize) -> Root {
        Root { residual: largest(&self.residual(moment.velocity.as_flattened())), moment, iterations }
    }

    fn residual(&self, velocity: &[f64]) -> Vec<f64> {
        let moment = self.moment(velocity);
        let mut acceleration = vec![[0.0; 3]; moment.position.len()];
        self.law.accelerate(&moment.position, &moment.velocity, &mut acceleration);
        let start = self.start.velocity.as_flattened();
        let parts = velocity.iter().zip(start).zip(acceleration.as_flattened());
        parts.map(|((after, before), a)| after - before - self.dt * a).collect()
    }

    /// Row by row; central differences, whose error is far below what slows Newton down.
    fn jacobian(&self, velocity: &[f64]) -> Vec<Vec<f64>> {
        let size = velocity.len();
        let mut rows = vec![vec![0.0; size]; size];
        for column in 0..size {
            // The cube root of epsilon balances truncation against rounding for central differences.
            let width = f64::EPSILON.cbrt() * self.scale(velocity);
            let probe = |sign: f64| {
                let mut moved = velocity.to_vec();
                moved[column] += sign * width;
                self.residual(&moved)
            };
            let (ahead, behind) = (probe(1.0), probe(-1.0));
            for (row, (a, b)) in rows.iter_mut().zip(ahead.iter().zip(&behind)) {
                row[column] = (a - b) / (2.0 * width);
            }
        }
        rows
    }

    /// How large velocities, and positions over dt, are: their rounding limits how well v' can be known.
    fn scale(&self, velocity: &[f64]) -> f64 {
        let position = largest(self.moment(velocity).position.as_flattened());
        largest(velocity).max(position / self.dt).max(f64::MIN_POSITIVE)
    }

    fn newton(&self, mut velocity: Vec<f64>, iterations: &mut usize) -> Option<Vec<f64>> {
        for _ in 0..MOST_ITERATIONS {
            *iterations += 1;
            let correction = solve(self.jacobian(&velocity), self.residual(&velocity))?;
            for (v, c) in velocity.iter_mut().zip(&correction) {
                *v -= c;
            }
            let change = largest(&correction);
            if !change.is_finite() {
                return None;
            }
            if change <= TOLERANCE * self.scale(&velocity) {
                return Some(velocity);
            }
        }
        None
    }
}

/// The largest magnitude; a NaN makes it NaN, so that nothing converges on it.
fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest: f64, value| {
        if value.is_nan() {
            f64::NAN
        } else if value.abs() > largest {
            value.abs()
        } else {
            largest
        }
    })
}
