//! Models made by hand, and a crude stepper, so that shapes look real.

use hooke_runner::model::{Hold, Model, ModelParticle, ModelPlane, ModelSpring, Track};

pub const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

pub struct Scene {
    pub name: &'static str,
    pub model: Model,
    pub gravity: [f64; 3],
}

fn scene(name: &'static str, model: Model) -> Scene {
    Scene { name, model, gravity: GRAVITY }
}

pub fn particle(position: [f64; 3], mass: f64, hold: Hold) -> ModelParticle {
    ModelParticle { position, velocity: [0.0; 3], mass, hold }
}

pub fn floor(z: f64) -> ModelPlane {
    ModelPlane { point: [0.0, 0.0, z], normal: [0.0, 0.0, 1.0], restitution: 0.8 }
}

pub fn join(model: &mut Model, from: usize, to: usize, stiffness: f64, damping: f64) {
    let [a, b] = [from, to].map(|end| model.particles[end].position);
    let rest_length = (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt();
    model.springs.push(ModelSpring { between: [from as u32, to as u32], stiffness, damping, rest_length });
}

pub fn spring() -> Scene {
    let mut model = Model::default();
    model.particles.push(particle([0.0, 0.0, 2.0], 1.0, Hold::Pinned));
    model.particles.push(particle([0.0, 0.0, 1.2], 1.0, Hold::Free));
    join(&mut model, 0, 1, 40.0, 0.2);
    model.planes.push(floor(0.0));
    scene("mass on a vertical spring", model)
}

pub fn pendulum() -> Scene {
    let mut model = Model::default();
    model.particles.push(particle([0.0, 0.0, 2.0], 1.0, Hold::Pinned));
    model.particles.push(particle([0.8, 0.0, 1.6], 1.0, Hold::Free));
    join(&mut model, 0, 1, 300.0, 0.2);
    scene("pendulum", model)
}

pub fn balls() -> Scene {
    let mut model = Model::default();
    for number in 0..7 {
        let x = f64::from(number) * 0.5;
        model.particles.push(particle([x, 0.0, 1.0 + 0.15 * f64::from(number)], 1.0, Hold::Free));
    }
    model.planes.push(floor(0.0));
    scene("seven bouncing balls", model)
}

pub fn cloth(side: usize) -> Scene {
    let mut model = Model::default();
    let step = 1.0 / (side - 1) as f64;
    let at = |u: usize, v: usize| v * side + u;
    let mass = 10.0 / (side * side) as f64;
    for v in 0..side {
        for u in 0..side {
            let hold = if v == 0 && (u == 0 || u == side - 1) { Hold::Pinned } else { Hold::Free };
            model.particles.push(particle([u as f64 * step, v as f64 * step, 2.0], mass, hold));
        }
    }
    for v in 0..side {
        for u in 0..side {
            for (du, dv) in [(1i64, 0i64), (0, 1), (1, 1), (-1, 1), (2, 0), (0, 2)] {
                let (to_u, to_v) = (u as i64 + du, v as i64 + dv);
                let inside = |at: i64| (0..side as i64).contains(&at);
                if inside(to_u) && inside(to_v) {
                    join(&mut model, at(u, v), at(to_u as usize, to_v as usize), 800.0, 0.1);
                }
            }
        }
    }
    scene("cloth held at two corners", model)
}

pub fn rope() -> Scene {
    let mut model = Model::default();
    for number in 0..41 {
        let hold = if number == 0 || number == 40 { Hold::Pinned } else { Hold::Free };
        let height = 2.0 + 0.3 * (f64::from(number) * 0.3).sin();
        model.particles.push(particle([f64::from(number) * 0.05, 0.0, height], 0.01, hold));
    }
    for number in 0..40 {
        join(&mut model, number, number + 1, 200.0, 0.05);
    }
    scene("slung rope", model)
}

pub fn jelly() -> Scene {
    let mut model = Model::default();
    let at = |x: usize, y: usize, z: usize| (z * 8 + y) * 8 + x;
    for z in 0..8 {
        for y in 0..8 {
            for x in 0..8 {
                let place = [x, y, z].map(|part| part as f64 * 0.07);
                model.particles.push(particle([place[0], place[1], place[2] + 0.6], 0.01, Hold::Free));
            }
        }
    }
    for z in 0..8usize {
        for y in 0..8usize {
            for x in 0..8usize {
                for code in 14..27i64 {
                    let offset = [code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1];
                    let to = [x as i64 + offset[0], y as i64 + offset[1], z as i64 + offset[2]];
                    if to.iter().all(|part| (0..8).contains(part)) {
                        let to = to.map(|part| part as usize);
                        join(&mut model, at(x, y, z), at(to[0], to[1], to[2]), 60.0, 0.05);
                    }
                }
            }
        }
    }
    let tilt = 0.3f64;
    model.planes.push(ModelPlane { point: [0.0; 3], normal: [tilt.sin(), 0.0, tilt.cos()], restitution: 0.3 });
    scene("jelly on a slope", model)
}

pub fn cloud(count: usize) -> Scene {
    let mut model = Model::default();
    let base: f64 = 1.220_744_084_605_759_5;
    for number in 0..count {
        let place = [1, 2, 3].map(|power| (0.5 + (number as f64 + 1.0) / base.powi(power)).fract());
        let position = [place[0] * 10.0, place[1] * 10.0, 1.0 + place[2] * 5.0];
        model.particles.push(particle(position, 0.01, Hold::Free));
    }
    model.planes.push(floor(0.0));
    scene("a thousand balls", model)
}

pub fn carried() -> Scene {
    let mut model = Model::default();
    let keys = vec![(0.0, [0.0, 0.0, 2.0]), (1.0, [1.0, 0.4, 2.3]), (2.0, [0.0, 0.0, 2.0])];
    model.tracks.push(Track { keys });
    model.particles.push(particle([0.0, 0.0, 2.0], 1.0, Hold::Track(0)));
    for number in 1..6 {
        model.particles.push(particle([0.0, 0.0, 2.0 - 0.2 * number as f64], 0.1, Hold::Free));
        join(&mut model, number - 1, number, 60.0, 0.3);
    }
    model.planes.push(floor(0.0));
    model.planes.push(ModelPlane { point: [-0.8, 0.0, 0.0], normal: [1.0, 0.0, 0.0], restitution: 1.0 });
    scene("carried chain by a wall", model)
}

pub fn all() -> Vec<Scene> {
    vec![spring(), pendulum(), balls(), cloth(32), rope(), jelly(), cloud(1000), carried()]
}

/// Positions after each frame, by semi-implicit Euler with the planes' reflection.
pub struct Motion<'a> {
    scene: &'a Scene,
    pub time: f64,
    pub position: Vec<[f64; 3]>,
    velocity: Vec<[f64; 3]>,
}

impl<'a> Motion<'a> {
    pub fn new(scene: &'a Scene) -> Self {
        let particles = &scene.model.particles;
        Self {
            scene,
            time: 0.0,
            position: particles.iter().map(|particle| particle.position).collect(),
            velocity: particles.iter().map(|particle| particle.velocity).collect(),
        }
    }

    pub fn run(&mut self, duration: f64, steps: usize) {
        let step = duration / steps as f64;
        for _ in 0..steps {
            self.step(step);
        }
    }

    fn step(&mut self, step: f64) {
        let model = &self.scene.model;
        let mut force = vec![[0.0; 3]; self.position.len()];
        for spring in &model.springs {
            let [from, to] = spring.between.map(|end| end as usize);
            let d: [f64; 3] = std::array::from_fn(|axis| self.position[to][axis] - self.position[from][axis]);
            let length = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
            let speed: f64 =
                (0..3).map(|axis| (self.velocity[to][axis] - self.velocity[from][axis]) * d[axis]).sum::<f64>()
                    / length;
            let pull = (spring.stiffness * (length - spring.rest_length) + spring.damping * speed) / length;
            for (axis, part) in d.into_iter().enumerate() {
                force[from][axis] += pull * part;
                force[to][axis] -= pull * part;
            }
        }
        self.time += step;
        for (number, particle) in model.particles.iter().enumerate() {
            match particle.hold {
                Hold::Free => {}
                Hold::Pinned => continue,
                Hold::Track(track) => {
                    self.position[number] = along(&model.tracks[track as usize], self.time);
                    continue;
                }
            }
            for (axis, pull) in force[number].into_iter().enumerate() {
                let acceleration = pull / particle.mass + self.scene.gravity[axis];
                self.velocity[number][axis] += step * acceleration;
                self.position[number][axis] += step * self.velocity[number][axis];
            }
            for plane in &model.planes {
                let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                let depth = dot(plane.normal, self.position[number]) - dot(plane.normal, plane.point);
                let speed = dot(plane.normal, self.velocity[number]);
                if depth < 0.0 && speed < 0.0 {
                    for axis in 0..3 {
                        self.velocity[number][axis] -= (1.0 + plane.restitution) * speed * plane.normal[axis];
                        self.position[number][axis] -= depth * plane.normal[axis];
                    }
                }
            }
        }
    }
}

fn along(track: &Track, time: f64) -> [f64; 3] {
    for pair in track.keys.windows(2) {
        if time <= pair[1].0 {
            let share = (time - pair[0].0) / (pair[1].0 - pair[0].0);
            return std::array::from_fn(|axis| pair[0].1[axis] + share * (pair[1].1[axis] - pair[0].1[axis]));
        }
    }
    track.keys[track.keys.len() - 1].1
}
