//! The words and the colour scale around the picture.

use super::canvas::Canvas;
use super::colours::{BACKGROUND, INK, StrainScale, blend, strain_colour};
use super::text::{Anchor, Typeface};

/// What is written on the pictures of one run.
#[derive(Clone, Debug)]
pub(super) struct Legend {
    typeface: Typeface,
    name: String,
    /// How large everything is: 1 at 480 pixels high.
    scale: f32,
    /// Digits of the time after the point.
    decimals: usize,
    last_time: Option<f64>,
}

impl Legend {
    pub(super) fn new(name: &str, size: [u32; 2]) -> Self {
        let typeface = Typeface::new();
        let scale = (size[1] as f32 / 480.0).clamp(0.75, 4.0);
        // The other end of the line is for the time.
        let name = typeface.fit(name, 17.0 * scale, size[0] as f32 - 160.0 * scale);
        Self { typeface, name, scale, decimals: 2, last_time: None }
    }

    /// Writes the name at the top left and the time at the top right.
    pub(super) fn write_time(&mut self, canvas: &mut Canvas, time: f64) {
        // As many digits as tell two frames apart.
        let step = self.last_time.map_or(0.0, |last| (time - last).abs());
        if step > 0.0 && step.is_finite() {
            self.decimals = self.decimals.max((-(step * 1.001).log10()).ceil().clamp(0.0, 9.0) as usize);
        }
        self.last_time = Some(time);
        let (scale, width) = (self.scale, canvas.width() as f32);
        let baseline = 27.0 * scale;
        let quiet = blend(INK, BACKGROUND, 0.25);
        self.typeface.write(canvas, &self.name, [16.0 * scale, baseline], 17.0 * scale, Anchor::Left, quiet);
        let text = format!("t = {time:.*} s", self.decimals);
        self.typeface.write(canvas, &text, [width - 16.0 * scale, baseline], 19.0 * scale, Anchor::Right, INK);
    }

    /// Draws the colour scale at the bottom right.
    pub(super) fn draw_scale(&self, canvas: &mut Canvas, strain: &StrainScale) {
        let scale = self.scale;
        let [width, height] = canvas.size();
        let long = (150.0 * scale).min(width as f32 * 0.5);
        let left = width as f32 - 30.0 * scale - long;
        let top = height as f32 - 34.0 * scale;
        // Each half has a scale of its own, as far as strains go; the colours are of one.
        let shortest = (-strain.start() / strain.end()) as f32;
        for row in 0..(8.0 * scale).max(2.0) as usize {
            for column in 0..long as usize {
                let part = (column as f32 + 0.5) / long * 2.0 - 1.0;
                let colour = strain_colour(if part < 0.0 { part * shortest } else { part });
                let (x, y) = (left as usize + column, top as usize + row);
                if x < width && y < height {
                    canvas.cover(y * width + x, colour, 1.0);
                }
            }
        }
        let [least, most] = [-strain.start(), strain.end()].map(|strain| strain * 100.0);
        let baseline = height as f32 - 11.0 * scale;
        let above = if strain.is_passed() { "≥ " } else { "" };
        let below = if strain.is_passed() && least < 100.0 { "≤ " } else { "" };
        let labels = [format!("{below}−{least} %"), "0".to_owned(), format!("{above}+{most} %")];
        for (place, label) in labels.iter().enumerate() {
            let at = [left + long * place as f32 * 0.5, baseline];
            self.typeface.write(canvas, label, at, 14.0 * scale, Anchor::Middle, INK);
        }
        let at = [left - 10.0 * scale, top + 8.5 * scale];
        self.typeface.write(canvas, "strain", at, 15.0 * scale, Anchor::Right, INK);
    }
}
