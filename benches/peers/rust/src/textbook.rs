//! The textbook loop on three kinds of vector.

use std::error::Error;

use hooke_benches::textbook::{Response, Textbook};
use hooke_benches::vector::{Scalar, Vector};
use hooke_runner::scene::Scene;

use crate::peer::{Outcome, Peer, Request, timed};

pub struct Start<V: Vector>(Textbook<V>);

pub fn new<V: Vector>(scene: &Scene) -> Result<Start<V>, Box<dyn Error>> {
    let textbook = Textbook::new(&scene.model()?, scene.settings().gravity, Response::Project);
    Ok(Start(textbook.map_err(|_| "the textbook loop has no keyframes")?))
}

impl<V: Vector> Peer for Start<V> {
    fn run(&mut self, request: &Request) -> Result<Outcome, Box<dyn Error>> {
        let mut textbook = self.0.clone();
        let time_step = V::Real::from_f64(request.setting);
        let (cpu, ()) = timed(|| {
            for _ in 0..request.steps() {
                textbook.step_semi_implicit_euler(time_step);
            }
        });
        let position = textbook.particles.iter().flat_map(|particle| particle.position.components()).collect();
        Ok(Outcome { cpu, position })
    }
}
