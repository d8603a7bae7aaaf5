//! The shadows of one frame.

use glam::DVec3;

use super::Picture;
use crate::draw::camera::Camera;
use crate::draw::looks::Look;

/// Beyond this many springs, shadows are those of the particles only.
const MANY_SPRINGS: usize = 50_000;

impl Picture {
    pub(super) fn cast_shadows(&mut self, camera: &Camera) {
        self.shadows.clear(self.canvas.size());
        let Some(down) = self.scenery.down else {
            return;
        };
        // A circle on a level floor is this flat.
        let tilt = DVec3::from_array(camera.forward()).dot(down).abs().clamp(0.15, 1.0) as f32;
        if self.scenery.springs.len() <= MANY_SPRINGS {
            for &(between, _) in &self.scenery.springs {
                let ends = between.map(|end| self.particles.get(end as usize).and_then(|seen| seen.shadow));
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
                self.shadows.ellipse(foot, [radius.max(1.0), (radius * tilt).max(0.7)], strength);
            }
        }
        self.shadows.cast(&mut self.canvas, &self.layers.front);
    }
}
