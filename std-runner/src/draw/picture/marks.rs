//! The springs and particles of one frame, from far to near.

use super::Picture;
use crate::draw::camera::Camera;
use crate::draw::colours::{BACKGROUND, INK, JOINT, SHADOW, TRACK, blend, strain_colour};
use crate::draw::looks::Look;
use crate::draw::shapes;

/// The most that the farthest things fade.
const FADE: f32 = 0.5;
/// Up to this many springs are drawn as zigzags where there is room.
const FEW_SPRINGS: usize = 24;

impl Picture {
    pub(super) fn draw_things(&mut self, camera: &Camera) {
        let mut order = std::mem::take(&mut self.order);
        order.clear();
        for (number, (between, _)) in self.scenery.springs.iter().enumerate() {
            let [from, to] = between.map(|end| self.particles.get(end as usize).map_or(f32::NAN, |seen| seen.depth));
            // Behind both its ends, so that it never runs across the balls that it joins.
            if from.is_finite() && to.is_finite() {
                order.push(from.max(to), number as u32);
            }
        }
        let springs = self.scenery.springs.len() as u32;
        for (number, (seen, look)) in self.particles.iter().zip(&self.scenery.looks.particles).enumerate() {
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
        let (Some((between, _)), Some(strain)) = (self.scenery.springs.get(number), self.strains.get(number)) else {
            return;
        };
        let [Some(from), Some(to)] = between.map(|end| self.particles.get(end as usize).copied()) else {
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
        let (Some(seen), Some(look)) = (self.particles.get(number), self.scenery.looks.particles.get(number)) else {
            return;
        };
        let metre = camera.pixels_per_metre(f64::from(seen.depth)) as f32;
        let fade = self.fade(seen.depth);
        let scale = camera.size()[1] as f32 / 480.0;
        // Marks keep clear of their neighbours' marks.
        let mark = (0.42 * self.scenery.looks.spring_length as f32 * metre).clamp(2.0, 6.0 * scale.max(0.5));
        match *look {
            Look::Hidden => {}
            Look::Ball(radius, colour) => {
                let radius = (radius * metre).min(camera.size()[1] as f32);
                // Smaller joints than the springs are wide show nothing.
                let is_loose = colour != JOINT;
                if is_loose || radius > 1.3 {
                    shapes::ball(&mut self.canvas, seen.place, radius.max(1.2 * scale), colour, fade);
                }
            }
            Look::Pinned => {
                let colour = blend(blend(INK, SHADOW, 0.2), BACKGROUND, fade);
                shapes::diamond(&mut self.canvas, seen.place, mark, colour);
            }
            Look::OnTrack => {
                shapes::square(&mut self.canvas, seen.place, mark, blend(TRACK, BACKGROUND, fade));
            }
        }
    }

    /// How wide a spring is at this depth, pixels.
    fn spring_width(&self, camera: &Camera, depth: f32) -> f32 {
        let scale = camera.size()[1] as f32 / 480.0;
        let natural = 0.13 * self.scenery.looks.spring_length * camera.pixels_per_metre(f64::from(depth));
        let thinnest = if self.scenery.looks.is_sparse { 1.4 } else { 0.4 };
        (natural as f32).clamp(thinnest * scale.min(1.5), 2.2 * scale.max(0.75))
    }
}
