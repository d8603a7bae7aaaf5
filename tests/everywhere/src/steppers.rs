//! The steppers by their names.

use hooke::{
    AdaptiveDop853, AdaptiveDormandPrinceRkn8, Auto, BlanesMoanS6, DenseOutput, Dop853, DormandPrinceRkn8,
    ExplicitEuler, Fixed, ImplicitEuler, ImplicitEulerLinearised, ImplicitMidpoint, Real, Rk4, SemiImplicitEuler,
    Stepper, TrBdf2, VelocityVerlet,
};

use crate::build::{PARTICLES, PLANES, SPRINGS};
use crate::row::StepperName;

/// Room for what steppers own.
pub type Workspace = Fixed<PARTICLES, SPRINGS, PLANES>;
/// Blocks of a factor a spring: enough for ropes, not for the cloth, so that both ways to solve are taken.
const FILL: usize = 2;
/// Of the implicit steppers, relative; within reach of single precision.
const TOLERANCE: f64 = 1e-4;
/// Of those that choose parts of steps, m.
const ERROR: f64 = 1e-5;

/// Calls `then` with a new stepper of that name.
pub fn with<R: Real>(name: StepperName, then: &mut dyn FnMut(&mut dyn Stepper<R>)) {
    match name {
        StepperName::ExplicitEuler => then(&mut ExplicitEuler),
        StepperName::SemiImplicitEuler => then(&mut SemiImplicitEuler),
        StepperName::ImplicitEuler => then(&mut ImplicitEuler::<R, Workspace, FILL>::new(TOLERANCE)),
        StepperName::ImplicitEulerLinearised => {
            then(&mut ImplicitEulerLinearised::<R, Workspace, FILL>::new(TOLERANCE));
        }
        StepperName::ImplicitMidpoint => then(&mut ImplicitMidpoint::<R, Workspace, FILL>::new(TOLERANCE)),
        StepperName::TrBdf2 => then(&mut TrBdf2::<R, Workspace, FILL>::new(TOLERANCE)),
        StepperName::VelocityVerlet => then(&mut VelocityVerlet::<R, Workspace>::new()),
        StepperName::Rk4 => then(&mut Rk4::<R, Workspace>::new()),
        StepperName::BlanesMoanS6 => then(&mut BlanesMoanS6::<R, Workspace>::new()),
        StepperName::Dop853 => then(&mut Dop853::<R, Workspace>::new()),
        StepperName::AdaptiveDop853 => {
            then(&mut DenseOutput::<_, R, Workspace>::of(AdaptiveDop853::<R, Workspace>::new(ERROR)));
        }
        StepperName::DormandPrinceRkn8 => then(&mut DormandPrinceRkn8::<R, Workspace>::new()),
        StepperName::AdaptiveDormandPrinceRkn8 => then(&mut AdaptiveDormandPrinceRkn8::<R, Workspace>::new(ERROR)),
        StepperName::Auto => then(&mut Auto::<R, Workspace, FILL>::new(TOLERANCE)),
    }
}
