//! A rope, a cloth and balls of any size.

use hooke::{Particle, Plane, Real, Spring, World};

/// A rope of all the particles that there is room for, held at both ends, undamped. Nothing if there is no room.
pub fn rope<R: Real, const P: usize, const S: usize, const L: usize>(world: &mut World<R, P, S, L>) -> Option<()> {
    let number = R::from_f64;
    world.set_gravity([0.0, 0.0, -9.81].map(R::Coordinate::from_f64)).ok()?;
    for index in 0..P as u32 {
        let place = [0.1 * f64::from(index), 0.0, 1.0].map(R::Coordinate::from_f64);
        let particle = Particle::at(place).with_mass(number(0.125));
        let is_end = index == 0 || index + 1 == P as u32;
        world.add_particle(if is_end { particle.pinned() } else { particle }).ok()?;
        if index > 0 {
            world.add_spring(Spring::new([index - 1, index], number(100.0), number(0.1))).ok()?;
        }
    }
    Some(())
}

/// A damped cloth of `side` × `side` particles, held at two corners: structural, shear and bend springs. Nothing if there is
/// no room.
pub fn cloth<const P: usize, const S: usize, const L: usize>(world: &mut World<f32, P, S, L>, side: u32) -> Option<()> {
    let spacing = 0.1;
    world.set_gravity([0.0, 0.0, -9.81]).ok()?;
    for index in 0..side * side {
        let place = [spacing * (index % side) as f32, spacing * (index / side) as f32, 1.0];
        let particle = Particle::at(place).with_mass(0.02);
        let is_held = index == 0 || index + 1 == side;
        world.add_particle(if is_held { particle.pinned() } else { particle }).ok()?;
    }
    let diagonal = spacing * core::f32::consts::SQRT_2;
    let reaches = [
        (1, 0, spacing),
        (0, 1, spacing),
        (1, 1, diagonal),
        (-1, 1, diagonal),
        (2, 0, 2.0 * spacing),
        (0, 2, 2.0 * spacing),
    ];
    for (right, up, length) in reaches {
        for index in 0..side * side {
            let (u, v) = ((index % side).checked_add_signed(right), index / side + up);
            if let Some(u) = u
                && u < side
                && v < side
            {
                world.add_spring(Spring::new([index, v * side + u], 50.0, length).with_damping(0.01)).ok()?;
            }
        }
    }
    Some(())
}

/// Balls above a floor that lies askew, thrown upwards and aside. Nothing if there is no room.
pub fn balls<const P: usize, const S: usize, const L: usize>(world: &mut World<f32, P, S, L>) -> Option<()> {
    world.set_gravity([0.0, 0.0, -9.81]).ok()?;
    for index in 0..P as u32 {
        let aside = 0.1 * index as f32;
        let ball = Particle::at([aside, 0.0, 0.1 + 0.5 * aside]).with_velocity([0.2, aside, 1.0]);
        world.add_particle(ball.with_mass(0.1)).ok()?;
    }
    world.add_plane(Plane::through([0.0; 3], [0.125, 0.0, 1.0], 0.75).ok()?).ok()?;
    Some(())
}
