//! The textbook loop, as a lecture writes it: an array of structures, forces zeroed, gravity added,
//! one pass over the springs that scatters to both ends, one pass over the particles, collisions.
//!
//! It is the rival in the benchmarks and a yardstick in the tests,
//! so it shares nothing with Hooke's own stepping but the scene it is given.

use crate::vector::{Scalar, Vector};
use hooke_runner::model::{Hold, Model};

/// One particle with all that belongs to it.
#[derive(Clone, Copy, Debug)]
pub struct Particle<V: Vector> {
    /// m
    pub position: V,
    /// m/s; 0 for a pinned particle, always
    pub velocity: V,
    /// N, what the last force computation summed
    pub force: V,
    /// kg
    pub mass: V::Real,
    /// 1/kg; 0 for a pinned particle, which therefore never gains a velocity
    pub inverse_mass: V::Real,
}

/// One spring.
#[derive(Clone, Copy, Debug)]
pub struct Spring<V: Vector> {
    /// The particles i and j that it joins.
    pub between: [u32; 2],
    /// k, N/m
    pub stiffness: V::Real,
    /// `k_d`, N·s/m
    pub damping: V::Real,
    /// m
    pub rest_length: V::Real,
}

/// The half-space n·x ≥ offset that particles are kept in.
#[derive(Clone, Copy, Debug)]
pub struct Plane<V: Vector> {
    /// n, of length 1.
    pub normal: V,
    /// m
    pub offset: V::Real,
    /// e, 0 to 1
    pub restitution: V::Real,
}

/// What a hit does, once the positions are updated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Response {
    /// The normal velocity becomes −e times itself.
    Reflect,
    /// The same, and the particle is put back on the plane.
    Project,
}

/// A particle follows keyframes, which the textbook loop does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KinematicParticle(
    /// Its number.
    pub usize,
);

/// A mass-spring system, stepped as the lecture does.
#[derive(Clone, Debug)]
pub struct Textbook<V: Vector> {
    /// In the scene's order.
    pub particles: Vec<Particle<V>>,
    /// In the scene's order.
    pub springs: Vec<Spring<V>>,
    /// In file order, which is the order they are tested in.
    pub planes: Vec<Plane<V>>,
    /// g, m/s²
    pub gravity: V,
    /// What a hit does.
    pub response: Response,
}

impl<V: Vector> Textbook<V> {
    /// The system that a flat scene describes, under `gravity` in m/s².
    ///
    /// # Errors
    /// The first particle that follows keyframes.
    pub fn new(model: &Model, gravity: [f64; 3], response: Response) -> Result<Self, KinematicParticle> {
        let real = V::Real::from_f64;
        let mut particles = Vec::with_capacity(model.particles.len());
        for (number, particle) in model.particles.iter().enumerate() {
            let (velocity, inverse_mass) = match particle.hold {
                Hold::Free => (V::from_components(particle.velocity), real(1.0 / particle.mass)),
                Hold::Pinned => (V::ZERO, V::Real::ZERO),
                Hold::Track(_) => return Err(KinematicParticle(number)),
            };
            particles.push(Particle {
                position: V::from_components(particle.position),
                velocity,
                force: V::ZERO,
                mass: real(particle.mass),
                inverse_mass,
            });
        }
        let springs = model.springs.iter().map(|spring| Spring {
            between: spring.between,
            stiffness: real(spring.stiffness),
            damping: real(spring.damping),
            rest_length: real(spring.rest_length),
        });
        let planes = model.planes.iter().map(|plane| {
            let [n, p] = [plane.normal, plane.point];
            Plane {
                normal: V::from_components(n),
                offset: real(n[0] * p[0] + n[1] * p[1] + n[2] * p[2]),
                restitution: real(plane.restitution),
            }
        });
        Ok(Self {
            particles,
            springs: springs.collect(),
            planes: planes.collect(),
            gravity: V::from_components(gravity),
            response,
        })
    }

    /// x' = x + dt·v; v' = v + dt·a(x, v); then the collisions. `time_step` in s.
    pub fn step_explicit_euler(&mut self, time_step: V::Real) {
        self.compute_forces();
        for particle in &mut self.particles {
            let acceleration = particle.force * particle.inverse_mass;
            particle.position += particle.velocity * time_step;
            particle.velocity += acceleration * time_step;
        }
        self.collide();
    }

    /// v' = v + dt·a(x, v); x' = x + dt·v'; then the collisions. `time_step` in s.
    // Part of whatever it is compiled into: see `avx2`.
    #[inline(always)]
    pub fn step_semi_implicit_euler(&mut self, time_step: V::Real) {
        self.compute_forces();
        for particle in &mut self.particles {
            let acceleration = particle.force * particle.inverse_mass;
            particle.velocity += acceleration * time_step;
            particle.position += particle.velocity * time_step;
        }
        self.collide();
    }

    /// f = m g, then F = (k (l − `l_rest`) + `k_d` l̇) d̂ added at i and subtracted at j.
    #[inline(always)]
    fn compute_forces(&mut self) {
        for particle in &mut self.particles {
            particle.force = self.gravity * particle.mass;
        }
        for spring in &self.springs {
            let [i, j] = spring.between.map(|number| number as usize);
            let (from, to) = (self.particles[i], self.particles[j]);
            let separation = to.position - from.position;
            let length = separation.length();
            // A spring without length has no direction to pull in.
            if length == V::Real::ZERO {
                continue;
            }
            let direction = separation * (V::Real::ONE / length);
            let length_rate = (to.velocity - from.velocity).dot(direction);
            let force = direction * (spring.stiffness * (length - spring.rest_length) + spring.damping * length_rate);
            self.particles[i].force += force;
            self.particles[j].force -= force;
        }
    }

    /// A particle is hit when n·x < offset while n·v < 0; a pinned one has no velocity, so it never is.
    #[inline(always)]
    fn collide(&mut self) {
        if self.planes.is_empty() {
            return;
        }
        for particle in &mut self.particles {
            for plane in &self.planes {
                let depth = plane.offset - particle.position.dot(plane.normal);
                let normal_velocity = particle.velocity.dot(plane.normal);
                if depth > V::Real::ZERO && normal_velocity < V::Real::ZERO {
                    particle.velocity -= plane.normal * ((V::Real::ONE + plane.restitution) * normal_velocity);
                    if self.response == Response::Project {
                        particle.position += plane.normal * depth;
                    }
                }
            }
        }
    }
}
