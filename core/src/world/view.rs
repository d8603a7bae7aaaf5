//! A world seen as slices: what kernels and steppers work on, whatever holds the columns.

use super::clock::Clock;
use super::layout::Incidence;
use super::pieces::Words;
use super::plan::Plan;
use super::rest::Watch;
use crate::Real;
use crate::carried::{Carried, CarriedMut};
use crate::contact::HoldUp;
use crate::lanes::Present;
use crate::sleep::Sleeping;
use crate::types::{Plane, StepError};
use crate::vectors::{ColumnsMut, at, copy_columns, fetch, items_of, lend, part, read, store, window};
use crate::workers::Workers;

/// Positions and velocities by slot.
pub struct State<'a, R: Real> {
    /// m
    pub position: ColumnsMut<'a, R>,
    /// m/s
    pub velocity: ColumnsMut<'a, R>,
    /// What positions have lost in rounding, if they keep it.
    pub position_residual: ColumnsMut<'a, R::Residual>,
    /// What velocities have lost.
    pub velocity_residual: ColumnsMut<'a, R::Residual>,
}

impl<R: Real> State<'_, R> {
    /// Copies both from another state.
    pub fn copy_from(&mut self, other: &State<'_, R>) {
        self.keep(0, other);
    }

    /// Where a particle is, m, without what positions have lost.
    #[cfg_attr(feature = "compact", inline(never))]
    #[cfg_attr(not(feature = "compact"), inline(always))]
    pub fn position_of(&self, slot: u32) -> [R; 3] {
        fetch(read(&self.position), slot)
    }

    /// How fast it moves, m/s, without what velocities have lost.
    #[cfg_attr(feature = "compact", inline(never))]
    #[cfg_attr(not(feature = "compact"), inline(always))]
    pub fn velocity_of(&self, slot: u32) -> [R; 3] {
        fetch(read(&self.velocity), slot)
    }

    /// Where it is, m, with what positions have lost.
    #[cfg_attr(feature = "compact", inline(never))]
    pub fn exact_position(&self, slot: u32) -> [f64; 3] {
        self.carried_position().exactly(slot)
    }

    /// How fast it moves, m/s, with what velocities have lost.
    #[cfg_attr(feature = "compact", inline(never))]
    pub fn exact_velocity(&self, slot: u32) -> [f64; 3] {
        self.carried_velocity().exactly(slot)
    }

    /// Gives it a velocity, whatever has been lost of it.
    #[cfg_attr(feature = "compact", inline(never))]
    #[cfg_attr(not(feature = "compact"), inline(always))]
    pub fn set_velocity(&mut self, slot: u32, velocity: [R; 3]) {
        store(&mut self.velocity, slot, velocity);
    }

    /// Nothing has been lost, of the slots from `first` on.
    pub fn forget_residuals_from(&mut self, first: u32) {
        if !R::IS_COMPENSATED {
            return;
        }
        let columns = self.position_residual.iter_mut().chain(&mut self.velocity_residual);
        for column in columns {
            column.get_mut(first as usize..).unwrap_or_default().fill(R::NO_RESIDUAL);
        }
    }

    /// Puts a particle somewhere else; where it is already, nothing is lost of it.
    pub fn put_position(&mut self, slot: u32, position: [R; 3]) {
        if R::IS_COMPENSATED && fetch(read(&self.position), slot) != position {
            store(&mut self.position_residual, slot, [R::NO_RESIDUAL; 3]);
        }
        store(&mut self.position, slot, position);
    }

    /// Gives a particle another velocity; where it has it already, nothing is lost of it.
    pub fn put_velocity(&mut self, slot: u32, velocity: [R; 3]) {
        if R::IS_COMPENSATED && fetch(read(&self.velocity), slot) != velocity {
            store(&mut self.velocity_residual, slot, [R::NO_RESIDUAL; 3]);
        }
        store(&mut self.velocity, slot, velocity);
    }

    /// Copies both from another state, for the slots from `first` on.
    pub fn keep(&mut self, first: u32, other: &State<'_, R>) {
        copy_columns(&mut self.position, &other.position, first);
        copy_columns(&mut self.velocity, &other.velocity, first);
        if R::IS_COMPENSATED {
            copy_columns(&mut self.position_residual, &other.position_residual, first);
            copy_columns(&mut self.velocity_residual, &other.velocity_residual, first);
        }
    }

    /// Goes on in a straight line from another state, by so many times the way from there to here.
    pub fn extrapolate(&mut self, from: &State<'_, R>, times: R) {
        let columns = self.position.iter_mut().chain(&mut self.velocity);
        for (column, from) in columns.zip(from.position.iter().chain(&from.velocity)) {
            for (value, from) in column.iter_mut().zip(from.iter()) {
                *value += times * (*value - *from);
            }
        }
    }

    /// Of the first so many slots.
    fn first(&mut self, count: u32) -> State<'_, R> {
        State {
            position: first_of(&mut self.position, count),
            velocity: first_of(&mut self.velocity, count),
            position_residual: first_of(&mut self.position_residual, count),
            velocity_residual: first_of(&mut self.velocity_residual, count),
        }
    }

    /// Lent on.
    pub fn lend(&mut self) -> State<'_, R> {
        State {
            position: lend(&mut self.position),
            velocity: lend(&mut self.velocity),
            position_residual: lend(&mut self.position_residual),
            velocity_residual: lend(&mut self.velocity_residual),
        }
    }

    /// Positions with their residuals.
    pub fn carried_position(&self) -> Carried<'_, R> {
        Carried { value: read(&self.position), residual: read(&self.position_residual) }
    }

    /// Velocities with their residuals.
    pub fn carried_velocity(&self) -> Carried<'_, R> {
        Carried { value: read(&self.velocity), residual: read(&self.velocity_residual) }
    }
}

impl<'a, R: Real> State<'a, R> {
    /// Positions and velocities apart, each with their residuals.
    pub fn apart(self) -> [CarriedMut<'a, R>; 2] {
        let Self { position, velocity, position_residual, velocity_residual } = self;
        [
            CarriedMut { value: position, residual: position_residual },
            CarriedMut { value: velocity, residual: velocity_residual },
        ]
    }

    /// Of both.
    pub fn of([position, velocity]: [CarriedMut<'a, R>; 2]) -> Self {
        Self {
            position: position.value,
            velocity: velocity.value,
            position_residual: position.residual,
            velocity_residual: velocity.residual,
        }
    }
}

/// The same of three columns.
#[cfg_attr(feature = "compact", inline(never))]
fn first_of<'a, R>([x, y, z]: &'a mut ColumnsMut<'_, R>, count: u32) -> ColumnsMut<'a, R> {
    [first(x, count), first(y, count), first(z, count)]
}

/// The first so many items, or all if there are fewer.
fn first<R>(column: &mut [R], count: u32) -> &mut [R] {
    let count = column.len().min(count as usize);
    column.split_at_mut_checked(count).map_or(&mut [], |(first, _)| first)
}

/// The vector of a slot, as it is told at the surface.
pub fn told<R: Real>(columns: Carried<'_, R>, slot: u32) -> R::Vec3 {
    columns.fetch(slot).map(|(value, residual)| value.told(residual)).into()
}

/// Positions and velocities as they are told at the surface, in the order of the particles' numbers.
pub fn states_of<'a, R: Real>(
    position: Carried<'a, R>,
    velocity: Carried<'a, R>,
    slot_of: &'a [u32],
) -> impl Iterator<Item = (R::Vec3, R::Vec3)> + use<'a, R> {
    slot_of.iter().map(move |slot| (told(position, *slot), told(velocity, *slot)))
}

/// Springs, and the springs of each slot.
#[derive(Clone, Copy)]
pub struct Springs<'a, R> {
    /// Slots.
    pub ends: &'a [[u32; 2]],
    /// N/m
    pub stiffness: &'a [R],
    /// N·s/m
    pub damping: &'a [R],
    /// m
    pub rest_length: &'a [R],
    /// Its number.
    pub number: &'a [u32],
    /// The pieces of diagonals, as they are kept.
    pub pieces: &'a [Words],
    /// Of the places of pieces with gaps.
    pub presences: &'a [u8],
    /// Where the incidences of each slot end.
    pub incidence_end: &'a [u32],
    /// Of all slots.
    pub incidences: &'a [Incidence],
}

/// What a spring pulls by.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Law<R> {
    /// N/m
    pub stiffness: R,
    /// N·s/m
    pub damping: R,
    /// m
    pub rest_length: R,
}

impl<'a, R: Real> Springs<'a, R> {
    /// Of one spring.
    #[inline(always)]
    pub fn law(&self, spring: u32) -> Law<R> {
        Law {
            stiffness: at(self.stiffness, spring),
            damping: at(self.damping, spring),
            rest_length: at(self.rest_length, spring),
        }
    }

    /// Of one spring, in `f64`.
    #[cfg_attr(feature = "compact", inline(never))]
    pub fn exact_law(&self, spring: u32) -> Law<f64> {
        let Law { stiffness, damping, rest_length } = self.law(spring);
        Law { stiffness: stiffness.to_f64(), damping: damping.to_f64(), rest_length: rest_length.to_f64() }
    }

    /// The slots from 0 to `attached`, each with its springs in the order in which their forces are added.
    pub fn by_slot(self, attached: u32) -> impl Iterator<Item = (u32, &'a [Incidence])> {
        let mut start = 0;
        (0..attached).zip(self.incidence_end).map(move |(slot, end)| {
            let incidences = self.incidences.get(start as usize..*end as usize).unwrap_or_default();
            start = *end;
            (slot, incidences)
        })
    }

    /// The springs of one slot.
    pub fn of_slot(self, slot: u32) -> &'a [Incidence] {
        incidences_of(slot, self.incidence_end, self.incidences)
    }

    /// The first so many.
    pub fn first(self, count: u32) -> Self {
        let [ends] = window([self.ends], 0..count);
        let [stiffness, damping, rest_length] = window([self.stiffness, self.damping, self.rest_length], 0..count);
        Self { ends, stiffness, damping, rest_length, ..self }
    }
}

/// Those of one slot.
pub fn incidences_of<'a>(slot: u32, incidence_end: &[u32], incidences: &'a [Incidence]) -> &'a [Incidence] {
    part(incidences, items_of(incidence_end, slot)).unwrap_or_default()
}

/// What stays as it is while a step is made.
#[derive(Clone, Copy)]
pub struct System<'a, R> {
    /// kg, by slot.
    pub mass: &'a [R],
    /// 1/kg, by slot; 0 where pinned or kinematic.
    pub inverse_mass: &'a [R],
    /// The particle in each slot.
    pub particle_at: &'a [u32],
    /// All springs, in the order in which their forces are added.
    pub springs: Springs<'a, R>,
    /// All planes.
    pub planes: &'a [Plane<R>],
    /// m/s²
    pub gravity: [R; 3],
    /// What of all that there is.
    pub plan: Plan,
    /// The most that kernels may make use of.
    pub lanes: Present,
    /// Who shares the work, if anybody does.
    pub workers: Option<&'a dyn Workers>,
    /// What holds particles at rest on planes up while they are pressed against them, if anything does.
    pub support: Option<HoldUp<R>>,
}

impl<R: Real> System<'_, R> {
    /// Whether a particle moves as the forces on it say.
    #[cfg_attr(feature = "compact", inline(never))]
    pub fn is_dynamic(&self, slot: u32) -> bool {
        at(self.inverse_mass, slot) > R::ZERO
    }
}

/// A prepared world as slices: it steps like the world that it was borrowed from.
pub struct View<'a, R: Real> {
    pub(crate) system: System<'a, R>,
    /// The state now.
    pub(crate) current: State<'a, R>,
    /// The state that a step is making.
    pub(crate) next: State<'a, R>,
    /// Whether the next state is known to be finite.
    pub(crate) is_next_finite: bool,
    /// Which of the owner's two states is the current one: 0 or 1.
    pub(crate) front: &'a mut usize,
    /// Grows whenever the current state changes, so that who remembers something of it can tell.
    pub(crate) epoch: &'a mut u64,
    /// How often the state has been changed from outside, by anything but a step.
    pub(crate) changes: u64,
    pub(crate) clock: &'a mut Clock,
    /// The time at the end of the step that is being taken.
    pub(crate) end: Clock,
    pub(crate) slot_of: &'a [u32],
    /// When what rests falls asleep, if it may.
    pub(crate) sleep: Option<Sleeping<R>>,
    /// The marks of all particles, by number.
    pub(crate) rest: &'a mut [u8],
    pub(crate) watch: &'a mut Watch,
}

impl<'a, R: Real> View<'a, R> {
    /// What the world needs.
    #[must_use]
    pub fn plan(&self) -> &Plan {
        &self.system.plan
    }

    /// The time of the current state, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.clock.seconds()
    }

    /// Shares the work of the steps that this view takes among threads. It pays from some 20,000 springs on; with the feature
    /// `compact` there is none to share.
    pub fn share_among(&mut self, workers: &'a dyn Workers) {
        self.system.workers = Some(workers);
    }

    /// Where a particle is, m; nothing if there is no such particle.
    #[must_use]
    pub fn position(&self, particle: u32) -> Option<R::Vec3> {
        let slot = *self.slot_of.get(particle as usize)?;
        Some(told(self.current.carried_position(), slot))
    }

    /// How fast a particle moves, m/s; nothing if there is no such particle.
    #[must_use]
    pub fn velocity(&self, particle: u32) -> Option<R::Vec3> {
        let slot = *self.slot_of.get(particle as usize)?;
        Some(told(self.current.carried_velocity(), slot))
    }

    /// Where all particles are (m) and how fast they move (m/s), in the order of their numbers.
    pub fn states(&self) -> impl Iterator<Item = (R::Vec3, R::Vec3)> {
        states_of(self.current.carried_position(), self.current.carried_velocity(), self.slot_of)
    }

    /// The same world without the particles in free flight, which nothing that springs pull at depends on.
    pub(crate) fn attached(&mut self) -> View<'_, R> {
        let attached = self.system.plan.attached;
        self.part(System { plan: Plan { particles: attached, ..self.system.plan }, ..self.system })
    }

    /// The same world without the islands that sleep, which nothing that is awake depends on.
    pub(crate) fn awake(&mut self) -> View<'_, R> {
        let plan = self.system.plan.awake();
        self.part(System { plan, springs: self.system.springs.first(plan.springs), ..self.system })
    }

    /// The same world as if another state were its current one.
    pub(crate) fn starting_from<'b>(&'b mut self, state: &'b mut State<'_, R>) -> View<'b, R> {
        self.with_state(state.lend())
    }

    /// The same, of a state that is lent already.
    pub(crate) fn with_state<'b>(&'b mut self, state: State<'b, R>) -> View<'b, R> {
        let system = self.system;
        View { current: state, ..self.part(system) }
    }

    /// The first of its particles, with these springs.
    fn part<'b>(&'b mut self, system: System<'b, R>) -> View<'b, R> {
        let count = system.plan.particles;
        View {
            system,
            current: self.current.first(count),
            next: self.next.first(count),
            is_next_finite: self.is_next_finite,
            front: self.front,
            epoch: self.epoch,
            changes: self.changes,
            clock: self.clock,
            end: self.end,
            slot_of: self.slot_of,
            sleep: self.sleep,
            rest: self.rest,
            watch: self.watch,
        }
    }

    /// The state that a step made becomes the current one, at the time `now`. `answered` tells whether collisions have
    /// changed it since the stepper made it.
    pub(crate) fn commit(&mut self, now: Clock, answered: bool) {
        core::mem::swap(&mut self.current, &mut self.next);
        *self.front ^= 1;
        *self.epoch += 1 + u64::from(answered);
        *self.clock = now;
    }

    /// Refuses a next state that is not finite, naming the first particle by number.
    pub(crate) fn refuse_non_finite(&self) -> Result<(), StepError> {
        if self.is_next_finite { Ok(()) } else { self.refuse_non_finite_from(0) }
    }

    /// The same, where the states of the slots before this one are known to be finite.
    pub(crate) fn refuse_non_finite_from(&self, first: u32) -> Result<(), StepError> {
        let finite = !cfg!(feature = "compact")
            && self.next.position.iter().chain(&self.next.velocity).all(|column| {
                let rest = column.get(first as usize..).unwrap_or_default();
                rest.iter().fold(true, |finite, value| finite & value.is_finite())
            });
        if finite {
            return Ok(());
        }
        let mut lowest = u32::MAX;
        for slot in first..self.system.plan.particles {
            let [position, velocity] = [self.next.position_of(slot), self.next.velocity_of(slot)];
            if !position.iter().chain(&velocity).all(|component| component.is_finite()) {
                lowest = lowest.min(at(self.system.particle_at, slot));
            }
        }
        // There is no particle of this number.
        if lowest == u32::MAX { Ok(()) } else { Err(StepError::NonFinite { particle: lowest }) }
    }
}
