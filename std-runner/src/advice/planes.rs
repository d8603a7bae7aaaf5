//! Particles and planes that do not go together.

use super::{Advice, Subject, Topic};
use crate::model::{Hold, ModelPlane};
use crate::scene::CollisionForm;
use crate::simulate::chooses_steps;
use crate::units::metres;

/// What lies less than this part of its coordinates below a plane lies on it.
const ON_PLANE: f64 = 1e-6;

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn height(plane: &ModelPlane, position: [f64; 3]) -> f64 {
    dot(plane.normal, position) - dot(plane.normal, plane.point)
}

/// Free particles that start on the wrong side of a plane.
pub(super) fn beyond(subject: &Subject<'_>) -> Vec<Advice> {
    let of_plane = |(number, plane): (usize, &ModelPlane)| {
        let free = (0_usize..).zip(&subject.model.particles).filter(|(_, particle)| particle.hold == Hold::Free);
        let below = free.clone().filter_map(|(index, particle)| {
            let scale = particle.position.iter().fold(1.0_f64, |scale, coordinate| scale.max(coordinate.abs()));
            let depth = -height(plane, particle.position);
            (depth > ON_PLANE * scale).then_some((index, depth))
        });
        let count = below.clone().count();
        let (first, _) = below.clone().next()?;
        let (deepest, depth) = below.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let (count, remedy) = if count == free.count() {
            ("every free particle".to_owned(), "turn its normal round: it points to the side where particles may be")
        } else {
            let particles = if count == 1 { "particle" } else { "particles" };
            (format!("{count} free {particles}, the first is number {first},"), "move them, or the plane")
        };
        let starts = if count.starts_with("1 ") || count.starts_with("every") { "starts" } else { "start" };
        let message =
            format!("{count} {starts} beyond plane {number}; the deepest is particle {deepest}, by {}", metres(depth));
        Some(Advice { topic: Topic::BeyondPlane, message, remedy: remedy.to_owned() })
    };
    subject.model.planes.iter().enumerate().filter_map(of_plane).collect()
}

/// `reflect` turns velocities round and leaves positions alone: what has come to rest falls a little in each step.
pub(super) fn sinking(subject: &Subject<'_>) -> Option<Advice> {
    let gravity = subject.settings.gravity;
    if subject.settings.collision != CollisionForm::Reflect {
        return None;
    }
    let rests = |plane: &ModelPlane| dot(plane.normal, gravity) < 0.0 && plane.restitution < 1.0;
    let (number, _) = subject.model.planes.iter().enumerate().find(|(_, plane)| rests(plane))?;
    let message = format!("with reflect, what comes to rest on plane {number} sinks slowly through it");
    let remedy = "use --collision project, or time-of-impact".to_owned();
    Some(Advice { topic: Topic::SinkingAtRest, message, remedy })
}

/// Forms that look for hits at the ends of steps, where those are from frame to frame.
pub(super) fn between_frames(subject: &Subject<'_>) -> Option<Advice> {
    let Subject { model, settings, .. } = subject;
    let (stepper, collision) = (settings.stepper, settings.collision);
    if model.planes.is_empty() || collision == CollisionForm::TimeOfImpact || !chooses_steps(settings) {
        return None;
    }
    let message = format!(
        "{collision} looks for hits at the end of a step, and where {stepper} chooses its steps that is the next frame"
    );
    let remedy = "use --collision time-of-impact, or a --time-step".to_owned();
    Some(Advice { topic: Topic::HitsBetweenFrames, message, remedy })
}
