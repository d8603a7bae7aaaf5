//! The world as its user holds it.

mod change;

use super::clock::Clock;
use super::dormancy::Dormancy;
use super::layout::{ParticleColumns, SpringColumns};
use super::order::{is_idle, order};
use super::pieces::{Found, Ordered};
use super::plan::Plan;
use super::prepare::{Layout, list_incidences, partition};
use super::rest::{Mark, Watch};
use super::storage::{Column, Fixed, Storage};
use super::view::{Springs, State, System, View, incidences_of, told};
use crate::Real;
use crate::lanes::{Lanes, Present};
use crate::types::{AddParticleError, AddPlaneError, AddSpringError, Hold, Particle, Plane, SetError, Sleep, Spring};
use crate::vectors::{ColumnsMut, at, difference, is_zero, put, size, store};

/// A world of fixed capacity: nothing is ever allocated.
///
/// It takes 14 reals and 13 bytes a particle, 3 reals and 34 bytes a spring, and 5 reals a plane.
pub type World<R, const PARTICLES: usize, const SPRINGS: usize, const PLANES: usize> =
    Container<R, Fixed<PARTICLES, SPRINGS, PLANES>>;

/// Particles, springs and planes, in whatever columns `M` provides.
///
/// A clone is a place to come back to. Steppers remember of one world what they made of it: what steps a clone is one of its
/// own, or one that is new.
#[derive(Clone)]
pub struct Container<R: Real, M: Storage> {
    particles: ParticleColumns<R, M>,
    springs: SpringColumns<R, M>,
    planes: M::Planes<Plane<R>>,
    gravity: [R; 3],
    clock: Clock,
    front: usize,
    epoch: u64,
    changes: u64,
    /// Of what was prepared.
    plan: Plan,
    /// Whether particles and springs still are where it says.
    is_laid_out: bool,
    /// Whether all of it holds.
    is_current: bool,
    lanes: Lanes,
    /// If islands may sleep.
    sleep: Option<Dormancy<R, M>>,
    watch: Watch,
}

impl<R: Real, M: Storage> Default for Container<R, M> {
    fn default() -> Self {
        Self::new()
    }
}

impl<R: Real, M: Storage> Container<R, M> {
    /// Without any particles, springs, planes or gravity, at 0 s.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            particles: ParticleColumns::EMPTY,
            springs: SpringColumns::EMPTY,
            planes: Column::EMPTY,
            gravity: [R::ZERO; 3],
            clock: Clock::START,
            front: 0,
            epoch: 0,
            changes: 0,
            plan: Plan::EMPTY,
            is_laid_out: false,
            is_current: false,
            lanes: Lanes::MOST,
            sleep: None,
            watch: Watch { since: 0.0, fell_asleep: false },
        }
    }

    /// Adds a particle and returns its number: 0 for the first, one more for each that follows.
    ///
    /// # Errors
    /// If there is no room for it, its mass or the inverse of that is not positive and finite, or its state is not finite.
    pub fn add_particle(&mut self, particle: Particle<R>) -> Result<u32, AddParticleError<R>> {
        // A mass next to 0 has an infinite inverse, and no force on it a finite answer.
        if !(particle.mass > R::ZERO && particle.mass.is_finite() && (R::ONE / particle.mass).is_finite()) {
            return Err(AddParticleError::Mass(particle.mass));
        }
        if !(carried::<R>(particle.position).is_some() && carried::<R>(particle.velocity).is_some()) {
            return Err(AddParticleError::NotFinite);
        }
        let number = self.particles.push(particle)?;
        self.disturb();
        self.is_laid_out = false;
        Ok(number)
    }

    /// Adds a spring and returns its number. Two particles may have any number of springs between them.
    ///
    /// # Errors
    /// If there is no room for it, an end does not exist, both ends are the same, or a parameter is negative or not
    /// finite.
    pub fn add_spring(&mut self, spring: Spring<R>) -> Result<u32, AddSpringError<R>> {
        let [first, second] = spring.between;
        for particle in spring.between {
            if particle >= self.particles.count() {
                return Err(AddSpringError::NoSuchParticle(particle));
            }
        }
        if first == second {
            return Err(AddSpringError::SameParticle(first));
        }
        if let Some(wrong) = spring.wrong() {
            return Err(wrong);
        }
        let slots = spring.between.map(|particle| at(self.particles.slot_of.items(), particle));
        let number = self.springs.push(spring, slots)?;
        slots.into_iter().for_each(|slot| self.wake(slot));
        self.disturb();
        self.is_laid_out = false;
        Ok(number)
    }

    /// Adds a plane and returns its number; collisions are answered in this order.
    ///
    /// # Errors
    /// If there is no room for it.
    pub fn add_plane(&mut self, plane: Plane<R>) -> Result<u32, AddPlaneError<R>> {
        let number = self.planes.items().len() as u32;
        self.planes.push(plane).map_err(AddPlaneError::Full)?;
        self.change_for_all();
        Ok(number)
    }

    /// Sets the gravitational acceleration, m/s².
    ///
    /// # Errors
    /// If it is not finite.
    pub fn set_gravity(&mut self, gravity: impl Into<R::Vec3>) -> Result<(), SetError> {
        let gravity = carried::<R>(gravity.into()).ok_or(SetError::NotFinite)?;
        self.gravity = values::<R>(gravity);
        self.change_for_all();
        Ok(())
    }

    /// Puts a particle somewhere else (m).
    ///
    /// # Errors
    /// If there is no such particle, or the position is not finite.
    pub fn set_position(&mut self, particle: u32, position: impl Into<R::Vec3>) -> Result<(), SetError> {
        self.set_state(particle, Some(position.into()), None)
    }

    /// Gives a particle another velocity (m/s). This is how a kinematic particle is moved; a pinned one becomes
    /// kinematic by it.
    ///
    /// # Errors
    /// If there is no such particle, or the velocity is not finite.
    pub fn set_velocity(&mut self, particle: u32, velocity: impl Into<R::Vec3>) -> Result<(), SetError> {
        self.set_state(particle, None, Some(velocity.into()))
    }

    /// Puts a kinematic particle where it should be (m) with the velocity it should have (m/s).
    ///
    /// Meant for every step: as long as the velocity stays the same, and the position is the one that it has led to but
    /// for its rounding, this counts as the same motion, and nothing that was worked out for it is worked out anew.
    ///
    /// # Errors
    /// If there is no such particle, or either is not finite.
    pub fn drive(
        &mut self,
        particle: u32,
        position: impl Into<R::Vec3>,
        velocity: impl Into<R::Vec3>,
    ) -> Result<(), SetError> {
        self.set_state(particle, Some(position.into()), Some(velocity.into()))
    }

    /// Pins a particle, lets it go, or makes it kinematic. A particle that is pinned loses its velocity.
    ///
    /// # Errors
    /// If there is no such particle.
    pub fn set_hold(&mut self, particle: u32, hold: Hold) -> Result<(), SetError> {
        let slot = self.slot(particle)?;
        let mass = at(self.particles.mass.items(), slot);
        let inverse = if hold == Hold::Free { R::ONE / mass } else { R::ZERO };
        let before = at(self.particles.inverse_mass.items(), slot);
        put(self.particles.inverse_mass.items_mut(), slot, inverse);
        if (before == R::ZERO) != (inverse == R::ZERO) && self.hangs_on_held(slot) {
            // The springs between them take part in steps, or do not any more.
            self.is_laid_out = false;
        }
        if hold == Hold::Pinned {
            let mut state = self.current_mut();
            set::<R>(&mut state.velocity, &mut state.velocity_residual, slot, [(R::ZERO, R::NO_RESIDUAL); 3]);
        }
        self.change_of(slot);
        self.is_current = false;
        Ok(())
    }

    /// Lets islands, the connected parts of the spring graph, sleep while they rest; or none of them, as it is at first.
    ///
    /// Held particles do not connect islands. What sleeps has no velocity and stays exactly where it is, with whatever
    /// stepper and response, and costs nothing. An island wakes when anything from outside touches one of its
    /// particles, one that holds it, gravity or the planes. Nothing else can reach it: particles do not meet each other,
    /// and a held particle that moves lets nothing that hangs on it fall asleep. Particles in free flight never sleep.
    ///
    /// Islands fall asleep at the end of a step, and are left out from the next view of the world on. Where several of
    /// them hang on one held particle, it counts as part of none: its pull is added before those of other particles.
    ///
    /// # Errors
    /// If the speed or the time is not positive and finite.
    pub fn set_sleep(&mut self, sleep: Option<Sleep<R>>) -> Result<(), SetError> {
        if sleep.is_some_and(|sleep| !sleep.is_sound()) {
            return Err(SetError::NotPositive);
        }
        self.sleep = sleep.map(Dormancy::new);
        self.wake_all();
        self.disturb();
        self.is_laid_out = false;
        Ok(())
    }

    /// Steps with no wider vector instructions than these, to compare: the bits are the same with all of them.
    pub fn set_lanes(&mut self, most: Lanes) {
        self.lanes = most;
    }

    /// Where a particle is, m; nothing if there is no such particle.
    #[must_use]
    pub fn position(&self, particle: u32) -> Option<R::Vec3> {
        let slot = self.slot(particle).ok()?;
        Some(told(self.current().position(), slot))
    }

    /// How fast a particle moves, m/s; nothing if there is no such particle.
    #[must_use]
    pub fn velocity(&self, particle: u32) -> Option<R::Vec3> {
        let slot = self.slot(particle).ok()?;
        Some(told(self.current().velocity(), slot))
    }

    /// The time of the state, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.clock.seconds()
    }

    /// The world as slices, prepared for stepping.
    pub fn view(&mut self) -> View<'_, R> {
        let is_known = self.is_laid_out && self.is_current;
        if !is_known {
            self.disturb();
        }
        if !is_known || self.watch.fell_asleep {
            self.prepare();
        }
        let plan = self.plan;
        let Self { particles, springs, planes, gravity, clock, front, epoch, changes, lanes, sleep, watch, .. } = self;
        let ParticleColumns { state: [a, b], mass, inverse_mass, slot_of, particle_at, incidence_end, rest } =
            particles;
        let (current, next) = if *front == 0 { (a, b) } else { (b, a) };
        let (current, next) = (current.lend(), next.lend());
        let system = System {
            mass: mass.items(),
            inverse_mass: inverse_mass.items(),
            particle_at: particle_at.items(),
            springs: Springs {
                ends: springs.ends.items(),
                stiffness: springs.stiffness.items(),
                damping: springs.damping.items(),
                rest_length: springs.rest_length.items(),
                number: springs.number.items(),
                pieces: springs.pieces.items().as_chunks().0.get(..plan.pieces as usize).unwrap_or_default(),
                presences: springs.presences.items().as_flattened(),
                incidence_end: incidence_end.items(),
                incidences: springs.incidences.items().as_flattened(),
            },
            planes: planes.items(),
            gravity: *gravity,
            plan,
            lanes: Present::up_to(*lanes),
            workers: None,
            support: None,
        };
        let slot_of = slot_of.items();
        let end = *clock;
        View {
            system,
            current,
            next,
            is_next_finite: false,
            front,
            epoch,
            changes: *changes,
            clock,
            end,
            slot_of,
            sleep: sleep.map(|dormancy| dormancy.sleeping),
            rest: rest.items_mut(),
            watch,
        }
    }

    /// Sorts particles into slots, lists their springs, and writes what the plan says of that.
    fn lay_out(&mut self) {
        let layout = partition(&mut self.particles, &mut self.springs, self.front, self.sleep);
        order(&mut self.springs, self.particles.inverse_mass.items(), layout.first_asleep());
        list_incidences(&mut self.particles, &mut self.springs);
        let Layout { particles, attached, asleep, islands, islands_asleep, renumbered, .. } = layout;
        self.plan = Plan {
            attached,
            particles,
            renumbered: renumbered.particles,
            reach: renumbered.reach,
            reach_by_number: renumbered.reach_before,
            islands,
            islands_asleep,
            asleep,
            ..self.plan
        };
    }

    /// Puts everything where it belongs, and finds out what the world needs.
    #[cfg_attr(feature = "compact", inline(never))]
    fn prepare(&mut self) {
        // Where islands may sleep, the layout also follows from what is held and what is calm.
        if !self.is_laid_out || self.sleep.is_some() {
            self.lay_out();
        }
        let Plan { particles, attached, asleep, .. } = self.plan;
        let first_asleep = particles - asleep;
        let springs = self.springs.ends.items().iter().take_while(|[_, j]| *j < first_asleep).count();
        let awake = self.springs.ends.items().get(..springs).unwrap_or_default();
        let inverse_mass = self.particles.inverse_mass.items();
        let live = awake.iter().take_while(|ends| !is_idle(**ends, inverse_mass)).count();
        let span = awake.iter().take(live).map(|[i, j]| j - i).max().unwrap_or(0);
        let (on_diagonals, pieces) = self.find_pieces(attached - asleep, live);
        self.plan = Plan {
            gravity: !is_zero(self.gravity),
            held: self.particles.inverse_mass.items().iter().filter(|inverse| **inverse == R::ZERO).count() as u32,
            of_one_mass: Plan::of_one_mass(self.particles.inverse_mass.items()),
            springs: self.springs.count(),
            on_diagonals,
            idle: (springs - live) as u32,
            span,
            pieces,
            damped: Plan::coverage(self.springs.damping.items()),
            planes: self.planes.items().len() as u32,
            springs_asleep: self.springs.count() - springs as u32,
            ..self.plan
        };
        self.watch.fell_asleep = false;
        self.is_laid_out = true;
        self.is_current = true;
    }

    /// Finds those of the first so many springs that lie on diagonals: how many there are, in how many pieces.
    fn find_pieces(&mut self, attached: u32, count: usize) -> (u32, u32) {
        if cfg!(feature = "small") {
            // Every spring is gone through by itself.
            return (0, 0);
        }
        let SpringColumns { ends, stiffness, damping, rest_length, pieces, presences, .. } = &mut self.springs;
        let ordered = Ordered {
            ends: ends.items().get(..count).unwrap_or_default(),
            stiffness: stiffness.items(),
            damping: damping.items(),
            rest_length: rest_length.items(),
            attached,
        };
        let words = pieces.items_mut();
        let presences = presences.items_mut().as_flattened_mut();
        let mut found = Found { words, presences, pieces: 0, places: 0, springs: 0 };
        ordered.find_pieces(&mut found);
        (found.springs, found.pieces)
    }

    fn slot(&self, particle: u32) -> Result<u32, SetError> {
        self.particles.slot_of.items().get(particle as usize).copied().ok_or(SetError::NoSuchParticle(particle))
    }

    fn current_mut(&mut self) -> State<'_, R> {
        let [a, b] = &mut self.particles.state;
        if self.front == 0 { a.lend() } else { b.lend() }
    }

    /// Gives a particle the position and the velocity that are told. Where both are, it may be the motion that it is in.
    fn set_state(
        &mut self,
        particle: u32,
        position: Option<R::Vec3>,
        velocity: Option<R::Vec3>,
    ) -> Result<(), SetError> {
        let slot = self.slot(particle)?;
        let mut state = self.current_mut();
        let former = [state.carried_position().fetch(slot), state.carried_velocity().fetch(slot)];
        let [mut new_position, mut new_velocity] = former;
        if !(carry_if_told::<R>(position, &mut new_position) && carry_if_told::<R>(velocity, &mut new_velocity)) {
            return Err(SetError::NotFinite);
        }
        set::<R>(&mut state.position, &mut state.position_residual, slot, new_position);
        set::<R>(&mut state.velocity, &mut state.velocity_residual, slot, new_velocity);
        let [former_position, former_velocity] = former;
        let is_same = position.is_some()
            && velocity.is_some()
            && values::<R>(new_velocity) == values::<R>(former_velocity)
            && !displaced(values::<R>(former_position), values::<R>(new_position));
        if !is_same {
            self.change_of(slot);
        }
        Ok(())
    }

    /// Something has changed that all particles feel.
    fn change_for_all(&mut self) {
        self.wake_all();
        self.disturb();
        self.is_current = false;
    }

    /// A particle has changed.
    fn change_of(&mut self, slot: u32) {
        self.wake(slot);
        self.disturb();
    }

    /// Touches a particle: the island that it belongs to, and those that hang on it, wake.
    fn wake(&mut self, slot: u32) {
        if let Some(Dormancy { touch, .. }) = self.sleep
            && touch(&mut self.particles, &self.springs, slot)
        {
            self.is_laid_out = false;
        }
    }

    /// Whether a spring leads from a particle to a held one.
    fn hangs_on_held(&self, slot: u32) -> bool {
        let ParticleColumns { inverse_mass, incidence_end, .. } = &self.particles;
        let springs = self.springs.incidences.items().as_flattened();
        let mut of_slot = incidences_of(slot, incidence_end.items(), springs).iter();
        of_slot.any(|spring| at(inverse_mass.items(), spring.neighbour) == R::ZERO)
    }

    /// Touches all particles.
    fn wake_all(&mut self) {
        let mark = if self.sleep.is_some() { Mark::default().stirred() } else { Mark::default() };
        self.particles.rest.items_mut().fill(mark.to_byte());
    }

    /// Tells those who remember something of the state that it has changed.
    fn disturb(&mut self) {
        self.epoch += 1;
        self.changes += 1;
    }
}

/// Whether two positions differ by more than the few roundings of a step.
fn displaced<R: Real>(before: [R; 3], after: [R; 3]) -> bool {
    let reach = size(before) + size(after);
    size(difference(before, after)) > R::from_f64(64.0) * R::EPSILON * reach
}

/// A vector as it is carried: numbers with their residuals.
type CarriedVector<R> = [(R, <R as Real>::Residual); 3];

/// A vector as it is carried; nothing if it is not finite so.
fn carried<R: Real>(vector: R::Vec3) -> Option<CarriedVector<R>> {
    let mut carried = const { [(R::ZERO, R::NO_RESIDUAL); 3] };
    carry_if_told::<R>(Some(vector), &mut carried).then_some(carried)
}

/// Carries a vector if there is one, and tells whether it is finite then.
fn carry_if_told<R: Real>(vector: Option<R::Vec3>, to: &mut CarriedVector<R>) -> bool {
    if let Some(vector) = vector {
        let [x, y, z] = vector.into();
        *to = [R::carry(x), R::carry(y), R::carry(z)];
    }
    values::<R>(*to).iter().all(|value| value.is_finite())
}

/// Without its residuals.
fn values<R: Real>([(x, _), (y, _), (z, _)]: CarriedVector<R>) -> [R; 3] {
    [x, y, z]
}

/// Sets the vector of a slot.
fn set<R: Real>(
    value: &mut ColumnsMut<'_, R>,
    residual: &mut ColumnsMut<'_, R::Residual>,
    slot: u32,
    [(x, u), (y, v), (z, w)]: CarriedVector<R>,
) {
    store(value, slot, [x, y, z]);
    store(residual, slot, [u, v, w]);
}
