//! Dense linear algebra for small systems, as textbooks have it.

/// Solves a linear system by Gaussian elimination with partial pivoting; `None` for a singular matrix.
#[must_use]
pub fn solve(mut rows: Vec<Vec<f64>>, mut right: Vec<f64>) -> Option<Vec<f64>> {
    let size = right.len();
    for column in 0..size {
        let pivot = (column..size).max_by(|&a, &b| rows[a][column].abs().total_cmp(&rows[b][column].abs()))?;
        rows.swap(column, pivot);
        right.swap(column, pivot);
        if rows[column][column] == 0.0 {
            return None;
        }
        let (done, rest) = rows.split_at_mut(column + 1);
        let pivot_row = &done[column];
        for (offset, row) in rest.iter_mut().enumerate() {
            let factor = row[column] / pivot_row[column];
            for (entry, above) in row[column..].iter_mut().zip(&pivot_row[column..]) {
                *entry -= factor * above;
            }
            right[column + 1 + offset] -= factor * right[column];
        }
    }
    for row in (0..size).rev() {
        let known: f64 = (row + 1..size).map(|column| rows[row][column] * right[column]).sum();
        right[row] = (right[row] - known) / rows[row][row];
    }
    Some(right)
}

/// The largest eigenvalue of a symmetric matrix, by cyclic Jacobi rotations (Golub and Van Loan, § 8.5).
#[must_use]
pub fn largest_eigenvalue(mut rows: Vec<Vec<f64>>) -> f64 {
    let size = rows.len();
    // Each sweep at least squares what is left beside the diagonal, once that is small: 12 are far past rounding.
    for _ in 0..12 {
        for p in 0..size {
            for q in p + 1..size {
                rotate(&mut rows, p, q);
            }
        }
    }
    (0..size).fold(f64::NEG_INFINITY, |largest, index| largest.max(rows[index][index]))
}

/// Annuls the entry (p, q).
fn rotate(rows: &mut [Vec<f64>], p: usize, q: usize) {
    let entry = rows[p][q];
    if entry == 0.0 {
        return;
    }
    let theta = (rows[q][q] - rows[p][p]) / (2.0 * entry);
    let tangent = theta.signum() / (theta.abs() + theta.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = tangent * cosine;
    for row in rows.iter_mut() {
        let (a, b) = (row[p], row[q]);
        (row[p], row[q]) = (cosine * a - sine * b, sine * a + cosine * b);
    }
    let (upper, lower) = rows.split_at_mut(q);
    for (a, b) in upper[p].iter_mut().zip(&mut lower[0]) {
        (*a, *b) = (cosine * *a - sine * *b, sine * *a + cosine * *b);
    }
}
