//! One number for a whole state, bit by bit: two machines that tell the same one have the same bits.
#![no_std]

use hooke::{Real, View};

/// FNV-1a (Fowler, Noll and Vo) over the little-endian bits of all positions (m) and velocities (m/s), by particle number.
///
/// A 32-bit number is widened first: that is exact, and as telling.
#[must_use]
pub fn of<R: Real>(view: &View<'_, R>) -> u64 {
    view.states().fold(OF_NOTHING, |digest, (position, velocity)| {
        let [x, v]: [[R::Coordinate; 3]; 2] = [position.into(), velocity.into()];
        with(digest, [x.map(Real::to_f64), v.map(Real::to_f64)])
    })
}

/// That of no particles.
pub const OF_NOTHING: u64 = 0xcbf2_9ce4_8422_2325;

/// A digest with one particle more: its position (m) and its velocity (m/s).
#[must_use]
pub fn with(digest: u64, state: [[f64; 3]; 2]) -> u64 {
    let mut digest = digest;
    for component in state.as_flattened() {
        let mut bits = component.to_bits();
        for _ in 0..size_of_val(&bits) {
            digest = (digest ^ (bits & 0xff)).wrapping_mul(0x0000_0100_0000_01b3);
            bits >>= 8;
        }
    }
    digest
}
