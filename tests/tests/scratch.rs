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
