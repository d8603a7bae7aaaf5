//! Shadows along gravity on the planes below.

use glam::DVec3;

use super::canvas::{Canvas, cover_pixel};
use super::colours::SHADOW;
use super::floor::Plane;
use super::shapes::cover_line;

const DARKEST: f32 = 0.42;

/// Where it is dark. Shadows don't add up: below two things it is as dark as below one.
#[derive(Clone, Debug, Default)]
pub(super) struct Shadows {
    size: [usize; 2],
    darkness: Vec<u8>,
    is_empty: bool,
}

/// The first plane that a point would fall on, how deep it is below, and where.
pub(super) fn below(planes: &[Plane], down: DVec3, point: DVec3) -> Option<(usize, f64, DVec3)> {
    let falls = planes.iter().enumerate().filter_map(|(number, plane)| {
        let slope = -plane.normal.dot(down);
        let depth = plane.height(point) / slope;
        (slope > 1e-3 && depth >= 0.0).then_some((number, depth))
    });
    let (number, depth) = falls.min_by(|a, b| a.1.total_cmp(&b.1))?;
    Some((number, depth, point + down * depth))
}

impl Shadows {
    pub(super) fn clear(&mut self, size: [usize; 2]) {
        if !self.is_empty || self.size != size {
            self.darkness.clear();
            self.darkness.resize(size[0] * size[1], 0);
            self.size = size;
        }
        self.is_empty = true;
    }

    /// The shadow of a line.
    pub(super) fn line(&mut self, ends: [[f32; 2]; 2], width: f32) {
        self.is_empty = false;
        let strength = 255.0 * 0.7 * width.min(1.0);
        let darkness = &mut self.darkness;
        cover_line(self.size, ends, width.max(1.0) * 0.5, |index, coverage| {
            if let Some(old) = darkness.get_mut(index) {
                *old = (*old).max((coverage * strength) as u8);
            }
        });
    }

    /// The shadow of a ball: an ellipse with these half axes, pixels.
    pub(super) fn ellipse(&mut self, centre: [f32; 2], half: [f32; 2], strength: f32) {
        self.is_empty = false;
        let range = |axis: usize| {
            let low = (centre[axis] - half[axis] - 1.0).max(0.0) as usize;
            low..((centre[axis] + half[axis] + 2.0).max(0.0) as usize).min(self.size[axis])
        };
        let columns = range(0);
        for row in range(1) {
            for column in columns.clone() {
                let x = (column as f32 + 0.5 - centre[0]) / half[0];
                let y = (row as f32 + 0.5 - centre[1]) / half[1];
                // Soft at the rim.
                let light = ((1.0 - (x * x + y * y).sqrt()) * 2.5).clamp(0.0, 1.0);
                if let Some(old) = self.darkness.get_mut(row * self.size[0] + column) {
                    *old = (*old).max((light * strength * 255.0) as u8);
                }
            }
        }
    }

    /// Darkens the planes' fronts.
    pub(super) fn cast(&self, canvas: &mut Canvas, front: &[f32]) {
        if self.is_empty {
            return;
        }
        for ((pixel, dark), front) in canvas.pixels_mut().iter_mut().zip(&self.darkness).zip(front) {
            if *dark > 0 {
                cover_pixel(pixel, SHADOW, f32::from(*dark) * (DARKEST / 255.0) * front);
            }
        }
    }
}
