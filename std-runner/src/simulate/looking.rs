//! What looks into the parts of a step while they are made: at the frames within them, and at their energy.

use hooke::{Observer, Stepper, View};

use super::Stepped;
use super::audit::Audit;
use super::frames::Frames;

/// Takes frames within parts of a step, and follows its energy if that is asked.
pub(super) struct Looking<'a, R: Stepped> {
    pub(super) frames: &'a mut Frames<R>,
    /// The step of the schedule.
    pub(super) step: u64,
    pub(super) audit: Option<&'a mut Audit>,
}

impl<R: Stepped> Looking<'_, R> {
    fn audit(&mut self, tell: impl FnOnce(&mut Audit)) {
        if let Some(audit) = &mut self.audit {
            tell(audit);
        }
    }
}

impl<R: Stepped> Observer<R> for Looking<'_, R> {
    fn watches(&self) -> bool {
        self.audit.is_some()
    }

    fn advanced(&mut self, view: &mut View<'_, R>, dt: R) {
        self.audit(|audit| audit.advanced(view, dt));
    }

    fn advanced_by(&mut self, view: &mut View<'_, R>, dt: R, stepper: &mut (impl Stepper<R> + ?Sized)) {
        self.frames.within_part(view, dt, stepper, self.step);
        self.advanced(view, dt);
    }

    fn lost_in_impacts(&mut self, energy: f64) {
        self.audit(|audit| Observer::<R>::lost_in_impacts(audit, energy));
    }

    fn fell_asleep(&mut self, energy: f64) {
        self.audit(|audit| Observer::<R>::fell_asleep(audit, energy));
    }

    fn begins(&mut self) {
        self.audit(Observer::<R>::begins);
    }

    fn fails(&mut self) {
        self.audit(Observer::<R>::fails);
    }
}
