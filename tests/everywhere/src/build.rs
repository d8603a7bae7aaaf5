//! Making a world: in double precision, of sums, products, quotients and roots alone, so that it starts from the same bits
//! everywhere too.

use core::fmt;

use hooke::{
    AddParticleError, AddPlaneError, AddSpringError, Hold, Particle, Plane, Real, SetError, Sleep, Spring, World,
};

/// Room for the largest of the worlds.
pub const PARTICLES: usize = 272;
/// Likewise.
pub const SPRINGS: usize = 1000;
/// Likewise.
pub const PLANES: usize = 4;

/// The world that all of them are built in.
pub type Room<R> = World<R, PARTICLES, SPRINGS, PLANES>;

/// Why a world could not be built: a mistake in here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BuildError<R: Real> {
    Particle(AddParticleError<R>),
    Spring(AddSpringError<R>),
    Plane(AddPlaneError<R>),
    Set(SetError),
}

impl<R: Real> fmt::Display for BuildError<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Particle(error) => error.fmt(f),
            Self::Spring(error) => error.fmt(f),
            Self::Plane(error) => error.fmt(f),
            Self::Set(error) => error.fmt(f),
        }
    }
}

pub type Built<R, T = ()> = Result<T, BuildError<R>>;

/// A world that is being built.
pub struct Builder<R: Real> {
    pub world: Room<R>,
    /// Where particles were put, m.
    places: [[f64; 3]; PARTICLES],
}

impl<R: Real> Builder<R> {
    pub fn new(gravity: [f64; 3]) -> Built<R, Self> {
        let mut world = Room::new();
        world.set_gravity(gravity.map(coordinate::<R>)).map_err(BuildError::Set)?;
        Ok(Self { world, places: [[0.0; 3]; PARTICLES] })
    }

    /// A particle of a mass (kg), with a velocity (m/s).
    pub fn particle(&mut self, position: [f64; 3], velocity: [f64; 3], mass: f64, hold: Hold) -> Built<R, u32> {
        let particle = Particle {
            position: position.map(coordinate::<R>).into(),
            velocity: velocity.map(coordinate::<R>).into(),
            mass: R::from_f64(mass),
            hold,
        };
        let number = self.world.add_particle(particle).map_err(BuildError::Particle)?;
        if let Some(place) = self.places.get_mut(number as usize) {
            *place = position;
        }
        Ok(number)
    }

    /// A spring as long as `stretched` times its rest length, with a stiffness (N/m) and a damping (N·s/m).
    pub fn spring(&mut self, between: [u32; 2], stiffness: f64, damping: f64, stretched: f64) -> Built<R> {
        let [a, b] = between.map(|number| self.places.get(number as usize).copied().unwrap_or_default());
        let square: f64 = a.iter().zip(b).map(|(a, b)| (b - a) * (b - a)).sum();
        let rest_length = Real::sqrt(square) / stretched;
        let spring = Spring::new(between, R::from_f64(stiffness), R::from_f64(rest_length));
        self.world.add_spring(spring.with_damping(R::from_f64(damping))).map_err(BuildError::Spring)?;
        Ok(())
    }

    /// A plane through a point (m).
    pub fn plane(&mut self, point: [f64; 3], normal: [f64; 3], restitution: f64) -> Built<R> {
        let [point, normal] = [point, normal].map(|vector| vector.map(coordinate::<R>));
        let plane = Plane::through(point, normal, R::from_f64(restitution)).map_err(BuildError::Plane)?;
        self.world.add_plane(plane).map_err(BuildError::Plane)?;
        Ok(())
    }

    /// Islands slower than this (m/s) for so long (s) may sleep.
    pub fn sleep(&mut self, speed: f64, time: f64) -> Built<R> {
        let sleep = Sleep::below(R::from_f64(speed)).after(R::from_f64(time));
        self.world.set_sleep(Some(sleep)).map_err(BuildError::Set)
    }
}

fn coordinate<R: Real>(value: f64) -> R::Coordinate {
    R::Coordinate::from_f64(value)
}
