//! The response that finds hits inside the step.

use super::Answer;
use super::bounce::{Flight, first_contact, half_square};
use super::fly_along::fly_along;
use super::locate::locate;
use super::stop::stop_all;
use core::ops::Range;

use crate::Real;
use crate::contact::{hold_up, lies_on, resting, support, touching};
use crate::forces::pull;
use crate::reach::Reach;
use crate::roles::{Observer, Response, Stepper};
use crate::rounding::rounding;
use crate::types::{Full, Plane, StepError, StepReport};
use crate::vectors::{along, at, dot, fetch, read, size};
use crate::world::{Clock, Plan, State, StateColumns, Storage, System, View, tiles};

/// Parts that hits may cut one step into. What hits after that is stopped where it is, and reported.
const MOST_SUBSTEPS: u32 = 64;

/// Times that the planes are gone through at one hit: a particle in a wedge is thrown from one to the other.
const MOST_ROUNDS: u32 = 16;

/// The order of the steppers whose path between two states a parabola is good enough for.
const PARABOLA: u32 = 2;

/// The hit is located inside the step, answered there, and the rest of the step is taken from there.
///
/// A particle without springs is flown along the stepper's own path from plane to plane. Where springs pull, the
/// first hit of any particle cuts the step in two, so that the stepper starts anew after it and keeps its order: the
/// path between the two states is taken as the parabola through them with the first one's velocity, which is the
/// explicit Eulers' and Verlet's own path and differs from the implicit ones' by dt³. On the path of a stepper of higher
/// order the hit is found by Newton's method, with steps of its own.
///
/// A particle at rest on planes is held up while it is pressed against them and let go when something pulls it off.
pub struct TimeOfImpact<R: Real, M: Storage> {
    /// The state at the start of a step that is cut, for the case that it fails: 6 reals a particle.
    start: StateColumns<R, M>,
}

impl<R: Real, M: Storage> TimeOfImpact<R, M> {
    /// Without room for any particles yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { start: StateColumns::EMPTY }
    }
}

impl<R: Real, M: Storage> Default for TimeOfImpact<R, M> {
    fn default() -> Self {
        Self::new()
    }
}

impl<R: Real, M: Storage> Response<R> for TimeOfImpact<R, M> {
    fn fit(&mut self, plan: &Plan) -> Result<(), Full> {
        // Only springs and planes together make a step that can fail half-way.
        let saved = if plan.planes > 0 && plan.springs > 0 { plan.particles as usize } else { 0 };
        self.start.fit(saved)
    }

    fn step(
        &mut self,
        view: &mut View<'_, R>,
        stepper: &mut (impl Stepper<R> + ?Sized),
        dt: R,
        observer: &mut impl Observer<R>,
    ) -> Result<StepReport, StepError> {
        view.system.support = (view.system.plan.planes > 0).then_some(hold_up);
        let mut start = Start { state: self.start.lend(), clock: None };
        let mut stepped = step(view, stepper, dt, observer, &mut start);
        if let Err(StepError::NonFinite { .. }) = stepped {
            // The first by number may be one in free flight, which had not had its turn.
            fly_along(view, stepper.curvature(), dt, &mut StepReport::default());
            stepped = view.refuse_non_finite().and(stepped);
            start.restore(view);
        }
        view.system.support = None;
        stepped
    }
}

/// The state before the first cut.
struct Start<'a, R: Real> {
    state: State<'a, R>,
    /// Its time; nothing before the first cut.
    clock: Option<Clock>,
}

impl<R: Real> Start<'_, R> {
    fn save(&mut self, view: &View<'_, R>) {
        if self.clock.is_none() {
            self.state.copy_from(&view.current);
            self.clock = Some(*view.clock);
        }
    }

    fn restore(&self, view: &mut View<'_, R>) {
        if let Some(clock) = self.clock {
            view.current.copy_from(&self.state);
            *view.clock = clock;
            *view.epoch += 2;
        }
    }
}

/// A plane that a particle meets.
struct Hit<R> {
    /// After this time, s.
    tau: R,
    slot: u32,
    plane: Plane<R>,
}

fn step<R: Real>(
    view: &mut View<'_, R>,
    stepper: &mut (impl Stepper<R> + ?Sized),
    dt: R,
    observer: &mut impl Observer<R>,
    start: &mut Start<'_, R>,
) -> Result<StepReport, StepError> {
    let mut report = StepReport::default();
    let from = view.clock.seconds();
    let mut rest = dt;
    // The same in `f64`, as thousands of parts add up in no other.
    let mut left = dt.to_f64();
    // Bounces that would end within a step end in rest: within a part of it, where those are what is chosen.
    let mut span = if stepper.chooses_parts() { R::ZERO } else { dt };
    let mut cuts = 0;
    let mut stopped = None;
    if view.system.plan.attached > 0 {
        loop {
            let (part, hit) = advance_to_hit(view, stepper, rest, &mut report)?;
            span = span.at_least(part);
            cuts += u32::from(hit.is_some());
            report.substeps += u32::from(hit.is_some());
            let Some(mut hit) = hit.filter(|_| cuts < MOST_SUBSTEPS) else {
                // To the end of the part: nothing is met before it, or too much to be followed one by one.
                observer.advanced_by(view, part, stepper);
                if cuts == MOST_SUBSTEPS {
                    let answer = stop_all(view, observer.watches());
                    view.attached().refuse_non_finite()?;
                    report.capped += answer.hits;
                    stopped = Some(answer);
                }
                if part >= rest {
                    break;
                }
                start.save(view);
                let answer = stopped.take();
                observer.lost_in_impacts(answer.map_or(0.0, |answer| answer.lost));
                view.next.keep(view.system.plan.attached, &view.current);
                view.commit(view.clock.later(part.to_f64()), answer.is_some());
                left -= part.to_f64();
                (rest, cuts) = (R::from_f64(left), 0);
                continue;
            };
            start.save(view);
            // Where the path does not meet the plane after all, the step is cut all the same: the rest is known better.
            let mut meets = true;
            if hit.tau > R::ZERO {
                if stepper.order() > PARABOLA {
                    match locate(view, stepper, hit.slot, &hit.plane, hit.tau, part, &mut report) {
                        Some(tau) => hit.tau = tau,
                        None => meets = false,
                    }
                }
                report.add(&stepper.advance(&mut view.attached(), hit.tau));
                view.attached().refuse_non_finite()?;
                keep_lying(&mut view.attached(), hit.tau);
                observer.advanced_by(view, hit.tau, stepper);
                view.next.keep(view.system.plan.attached, &view.current);
            } else {
                view.next.copy_from(&view.current);
            }
            let answer = if meets { bounce(&mut view.attached(), &hit, span) } else { Answer::default() };
            observer.lost_in_impacts(answer.lost);
            report.hits += answer.hits;
            view.commit(view.clock.later(hit.tau.to_f64()), meets);
            rest -= hit.tau;
            left = rest.to_f64();
        }
    }
    let lost = match stepper.fly(view, from, &mut report) {
        Some(lost) => {
            view.next.forget_residuals_from(view.system.plan.attached);
            lost
        }
        None => fly_along(view, stepper.curvature(), dt, &mut report),
    };
    // What springs pull at has been looked at, and exact flight has seen to that itself.
    if !core::mem::take(&mut view.is_next_finite) {
        view.refuse_non_finite_from(view.system.plan.attached)?;
    }
    observer.lost_in_impacts(stopped.map_or(0.0, |answer| answer.lost) + lost);
    report.substeps += 1;
    view.commit(view.end, stopped.is_some());
    Ok(report)
}

/// Advances what springs pull at towards the end of the step, and tells by how much and the first hit on the way there.
fn advance_to_hit<R: Real>(
    view: &mut View<'_, R>,
    stepper: &mut (impl Stepper<R> + ?Sized),
    rest: R,
    report: &mut StepReport,
) -> Result<(R, Option<Hit<R>>), StepError> {
    let mut attached = view.attached();
    let part = stepper.advance_up_to(&mut attached, rest, report);
    attached.refuse_non_finite()?;
    keep_lying(&mut attached, part);
    Ok((part, first_hit(&attached, part)))
}

/// Keeps what lay on a plane before a step, and is not pulled off it, on that plane. The roundings of the step are taken
/// from it: where its sliding turns round, those of its fastest would else look like a motion of their own.
fn keep_lying<R: Real>(view: &mut View<'_, R>, dt: R) {
    let View { system, current, next, .. } = view;
    if system.planes.is_empty() {
        return;
    }
    for slots in tiles(0..system.plan.particles) {
        let reach = Reach::between(system.lanes, current, next, dt, slots.clone());
        for plane in system.planes.iter().filter(|plane| reach.may_meet(plane)) {
            keep_tile_lying(system, current, next, plane, slots.clone());
        }
    }
}

fn keep_tile_lying<R: Real>(
    system: &System<'_, R>,
    current: &State<'_, R>,
    next: &mut State<'_, R>,
    plane: &Plane<R>,
    slots: Range<u32>,
) {
    for slot in slots {
        let (position, velocity) = (fetch(read(&current.position), slot), fetch(read(&current.velocity), slot));
        if !lies_on(plane, position, velocity) || !system.is_dynamic(slot) {
            continue;
        }
        let mut after =
            Flight { position: fetch(read(&next.position), slot), velocity: fetch(read(&next.velocity), slot) };
        let pull = pull(system, read(&next.position), read(&next.velocity), slot);
        let a = along(system.gravity, at(system.inverse_mass, slot), pull);
        // On its way off the plane, however slowly.
        let leaves = dot(plane.normal, support(system.planes, position, velocity, a).allow(a)) > rounding(size(a));
        if plane.gap(after.position) < -touching(plane, after.position) {
            // It began to be pressed against it within the step, while an implicit stepper held up only what was at the
            // start; or it began to be pulled off it, while a kick of a splitting went back in time.
            after.position = along(after.position, -plane.gap(after.position), plane.normal);
            after.velocity =
                along(after.velocity, (-dot(plane.normal, after.velocity)).at_least(R::ZERO), plane.normal);
        }
        if !leaves {
            after.keep_on(plane, velocity);
        }
        next.put_position(slot, after.position);
        next.put_velocity(slot, after.velocity);
    }
}

/// The first hit of any particle between the current state and the next one, `duration` seconds later.
fn first_hit<R: Real>(view: &View<'_, R>, duration: R) -> Option<Hit<R>> {
    let View { system, current, next, .. } = view;
    let mut first: Option<(Hit<R>, usize)> = None;
    if system.planes.is_empty() {
        return None;
    }
    for slots in tiles(0..system.plan.particles) {
        let reach = Reach::between(system.lanes, current, next, duration, slots.clone());
        for (number, plane) in system.planes.iter().enumerate().filter(|(_, plane)| reach.may_meet(plane)) {
            for slot in slots.clone() {
                let after = plane.gap(fetch(read(&next.position), slot));
                let velocity = fetch(read(&current.velocity), slot);
                let speed = dot(plane.normal, velocity);
                if after >= R::ZERO && speed >= R::ZERO || !system.is_dynamic(slot) {
                    continue;
                }
                let position = fetch(read(&current.position), slot);
                let Some(tau) = time_to(plane, position, velocity, after, duration) else { continue };
                // Of several at the same time the first is that of the first plane.
                let is_first = first
                    .as_ref()
                    .map_or(tau < duration, |(hit, plane)| tau < hit.tau || tau == hit.tau && number < *plane);
                if is_first {
                    first = Some((Hit { tau, slot, plane: *plane }, number));
                }
            }
        }
    }
    first.map(|(hit, _)| hit)
}

/// When a plane is met, given the gap `after` the time `duration`; nothing if the particle lies on it.
fn time_to<R: Real>(plane: &Plane<R>, position: [R; 3], velocity: [R; 3], after: R, duration: R) -> Option<R> {
    let gap = plane.gap(position);
    let speed = dot(plane.normal, velocity);
    if gap <= touching(plane, position) && speed < -resting(velocity) {
        return Some(R::ZERO);
    }
    if lies_on(plane, position, velocity) {
        return None;
    }
    let bend = (after - gap - speed * duration) / (duration * duration);
    first_contact(gap.at_least(R::ZERO), speed, bend)
}

/// Answers a hit that the next state is at, and every other that it is at too.
fn bounce<R: Real>(view: &mut View<'_, R>, hit: &Hit<R>, dt: R) -> Answer {
    let mut answer = Answer::default();
    let View { system, current, next, .. } = view;
    let mut respond = |next: &mut State<'_, R>, plane: &Plane<R>, slot: u32, located: bool| {
        let mut flight =
            Flight { position: fetch(read(&next.position), slot), velocity: fetch(read(&next.velocity), slot) };
        let speed = -dot(plane.normal, flight.velocity);
        let comes = speed > resting(flight.velocity);
        let near = plane.gap(flight.position) <= R::from_f64(4.0) * touching(plane, flight.position);
        if !(located || near && comes) || !system.is_dynamic(slot) {
            return false;
        }
        let pull = pull(system, read(&next.position), read(&next.velocity), slot);
        let pressed = -dot(plane.normal, along(system.gravity, at(system.inverse_mass, slot), pull));
        // On the path of an implicit stepper what has come to the plane may have turned round already, by the same force
        // that would press it against the plane again and again: then only the next bounce counts, not all to come.
        let (mut away, losing) =
            if comes { (plane.restitution * speed, R::ONE - plane.restitution) } else { (-speed, R::ONE) };
        if losing > R::ZERO && pressed > R::ZERO && R::from_f64(2.0) * away <= dt * pressed * losing {
            // All the bounces to come would end within a step: it comes to rest.
            away = R::ZERO;
        }
        let before = fetch(read(&current.position), slot);
        if hit.tau > R::ZERO && plane.gap(before) >= -touching(plane, before) {
            // It has come to the plane since, and by the parabola's error beyond it.
            flight.position = along(flight.position, -plane.gap(flight.position), plane.normal);
        }
        flight.put_on(plane, away);
        next.put_position(slot, flight.position);
        next.put_velocity(slot, flight.velocity);
        answer.hits += 1;
        answer.lost += at(system.mass, slot).to_f64() * (half_square(speed) - half_square(away));
        true
    };
    respond(next, &hit.plane, hit.slot, true);
    for _ in 0..MOST_ROUNDS {
        let mut answered = false;
        for plane in system.planes {
            for slots in tiles(0..system.plan.particles) {
                if Reach::at(system.lanes, read(&next.position), slots.clone()).may_meet(plane) {
                    for slot in slots {
                        answered |= respond(next, plane, slot, false);
                    }
                }
            }
        }
        if !answered {
            break;
        }
    }
    answer
}
