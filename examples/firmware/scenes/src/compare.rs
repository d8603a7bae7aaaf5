//! Every stepper on every scene, and the digest of what comes of it.

use hooke::{
    Auto, BlanesMoanS6, Dop853, DormandPrinceRkn8, ExplicitEuler, Fixed, ImplicitEuler, ImplicitEulerLinearised,
    ImplicitMidpoint, Project, Real, Reflect, Response, Rk4, SemiImplicitEuler, StepError, Stepper, TimeOfImpact,
    TrBdf2, VelocityVerlet, World,
};

use crate::{balls, cloth, rope};

/// Is told a scene, a stepper, and the digest of the last state, or why there is none.
pub trait Tell {
    /// One line.
    fn tell(&mut self, scene: &str, stepper: &str, digest: Result<u64, StepError>);
}

/// Steps that are taken of each where there is a unit for floating-point numbers, and where there is none.
const STEPS: [u32; 2] = [200, 25];
/// s
const TIME_STEP: f64 = 1.0 / 512.0;
/// At which implicit steps count as solved.
const TOLERANCE: f64 = 1e-5;

/// A world, how it is filled, and how its planes are answered.
struct Run<'a, W, F, A> {
    scene: &'a str,
    steps: u32,
    world: &'a mut W,
    fill: F,
    response: A,
}

impl<R, const P: usize, const S: usize, const L: usize, F, A, C> Run<'_, World<R, P, S, L>, F, A>
where
    R: Real,
    F: Fn(&mut World<R, P, S, L>) -> Option<()>,
    A: Fn() -> C,
    C: Response<R>,
{
    /// A function of its own for each stepper, so that the stack holds one at a time.
    #[inline(never)]
    fn by<T: Stepper<R>>(&mut self, name: &str, stepper: impl FnOnce() -> T, tell: &mut impl Tell) {
        let mut stepper = stepper();
        *self.world = World::new();
        let filled = (self.fill)(self.world).is_some();
        let mut response = (self.response)();
        let mut taken = if filled { Ok(()) } else { Err(StepError::TimeStep) };
        for _ in 0..self.steps {
            taken =
                taken.and_then(|()| self.world.step(&mut stepper, &mut response, R::from_f64(TIME_STEP)).map(|_| ()));
        }
        tell.tell(self.scene, name, taken.map(|()| hooke_digest::of(&self.world.view())));
    }

    /// By all but `auto`.
    fn by_named(&mut self, tell: &mut impl Tell) {
        self.by("explicit-euler", || ExplicitEuler, tell);
        self.by("semi-implicit-euler", || SemiImplicitEuler, tell);
        self.by("velocity-verlet", VelocityVerlet::<R, Fixed<P, S, L>>::new, tell);
        self.by("rk4", Rk4::<R, Fixed<P, S, L>>::new, tell);
        self.by("blanes-moan-s6", BlanesMoanS6::<R, Fixed<P, S, L>>::new, tell);
        self.by("dop853", Dop853::<R, Fixed<P, S, L>>::new, tell);
        self.by("dormand-prince-rkn8", DormandPrinceRkn8::<R, Fixed<P, S, L>>::new, tell);
        self.by("implicit-euler", || ImplicitEuler::<R, Fixed<P, S, L>>::new(TOLERANCE), tell);
        self.by("implicit-euler-linearised", || ImplicitEulerLinearised::<R, Fixed<P, S, L>>::new(TOLERANCE), tell);
        self.by("implicit-midpoint", || ImplicitMidpoint::<R, Fixed<P, S, L>>::new(TOLERANCE), tell);
        self.by("tr-bdf2", || TrBdf2::<R, Fixed<P, S, L>>::new(TOLERANCE), tell);
    }

    fn by_all(&mut self, tell: &mut impl Tell) {
        self.by_named(tell);
        self.by("auto", || Auto::<R, Fixed<P, S, L>>::new(TOLERANCE), tell);
    }
}

/// The worlds of [`many`].
pub struct Many {
    rope: World<f32, 32, 31, 0>,
    rope_double: World<f64, 32, 31, 0>,
    cloth: World<f32, 100, 502, 0>,
    balls: World<f32, 8, 0, 1>,
}

impl Many {
    /// Empty ones.
    pub const EMPTY: Self =
        Self { rope: World::new(), rope_double: World::new(), cloth: World::new(), balls: World::new() };
}

/// All steppers on a rope in both precisions, on a cloth of 10 × 10, and on bouncing balls in all forms of collision.
pub fn many(worlds: &mut Many, tell: &mut impl Tell) {
    let [steps, _] = STEPS;
    let Many { rope: single, rope_double, cloth: hanging, balls: bouncing } = worlds;
    Run { scene: "rope of 32, f32", steps, world: single, fill: rope, response: || Project }.by_all(tell);
    Run { scene: "rope of 32, f64", steps, world: rope_double, fill: rope, response: || Project }.by_all(tell);
    Run {
        scene: "cloth 10x10, f32",
        steps,
        world: hanging,
        fill: |world: &mut _| cloth(world, 10),
        response: || Project,
    }
    .by_all(tell);
    Run { scene: "balls, f32, reflect", steps, world: bouncing, fill: balls, response: || Reflect }.by_all(tell);
    Run { scene: "balls, f32, project", steps, world: bouncing, fill: balls, response: || Project }.by_all(tell);
    let located = TimeOfImpact::<f32, Fixed<8, 0, 1>>::new;
    Run { scene: "balls, f32, time-of-impact", steps, world: bouncing, fill: balls, response: located }.by_all(tell);
}

/// The worlds of [`few`].
pub struct Few {
    rope: World<f32, 8, 7, 0>,
    cloth: World<f32, 9, 26, 0>,
}

impl Few {
    /// Empty ones.
    pub const EMPTY: Self = Self { rope: World::new(), cloth: World::new() };
}

/// For 16 KiB of RAM: all steppers on a rope of 8 and on a cloth of 3 × 3.
pub fn few(worlds: &mut Few, tell: &mut impl Tell) {
    let [_, steps] = STEPS;
    let Few { rope: short, cloth: hanging } = worlds;
    Run { scene: "rope of 8, f32", steps, world: short, fill: rope, response: || Project }.by_all(tell);
    Run { scene: "cloth 3x3, f32", steps, world: hanging, fill: |world: &mut _| cloth(world, 3), response: || Project }
        .by_all(tell);
}

/// The world of [`bouncing`].
pub type Balls = World<f32, 4, 0, 1>;

/// For 16 KiB of RAM too: all steppers on bouncing balls in all forms of collision, but for `auto` with located impacts, whose
/// exact flights take more of the stack.
pub fn bouncing(world: &mut Balls, tell: &mut impl Tell) {
    let [_, steps] = STEPS;
    Run { scene: "balls of 4, f32, reflect", steps, world, fill: balls, response: || Reflect }.by_all(tell);
    Run { scene: "balls of 4, f32, project", steps, world, fill: balls, response: || Project }.by_all(tell);
    let located = TimeOfImpact::<f32, Fixed<4, 0, 1>>::new;
    Run { scene: "balls of 4, f32, time-of-impact", steps, world, fill: balls, response: located }.by_named(tell);
}
