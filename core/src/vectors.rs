//! Vectors of three, alone and in columns: what every kernel is written with.
//!
//! Nothing here can fail: a read past the end gives 0 and a write past the end does nothing. Preparation makes sure
//! that neither happens.

use core::ops::Range;

use crate::Real;

/// Three columns, read: x, y, z of each particle.
pub type Columns<'a, R> = [&'a [R]; 3];

/// Three columns, written.
pub type ColumnsMut<'a, R> = [&'a mut [R]; 3];

/// Three written columns, lent for reading.
#[inline(always)]
pub fn read<'a, R>(columns: &'a ColumnsMut<'_, R>) -> Columns<'a, R> {
    let [x, y, z] = columns;
    [x, y, z]
}

/// Three written columns, lent on.
#[inline(always)]
pub fn lend<'a, R>(columns: &'a mut ColumnsMut<'_, R>) -> ColumnsMut<'a, R> {
    let [x, y, z] = columns;
    [x, y, z]
}

/// Item `index`, or its type's default past the end.
#[inline(always)]
pub fn at<T: Copy + Default>(items: &[T], index: u32) -> T {
    items.get(index as usize).copied().unwrap_or_default()
}

/// Sets item `index`, or nothing past the end.
#[inline(always)]
pub fn put<T>(items: &mut [T], index: u32, value: T) {
    if let Some(item) = items.get_mut(index as usize) {
        *item = value;
    }
}

/// Where the items of `index` are, in a list of which it is known where those of each index end; they begin where those of
/// the index before end.
#[cfg_attr(feature = "compact", inline(never))]
pub fn items_of(ends: &[u32], index: u32) -> Range<u32> {
    index.checked_sub(1).map_or(0, |before| at(ends, before))..at(ends, index)
}

/// The vector of particle `index`.
#[cfg_attr(feature = "compact", inline(never))]
#[cfg_attr(not(feature = "compact"), inline(always))]
pub fn fetch<T: Copy + Default>(columns: Columns<'_, T>, index: u32) -> [T; 3] {
    fetch_inlined(columns, index)
}

/// The same in a hot loop, where a call would take longer.
#[inline(always)]
pub fn fetch_inlined<T: Copy + Default>(columns: Columns<'_, T>, index: u32) -> [T; 3] {
    let ([x, y, z], index) = (columns, index as usize);
    // One way out for all three: a branch that is never taken, where three defaults would each be selected.
    let (Some(x), Some(y), Some(z)) = (x.get(index), y.get(index), z.get(index)) else {
        return [T::default(), T::default(), T::default()];
    };
    [*x, *y, *z]
}

/// Sets the vector of particle `index`.
#[cfg_attr(feature = "compact", inline(never))]
#[cfg_attr(not(feature = "compact"), inline(always))]
pub fn store<T>(columns: &mut ColumnsMut<'_, T>, index: u32, vector: [T; 3]) {
    store_inlined(columns, index, vector);
}

/// The same in a hot loop.
#[inline(always)]
pub fn store_inlined<T>([x, y, z]: &mut ColumnsMut<'_, T>, index: u32, vector: [T; 3]) {
    let index = index as usize;
    if let (Some(x), Some(y), Some(z)) = (x.get_mut(index), y.get_mut(index), z.get_mut(index)) {
        [*x, *y, *z] = vector;
    }
}

/// A vector of the surface as numbers to compute with.
pub fn rounded<R: Real>(vector: R::Vec3) -> [R; 3] {
    vector.into().map(|coordinate| R::carry(coordinate).0)
}

/// a·b
#[inline(always)]
pub fn dot<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    ax * bx + ay * by + az * bz
}

/// a − b
#[inline(always)]
pub fn difference<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    [ax - bx, ay - by, az - bz]
}

/// s a
#[inline(always)]
pub fn scaled<R: Real>(s: R, a: [R; 3]) -> [R; 3] {
    let [x, y, z] = a;
    [s * x, s * y, s * z]
}

/// In `f64`.
#[inline(always)]
pub fn exact<R: Real>([x, y, z]: [R; 3]) -> [f64; 3] {
    [x.to_f64(), y.to_f64(), z.to_f64()]
}

/// Whether all of it is 0.
#[inline(always)]
pub fn is_zero<R: Real>([x, y, z]: [R; 3]) -> bool {
    x == R::ZERO && y == R::ZERO && z == R::ZERO
}

/// a + s b
#[inline(always)]
pub fn along<R: Real>(a: [R; 3], s: R, b: [R; 3]) -> [R; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    [ax + s * bx, ay + s * by, az + s * bz]
}

/// What is left of a across the unit vector n; exactly 0 if that is no more than rounding.
///
/// One subtraction leaves a rounding of |a| along n; after the second it is a rounding of what is left ("twice is
/// enough", Parlett, *The Symmetric Eigenvalue Problem*, §6.9).
#[cfg_attr(feature = "compact", inline(never))]
#[cfg_attr(not(feature = "compact"), inline(always))]
pub fn across<R: Real>(a: [R; 3], n: [R; 3]) -> [R; 3] {
    let once = along(a, -dot(n, a), n);
    if size(once) <= R::from_f64(8.0) * R::EPSILON * size(a) {
        return const { [R::ZERO; 3] };
    }
    along(once, -dot(n, once), n)
}

/// |x| + |y| + |z|
#[inline(always)]
pub fn size<R: Real>([x, y, z]: [R; 3]) -> R {
    x.abs() + y.abs() + z.abs()
}

/// a × b
#[inline(always)]
pub fn cross<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    let ([ax, ay, az], [bx, by, bz]) = (a, b);
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

/// out = a + s b, over whole columns.
#[inline]
pub fn advance_columns<R: Real>(out: &mut ColumnsMut<'_, R>, a: &ColumnsMut<'_, R>, s: R, b: &ColumnsMut<'_, R>) {
    for ((out, a), b) in out.iter_mut().zip(a).zip(b) {
        for ((out, a), b) in out.iter_mut().zip(a.iter()).zip(b.iter()) {
            *out = *a + s * *b;
        }
    }
}

/// out = a, from an index on.
#[inline]
pub fn copy_columns<T: Copy>(out: &mut ColumnsMut<'_, T>, a: &ColumnsMut<'_, T>, first: u32) {
    let first = first as usize;
    for (out, a) in out.iter_mut().zip(a) {
        let (out, a) = (out.get_mut(first..).unwrap_or_default(), a.get(first..).unwrap_or_default());
        for (out, a) in out.iter_mut().zip(a) {
            *out = *a;
        }
    }
}

/// The same stretch of several columns; nothing of those that it does not lie in.
#[inline(always)]
pub fn window<const COLUMNS: usize, T>(columns: [&[T]; COLUMNS], range: Range<u32>) -> [&[T]; COLUMNS] {
    columns.map(|column| column.get(range.start as usize..range.end as usize).unwrap_or_default())
}

/// The same stretch of several written columns; nothing of those that it does not lie in.
#[inline(always)]
pub fn window_mut<const COLUMNS: usize, T>(columns: [&mut [T]; COLUMNS], range: Range<u32>) -> [&mut [T]; COLUMNS] {
    columns.map(|column| column.get_mut(range.start as usize..range.end as usize).unwrap_or_default())
}

/// The same stretch of three columns, or nothing if it does not lie in all of them: in what follows the compiler knows
/// that they are of one length.
#[inline(always)]
pub fn cut<T>([x, y, z]: Columns<'_, T>, range: Range<u32>) -> Option<Columns<'_, T>> {
    Some([part(x, range.clone())?, part(y, range.clone())?, part(z, range)?])
}

/// A stretch of one column, or nothing if it does not lie in it.
#[inline(always)]
pub fn part<T>(column: &[T], range: Range<u32>) -> Option<&[T]> {
    column.get(range.start as usize..range.end as usize)
}

/// So many items of three columns from an index on, or nothing if there are fewer: in what follows the compiler knows that
/// they are as many as others that were cut to this number.
#[inline(always)]
pub fn stretch<T>([x, y, z]: Columns<'_, T>, first: u32, count: usize) -> Option<Columns<'_, T>> {
    let first = first as usize;
    Some([x.get(first..)?.get(..count)?, y.get(first..)?.get(..count)?, z.get(first..)?.get(..count)?])
}

/// The same stretch of three written columns, or nothing if it does not lie in all of them.
#[inline(always)]
pub fn cut_mut<T>([x, y, z]: ColumnsMut<'_, T>, range: Range<u32>) -> Option<ColumnsMut<'_, T>> {
    let range = range.start as usize..range.end as usize;
    Some([x.get_mut(range.clone())?, y.get_mut(range.clone())?, z.get_mut(range)?])
}

/// Three written columns before and from an index.
#[inline]
pub fn split<R>([x, y, z]: ColumnsMut<'_, R>, index: u32) -> (ColumnsMut<'_, R>, ColumnsMut<'_, R>) {
    let cut =
        |column| -> (&mut [R], &mut [R]) { <[R]>::split_at_mut_checked(column, index as usize).unwrap_or_default() };
    let ((x, x_rest), (y, y_rest), (z, z_rest)) = (cut(x), cut(y), cut(z));
    ([x, y, z], [x_rest, y_rest, z_rest])
}

/// The vectors of three columns.
#[inline(always)]
pub fn triples<'a, T: Copy>([x, y, z]: Columns<'a, T>) -> impl Iterator<Item = [T; 3]> + Clone + 'a {
    x.iter().zip(y).zip(z).map(|((x, y), z)| [*x, *y, *z])
}

/// Sets a vector in written columns.
#[inline(always)]
pub fn set<T>([x, y, z]: [&mut T; 3], vector: [T; 3]) {
    [*x, *y, *z] = vector;
}

/// The vectors of three written columns.
#[inline(always)]
pub fn triples_mut<'a, T>([x, y, z]: ColumnsMut<'a, T>) -> impl Iterator<Item = [&'a mut T; 3]> {
    x.iter_mut().zip(y).zip(z).map(|((x, y), z)| [x, y, z])
}
