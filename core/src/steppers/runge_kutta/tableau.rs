//! Coefficients of explicit Runge-Kutta methods, in the form that equations of second order give them.

/// x″ = a(x, x′) is stepped by
///
/// Xᵢ = x + cᵢ dt v + dt² Σ āᵢⱼ Aⱼ, Vᵢ = v + dt Σ aᵢⱼ Aⱼ, Aᵢ = a(Xᵢ, Vᵢ),
/// x′ = x + dt v + dt² Σ b̄ᵢ Aᵢ, v′ = v + dt Σ bᵢ Aᵢ
///
/// (Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I*, §II.14).
pub trait Tableau<const STAGES: usize> {
    /// c
    const NODES: [f64; STAGES];
    /// ā, below its diagonal.
    const POSITION: [[f64; STAGES]; STAGES];
    /// a, below its diagonal; nothing where accelerations must not depend on velocities.
    const VELOCITY: Option<[[f64; STAGES]; STAGES]>;
    /// b̄
    const POSITION_WEIGHTS: [f64; STAGES];
    /// b
    const VELOCITY_WEIGHTS: [f64; STAGES];
    /// Of accuracy.
    const ORDER: u32;
    /// Whether the last stage is at the position that the step makes, so that its acceleration is the next step's first.
    const FIRST_SAME_AS_LAST: bool;
}

/// A method for equations of first order: the tableau with ā = a a and b̄ = b a.
pub trait FirstOrder<const STAGES: usize> {
    /// c
    const NODES: [f64; STAGES];
    /// a, below its diagonal.
    const MATRIX: [[f64; STAGES]; STAGES];
    /// b
    const WEIGHTS: [f64; STAGES];
    /// Of accuracy.
    const ORDER: u32;
}

impl<T: FirstOrder<STAGES>, const STAGES: usize> Tableau<STAGES> for T {
    const NODES: [f64; STAGES] = <T as FirstOrder<STAGES>>::NODES;
    const POSITION: [[f64; STAGES]; STAGES] = product(&T::MATRIX, &T::MATRIX);
    const VELOCITY: Option<[[f64; STAGES]; STAGES]> = Some(T::MATRIX);
    const POSITION_WEIGHTS: [f64; STAGES] = weighted(&T::WEIGHTS, &T::MATRIX);
    const VELOCITY_WEIGHTS: [f64; STAGES] = T::WEIGHTS;
    const ORDER: u32 = <T as FirstOrder<STAGES>>::ORDER;
    const FIRST_SAME_AS_LAST: bool = false;
}

/// A row of a matrix, given up to where nothing but zeros follow.
pub const fn row<const STAGES: usize>(given: &[f64]) -> [f64; STAGES] {
    let mut row = [0.0; STAGES];
    let (mut to, mut from) = (row.as_mut_slice(), given);
    while let ([entry, further_to @ ..], [value, further_from @ ..]) = (to, from) {
        *entry = *value;
        (to, from) = (further_to, further_from);
    }
    row
}

/// The product of two matrices.
const fn product<const STAGES: usize>(
    left: &[[f64; STAGES]; STAGES],
    right: &[[f64; STAGES]; STAGES],
) -> [[f64; STAGES]; STAGES] {
    let mut product = [[0.0; STAGES]; STAGES];
    let (mut to, mut from) = (product.as_mut_slice(), left.as_slice());
    while let ([row, further_to @ ..], [weights, further_from @ ..]) = (to, from) {
        *row = weighted(weights, right);
        (to, from) = (further_to, further_from);
    }
    product
}

/// The sum of the rows of a matrix with these weights.
pub const fn weighted<const STAGES: usize>(weights: &[f64; STAGES], rows: &[[f64; STAGES]; STAGES]) -> [f64; STAGES] {
    let mut sum = [0.0; STAGES];
    let (mut weights, mut rows) = (weights.as_slice(), rows.as_slice());
    while let ([weight, further_weights @ ..], [row, further_rows @ ..]) = (weights, rows) {
        let (mut to, mut from) = (sum.as_mut_slice(), row.as_slice());
        while let ([entry, further_to @ ..], [part, further_from @ ..]) = (to, from) {
            *entry += *weight * *part;
            (to, from) = (further_to, further_from);
        }
        (weights, rows) = (further_weights, further_rows);
    }
    sum
}
