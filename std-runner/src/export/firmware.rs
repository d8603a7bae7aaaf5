//! Rust source of constants and of what makes a world of them, for programs without files and without a heap.

use hooke::Real;

use super::refused::{Refused, check};
use super::roles::{Role, response, stepper};
use super::rows::{constant, debug, number, table, vector};
use crate::model::{Hold, Model};
use crate::scene::Settings;
use crate::simulate::{Anchor, Start};

/// A scene as a module of a program: its data in the precision `R`, the functions that fill a world with them, and the
/// length and the end of each step. A world that is stepped so goes through the same bits as in `hooke run`.
///
/// # Errors
/// If the scene has what such a module cannot hold.
pub fn firmware<R: Real>(model: &Model, settings: &Settings, start: &Start, real: &str) -> Result<String, Refused> {
    check(model, settings)?;
    let anchor = Anchor::of(model);
    let model = anchor.relative(model);
    let mut text = head(settings);
    let (stepper, response) = (stepper(settings, start, real), response(settings, real));
    text += &types(real, &stepper, &response);
    let origin = anchor.from_there([0.0; 3]).map(|place| 0.0 - place);
    let counts = [
        ("PARTICLES", model.particles.len(), "Particles."),
        ("SPRINGS", model.springs.len(), "Springs."),
        ("PLANES", model.planes.len(), "Planes."),
    ];
    for (name, count, about) in counts {
        text += &constant(name, "usize", &debug(count), about);
    }
    text += &constant("ORIGIN", "[f64; 3]", &debug(origin), "What positions are relative to, m.");
    text += &constant("GRAVITY", &format!("[{real}; 3]"), &vector::<R>(settings.gravity), "m/s²");
    text += &data::<R>(&model, real);
    text += &schedule::<R>(settings, start, real);
    text += &functions(settings, &stepper, &response);
    Ok(text)
}

fn head(settings: &Settings) -> String {
    format!(
        "//! The scene {:?}, written by `hooke export --firmware`: not to be changed by hand.\n\
         #![allow(dead_code, reason = \"a program takes what it needs\")]\n",
        settings.name
    )
}

fn types(real: &str, stepper: &Role, response: &Role) -> String {
    format!(
        "\nuse hooke::{{Fixed, Particle, Plane, Spring, World}};\n\
         \n/// Room for the scene, and for nothing more.\npub type Capacity = Fixed<PARTICLES, SPRINGS, PLANES>;\n\
         /// A world of that capacity.\npub type Scene = World<{real}, PARTICLES, SPRINGS, PLANES>;\n\
         /// What the scene is stepped by.\npub type Stepper = {};\n\
         /// What happens at its planes.\npub type Response = {};\n",
        stepper.kind, response.kind
    )
}

fn data<R: Real>(model: &Model, real: &str) -> String {
    let particles = model.particles.iter().map(|particle| {
        let (position, velocity) = (vector::<R>(particle.position), vector::<R>(particle.velocity));
        format!("({position}, {velocity}, {}, {})", number::<R>(particle.mass), particle.hold == Hold::Pinned)
    });
    let springs = model.springs.iter().map(|spring| {
        let [stiffness, damping, rest_length] = [spring.stiffness, spring.damping, spring.rest_length].map(number::<R>);
        format!("({:?}, {stiffness}, {damping}, {rest_length})", spring.between)
    });
    let planes = model.planes.iter().map(|plane| {
        let (point, normal) = (vector::<R>(plane.point), vector::<R>(plane.normal));
        format!("({point}, {normal}, {})", number::<R>(plane.restitution))
    });
    let particle = format!("([{real}; 3], [{real}; 3], {real}, bool)");
    let spring = format!("([u32; 2], {real}, {real}, {real})");
    let plane = format!("([{real}; 3], [{real}; 3], {real})");
    table(
        "PARTICLE",
        &particle,
        "PARTICLES",
        "Position (m), velocity (m/s), mass (kg), whether it is pinned.",
        particles,
    ) + &table("SPRING", &spring, "SPRINGS", "Ends, stiffness (N/m), damping (N·s/m), rest length (m).", springs)
        + &table("PLANE", &plane, "PLANES", "Point (m), direction, restitution.", planes)
}

/// When steps end, and how long they are: by the time step, or from frame to frame where particles fly.
fn schedule<R: Real>(settings: &Settings, start: &Start, real: &str) -> String {
    let schedule = &start.schedule;
    let end = match start.time_step {
        Some(time_step) => format!("f64::from(step) * {time_step:?}"),
        None => format!("f64::from(step) / {:?}", settings.frame_rate),
    };
    let (step, length) = match (start.time_step, schedule.short_step()) {
        (None, _) => ("step", format!("(end(step) - end(step.saturating_sub(1))) as {real}")),
        (Some(time_step), None) => ("_step", number::<R>(time_step)),
        (Some(time_step), Some(last)) => {
            ("step", format!("if step < STEPS {{ {} }} else {{ {} }}", number::<R>(time_step), number::<R>(last)))
        }
    };
    constant("STEPS", "u32", &debug(schedule.steps()), "The whole scene.")
        + &format!(
            "\n/// When a step ends, s; step 1 is the first.\n#[must_use]\npub fn end(step: u32) -> f64 {{\n\
             {INDENT}if step < STEPS {{ {end} }} else {{ {:?} }}\n}}\n",
            settings.duration
        )
        + &format!(
            "\n/// How long a step is, s.\n#[must_use]\npub fn length({step}: u32) -> {real} {{\n\
             {INDENT}{length}\n}}\n"
        )
}

fn functions(settings: &Settings, stepper: &Role, response: &Role) -> String {
    let sleep = settings.sleep_speed.map_or_else(String::new, |speed| {
        format!("    world.set_sleep(Some(hooke::Sleep::below({speed:?}))).ok()?;\n")
    });
    format!(
        "\n/// A stepper as the scene says.\n#[must_use]\npub const fn stepper() -> Stepper {{\n    {}\n}}\n\
         \n/// A response as the scene says.\n#[must_use]\npub const fn response() -> Response {{\n    {}\n}}\n\
         \n/// Fills a new world. Nothing if it is not empty.\npub fn fill(world: &mut Scene) -> Option<()> {{\n\
         {INDENT}for (position, velocity, mass, pinned) in &PARTICLE {{\n\
         {INDENT}    let particle = Particle::at(*position).with_velocity(*velocity).with_mass(*mass);\n\
         {INDENT}    world.add_particle(if *pinned {{ particle.pinned() }} else {{ particle }}).ok()?;\n\
         {INDENT}}}\n\
         {INDENT}for (between, stiffness, damping, rest_length) in &SPRING {{\n\
         {INDENT}    world.add_spring(Spring::new(*between, *stiffness, *rest_length).with_damping(*damping)).ok()?;\n\
         {INDENT}}}\n\
         {INDENT}for (point, normal, restitution) in &PLANE {{\n\
         {INDENT}    world.add_plane(Plane::through(*point, *normal, *restitution).ok()?).ok()?;\n\
         {INDENT}}}\n\
         {INDENT}world.set_gravity(GRAVITY).ok()?;\n\
         {sleep}\
         {INDENT}Some(())\n}}\n",
        stepper.value, response.value
    )
}

const INDENT: &str = "    ";
