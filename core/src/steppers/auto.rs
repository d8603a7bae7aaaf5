//! The stepper that may be clever.

use core::fmt;

use super::{ImplicitEuler, SemiImplicitEuler, VelocityVerlet};
use crate::Real;
use crate::collisions::Flights;
use crate::roles::Stepper;
use crate::solve::LinearSolver;
use crate::stability::{StabilityBound, bound};
use crate::types::{Full, StepReport};
use crate::world::{Plan, Storage, View};

/// Steps after which the stability bound is worked out anew: it costs a few force evaluations, so about 5 %.
const STEPS_BETWEEN_BOUNDS: u32 = 64;

/// Steps that come closer to the bound than this are not taken: between two bounds springs stretch and turn.
const MARGIN: f64 = 0.95;

/// Flies particles without springs exactly, and steps the others by the cheapest stepper that is stable and good
/// enough: velocity Verlet while its stability bound allows the time step, semi-implicit Euler (which damping limits
/// less) while its own does, and implicit Euler, which has none, past both.
///
/// Exact flight, from plane to plane without stepping in between, needs [`crate::TimeOfImpact`]; the other responses
/// answer hits at the end of each step, up to which such a particle then flies by x + dt v + ½dt² g.
///
/// ```
/// use hooke::{Auto, Chosen, Fixed, Particle, Spring, TimeOfImpact, World};
///
/// let mut world = World::<f64, 2, 1, 0>::new();
/// let pin = world.add_particle(Particle::at([0.0; 3]).pinned())?;
/// let mass = world.add_particle(Particle::at([1.1, 0.0, 0.0]))?;
/// world.add_spring(Spring::new([pin, mass], 100.0, 1.0))?;
/// let mut stepper = Auto::<f64, Fixed<2, 1, 0>>::new(1e-6);
/// let mut response = TimeOfImpact::<f64, Fixed<2, 1, 0>>::new();
/// // ω = 10 rad/s: Verlet is stable up to 0.2 s.
/// world.step(&mut stepper, &mut response, 0.1)?;
/// assert_eq!(stepper.choice().map(|choice| choice.chosen), Some(Chosen::VelocityVerlet));
/// world.step(&mut stepper, &mut response, 1.0)?;
/// assert_eq!(stepper.choice().map(|choice| choice.chosen), Some(Chosen::ImplicitEuler));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Auto<R: Real, M: Storage, const FILL: usize = 1> {
    verlet: VelocityVerlet<R, M>,
    implicit: ImplicitEuler<R, M, FILL>,
    flights: Flights<R, M>,
    choice: Option<Choice>,
    /// Until the next bound.
    steps_left: u32,
    /// The changes from outside that the choice was made after, and the time step it was made for.
    made_for: (u64, f64),
}

/// What steps the particles that springs pull at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chosen {
    /// Nothing: there are none.
    Flight,
    /// [`VelocityVerlet`]
    VelocityVerlet,
    /// [`SemiImplicitEuler`]
    SemiImplicitEuler,
    /// [`ImplicitEuler`]
    ImplicitEuler,
}

/// What [`Auto`] chose, and why: its `Display` says so in words.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// What was chosen.
    pub chosen: Chosen,
    /// The time step that it was chosen for, s.
    pub time_step: f64,
    /// The bounds that decided; nothing where no spring pulls at a free particle.
    pub bound: Option<StabilityBound>,
}

impl<R: Real, M: Storage, const FILL: usize> Auto<R, M, FILL> {
    /// With the tolerance of [`ImplicitEuler`], should it be chosen: relative, without a unit; 1e-6, say. Without room for any
    /// particles yet.
    #[must_use]
    pub const fn new(tolerance: f64) -> Self {
        Self {
            verlet: VelocityVerlet::new(),
            implicit: ImplicitEuler::new(tolerance),
            flights: Flights::new(),
            choice: None,
            steps_left: 0,
            made_for: (0, 0.0),
        }
    }

    /// What it chose last; nothing before the first step.
    #[must_use]
    pub fn choice(&self) -> Option<Choice> {
        self.choice
    }

    /// What solves the linear systems of [`ImplicitEuler`]'s steps of `dt` seconds, should it be chosen, and why.
    ///
    /// # Errors
    /// If the workspace has a fixed capacity and the world is larger.
    pub fn linear_solver(&mut self, view: &View<'_, R>, dt: R) -> Result<LinearSolver, Full> {
        self.implicit.linear_solver(view, dt)
    }

    fn choose(&mut self, view: &View<'_, R>, dt: R) -> Chosen {
        let made_for = (view.changes, dt.to_f64());
        match self.choice {
            Some(choice) if self.steps_left > 0 && self.made_for == made_for => {
                self.steps_left -= 1;
                choice.chosen
            }
            _ => {
                self.made_for = made_for;
                self.steps_left = STEPS_BETWEEN_BOUNDS;
                let choice = Choice::of(bound(&view.system, view.system.plan.attached, &view.current), dt.to_f64());
                self.choice = Some(choice);
                choice.chosen
            }
        }
    }
}

impl Choice {
    /// What [`Auto`] chooses for a time step (s; positive and finite) within these bounds; nothing where no spring pulls at a free
    /// particle.
    #[must_use]
    pub fn of(bound: Option<StabilityBound>, time_step: f64) -> Self {
        let chosen = match bound {
            None => Chosen::Flight,
            Some(bound) if time_step <= MARGIN * bound.velocity_verlet => Chosen::VelocityVerlet,
            Some(bound) if time_step <= MARGIN * bound.semi_implicit_euler => Chosen::SemiImplicitEuler,
            Some(_) => Chosen::ImplicitEuler,
        };
        Self { chosen, time_step, bound }
    }
}

impl<R: Real, M: Storage, const FILL: usize> Stepper<R> for Auto<R, M, FILL> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        self.verlet.fit(plan)?;
        self.implicit.fit(plan)?;
        self.flights.fit(plan)
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        match self.choose(view, dt) {
            // Without springs that pull, Verlet's step is the exact x + dt v + ½dt² g.
            Chosen::Flight | Chosen::VelocityVerlet => self.verlet.advance(view, dt),
            Chosen::SemiImplicitEuler => SemiImplicitEuler.advance(view, dt),
            Chosen::ImplicitEuler => self.implicit.advance(view, dt),
        }
    }

    fn order(&self) -> u32 {
        2
    }

    fn curvature(&self) -> R {
        R::from_f64(0.5)
    }

    fn fly(&mut self, view: &mut View<'_, R>, from: f64, report: &mut StepReport) -> Option<f64> {
        Some(self.flights.fly(view, from, report))
    }

    fn look_ahead(&mut self, view: &mut View<'_, R>, time: f64) -> bool {
        self.flights.look_ahead(view, time)
    }

    fn rearranged(&mut self, view: &View<'_, R>) {
        self.verlet.rearranged(view);
    }
}

impl fmt::Display for Choice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let dt = Seconds(self.time_step);
        let Some(bound) = self.bound else {
            return write!(f, "exact flight: no spring pulls at any free particle");
        };
        let (verlet, semi_implicit) = (Seconds(bound.velocity_verlet), Seconds(bound.semi_implicit_euler));
        match self.chosen {
            Chosen::Flight => write!(f, "exact flight"),
            Chosen::VelocityVerlet if bound.velocity_verlet == f64::INFINITY => {
                write!(f, "velocity-verlet: second order, and the springs limit no time step")
            }
            Chosen::VelocityVerlet => {
                write!(f, "velocity-verlet: second order, and stable at {dt}, below its bound of {verlet}")
            }
            Chosen::SemiImplicitEuler => write!(
                f,
                "semi-implicit-euler: stable at {dt}, below its bound of {semi_implicit}; velocity-verlet's is {verlet}"
            ),
            Chosen::ImplicitEuler => write!(
                f,
                "implicit-euler: {dt} is past the bounds of velocity-verlet ({verlet}) and semi-implicit-euler \
                 ({semi_implicit})"
            ),
        }
    }
}

/// Shown in a unit that leaves a number to read.
struct Seconds(f64);

impl fmt::Display for Seconds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            seconds if seconds >= 1.0 => write!(f, "{seconds:.3} s"),
            seconds if seconds >= 1e-3 => write!(f, "{:.3} ms", 1e3 * seconds),
            seconds if seconds >= 1e-6 => write!(f, "{:.3} µs", 1e6 * seconds),
            seconds => write!(f, "{seconds:.3e} s"),
        }
    }
}
