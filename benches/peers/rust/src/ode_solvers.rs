//! The crate `ode_solvers`: Runge-Kutta of order 4 at a fixed step, Dormand-Prince 8(5,3) to a tolerance.

use std::error::Error;

use hooke_runner::scene::Scene;
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{DVector, Dop853, Rk4, System};

use crate::peer::{Outcome, Peer, Request, timed};
use crate::right_hand_side::RightHandSide;

/// RK4 keeps every state it has been in: it is started again after so many steps, which is faster than letting it.
const STEPS_AT_ONCE: usize = 100;

pub struct Solver {
    equation: RightHandSide,
    solve: Solve,
}

type Solve = fn(&RightHandSide, &Request) -> Result<DVector<f64>, Box<dyn Error>>;

pub fn new(method: &str, scene: &Scene) -> Result<Solver, Box<dyn Error>> {
    let solve: Solve = match method {
        "rk4" => rk4,
        "dop853" => dop853,
        _ => return Err(format!("no method is called {method}").into()),
    };
    Ok(Solver { equation: RightHandSide::new(scene)?, solve })
}

impl Peer for Solver {
    fn run(&mut self, request: &Request) -> Result<Outcome, Box<dyn Error>> {
        let (cpu, state) = timed(|| (self.solve)(&self.equation, request));
        Ok(Outcome { cpu, position: self.equation.positions(state?.as_slice()) })
    }
}

impl System<f64, DVector<f64>> for &RightHandSide {
    fn system(&self, _: f64, state: &DVector<f64>, rate: &mut DVector<f64>) {
        self.rate(state.as_slice(), rate.as_mut_slice());
    }
}

fn rk4(equation: &RightHandSide, request: &Request) -> Result<DVector<f64>, Box<dyn Error>> {
    let mut state = DVector::from_vec(equation.start.clone());
    let mut left = request.steps();
    while left > 0 {
        let steps = left.min(STEPS_AT_ONCE);
        // It rounds the number of steps up: half a step less than it should be is safe.
        let end = (steps as f64 - 0.5) * request.setting;
        let mut solver = Rk4::new(equation, 0.0, state, end, request.setting);
        solver.integrate()?;
        state = solver.y_out().last().ok_or("it gave no state")?.clone();
        left -= steps;
    }
    Ok(state)
}

fn dop853(equation: &RightHandSide, request: &Request) -> Result<DVector<f64>, Box<dyn Error>> {
    let (start, tolerance) = (DVector::from_vec(equation.start.clone()), request.setting);
    let mut solver = Dop853::new(equation, 0.0, request.duration, request.duration, start, tolerance, tolerance);
    solver.set_output(OutputType::Sparse);
    solver.integrate()?;
    Ok(solver.y_out().last().ok_or("it gave no state")?.clone())
}
