//! A world made of a model.

use hooke::{
    AddParticleError, AddPlaneError, AddSpringError, Container, Hold, Particle, Plane, Real, SetError, Sleep, Spring,
};

use super::anchor::Anchor;
use super::heap::Heap;
use crate::model::{Hold as ModelHold, Model, ModelParticle, ModelPlane, ModelSpring};
use crate::scene::Settings;

/// A world of any size.
pub type HeapWorld<R> = Container<R, Heap>;

/// What of a sound model is out of the range of the precision that it is to be stepped in.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{place} cannot be stepped in this precision: {reason}; use precision = \"f64\" or values nearer to 1")]
pub struct BuildError {
    /// `particle 3`, say.
    pub place: String,
    /// What its value becomes.
    pub reason: String,
}

/// The world of a model, under a gravity in m/s².
///
/// # Errors
/// If a value does not survive its rounding to `R`: a mass that becomes 0, say.
pub fn world<R: Real>(model: &Model, gravity: [f64; 3]) -> Result<HeapWorld<R>, BuildError> {
    let mut world = HeapWorld::<R>::new();
    let refused = |place: String| move |reason: String| BuildError { place, reason };
    for (number, particle) in model.particles.iter().enumerate() {
        add_particle(&mut world, particle).map_err(|error| refused(format!("particle {number}"))(error.to_string()))?;
    }
    for (number, spring) in model.springs.iter().enumerate() {
        add_spring(&mut world, spring).map_err(|error| refused(format!("spring {number}"))(error.to_string()))?;
    }
    for (number, plane) in model.planes.iter().enumerate() {
        add_plane(&mut world, plane).map_err(|error| refused(format!("plane {number}"))(error.to_string()))?;
    }
    set_gravity(&mut world, gravity).map_err(|error| refused("gravity".into())(error.to_string()))?;
    Ok(world)
}

/// The world of a model as the settings say: under their gravity, seen from the model's anchor, and with what rests asleep
/// if they let it.
///
/// # Errors
/// Like [`world`].
pub fn world_with<R: Real>(model: &Model, settings: &Settings) -> Result<HeapWorld<R>, BuildError> {
    let mut world = world(&Anchor::of(model).relative(model), settings.gravity)?;
    let sleep = settings.sleep_speed.map(|speed| Sleep::below(R::from_f64(speed)));
    let refused = |error: SetError| BuildError { place: "sleep_speed".to_owned(), reason: error.to_string() };
    world.set_sleep(sleep).map_err(refused)?;
    Ok(world)
}

/// A vector rounded to `R`.
pub(super) fn vector<R: Real>(vector: [f64; 3]) -> R::Vec3 {
    vector.map(R::Coordinate::from_f64).into()
}

fn add_particle<R: Real>(world: &mut HeapWorld<R>, particle: &ModelParticle) -> Result<u32, AddParticleError<R>> {
    let hold = match particle.hold {
        ModelHold::Free => Hold::Free,
        ModelHold::Pinned => Hold::Pinned,
        ModelHold::Track(_) => Hold::Kinematic,
    };
    world.add_particle(Particle {
        position: vector::<R>(particle.position),
        velocity: vector::<R>(particle.velocity),
        mass: R::from_f64(particle.mass),
        hold,
    })
}

fn add_spring<R: Real>(world: &mut HeapWorld<R>, spring: &ModelSpring) -> Result<u32, AddSpringError<R>> {
    world.add_spring(Spring {
        between: spring.between,
        stiffness: R::from_f64(spring.stiffness),
        damping: R::from_f64(spring.damping),
        rest_length: R::from_f64(spring.rest_length),
    })
}

fn add_plane<R: Real>(world: &mut HeapWorld<R>, plane: &ModelPlane) -> Result<u32, AddPlaneError<R>> {
    let restitution = R::from_f64(plane.restitution);
    let plane = Plane::<R>::through(vector::<R>(plane.point), vector::<R>(plane.normal), restitution)?;
    world.add_plane(plane)
}

fn set_gravity<R: Real>(world: &mut HeapWorld<R>, gravity: [f64; 3]) -> Result<(), SetError> {
    world.set_gravity(vector::<R>(gravity))
}
