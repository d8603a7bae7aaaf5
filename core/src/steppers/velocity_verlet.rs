//! Velocity Verlet with the damping evaluated at a predicted velocity.

use super::verlet_stages::{Drift, Kick};
use crate::Real;
use crate::roles::Stepper;
use crate::shared::share;
use crate::types::{Full, StepReport};
use crate::vectors::{ColumnsMut, fetch, lend, read, store};
use crate::world::{Column, Plan, Storage, View};

/// x' = x + dt·v + ½dt²·a; a' = a(x', v + dt·a); v' = v + ½dt (a + a'). Second order, one force evaluation a step.
///
/// Where nothing is damped it is the velocity Verlet of Swope et al. (1982), symplectic and stable up to ω dt = 2.
/// Damping forces need the velocity that the step is only about to find; at the predicted velocity v + dt·a the
/// method stays of second order, at the old velocity v it would fall to the first.
///
/// a' is kept: it is the next step's a, unless something has changed the state in between. So a stepper belongs to one
/// world. With damping ratio ζ it is stable up to ω dt = 2(√(1+4ζ²) − 2ζ): what one evaluation instead of two costs.
pub struct VelocityVerlet<R: Real, M: Storage> {
    /// a of the current state and of the next one.
    acceleration: [[M::Particles<R>; 3]; 2],
    /// The epochs of the states that they belong to, the current one's first; 0 is none.
    epoch: [u64; 2],
    /// How many particles they are of: a response may leave some to others.
    particles: u32,
    /// Which of the two is the current state's.
    front: usize,
    /// That one is in the order of particles' numbers, until it is known to which slots they have been moved.
    by_number: bool,
}

impl<R: Real, M: Storage> VelocityVerlet<R, M> {
    /// Without room for any particles yet.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            acceleration: [const { [const { Column::EMPTY }; 3] }; 2],
            epoch: [0; 2],
            particles: 0,
            front: 0,
            by_number: false,
        }
    }
}

/// The two accelerations that a stepper remembers.
struct Sides<'a, R> {
    /// Of the current state.
    now: ColumnsMut<'a, R>,
    /// Of the next one.
    beside: ColumnsMut<'a, R>,
    epoch: &'a mut [u64; 2],
}

impl<R: Real, M: Storage> VelocityVerlet<R, M> {
    fn sides(&mut self) -> Sides<'_, R> {
        let [first, second] = self.acceleration.each_mut().map(|columns| columns.each_mut().map(Column::items_mut));
        let (now, beside) = if self.front == 0 { (first, second) } else { (second, first) };
        Sides { now, beside, epoch: &mut self.epoch }
    }

    /// The two change places when the state that the last step made has become the current one.
    fn turn(&mut self, view: &View<'_, R>) {
        let [epoch, next_epoch] = &mut self.epoch;
        if *next_epoch == *view.epoch {
            core::mem::swap(epoch, next_epoch);
            self.change_sides();
        }
    }

    /// The one beside takes the place of that of the current state.
    fn change_sides(&mut self) {
        self.front ^= 1;
    }
}

impl<R: Real, M: Storage> Default for VelocityVerlet<R, M> {
    fn default() -> Self {
        Self::new()
    }
}

impl<R: Real, M: Storage> Stepper<R> for VelocityVerlet<R, M> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        self.acceleration.iter_mut().flatten().try_for_each(|column| column.fit(plan.particles as usize))
    }

    fn advance(&mut self, view: &mut View<'_, R>, dt: R) -> StepReport {
        let mut report = StepReport::default();
        self.turn(view);
        if self.by_number {
            self.by_number = false;
            let Sides { now: by_number, beside: mut by_slot, .. } = self.sides();
            for (number, slot) in view.system.particle_at.iter().zip(0..view.system.plan.particles) {
                store(&mut by_slot, slot, fetch(read(&by_number), *number));
            }
            self.change_sides();
        }
        let particles = view.system.plan.particles;
        // There are fewer once some sleep.
        let is_whole = core::mem::replace(&mut self.particles, particles) >= particles;
        let Sides { now: mut acceleration, beside: next_acceleration, epoch: [epoch, next_epoch] } = self.sides();
        if !is_whole || *epoch != *view.epoch {
            let (x, v) = (view.current.carried_position(), read(&view.current.velocity));
            view.system.accelerations(x, v, lend(&mut acceleration), &mut report);
            *epoch = *view.epoch;
        }
        advance(view, dt, &acceleration, next_acceleration, &mut report);
        *next_epoch = *view.epoch + 1;
        report
    }

    fn order(&self) -> u32 {
        2
    }

    fn curvature(&self) -> R {
        R::from_f64(0.5)
    }

    fn rearranged(&mut self, view: &View<'_, R>) {
        self.turn(view);
        if self.by_number || self.epoch.first() != Some(&*view.epoch) {
            return;
        }
        let Sides { now: by_slot, beside: mut by_number, .. } = self.sides();
        for (number, slot) in view.system.particle_at.iter().zip(0..) {
            store(&mut by_number, *number, fetch(read(&by_slot), slot));
        }
        self.change_sides();
        self.by_number = true;
    }
}

fn advance<R: Real>(
    view: &mut View<'_, R>,
    dt: R,
    acceleration: &ColumnsMut<'_, R>,
    mut next_acceleration: ColumnsMut<'_, R>,
    report: &mut StepReport,
) {
    let View { system, current, next, .. } = view;
    let (x, v) = (current.carried_position(), current.carried_velocity());
    let a = read(acceleration);
    let (lanes, slots) = (system.lanes, 0..system.plan.particles);
    let [mut next_position, mut next_velocity] = next.lend().apart();
    let drift = Drift {
        lanes,
        dt,
        slots: slots.clone(),
        position: x,
        velocity: v.value,
        acceleration: a,
        next_position: next_position.lend(),
        predicted: lend(&mut next_velocity.value),
    };
    let drifted = share(drift, system.workers);
    let predicted = read(&next_velocity.value);
    system.accelerations(next_position.read(), predicted, lend(&mut next_acceleration), report);
    let kick = Kick {
        lanes,
        dt,
        slots,
        velocity: v,
        acceleration: a,
        next_acceleration: read(&next_acceleration),
        next_velocity,
    };
    view.is_next_finite = share(kick, system.workers) && drifted;
}
