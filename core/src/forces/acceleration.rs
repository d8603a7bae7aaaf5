//! From the sums of forces on the particles of a tile to their accelerations, and on to what is made of them, in one
//! loop.

use core::ops::Range;

use crate::Real;
use crate::compiled::HotLoops;
use crate::lanes::{Kernel, Present, Set};
use crate::vectors::{Columns, ColumnsMut, lend, part, read, triples};
use crate::world::System;

/// Where the accelerations of a tile's particles come from: one for the whole tile, so that it is asked once, not for each of
/// them.
#[derive(Clone, Copy, Debug)]
pub enum Origin {
    /// [`Pulled`]
    Pulled,
    /// [`Falling`]
    Falling,
    /// [`Known`]
    Known,
}

/// How a particle's acceleration is made.
pub trait Rule<R>: Copy {
    /// Along one axis, in a field g, given 1/m, the force (N) from springs to lower slots and that from springs to
    /// higher ones.
    fn along(self, g: R, inverse_mass: R, below: R, above: R) -> R;
}

/// a = g + f/m, or 0 where held.
#[derive(Clone, Copy)]
pub struct Pulled;

impl<R: Real> Rule<R> for Pulled {
    #[inline(always)]
    fn along(self, g: R, inverse_mass: R, below: R, above: R) -> R {
        let acceleration = g + inverse_mass * (below + above);
        // Held, whatever pulls: 0 times an infinite force would not be 0.
        if inverse_mass == R::ZERO { R::ZERO } else { acceleration }
    }
}

/// a = g, or 0 where held: no spring pulls.
#[derive(Clone, Copy)]
pub struct Falling;

impl<R: Real> Rule<R> for Falling {
    #[inline(always)]
    fn along(self, g: R, inverse_mass: R, _below: R, _above: R) -> R {
        if inverse_mass == R::ZERO { R::ZERO } else { g }
    }
}

/// It is known, and stands in place of the force from below.
#[derive(Clone, Copy)]
pub struct Known;

impl<R: Real> Rule<R> for Known {
    #[inline(always)]
    fn along(self, _g: R, _inverse_mass: R, below: R, _above: R) -> R {
        below
    }
}

/// The particles of a tile, and what their accelerations are to be made of.
pub struct Tile<'a, R> {
    pub slots: Range<u32>,
    /// N, from springs to lower slots; m/s², where accelerations are known.
    pub below: ColumnsMut<'a, R>,
    pub rest: Rest<'a, R>,
}

/// What else they are made of.
#[derive(Clone, Copy)]
pub struct Rest<'a, R> {
    /// N, from springs to higher slots.
    above: Columns<'a, R>,
    /// 1/kg
    inverse_mass: &'a [R],
    /// m/s²
    gravity: [R; 3],
    pub lanes: Present,
    pub origin: Origin,
}

impl<'a, R: Real> Tile<'a, R> {
    /// With the inverse masses of these particles.
    #[inline(always)]
    pub fn of(
        system: &System<'a, R>,
        slots: Range<u32>,
        below: ColumnsMut<'a, R>,
        above: Columns<'a, R>,
        inverse_mass: &'a [R],
        origin: Origin,
    ) -> Self {
        let rest = Rest { above, inverse_mass, gravity: system.gravity, lanes: system.lanes, origin };
        Self { slots, below, rest }
    }

    /// Of particles whose accelerations have been written.
    pub fn known(system: &System<'a, R>, slots: Range<u32>, accelerations: ColumnsMut<'a, R>) -> Option<Self> {
        let inverse_mass = part(system.inverse_mass, slots.clone())?;
        // Of a length with the others: what is in it is not looked at.
        let above = [inverse_mass; 3];
        Some(Self::of(system, slots, accelerations, above, inverse_mass, Origin::Known))
    }

    /// Writes the accelerations in place of the forces from below, and lends them.
    #[inline(always)]
    pub fn fresh(&mut self) -> Columns<'_, R> {
        // `plain.rs` has written them already.
        if !cfg!(feature = "small") {
            R::Loops::write_accelerations(self.rest.lanes, Write { below: lend(&mut self.below), rest: self.rest });
            self.rest.origin = Origin::Known;
        }
        read(&self.below)
    }
}

/// The inverse masses of a tile's particles: that of the plan's particles of one mass in `uniform`, if at all, as often as
/// a tile has particles, which is in the first cache where their own may not be. Nothing if they are not known.
#[inline(always)]
pub fn inverse_masses<'a, R: Real>(system: &System<'a, R>, slots: &Range<u32>, uniform: &'a [R]) -> Option<&'a [R]> {
    let of_one_mass = &system.plan.of_one_mass;
    let is_uniform = !uniform.is_empty() && of_one_mass.0 <= slots.start && slots.end <= of_one_mass.1;
    if is_uniform { part(uniform, 0..slots.end - slots.start) } else { part(system.inverse_mass, slots.clone()) }
}

/// Accelerations in place of forces from below.
pub struct Write<'a, 'b, R> {
    below: ColumnsMut<'a, R>,
    rest: Rest<'b, R>,
}

impl<R: Real> Kernel for Write<'_, '_, R> {
    type Output = ();

    #[inline(always)]
    fn run(self, _set: impl Set) {
        match self.rest.origin {
            Origin::Pulled => self.by(Pulled),
            Origin::Falling => self.by(Falling),
            Origin::Known => {}
        }
    }
}

impl<R: Real> Write<'_, '_, R> {
    #[inline(always)]
    fn by(self, rule: impl Rule<R>) {
        let Rest { above, inverse_mass, gravity, .. } = self.rest;
        for ((below, above), g) in self.below.into_iter().zip(above).zip(gravity) {
            write_along(rule, g, inverse_mass, below, above);
        }
    }
}

/// Along one axis.
#[cfg_attr(feature = "compact", inline(never))]
#[cfg_attr(not(feature = "compact"), inline(always))]
pub fn write_along<R: Real>(rule: impl Rule<R>, g: R, inverse_mass: &[R], below: &mut [R], above: &[R]) {
    for ((below, above), inverse_mass) in below.iter_mut().zip(above).zip(inverse_mass) {
        *below = rule.along(g, *inverse_mass, *below, *above);
    }
}

impl<'a, R: Real> Rest<'a, R> {
    /// For each particle, what makes its acceleration of the force from below.
    #[inline(always)]
    pub fn accelerations<A: Rule<R> + 'a>(self, rule: A) -> impl Iterator<Item = impl Fn([R; 3]) -> [R; 3]> + 'a {
        let Self { above, inverse_mass, gravity: [g_x, g_y, g_z], .. } = self;
        triples(above).zip(inverse_mass).map(move |([above_x, above_y, above_z], w)| {
            move |[below_x, below_y, below_z]: [R; 3]| {
                [
                    rule.along(g_x, *w, below_x, above_x),
                    rule.along(g_y, *w, below_y, above_y),
                    rule.along(g_z, *w, below_z, above_z),
                ]
            }
        })
    }
}
