//! The matrices of a spring system, assembled: what the core keeps spring by spring.

use glam::{DMat3, DVec3};
use hooke_runner::model::{Hold, Model};

use crate::dense;
use crate::moment::Moment;
use crate::right_hand_side::RightHandSide;

/// A square matrix by rows.
pub type Matrix = Vec<Vec<f64>>;

/// K, made positive definite, and C: the springs' resistance to displacements (N/m) and to velocities (N·s/m).
///
/// Each spring adds k d̂d̂ᵀ + max(0, `across`) (I − d̂d̂ᵀ) and `k_d` d̂d̂ᵀ between its ends; `across` is told the spring's
/// stiffness (N/m), rest length, length (m) and force density (N/m).
#[must_use]
pub fn matrices(model: &Model, moment: &Moment, across: fn([f64; 4]) -> f64) -> [Matrix; 2] {
    let size = 3 * model.particles.len();
    let mut matrices = [vec![vec![0.0; size]; size], vec![vec![0.0; size]; size]];
    for spring in &model.springs {
        let [i, j] = spring.between.map(|number| number as usize);
        let apart = |vectors: &[[f64; 3]]| DVec3::from(vectors[j]) - DVec3::from(vectors[i]);
        let (d, v) = (apart(&moment.position), apart(&moment.velocity));
        let l = d.length();
        let axis = d.normalize_or_zero();
        let tension = spring.stiffness * (l - spring.rest_length) + spring.damping * v.dot(axis);
        let density = if l > 0.0 { tension / l } else { 0.0 };
        let along = DMat3::from_cols(axis * axis.x, axis * axis.y, axis * axis.z);
        let sideways = across([spring.stiffness, spring.rest_length, l, density]).max(0.0);
        let blocks = [spring.stiffness * along + sideways * (DMat3::IDENTITY - along), spring.damping * along];
        for (matrix, block) in matrices.iter_mut().zip(blocks) {
            for (row, column, sign) in [(i, i, 1.0), (j, j, 1.0), (i, j, -1.0), (j, i, -1.0)] {
                for (r, c) in (0..9).map(|entry| (entry / 3, entry % 3)) {
                    matrix[3 * row + r][3 * column + c] += sign * block.row(r)[c];
                }
            }
        }
    }
    matrices
}

/// √(1/m) of every component, 0 where the particle is held: what a matrix is scaled with on both sides.
#[must_use]
pub fn weights(model: &Model) -> Vec<f64> {
    let weight = |hold, mass: f64| if hold == Hold::Free { mass.sqrt().recip() } else { 0.0 };
    model.particles.iter().flat_map(|particle| [weight(particle.hold, particle.mass); 3]).collect()
}

/// The step that solves (M + dt·C + dt²·K)(v' − v) = dt (f(x, v) − dt·K v), in components scaled with √m, so that those
/// whose weight √(1/m) is 0 drop out.
///
/// # Panics
/// The matrix is singular, which it cannot be.
#[must_use]
pub fn step(model: &Model, gravity: [f64; 3], start: &Moment, weights: &[f64], dt: f64) -> Moment {
    let across = |[stiffness, rest_length, length, density]: [f64; 4]| {
        if length > 0.0 {
            density
        } else if rest_length > 0.0 {
            0.0
        } else {
            stiffness
        }
    };
    let [k, c] = matrices(model, start, across);
    let mut accelerations = vec![[0.0; 3]; model.particles.len()];
    RightHandSide::new(model, gravity).accelerate(&start.position, &start.velocity, &mut accelerations);
    let (v, a) = (start.velocity.as_flattened(), accelerations.as_flattened());
    let size = v.len();
    let rows = (0..size).map(|row| {
        let entry = |column: usize| {
            let inertia = if row == column { 1.0 } else { 0.0 };
            inertia + weights[row] * (dt * c[row][column] + dt * dt * k[row][column]) * weights[column]
        };
        (0..size).map(entry).collect()
    });
    let right = (0..size).map(|row| {
        let stretched: f64 = k[row].iter().zip(v).map(|(k, v)| k * v).sum();
        let inertial = if weights[row] > 0.0 { dt * a[row] / weights[row] } else { 0.0 };
        inertial - dt * dt * weights[row] * stretched
    });
    let change = dense::solve(rows.collect(), right.collect()).expect("a positive definite matrix");
    let velocity: Vec<f64> = (0..size).map(|row| v[row] + weights[row] * change[row]).collect();
    let position: Vec<f64> = start.position.as_flattened().iter().zip(&velocity).map(|(x, v)| x + dt * v).collect();
    Moment { position: position.as_chunks().0.to_vec(), velocity: velocity.as_chunks().0.to_vec() }
}
