//! Scratch.
use glam::{DVec3, Vec3, Vec3A};
use hooke::*;
use hooke_benches::textbook::{Response, Textbook};
use hooke_runner::scene::{Scene, StepperName};
use hooke_runner::simulate::{AnyStepper, world};
use std::time::Instant;
fn main() {
    for path in std::env::args().skip(1) {
        let mesh = path.strip_prefix("mesh:").map(|n| hooke_benches::mesh::irregular(n.parse().unwrap()));
        let scene = if mesh.is_some() {
            Scene::load(std::path::Path::new("benches/scenes/cloth-32.toml")).unwrap()
        } else {
            Scene::load(std::path::Path::new(&path)).unwrap()
        };
        let model = mesh.unwrap_or_else(|| scene.model().unwrap());
        let g = scene.settings().gravity;
        let n = model.springs.len().max(1);
        let steps = (20_000_000 / n).clamp(3, 20000);
        let mut t3 = Textbook::<Vec3>::new(&model, g, Response::Project).unwrap();
        let mut ta = Textbook::<Vec3A>::new(&model, g, Response::Project).unwrap();
        let mut td = Textbook::<DVec3>::new(&model, g, Response::Project).unwrap();
        let mut best = [f64::MAX; 8];
        let mut w32: Vec<_> = [Lanes::Baseline, Lanes::Avx2]
            .into_iter()
            .map(|l| {
                let mut w = world::<f32>(&model, g).unwrap();
                w.set_lanes(l);
                w
            })
            .collect();
        let mut w64: Vec<_> = [Lanes::Baseline, Lanes::Avx2]
            .into_iter()
            .map(|l| {
                let mut w = world::<f64>(&model, g).unwrap();
                w.set_lanes(l);
                w
            })
            .collect();
        let mut wv = world::<f32>(&model, g).unwrap();
        let mut sv = AnyStepper::named(StepperName::VelocityVerlet, 1e-6);
        println!("{path}: {:?}", wv.view().plan());
        let dt = 1e-4;
        for _ in 0..5 {
            let mut slot = 0;
            let mut time = |f: &mut dyn FnMut()| {
                let t = Instant::now();
                for _ in 0..steps {
                    f()
                }
                let e = t.elapsed().as_secs_f64() / steps as f64 / n as f64 * 1e9;
                best[slot] = best[slot].min(e);
                slot += 1;
            };
            time(&mut || t3.step_semi_implicit_euler(dt as f32));
            time(&mut || ta.step_semi_implicit_euler(dt as f32));
            time(&mut || td.step_semi_implicit_euler(dt));
            for w in &mut w32 {
                time(&mut || {
                    w.step(&mut SemiImplicitEuler, &mut Project, dt as f32).unwrap();
                });
            }
            for w in &mut w64 {
                time(&mut || {
                    w.step(&mut SemiImplicitEuler, &mut Project, dt).unwrap();
                });
            }
            time(&mut || {
                wv.step(&mut sv, &mut Project, dt as f32).unwrap();
            });
        }
        println!(
            "  Vec3 {:.2} Vec3A {:.2} DVec3 {:.2} | f32 sse {:.2} avx2 {:.2} | f64 sse {:.2} avx2 {:.2} | verlet f32 {:.2}   ratio {:.2} {:.2}",
            best[0],
            best[1],
            best[2],
            best[3],
            best[4],
            best[5],
            best[6],
            best[7],
            best[0].min(best[1]) / best[4],
            best[2] / best[6]
        );
    }
}
