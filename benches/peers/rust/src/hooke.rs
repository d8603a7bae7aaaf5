//! Hooke, by the interface that its runner uses.

use std::error::Error;

use hooke::{Compensated, Project, Real};
use hooke_runner::model::Model;
use hooke_runner::scene::{Scene, StepperName};
use hooke_runner::simulate::{AnyStepper, world};

use crate::peer::{Outcome, Peer, Request, timed};

/// Relative residual at which an implicit step counts as solved: the default of scenes.
const TOLERANCE: f64 = 1e-6;

struct Hooke {
    model: Model,
    gravity: [f64; 3],
    stepper: StepperName,
    run: fn(&Hooke, &Request) -> Result<Outcome, Box<dyn Error>>,
}

/// `variant` is a stepper and a precision: `velocity-verlet:f64`.
pub fn new(variant: &str, scene: &Scene) -> Result<Box<dyn Peer>, Box<dyn Error>> {
    let (stepper, precision) = variant.split_once(':').ok_or("hooke:STEPPER:PRECISION")?;
    let run = match precision {
        "f32" => run::<f32>,
        "f32-compensated" => run::<Compensated>,
        "f64" => run::<f64>,
        _ => return Err(format!("no precision is called {precision}").into()),
    };
    Ok(Box::new(Hooke { model: scene.model()?, gravity: scene.settings().gravity, stepper: stepper.parse()?, run }))
}

impl Peer for Hooke {
    fn run(&mut self, request: &Request) -> Result<Outcome, Box<dyn Error>> {
        (self.run)(self, request)
    }
}

fn run<R: Real>(hooke: &Hooke, request: &Request) -> Result<Outcome, Box<dyn Error>>
where
    f64: From<R::Coordinate>,
{
    let mut world = world::<R>(&hooke.model, hooke.gravity)?;
    let mut stepper = AnyStepper::named(hooke.stepper, TOLERANCE);
    let time_step = R::from_f64(request.setting);
    // Sorts and lists the springs, once for all steps.
    world.view();
    let (cpu, stepped) = timed(|| {
        (0..request.steps()).try_for_each(|_| {
            let report = world.step(&mut stepper, &mut Project, time_step)?;
            if report.converged { Ok(()) } else { Err(Box::<dyn Error>::from("a step was not solved")) }
        })
    });
    stepped?;
    let position = world.view().states().flat_map(|(position, _)| position.into().map(f64::from)).collect();
    Ok(Outcome { cpu, position })
}
