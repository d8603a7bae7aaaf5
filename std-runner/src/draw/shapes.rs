//! Lines, balls and marks, drawn straight onto the pixels with smooth edges.
//!
//! A cloth has thousands of short lines, each of its own colour and in its own place in the order of depth.
//! A general path renderer spends most of its time preparing each of them; these loops only touch pixels.

use super::canvas::{Canvas, cover_pixel};
use super::colours::{BACKGROUND, Colour, blend};

/// Visits each pixel of a straight line, with how much of it the line covers.
///
/// `half_width` is in pixels, at least 0.5: for a thinner line, scale the coverage.
#[inline]
pub(super) fn cover_line(size: [usize; 2], ends: [[f32; 2]; 2], half_width: f32, mut visit: impl FnMut(usize, f32)) {
    let Some([from, to]) = clip(size, ends, half_width + 1.0) else {
        return;
    };
    let steep = (to[1] - from[1]).abs() > (to[0] - from[0]).abs();
    // `along` is the axis that the line mostly follows.
    let (along, across) = if steep { (1, 0) } else { (0, 1) };
    let (from, to) = if from[along] > to[along] { (to, from) } else { (from, to) };
    let run = to[along] - from[along];
    let slope = if run > 1e-6 { (to[across] - from[across]) / run } else { 0.0 };
    let reach = half_width * (1.0 + slope * slope).sqrt();
    let strides = if steep { (size[0], 1) } else { (1, size[0]) };
    let first = from[along].max(0.0) as usize;
    let last = (to[along].ceil().max(0.0) as usize).min(size[along]);
    for column in first..last {
        let start = from[along].max(column as f32);
        let end = to[along].min(column as f32 + 1.0);
        let centre = from[across] + ((start + end) * 0.5 - from[along]) * slope;
        let low = (centre - reach - 0.5).max(0.0) as usize;
        let high = ((centre + reach + 1.5).max(0.0) as usize).min(size[across]);
        for row in low..high {
            let distance = (row as f32 + 0.5 - centre).abs();
            let coverage = (reach + 0.5 - distance).clamp(0.0, 1.0) * (end - start);
            if coverage > 0.0 {
                visit(column * strides.0 + row * strides.1, coverage);
            }
        }
    }
}

/// The part of a line that lies in the picture or within `margin` pixels of it.
fn clip(size: [usize; 2], [from, to]: [[f32; 2]; 2], margin: f32) -> Option<[[f32; 2]; 2]> {
    let mut range = [0.0f32, 1.0f32];
    for axis in 0..2 {
        let (low, high) = (-margin, size[axis] as f32 + margin);
        let step = to[axis] - from[axis];
        if !step.is_finite() {
            return None;
        }
        if step == 0.0 {
            if from[axis] < low || from[axis] > high {
                return None;
            }
            continue;
        }
        let (enter, leave) = ((low - from[axis]) / step, (high - from[axis]) / step);
        range[0] = range[0].max(enter.min(leave));
        range[1] = range[1].min(enter.max(leave));
    }
    if range[0] >= range[1] {
        return None;
    }
    let at = |share: f32| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * share);
    Some([at(range[0]), at(range[1])])
}

/// Draws a straight line, `width` pixels wide; one thinner than a pixel is paler instead.
pub(super) fn line(canvas: &mut Canvas, ends: [[f32; 2]; 2], width: f32, colour: Colour) {
    let opacity = width.min(1.0);
    let size = canvas.size();
    let pixels = canvas.pixels_mut();
    cover_line(size, ends, width.max(1.0) * 0.5, |index, coverage| {
        if let Some(pixel) = pixels.get_mut(index) {
            cover_pixel(pixel, colour, coverage * opacity);
        }
    });
}

/// Draws a coil spring seen from the side; a plain line where it is short.
pub(super) fn zigzag(canvas: &mut Canvas, [from, to]: [[f32; 2]; 2], width: f32, colour: Colour) {
    const TEETH: usize = 14;
    let (x, y) = (to[0] - from[0], to[1] - from[1]);
    let length = x.hypot(y);
    let amplitude = 3.6 * width;
    // One longer than ten thousand pixels is mostly out of the picture.
    if !(length > 3.0 * width * TEETH as f32 && length < 1e4) {
        line(canvas, [from, to], width, colour);
        return;
    }
    let at = |along: f32, aside: f32| {
        let aside = aside * amplitude / length;
        [from[0] + x * along - y * aside, from[1] + y * along + x * aside]
    };
    // Straight for a tenth of the length at either end.
    let place = |tooth: f32| 0.1 + 0.8 * tooth / TEETH as f32;
    let mut last = from;
    let corners = (0..TEETH).map(|tooth| {
        let side = if tooth % 2 == 0 { 1.0 } else { -1.0 };
        at(place(tooth as f32 + 0.5), side)
    });
    let middle = [at(place(0.0), 0.0)].into_iter().chain(corners).chain([at(place(TEETH as f32), 0.0)]);
    for next in middle.chain([to]) {
        line(canvas, [last, next], width, colour);
        last = next;
    }
}

/// Draws what is within `radius` pixels of a centre: `shade` gets the offset in radii and returns colour and coverage.
fn around(canvas: &mut Canvas, centre: [f32; 2], radius: f32, mut shade: impl FnMut(f32, f32) -> (Colour, f32)) {
    let [width, height] = canvas.size();
    let reach = radius + 1.0;
    let range = |middle: f32, side: usize| {
        let low = (middle - reach).max(0.0) as usize;
        low..((middle + reach + 1.0).max(0.0) as usize).min(side)
    };
    if !(centre[0].is_finite() && centre[1].is_finite() && radius.is_finite()) {
        return;
    }
    for row in range(centre[1], height) {
        for column in range(centre[0], width) {
            let x = (column as f32 + 0.5 - centre[0]) / radius;
            let y = (row as f32 + 0.5 - centre[1]) / radius;
            let (colour, coverage) = shade(x, y);
            if coverage > 0.0 {
                canvas.cover(row * width + column, colour, coverage.min(1.0));
            }
        }
    }
}

/// Towards the light: from the left, above, and the viewer.
const LIGHT: [f32; 3] = [-0.45, -0.65, 0.61];

/// Draws a ball lit from the upper left, `fade` (0 to 1) of the way to the background.
pub(super) fn ball(canvas: &mut Canvas, centre: [f32; 2], radius: f32, colour: Colour, fade: f32) {
    let flat = radius < 1.5;
    around(canvas, centre, radius, |x, y| {
        let squared = x * x + y * y;
        let coverage = (1.0 - squared.sqrt()) * radius + 0.5;
        if coverage <= 0.0 {
            return (colour, 0.0);
        }
        if flat {
            return (blend(colour, BACKGROUND, fade), coverage);
        }
        let z = (1.0 - squared).max(0.0).sqrt();
        let facing = (x * LIGHT[0] + y * LIGHT[1] + z * LIGHT[2]).max(0.0);
        let shaded = colour.map(|part| (f32::from(part) * (0.5 + 0.56 * facing)).min(255.0) as u8);
        // The mirror image of the light, seen from straight ahead.
        let mirror = (2.0 * facing * z - LIGHT[2]).max(0.0);
        let lit = blend(shaded, [255, 255, 255], 0.55 * mirror.powi(10));
        (blend(lit, BACKGROUND, fade), coverage)
    });
}

/// Draws a diamond in a white ring: a pinned particle.
pub(super) fn diamond(canvas: &mut Canvas, centre: [f32; 2], radius: f32, colour: Colour) {
    ringed(canvas, centre, radius, colour, |x, y| (x.abs() + y.abs()) * 0.8);
}

/// Draws a square in a white ring: a particle on a track.
pub(super) fn square(canvas: &mut Canvas, centre: [f32; 2], radius: f32, colour: Colour) {
    ringed(canvas, centre, radius, colour, |x, y| x.abs().max(y.abs()) * 1.15);
}

fn ringed(canvas: &mut Canvas, centre: [f32; 2], radius: f32, colour: Colour, size: impl Fn(f32, f32) -> f32) {
    around(canvas, centre, radius * 1.3, |x, y| {
        let edge = size(x, y);
        let inside = ((0.72 - edge) * radius * 1.3 + 0.5).clamp(0.0, 1.0);
        (blend([255, 255, 255], colour, inside), (1.0 - edge) * radius * 1.3 + 0.5)
    });
}
