//! A row, stepped.

use core::fmt;

use hooke::{
    Compensated, Lanes, Project, Real, Reflect, Response, StepError, StepReport, Stepper, TimeOfImpact, Workers,
};

use crate::build::Room;
#[cfg(feature = "changed-bit")]
use crate::changed_bit;
use crate::row::{Form, Precision, Row};
use crate::steppers::{self, Workspace};

/// What it is stepped with: none of this may show in the bits.
#[derive(Clone, Copy, Debug)]
pub struct Machine<'a> {
    /// The widest vector instructions.
    pub lanes: Lanes,
    /// Threads, if there are any.
    pub workers: Option<&'a dyn Workers>,
}

/// The position (m) and the velocity (m/s) of a particle, widened to double precision.
pub type Moment = [f64; 6];

/// Where a course has come to.
pub enum Reached<'a> {
    /// The end of a step.
    Step {
        /// Its number, from 1.
        number: u32,
        /// What it tells of itself.
        report: &'a StepReport,
        /// Of the state at its end.
        digest: u64,
        /// That state, by particle.
        state: &'a mut dyn Iterator<Item = Moment>,
    },
    /// A step that was refused, which ends it.
    Refused(StepError),
    /// The world cannot be built: a mistake in this package, and what it is.
    Unbuilt(fmt::Arguments<'a>),
}

impl Row {
    /// Steps it to its end, or to the first step that is refused, and tells of each.
    pub fn follow(self, machine: Machine<'_>, tell: &mut dyn FnMut(Reached<'_>)) {
        match self.precision {
            Precision::F32 => self.follow_in::<f32>(machine, tell),
            Precision::F32Compensated => self.follow_in::<Compensated>(machine, tell),
            Precision::F64 => self.follow_in::<f64>(machine, tell),
        }
    }

    fn follow_in<R: Real>(self, machine: Machine<'_>, tell: &mut dyn FnMut(Reached<'_>)) {
        let mut world = match self.scene.build::<R>() {
            Ok(world) => world,
            Err(error) => return tell(Reached::Unbuilt(format_args!("{error}"))),
        };
        world.set_lanes(machine.lanes);
        steppers::with(self.stepper, &mut |stepper| match self.form {
            Form::Reflect => self.steps(&mut world, stepper, &mut Reflect, machine, tell),
            Form::Project => self.steps(&mut world, stepper, &mut Project, machine, tell),
            Form::TimeOfImpact => {
                let mut response = TimeOfImpact::<R, Workspace>::new();
                self.steps(&mut world, stepper, &mut response, machine, tell);
            }
        });
    }

    fn steps<R: Real>(
        self,
        world: &mut Room<R>,
        stepper: &mut dyn Stepper<R>,
        response: &mut impl Response<R>,
        machine: Machine<'_>,
        tell: &mut dyn FnMut(Reached<'_>),
    ) {
        let dt = R::from_f64(self.scene.time_step());
        for number in 1..=self.scene.steps() {
            let mut view = world.view();
            if let Some(workers) = machine.workers {
                view.share_among(workers);
            }
            let report = match view.step(stepper, response, dt) {
                Ok(report) => report,
                Err(error) => return tell(Reached::Refused(error)),
            };
            #[cfg(feature = "changed-bit")]
            changed_bit::after_step(self, number, world);
            let view = world.view();
            let digest = hooke_digest::of(&view);
            let mut state = view.states().map(|(position, velocity)| {
                let [[x, y, z], [u, v, w]]: [[R::Coordinate; 3]; 2] = [position.into(), velocity.into()];
                [x, y, z, u, v, w].map(R::Coordinate::to_f64)
            });
            tell(Reached::Step { number, report: &report, digest, state: &mut state });
        }
    }
}
