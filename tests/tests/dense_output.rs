//! DOP853 between the ends of its steps: as exact as at them, through damping and bounces, and at nobody else's cost.
#![allow(clippy::unwrap_used, clippy::expect_used, missing_docs)]

use hooke::{
    AdaptiveDop853, Compensated, DenseOutput, Dop853, Observer, Real, Reflect, Response, Stepper, TimeOfImpact, View,
};
use hooke_runner::model::{Hold, Model, ModelParticle};
use hooke_runner::simulate::{Heap, world};
use hooke_tests::moment::Moment;
use hooke_tests::problems::oscillator::Oscillator;
use hooke_tests::problems::{Problem, bouncing, smooth};
use hooke_tests::{digest, measure};

type Fixed<R = f64> = DenseOutput<Dop853<R, Heap>, R, Heap>;
type Adaptive = DenseOutput<AdaptiveDop853<f64, Heap>, f64, Heap>;

fn moment<R: Real>(view: &View<'_, R>) -> Moment {
    view.states().fold(Moment::default(), |moment, (x, v)| {
        let [x, v]: [[R::Coordinate; 3]; 2] = [x.into(), v.into()];
        moment.with(x.map(Real::to_f64), v.map(Real::to_f64))
    })
}

/// The state some way into a step: its time, s, and what there is.
type Seen = (f64, Moment);

/// Looks at the same parts of every step, or part of a step.
#[derive(Default)]
struct Look {
    parts: Vec<f64>,
    seen: Vec<Vec<Seen>>,
    /// Steps that cannot be looked into.
    blind: usize,
}

impl<R: Real> Observer<R> for Look {
    fn watches(&self) -> bool {
        true
    }

    fn advanced(&mut self, _view: &mut View<'_, R>, _dt: R) {}

    fn advanced_by(&mut self, view: &mut View<'_, R>, dt: R, stepper: &mut (impl Stepper<R> + ?Sized)) {
        let start = view.time();
        let mut seen = Vec::new();
        for part in &self.parts {
            let after = *part * dt.to_f64();
            match stepper.between(view, dt, R::from_f64(after)) {
                Some(between) => seen.push((start + after, moment(&between))),
                None => self.blind += 1,
            }
        }
        self.seen.push(seen);
    }

    fn lost_in_impacts(&mut self, _energy: f64) {}
}

/// What is seen in so many steps of a problem, or one that is taken in parts.
fn look<R: Real>(
    problem: &Problem,
    stepper: &mut (impl Stepper<R> + ?Sized),
    response: &mut impl Response<R>,
    parts: &[f64],
    count: usize,
) -> Look {
    let mut world = world::<R>(&problem.model, problem.gravity).unwrap();
    let mut look = Look { parts: parts.to_vec(), ..Look::default() };
    for _ in 0..count {
        let dt = R::from_f64(0.5 * problem.duration / count as f64);
        world.view().step_observed(stepper, response, dt, &mut look).unwrap();
    }
    look
}

/// The largest errors in position, m, and velocity, m/s.
fn errors<'a>(problem: &Problem, seen: impl Iterator<Item = &'a Seen>) -> [f64; 2] {
    seen.fold([0.0_f64; 2], |[x, v], (time, moment)| {
        let exact = (problem.exact)(*time);
        [x.max(measure::position_error(moment, &exact)), v.max(measure::velocity_error(moment, &exact))]
    })
}

fn swinging() -> impl Iterator<Item = Problem> {
    // Those at rest have nothing but roundings.
    let rests = |problem: &Problem| ["hanging", "slung"].iter().any(|kind| problem.name.starts_with(kind));
    let moves = move |problem: &Problem| !problem.model.springs.is_empty() && !rests(problem);
    smooth().into_iter().filter(moves)
}

/// The order at which errors fall from one number of steps to the next.
fn orders(counts: [usize; 2], errors: [[f64; 2]; 2]) -> [f64; 2] {
    let [coarse, fine] = errors;
    [0, 1].map(|kind: usize| (coarse[kind] / fine[kind]).ln() / (counts[1] as f64 / counts[0] as f64).ln())
}

/// A curve of seventh order is off by the eighth power of the step, as the steps themselves are in the end: both in position
/// and in velocity, with damping and without. The cubic through both ends, where it is flattest, is off by the fourth.
#[test]
fn between_steps_errors_fall_as_at_their_ends() {
    let counts = [24, 32];
    for problem in swinging() {
        let [coarse, fine] = counts.map(|count| {
            look::<f64>(&problem, &mut Fixed::of(Dop853::new()), &mut Reflect, &[0.0, 0.2, 0.5, 0.85, 1.0], count).seen
        });
        let curve = [&coarse, &fine].map(|seen| errors(&problem, seen.iter().flat_map(|step| &step[1..4])));
        // The stiffest, damped beyond the critical, has not come down to its order at these steps.
        let margin = if problem.name.contains("ratio 2.5") { 0.8 } else { 0.3 };
        for order in orders(counts, curve) {
            assert!((order - 8.0).abs() < margin, "{}: {order}, {curve:?}", problem.name);
        }
        let cubic = [&coarse, &fine].map(|seen| {
            let middles: Vec<Seen> = seen.iter().map(|step| hermite(&step[0], &step[4])).collect();
            errors(&problem, middles.iter())
        });
        let [order, _] = orders(counts, cubic);
        assert!(
            (order - 4.0).abs() < margin && cubic[1][0] > 100.0 * curve[1][0],
            "{}: {order}, {cubic:?}",
            problem.name
        );
    }
}

/// Half-way along the cubic through two states.
fn hermite((from, left): &Seen, (to, right): &Seen) -> Seen {
    let dt = to - from;
    let mut middle = Moment::default();
    for number in 0..left.position.len() {
        let of = |moment: &Moment| (moment.position[number], moment.velocity[number]);
        let ((x, u), (y, v)) = (of(left), of(right));
        let place = [0, 1, 2].map(|axis| 0.5 * (x[axis] + y[axis]) + 0.125 * dt * (u[axis] - v[axis]));
        let speed = [0, 1, 2].map(|axis| 1.5 * (y[axis] - x[axis]) / dt - 0.25 * (u[axis] + v[axis]));
        middle = middle.with(place, speed);
    }
    (0.5 * (from + to), middle)
}

/// At its ends the curve is the states themselves, but for the roundings of its sums.
#[test]
fn the_curve_meets_both_ends() {
    for problem in swinging() {
        let seen = look::<f64>(&problem, &mut Fixed::of(Dop853::new()), &mut Reflect, &[0.0, 1.0], 12).seen;
        for pair in seen.windows(2) {
            let ((_, end), (_, start)) = (&pair[0][1], &pair[1][0]);
            assert!(measure::position_error(end, start) < 1e-14, "{}", problem.name);
            assert!(measure::velocity_error(end, start) < 1e-12, "{}", problem.name);
        }
    }
}

/// One step of the whole duration, in as many parts as the tolerance makes of it: what is between keeps it too.
#[test]
fn within_steps_that_are_chosen_the_tolerance_holds() {
    for tolerance in [1e-5, 1e-8] {
        for problem in swinging() {
            let mut stepper = Adaptive::of(AdaptiveDop853::new(tolerance));
            let look = look(&problem, &mut stepper, &mut Reflect, &[0.1, 0.3, 0.5, 0.7, 0.9], 1);
            let [error, _] = errors(&problem, look.seen.iter().flatten());
            assert!(error < 100.0 * tolerance, "{}, {tolerance:e}: {error:e}", problem.name);
        }
    }
}

/// A hit cuts a part, and the curve is of what is left of it.
#[test]
fn up_to_a_bounce_and_from_it_the_curve_is_the_motion() {
    for problem in bouncing().into_iter().filter(|problem| !problem.model.springs.is_empty()) {
        // Endless bounces end with the first part that they would end within.
        if problem.rest.is_some() || problem.name.ends_with("restitution 0") {
            continue;
        }
        let mut stepper = Adaptive::of(AdaptiveDop853::new(1e-9));
        let mut response = TimeOfImpact::<f64, Heap>::new();
        let look = look(&problem, &mut stepper, &mut response, &[0.1, 0.5, 0.9], 3);
        let [error, _] = errors(&problem, look.seen.iter().flatten());
        assert!(look.blind == 0 && look.seen.len() > 3 && error < 1e-6, "{}: {error:e}", problem.name);
    }
}

/// Steps are the same to the bit, whether anybody looks or not, and they count the same work.
#[test]
fn looking_changes_nothing() {
    let problem = swinging().next().unwrap();
    let (mut plain, mut looked) = (Dop853::<f64, Heap>::new(), Fixed::of(Dop853::new()));
    let [mut alone, mut seen] = [0, 1].map(|_| world::<f64>(&problem.model, problem.gravity).unwrap());
    for _ in 0..10 {
        let dt = 0.02 * problem.duration;
        let mut look = Look { parts: vec![0.25], ..Look::default() };
        let first = alone.step(&mut plain, &mut Reflect, dt).unwrap();
        let second = seen.view().step_observed(&mut looked, &mut Reflect, dt, &mut look).unwrap();
        assert_eq!((first, digest::of(&alone.view())), (second, digest::of(&seen.view())));
        assert_eq!(look.seen.concat().len(), 1);
    }
}

/// Numbers that carry their rounding do so between steps too: errors are those at the ends of steps, far less than without.
/// Springs and masses are the same in `f32`.
#[test]
fn carried_roundings_are_told() {
    fn errors_at<R: Real>(part: f64) -> f64 {
        let oscillator =
            Oscillator { mass: 1.0, stiffness: 64.0, rest_length: 0.75, damping_ratio: 0.125, ..Oscillator::default() };
        let problem = oscillator.problem();
        let look = look(&problem, &mut Fixed::<R>::of(Dop853::new()), &mut Reflect, &[part], 200);
        errors(&problem, look.seen.iter().flatten())[0]
    }
    let (end, between) = (errors_at::<Compensated>(0.0), errors_at::<Compensated>(0.4));
    assert!((between / end - 1.0).abs() < 0.05, "{between:e}, {end:e}");
    let single = errors_at::<f32>(0.4);
    assert!(single > 5.0 * between, "{single:e}, {between:e}");
}

/// What no spring pulls at flies on a path of its own, from plane to plane: a world that has any is not told.
#[test]
fn what_flies_alone_is_not_told() {
    let mut problem = swinging().next().unwrap();
    let ball = ModelParticle { position: [9.0; 3], velocity: [0.0; 3], mass: 1.0, hold: Hold::Free };
    problem.model = Model { particles: [&problem.model.particles[..], &[ball]].concat(), ..problem.model };
    let stepper = || Fixed::of(Dop853::new());
    let alone = look(&problem, &mut stepper(), &mut TimeOfImpact::<f64, Heap>::new(), &[0.5], 4);
    assert_eq!((alone.blind, alone.seen.concat().len()), (4, 0));
    // The other responses step it with the rest.
    let together = look(&problem, &mut stepper(), &mut Reflect, &[0.5], 4);
    assert_eq!((together.blind, together.seen.concat().len()), (0, 4));
    // Nobody else has a curve.
    let other = look(&problem, &mut Dop853::<f64, Heap>::new(), &mut Reflect, &[0.5], 4);
    assert_eq!(other.blind, 4);
}
