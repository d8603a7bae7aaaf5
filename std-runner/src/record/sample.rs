//! What a recording needs of a number: its bytes, and its shortest text.

use hooke::Real;

/// A number that arrays can be recorded of: `f32`, `f64` or `u32`.
pub trait Element: Sized {
    /// Its type as NumPy spells it, little-endian: `<f4`, say.
    const NPY_TYPE: &'static str;
    /// How many bytes one takes.
    const SIZE: u64;

    /// Appends the numbers' bytes, little-endian.
    fn append_bytes(numbers: &[Self], bytes: &mut Vec<u8>);
}

/// A real number that can be recorded: `f32` or `f64`.
pub trait Sample: Real<Coordinate = Self> + Element + Send + 'static {
    /// Appends the shortest decimal text that reads back to the same bits; `NaN`, `inf` or `-inf` if it isn't finite.
    fn append_text(self, text: &mut Vec<u8>);
}

macro_rules! element {
    ($type:ident, $npy_type:literal, $size:literal) => {
        impl Element for $type {
            const NPY_TYPE: &'static str = $npy_type;
            const SIZE: u64 = $size;

            fn append_bytes(numbers: &[Self], bytes: &mut Vec<u8>) {
                let start = bytes.len();
                bytes.resize(start + size_of_val(numbers), 0);
                let (places, _) = bytes[start..].as_chunks_mut::<$size>();
                for (place, number) in places.iter_mut().zip(numbers) {
                    *place = number.to_le_bytes();
                }
            }
        }
    };
}

element!(f32, "<f4", 4);
element!(f64, "<f8", 8);
element!(u32, "<u4", 4);

macro_rules! sample {
    ($type:ident) => {
        impl Sample for $type {
            fn append_text(self, text: &mut Vec<u8>) {
                let mut digits = zmij::Buffer::new();
                if self.is_finite() {
                    super::decimal::append_shortest(digits.format_finite(self).as_bytes(), text);
                } else {
                    text.extend_from_slice(digits.format(self).as_bytes());
                }
            }
        }
    };
}

sample!(f32);
sample!(f64);
