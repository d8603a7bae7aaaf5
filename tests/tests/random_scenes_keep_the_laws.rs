//! Small random scenes, in every way there is to step them: what must hold whatever is in a scene.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::{Compensated, Container, Fixed, Hold, Ledger, Observer, Plane, Real, StepError, StepReport, Storage};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_runner::simulate::{AnyResponse, AnyStepper, Heap};
use hooke_tests::digest;
use hooke_tests::random::Random;
use hooke_tests::random_scenes::RandomScene;
use hooke_tests::steppers;

type Room = Fixed<{ RandomScene::MOST[0] }, { RandomScene::MOST[1] }, { RandomScene::MOST[2] }>;

/// A world with what steps it.
struct Run<R: Real, M: Storage> {
    world: Container<R, M>,
    stepper: AnyStepper<R>,
    response: AnyResponse<R>,
}

impl<R: Real, M: Storage> Run<R, M> {
    fn new(scene: &RandomScene, stepper: StepperName, form: CollisionForm) -> Self {
        Self { world: scene.world(), stepper: AnyStepper::named(stepper, 1e-9), response: AnyResponse::named(form) }
    }

    fn step(&mut self, dt: f64, observer: &mut impl Observer<R>) -> Result<StepReport, StepError> {
        self.world.view().step_observed(self.stepper.any(), &mut self.response, R::from_f64(dt), observer)
    }

    fn step_to(&mut self, end: f64) {
        let dt = R::from_f64(end - self.world.time());
        self.world.view().step_to(self.stepper.any(), &mut self.response, dt, end, &mut ()).unwrap();
    }

    fn digest(&mut self) -> u64 {
        digest::of(&self.world.view())
    }
}

/// Every way to step a scene.
fn ways() -> impl Iterator<Item = (StepperName, CollisionForm)> {
    let forms = |stepper: StepperName| CollisionForm::ALL.iter().map(move |form| (stepper, *form));
    steppers::all().flat_map(forms)
}

/// Of ordinary size, tiny, and huge and far from the origin.
fn scenes(seeds: std::ops::Range<u64>) -> impl Iterator<Item = (u64, RandomScene)> {
    seeds.map(|seed| {
        let [size, offset] = [[1.0, 0.0], [1.0, 3.0], [1e-6, 0.0], [1e6, 3.0]][seed as usize % 4];
        (seed, RandomScene::new(seed, size, offset))
    })
}

#[test]
fn the_same_bits_with_a_ledger_and_in_any_container_and_nothing_beyond_a_plane() {
    for (seed, scene) in scenes(0..300) {
        for (stepper, form) in ways() {
            follow::<f64>(seed, &scene, stepper, form);
            follow::<f32>(seed, &scene, stepper, form);
            follow::<Compensated>(seed, &scene, stepper, form);
        }
    }
}

fn follow<R: Real>(seed: u64, scene: &RandomScene, stepper: StepperName, form: CollisionForm) {
    let dt = scene.time_step();
    let mut watched = Run::<R, Heap>::new(scene, stepper, form);
    let mut plain = Run::<R, Heap>::new(scene, stepper, form);
    let mut small = Run::<R, Room>::new(scene, stepper, form);
    let mut ledger = Ledger::open(&watched.world.view());
    for step in 0..50 {
        let report = watched.step(dt, &mut ledger).unwrap();
        assert_eq!(plain.step(dt, &mut ()).unwrap(), report, "seed {seed}, {stepper}, {form}");
        assert_eq!(small.step(dt, &mut ()).unwrap(), report, "seed {seed}, {stepper}, {form}");
        assert!(report.substeps <= 65, "seed {seed}, {stepper}, {form}: {report:?}");
        if form == CollisionForm::TimeOfImpact {
            nothing_is_beyond(&mut watched, scene, stepper, dt, &format!("seed {seed}, {stepper}, step {step}"));
        }
    }
    let digest = watched.digest();
    assert_eq!([plain.digest(), small.digest()], [digest; 2], "seed {seed}, {stepper}, {form}");
    assert!(ledger.balance(&watched.world.view()).remainder().is_finite());
}

/// Explicit steppers draw the very parabolas on which hits are looked for: what is left beyond a plane is rounding,
/// 32 of them for a contact and as many for the step from it. An implicit stepper's path is another one, by the change
/// of the forces within a step: it may dip below the plane between two hits by less than a hundredth of what the largest
/// acceleration here, some 300 sizes/s², makes of a step.
fn nothing_is_beyond<R: Real, M: Storage>(
    run: &mut Run<R, M>,
    scene: &RandomScene,
    stepper: StepperName,
    dt: f64,
    what: &str,
) {
    let implicit = matches!(stepper, StepperName::ImplicitEuler | StepperName::ImplicitEulerLinearised);
    let dip = if implicit { scene.size * dt * dt } else { 0.0 };
    let view = run.world.view();
    for ((position, velocity), particle) in view.states().zip(&scene.particles) {
        let [x, v]: [[R::Coordinate; 3]; 2] = [position.into(), velocity.into()];
        let size = |vector: [R::Coordinate; 3]| vector.iter().map(|component| component.to_f64().abs()).sum::<f64>();
        assert!((size(x) + size(v)).is_finite(), "{what}");
        for &(point, normal, _) in scene.planes.iter().filter(|_| particle.3 == Hold::Free) {
            let plane =
                Plane::<R>::through(point.map(R::Coordinate::from_f64), normal.map(R::Coordinate::from_f64), R::ONE)
                    .unwrap();
            let normal: [R::Coordinate; 3] = plane.normal().into();
            let height: f64 = normal.iter().zip(x).map(|(n, x)| n.to_f64() * x.to_f64()).sum();
            let gap = height - plane.offset().to_f64();
            let numbers = size(x) + plane.offset().to_f64().abs() + dt * size(v);
            assert!(gap >= -dip - 128.0 * R::EPSILON.to_f64() * numbers, "{what}: {gap:e} m in {numbers} m");
        }
    }
}

#[test]
fn a_step_that_fails_leaves_the_bits() {
    let mut failed = 0;
    for (seed, scene) in scenes(200..240) {
        for (stepper, form) in ways() {
            let mut run = Run::<f64, Heap>::new(&scene, stepper, form);
            let mut ledger = Ledger::open(&run.world.view());
            let dt = scene.time_step();
            for _ in 0..10 {
                run.step(dt, &mut ledger).unwrap();
            }
            let before = (run.digest(), run.world.time(), ledger.balance(&run.world.view()));
            if run.step(1e306, &mut ledger).is_err() {
                failed += 1;
                let after = (run.digest(), run.world.time(), ledger.balance(&run.world.view()));
                assert_eq!(after, before, "seed {seed}, {stepper}, {form}");
                run.step(dt, &mut ledger).unwrap();
            }
        }
    }
    assert!(failed > 200, "only {failed} steps have failed");
}

/// The rate at which the remainder falls, over many scenes: the middle one, since single ones bounce another number of
/// times at another time step.
#[test]
fn the_remainder_falls_at_the_order_of_the_stepper() {
    for (stepper, least) in [
        (StepperName::ExplicitEuler, 0.8),
        (StepperName::SemiImplicitEuler, 0.8),
        (StepperName::ImplicitEuler, 0.8),
        (StepperName::ImplicitEulerLinearised, 0.8),
        (StepperName::VelocityVerlet, 1.6),
        (StepperName::Auto, 1.6),
    ] {
        let mut slopes: Vec<f64> = (300..400).filter_map(|seed| slope(seed, stepper)).collect();
        slopes.sort_by(f64::total_cmp);
        assert!(slopes.len() > 30, "{stepper}: {} scenes tell", slopes.len());
        let middle = slopes[slopes.len() / 2];
        assert!(middle > least, "{stepper}: {middle} of {}", slopes.len());
    }
}

/// log₂ of what is left of the remainder at a quarter of the time step, per halving; nothing where there was none.
fn slope(seed: u64, stepper: StepperName) -> Option<f64> {
    let scene = RandomScene::new(seed, 1.0, 0.0);
    let dt = 0.2 * scene.time_step();
    let remainder = |parts: u32| {
        let mut run = Run::<f64, Heap>::new(&scene, stepper, CollisionForm::TimeOfImpact);
        let mut ledger = Ledger::open(&run.world.view());
        for _ in 0..40 * parts {
            run.step(dt / f64::from(parts), &mut ledger).unwrap();
        }
        let balance = ledger.balance(&run.world.view());
        balance.remainder().abs() / balance.scale().max(1e-300)
    };
    let (coarse, fine) = (remainder(1), remainder(4));
    (coarse > 1e-9 && fine > 0.0).then(|| 0.5 * (coarse / fine).log2())
}

/// What steppers remember belongs to the state that they left: if others step the world in between, or if it is set to
/// what it is already, they go on as new ones would. (Where springs are damped Verlet knows the forces at the velocity
/// that it had predicted, and a new one those at the velocity that there is.)
#[test]
fn steppers_take_turns() {
    for (seed, mut scene) in scenes(700..760) {
        scene.springs.iter_mut().for_each(|(_, [_, damping, _])| *damping = 0.0);
        for (number, (stepper, form)) in ways().enumerate() {
            let dt = scene.time_step();
            let other = steppers::all().cycle().nth(number + seed as usize).unwrap();
            let mut run = Run::<f64, Heap>::new(&scene, stepper, form);
            let mut fresh = Run::<f64, Heap>::new(&scene, stepper, form);
            let mut waiting = AnyStepper::named(other, 1e-9);
            for step in 0..30 {
                if step % 3 == 0 {
                    std::mem::swap(&mut run.stepper, &mut waiting);
                }
                if step % 5 == 0 {
                    let velocity = run.world.velocity(0).unwrap();
                    run.world.set_velocity(0, velocity).unwrap();
                }
                fresh.stepper = AnyStepper::named(if step / 3 % 2 == 0 { other } else { stepper }, 1e-9);
                run.step(dt, &mut ()).unwrap();
                fresh.step(dt, &mut ()).unwrap();
                // Exact flight is reckoned from another event by a new one, and Verlet's forces are those before the
                // roundings were taken from what lies on a plane: their bits are not the same.
                let remembered = [StepperName::Auto, StepperName::VelocityVerlet];
                let rounded = form == CollisionForm::TimeOfImpact
                    && remembered.iter().any(|name| [stepper, other].contains(name));
                if !rounded {
                    assert_eq!(run.digest(), fresh.digest(), "seed {seed}, {stepper} and {other}, {form}, step {step}");
                }
            }
        }
    }
}

/// The shortest and the longest steps end, in a state that is finite or in the old one.
#[test]
fn steps_of_any_length_end() {
    for (seed, scene) in scenes(800..830) {
        for (stepper, form) in ways() {
            for dt in [1e-300, 1e-30, 1e-12, 1.0, 1e3, 1e9] {
                let mut run = Run::<f64, Heap>::new(&scene, stepper, form);
                let mut single = Run::<f32, Heap>::new(&scene, stepper, form);
                for _ in 0..3 {
                    let result = run.step(dt, &mut ()).err();
                    let fine = matches!(result, None | Some(StepError::NonFinite { .. }));
                    assert!(fine, "seed {seed}, {stepper}, {form}, {dt} s: {result:?}");
                    if dt > 1e-37 {
                        let result = single.step(dt, &mut ()).err();
                        let fine = matches!(result, None | Some(StepError::NonFinite { .. }));
                        assert!(fine, "seed {seed}, {stepper}, {form}, {dt} s in f32: {result:?}");
                    }
                }
                let finite = run.world.view().states().all(|(x, v)| x.is_finite() && v.is_finite());
                assert!(finite, "seed {seed}, {stepper}, {form}, {dt} s");
                let finite = single.world.view().states().all(|(x, v)| x.is_finite() && v.is_finite());
                assert!(finite, "seed {seed}, {stepper}, {form}, {dt} s in f32");
            }
        }
    }
}

/// On one plane more restitution never leaves less energy, at any time.
#[test]
fn more_restitution_leaves_more_energy() {
    for seed in 500..540 {
        let mut scene = RandomScene::new(seed, 1.0, 0.0).without_springs();
        scene.planes.truncate(1);
        let mut least = f64::NEG_INFINITY;
        for restitution in [0.0, 1e-6, 0.2, 0.5, 0.9, 1.0] {
            scene.planes.iter_mut().for_each(|plane| plane.2 = restitution);
            let mut run = Run::<f64, Heap>::new(&scene, StepperName::Auto, CollisionForm::TimeOfImpact);
            let mut ledger = Ledger::open(&run.world.view());
            for _ in 0..50 {
                run.step(0.04, &mut ledger).unwrap();
            }
            let balance = ledger.balance(&run.world.view());
            assert!(balance.remainder().abs() <= 1e-12 * balance.scale(), "seed {seed}: {balance:?}");
            let energy = balance.kinetic + balance.gravitational;
            assert!(energy >= least - 1e-12 * balance.scale(), "seed {seed}, restitution {restitution}");
            least = energy;
        }
    }
}

/// Exact flight gives the same bits at the same times, whatever times lie between them and whoever has looked ahead.
#[test]
fn exact_flight_does_not_depend_on_the_steps() {
    for (seed, scene) in scenes(600..680) {
        let scene = scene.without_springs();
        the_same_at_common_times::<f64>(seed, &scene);
        the_same_at_common_times::<f32>(seed, &scene);
    }
}

fn the_same_at_common_times<R: Real>(seed: u64, scene: &RandomScene) {
    let mut random = Random::new(seed);
    let mut runs = [0; 3].map(|_| Run::<R, Heap>::new(scene, StepperName::Auto, CollisionForm::TimeOfImpact));
    for step in 1..=8 {
        let [from, to] = [step - 1, step].map(|step| 0.25 * f64::from(step));
        let [coarse, fine, curious] = &mut runs;
        coarse.step_to(to);
        let mut time = from;
        while random.below(6) > 0 {
            time += random.between(0.0, 0.5) * (to - time);
            fine.step_to(time);
            curious.world.view().free_at(curious.stepper.any(), time).map(Iterator::count);
        }
        fine.step_to(to);
        curious.step_to(to);
        let digests = [coarse.digest(), fine.digest(), curious.digest()];
        assert_eq!(digests, [digests[0]; 3], "seed {seed}, {to} s");
    }
}
