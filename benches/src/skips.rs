//! What a scene may not need, each as a pair: steps with it and steps without.

use hooke::Sleep;
use hooke_runner::model::{Hold, Model, ModelPlane};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_runner::simulate::{AnyResponse, AnyStepper, HeapWorld, world};

use crate::scenes::{GRAVITY, balls, cloth, ropes, thrown_balls};

/// Takes so many steps.
pub type Steps = Box<dyn FnMut(u32)>;

/// What a pair shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shows {
    /// What leaving something out gains.
    Gain,
    /// What it costs to look whether something can be left out, where it cannot.
    Cost,
}

/// Steps with something, and steps without.
#[derive(Clone, Copy)]
pub struct Pair {
    /// What it is.
    pub name: &'static str,
    /// Which of the two is to be expected.
    pub shows: Shows,
    /// Steps with it.
    pub with: fn() -> Steps,
    /// The same steps without.
    pub without: fn() -> Steps,
}

/// s; stable on all of these scenes.
const TIME_STEP: f32 = 1e-4;
/// Relative; none of these steppers asks for it.
const TOLERANCE: f64 = 1e-6;
/// Above the floor: where the cloth hangs. A plane a little lower has to be tested particle by particle.
const HEIGHT: f64 = 1.0;

/// All of them.
pub const PAIRS: [Pair; 14] = [
    gain("gravity", || plain(&cloth(64, 0.05)), || steps(&cloth(64, 0.05), [0.0; 3], euler())),
    gain("springs", || plain(&cloth(64, 0.05)), || plain(&changed(|model| model.springs.clear()))),
    gain("damping", || plain(&cloth(64, 0.05)), || plain(&cloth(64, 0.0))),
    gain("damping of most springs", || plain(&cloth(64, 0.05)), || plain(&changed(damp_a_sixth))),
    gain("springs that vary", || plain(&changed(vary)), || plain(&cloth(64, 0.05))),
    gain("masses that vary", || plain(&large(vary_masses)), || plain(&large(|_| ()))),
    gain("planes", || plain(&changed(|model| planes(model, HEIGHT - 1e-6))), || plain(&cloth(64, 0.05))),
    gain(
        "planes in reach",
        || plain(&changed(|model| planes(model, HEIGHT - 1e-6))),
        || plain(&changed(|model| planes(model, -100.0))),
    ),
    gain("particles that are not pinned", || plain(&cloth(64, 0.05)), || plain(&changed(pin_half))),
    gain("steps of free particles", || frames(euler(), 16), || frames(StepperName::Auto, 1)),
    gain("axes that particles move along", || flights(&thrown_balls(10_000)), || flights(&balls(10_000))),
    gain("islands awake", || ropes_at_rest(None), || ropes_at_rest(Some(Sleep::below(0.05).after(0.04)))),
    cost("whether planes are in reach", || plain(&changed(|model| planes(model, -100.0))), || plain(&cloth(64, 0.05))),
    cost("whether islands rest", || cloth_that_may_sleep(true), || cloth_that_may_sleep(false)),
];

const fn gain(name: &'static str, with: fn() -> Steps, without: fn() -> Steps) -> Pair {
    Pair { name, shows: Shows::Gain, with, without }
}

const fn cost(name: &'static str, with: fn() -> Steps, without: fn() -> Steps) -> Pair {
    Pair { name, shows: Shows::Cost, with, without }
}

fn euler() -> StepperName {
    StepperName::SemiImplicitEuler
}

fn plain(model: &Model) -> Steps {
    steps(model, GRAVITY, euler())
}

fn changed(change: impl Fn(&mut Model)) -> Model {
    let mut model = cloth(64, 0.05);
    change(&mut model);
    model
}

fn damp_a_sixth(model: &mut Model) {
    model.springs.iter_mut().skip(4000).for_each(|spring| spring.damping = 0.0);
}

fn vary(model: &mut Model) {
    for (number, spring) in model.springs.iter_mut().enumerate() {
        spring.stiffness *= 1.0 + 1e-3 * (number % 7) as f64;
    }
}

/// A cloth whose columns do not fit into the second cache.
fn large(change: impl Fn(&mut Model)) -> Model {
    let mut model = cloth(256, 0.05);
    change(&mut model);
    model
}

fn vary_masses(model: &mut Model) {
    for (number, particle) in model.particles.iter_mut().enumerate() {
        particle.mass *= 1.0 + 1e-3 * (number % 7) as f64;
    }
}

/// Four of them.
fn planes(model: &mut Model, height: f64) {
    let plane = ModelPlane { point: [0.0, 0.0, height], normal: [0.0, 0.0, 1.0], restitution: 0.5 };
    model.planes = vec![plane; 4];
}

fn pin_half(model: &mut Model) {
    let half = model.particles.len() / 2;
    model.particles.iter_mut().take(half).for_each(|particle| particle.hold = Hold::Pinned);
}

fn steps(model: &Model, gravity: [f64; 3], stepper: StepperName) -> Steps {
    stepping(built(model, gravity), Method::projecting(stepper), TIME_STEP, 1)
}

/// Balls over a plane, each step a sixtieth of a second, taken in so many parts.
fn frames(stepper: StepperName, parts: u16) -> Steps {
    stepping(built(&balls(10_000), GRAVITY), Method::projecting(stepper), 1.0 / 60.0 / f32::from(parts), parts.into())
}

/// A sixtieth of a second each.
fn flights(model: &Model) -> Steps {
    let method = Method::new(StepperName::Auto, CollisionForm::TimeOfImpact);
    stepping(built(model, GRAVITY), method, 1.0 / 60.0, 1)
}

/// Ropes that lie still, without gravity, one in a hundred of which swings.
fn ropes_at_rest(sleep: Option<Sleep<f32>>) -> Steps {
    let time_step = 1e-3;
    let mut model = ropes(200, 100);
    for (number, particle) in model.particles.iter_mut().enumerate() {
        if number / 100 % 100 == 37 {
            particle.velocity = [0.0, 0.0, 1.0];
        }
    }
    let mut world = built(&model, [0.0; 3]);
    world.set_sleep(sleep).expect("sound");
    Method::projecting(euler()).take(&mut world, time_step, 100);
    assert_eq!(world.view().plan().islands_asleep, if sleep.is_some() { 198 } else { 0 });
    stepping(world, Method::projecting(euler()), time_step, 1)
}

/// It never comes to rest.
fn cloth_that_may_sleep(may: bool) -> Steps {
    let mut world = built(&cloth(64, 0.05), GRAVITY);
    world.set_sleep(may.then(|| Sleep::below(1e-6))).expect("sound");
    stepping(world, Method::projecting(euler()), TIME_STEP, 1)
}

fn built(model: &Model, gravity: [f64; 3]) -> HeapWorld<f32> {
    world(model, gravity).expect("a scene in range")
}

/// Steps of a world, each taken in so many parts of `time_step` seconds.
fn stepping(mut world: HeapWorld<f32>, mut method: Method, time_step: f32, parts: u32) -> Steps {
    Box::new(move |steps| method.take(&mut world, time_step, steps * parts))
}

/// What steps, and what answers collisions.
struct Method(AnyStepper<f32>, AnyResponse<f32>);

impl Method {
    fn new(stepper: StepperName, form: CollisionForm) -> Self {
        Self(AnyStepper::named(stepper, TOLERANCE), AnyResponse::named(form))
    }

    fn projecting(stepper: StepperName) -> Self {
        Self::new(stepper, CollisionForm::Project)
    }

    fn take(&mut self, world: &mut HeapWorld<f32>, time_step: f32, steps: u32) {
        let Self(stepper, response) = self;
        for _ in 0..steps {
            world.step(stepper.any(), response, time_step).expect("a stable step");
        }
    }
}
