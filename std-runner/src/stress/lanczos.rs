//! The largest eigenvalue of a symmetric operator that can only be applied (Lanczos 1950).

/// Vectors that are built at most; full orthogonalisation keeps them all.
const VECTORS: usize = 60;
/// A value that a further vector raises by less than this part is the last one.
const SETTLED: f64 = 1e-7;

/// The largest eigenvalue of `apply`, which is symmetric in the scalar product with these weights; from below, to about
/// 1e-6. `start` must not be zero everywhere.
pub fn largest_eigenvalue(
    weights: &[f64],
    start: Vec<f64>,
    mut apply: impl FnMut(&[f64]) -> Vec<f64>,
) -> (f64, Vec<f64>) {
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).zip(weights).map(|((a, b), w)| a * b * w).sum::<f64>();
    let unit = |vector: Vec<f64>| {
        let size = product(&vector, &vector).sqrt();
        (size, vector.into_iter().map(|entry| entry / size).collect::<Vec<f64>>())
    };
    let mut basis = vec![unit(start).1];
    let (mut diagonal, mut beside): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    let mut value = 0.0;
    while let Some(last) = basis.last() {
        let mut next = apply(last);
        diagonal.push(product(&next, last));
        // Twice is enough (Kahan, in Parlett's The Symmetric Eigenvalue Problem, §6-9).
        for _ in 0..2 {
            for vector in &basis {
                let part = product(&next, vector);
                next.iter_mut().zip(vector).for_each(|(next, entry)| *next -= part * entry);
            }
        }
        let before = std::mem::replace(&mut value, tridiagonal(&diagonal, &beside));
        let (size, next) = unit(next);
        let settled = basis.len() > 4 && value - before <= SETTLED * value;
        if settled || basis.len() == VECTORS.min(weights.len()) || size <= 1e-12 * value {
            break;
        }
        beside.push(size);
        basis.push(next);
    }
    let vector = combined(&basis, &eigenvector(&diagonal, &beside, value));
    (value, vector)
}

/// The largest eigenvalue of a tridiagonal matrix, by bisection on the signs of its pivots (Sturm's sequence).
fn tridiagonal(diagonal: &[f64], beside: &[f64]) -> f64 {
    let radius = |row: usize| {
        let left = row.checked_sub(1).and_then(|row| beside.get(row)).copied().unwrap_or(0.0);
        left.abs() + beside.get(row).copied().unwrap_or(0.0).abs()
    };
    let rows = || diagonal.iter().enumerate();
    let mut above = rows().map(|(row, entry)| entry + radius(row)).fold(f64::NEG_INFINITY, f64::max);
    let mut below = diagonal.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    while above - below > 1e-13 * above.abs() {
        let middle = 0.5 * (below + above);
        if middle <= below || middle >= above {
            break;
        }
        let mut pivot = 1.0;
        let exceeds = rows().any(|(row, entry)| {
            let left = row.checked_sub(1).and_then(|row| beside.get(row)).copied().unwrap_or(0.0);
            pivot = entry - middle - left * left / pivot;
            pivot > 0.0
        });
        if exceeds {
            below = middle;
        } else {
            above = middle;
        }
    }
    0.5 * (below + above)
}

/// By the recurrence from its first row.
fn eigenvector(diagonal: &[f64], beside: &[f64], value: f64) -> Vec<f64> {
    let mut entries = vec![1.0];
    for (row, next) in beside.iter().enumerate() {
        let before = row.checked_sub(1).map_or(0.0, |before| beside[before] * entries[before]);
        entries.push(((value - diagonal[row]) * entries[row] - before) / next);
    }
    entries
}

fn combined(basis: &[Vec<f64>], weights: &[f64]) -> Vec<f64> {
    let mut sum = vec![0.0; basis.first().map_or(0, Vec::len)];
    for (vector, weight) in basis.iter().zip(weights) {
        sum.iter_mut().zip(vector).for_each(|(sum, entry)| *sum += weight * entry);
    }
    sum
}
