//! The stepper, the response and the observer of a world, chosen while it runs.

use hooke::{
    Auto, BlanesMoanS6, Dop853, DormandPrinceRkn8, ExplicitEuler, Full, ImplicitEuler, ImplicitEulerLinearised,
    ImplicitMidpoint, Ledger, Observer, Plan, Project, Real, Reflect, Response, Rk4, SemiImplicitEuler, StepError,
    StepReport, Stepper, TimeOfImpact, TrBdf2, VelocityVerlet, View,
};

use crate::arena::InArena;
use crate::options::{HookeCollision, HookeStepper};

/// The blocks of a factor that implicit steppers may have for each spring, as on the desktop: the bits are the same only
/// where the room is.
pub const FILL: usize = 16;

/// Any of the steppers.
#[allow(clippy::large_enum_variant, reason = "there is one of it in a world")]
pub enum AnyStepper<R: Real> {
    ExplicitEuler(ExplicitEuler),
    SemiImplicitEuler(SemiImplicitEuler),
    ImplicitEuler(ImplicitEuler<R, InArena, FILL>),
    ImplicitEulerLinearised(ImplicitEulerLinearised<R, InArena, FILL>),
    VelocityVerlet(VelocityVerlet<R, InArena>),
    Rk4(Rk4<R, InArena>),
    BlanesMoanS6(BlanesMoanS6<R, InArena>),
    Dop853(Dop853<R, InArena>),
    DormandPrinceRkn8(DormandPrinceRkn8<R, InArena>),
    ImplicitMidpoint(ImplicitMidpoint<R, InArena, FILL>),
    TrBdf2(TrBdf2<R, InArena, FILL>),
    Auto(Auto<R, InArena, FILL>),
}

impl<R: Real> AnyStepper<R> {
    /// The stepper of that name; the implicit ones solve to `tolerance`.
    pub fn named(name: HookeStepper, tolerance: f64) -> Self {
        match name {
            HookeStepper::ExplicitEuler => Self::ExplicitEuler(ExplicitEuler),
            HookeStepper::SemiImplicitEuler => Self::SemiImplicitEuler(SemiImplicitEuler),
            HookeStepper::ImplicitEuler => Self::ImplicitEuler(ImplicitEuler::new(tolerance)),
            HookeStepper::ImplicitEulerLinearised => {
                Self::ImplicitEulerLinearised(ImplicitEulerLinearised::new(tolerance))
            }
            HookeStepper::VelocityVerlet => Self::VelocityVerlet(VelocityVerlet::new()),
            HookeStepper::Rk4 => Self::Rk4(Rk4::new()),
            HookeStepper::BlanesMoanS6 => Self::BlanesMoanS6(BlanesMoanS6::new()),
            HookeStepper::Dop853 => Self::Dop853(Dop853::new()),
            HookeStepper::DormandPrinceRkn8 => Self::DormandPrinceRkn8(DormandPrinceRkn8::new()),
            HookeStepper::ImplicitMidpoint => Self::ImplicitMidpoint(ImplicitMidpoint::new(tolerance)),
            HookeStepper::TrBdf2 => Self::TrBdf2(TrBdf2::new(tolerance)),
            HookeStepper::Auto => Self::Auto(Auto::new(tolerance)),
        }
    }

    /// Whichever it is.
    pub fn any(&mut self) -> &mut dyn Stepper<R> {
        match self {
            Self::ExplicitEuler(stepper) => stepper,
            Self::SemiImplicitEuler(stepper) => stepper,
            Self::ImplicitEuler(stepper) => stepper,
            Self::ImplicitEulerLinearised(stepper) => stepper,
            Self::VelocityVerlet(stepper) => stepper,
            Self::Rk4(stepper) => stepper,
            Self::BlanesMoanS6(stepper) => stepper,
            Self::Dop853(stepper) => stepper,
            Self::DormandPrinceRkn8(stepper) => stepper,
            Self::ImplicitMidpoint(stepper) => stepper,
            Self::TrBdf2(stepper) => stepper,
            Self::Auto(stepper) => stepper,
        }
    }

    /// Makes room for what solves the linear systems of steps of `dt` seconds, if the stepper has any.
    pub fn prepare(&mut self, view: &View<'_, R>, dt: R) -> Result<(), Full> {
        match self {
            Self::ImplicitEuler(stepper) => stepper.linear_solver(view, dt).map(|_| ()),
            Self::ImplicitEulerLinearised(stepper) => stepper.linear_solver(view, dt).map(|_| ()),
            Self::ImplicitMidpoint(stepper) => stepper.linear_solver(view, dt).map(|_| ()),
            Self::TrBdf2(stepper) => stepper.linear_solver(view, dt).map(|_| ()),
            Self::Auto(stepper) => stepper.linear_solver(view, dt).map(|_| ()),
            _ => Ok(()),
        }
    }
}

/// Any of the collision responses.
#[allow(clippy::large_enum_variant, reason = "there is one of it in a world")]
pub enum AnyResponse<R: Real> {
    Reflect(Reflect),
    Project(Project),
    TimeOfImpact(TimeOfImpact<R, InArena>),
}

impl<R: Real> AnyResponse<R> {
    /// The response of that name.
    pub fn named(name: HookeCollision) -> Self {
        match name {
            HookeCollision::Reflect => Self::Reflect(Reflect),
            HookeCollision::Project => Self::Project(Project),
            HookeCollision::TimeOfImpact => Self::TimeOfImpact(TimeOfImpact::new()),
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

/// A ledger, if one has been opened: one kind of observer, so that there is one copy of the steps.
#[derive(Default)]
pub struct MaybeLedger(pub Option<Ledger>);

impl<R: Real> Observer<R> for MaybeLedger {
    fn watches(&self) -> bool {
        self.0.is_some()
    }

    fn advanced(&mut self, view: &mut View<'_, R>, dt: R) {
        if let Some(ledger) = &mut self.0 {
            ledger.advanced(view, dt);
        }
    }

    fn lost_in_impacts(&mut self, energy: f64) {
        if let Some(ledger) = &mut self.0 {
            Observer::<R>::lost_in_impacts(ledger, energy);
        }
    }

    fn fell_asleep(&mut self, energy: f64) {
        if let Some(ledger) = &mut self.0 {
            Observer::<R>::fell_asleep(ledger, energy);
        }
    }

    fn begins(&mut self) {
        if let Some(ledger) = &mut self.0 {
            Observer::<R>::begins(ledger);
        }
    }

    fn fails(&mut self) {
        if let Some(ledger) = &mut self.0 {
            Observer::<R>::fails(ledger);
        }
    }
}
