//! One step of semi-implicit Euler against the textbook loop, in one run: contenders take turns, the best round counts.
//!
//! `cargo run --release -p hooke-benches --bin against-textbook [SCENE…]` prints a table and, without scenes named,
//! writes `benches/results/step.csv`.

#![allow(clippy::expect_used, reason = "a benchmark that cannot be set up has nothing to measure")]

use std::fmt::Write as _;
use std::path::Path;

use glam::{DVec3, Vec3, Vec3A};
use hooke::{Lanes, Project, Real};
use hooke_benches::avx2;
use hooke_benches::interleaved::{Contender, least_times};
use hooke_benches::scenes::{GRAVITY, STEP};
use hooke_benches::stamp::stamp;
use hooke_benches::textbook::{Response, Textbook};
use hooke_benches::vector::{Scalar, Vector};
use hooke_runner::model::Model;
use hooke_runner::scene::StepperName;
use hooke_runner::simulate::{AnyStepper, HeapWorld, Threads, world};

/// s; stable on all of these scenes.
const TIME_STEP: f64 = 1e-4;
/// Relative; none of these steppers asks for it.
const TOLERANCE: f64 = 1e-6;
const ROUNDS: u32 = 7;
/// What the names of its contenders begin with.
const TEXTBOOK: &str = "textbook";

fn main() -> std::io::Result<()> {
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let mut csv = format!("# {}\nscene,contender,springs,particles,ns_per_step\n", stamp());
    for (name, make) in STEP {
        if asked.is_empty() || asked.iter().any(|asked| asked == name) {
            race(name, &make(), &mut csv);
        }
    }
    if asked.is_empty() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("results");
        std::fs::create_dir_all(&folder)?;
        std::fs::write(folder.join("step.csv"), csv)?;
    }
    Ok(())
}

fn race(name: &str, model: &Model, csv: &mut String) {
    let (springs, particles) = (model.springs.len(), model.particles.len());
    let items = if springs > 0 { springs } else { particles };
    let euler = StepperName::SemiImplicitEuler;
    let mut contenders = vec![
        textbook::<Vec3>("Vec3 f32", model),
        textbook::<Vec3A>("Vec3A f32", model),
        textbook::<DVec3>("DVec3 f64", model),
        avx2_textbook::<Vec3>("Vec3 f32", model),
        avx2_textbook::<Vec3A>("Vec3A f32", model),
        avx2_textbook::<DVec3>("DVec3 f64", model),
        ours::<f32>("f32 baseline", model, euler, Lanes::Baseline, 1),
        ours::<f32>("f32 AVX2", model, euler, Lanes::Avx2, 1),
        ours::<f32>("f32", model, euler, Lanes::Avx512, 1),
        ours::<f64>("f64", model, euler, Lanes::Avx512, 1),
        ours::<f32>("Verlet f32", model, StepperName::VelocityVerlet, Lanes::Avx512, 1),
    ];
    // Long enough that a thread which has been asleep is at work for most of it.
    let steps = (16_000_000 / items).clamp(3, 8000) as u32;
    let times = least_times(&mut contenders, ROUNDS, steps);
    let [single, double] = ["f32", "f64"].map(|precision| least_of_textbooks(precision, &contenders, &times));
    println!("{name}: {springs} springs, {particles} particles");
    let mut tell = |contender: &str, time: f64, told: String| {
        let each = time / items as f64;
        println!("  {contender:24}{each:8.2} ns per {} {told}", if springs > 0 { "spring" } else { "particle" });
        let _ = writeln!(csv, "{name},{contender},{springs},{particles},{time:.0}");
    };
    for ((contender, _), time) in contenders.iter().zip(&times) {
        let rival = if contender.contains("f64") { double } else { single };
        let is_rival = contender.starts_with(TEXTBOOK);
        let ratio = if is_rival { String::new() } else { format!("{:6.2} times the textbook", rival / time) };
        tell(contender, *time, ratio);
    }
    // Between themselves: a core that has been left idle for the others' turns takes its time to come back.
    let mut contenders =
        [1, 2].map(|threads| ours::<f32>(&format!("f32 on {threads} thread(s)"), model, euler, Lanes::Avx512, threads));
    let times = least_times(&mut contenders, ROUNDS, steps);
    for ((contender, _), time) in contenders.iter().zip(&times) {
        tell(contender, *time, format!("{:6.2} times one thread", times[0] / time));
    }
}

/// The time of the fastest textbook loop of a precision.
fn least_of_textbooks(precision: &str, contenders: &[Contender<'_>], times: &[f64]) -> f64 {
    let rivals = contenders.iter().zip(times);
    let rivals = rivals.filter(|((name, _), _)| name.starts_with(TEXTBOOK) && name.contains(precision));
    rivals.fold(f64::INFINITY, |least, (_, time)| least.min(*time))
}

fn textbook<V: Vector + 'static>(label: &str, model: &Model) -> Contender<'static>
where
    V::Real: Scalar + 'static,
{
    stepping(format!("{TEXTBOOK} {label}"), model, Textbook::<V>::step_semi_implicit_euler)
}

/// The same, compiled for AVX2.
fn avx2_textbook<V: Vector + 'static>(label: &str, model: &Model) -> Contender<'static>
where
    V::Real: Scalar + 'static,
{
    stepping(format!("{TEXTBOOK} {label} AVX2"), model, avx2::step_semi_implicit_euler::<V>)
}

fn stepping<V: Vector + 'static>(
    name: String,
    model: &Model,
    step: impl Fn(&mut Textbook<V>, V::Real) + 'static,
) -> Contender<'static>
where
    V::Real: Scalar + 'static,
{
    let mut textbook = Textbook::<V>::new(model, GRAVITY, Response::Project).expect("no keyframes");
    let dt = V::Real::from_f64(TIME_STEP);
    (name, Box::new(move |steps| (0..steps).for_each(|_| step(&mut textbook, dt))))
}

fn ours<R: Real>(label: &str, model: &Model, stepper: StepperName, lanes: Lanes, threads: u32) -> Contender<'static> {
    let mut world = world::<R>(model, GRAVITY).expect("a scene in range");
    world.set_lanes(lanes);
    let mut stepper = AnyStepper::named(stepper, TOLERANCE);
    let threads = Threads::of(Some(threads), world.view().plan()).expect("threads to be had");
    let step = move |steps: u32| match &threads {
        Some(threads) => threads.during(|| repeat(&mut world, &mut stepper, Some(threads), steps)),
        None => repeat(&mut world, &mut stepper, None, steps),
    };
    (format!("hooke {label}"), Box::new(step))
}

fn repeat<R: Real>(world: &mut HeapWorld<R>, stepper: &mut AnyStepper<R>, threads: Option<&Threads>, steps: u32) {
    for _ in 0..steps {
        let mut view = world.view();
        if let Some(threads) = threads {
            view.share_among(threads);
        }
        view.step(stepper.any(), &mut Project, R::from_f64(TIME_STEP)).expect("a stable step");
    }
}
