//! Coefficients of explicit Runge-Kutta methods, in the form that equations of second order give them.

/// x″ = a(x, x′) is stepped by
///
/// Xᵢ = x + cᵢ dt v + dt² Σ āᵢⱼ Aⱼ, Vᵢ = v + dt Σ aᵢⱼ Aⱼ, Aᵢ = a(Xᵢ, Vᵢ),
/// x′ = x + dt v + dt² Σ b̄ᵢ Aᵢ, v′ = v + dt Σ bᵢ Aᵢ
///
/// (Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I*, §II.14). A Runge-Kutta method for equations
/// of first order is the one with ā = a a and b̄ = b a.
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

/// The product of two matrices.
pub const fn product<const STAGES: usize>(
    left: &[[f64; STAGES]; STAGES],
    right: &[[f64; STAGES]; STAGES],
) -> [[f64; STAGES]; STAGES] {
    let mut product = [[0.0; STAGES]; STAGES];
    let mut row = 0;
    while row < STAGES {
        product[row] = weighted(&left[row], right);
        row += 1;
    }
    product
}

/// The sum of the rows of a matrix with these weights.
pub const fn weighted<const STAGES: usize>(weights: &[f64; STAGES], rows: &[[f64; STAGES]; STAGES]) -> [f64; STAGES] {
    let mut sum = [0.0; STAGES];
    let mut column = 0;
    while column < STAGES {
        let mut row = 0;
        while row < STAGES {
            sum[column] += weights[row] * rows[row][column];
            row += 1;
        }
        column += 1;
    }
    sum
}
