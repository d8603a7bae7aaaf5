//! What cannot be is refused with an error that says what, and the world is as it was, to the bit.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::{
    AddParticleError, AddPlaneError, AddSpringError, Hold, Particle, Plane, Reflect, SemiImplicitEuler, SetError,
    Spring, StepError, World,
};
use hooke_tests::digest;

type Small = World<f64, 3, 2, 1>;

const NOT_POSITIVE: [f64; 5] = [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const NOT_FINITE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const NEGATIVE: [f64; 4] = [-1e-300, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// Full but for one particle and one spring.
fn world() -> Small {
    let mut world = Small::new();
    world.add_particle(Particle::at([0.0, 0.0, 1.0]).pinned()).unwrap();
    world.add_particle(Particle::at([0.3, 0.0, 0.5]).with_velocity([0.1, -0.2, 0.4]).with_mass(0.3)).unwrap();
    world.add_spring(Spring::new([0, 1], 30.0, 0.4).with_damping(0.1)).unwrap();
    world.add_plane(Plane::through([0.0; 3], [0.0, 0.0, 1.0], 0.5).unwrap()).unwrap();
    world.set_gravity([0.0, 0.0, -9.81]).unwrap();
    world
}

/// Everything that can be told from outside, now and after ten steps.
fn fingerprint(world: &mut Small) -> [u64; 3] {
    let before = digest::of(&world.view());
    let time = world.time().to_bits();
    for _ in 0..10 {
        world.step(&mut SemiImplicitEuler, &mut Reflect, 1e-3).unwrap();
    }
    [before, time, digest::of(&world.view())]
}

/// Whatever the attempt is, a world on which it was made goes on like one on which it was not.
fn unchanged<E>(attempt: impl FnOnce(&mut Small) -> E) -> E {
    let mut tried = world();
    let error = attempt(&mut tried);
    assert_eq!(fingerprint(&mut tried), fingerprint(&mut world()));
    error
}

/// NaN is not equal to itself: errors are compared as they print.
fn same<E: std::fmt::Debug>(found: E, expected: E) {
    assert_eq!(format!("{found:?}"), format!("{expected:?}"));
}

#[test]
fn particles() {
    let sound = Particle::<f64>::at([1.0, 2.0, 3.0]);
    for mass in NOT_POSITIVE {
        same(unchanged(|world| world.add_particle(sound.with_mass(mass))), Err(AddParticleError::Mass(mass)));
    }
    // Its inverse is infinite.
    same(unchanged(|world| world.add_particle(sound.with_mass(1e-310))), Err(AddParticleError::Mass(1e-310)));
    for wrong in NOT_FINITE {
        for vector in [[wrong, 0.0, 0.0], [0.0, wrong, 0.0], [0.0, 0.0, wrong]] {
            let error = unchanged(|world| world.add_particle(Particle::at(vector)));
            same(error, Err(AddParticleError::NotFinite));
            let error = unchanged(|world| world.add_particle(sound.with_velocity(vector)));
            same(error, Err(AddParticleError::NotFinite));
        }
    }
    let mut full = World::<f64, 1, 0, 0>::new();
    assert_eq!(full.add_particle(sound), Ok(0));
    let back = sound.with_mass(7.0).with_velocity([1.0, 0.0, 0.0]).kinematic();
    assert_eq!(full.add_particle(back), Err(AddParticleError::Full(back)));
    assert_eq!(full.view().states().count(), 1);
}

#[test]
fn springs() {
    let sound = Spring::<f64>::new([0, 1], 5.0, 0.1);
    for value in NEGATIVE {
        let spring = Spring { stiffness: value, ..sound };
        same(unchanged(|world| world.add_spring(spring)), Err(AddSpringError::Stiffness(value)));
        let spring = Spring { damping: value, ..sound };
        same(unchanged(|world| world.add_spring(spring)), Err(AddSpringError::Damping(value)));
        let spring = Spring { rest_length: value, ..sound };
        same(unchanged(|world| world.add_spring(spring)), Err(AddSpringError::RestLength(value)));
    }
    for (between, missing) in [([0, 2], 2), ([9, 0], 9), ([u32::MAX, 1], u32::MAX)] {
        let spring = Spring { between, ..sound };
        same(unchanged(|world| world.add_spring(spring)), Err(AddSpringError::NoSuchParticle(missing)));
    }
    let spring = Spring { between: [1, 1], ..sound };
    same(unchanged(|world| world.add_spring(spring)), Err(AddSpringError::SameParticle(1)));
    let mut full = world();
    assert_eq!(full.add_spring(sound), Ok(1));
    assert_eq!(full.add_spring(spring_of(9.0)), Err(AddSpringError::Full(spring_of(9.0))));
    assert_eq!(full.view().plan().springs, 2);
}

fn spring_of(stiffness: f64) -> Spring<f64> {
    Spring::new([1, 0], stiffness, 0.2).with_damping(0.3)
}

#[test]
fn planes() {
    let through = |point: [f64; 3], normal: [f64; 3], restitution| Plane::<f64>::through(point, normal, restitution);
    for wrong in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
        same(through([0.0; 3], [0.0, 0.0, 1.0], wrong), Err(AddPlaneError::Restitution(wrong)));
    }
    for wrong in NOT_FINITE {
        same(through([0.0, wrong, 0.0], [0.0, 0.0, 1.0], 0.5), Err(AddPlaneError::Point));
        same(through([0.0; 3], [0.0, wrong, 1.0], 0.5), Err(AddPlaneError::Normal));
    }
    same(through([0.0; 3], [0.0; 3], 0.5), Err(AddPlaneError::Normal));
    // Tiny and huge normals have directions all the same.
    for length in [1e-300, 1e300] {
        let plane = through([0.0, 2.0, 0.0], [0.0, length, 0.0], 0.5).unwrap();
        assert_eq!((plane.normal(), plane.offset()), ([0.0, 1.0, 0.0].into(), 2.0));
    }
    let back = through([1.0; 3], [1.0, 2.0, 3.0], 0.25).unwrap();
    same(unchanged(|world| world.add_plane(back)), Err(AddPlaneError::Full(back)));
}

#[test]
fn values() {
    for wrong in NOT_FINITE {
        let vector = [0.0, wrong, 0.0];
        same(unchanged(|world| world.set_gravity(vector)), Err(SetError::NotFinite));
        same(unchanged(|world| world.set_position(1, vector)), Err(SetError::NotFinite));
        same(unchanged(|world| world.set_velocity(1, vector)), Err(SetError::NotFinite));
        same(unchanged(|world| world.drive(1, vector, [0.0; 3])), Err(SetError::NotFinite));
        same(unchanged(|world| world.drive(1, [0.0; 3], vector)), Err(SetError::NotFinite));
    }
    for missing in [2, u32::MAX] {
        let error = Err(SetError::NoSuchParticle(missing));
        same(unchanged(|world| world.set_position(missing, [0.0; 3])), error);
        same(unchanged(|world| world.set_velocity(missing, [0.0; 3])), error);
        same(unchanged(|world| world.drive(missing, [0.0; 3], [0.0; 3])), error);
        same(unchanged(|world| world.set_hold(missing, Hold::Pinned)), error);
        let mut world = world();
        assert_eq!((world.position(missing), world.velocity(missing)), (None, None));
        assert_eq!((world.view().position(missing), world.view().velocity(missing)), (None, None));
    }
}

#[test]
fn time_steps() {
    for dt in NOT_POSITIVE {
        let error = unchanged(|world| world.step(&mut SemiImplicitEuler, &mut Reflect, dt));
        assert_eq!(error, Err(StepError::TimeStep));
    }
    for end in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = unchanged(|world| world.view().step_to(&mut SemiImplicitEuler, &mut Reflect, 1e-3, end, &mut ()));
        assert_eq!(error, Err(StepError::TimeStep), "{end}");
    }
}
