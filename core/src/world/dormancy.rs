//! What only worlds whose islands may sleep need: reached through pointers that [`crate::Container::set_sleep`] sets, so that
//! a program that lets nothing sleep does not contain it.

use super::islands::arrange;
use super::layout::{ParticleColumns, SpringColumns};
use super::prepare::{Layout, settle};
use super::rest::Mark;
use super::storage::{Column, Storage};
use super::view::incidences_of;
use crate::Real;
use crate::sleep::Sleeping;
use crate::types::Sleep;
use crate::vectors::{at, put};

/// Gives islands slots of their own: `islands::arrange`.
pub type Arrange<R, M> = fn(&mut ParticleColumns<R, M>, &mut SpringColumns<R, M>, usize, bool) -> (Layout, bool);

/// Wakes what a change to a slot concerns: `touch`.
pub type Touch<R, M> = fn(&mut ParticleColumns<R, M>, &SpringColumns<R, M>, u32) -> bool;

/// When islands sleep, and what that takes.
pub struct Dormancy<R: Real, M: Storage> {
    pub sleeping: Sleeping<R>,
    pub arrange: Arrange<R, M>,
    pub settle: fn(&mut ParticleColumns<R, M>, u32, usize),
    pub touch: Touch<R, M>,
}

impl<R: Real, M: Storage> Dormancy<R, M> {
    pub fn new(sleep: Sleep<R>) -> Self {
        Self { sleeping: Sleeping::new(sleep), arrange, settle, touch }
    }
}

impl<R: Real, M: Storage> Clone for Dormancy<R, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R: Real, M: Storage> Copy for Dormancy<R, M> {}

/// Touches a particle: the island that it belongs to, and those that hang on it, wake. Returns whether any slept.
fn touch<R: Real, M: Storage>(particles: &mut ParticleColumns<R, M>, springs: &SpringColumns<R, M>, slot: u32) -> bool {
    let ParticleColumns { inverse_mass, incidence_end, particle_at, rest, .. } = particles;
    let is_dynamic = |slot: &u32| at(inverse_mass.items(), *slot) > R::ZERO;
    let mut any_slept = false;
    let mut touch = |slot: u32| {
        let particle = at(particle_at.items(), slot);
        let mark = Mark::from_byte(at(rest.items(), particle));
        any_slept |= mark.is_asleep();
        put(rest.items_mut(), particle, mark.awake().stirred().to_byte());
    };
    touch(slot);
    let springs = springs.incidences.items().as_flattened();
    let neighbours = incidences_of(slot, incidence_end.items(), springs).iter().map(|spring| spring.neighbour);
    neighbours.filter(is_dynamic).for_each(touch);
    any_slept
}
