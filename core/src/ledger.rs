//! The energy ledger: what the integrator itself has added or lost.

use crate::Real;
use crate::forces::energy::{damping_power, elastic, gravitational, kinetic, pin_power};
use crate::roles::Observer;
use crate::world::View;

/// Follows the energy of a world through its steps.
///
/// It sums what leaves through damping and impacts and what moving pins put in, by the trapezoidal rule over every
/// part of a step, in `f64` whatever the precision of the world. What is then missing from the energy is the
/// integrator's own error.
///
/// ```
/// use hooke::{Ledger, Particle, Reflect, SemiImplicitEuler, World};
///
/// let mut world = World::<f64, 1, 0, 0>::new();
/// world.set_gravity([0.0, 0.0, -10.0])?;
/// world.add_particle(Particle::at([0.0, 0.0, 5.0]).with_mass(2.0))?;
/// let mut view = world.view();
/// let mut ledger = Ledger::open(&view);
/// for _ in 0..1000 {
///     view.step_observed(&mut SemiImplicitEuler, &mut Reflect, 1e-3, &mut ledger)?;
/// }
/// let balance = ledger.balance(&view);
/// // ½ m v² of v = 10 m/s, and what a first-order method is off by: ½ m g² t dt.
/// assert!((balance.kinetic - 100.0).abs() < 1e-9);
/// assert!((balance.remainder() + 0.1).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Ledger {
    opened_with: f64,
    account: Account,
    /// As it was when the present step began.
    before: Account,
}

/// What has been summed up so far.
#[derive(Clone, Copy, Debug, Default)]
struct Account {
    lost_to_damping: f64,
    lost_in_impacts: f64,
    lost_to_sleep: f64,
    work_of_pins: f64,
    /// Powers at the state of the epoch beside them, W.
    damping_power: f64,
    pin_power: f64,
    epoch: Option<u64>,
}

/// Where the energy is, and where it went, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Balance {
    /// Σ ½ m v², J.
    pub kinetic: f64,
    /// Σ ½ k (l − l_rest)², J.
    pub elastic: f64,
    /// −Σ m g·x, J: 0 at the origin.
    pub gravitational: f64,
    /// ∫ Σ k_d l̇² dt, J.
    pub lost_to_damping: f64,
    /// Of all bounces, J; putting a particle back on a plane counts with them.
    pub lost_in_impacts: f64,
    /// Kinetic energy that islands still had when they fell asleep, J.
    pub lost_to_sleep: f64,
    /// What was needed to move kinematic particles against their springs, J.
    pub work_of_pins: f64,
    /// Kinetic, elastic and gravitational energy when the ledger was opened, J.
    pub opened_with: f64,
}

impl Balance {
    /// What the integrator has added (positive) or lost (negative), J: 0 for the exact solution.
    #[must_use]
    pub fn remainder(&self) -> f64 {
        self.kinetic
            + self.elastic
            + self.gravitational
            + self.lost_to_damping
            + self.lost_in_impacts
            + self.lost_to_sleep
            - self.work_of_pins
            - self.opened_with
    }

    /// The size of the energies that the remainder is what is left of, J; 0 or more.
    #[must_use]
    pub fn scale(&self) -> f64 {
        [self.elastic, self.gravitational, self.lost_to_damping, self.lost_in_impacts, self.work_of_pins]
            .iter()
            .fold(self.kinetic, |largest, energy| largest.max(energy.abs()))
            .max(self.opened_with.abs())
    }
}

impl Ledger {
    /// Opens it on the current state, with nothing lost yet.
    #[must_use]
    pub fn open<R: Real>(view: &View<'_, R>) -> Self {
        let opened_with = kinetic(&view.system, &view.current)
            + elastic(&view.system, &view.current)
            + gravitational(&view.system, &view.current);
        Self { opened_with, account: Account::default(), before: Account::default() }
    }

    /// The balance at the current state: of the view that was stepped with this ledger looking on.
    #[must_use]
    pub fn balance<R: Real>(&self, view: &View<'_, R>) -> Balance {
        Balance {
            kinetic: kinetic(&view.system, &view.current),
            elastic: elastic(&view.system, &view.current),
            gravitational: gravitational(&view.system, &view.current),
            lost_to_damping: self.account.lost_to_damping,
            lost_in_impacts: self.account.lost_in_impacts,
            lost_to_sleep: self.account.lost_to_sleep,
            work_of_pins: self.account.work_of_pins,
            opened_with: self.opened_with,
        }
    }
}

impl<R: Real> Observer<R> for Ledger {
    fn watches(&self) -> bool {
        true
    }

    fn advanced(&mut self, view: &mut View<'_, R>, dt: R) {
        let account = &mut self.account;
        if account.epoch != Some(*view.epoch) {
            // Impacts, or somebody outside, have changed the state since its powers were worked out.
            account.damping_power = damping_power(&view.system, &view.current);
            account.pin_power = pin_power(&view.system, &view.current);
        }
        let half = 0.5 * dt.to_f64();
        let (damping, pins) = (damping_power(&view.system, &view.next), pin_power(&view.system, &view.next));
        account.lost_to_damping += half * (account.damping_power + damping);
        account.work_of_pins += half * (account.pin_power + pins);
        (account.damping_power, account.pin_power) = (damping, pins);
        account.epoch = Some(*view.epoch + 1);
    }

    fn lost_in_impacts(&mut self, energy: f64) {
        self.account.lost_in_impacts += energy;
    }

    fn fell_asleep(&mut self, energy: f64) {
        self.account.lost_to_sleep += energy;
        // What sleeps takes no more power.
        self.account.epoch = None;
    }

    fn begins(&mut self) {
        self.before = self.account;
    }

    fn fails(&mut self) {
        self.account = self.before;
    }
}
