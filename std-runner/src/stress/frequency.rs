//! The highest frequency and the fastest damping of a scene's start, measured on the forces themselves.

use hooke::{ExplicitEuler, Reflect, StabilityBound, StepError};

use super::frozen::Frozen;
use super::lanczos::largest_eigenvalue;
use super::noise::noise;
use crate::simulate::{BuildError, HeapWorld, world};

/// How far particles are moved to see what pulls them back, relative to the length of the springs: the error of central
/// differences is the square of it, and rounding takes 1e-16 over it.
const CHANGE: f64 = 1e-6;
/// Times that a limit is drawn nearer to where the largest eigenvalue is 4.
const ROUNDS: u32 = 5;

/// What limits time steps, as measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frequency {
    /// ω, the highest frequency, rad/s.
    pub highest: f64,
    /// ζ of the motion of that frequency.
    pub damping_ratio: f64,
    /// γ, the fastest rate at which anything is damped, 1/s.
    pub damping_rate: f64,
    /// The dt (s) at which dt²K + 2dt·C reaches 4M, K and C being stiffness and damping and M the masses.
    pub semi_implicit_euler: f64,
    /// The dt (s) at which dt²K + 4dt·C reaches 4M.
    pub velocity_verlet: f64,
}

impl Frequency {
    /// Of a scene at rest; nothing where no spring pulls at a free particle.
    ///
    /// # Errors
    /// If it cannot be stepped.
    pub fn of(frozen: &Frozen) -> Result<Option<Self>, BuildError> {
        let mut forces = Forces::of(frozen)?;
        if forces.free.is_empty() {
            return Ok(None);
        }
        let (squared, shape) = forces.largest(1.0, 0.0);
        let (damping_rate, _) = forces.largest(0.0, 1.0);
        if squared.is_nan() || squared <= 0.0 {
            return Ok(None);
        }
        let highest = squared.sqrt();
        let damping = forces.quotient(&shape, 0.0, 1.0);
        let damping_rate = damping_rate.max(0.0);
        let mut limit = |factor: f64| {
            let damped = factor * damping_rate;
            // Where it would be if the fastest motion were the most damped one.
            forces.limit(factor, 8.0 / (damped + (damped * damped + 16.0 * squared).sqrt()))
        };
        let (semi_implicit_euler, velocity_verlet) = (limit(2.0), limit(4.0));
        Ok(Some(Self {
            highest,
            damping_ratio: (0.5 * damping / highest).max(0.0),
            damping_rate,
            semi_implicit_euler,
            velocity_verlet,
        }))
    }

    /// The bounds that would follow from it, beside the one from the blocks.
    #[must_use]
    pub fn bound(&self, blocks: &StabilityBound) -> StabilityBound {
        StabilityBound {
            frequency: self.highest,
            damping_rate: self.damping_rate,
            semi_implicit_euler: self.semi_implicit_euler,
            velocity_verlet: self.velocity_verlet,
            ..*blocks
        }
    }
}

/// Accelerations of a scene at rest, beside where it rests.
struct Forces {
    world: HeapWorld<f64>,
    /// Numbers of the particles that move.
    free: Vec<u32>,
    /// Where they rest, m.
    position: Vec<[f64; 3]>,
    /// kg, three times each.
    mass: Vec<f64>,
    /// m
    change: f64,
}

impl Forces {
    fn of(frozen: &Frozen) -> Result<Self, BuildError> {
        let Frozen { model, particles, .. } = frozen;
        let mut is_joined = vec![false; model.particles.len()];
        for end in model.springs.iter().flat_map(|spring| spring.between) {
            is_joined[end as usize] = true;
        }
        let free: Vec<usize> = (0..*particles).filter(|&number| is_joined[number] && frozen.is_free(number)).collect();
        Ok(Self {
            world: world(model, [0.0; 3])?,
            position: free.iter().map(|&number| model.particles[number].position).collect(),
            mass: free.iter().flat_map(|&number| [model.particles[number].mass; 3]).collect(),
            free: free.into_iter().map(|number| number as u32).collect(),
            change: CHANGE * frozen.length,
        })
    }

    /// The largest eigenvalue of stiffness K + damping C over M, and its shape.
    fn largest(&mut self, stiffness: f64, damping: f64) -> (f64, Vec<f64>) {
        let start = (0..).zip(&self.free).flat_map(|(number, _)| noise(number)).collect();
        let mass = self.mass.clone();
        largest_eigenvalue(&mass, start, |shape| self.apply(shape, stiffness, damping))
    }

    /// (stiffness K + damping C) u over M, for the displacements u.
    fn apply(&mut self, shape: &[f64], stiffness: f64, damping: f64) -> Vec<f64> {
        let largest = shape.iter().fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
        let scale = self.change / largest;
        let [ahead, behind] =
            [1.0, -1.0].map(|sign| self.accelerations(shape, sign * scale * stiffness, sign * scale * damping));
        ahead.iter().zip(behind).map(|(ahead, behind)| (behind - ahead) / (2.0 * scale)).collect()
    }

    /// Of all particles, moved by so many times a shape, at so many times its velocity: what one step of explicit Euler
    /// of 1 s adds to their velocities.
    fn accelerations(&mut self, shape: &[f64], by: f64, at: f64) -> Vec<f64> {
        let moved = |rest: &[f64; 3], shape: &[f64; 3]| [0, 1, 2].map(|axis| rest[axis] + by * shape[axis]);
        let (shapes, _) = shape.as_chunks::<3>();
        for ((&number, rest), shape) in self.free.iter().zip(&self.position).zip(shapes) {
            // They exist, and are finite: what is not gives no finite acceleration either.
            let _ = self.world.set_position(number, moved(rest, shape));
            let _ = self.world.set_velocity(number, shape.map(|part| at * part));
        }
        let stepped: Result<_, StepError> = self.world.step(&mut ExplicitEuler, &mut Reflect, 1.0);
        let view = self.world.view();
        let gained = |(&number, shape): (&u32, &[f64; 3])| {
            let velocity = view.velocity(number).filter(|_| stepped.is_ok());
            let velocity: [f64; 3] = velocity.map_or([f64::NAN; 3], Into::into);
            [0, 1, 2].map(|axis| velocity[axis] - at * shape[axis])
        };
        self.free.iter().zip(shapes).flat_map(gained).collect()
    }

    /// Rayleigh's quotient of a shape.
    fn quotient(&mut self, shape: &[f64], stiffness: f64, damping: f64) -> f64 {
        let applied = self.apply(shape, stiffness, damping);
        let product =
            |left: &[f64]| -> f64 { left.iter().zip(shape).zip(&self.mass).map(|((a, b), m)| a * b * m).sum() };
        product(&applied) / product(shape)
    }

    /// The dt at which the largest eigenvalue of dt²K + factor·dt·C over M is 4: it grows with dt, at least as dt and at
    /// most as dt², so each round of the mean exponent brings it nearer.
    fn limit(&mut self, factor: f64, from: f64) -> f64 {
        let mut dt = from;
        for _ in 0..ROUNDS {
            let value = dt * dt * self.largest(1.0, factor / dt).0;
            if (value / 4.0 - 1.0).abs() < 1e-6 {
                break;
            }
            dt *= (4.0 / value).powf(1.0 / 1.5);
        }
        dt
    }
}
