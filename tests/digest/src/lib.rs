//! One number for a whole state, bit by bit: two machines that tell the same one have the same bits.
#![no_std]

use hooke::{Real, View};

/// FNV-1a (Fowler, Noll and Vo) over the little-endian bits of all positions (m) and velocities (m/s), by particle number.
///
/// A 32-bit number is widened first: that is exact, and as telling.
#[must_use]
pub fn of<R: Real>(view: &View<'_, R>) -> u64 {
    view.states().fold(0xcbf2_9ce4_8422_2325, |digest, (position, velocity)| {
        let [x, v]: [[R::Coordinate; 3]; 2] = [position.into(), velocity.into()];
        let bytes = x.into_iter().chain(v).flat_map(|component| component.to_f64().to_bits().to_le_bytes());
        bytes.fold(digest, |digest, byte| (digest ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
    })
}
