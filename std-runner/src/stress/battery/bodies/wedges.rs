//! A particle between two planes that meet, without gravity, elastic: unfolded, its path is a straight line.

use super::Body;
use crate::model::{Hold, Model, ModelParticle, ModelPlane};
use crate::stress::battery::case::{Case, Group};

/// Degrees.
const ANGLES: [f64; 8] = [10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 75.0, 90.0];
/// How near to the edge the straight line passes, m.
const MISS: f64 = 0.1;

/// All hits in a few steps, and in many.
pub fn wedges() -> Vec<Case> {
    let steps = [4, 400];
    ANGLES.iter().flat_map(|angle| steps.map(|steps| wedge(*angle, steps))).collect()
}

fn wedge(degrees: f64, steps: u64) -> Case {
    let angle = degrees.to_radians();
    let from = polar(1.0, 0.4 * angle);
    // Towards the edge, but for what passes it by.
    let heading = 0.4 * angle + std::f64::consts::PI - MISS.asin();
    let velocity = polar(1.0, heading);
    let particle = ModelParticle { position: from, velocity, mass: 0.2, hold: Hold::Free };
    let plane = |normal| ModelPlane { point: [0.0; 3], normal, restitution: 1.0 };
    let planes = vec![plane([0.0, 0.0, 1.0]), plane([angle.sin(), 0.0, -angle.cos()])];
    let body = Body {
        group: Group::Wedges,
        name: format!("{degrees}°, in {steps} steps"),
        model: Model { particles: vec![particle], planes, ..Model::default() },
        gravity: [0.0; 3],
        duration: 2.0,
        steps,
    };
    let case = body.moving(|time| vec![folded(from, velocity, time, angle)]);
    Case { most_hits: Some((std::f64::consts::PI / angle - 1e-9).ceil() as u64), ..case }
}

/// In the plane that the edge is across.
fn polar(radius: f64, angle: f64) -> [f64; 3] {
    [radius * angle.cos(), 0.0, radius * angle.sin()]
}

/// The point of the straight line, turned back into the wedge.
fn folded([x, _, z]: [f64; 3], [u, _, w]: [f64; 3], time: f64, angle: f64) -> [f64; 3] {
    let (a, b) = (x + time * u, z + time * w);
    let turned = (x * b - z * a).atan2(x * a + z * b);
    let unfolded = z.atan2(x) + turned;
    let within = unfolded.rem_euclid(2.0 * angle);
    polar(a.hypot(b), if within > angle { 2.0 * angle - within } else { within })
}
