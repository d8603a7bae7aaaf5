//! The smallest program that is a simulation: a pendulum of two springs that touches the floor.

use hooke::{Particle, Plane, Project, SemiImplicitEuler, Spring, World};

/// Room for what it has.
pub type Scene = World<f32, 4, 4, 1>;

/// Nothing if something does not fit.
pub fn fill(world: &mut Scene) -> Option<()> {
    world.set_gravity([0.0, 0.0, -9.81]).ok()?;
    let mut above = world.add_particle(Particle::at([0.0, 0.0, 1.0]).pinned()).ok()?;
    for place in [[0.5, 0.0, 1.0], [1.0, 0.0, 1.0]] {
        let particle = world.add_particle(Particle::at(place).with_mass(0.1)).ok()?;
        world.add_spring(Spring::new([above, particle], 40.0, 0.5).with_damping(0.1)).ok()?;
        above = particle;
    }
    world.add_plane(Plane::through([0.0; 3], [0.0, 0.0, 1.0], 0.5).ok()?).ok()?;
    Some(())
}

/// One step of a millisecond. Whether it was taken.
pub fn step(world: &mut Scene) -> bool {
    world.step(&mut SemiImplicitEuler, &mut Project, 1e-3).is_ok()
}
