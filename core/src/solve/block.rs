//! Arithmetic of 3 × 3 blocks, which a matrix of particles is made of.

use crate::Real;
use crate::vectors::{along, dot};

/// By rows, each padded to four: a row is one vector of a machine that has such, and half of the arithmetic is saved.
pub type Block<R> = [[R; 4]; 3];

/// A symmetric block: xx, yy, zz, xy, xz, yz.
pub type Symmetric<R> = [R; 6];

/// A symmetric block taken apart, C·D·Cᵀ: what C has below its diagonal of ones (yx, zx, zy), and 1/D.
pub type Pivot<R> = [R; 6];

/// m + s n nᵀ + t I
#[inline(always)]
pub fn add_spring<R: Real>([xx, yy, zz, xy, xz, yz]: Symmetric<R>, [x, y, z]: [R; 3], s: R, t: R) -> Symmetric<R> {
    let [sx, sy, sz] = [s * x, s * y, s * z];
    [xx + t + sx * x, yy + t + sy * y, zz + t + sz * z, xy + sx * y, xz + sx * z, yz + sy * z]
}

/// m − s n nᵀ − t I
#[inline(always)]
pub fn subtract_spring<R: Real>(block: &mut Block<R>, n: [R; 3], s: R, t: R) {
    let [[xx, xy, xz, _], [yx, yy, yz, _], [zx, zy, zz, _]] = *block;
    let [dxx, dyy, dzz, dxy, dxz, dyz] = add_spring(const { [R::ZERO; 6] }, n, s, t);
    *block = [
        [xx - dxx, xy - dxy, xz - dxz, R::ZERO],
        [yx - dxy, yy - dyy, yz - dyz, R::ZERO],
        [zx - dxz, zy - dyz, zz - dzz, R::ZERO],
    ];
}

/// m v
#[inline(always)]
pub fn times_symmetric<R: Real>([xx, yy, zz, xy, xz, yz]: Symmetric<R>, [x, y, z]: [R; 3]) -> [R; 3] {
    [xx * x + xy * y + xz * z, xy * x + yy * y + yz * z, xz * x + yz * y + zz * z]
}

/// The inverse of a positive definite block, by cofactors.
pub fn inverse<R: Real>([xx, yy, zz, xy, xz, yz]: Symmetric<R>) -> Symmetric<R> {
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

/// C·D·Cᵀ of a symmetric block, and D. Nothing if it is not positive definite.
#[inline(always)]
pub fn take_apart<R: Real>([xx, yy, zz, xy, xz, yz]: Symmetric<R>) -> Option<(Pivot<R>, [R; 3])> {
    let inverse_x = R::ONE / xx;
    let (c_yx, c_zx) = (xy * inverse_x, xz * inverse_x);
    let y = yy - c_yx * xy;
    let inverse_y = R::ONE / y;
    let left = yz - c_zx * xy;
    let c_zy = left * inverse_y;
    let z = zz - c_zx * xz - c_zy * left;
    let inverse_z = R::ONE / z;
    let inverses = [inverse_x, inverse_y, inverse_z];
    // An infinite pivot is caught by its inverse, 0.
    if !inverses.iter().all(|inverse| *inverse > R::ZERO && inverse.is_finite()) {
        return None;
    }
    Some(([c_yx, c_zx, c_zy, inverse_x, inverse_y, inverse_z], [xx, y, z]))
}

/// b C⁻ᵀ D⁻¹
#[inline(always)]
pub fn divide<R: Real>(block: &mut Block<R>, [c_yx, c_zx, c_zy, x, y, z]: Pivot<R>) {
    for row in block {
        let [a, b, c, _] = *row;
        let b = b - a * c_yx;
        let c = c - a * c_zx - b * c_zy;
        *row = [a * x, b * y, c * z, R::ZERO];
    }
}

/// b D
#[inline(always)]
pub fn times_diagonal<R: Real>(mut block: Block<R>, [x, y, z]: [R; 3]) -> Block<R> {
    for row in &mut block {
        let [a, b, c, _] = *row;
        *row = [a * x, b * y, c * z, R::ZERO];
    }
    block
}

/// m − a b
#[inline(always)]
pub fn subtract_product<R: Real>(m: &mut Block<R>, a: &Block<R>, b: &Block<R>) {
    let [[x0, x1, x2, x3], [y0, y1, y2, y3], [z0, z1, z2, z3]] = *b;
    for (row, [a, b, c, _]) in m.iter_mut().zip(*a) {
        let [m, n, o, p] = *row;
        *row = [
            m - (a * x0 + b * y0 + c * z0),
            n - (a * x1 + b * y1 + c * z1),
            o - (a * x2 + b * y2 + c * z2),
            p - (a * x3 + b * y3 + c * z3),
        ];
    }
}

/// m − a bᵀ where that is symmetric.
#[inline(always)]
pub fn subtract_symmetric<R: Real>(block: &mut Symmetric<R>, a: &Block<R>, b: &Block<R>) {
    let ([x, y, z], [u, v, w]) = (rows(a), rows(b));
    let [xx, yy, zz, xy, xz, yz] = *block;
    *block = [xx - dot(x, u), yy - dot(y, v), zz - dot(z, w), xy - dot(x, v), xz - dot(x, w), yz - dot(y, w)];
}

/// v − b u
#[inline(always)]
pub fn subtract_rows<R: Real>([x, y, z]: [R; 3], block: &Block<R>, u: [R; 3]) -> [R; 3] {
    let [a, b, c] = rows(block);
    [x - dot(a, u), y - dot(b, u), z - dot(c, u)]
}

/// v − bᵀ u
#[inline(always)]
pub fn subtract_columns<R: Real>(v: [R; 3], block: &Block<R>, [x, y, z]: [R; 3]) -> [R; 3] {
    let [a, b, c] = rows(block);
    along(along(along(v, -x, a), -y, b), -z, c)
}

#[inline(always)]
fn rows<R: Real>(block: &Block<R>) -> [[R; 3]; 3] {
    let [[a, b, c, _], [d, e, f, _], [g, h, i, _]] = *block;
    [[a, b, c], [d, e, f], [g, h, i]]
}

/// bᵀ
#[inline(always)]
pub fn transposed<R: Real>([[a, b, c, _], [d, e, f, _], [g, h, i, _]]: Block<R>) -> Block<R> {
    [[a, d, g, R::ZERO], [b, e, h, R::ZERO], [c, f, i, R::ZERO]]
}

/// C⁻¹ v
#[inline(always)]
pub fn solve_lower<R: Real>([c_yx, c_zx, c_zy, ..]: Pivot<R>, [x, y, z]: [R; 3]) -> [R; 3] {
    let y = y - c_yx * x;
    [x, y, z - c_zx * x - c_zy * y]
}

/// D⁻¹ v
#[inline(always)]
pub fn solve_diagonal<R: Real>([_, _, _, inverse_x, inverse_y, inverse_z]: Pivot<R>, [x, y, z]: [R; 3]) -> [R; 3] {
    [inverse_x * x, inverse_y * y, inverse_z * z]
}

/// C⁻ᵀ v
#[inline(always)]
pub fn solve_upper<R: Real>([c_yx, c_zx, c_zy, ..]: Pivot<R>, [x, y, z]: [R; 3]) -> [R; 3] {
    let y = y - c_zy * z;
    [x - c_yx * y - c_zx * z, y, z]
}
