//! A root is the number nearest to the exact one: its neighbours' halfway points, squared in integers, bracket the square.
//!
//! Two forms are tested: the one that this package's features choose, and the machine's own without the standard library.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::Real;
use hooke_tests::random::Random;

/// The same file, compiled as for a world without the standard library: this package has no feature `std`.
#[path = "../../core/src/square_root.rs"]
#[allow(unexpected_cfgs)]
mod square_root;

/// A million random patterns meet every exponent, subnormal ones too, 400 times or more in double precision.
const DRAWS: usize = 1 << 20;

/// How a number is laid out, and a root function of it.
struct Format {
    fraction_bits: u32,
    bias: i32,
    /// The roots of bit patterns, as bit patterns; in one loop, so that it vectorises.
    roots: fn(&[u64]) -> Vec<u64>,
}

const SINGLE: Format = Format { fraction_bits: 23, bias: 127, roots: |x| single(x, <f32 as Real>::sqrt) };
const DOUBLE: Format = Format { fraction_bits: 52, bias: 1023, roots: |x| double(x, <f64 as Real>::sqrt) };
const BARE_SINGLE: Format = Format { roots: |x| single(x, square_root::single), ..SINGLE };
const BARE_DOUBLE: Format = Format { roots: |x| double(x, square_root::double), ..DOUBLE };
const FORMATS: [Format; 4] = [SINGLE, DOUBLE, BARE_SINGLE, BARE_DOUBLE];

fn single(patterns: &[u64], root: impl Fn(f32) -> f32) -> Vec<u64> {
    let numbers: Vec<f32> = patterns.iter().map(|bits| f32::from_bits(*bits as u32)).collect();
    let roots: Vec<f32> = numbers.iter().map(|x| root(*x)).collect();
    roots.iter().map(|root| u64::from(root.to_bits())).collect()
}

fn double(patterns: &[u64], root: impl Fn(f64) -> f64) -> Vec<u64> {
    let numbers: Vec<f64> = patterns.iter().map(|bits| f64::from_bits(*bits)).collect();
    let roots: Vec<f64> = numbers.iter().map(|x| root(*x)).collect();
    roots.iter().map(|root| root.to_bits()).collect()
}

impl Format {
    /// The pattern of positive infinity, the first that is not a positive finite number's.
    fn infinity(&self) -> u64 {
        (2 * self.bias as u64 + 1) << self.fraction_bits
    }

    fn sign(&self) -> u64 {
        self.infinity() + (1 << self.fraction_bits)
    }

    /// n and e of the positive finite number n 2^e.
    fn parts(&self, bits: u64) -> (u128, i32) {
        let (exponent, fraction) = (bits >> self.fraction_bits, bits & ((1 << self.fraction_bits) - 1));
        let n = if exponent == 0 { fraction } else { fraction | 1 << self.fraction_bits };
        (u128::from(n), exponent.max(1) as i32 - self.bias - self.fraction_bits as i32)
    }

    /// Whether `root` is the number nearest to √`square`, both positive and finite. No tolerance: these are integers.
    fn is_root(&self, root: u64, square: u64) -> bool {
        let ((n, e), (m, f)) = (self.parts(root), self.parts(square));
        // In quarters of the last place. Just above a power of two the next smaller number is half as far.
        let below = if n == 1 << self.fraction_bits { 4 * n - 1 } else { 4 * n - 2 };
        let above = 4 * n + 2;
        let Ok(shift) = u32::try_from(f - 2 * e + 4) else { return false };
        // No halfway point has a square as short as m: nothing is ever on the edge.
        shift < m.leading_zeros() && below * below < m << shift && m << shift < above * above
    }

    /// Every pattern's root is right, and neither of its neighbours would be.
    fn hold(&self, squares: &[u64]) {
        for (square, root) in squares.iter().zip((self.roots)(squares)) {
            assert!(self.is_root(root, *square), "√{square:#x} is not {root:#x}");
            assert!(!self.is_root(root + 1, *square) && !self.is_root(root - 1, *square), "{square:#x}");
        }
    }
}

#[test]
fn of_any_number() {
    let mut random = Random::new(1);
    for format in FORMATS {
        let squares: Vec<u64> = (0..DRAWS).map(|_| 1 + random.bits() % (format.infinity() - 1)).collect();
        format.hold(&squares);
        let ends = [1, 2, (1 << format.fraction_bits) - 1, 1 << format.fraction_bits, format.infinity() - 1];
        format.hold(&ends);
    }
}

/// The two numbers on either side of a halfway point's square have different roots, and no number is harder to round.
#[test]
fn of_the_numbers_hardest_to_round() {
    let mut random = Random::new(2);
    for format in FORMATS {
        let hardest = (0..DRAWS / 2).flat_map(|_| {
            let n = (1 << format.fraction_bits) + random.below(1 << format.fraction_bits) as u128;
            let halfway = (2 * n + 1) * (2 * n + 1);
            let spare = 127 - format.fraction_bits - halfway.leading_zeros();
            // The halfway point's square is cut down to a number's length, and takes any exponent e of 2^e that leaves
            // the root's a whole number: one as odd as what was cut off.
            let fraction = (halfway >> spare) as u64 - (1 << format.fraction_bits);
            let odd = (u64::from(spare) + format.bias as u64 + u64::from(format.fraction_bits)) % 2;
            let exponent = 2 * random.below(format.bias as usize - 1) as u64 + 2 - odd;
            let square = (exponent << format.fraction_bits) + fraction;
            [square, square + 1]
        });
        let squares: Vec<u64> = hardest.collect();
        format.hold(&squares);
        let roots = (format.roots)(&squares);
        // The control: these are the two sides of a halfway point indeed.
        assert!(roots.chunks(2).all(|pair| pair[1] == pair[0] + 1));
    }
}

#[test]
fn of_the_numbers_that_have_none() {
    for format in FORMATS {
        let (infinity, sign) = (format.infinity(), format.sign());
        let itself = [0, sign, infinity];
        assert_eq!((format.roots)(&itself), itself, "0, −0 and infinity are their own roots");
        let none = [sign + 1, sign | infinity >> 1, sign | infinity, infinity + 1, sign | (infinity + 1)];
        for root in (format.roots)(&none) {
            // The bits of a NaN are not IEEE 754's to say.
            assert!(root & (sign - 1) > infinity, "{root:#x} is a number");
        }
    }
}
