//! The crate `diffsol`: Tsitouras 5(4), BDF of variable order, and ESDIRK 3(4), with sparse Jacobians.

use std::error::Error;

use diffsol::{FaerSparseLU, FaerSparseMat, OdeBuilder, OdeEquations, OdeSolverMethod, OdeSolverStopReason, Vector};
use hooke_runner::scene::Scene;

use crate::peer::{Outcome, Peer, Request, timed};
use crate::right_hand_side::RightHandSide;

pub struct Solver {
    equation: RightHandSide,
    method: Method,
}

enum Method {
    Tsit45,
    Bdf,
    Esdirk34,
}

pub fn new(method: &str, scene: &Scene) -> Result<Solver, Box<dyn Error>> {
    let method = match method {
        "tsit45" => Method::Tsit45,
        "bdf" => Method::Bdf,
        "esdirk34" => Method::Esdirk34,
        _ => return Err(format!("no method is called {method}").into()),
    };
    Ok(Solver { equation: RightHandSide::new(scene)?, method })
}

impl Peer for Solver {
    fn run(&mut self, request: &Request) -> Result<Outcome, Box<dyn Error>> {
        type Matrix = FaerSparseMat<f64>;
        type Lu = FaerSparseLU<f64>;
        let equation = &self.equation;
        let problem = OdeBuilder::<Matrix>::new()
            .rtol(request.setting)
            .atol([request.setting])
            .rhs_implicit(
                |state, _, _, rate| equation.rate(state, rate),
                |state, _, _, change, rate| equation.rate_change(state, change, rate),
            )
            .init(|_, _, state| state.copy_from_slice(&equation.start), equation.start.len())
            .build()?;
        let (cpu, state) = match self.method {
            Method::Tsit45 => solve(problem.tsit45()?, request.duration),
            Method::Bdf => solve(problem.bdf::<Lu>()?, request.duration),
            Method::Esdirk34 => solve(problem.esdirk34::<Lu>()?, request.duration),
        };
        Ok(Outcome { cpu, position: equation.positions(&state?) })
    }
}

/// The processor time, and the state at the end.
fn solve<'a, E: OdeEquations<T = f64> + 'a>(
    mut solver: impl OdeSolverMethod<'a, E>,
    duration: f64,
) -> (f64, Result<Vec<f64>, Box<dyn Error>>) {
    timed(|| {
        solver.set_stop_time(duration)?;
        while !matches!(solver.step()?, OdeSolverStopReason::TstopReached) {}
        Ok(solver.state().y.clone_as_vec())
    })
}
