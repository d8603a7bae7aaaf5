//! Headers of NumPy's array format.
//!
//! A header tells how many rows its array has, and an archive's checksum covers it. So that the number of rows can
//! change without changing the checksum, each header holds a run of blanks, spaces and tabs, chosen such that the
//! CRC-32 of the whole header is 0: the CRC-32 of nothing. The checksum of header and rows is then that of the rows.

use super::little_endian::append_u16;

/// How many bytes a header takes: a multiple of 64, as NumPy advises.
pub(super) const HEADER: usize = 128;
const MAGIC: &[u8] = b"\x93NUMPY\x01\x00";
const END: &[u8] = b"}\n";
/// One for each bit of a CRC-32.
const BLANKS: usize = 32;
const FIRST_BLANK: usize = HEADER - END.len() - BLANKS;
/// What turns a space into a tab.
const BLANK_FLIP: u8 = b' ' ^ b'\t';

/// Makes the headers of one array, whatever its number of rows.
pub(super) struct Header {
    element_type: &'static str,
    /// What follows the number of rows in the shape.
    row_shape: String,
    balance: Balance,
}

impl Header {
    /// For an array of rows of this shape: no number for plain values, one for vectors, two for lists of vectors.
    pub(super) fn new(element_type: &'static str, row_shape: &[u64]) -> Self {
        let numbers: Vec<String> = row_shape.iter().map(u64::to_string).collect();
        Self { element_type, row_shape: numbers.join(", "), balance: Balance::new() }
    }

    /// Appends the header of an array of that many rows.
    pub(super) fn append(&self, rows: u64, bytes: &mut Vec<u8>) {
        let start = bytes.len();
        bytes.extend_from_slice(MAGIC);
        append_u16(bytes, (HEADER - MAGIC.len() - 2) as u16);
        let dictionary = format!(
            "{{'descr': '{}', 'fortran_order': False, 'shape': ({rows}, {}), ",
            self.element_type, self.row_shape
        );
        bytes.extend_from_slice(dictionary.as_bytes());
        // It fits: rows and row shape of an array whose size is a `u64` have 21 digits at most between them.
        bytes.resize(start + HEADER - END.len(), b' ');
        bytes.extend_from_slice(END);
        let tabs = self.balance.tabs(crc32fast::hash(&bytes[start..]));
        for (blank, byte) in bytes[start + FIRST_BLANK..][..BLANKS].iter_mut().enumerate() {
            if tabs >> blank & 1 == 1 {
                *byte ^= BLANK_FLIP;
            }
        }
    }
}

/// Which blanks to make tabs to change a header's CRC-32 in a wanted way.
///
/// A CRC is linear: a flipped blank changes it by a pattern that depends on the blank's place alone. The patterns of 32
/// neighbouring places are independent, so each change is the sum (exclusive or) of exactly one choice of them.
struct Balance {
    /// By its highest bit: a change of the CRC and the blanks that make it.
    steps: [(u32, u32); BLANKS],
}

impl Balance {
    fn new() -> Self {
        let mut steps = [(0, 0); BLANKS];
        let unchanged = crc32fast::hash(&[0; HEADER]);
        for blank in 0..BLANKS {
            let mut flipped = [0; HEADER];
            flipped[FIRST_BLANK + blank] = BLANK_FLIP;
            let mut change = crc32fast::hash(&flipped) ^ unchanged;
            let mut blanks = 1_u32 << blank;
            // Gaussian elimination: what the steps so far can make is taken out; the rest is a new step.
            for bit in (0..BLANKS).rev() {
                if change >> bit & 1 == 0 {
                    continue;
                }
                if steps[bit].0 == 0 {
                    steps[bit] = (change, blanks);
                    break;
                }
                change ^= steps[bit].0;
                blanks ^= steps[bit].1;
            }
        }
        Self { steps }
    }

    /// The blanks, a bit each, that change a CRC-32 of `checksum` to 0.
    fn tabs(&self, checksum: u32) -> u32 {
        let mut rest = checksum;
        let mut tabs = 0;
        for (bit, (change, blanks)) in self.steps.iter().enumerate().rev() {
            if rest >> bit & 1 == 1 {
                rest ^= change;
                tabs ^= blanks;
            }
        }
        tabs
    }
}
