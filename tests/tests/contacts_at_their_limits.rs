//! Contacts where something is extreme: the distances, the number of hits, the planes, the times that are asked for.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::{
    AddPlaneError, Auto, Fixed, ImplicitEuler, Ledger, Particle, Plane, Real, SemiImplicitEuler, Spring, StepReport,
    Stepper, TimeOfImpact, VelocityVerlet, World,
};

type Room = Fixed<128, 128, 4>;
type Large<R> = World<R, 128, 128, 4>;

fn run<R: Real>(world: &mut Large<R>, stepper: &mut (impl Stepper<R> + ?Sized), dt: f64, steps: u32) -> StepReport {
    let mut response = TimeOfImpact::<R, Room>::new();
    let mut total = StepReport::default();
    for _ in 0..steps {
        total.add(&world.step(stepper, &mut response, R::from_f64(dt)).unwrap());
    }
    total
}

fn auto<R: Real>() -> Auto<R, Room> {
    Auto::new(1e-9)
}

fn vector<R: Real>(vector: [f64; 3]) -> [R::Coordinate; 3] {
    vector.map(R::Coordinate::from_f64)
}

fn fall<R: Real>() -> Large<R> {
    let mut world = Large::new();
    world.set_gravity(vector::<R>([0.0, 0.0, -10.0])).unwrap();
    world
}

fn plane<R: Real>(point: [f64; 3], normal: [f64; 3], restitution: f64) -> Plane<R> {
    Plane::through(vector::<R>(point), vector::<R>(normal), R::from_f64(restitution)).unwrap()
}

/// What one particle touches does not depend on where another one is.
#[test]
fn a_far_away_particle_changes_no_contact() {
    let drop = |far: f32| {
        let mut world = fall::<f32>();
        let ball = world.add_particle(Particle::at([0.0, 0.0, 1.0])).unwrap();
        world.add_particle(Particle::at([far, 0.0, 1.0]).pinned()).unwrap();
        world.add_plane(plane([0.0; 3], [0.0, 0.0, 1.0], 0.5)).unwrap();
        run(&mut world, &mut auto(), 0.01, 120);
        world.position(ball).unwrap()
    };
    assert_eq!(drop(1e6), drop(1.0));
}

/// More bounces than are followed, on whichever side the last one is: what is stopped goes through no plane.
#[test]
fn too_many_bounces_end_between_the_plates() {
    for height in [5e-4, 1e-3] {
        let mut world = fall::<f64>();
        let ball = world.add_particle(Particle::at([0.0, 0.0, 2e-4]).with_velocity([1.0, 0.0, 1000.0])).unwrap();
        let other = if height == 1e-3 { [0.3, 0.0, -1000.0] } else { [0.3, 0.0, 1000.0] };
        let other = world.add_particle(Particle::at([0.0, 1.0, 2e-4]).with_velocity(other)).unwrap();
        world.add_plane(plane([0.0; 3], [0.0, 0.0, 1.0], 1.0)).unwrap();
        world.add_plane(plane([0.0, 0.0, height], [0.0, 0.0, -1.0], 1.0)).unwrap();
        world.add_plane(plane([0.5, 0.0, 0.0], [-1.0, 0.0, 0.0], 1.0)).unwrap();
        for stepper in [true, false] {
            for _ in 0..4 {
                let report = if stepper {
                    run(&mut world, &mut auto(), 1.0, 1)
                } else {
                    run(&mut world, &mut VelocityVerlet::<f64, Room>::new(), 1.0, 1)
                };
                assert!(report.hits <= 20_000);
                for particle in [ball, other] {
                    let position = world.position(particle).unwrap();
                    assert!((-1e-15..=height + 1e-15).contains(&position.z) && position.x <= 0.5 + 1e-15, "{position}");
                }
            }
        }
    }
}

/// More hits in one step than it may be cut by: what is stopped is put back on the plane, and the ledger tells.
#[test]
fn a_chain_that_lands_in_one_step_lands_on_the_plane() {
    fn land(mut stepper: impl Stepper<f64>) -> (f64, u32, f64) {
        let mut world = fall::<f64>();
        for link in 0..120 {
            let place = [0.01 * f64::from(link), 0.0, 0.5 + 3e-4 * f64::from(link)];
            world.add_particle(Particle::at(place).with_velocity([0.0, 0.0, -5.0])).unwrap();
        }
        for link in 1..120 {
            world.add_spring(Spring::new([link - 1, link], 5.0, 0.01).with_damping(0.01)).unwrap();
        }
        world.add_plane(plane([0.0; 3], [0.0, 0.0, 1.0], 0.5)).unwrap();
        let mut response = TimeOfImpact::<f64, Room>::new();
        let mut ledger = Ledger::open(&world.view());
        let (mut lowest, mut capped) = (0.0_f64, 0);
        for _ in 0..60 {
            capped += world.view().step_observed(&mut stepper, &mut response, 1e-2, &mut ledger).unwrap().capped;
            lowest = (0..120).fold(lowest, |lowest, link| lowest.min(world.position(link).unwrap().z));
        }
        let balance = ledger.balance(&world.view());
        (lowest, capped, balance.remainder().abs() / balance.scale())
    }
    let verlet = land(VelocityVerlet::<f64, Room>::new());
    let eulers = [land(SemiImplicitEuler), land(ImplicitEuler::<f64, Room>::new(1e-9))];
    for (lowest, capped, _) in [verlet, eulers[0], eulers[1]] {
        assert!(lowest > -1e-12 && capped > 0, "{lowest} m, {capped} stopped");
    }
    assert!(verlet.2 < 1e-6, "{}", verlet.2);
}

#[test]
fn a_plane_that_is_there_twice_is_one_plane() {
    let slide = |planes: u32, normal: [f64; 3]| {
        let mut world = fall::<f64>();
        let ball = world.add_particle(Particle::at([0.0; 3])).unwrap();
        for _ in 0..planes {
            world.add_plane(plane([0.0; 3], normal, 0.5)).unwrap();
        }
        run(&mut world, &mut auto(), 0.1, 10);
        world.position(ball).unwrap()
    };
    for tilt in 0..20 {
        let normal = [0.3 + 0.1 * f64::from(tilt), 0.2, 1.0];
        let [once, twice] = [slide(1, normal), slide(2, normal)];
        assert!((once - twice).length() <= 1e-14 * once.length() && once.length() > 0.1, "{normal:?}: {once}, {twice}");
    }
}

/// Fast along a ceiling and pulled off it slowly: the pull of a step is smaller than a rounding of the speed.
#[test]
fn what_slides_along_a_ceiling_falls_off_it() {
    fn drop(mut stepper: impl Stepper<f32>, tied: bool) -> f32 {
        let mut world = Large::<f32>::new();
        world.set_gravity([0.0, 0.0, -0.2]).unwrap();
        for side in [0.0, 0.1] {
            world.add_particle(Particle::at([0.3, side, 0.0]).with_velocity([10.0, 0.0, 0.0])).unwrap();
        }
        if tied {
            world.add_spring(Spring::new([0, 1], 10.0, 0.1)).unwrap();
        }
        world.add_plane(plane([0.0; 3], [0.0, 0.0, -1.0], 0.5)).unwrap();
        run(&mut world, &mut stepper, 1e-4, 10_000);
        world.position(0).unwrap().z
    }
    for tied in [true, false] {
        let heights =
            [drop(auto(), tied), drop(VelocityVerlet::<f32, Room>::new(), tied), drop(SemiImplicitEuler, tied)];
        // ½ g t², to the 10,000 roundings of single precision.
        assert!(heights.iter().all(|z| (z + 0.1).abs() < 1e-4), "{heights:?}");
    }
}

/// Up a slope, round and down again, on an elastic plane too: it slides, and the roundings of its way make no bounces.
#[test]
fn what_slides_does_not_bounce() {
    fn slide<R: Real>(mut stepper: impl Stepper<R>, restitution: f64) {
        let (sine, cosine) = 0.4_f64.sin_cos();
        let mut world = fall::<R>();
        let up = vector::<R>([-3.0 * cosine, 0.0, 3.0 * sine]);
        let ball = world.add_particle(Particle::at(vector::<R>([0.0; 3])).with_velocity(up)).unwrap();
        world.add_plane(plane([0.0; 3], [sine, 0.0, cosine], restitution)).unwrap();
        let report = run(&mut world, &mut stepper, 1e-3, 50_000);
        assert_eq!(report.hits, 0);
        let [x, _, z]: [R::Coordinate; 3] = world.position(ball).unwrap().into();
        let (x, z) = (x.to_f64(), z.to_f64());
        let gap = x * sine + z * cosine;
        assert!(gap.abs() <= 4.0 * R::EPSILON.to_f64() * (x.abs() + z.abs()), "{gap}");
    }
    for restitution in [0.5, 1.0] {
        slide::<f32>(VelocityVerlet::<f32, Room>::new(), restitution);
        slide::<f64>(VelocityVerlet::<f64, Room>::new(), restitution);
        slide::<f32>(SemiImplicitEuler, restitution);
        slide::<f64>(SemiImplicitEuler, restitution);
        slide::<f32>(auto(), restitution);
    }
}

/// A corner that gravity presses into, one of whose planes is elastic: the others take the energy, and it ends in rest.
#[test]
fn a_corner_with_one_elastic_plane_comes_to_rest() {
    let mut world = fall::<f64>();
    world.add_particle(Particle::at([0.3, 0.2, 1.0])).unwrap();
    for (normal, restitution) in [([1.0, 0.2, 0.9], 0.3), ([-1.0, 0.4, 0.8], 0.0), ([0.1, -1.0, 0.02], 1.0)] {
        world.add_plane(plane([0.1, 0.4, -0.2], normal, restitution)).unwrap();
    }
    let report = run(&mut world, &mut VelocityVerlet::<f64, Room>::new(), 5e-3, 2000);
    assert_eq!(report.capped, 0);
    assert_eq!(run(&mut world, &mut VelocityVerlet::<f64, Room>::new(), 5e-3, 100).hits, 0);
}

/// Looking ahead is looking only: what is met on the way is reported by the step, and nobody has to ask in order.
#[test]
fn looking_ahead_changes_nothing() {
    let hits = |look: &dyn Fn(f64) -> Vec<f64>| {
        let mut world = fall::<f64>();
        let ball = world.add_particle(Particle::at([0.0, 0.0, 1.0])).unwrap();
        world.add_plane(plane([0.0; 3], [0.0, 0.0, 1.0], 0.5)).unwrap();
        let mut stepper = auto();
        let mut hits = 0;
        for _ in 0..11 {
            for time in look(world.time()) {
                world.view().free_at(&mut stepper, time).map(Iterator::count);
            }
            hits += run(&mut world, &mut stepper, 0.1, 1).hits;
        }
        (hits, world.position(ball).unwrap().z)
    };
    let (bounces, height) = hits(&|_| Vec::new());
    assert_eq!(bounces, 2);
    for look in
        [|now| vec![now + 0.03, now + 0.09], |now| vec![now + 0.09, now + 0.01], |now| vec![now + 5.0, now - 1.0]]
    {
        let (seen, reached) = hits(&look);
        assert_eq!(seen, bounces);
        assert!((reached - height).abs() < 1e-13, "{reached} for {height}");
    }
}

#[test]
fn what_is_driven_elsewhere_goes_on_from_there() {
    let mut world = Large::<f64>::new();
    let driven = world.add_particle(Particle::at([0.0, 0.0, 1.0]).kinematic()).unwrap();
    let mut stepper = auto();
    run(&mut world, &mut stepper, 0.1, 2);
    world.drive(driven, [5.0, 0.0, 1.0], [0.0; 3]).unwrap();
    run(&mut world, &mut stepper, 0.1, 2);
    assert_eq!(world.position(driven).unwrap().x, 5.0);
}

#[test]
fn a_plane_too_far_away_for_its_precision_is_refused() {
    let error = Plane::<f32>::through([3e38; 3], [1.0; 3], 0.5);
    assert_eq!(error, Err(AddPlaneError::Point));
}

/// A solution is not taken for one because its residual's square is too small for single precision.
#[test]
fn grains_of_dust_are_solved_for_like_anything_else() {
    let swing = |mass: f32| {
        let mut world = Large::<f32>::new();
        world.add_particle(Particle::at([0.0; 3]).pinned()).unwrap();
        let first = Particle::at([1e-6, 0.0, 0.0]).with_mass(mass).with_velocity([0.0, 1e-6, 0.0]);
        world.add_particle(first).unwrap();
        world.add_particle(Particle::at([2e-6, 1e-6, 0.0]).with_mass(mass)).unwrap();
        for link in [0, 1] {
            world.add_spring(Spring::new([link, link + 1], 100.0 * mass, 0.9e-6)).unwrap();
        }
        run(&mut world, &mut ImplicitEuler::<f32, Room>::new(1e-6), 0.05, 20);
        world.position(2).unwrap() * 1e6
    };
    // The same problem in other units of mass, apart from what a tolerance of 1e-6 leaves in 20 steps.
    let (light, heavy) = (swing(1e-15), swing(1.0));
    assert!((light - heavy).length() < 1e-4, "{light} for {heavy}");
}
