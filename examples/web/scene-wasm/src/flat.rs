//! A model as arrays that a page can lay views over.

use hooke_scene::Settings;
use hooke_scene::model::{CameraChoice, Hold, Model};
use hooke_scene::{CollisionForm, Precision, StepperName, TimeStep};
use serde::Serialize;

/// What comes before the arrays, as JSON.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Header<'a> {
    name: &'a str,
    gravity: [f64; 3],
    duration: f64,
    time_step: TimeStep,
    frame_rate: f64,
    stepper: StepperName,
    precision: Precision,
    tolerance: f64,
    collision: CollisionForm,
    sleep_speed: Option<f64>,
    max_error: Option<f64>,
    camera: &'a CameraChoice,
    particles: usize,
    springs: usize,
    planes: usize,
    /// How many keys each track has.
    tracks: Vec<usize>,
}

/// The length of the header (`u32`, then the header, then spaces up to a multiple of 8 bytes), and the arrays one behind
/// the other: `f64` positions, velocities and masses; stiffness, damping and rest length of springs; point, normal and
/// restitution of each plane; time and place of each key; `u32` ends of springs; `i32` holds (−1 free, −2 pinned, or a track).
pub(crate) fn flat(settings: &Settings, model: &Model) -> Vec<u8> {
    let header = Header {
        name: &settings.name,
        gravity: settings.gravity,
        duration: settings.duration,
        time_step: settings.time_step,
        frame_rate: settings.frame_rate,
        stepper: settings.stepper,
        precision: settings.precision,
        tolerance: settings.tolerance,
        collision: settings.collision,
        sleep_speed: settings.sleep_speed,
        max_error: settings.max_error.map(|asked| asked.error),
        camera: &settings.camera,
        particles: model.particles.len(),
        springs: model.springs.len(),
        planes: model.planes.len(),
        tracks: model.tracks.iter().map(|track| track.keys.len()).collect(),
    };
    // Texts and numbers: nothing in it can fail.
    let mut header = serde_json::to_vec(&header).unwrap_or_default();
    header.resize((header.len() + 4).next_multiple_of(8) - 4, b' ');
    let mut out = (header.len() as u32).to_le_bytes().to_vec();
    out.append(&mut header);

    let particles = &model.particles;
    numbers(&mut out, particles.iter().flat_map(|particle| particle.position));
    numbers(&mut out, particles.iter().flat_map(|particle| particle.velocity));
    numbers(&mut out, particles.iter().map(|particle| particle.mass));
    numbers(&mut out, model.springs.iter().map(|spring| spring.stiffness));
    numbers(&mut out, model.springs.iter().map(|spring| spring.damping));
    numbers(&mut out, model.springs.iter().map(|spring| spring.rest_length));
    for plane in &model.planes {
        numbers(&mut out, plane.point.into_iter().chain(plane.normal).chain([plane.restitution]));
    }
    for (time, place) in model.tracks.iter().flat_map(|track| &track.keys) {
        numbers(&mut out, [*time].into_iter().chain(*place));
    }
    out.extend(model.springs.iter().flat_map(|spring| spring.between).flat_map(u32::to_le_bytes));
    out.extend(particles.iter().map(|particle| held(particle.hold)).flat_map(i32::to_le_bytes));
    out
}

fn numbers(out: &mut Vec<u8>, numbers: impl IntoIterator<Item = f64>) {
    out.extend(numbers.into_iter().flat_map(f64::to_le_bytes));
}

fn held(hold: Hold) -> i32 {
    match hold {
        Hold::Free => -1,
        Hold::Pinned => -2,
        // Tracks are as many as particles that are written out one by one.
        Hold::Track(track) => track as i32,
    }
}
