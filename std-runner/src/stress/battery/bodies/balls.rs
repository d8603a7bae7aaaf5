//! A ball that falls on a floor, and bounces.

use super::Body;
use crate::model::{Hold, Model, ModelParticle, ModelPlane};
use crate::scene::CollisionForm;
use crate::stress::battery::case::{Case, Group};

/// m/s²
const GRAVITY: f64 = 9.81;

/// With no restitution, some and all; to rest, and thousands of times.
pub fn balls() -> Vec<Case> {
    let mut cases = Vec::new();
    for restitution in [0.0, 0.25, 0.5, 0.9, 1.0] {
        for &collision in CollisionForm::ALL {
            cases.push(Case { collision, ..ball(restitution, 1.0, 1.5, 1500, &format!(", {collision}")) });
        }
    }
    // 0.045 s to the floor; at rest after 3 times that, which no bounce is to be missed for.
    cases.push(ball(0.5, 0.01, 10.0, 10_000, ", long at rest"));
    cases.push(ball(0.5, 0.01, 10.0, 4, ", all bounces and rest in one step"));
    // 3,000 bounces of 0.09 s and less.
    cases.push(ball(0.999, 0.01, 86.0, 86_000, ", 3,000 bounces"));
    cases.push(ball(1.0, 0.01, 271.0, 271_000, ", 3,000 bounces"));
    cases
}

fn ball(restitution: f64, height: f64, duration: f64, steps: u64, how: &str) -> Case {
    let ball = ModelParticle { position: [0.3, -0.2, height], velocity: [0.0; 3], mass: 0.1, hold: Hold::Free };
    let floor = ModelPlane { point: [0.0; 3], normal: [0.0, 0.0, 1.0], restitution };
    let body = Body {
        group: Group::Bounces,
        name: format!("a ball, restitution {restitution}{how}"),
        model: Model { particles: vec![ball], planes: vec![floor], ..Model::default() },
        gravity: [0.0, 0.0, -GRAVITY],
        duration,
        steps,
    };
    body.moving(|time| vec![[0.3, -0.2, above(restitution, height, time)]])
}

/// How high it is after a time, s: from one impact to the next, each with e times the speed of the one before.
fn above(restitution: f64, height: f64, time: f64) -> f64 {
    let mut speed = (2.0 * GRAVITY * height).sqrt();
    let first = speed / GRAVITY;
    if time < first {
        return height - 0.5 * GRAVITY * time * time;
    }
    // Between bounces that grow shorter the end of all is known.
    let end = if restitution < 1.0 { first * (1.0 + restitution) / (1.0 - restitution) } else { f64::INFINITY };
    let mut since = time - first;
    speed *= restitution;
    while time < end && speed > 0.0 {
        let flight = 2.0 * speed / GRAVITY;
        if since < flight {
            return since * (speed - 0.5 * GRAVITY * since);
        }
        since -= flight;
        speed *= restitution;
    }
    0.0
}
