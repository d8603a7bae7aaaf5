//! The crate `rapier3d`: a rigid body without rotation for each particle, a spring joint for each spring.
//!
//! Its joints are soft constraints, integrated implicitly and iterated over: it approaches the same equation as its
//! steps shrink, by a scheme of its own.

use std::error::Error;

use hooke_runner::model::{Hold, Model};
use hooke_runner::scene::Scene;
use rapier3d::prelude::*;

use crate::peer::{Outcome, Peer, Request, timed};

/// m; of the balls that collide with planes. A particle is that far above the plane that its ball rests on.
const RADIUS: f32 = 1e-3;

pub struct Rapier {
    model: Model,
    gravity: [f64; 3],
    /// Of its solver in a step, which it flies in as many parts.
    iterations: usize,
}

pub fn new(iterations: &str, scene: &Scene) -> Result<Rapier, Box<dyn Error>> {
    Ok(Rapier { model: scene.model()?, gravity: scene.settings().gravity, iterations: iterations.parse()? })
}

fn vector(vector: [f64; 3]) -> Vector {
    let [x, y, z] = vector.map(|component| component as f32);
    Vector::new(x, y, z)
}

impl Peer for Rapier {
    fn run(&mut self, request: &Request) -> Result<Outcome, Box<dyn Error>> {
        let mut bodies = RigidBodySet::new();
        let mut colliders = ColliderSet::new();
        let mut joints = ImpulseJointSet::new();
        let handles = self.add_particles(&mut bodies, &mut colliders);
        self.add_springs(&handles, &mut joints);
        self.add_planes(&mut colliders);

        let gravity = vector(self.gravity);
        let parameters = IntegrationParameters {
            dt: request.setting as f32,
            num_solver_iterations: self.iterations,
            ..Default::default()
        };
        let mut pipeline = PhysicsPipeline::new();
        let mut islands = IslandManager::new();
        let mut broad_phase = DefaultBroadPhase::new();
        let mut narrow_phase = NarrowPhase::new();
        let mut multibody_joints = MultibodyJointSet::new();
        let mut soft_bodies = SoftBodySet::new();
        let mut ccd_solver = CCDSolver::new();
        let (cpu, ()) = timed(|| {
            for _ in 0..request.steps() {
                pipeline.step(
                    gravity,
                    &parameters,
                    &mut islands,
                    &mut broad_phase,
                    &mut narrow_phase,
                    &mut bodies,
                    &mut colliders,
                    &mut joints,
                    &mut multibody_joints,
                    &mut soft_bodies,
                    &mut ccd_solver,
                    &(),
                    &(),
                );
            }
        });
        let position = handles.iter().flat_map(|handle| {
            let place = bodies[*handle].translation();
            [place.x, place.y, place.z].map(f64::from)
        });
        Ok(Outcome { cpu, position: position.collect() })
    }
}

impl Rapier {
    fn add_particles(&self, bodies: &mut RigidBodySet, colliders: &mut ColliderSet) -> Vec<RigidBodyHandle> {
        let mut handles = Vec::with_capacity(self.model.particles.len());
        for particle in &self.model.particles {
            let body = match particle.hold {
                Hold::Free => RigidBodyBuilder::dynamic().additional_mass(particle.mass as f32).lock_rotations(),
                Hold::Pinned | Hold::Track(_) => RigidBodyBuilder::fixed(),
            };
            let body = body.translation(vector(particle.position)).linvel(vector(particle.velocity)).can_sleep(false);
            let handle = bodies.insert(body);
            if !self.model.planes.is_empty() {
                let ball = ColliderBuilder::ball(RADIUS).mass(0.0).restitution(self.restitution()).friction(0.0);
                // Balls meet planes, and nothing else.
                let ball = ball.collision_groups(InteractionGroups::new(
                    Group::GROUP_1,
                    Group::GROUP_2,
                    InteractionTestMode::And,
                ));
                colliders.insert_with_parent(ball, handle, bodies);
            }
            handles.push(handle);
        }
        handles
    }

    fn add_springs(&self, handles: &[RigidBodyHandle], joints: &mut ImpulseJointSet) {
        for spring in &self.model.springs {
            let [i, j] = spring.between.map(|number| handles[number as usize]);
            let [rest_length, stiffness, damping] =
                [spring.rest_length, spring.stiffness, spring.damping].map(|value| value as f32);
            let joint = SpringJointBuilder::new(rest_length, stiffness, damping).contacts_enabled(false);
            joints.insert(i, j, joint, false);
        }
    }

    fn add_planes(&self, colliders: &mut ColliderSet) {
        for plane in &self.model.planes {
            // Sunk by the radius of the balls, so that a particle bounces where the plane is.
            let normal = vector(plane.normal);
            let half_space = ColliderBuilder::new(SharedShape::halfspace(normal));
            colliders.insert(
                half_space
                    .translation(vector(plane.point) - normal * RADIUS)
                    .restitution(self.restitution())
                    .friction(0.0)
                    .collision_groups(InteractionGroups::new(Group::GROUP_2, Group::GROUP_1, InteractionTestMode::And)),
            );
        }
    }

    /// The scenes have one plane, or planes alike.
    fn restitution(&self) -> f32 {
        self.model.planes.first().map_or(0.0, |plane| plane.restitution as f32)
    }
}
