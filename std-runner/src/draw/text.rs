//! Small text.

use ab_glyph::{Font, FontRef, PxScale, ScaleFont, point};

use super::canvas::Canvas;
use super::colours::Colour;

/// One typeface, its digits all of one width.
#[derive(Clone, Debug)]
pub(super) struct Typeface {
    font: Option<FontRef<'static>>,
}

/// Where text is, from the point it is placed at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Anchor {
    Left,
    Middle,
    Right,
}

impl Typeface {
    pub(super) fn new() -> Self {
        // The bytes are a constant that is known to be a font; without one, pictures would have no text.
        let font = FontRef::try_from_slice(epaint_default_fonts::UBUNTU_LIGHT).ok();
        Self { font }
    }

    /// How wide a text is, pixels.
    pub(super) fn width(&self, text: &str, height: f32) -> f32 {
        let Some(font) = &self.font else { return 0.0 };
        let font = font.as_scaled(PxScale::from(height));
        text.chars().map(|letter| advance(&font, letter)).sum()
    }

    /// As much of a text as fits into this many pixels, with an ellipsis where it was cut.
    pub(super) fn fit(&self, text: &str, height: f32, room: f32) -> String {
        let clean = |letter: char| if letter.is_control() { ' ' } else { letter };
        let text: String = text.chars().take(200).map(clean).collect();
        if self.width(&text, height) <= room {
            return text;
        }
        let mut kept = text;
        while kept.pop().is_some() {
            let shortened = format!("{}…", kept.trim_end());
            if self.width(&shortened, height) <= room {
                return shortened;
            }
        }
        kept
    }

    /// Writes text of this height in pixels, with its baseline at a point.
    pub(super) fn write(
        &self,
        canvas: &mut Canvas,
        text: &str,
        at: [f32; 2],
        height: f32,
        anchor: Anchor,
        colour: Colour,
    ) {
        let Some(font) = &self.font else { return };
        let share = match anchor {
            Anchor::Left => 0.0,
            Anchor::Middle => 0.5,
            Anchor::Right => 1.0,
        };
        let mut x = at[0] - share * self.width(text, height);
        let [width, rows] = canvas.size();
        let scaled = font.as_scaled(PxScale::from(height));
        for letter in text.chars() {
            let identity = font.glyph_id(letter);
            let step = advance(&scaled, letter);
            // A narrow digit stands in the middle of its place.
            let indent = (step - scaled.h_advance(identity)) * 0.5;
            let glyph = identity.with_scale_and_position(height, point(x + indent, at[1]));
            if let Some(outline) = font.outline_glyph(glyph) {
                let corner = outline.px_bounds().min;
                outline.draw(|column, row, coverage| {
                    let (column, row) = (corner.x as i64 + i64::from(column), corner.y as i64 + i64::from(row));
                    if (0..width as i64).contains(&column) && (0..rows as i64).contains(&row) {
                        // The face is a light one: a little more ink makes it readable when small.
                        let ink = (coverage * 1.25).clamp(0.0, 1.0);
                        canvas.cover(row as usize * width + column as usize, colour, ink);
                    }
                });
            }
            x += step;
        }
    }
}

/// How far to the next letter. All digits take the widest one's place, so that running time doesn't jitter.
fn advance<F: Font>(font: &impl ScaleFont<F>, letter: char) -> f32 {
    let shown = if letter.is_ascii_digit() { '0' } else { letter };
    font.h_advance(font.scaled_glyph(shown).id)
}
