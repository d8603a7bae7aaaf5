//! Coming to rest on planes, staying there, and leaving when something pulls.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::{
    Auto, Fixed, Hold, Ledger, Particle, Plane, Response, SemiImplicitEuler, Spring, StepReport, Stepper, TimeOfImpact,
    VelocityVerlet, World,
};

type Storage = Fixed<8, 8, 8>;
type Small = World<f64, 8, 8, 8>;

const GRAVITY: [f64; 3] = [0.0, 0.0, -10.0];

fn plane(point: [f64; 3], normal: [f64; 3], restitution: f64) -> Plane<f64> {
    Plane::through(point, normal, restitution).unwrap()
}

fn run(world: &mut Small, stepper: &mut impl Stepper<f64>, dt: f64, steps: u32) -> StepReport {
    let mut response = TimeOfImpact::<f64, Storage>::new();
    response.fit(world.view().plan()).unwrap();
    let mut total = StepReport::default();
    for _ in 0..steps {
        total.add(&world.step(stepper, &mut response, dt).unwrap());
    }
    total
}

fn auto() -> Auto<f64, Storage> {
    Auto::new(1e-9)
}

/// A ball on a level floor that a slack spring hangs over; the pin is then lifted.
#[test]
fn a_particle_at_rest_leaves_when_a_spring_pulls() {
    let mut world = Small::new();
    world.set_gravity(GRAVITY).unwrap();
    let pin = world.add_particle(Particle::at([0.0, 0.0, 1.0]).kinematic()).unwrap();
    let ball = world.add_particle(Particle::at([0.0, 0.0, 0.3])).unwrap();
    world.add_spring(Spring::new([pin, ball], 50.0, 1.0).with_damping(1.0)).unwrap();
    world.add_plane(plane([0.0; 3], [0.0, 0.0, 1.0], 0.4)).unwrap();
    let mut verlet = VelocityVerlet::<f64, Storage>::new();

    // Compressed to 0.7 m at first, and at its rest length on the floor: the ball lies there.
    run(&mut world, &mut verlet, 1e-3, 3000);
    let rested = world.position(ball).unwrap();
    assert!(rested.z.abs() < 1e-13, "at rest at {rested}");
    assert!(world.velocity(ball).unwrap().length() < 1e-13);
    let report = run(&mut world, &mut verlet, 1e-3, 1000);
    assert_eq!(report.hits, 0, "what lies does not bounce");

    // The pin rises by 1 m/s. The weight of 10 N is balanced by 50 N/m and by the damping's 1 N at 0.18 m.
    world.set_velocity(pin, [0.0, 0.0, 1.0]).unwrap();
    run(&mut world, &mut verlet, 1e-3, 175);
    assert!(world.position(ball).unwrap().z.abs() < 1e-13, "not strong enough yet");
    run(&mut world, &mut verlet, 1e-3, 60);
    assert!(world.position(ball).unwrap().z > 1e-4, "and now it is");
}

/// No energy appears or vanishes while something lies: the plane does no work.
#[test]
fn rest_costs_no_energy() {
    let mut world = Small::new();
    world.set_gravity(GRAVITY).unwrap();
    let left = world.add_particle(Particle::at([-0.5, 0.0, 0.0])).unwrap();
    let right = world.add_particle(Particle::at([0.6, 0.0, 0.0])).unwrap();
    world.add_spring(Spring::new([left, right], 30.0, 1.0)).unwrap();
    world.add_plane(plane([0.0; 3], [0.0, 0.0, 1.0], 0.4)).unwrap();
    let mut verlet = VelocityVerlet::<f64, Storage>::new();
    let mut response = TimeOfImpact::<f64, Storage>::new();
    let mut ledger = Ledger::open(&world.view());
    for _ in 0..5000 {
        let report = world.view().step_observed(&mut verlet, &mut response, 1e-3, &mut ledger).unwrap();
        assert_eq!(report.hits, 0);
    }
    // Two masses on a spring slide and oscillate: Verlet's energy oscillates by up to (ω dt)²/4 = 1.5e-5 of it.
    let balance = ledger.balance(&world.view());
    assert!(balance.remainder().abs() < 2e-5 * balance.opened_with, "{balance:?}");
    assert!(world.position(left).unwrap().z.abs() < 1e-13);
}

/// An elastic particle bounces at most ⌈π/θ⌉ times in a wedge of angle θ without gravity.
#[test]
fn an_elastic_particle_leaves_a_wedge() {
    for degrees in [10.0_f64, 25.0, 36.0, 60.0, 90.0] {
        let theta = degrees.to_radians();
        let mut world = Small::new();
        let inside = [(0.4 * theta).cos(), 0.0, (0.4 * theta).sin()];
        let particle = Particle::at(inside.map(|x| 3.0 * x)).with_velocity([-5.0 * inside[0], 0.1, -4.0 * inside[2]]);
        let ball = world.add_particle(particle).unwrap();
        world.add_plane(plane([0.0; 3], [0.0, 0.0, 1.0], 1.0)).unwrap();
        world.add_plane(plane([0.0; 3], [theta.sin(), 0.0, -theta.cos()], 1.0)).unwrap();
        let before = world.velocity(ball).unwrap().length();
        let report = run(&mut world, &mut auto(), 0.5, 20);
        let most = (std::f64::consts::PI / theta).ceil() as u32;
        assert!((1..=most).contains(&report.hits), "{degrees}°: {} hits, at most {most}", report.hits);
        assert_eq!(report.capped, 0);
        // Each bounce rounds a velocity.
        assert!((world.velocity(ball).unwrap().length() - before).abs() < 1e-13 * before);
    }
}

/// Endless bounces in the corner of three planes end in rest in it, and are not followed for ever.
#[test]
fn a_corner_holds_what_falls_into_it() {
    for restitution in [0.0, 0.3, 0.6, 0.9] {
        let mut world = Small::new();
        world.set_gravity(GRAVITY).unwrap();
        let ball = world.add_particle(Particle::at([0.5, 0.2, 2.0])).unwrap();
        for normal in [[1.0, 0.0, 1.0], [-1.0, 0.9, 1.0], [-0.8, -1.0, 1.1]] {
            world.add_plane(plane([0.1, -0.3, 0.2], normal, restitution)).unwrap();
        }
        let report = run(&mut world, &mut auto(), 0.1, 600);
        assert_eq!(report.capped, 0, "restitution {restitution}: {} hits", report.hits);
        let apart = world.position(ball).unwrap() - glam::DVec3::new(0.1, -0.3, 0.2);
        assert!(apart.length() < 1e-6, "restitution {restitution}: {apart} from the corner");
    }
}

/// A slide down one plane along another: gravity keeps only its part along the line where they meet.
#[test]
fn two_planes_leave_the_line_between_them() {
    let mut world = Small::new();
    world.set_gravity(GRAVITY).unwrap();
    let ball = world.add_particle(Particle::at([0.0; 3])).unwrap();
    world.add_plane(plane([0.0; 3], [0.5, 1.0, 1.0], 0.5)).unwrap();
    world.add_plane(plane([0.0; 3], [0.5, -1.0, 1.0], 0.5)).unwrap();
    run(&mut world, &mut auto(), 0.1, 10);
    // Along the line (2, 0, −1)/√5: the acceleration is g/√5, and the way ½ (g/√5) t² after 1 s.
    let line = glam::DVec3::new(2.0, 0.0, -1.0) / 5_f64.sqrt();
    let expected = line * (0.5 * 10.0 / 5_f64.sqrt());
    assert!((world.position(ball).unwrap() - expected).length() < 1e-13);
}

#[test]
fn an_elastic_ball_never_rests() {
    let mut world = Small::new();
    world.set_gravity(GRAVITY).unwrap();
    let ball = world.add_particle(Particle::at([0.0, 0.0, 0.05])).unwrap();
    world.add_plane(plane([0.0; 3], [0.0, 0.0, 1.0], 1.0)).unwrap();
    run(&mut world, &mut auto(), 1.0 / 60.0, 60_000);
    let (x, v) = (world.position(ball).unwrap(), world.velocity(ball).unwrap());
    let energy = 10.0 * x.z + 0.5 * v.length_squared();
    // Five thousand bounces, each rounding a speed.
    assert!((energy - 0.5).abs() < 1e-11, "{energy}");
}

#[test]
fn held_particles_go_through_planes() {
    let mut world = Small::new();
    let pinned = world.add_particle(Particle::at([0.0, 0.0, -1.0]).pinned()).unwrap();
    let driven = world.add_particle(Particle::at([1.0, 0.0, 0.5]).with_velocity([0.0, 0.0, -1.0]).kinematic()).unwrap();
    world.add_plane(plane([0.0; 3], [0.0, 0.0, 1.0], 0.5)).unwrap();
    for _ in 0..2 {
        let report = run(&mut world, &mut auto(), 0.5, 2);
        assert_eq!(report.hits, 0);
        world.set_hold(pinned, Hold::Pinned).unwrap();
    }
    assert_eq!(world.position(pinned).unwrap().z, -1.0);
    assert_eq!(world.position(driven).unwrap().z, -1.5);
}

/// A particle that starts beyond a plane is turned round there, not moved.
#[test]
fn a_bounce_does_not_move_what_starts_beyond_the_plane() {
    let mut world = Small::new();
    let ball = world.add_particle(Particle::at([0.0, 0.0, -0.25]).with_velocity([0.0, 0.0, -1.0])).unwrap();
    world.add_plane(plane([0.0; 3], [0.0, 0.0, 1.0], 0.5)).unwrap();
    let report = run(&mut world, &mut auto(), 0.25, 1);
    assert_eq!(report.hits, 1);
    assert_eq!(world.position(ball).unwrap().z, -0.125);
    assert_eq!(world.velocity(ball).unwrap().z, 0.5);
}

/// Semi-implicit Euler under time of impact: a ball in free flight bounces on the path that Euler draws.
#[test]
fn a_named_stepper_bounces_on_its_own_path() {
    let mut world = Small::new();
    world.set_gravity(GRAVITY).unwrap();
    let ball = world.add_particle(Particle::at([0.0, 0.0, 0.05])).unwrap();
    world.add_plane(plane([0.0; 3], [0.0, 0.0, 1.0], 0.5)).unwrap();
    run(&mut world, &mut SemiImplicitEuler, 0.1, 1);
    // By hand: z = 0.05 − 10 τ² is 0 at τ = √0.005, where v = −10 τ; then v⁺ = 5 τ, and the rest r = 0.1 − τ brings
    // v' = v⁺ − 10 r and z' = r v'.
    let tau = 0.005_f64.sqrt();
    let r = 0.1 - tau;
    let v = 5.0 * tau - 10.0 * r;
    assert!((world.velocity(ball).unwrap().z - v).abs() < 1e-14);
    assert!((world.position(ball).unwrap().z - r * v).abs() < 1e-14);
}
