//! The inverses of the matrix's diagonal blocks (block Jacobi).

use super::linearised::Linearisation;
use crate::Real;
use crate::vectors::{at, fetch, put, read};
use crate::world::System;

/// Blocks kept as xx, yy, zz, xy, xz, yz.
type Blocks<'a, R> = [&'a mut [R]; 6];

/// Inverts the 3 × 3 block of every dynamic particle; it is positive definite since its mass is.
pub fn invert_blocks<R: Real>(system: &System<'_, R>, matrix: &Linearisation<'_, R>, blocks: &mut Blocks<'_, R>) {
    for (slot, incidences) in system.springs.by_slot(system.plan.attached) {
        let mass = at(system.mass, slot);
        let mut block = [mass, mass, mass, R::ZERO, R::ZERO, R::ZERO];
        for incidence in incidences {
            let [x, y, z] = fetch(read(&matrix.axis), incidence.spring);
            let across = at(matrix.across, incidence.spring);
            let stretch = at(matrix.along, incidence.spring) - across;
            let [xx, yy, zz, xy, xz, yz] = block;
            block = [
                xx + across + stretch * x * x,
                yy + across + stretch * y * y,
                zz + across + stretch * z * z,
                xy + stretch * x * y,
                xz + stretch * x * z,
                yz + stretch * y * z,
            ];
        }
        for (column, entry) in blocks.iter_mut().zip(inverse(block)) {
            put(column, slot, entry);
        }
    }
}

/// By cofactors.
fn inverse<R: Real>([xx, yy, zz, xy, xz, yz]: [R; 6]) -> [R; 6] {
    let c_xx = yy * zz - yz * yz;
    let c_xy = xz * yz - xy * zz;
    let c_xz = xy * yz - xz * yy;
    let determinant = xx * c_xx + xy * c_xy + xz * c_xz;
    let scale = R::ONE / determinant;
    if !(scale.is_finite() && scale > R::ZERO) {
        // Rounding has eaten the determinant: the diagonal alone still helps.
        return [R::ONE / xx, R::ONE / yy, R::ONE / zz, R::ZERO, R::ZERO, R::ZERO];
    }
    [
        scale * c_xx,
        scale * (xx * zz - xz * xz),
        scale * (xx * yy - xy * xy),
        scale * c_xy,
        scale * c_xz,
        scale * (xy * xz - xx * yz),
    ]
}

/// The inverse block of a slot times a vector.
#[inline(always)]
pub fn apply<R: Real>(blocks: &Blocks<'_, R>, slot: u32, [x, y, z]: [R; 3]) -> [R; 3] {
    let [xx, yy, zz, xy, xz, yz] = blocks.each_ref().map(|column| at(column, slot));
    [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z]
}
