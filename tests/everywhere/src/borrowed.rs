//! Any stepper behind one type, so that the collision responses are compiled once, not once a stepper.

use hooke::{Full, Plan, Real, StepError, StepReport, Stepper, View};

/// A stepper that is only known when it runs.
pub struct Borrowed<'a, R: Real>(pub &'a mut dyn Stepper<R>);

impl<R: Real> Stepper<R> for Borrowed<'_, R> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        self.0.fit(plan)
    }

    fn accept(&self, plan: &Plan) -> Result<(), StepError> {
        self.0.accept(plan)
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        self.0.advance(view, dt)
    }

    fn advance_up_to(&mut self, view: &mut View<'_, R>, most: R, report: &mut StepReport) -> R {
        self.0.advance_up_to(view, most, report)
    }

    fn chooses_parts(&self) -> bool {
        self.0.chooses_parts()
    }

    fn begins(&mut self, view: &View<'_, R>) {
        self.0.begins(view);
    }

    fn fails(&mut self, view: &mut View<'_, R>) {
        self.0.fails(view);
    }

    fn between<'a>(&'a mut self, view: &'a mut View<'_, R>, dt: R, after: R) -> Option<View<'a, R>> {
        self.0.between(view, dt, after)
    }

    fn order(&self) -> u32 {
        self.0.order()
    }

    fn curvature(&self) -> R {
        self.0.curvature()
    }

    fn fly(&mut self, view: &mut View<'_, R>, from: f64, report: &mut StepReport) -> Option<f64> {
        self.0.fly(view, from, report)
    }

    fn look_ahead(&mut self, view: &mut View<'_, R>, time: f64) -> bool {
        self.0.look_ahead(view, time)
    }

    fn rearranged(&mut self, view: &View<'_, R>) {
        self.0.rearranged(view);
    }
}
