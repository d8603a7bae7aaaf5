//! The pixels that everything is drawn on.

use super::colours::{BACKGROUND, Colour};

/// An opaque picture: rows from the top, pixels from the left, four bytes each (red, green, blue, 255).
#[derive(Clone, Debug)]
pub struct Canvas {
    size: [usize; 2],
    pixels: Vec<[u8; 4]>,
}

impl Canvas {
    /// A blank picture of this many pixels across and down.
    #[must_use]
    pub(super) fn new(size: [u32; 2]) -> Self {
        let size = size.map(|side| side as usize);
        let pixels = vec![opaque(BACKGROUND); size[0] * size[1]];
        Self { size, pixels }
    }

    /// Pixels across.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.size[0] as u32
    }

    /// Pixels down.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.size[1] as u32
    }

    /// The bytes, four a pixel.
    #[must_use]
    pub fn data(&self) -> &[u8] {
        self.pixels.as_flattened()
    }

    /// The pixels, row after row.
    #[must_use]
    pub fn pixels(&self) -> &[[u8; 4]] {
        &self.pixels
    }

    /// The colour at this many pixels from the left and from the top, if that is inside.
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> Option<Colour> {
        let (x, y) = (x as usize, y as usize);
        if x >= self.size[0] || y >= self.size[1] {
            return None;
        }
        let [red, green, blue, _] = *self.pixels.get(y * self.size[0] + x)?;
        Some([red, green, blue])
    }

    pub(super) fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Makes this the same picture as another of the same size.
    pub(super) fn copy_from(&mut self, other: &Self) {
        self.size = other.size;
        self.pixels.clone_from(&other.pixels);
    }

    pub(super) fn pixels_mut(&mut self) -> &mut [[u8; 4]] {
        &mut self.pixels
    }

    /// Lays a colour over one pixel, `coverage` from 0 to 1.
    #[inline]
    pub(super) fn cover(&mut self, index: usize, colour: Colour, coverage: f32) {
        if let Some(pixel) = self.pixels.get_mut(index) {
            cover_pixel(pixel, colour, coverage);
        }
    }
}

/// Lays a colour over a pixel, `coverage` from 0 to 1.
#[inline]
pub(super) fn cover_pixel(pixel: &mut [u8; 4], colour: Colour, coverage: f32) {
    // In 256ths, so that full coverage is exactly the colour.
    let share = (coverage * 256.0 + 0.5) as i32;
    for (old, new) in pixel.iter_mut().zip(colour) {
        let from = i32::from(*old);
        *old = (from + (((i32::from(new) - from) * share + 128) >> 8)) as u8;
    }
}

/// A colour as a pixel.
pub(super) fn opaque([red, green, blue]: Colour) -> [u8; 4] {
    [red, green, blue, 255]
}
