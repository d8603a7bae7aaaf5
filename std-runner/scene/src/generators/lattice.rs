//! Particles in a straight grid of one, two or three sides, and the springs between its neighbours.

use glam::DVec3;

use crate::model::{Hold, ModelParticle, ModelSpring};

use super::super::spring::Law;

/// A place in a lattice: along its first, second and third side.
pub(super) type Place = [u32; 3];

/// A grid of particles. The place along the first side changes fastest from one number to the next.
pub(super) struct Lattice {
    /// Particles along each side.
    pub(super) counts: [u32; 3],
    /// Where place `[0, 0, 0]` is, m.
    pub(super) corner: DVec3,
    /// From one end of each side to the other, m.
    pub(super) sides: [DVec3; 3],
}

/// What the particles of a generator have in common.
#[derive(Clone, Copy)]
pub(super) struct Common {
    /// kg
    pub(super) mass: f64,
    /// m/s
    pub(super) velocity: [f64; 3],
}

impl Common {
    /// A particle that moves with the others, or stays.
    pub(super) fn particle(self, position: [f64; 3], pinned: bool) -> ModelParticle {
        let (velocity, hold) = if pinned { ([0.0; 3], Hold::Pinned) } else { (self.velocity, Hold::Free) };
        ModelParticle { position, velocity, mass: self.mass, hold }
    }
}

impl Lattice {
    /// How many there are.
    pub(super) fn particle_count(&self) -> u128 {
        self.counts.iter().map(|&count| u128::from(count)).product()
    }

    /// How many pairs of particles differ by `offset`.
    pub(super) fn pair_count(&self, offset: [i32; 3]) -> u128 {
        let along = |axis: usize| u128::from(self.counts[axis].saturating_sub(offset[axis].unsigned_abs()));
        along(0) * along(1) * along(2)
    }

    /// All places, in the order of their numbers.
    fn places(&self) -> impl Iterator<Item = Place> {
        let [first, second, third] = self.counts;
        (0..third).flat_map(move |z| (0..second).flat_map(move |y| (0..first).map(move |x| [x, y, z])))
    }

    /// One side's part of the way to a place along it: exactly all of it at the end.
    fn along(&self, axis: usize, place: f64) -> DVec3 {
        match self.counts[axis] {
            0 | 1 => DVec3::ZERO,
            count => self.sides[axis] * (place / f64::from(count - 1)),
        }
    }

    /// The particles, in the order of their numbers.
    pub(super) fn particles(&self, common: Common, pinned: impl Fn(Place) -> bool, out: &mut Vec<ModelParticle>) {
        out.extend(self.places().map(|place| {
            let [x, y, z] = place.map(f64::from);
            let position = self.corner + self.along(0, x) + self.along(1, y) + self.along(2, z);
            common.particle(position.to_array(), pinned(place))
        }));
    }

    /// Springs from each particle to the one `offset` away, in the order of the first one's numbers.
    pub(super) fn springs(&self, first: u32, offset: [i32; 3], law: Law, out: &mut Vec<ModelSpring>) {
        // The same for all of them: rounding each particle's place must not make equal springs differ.
        let [x, y, z] = offset.map(f64::from);
        let rest_length = (self.along(0, x) + self.along(1, y) + self.along(2, z)).length();
        out.extend(self.places().filter_map(|place| {
            let other = self.neighbour(place, offset)?;
            Some(law.between([first + self.number(place), first + self.number(other)], rest_length))
        }));
    }

    /// The place `offset` away, if it is in the lattice.
    fn neighbour(&self, place: Place, offset: [i32; 3]) -> Option<Place> {
        let mut other = place;
        for axis in 0..3 {
            other[axis] = place[axis].checked_add_signed(offset[axis]).filter(|&there| there < self.counts[axis])?;
        }
        Some(other)
    }

    fn number(&self, [x, y, z]: Place) -> u32 {
        let [first, second, _] = self.counts;
        (z * second + y) * first + x
    }
}
