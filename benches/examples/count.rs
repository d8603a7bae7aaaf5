//! Scratch.
use hooke::*;
use hooke_runner::scene::Scene;
use hooke_runner::simulate::world;
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let scene = Scene::load(std::path::Path::new(&a[1])).unwrap();
    let model = scene.model().unwrap();
    let mut w = world::<f32>(&model, scene.settings().gravity).unwrap();
    for _ in 0..a[2].parse::<u32>().unwrap() {
        w.step(&mut SemiImplicitEuler, &mut Project, 1e-4).unwrap();
    }
}
