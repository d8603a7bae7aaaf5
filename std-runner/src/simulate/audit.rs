//! What is followed of a run besides its state: its energy, and when hits cut its steps.

use hooke::{Balance, Ledger, Observer, Real, View};

/// An energy ledger that notes when impacts were answered.
#[derive(Clone, Debug)]
pub struct Audit {
    ledger: Ledger,
    /// The end of what was stepped last, s.
    now: f64,
    /// When impacts were answered since the last look, s.
    answered: Vec<f64>,
}

impl Audit {
    /// Begins with the current state.
    pub fn open<R: Real>(view: &View<'_, R>) -> Self {
        Self { ledger: Ledger::open(view), now: view.time(), answered: Vec::new() }
    }

    /// The balance at the current state.
    pub fn balance<R: Real>(&self, view: &View<'_, R>) -> Balance {
        self.ledger.balance(view)
    }

    /// When hits have cut the last step, s; where nothing has, there are none. Forgets them.
    pub fn cuts(&mut self) -> std::vec::Drain<'_, f64> {
        // The last ones are those at the end of the step, whether there were any or not.
        let inside = self.answered.iter().filter(|time| **time < self.now).count();
        self.answered.truncate(inside);
        self.answered.drain(..)
    }
}

impl<R: Real> Observer<R> for Audit {
    fn watches(&self) -> bool {
        true
    }

    fn advanced(&mut self, view: &mut View<'_, R>, dt: R) {
        self.now = view.time() + dt.to_f64();
        self.ledger.advanced(view, dt);
    }

    fn lost_in_impacts(&mut self, energy: f64) {
        self.answered.push(self.now);
        Observer::<R>::lost_in_impacts(&mut self.ledger, energy);
    }

    fn fell_asleep(&mut self, energy: f64) {
        Observer::<R>::fell_asleep(&mut self.ledger, energy);
    }

    fn begins(&mut self) {
        Observer::<R>::begins(&mut self.ledger);
    }

    fn fails(&mut self) {
        Observer::<R>::fails(&mut self.ledger);
    }
}
