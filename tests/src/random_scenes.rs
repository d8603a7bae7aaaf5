//! Small random scenes with everything in them: particles free, attached, pinned and kinematic, between planes that
//! leave room around a point.

use hooke::{Container, Hold, Particle, Plane, Real, Spring, Storage};

use crate::random::Random;

/// A scene in numbers, to be made in any precision and storage.
#[derive(Clone, Debug, Default)]
pub struct RandomScene {
    /// Position (m), velocity (m/s), mass (kg) and hold.
    pub particles: Vec<([f64; 3], [f64; 3], f64, Hold)>,
    /// Ends, stiffness (N/m), damping (N·s/m) and rest length (m).
    pub springs: Vec<([u32; 2], [f64; 3])>,
    /// Point (m), normal and restitution.
    pub planes: Vec<([f64; 3], [f64; 3], f64)>,
    /// m/s²
    pub gravity: [f64; 3],
    /// The size of the room, m.
    pub size: f64,
}

impl RandomScene {
    /// The most of particles, springs and planes that there can be.
    pub const MOST: [usize; 3] = [9, 18, 8];

    /// The scene of a seed, as large as `size` (m), around a point about `offset` sizes away from the origin. Times stay
    /// the same in scenes of every size.
    #[must_use]
    pub fn new(seed: u64, size: f64, offset: f64) -> Self {
        let mut random = Random::new(seed);
        let centre = random.vector(offset * size);
        let at = |vector: [f64; 3]| [0, 1, 2].map(|axis| centre[axis] + size * vector[axis]);
        let walls = walls(&mut random);
        let mut scene = Self { size, ..Self::default() };
        for &(normal, distance, restitution) in &walls {
            scene.planes.push((at(normal.map(|component| -distance * component)), normal, restitution));
        }
        let count = 1 + random.below(Self::MOST[0]);
        for _ in 0..count {
            let (place, velocity, hold) = place(&mut random, &walls);
            let velocity = velocity.map(|component| size * component);
            scene.particles.push((at(place), velocity, random.between(0.1, 2.0), hold));
        }
        for _ in 0..random.below(2 * count) {
            let [i, j] = [0; 2].map(|_| random.below(count));
            if i == j {
                continue;
            }
            let distance = dot(difference(&scene, i, j), difference(&scene, i, j)).sqrt();
            let damping = if random.below(2) == 0 { 0.0 } else { random.between(0.0, 2.0) };
            let parameters = [random.between(1.0, 300.0), damping, distance * random.between(0.5, 1.4)];
            scene.springs.push(([i as u32, j as u32], parameters));
        }
        if random.below(4) > 0 {
            scene.gravity = random.vector(10.0).map(|component| size * component);
        }
        scene
    }

    /// The same without springs, so that everything flies freely.
    #[must_use]
    pub fn without_springs(self) -> Self {
        Self { springs: Vec::new(), ..self }
    }

    /// The world of it.
    ///
    /// # Panics
    /// There is no room for it.
    #[must_use]
    pub fn world<R: Real, M: Storage>(&self) -> Container<R, M> {
        let vector = |vector: [f64; 3]| -> R::Vec3 { vector.map(R::Coordinate::from_f64).into() };
        let mut world = Container::<R, M>::new();
        for &(position, velocity, mass, hold) in &self.particles {
            let (position, velocity) = (vector(position), vector(velocity));
            let particle = Particle { position, velocity, mass: R::from_f64(mass), hold };
            world.add_particle(particle).expect("room for a particle");
        }
        for &(between, parameters) in &self.springs {
            let [stiffness, damping, rest_length] = parameters.map(R::from_f64);
            let spring = Spring { between, stiffness, damping, rest_length };
            world.add_spring(spring).expect("room for a spring");
        }
        for &(point, normal, restitution) in &self.planes {
            let plane = Plane::<R>::through(vector(point), vector(normal), R::from_f64(restitution));
            world.add_plane(plane.expect("a sound plane")).expect("room for a plane");
        }
        world.set_gravity(vector(self.gravity)).expect("finite gravity");
        world
    }

    /// A time step at which every explicit stepper is stable and accurate on the world of it, s.
    #[must_use]
    pub fn time_step(&self) -> f64 {
        let mut world = self.world::<f64, hooke_runner::simulate::Heap>();
        let bound = world.view().stability();
        bound.map_or(5e-3, |bound| (0.1 * bound.velocity_verlet.min(bound.semi_implicit_euler)).min(5e-3))
    }
}

/// Up to four walls around the origin, one in five of them with another opposite: normal, distance and restitution.
fn walls(random: &mut Random) -> Vec<([f64; 3], f64, f64)> {
    let mut walls = Vec::new();
    for _ in 0..random.below(5) {
        let normal = random.vector(1.0);
        let length = dot(normal, normal).sqrt();
        let normal = normal.map(|component| component / length);
        let restitution = [0.0, 1e-9, 0.3, 0.8, 0.99, 1.0][random.below(6)];
        walls.push((normal, random.between(0.05, 0.8), restitution));
        if random.below(5) == 0 {
            walls.push((normal.map(|component| -component), random.between(0.01, 0.5), restitution));
        }
    }
    walls
}

/// A place between the walls, now and then on one of them, a velocity and a hold.
fn place(random: &mut Random, walls: &[([f64; 3], f64, f64)]) -> ([f64; 3], [f64; 3], Hold) {
    let gap = |place: [f64; 3], &(normal, distance, _): &([f64; 3], f64, f64)| dot(normal, place) + distance;
    let mut place = random.vector(1.0);
    while walls.iter().any(|wall| gap(place, wall) < 0.0) {
        place = place.map(|component| 0.8 * component);
    }
    if !walls.is_empty() && random.below(5) == 0 {
        let wall = &walls[random.below(walls.len())];
        let away = gap(place, wall);
        let onto = [0, 1, 2].map(|axis| place[axis] - away * wall.0[axis]);
        if walls.iter().all(|wall| gap(onto, wall) > -1e-12) {
            place = onto;
        }
    }
    let hold = [Hold::Free, Hold::Free, Hold::Free, Hold::Free, Hold::Free, Hold::Pinned, Hold::Kinematic];
    let hold = hold[random.below(hold.len())];
    let fastest = if hold == Hold::Kinematic { 0.5 } else { 3.0 };
    let velocity = if random.below(3) == 0 { [0.0; 3] } else { random.vector(fastest) };
    (place, velocity, hold)
}

fn difference(scene: &RandomScene, i: usize, j: usize) -> [f64; 3] {
    [0, 1, 2].map(|axis| scene.particles[i].0[axis] - scene.particles[j].0[axis])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| a * b).sum()
}
