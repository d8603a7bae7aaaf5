//! Rest on planes: which of them hold a particle up, and what they leave of its acceleration.

use core::ops::Range;

use crate::Real;
use crate::reach::Reach;
use crate::rounding::rounding;
use crate::types::Plane;
use crate::vectors::{Columns, ColumnsMut, across, at, cross, dot, fetch, read, scaled, size, store};
use crate::world::System;

/// The directions that planes take from a particle at rest on them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Support<R> {
    /// None: no plane presses.
    #[default]
    None,
    /// The normal of one plane.
    Normal([R; 3]),
    /// All but the line along which two planes meet.
    AllBut([R; 3]),
    /// All: it sits in a corner.
    All,
}

impl<R: Real> Support<R> {
    /// What is left of a vector.
    #[cfg_attr(feature = "compact", inline(never))]
    #[cfg_attr(not(feature = "compact"), inline)]
    pub fn allow(self, vector: [R; 3]) -> [R; 3] {
        match self {
            Self::None => vector,
            Self::Normal(normal) => across(vector, normal),
            Self::AllBut(line) => scaled(dot(line, vector), line),
            Self::All => const { [R::ZERO; 3] },
        }
    }
}

/// The gap (m) up to which a particle counts as touching a plane.
#[inline(always)]
pub fn touching<R: Real>(plane: &Plane<R>, position: [R; 3]) -> R {
    rounding(size(position) + plane.offset.abs())
}

/// The normal speed (m/s) up to which a particle counts as neither coming nor going.
#[inline(always)]
pub fn resting<R: Real>(velocity: [R; 3]) -> R {
    rounding(size(velocity))
}

/// Whether a particle lies on a plane, or beyond it, without moving away from it or into it.
#[inline(always)]
pub fn lies_on<R: Real>(plane: &Plane<R>, position: [R; 3], velocity: [R; 3]) -> bool {
    (plane.gap(position) <= touching(plane, position)) & (dot(plane.normal, velocity).abs() <= resting(velocity))
}

/// The planes that hold a particle up against the acceleration a: those that it lies on and that a presses it
/// against.
pub fn support<R: Real>(planes: &[Plane<R>], position: [R; 3], velocity: [R; 3], a: [R; 3]) -> Support<R> {
    support_by(planes, a, |plane| lies_on(plane, position, velocity))
}

/// Of the planes that are touched, those that hold up against a, so that what they leave of it is the allowed vector
/// nearest to it (Gauss's principle of least constraint).
pub fn support_by<R: Real>(planes: &[Plane<R>], a: [R; 3], is_touched: impl Fn(&Plane<R>) -> bool) -> Support<R> {
    let touched = |plane: &&Plane<R>| is_touched(plane);
    let pressed = |plane: &&Plane<R>| dot(plane.normal, a) < R::ZERO;
    let allowed = |vector: [R; 3], but: [&Plane<R>; 2]| {
        let others = planes.iter().filter(|plane| !but.iter().any(|other| core::ptr::eq(*plane, *other)));
        others.filter(touched).all(|plane| dot(plane.normal, vector) >= -rounding(size(a)))
    };
    let mut presses = planes.iter().filter(pressed).filter(touched);
    let Some(first) = presses.next() else { return Support::None };
    for plane in core::iter::once(first).chain(presses) {
        let one = Support::Normal(plane.normal);
        if allowed(one.allow(a), [plane, plane]) {
            return one;
        }
    }
    for first in planes.iter().filter(pressed).filter(touched) {
        for second in planes.iter().filter(touched) {
            let line = cross(first.normal, second.normal);
            let length = dot(line, line).sqrt();
            if length <= R::EPSILON {
                continue;
            }
            let two = Support::AllBut(scaled(R::ONE / length, line));
            if allowed(two.allow(a), [first, second]) && push_apart(first, second, a) {
                return two;
            }
        }
    }
    Support::All
}

/// Whether both planes push, rather than pull, to keep a on the line where they meet.
fn push_apart<R: Real>(first: &Plane<R>, second: &Plane<R>, a: [R; 3]) -> bool {
    // a + λ₁ n₁ + λ₂ n₂ has no component along n₁ or n₂.
    let cosine = dot(first.normal, second.normal);
    let (b_1, b_2) = (dot(first.normal, a), dot(second.normal, a));
    let nothing = rounding(size(a));
    b_1 - cosine * b_2 <= nothing && b_2 - cosine * b_1 <= nothing
}

/// [`hold_up`], where a response asks for it: a program without one does not contain it.
pub type HoldUp<R> = fn(&System<'_, R>, Range<u32>, Columns<'_, R>, Columns<'_, R>, ColumnsMut<'_, R>);

/// Takes from the accelerations of the particles in these slots what planes hold up.
pub fn hold_up<R: Real>(
    system: &System<'_, R>,
    slots: Range<u32>,
    position: Columns<'_, R>,
    velocity: Columns<'_, R>,
    mut accelerations: ColumnsMut<'_, R>,
) {
    if system.planes.is_empty() {
        return;
    }
    let reach = Reach::at(system.lanes, position, slots.clone());
    if !system.planes.iter().any(|plane| reach.may_meet(plane)) {
        return;
    }
    for (index, slot) in (0..).zip(slots) {
        if at(system.inverse_mass, slot) == R::ZERO {
            continue;
        }
        let a = fetch(read(&accelerations), index);
        let supported = support(system.planes, fetch(position, slot), fetch(velocity, slot), a);
        if supported != Support::None {
            store(&mut accelerations, index, supported.allow(a));
        }
    }
}
