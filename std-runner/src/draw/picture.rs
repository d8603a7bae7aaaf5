//! One frame after another.

use glam::DVec3;
use hooke::Real;

use super::camera::Camera;
use super::canvas::Canvas;
use super::colours::{self, BACKGROUND, Colour, StrainScale};
use super::floor::Layers;
use super::legend::Legend;
use super::order::DepthOrder;
use super::scenery::Scenery;
use super::shadow::{Shadows, below};
use super::view::View;

mod marks;
mod shade;

/// Draws the frames of one run, in order.
#[derive(Clone, Debug)]
pub struct Picture {
    scenery: Scenery,
    view: View,
    legend: Legend,
    strain: StrainScale,
    canvas: Canvas,
    /// The planes alone, and the camera that they were painted for.
    back: Canvas,
    layers: Layers,
    painted: Option<Camera>,
    shadows: Shadows,
    order: DepthOrder,
    particles: Vec<Seen>,
    strains: Vec<f64>,
}

/// Where a particle is in the picture.
#[derive(Clone, Copy, Debug)]
struct Seen {
    /// Pixels from the left and from the top.
    place: [f32; 2],
    /// From the eye, m; not a number if it is not to be seen.
    depth: f32,
    /// Its shadow: the plane, and where.
    shadow: Option<(usize, [f32; 2])>,
}

impl Seen {
    const NOWHERE: Self = Self { place: [0.0; 2], depth: f32::NAN, shadow: None };
}

impl Picture {
    /// Ready for the first frame.
    #[must_use]
    pub fn new(scenery: Scenery) -> Self {
        let view = scenery.view.clone();
        let size = view.camera().size();
        Self {
            legend: Legend::new(&scenery.name, size),
            view,
            strain: StrainScale::default(),
            canvas: Canvas::new(size),
            back: Canvas::new(size),
            layers: Layers::default(),
            painted: None,
            shadows: Shadows::default(),
            order: DepthOrder::default(),
            particles: Vec::new(),
            strains: Vec::new(),
            scenery,
        }
    }

    /// Draws the particles at these positions (m) at a time (s); those that are not finite are left out.
    pub fn draw<R: Real>(&mut self, time: f64, position: &[[R; 3]]) -> &Canvas {
        let points = position.iter().map(|point| DVec3::from_array(point.map(R::to_f64)));
        self.view.follow(points.clone(), self.scenery.looks.largest);
        let camera = self.view.camera();
        self.paint_back(&camera);
        self.find_particles(&camera, points);
        self.find_strains(position);
        self.cast_shadows(&camera);
        self.draw_things(&camera);
        self.layers.lay_glass(&mut self.canvas);
        self.legend.write_time(&mut self.canvas, time);
        if !self.scenery.springs.is_empty() {
            self.legend.draw_scale(&mut self.canvas, &self.strain);
        }
        &self.canvas
    }

    /// The last picture drawn.
    #[must_use]
    pub fn canvas(&self) -> &Canvas {
        &self.canvas
    }

    /// The camera of the last picture drawn.
    #[must_use]
    pub fn camera(&self) -> Camera {
        self.view.camera()
    }

    /// What the ends of the colour scale stand for.
    #[must_use]
    pub fn strain_scale(&self) -> StrainScale {
        self.strain
    }

    /// Colours that later pictures may have even if the first has not: what a palette should hold, at most 200.
    #[must_use]
    pub fn palette_seeds(&self) -> Vec<Colour> {
        colours::seeds(!self.scenery.springs.is_empty())
    }

    fn paint_back(&mut self, camera: &Camera) {
        if self.painted != Some(*camera) {
            self.back.pixels_mut().fill(super::canvas::opaque(BACKGROUND));
            self.scenery.floor.paint(camera, self.view.growth(), &mut self.back, &mut self.layers);
            self.painted = Some(*camera);
        }
        self.canvas.copy_from(&self.back);
    }

    fn find_particles(&mut self, camera: &Camera, points: impl Iterator<Item = DVec3>) {
        let [width, height] = camera.size().map(|side| side as f32 * 0.5);
        let distance = self.view.distance();
        // What flies into the eye would hide the rest.
        let range = (distance * 0.03, distance * 1e3);
        let place = |point: DVec3| {
            let [x, y, depth] = camera.seen(point);
            let scale = camera.pixels_per_metre(depth);
            let place = [width + (x * scale) as f32, height - (y * scale) as f32];
            // Beyond a million pixels aside, the numbers no longer tell pixels apart.
            let is_visible = depth > range.0 && depth < range.1 && place.iter().all(|at| at.abs() < 1e6);
            is_visible.then_some((place, depth as f32))
        };
        let (planes, down) = (&self.scenery.floor.planes, self.scenery.down);
        self.particles.clear();
        self.particles.extend(points.map(|point| {
            let Some((at, depth)) = place(point) else {
                return Seen::NOWHERE;
            };
            let shadow = down.and_then(|down| {
                let (plane, _, foot) = below(planes, down, point)?;
                Some((plane, place(foot)?.0))
            });
            Seen { place: at, depth, shadow }
        }));
    }

    fn find_strains<R: Real>(&mut self, position: &[[R; 3]]) {
        self.strains.clear();
        for &(between, rest_length) in &self.scenery.springs {
            let [from, to] = between.map(|end| position.get(end as usize));
            let strain = match (from, to) {
                (Some(from), Some(to)) => {
                    let squared = |axis: usize| (to[axis].to_f64() - from[axis].to_f64()).powi(2);
                    let length = (squared(0) + squared(1) + squared(2)).sqrt();
                    // At rest length 0, any length is as stretched as can be.
                    if length == rest_length { 0.0 } else { (length - rest_length) / rest_length }
                }
                _ => f64::NAN,
            };
            self.strains.push(strain);
        }
        self.strain.include(&self.strains);
    }
}
