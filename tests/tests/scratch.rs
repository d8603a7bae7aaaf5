#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::{bounce_runs::run, measure, problems};
#[test]
fn flights() {
    for p in problems::bouncing() {
        if !p.model.springs.is_empty() {
            continue;
        }
        for (s, c, dt) in [
            (StepperName::Auto, CollisionForm::TimeOfImpact, 1.0 / 60.0),
            (StepperName::Auto, CollisionForm::TimeOfImpact, p.duration),
            (StepperName::VelocityVerlet, CollisionForm::TimeOfImpact, 0.01),
            (StepperName::SemiImplicitEuler, CollisionForm::TimeOfImpact, 0.001),
            (StepperName::SemiImplicitEuler, CollisionForm::Project, 0.001),
            (StepperName::SemiImplicitEuler, CollisionForm::Reflect, 0.001),
        ] {
            let mut worst = 0.0f64;
            let mut rem = 0.0f64;
            let mut lost = 0.0f64;
            let mut hits = 0;
            for k in 1..=10 {
                let t = p.duration * k as f64 / 10.0;
                let o = run(&p, s, c, dt, t);
                let e = (p.exact)(t);
                worst = worst.max(measure::position_error(&o.moment, &e));
                rem = rem.max(o.balance.remainder().abs() / o.balance.scale());
                lost = lost.max((o.balance.lost_in_impacts - p.lost_in_impacts(t)).abs() / o.balance.scale());
                hits = o.report.hits;
            }
            println!(
                "{:50} {:?} {:?} dt {:.4} pos {:.2e} rem {:.2e} lost {:.2e} hits {} impacts {} rest {:?}",
                p.name,
                s,
                c,
                dt,
                worst,
                rem,
                lost,
                hits,
                p.impacts.len(),
                p.rest
            );
        }
    }
}
#[test]
fn springs() {
    for p in problems::bouncing() {
        if p.model.springs.is_empty() {
            continue;
        }
        for s in [
            StepperName::VelocityVerlet,
            StepperName::SemiImplicitEuler,
            StepperName::ExplicitEuler,
            StepperName::ImplicitEuler,
        ] {
            print!("{:50} {:?} ", p.name, s);
            for dt in [4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4] {
                let mut worst = 0.0f64;
                let mut rem = 0.0f64;
                let mut hits = 0;
                let mut lost = 0.0;
                for k in 1..=4 {
                    let t = p.duration * k as f64 / 4.0;
                    let o = run(&p, s, CollisionForm::TimeOfImpact, dt, t);
                    worst = worst.max(measure::position_error(&o.moment, &(p.exact)(t)));
                    rem = rem.max(o.balance.remainder().abs() / o.balance.scale());
                    hits = o.report.hits;
                    lost = (o.balance.lost_in_impacts - p.lost_in_impacts(t)).abs() / o.balance.scale();
                }
                print!("| {:.1e} {:.1e} {:.1e} {}/{}", worst, rem, lost, hits, p.impacts.len());
            }
            println!();
        }
    }
}
use hooke_runner::{
    draw::{Picture, Scenery},
    record::{PngRecorder, Recorder},
    scene::Scene,
    simulate::{self, Options, Progress},
};
struct Quiet;
impl Progress for Quiet {
    fn reached(&self, _: f64, _: f64) {}
}
#[test]
fn scenes() {
    let only = std::env::var("ONLY").ok();
    for e in std::fs::read_dir("../scenes").unwrap() {
        let path = e.unwrap().path();
        if path.extension().is_none_or(|x| x != "toml") {
            continue;
        }
        if let Some(o) = &only {
            if !path.to_string_lossy().contains(o.as_str()) {
                continue;
            }
        }
        let scene = Scene::load(&path).unwrap();
        let mut settings = scene.settings().clone();
        settings.frame_rate = 8.0;
        let model = scene.model().unwrap();
        let stop = std::sync::atomic::AtomicBool::new(false);
        let stem = path.file_stem().unwrap().to_string_lossy().to_string();
        let out = std::path::PathBuf::from(format!("/tmp/scenes/{stem}.png"));
        std::fs::create_dir_all("/tmp/scenes").unwrap();
        let s = simulate::run::<f64>(
            &model,
            &settings,
            |_| {
                let p = Picture::new(Scenery::new(&model, settings.gravity, &settings.name, &settings.camera));
                Ok(vec![Box::new(PngRecorder::create(&out, p)?) as Box<dyn Recorder<f64>>])
            },
            &Options { ledger: true, interrupted: &stop, progress: &Quiet },
        )
        .unwrap();
        let b = s.balance.unwrap();
        println!(
            "{stem}: {:?} steps {} dt {:?} hits {} capped {} rem {:.2e} unconv {} its {} lin {} fe {} ns {:?} choices {:?}",
            s.ending,
            s.steps,
            s.time_step,
            s.hits,
            s.capped,
            b.remainder() / b.scale(),
            s.unconverged,
            s.iterations,
            s.linear_iterations,
            s.force_evaluations,
            s.nanoseconds_per_spring_step(),
            s.choices.iter().map(|c| c.to_string()).collect::<Vec<_>>()
        );
    }
}
#[test]
fn ledgers() {
    let only = std::env::var("ONLY").ok();
    for e in std::fs::read_dir("../scenes").unwrap() {
        let path = e.unwrap().path();
        if path.extension().is_none_or(|x| x != "toml") {
            continue;
        }
        if let Some(o) = &only {
            if !path.to_string_lossy().contains(o.as_str()) {
                continue;
            }
        }
        let scene = Scene::load(&path).unwrap();
        let model = scene.model().unwrap();
        let stop = std::sync::atomic::AtomicBool::new(false);
        let stem = path.file_stem().unwrap().to_string_lossy().to_string();
        let hooke_runner::scene::TimeStep::Seconds(dt0) = scene.settings().time_step else { continue };
        for st in
            [StepperName::Auto, StepperName::VelocityVerlet, StepperName::SemiImplicitEuler, StepperName::ImplicitEuler]
        {
            if st == StepperName::ImplicitEuler && model.springs.len() > 3000 {
                continue;
            }
            print!("{stem} {st} ");
            for k in 0..5 {
                let mut settings = scene.settings().clone();
                settings.stepper = st;
                settings.tolerance = 1e-10;
                settings.duration = settings.duration.min(1.0);
                settings.time_step = hooke_runner::scene::TimeStep::Seconds(dt0 / 2f64.powi(k));
                let s = simulate::run::<f64>(
                    &model,
                    &settings,
                    |_| Ok(vec![]),
                    &Options { ledger: true, interrupted: &stop, progress: &Quiet },
                )
                .unwrap();
                let b = s.balance.unwrap();
                print!(" {:.2e}({},{})", b.remainder() / b.scale(), s.hits, s.capped);
            }
            println!();
        }
    }
}
