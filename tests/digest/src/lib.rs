//! One number for a whole state, bit by bit: two machines that tell the same one have the same bits.
#![no_std]

use hooke::{Real, View};

/// FNV-1a (Fowler, Noll and Vo) over the little-endian bits of all positions (m) and velocities (m/s), by particle number.
///
/// A 32-bit number is widened first: that is exact, and as telling.
#[must_use]
pub fn of<R: Real>(view: &View<'_, R>) -> u64 {
    let mut digest = 0xcbf2_9ce4_8422_2325;
    for (position, velocity) in view.states() {
        let [x, v]: [[R::Coordinate; 3]; 2] = [position.into(), velocity.into()];
        for component in x.iter().chain(&v) {
            for byte in component.to_f64().to_bits().to_le_bytes() {
                digest = (digest ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
            }
        }
    }
    digest
}
