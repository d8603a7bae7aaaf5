//! One frame after another.

use glam::DVec3;
use hooke::Real;

use super::camera::Camera;
use super::canvas::Canvas;
use super::colours::{BACKGROUND, INK, SHADOW, StrainScale, TRACK, blend, strain_colour};
use super::floor::Layers;
use super::legend::Legend;
use super::looks::Look;
use super::order::DepthOrder;
use super::scenery::Scenery;
use super::shadow::{Shadows, below};
use super::shapes;
use super::view::View;

/// The most that the farthest things fade.
const FADE: f32 = 0.5;
/// Up to this many springs are drawn as zigzags where there is room.
const FEW_SPRINGS: usize = 24;
/// Beyond this many springs, shadows are those of the particles only.
const MANY_SPRINGS: usize = 50_000;

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
    const NOWHERE: Self = Self {
        place: [0.0; 2],
        depth: f32::NAN,
        shadow: None,
    };
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
        let points = position
            .iter()
            .map(|point| DVec3::from_array(point.map(R::to_f64)));
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

    fn paint_back(&mut self, camera: &Camera) {
        if self.painted != Some(*camera) {
            self.back
                .pixels_mut()
                .fill(super::canvas::opaque(BACKGROUND));
            self.scenery
                .floor
                .paint(camera, self.view.growth(), &mut self.back, &mut self.layers);
            self.painted = Some(*camera);
        }
        self.canvas.copy_from(&self.back);
    }

    fn find_particles(&mut self, camera: &Camera, points: impl Iterator<Item = DVec3>) {
        let [width, height] = camera.size().map(|side| side as f32 * 0.5);
        let distance = self.view.distance();
        let range = (distance * 1e-3, distance * 1e3);
        let place = |point: DVec3| {
            let [x, y, depth] = camera.seen(point);
            let scale = camera.pixels_per_metre(depth);
            let place = [width + (x * scale) as f32, height - (y * scale) as f32];
            // Beyond a million pixels aside, the numbers no longer tell pixels apart.
            let is_visible =
                depth > range.0 && depth < range.1 && place.iter().all(|at| at.abs() < 1e6);
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
            Seen {
                place: at,
                depth,
                shadow,
            }
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
                    if length == rest_length {
                        0.0
                    } else {
                        (length - rest_length) / rest_length
                    }
                }
                _ => f64::NAN,
            };
            self.strains.push(strain);
        }
        self.strain.include(&self.strains);
    }

    /// How wide a spring is at this depth, pixels.
    fn spring_width(&self, camera: &Camera, depth: f32) -> f32 {
        let scale = camera.size()[1] as f32 / 480.0;
        let natural =
            0.13 * self.scenery.looks.spring_length * camera.pixels_per_metre(f64::from(depth));
        let thinnest = if self.scenery.looks.is_sparse {
            1.4
        } else {
            0.4
        };
        (natural as f32).clamp(thinnest * scale.min(1.5), 2.2 * scale)
    }

    fn cast_shadows(&mut self, camera: &Camera) {
        self.shadows.clear(self.canvas.size());
        let Some(down) = self.scenery.down else {
            return;
        };
        // A circle on a level floor is this flat.
        let tilt = DVec3::from_array(camera.forward())
            .dot(down)
            .abs()
            .clamp(0.15, 1.0) as f32;
        if self.scenery.springs.len() <= MANY_SPRINGS {
            for &(between, _) in &self.scenery.springs {
                let ends = between.map(|end| {
                    self.particles
                        .get(end as usize)
                        .and_then(|seen| seen.shadow)
                });
                if let [Some((one, from)), Some((other, to))] = ends
                    && one == other
                {
                    self.shadows.line([from, to], 1.6);
                }
            }
        }
        let spacing = 0.4 * self.scenery.looks.spring_length;
        for (seen, look) in self.particles.iter().zip(&self.scenery.looks.particles) {
            let Some((_, foot)) = seen.shadow else {
                continue;
            };
            let radius = match *look {
                Look::Ball(radius, _) => f64::from(radius),
                Look::Hidden if self.scenery.springs.len() > MANY_SPRINGS => spacing,
                _ => continue,
            };
            let radius = (radius * camera.pixels_per_metre(f64::from(seen.depth))) as f32;
            // Paler the higher the ball.
            let height = (foot[1] - seen.place[1]).abs() / radius.max(1.0);
            let strength = (0.35 + 0.65 / (1.0 + 0.12 * height)).min(1.0);
            if radius < 500.0 {
                self.shadows
                    .ellipse(foot, [radius.max(1.0), (radius * tilt).max(0.7)], strength);
            }
        }
        self.shadows.cast(&mut self.canvas, &self.layers.front);
    }

    fn draw_things(&mut self, camera: &Camera) {
        let mut order = std::mem::take(&mut self.order);
        order.clear();
        for (number, (between, _)) in self.scenery.springs.iter().enumerate() {
            let [from, to] = between.map(|end| {
                self.particles
                    .get(end as usize)
                    .map_or(f32::NAN, |seen| seen.depth)
            });
            // Behind both its ends, so that it never runs across the balls that it joins.
            if from.is_finite() && to.is_finite() {
                order.push(from.max(to), number as u32);
            }
        }
        let springs = self.scenery.springs.len() as u32;
        for (number, (seen, look)) in self
            .particles
            .iter()
            .zip(&self.scenery.looks.particles)
            .enumerate()
        {
            if seen.depth.is_finite() && *look != Look::Hidden {
                order.push(seen.depth, springs + number as u32);
            }
        }
        for &number in order.far_to_near() {
            if number < springs {
                self.draw_spring(camera, number as usize);
            } else {
                self.draw_particle(camera, (number - springs) as usize);
            }
        }
        self.order = order;
    }

    /// How far towards the background things at this depth fade, 0 to 1.
    fn fade(&self, depth: f32) -> f32 {
        let [near, far] = self.scenery.depths;
        // In a scene without depth, nothing fades.
        let span = (far - near).max(0.4 * self.view.distance());
        let moved = self.view.distance() * (1.0 - 1.0 / self.view.growth());
        FADE * ((f64::from(depth) - near - moved) / span).clamp(0.0, 1.0) as f32
    }

    fn draw_spring(&mut self, camera: &Camera, number: usize) {
        let (Some((between, _)), Some(strain)) =
            (self.scenery.springs.get(number), self.strains.get(number))
        else {
            return;
        };
        let [Some(from), Some(to)] = between.map(|end| self.particles.get(end as usize).copied())
        else {
            return;
        };
        let depth = (from.depth + to.depth) * 0.5;
        let colour = strain_colour((strain / self.strain.end()) as f32);
        let colour = blend(colour, BACKGROUND, self.fade(depth));
        let width = self.spring_width(camera, depth);
        let ends = [from.place, to.place];
        if self.scenery.springs.len() <= FEW_SPRINGS {
            shapes::zigzag(&mut self.canvas, ends, width, colour);
        } else {
            shapes::line(&mut self.canvas, ends, width, colour);
        }
    }

    fn draw_particle(&mut self, camera: &Camera, number: usize) {
        let (Some(seen), Some(look)) = (
            self.particles.get(number),
            self.scenery.looks.particles.get(number),
        ) else {
            return;
        };
        let metre = camera.pixels_per_metre(f64::from(seen.depth)) as f32;
        let fade = self.fade(seen.depth);
        let scale = camera.size()[1] as f32 / 480.0;
        // Marks keep clear of their neighbours' marks.
        let mark = (0.42 * self.scenery.looks.spring_length as f32 * metre)
            .clamp(2.0, 6.0 * scale.max(0.5));
        match *look {
            Look::Hidden => {}
            Look::Ball(radius, colour) => {
                let radius = (radius * metre).min(camera.size()[1] as f32);
                // Smaller joints than the springs are wide show nothing.
                let is_loose = colour != super::colours::JOINT;
                if is_loose || radius > 1.3 {
                    shapes::ball(
                        &mut self.canvas,
                        seen.place,
                        radius.max(1.2 * scale),
                        colour,
                        fade,
                    );
                }
            }
            Look::Pinned => {
                let colour = blend(blend(INK, SHADOW, 0.2), BACKGROUND, fade);
                shapes::diamond(&mut self.canvas, seen.place, mark, colour);
            }
            Look::OnTrack => {
                shapes::square(
                    &mut self.canvas,
                    seen.place,
                    mark,
                    blend(TRACK, BACKGROUND, fade),
                );
            }
        }
    }
}
