//! Numbers without a pattern, the same on every machine.

/// Three numbers from −1 to 1, by the mixing function of Steele, Lea and Flood's SplitMix64 (2014).
pub fn noise(number: u64) -> [f64; 3] {
    [1, 2, 3].map(|axis| {
        let mut bits = (3 * number + axis).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    })
}
