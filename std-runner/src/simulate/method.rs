//! The stepper and the response that a scene names.

use hooke::{
    AdaptiveDop853, AdaptiveDormandPrinceRkn8, Auto, BlanesMoanS6, Choice, Chosen, DenseOutput, Dop853,
    DormandPrinceRkn8, ExplicitEuler, Full, ImplicitEuler, ImplicitEulerLinearised, ImplicitMidpoint, LinearSolver,
    Observer, Plan, Project, Real, Reflect, Response, Rk4, SemiImplicitEuler, StepError, StepReport, Stepper,
    TimeOfImpact, TrBdf2, VelocityVerlet, View,
};

use super::heap::Heap;
use super::time_step::chooses_steps;
use crate::scene::{CollisionForm, Settings, StepperName};

/// The blocks of a factor that implicit steppers may have for each spring: enough for cloths of 64 x 64.
pub const FILL: usize = 16;

/// Any of the steppers.
#[allow(clippy::large_enum_variant, reason = "there is one of it in a run")]
pub enum AnyStepper<R: Real> {
    /// `explicit-euler`
    ExplicitEuler(ExplicitEuler),
    /// `semi-implicit-euler`
    SemiImplicitEuler(SemiImplicitEuler),
    /// `implicit-euler`
    ImplicitEuler(ImplicitEuler<R, Heap, FILL>),
    /// `implicit-euler-linearised`
    ImplicitEulerLinearised(ImplicitEulerLinearised<R, Heap, FILL>),
    /// `implicit-midpoint`
    ImplicitMidpoint(ImplicitMidpoint<R, Heap, FILL>),
    /// `tr-bdf2`
    TrBdf2(TrBdf2<R, Heap, FILL>),
    /// `velocity-verlet`
    VelocityVerlet(VelocityVerlet<R, Heap>),
    /// `rk4`
    Rk4(Rk4<R, Heap>),
    /// `blanes-moan-s6`
    BlanesMoanS6(BlanesMoanS6<R, Heap>),
    /// `dop853`
    Dop853(Dop853<R, Heap>),
    /// `dormand-prince-rkn8`
    DormandPrinceRkn8(DormandPrinceRkn8<R, Heap>),
    /// `dop853`, with steps of its own choice, and what is between their ends
    AdaptiveDop853(DenseOutput<AdaptiveDop853<R, Heap>, R, Heap>),
    /// `dormand-prince-rkn8`, likewise
    AdaptiveDormandPrinceRkn8(AdaptiveDormandPrinceRkn8<R, Heap>),
    /// `auto`
    Auto(Auto<R, Heap, FILL>),
}

impl<R: Real> AnyStepper<R> {
    /// The stepper that settings ask for, for a scene whose farthest particle is `size` m from its middle: errors of steps
    /// that are chosen are relative to that.
    #[must_use]
    pub fn of(settings: &Settings, size: f64) -> Self {
        let tolerance = settings.tolerance * size;
        match settings.stepper {
            StepperName::Dop853 if chooses_steps(settings) => {
                Self::AdaptiveDop853(DenseOutput::of(AdaptiveDop853::new(tolerance)))
            }
            StepperName::DormandPrinceRkn8 if chooses_steps(settings) => {
                Self::AdaptiveDormandPrinceRkn8(AdaptiveDormandPrinceRkn8::new(tolerance))
            }
            stepper => Self::named(stepper, settings.tolerance),
        }
    }

    /// The stepper of that name, with steps as they are given; the implicit ones solve to `tolerance`.
    #[must_use]
    pub fn named(name: StepperName, tolerance: f64) -> Self {
        match name {
            StepperName::ExplicitEuler => Self::ExplicitEuler(ExplicitEuler),
            StepperName::SemiImplicitEuler => Self::SemiImplicitEuler(SemiImplicitEuler),
            StepperName::ImplicitEuler => Self::ImplicitEuler(ImplicitEuler::new(tolerance)),
            StepperName::ImplicitEulerLinearised => {
                Self::ImplicitEulerLinearised(ImplicitEulerLinearised::new(tolerance))
            }
            StepperName::ImplicitMidpoint => Self::ImplicitMidpoint(ImplicitMidpoint::new(tolerance)),
            StepperName::TrBdf2 => Self::TrBdf2(TrBdf2::new(tolerance)),
            StepperName::VelocityVerlet => Self::VelocityVerlet(VelocityVerlet::new()),
            StepperName::Rk4 => Self::Rk4(Rk4::new()),
            StepperName::BlanesMoanS6 => Self::BlanesMoanS6(BlanesMoanS6::new()),
            StepperName::Dop853 => Self::Dop853(Dop853::new()),
            StepperName::DormandPrinceRkn8 => Self::DormandPrinceRkn8(DormandPrinceRkn8::new()),
            StepperName::Auto => Self::Auto(Auto::new(tolerance)),
        }
    }

    /// Whichever it is.
    pub fn any(&mut self) -> &mut dyn Stepper<R> {
        match self {
            Self::ExplicitEuler(stepper) => stepper,
            Self::SemiImplicitEuler(stepper) => stepper,
            Self::ImplicitEuler(stepper) => stepper,
            Self::ImplicitEulerLinearised(stepper) => stepper,
            Self::ImplicitMidpoint(stepper) => stepper,
            Self::TrBdf2(stepper) => stepper,
            Self::VelocityVerlet(stepper) => stepper,
            Self::Rk4(stepper) => stepper,
            Self::BlanesMoanS6(stepper) => stepper,
            Self::Dop853(stepper) => stepper,
            Self::DormandPrinceRkn8(stepper) => stepper,
            Self::AdaptiveDop853(stepper) => stepper,
            Self::AdaptiveDormandPrinceRkn8(stepper) => stepper,
            Self::Auto(stepper) => stepper,
        }
    }

    /// What `auto` chose; nothing for the others, and before its first step.
    #[must_use]
    pub fn choice(&self) -> Option<Choice> {
        match self {
            Self::Auto(auto) => auto.choice(),
            _ => None,
        }
    }

    /// What solves the linear systems of steps of `dt` seconds, and why; nothing for explicit steppers.
    ///
    /// # Errors
    /// Never, on the heap.
    pub fn linear_solver(&mut self, view: &View<'_, R>, dt: f64) -> Result<Option<LinearSolver>, Full> {
        let dt = R::from_f64(dt);
        match self {
            Self::ImplicitEuler(stepper) => stepper.linear_solver(view, dt).map(Some),
            Self::ImplicitEulerLinearised(stepper) => stepper.linear_solver(view, dt).map(Some),
            Self::ImplicitMidpoint(stepper) => stepper.linear_solver(view, dt).map(Some),
            Self::TrBdf2(stepper) => stepper.linear_solver(view, dt).map(Some),
            // It steps explicitly where it can.
            Self::Auto(stepper) => match view.stability() {
                bound if Choice::of(bound, dt.to_f64()).chosen == Chosen::ImplicitEuler => {
                    stepper.linear_solver(view, dt).map(Some)
                }
                _ => Ok(None),
            },
            _ => Ok(None),
        }
    }
}

/// Any of the collision responses.
#[allow(clippy::large_enum_variant, reason = "there is one of it in a run")]
pub enum AnyResponse<R: Real> {
    /// `reflect`
    Reflect(Reflect),
    /// `project`
    Project(Project),
    /// `time-of-impact`
    TimeOfImpact(TimeOfImpact<R, Heap>),
}

impl<R: Real> AnyResponse<R> {
    /// The response of that name.
    #[must_use]
    pub fn named(name: CollisionForm) -> Self {
        match name {
            CollisionForm::Reflect => Self::Reflect(Reflect),
            CollisionForm::Project => Self::Project(Project),
            CollisionForm::TimeOfImpact => Self::TimeOfImpact(TimeOfImpact::new()),
        }
    }
}

impl<R: Real> Response<R> for AnyResponse<R> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        match self {
            Self::Reflect(response) => Response::<R>::fit(response, plan),
            Self::Project(response) => Response::<R>::fit(response, plan),
            Self::TimeOfImpact(response) => response.fit(plan),
        }
    }

    fn step(
        &mut self,
        view: &mut View<'_, R>,
        stepper: &mut (impl Stepper<R> + ?Sized),
        dt: R,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError> {
        match self {
            Self::Reflect(response) => response.step(view, stepper, dt, observer),
            Self::Project(response) => response.step(view, stepper, dt, observer),
            Self::TimeOfImpact(response) => response.step(view, stepper, dt, observer),
        }
    }
}
