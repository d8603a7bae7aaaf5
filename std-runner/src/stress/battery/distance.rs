//! Distances, without squares: those of what is next to 0 would be 0.

use crate::model::Model;

/// The largest difference of a coordinate between two lists of positions, m; infinite where anything is not a number.
pub fn farthest(left: &[[f64; 3]], right: &[[f64; 3]]) -> f64 {
    let pairs = left.as_flattened().iter().zip(right.as_flattened());
    pairs.fold(0.0, |farthest: f64, (a, b)| if (a - b).is_nan() { f64::INFINITY } else { farthest.max((a - b).abs()) })
}

/// The largest extent of a model along an axis, or the largest rest length of its springs, m; where both are 0, the farthest
/// coordinate, or 1.
pub fn size(model: &Model) -> f64 {
    let springs = model.springs.iter().fold(0.0_f64, |longest, spring| longest.max(spring.rest_length));
    let extent = model.extents().into_iter().map(|(least, most)| most - least).fold(springs, f64::max);
    let far = || model.particles.iter().flat_map(|particle| particle.position).fold(0.0_f64, |far, x| far.max(x.abs()));
    [extent, far()].into_iter().find(|size| *size > 0.0 && size.is_finite()).unwrap_or(1.0)
}
