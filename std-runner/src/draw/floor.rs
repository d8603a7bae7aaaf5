//! Planes as tiled patches, found pixel by pixel: exact at the horizon, at the eye, and for any tilt.

use glam::DVec3;

use super::camera::Camera;
use super::canvas::{Canvas, cover_pixel};
use super::colours::{Colour, TILES, blend};

/// A plane between the eye and things.
const GLASS: [Colour; 2] = [[150, 162, 190], [128, 142, 176]];
const GLASS_OPACITY: f32 = 0.22;

/// `normal`·x = `offset`, the normal of length 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    pub(super) normal: DVec3,
    pub(super) offset: f64,
}

impl Plane {
    /// How far in front of the plane a point is, m.
    pub(super) fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point) - self.offset
    }
}

/// The planes' patches around a scene.
#[derive(Clone, Debug)]
pub(super) struct Floor {
    pub(super) planes: Vec<Plane>,
    /// The middle of the scene and the patches' radius, m.
    pub(super) middle: DVec3,
    pub(super) radius: f64,
    pub(super) up: DVec3,
}

/// What a camera sees of a floor.
#[derive(Clone, Debug, Default)]
pub(super) struct Layers {
    /// For each pixel, how much of it is a plane's front: 0 to 1.
    pub(super) front: Vec<f32>,
    /// Pixels covered by planes seen from behind, with colour and opacity.
    glass: Vec<(u32, Colour, f32)>,
}

impl Layers {
    /// Lays the planes that lie before things over them.
    pub(super) fn lay_glass(&self, canvas: &mut Canvas) {
        for &(index, colour, opacity) in &self.glass {
            canvas.cover(index as usize, colour, opacity);
        }
    }
}

/// A plane as a row of pixels meets it.
struct Patch {
    plane: Plane,
    centre: DVec3,
    axes: [DVec3; 2],
    tile: f64,
    tones: [Colour; 2],
    is_glass: bool,
    radius: f64,
    /// The planes behind which it is not seen.
    cuts: Vec<Plane>,
}

impl Floor {
    /// Paints the planes; `growth` is how many times wider the scene has become.
    pub(super) fn paint(&self, camera: &Camera, growth: f64, canvas: &mut Canvas, layers: &mut Layers) {
        let [width, height] = canvas.size();
        layers.glass.clear();
        layers.front.clear();
        layers.front.resize(width * height, 0.0);
        for (number, plane) in self.planes.iter().enumerate() {
            let Some(mut patch) = self.patch(*plane, camera) else {
                continue;
            };
            patch.radius *= growth;
            let others = self.planes.iter().enumerate().filter(|(other, _)| *other != number);
            patch.cuts = others.map(|(_, plane)| *plane).collect();
            for row in 0..height {
                patch.paint_row(row, camera, canvas, layers);
            }
        }
    }

    fn patch(&self, plane: Plane, camera: &Camera) -> Option<Patch> {
        let centre = self.middle - plane.normal * plane.height(self.middle);
        let side = if plane.normal.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
        let first = side.reject_from_normalized(plane.normal).try_normalize()?;
        let is_glass = plane.height(camera.eye_point()) < 0.0;
        // A wall is a little darker than a floor.
        let steep = 1.0 - plane.normal.dot(self.up).max(0.0) as f32;
        let darken = |tone| blend(tone, [150, 158, 176], 0.28 * steep);
        // The next round number of metres to a quarter of the patch.
        let rough = self.radius * 0.16;
        let decade = 10f64.powf(rough.log10().floor());
        let tile = [1.0, 2.0, 5.0, 10.0].map(|step| step * decade).into_iter().find(|tile| *tile >= rough)?;
        Some(Patch {
            plane,
            centre,
            axes: [first, plane.normal.cross(first)],
            tile,
            tones: if is_glass { GLASS } else { TILES.map(darken) },
            is_glass,
            radius: self.radius,
            cuts: Vec::new(),
        })
    }
}

impl Patch {
    fn paint_row(&self, row: usize, camera: &Camera, canvas: &mut Canvas, layers: &mut Layers) {
        let [width, _] = canvas.size();
        let eye = camera.eye_point();
        let ray = camera.ray(0.5, row as f64 + 0.5);
        let right = camera.ray(1.5, row as f64 + 0.5) - ray;
        let below = camera.ray(0.5, row as f64 + 1.5) - ray;
        // All that is asked of the ray are products with it, which change evenly along the row.
        let across = |vector: DVec3| Product {
            start: vector.dot(ray),
            right: vector.dot(right),
            below: vector.dot(below),
            eye: vector.dot(eye - self.centre),
        };
        let slope = across(self.plane.normal);
        let axes = self.axes.map(across);
        for column in 0..width {
            let steepness = slope.at(column);
            let depth = -slope.eye / steepness;
            // Not a number, or infinite, where the ray runs along the plane.
            if !(depth > 0.0 && depth.is_finite()) {
                continue;
            }
            let places = axes.each_ref().map(|axis| axis.eye + depth * axis.at(column));
            let distance = (places[0] * places[0] + places[1] * places[1]).sqrt() / self.radius;
            let point = self.centre + self.axes[0] * places[0] + self.axes[1] * places[1];
            if distance >= 1.0 || self.cuts.iter().any(|cut| cut.height(point) < 0.0) {
                continue;
            }
            let mut light = 1.0;
            for (axis, place) in axes.iter().zip(places) {
                // How the place changes from pixel to pixel: what one pixel blurs.
                let tilt = axis.at(column) / steepness;
                let change = (axis.right - tilt * slope.right).abs() + (axis.below - tilt * slope.below).abs();
                light *= stripe(place / self.tile, depth * change * 0.5 / self.tile);
            }
            let fade = 1.0 - ((distance - 0.45) / 0.55).clamp(0.0, 1.0) as f32;
            let fade = fade * fade * (3.0 - 2.0 * fade);
            let colour = blend(self.tones[1], self.tones[0], 0.5 + 0.5 * light as f32);
            let index = row * width + column;
            if self.is_glass {
                layers.glass.push((index as u32, colour, fade * GLASS_OPACITY));
            } else if let (Some(pixel), Some(front)) = (canvas.pixels_mut().get_mut(index), layers.front.get_mut(index))
            {
                cover_pixel(pixel, colour, fade);
                *front = front.max(fade);
            }
        }
    }
}

/// The product of a vector with the rays of a row, and with the eye's place.
struct Product {
    start: f64,
    right: f64,
    below: f64,
    eye: f64,
}

impl Product {
    fn at(&self, column: usize) -> f64 {
        self.start + self.right * column as f64
    }
}

/// Stripes of width 1, from −1 to 1, smoothed over `blur` on either side.
fn stripe(place: f64, blur: f64) -> f64 {
    let within = place.rem_euclid(2.0);
    let edge = within.fract().min(1.0 - within.fract());
    let strength = (edge / blur.max(1e-9)).min(1.0) * (2.0 - 2.0 * blur).clamp(0.0, 1.0);
    if within < 1.0 { strength } else { -strength }
}
