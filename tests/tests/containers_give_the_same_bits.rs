//! A world of fixed capacity, one on the heap, and a borrowed view of either step to the same bits.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::{
    Auto, Compensated, Container, ExplicitEuler, Fixed, Hold, ImplicitEuler, ImplicitEulerLinearised, Particle, Plane,
    Project, Real, Reflect, Response, SemiImplicitEuler, Spring, Stepper, Storage, TimeOfImpact, VelocityVerlet, World,
};
use hooke_runner::model::{Hold as ModelHold, Model};
use hooke_runner::simulate::Heap;
use hooke_tests::digest;
use hooke_tests::graphs::{Graph, tilted_box};

type Room = Fixed<32, 64, 8>;

const GRAVITY: [f64; 3] = [0.2, -0.5, -9.7];

/// How a world is filled and stepped.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Container,
    View,
    /// Prepared, and looked at, before all parts are there.
    PreparedEarly,
}

#[test]
fn whatever_the_container() {
    for seed in 0..3 {
        let mut model = Graph::default().model(seed);
        model.planes = tilted_box();
        model.particles.iter_mut().for_each(|particle| particle.velocity = particle.velocity.map(|v| 15.0 * v));
        all_the_same::<f32>(&model);
        all_the_same::<Compensated>(&model);
        all_the_same::<f64>(&model);
    }
}

fn all_the_same<R: Real>(model: &Model) {
    let expected = digests::<R, Heap>(model, Way::Container);
    for way in [Way::Container, Way::View, Way::PreparedEarly] {
        assert_eq!(digests::<R, Room>(model, way), expected);
        assert_eq!(digests::<R, Heap>(model, way), expected);
    }
    // Eighteen ways to step, and no two of them alike: the digests see what they should. (auto is Verlet here but for
    // what flies freely, and its flights are Verlet's too unless hits are located.)
    let mut different = expected.clone();
    different.sort_unstable();
    different.dedup();
    assert_eq!((expected.len(), different.len()), (18, 16));
}

fn digests<R: Real, M: Storage>(model: &Model, way: Way) -> Vec<u64> {
    let mut digests = with_responses::<R, M, _>(model, way, || ExplicitEuler);
    digests.extend(with_responses::<R, M, _>(model, way, || SemiImplicitEuler));
    digests.extend(with_responses::<R, M, _>(model, way, || ImplicitEuler::<R, M>::new(1e-5)));
    digests.extend(with_responses::<R, M, _>(model, way, || ImplicitEulerLinearised::<R, M>::new(1e-5)));
    digests.extend(with_responses::<R, M, _>(model, way, VelocityVerlet::<R, M>::new));
    digests.extend(with_responses::<R, M, _>(model, way, || Auto::<R, M>::new(1e-5)));
    digests
}

fn with_responses<R: Real, M: Storage, S: Stepper<R>>(model: &Model, way: Way, stepper: impl Fn() -> S) -> Vec<u64> {
    vec![
        digest::<R, M>(model, way, stepper(), Reflect),
        digest::<R, M>(model, way, stepper(), Project),
        digest::<R, M>(model, way, stepper(), TimeOfImpact::<R, M>::new()),
    ]
}

fn digest<R: Real, M: Storage>(
    model: &Model,
    way: Way,
    mut stepper: impl Stepper<R>,
    mut response: impl Response<R>,
) -> u64 {
    let mut world = Container::<R, M>::new();
    fill(&mut world, model, way == Way::PreparedEarly);
    for _ in 0..100 {
        let dt = R::from_f64(2e-3);
        let report = if way == Way::View {
            world.view().step(&mut stepper, &mut response, dt)
        } else {
            world.step(&mut stepper, &mut response, dt)
        };
        report.unwrap();
    }
    digest::of(&world.view())
}

fn fill<R: Real, M: Storage>(world: &mut Container<R, M>, model: &Model, prepared_early: bool) {
    let vector = |vector: [f64; 3]| -> R::Vec3 { vector.map(R::Coordinate::from_f64).into() };
    for particle in &model.particles {
        let hold = if particle.hold == ModelHold::Free { Hold::Free } else { Hold::Pinned };
        let (position, velocity) = (vector(particle.position), vector(particle.velocity));
        world.add_particle(Particle { position, velocity, mass: R::from_f64(particle.mass), hold }).unwrap();
    }
    for spring in &model.springs {
        if prepared_early {
            assert!(world.view().states().count() > 0);
        }
        let [stiffness, damping, rest_length] = [spring.stiffness, spring.damping, spring.rest_length].map(R::from_f64);
        world.add_spring(Spring { between: spring.between, stiffness, damping, rest_length }).unwrap();
    }
    for plane in &model.planes {
        let restitution = R::from_f64(plane.restitution);
        let plane = Plane::<R>::through(vector(plane.point), vector(plane.normal), restitution);
        world.add_plane(plane.unwrap()).unwrap();
    }
    world.set_gravity(vector(GRAVITY)).unwrap();
}

/// 14 reals and 13 bytes a particle, 3 reals and 34 bytes a spring, 5 reals a plane, a length for each of 39 columns,
/// and less than 232 bytes for all that there is once, three pointers to what only sleep needs among it; and 12 residuals a particle where there are any.
#[test]
fn a_world_takes_the_bytes_that_are_documented() {
    assert_eq!(size_of::<World<f32, 64, 32, 16>>() - size_of::<World<f32, 0, 0, 0>>(), 64 * 69 + 32 * 46 + 16 * 20);
    assert_eq!(size_of::<World<f64, 64, 32, 16>>() - size_of::<World<f64, 0, 0, 0>>(), 64 * 125 + 32 * 58 + 16 * 40);
    let compensated = size_of::<World<Compensated, 64, 32, 16>>() - size_of::<World<Compensated, 0, 0, 0>>();
    assert_eq!(compensated, 64 * 117 + 32 * 46 + 16 * 20);
    assert!(size_of::<World<f64, 0, 0, 0>>() < 39 * size_of::<usize>() + 232);
}
