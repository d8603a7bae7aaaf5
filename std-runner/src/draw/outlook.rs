//! From which side a scene is best seen.

use glam::DVec3;

use super::floor::Plane;
use crate::model::{Hold, Model};

/// What gives a scene its sides.
pub(super) struct Outlook<'a> {
    pub(super) model: &'a Model,
    pub(super) planes: &'a [Plane],
}

impl Outlook<'_> {
    /// The direction to look along: straight at a flat scene, three-quarters at others, a little from above.
    pub(super) fn direction(&self, points: &[DVec3], up: DVec3, has_gravity: bool) -> DVec3 {
        let across = if up.x.abs() < 0.9 { DVec3::X } else { DVec3::Y }.reject_from_normalized(up).normalize();
        let along = up.cross(across);
        let centre = points.iter().fold(DVec3::ZERO, |sum, point| sum + *point) / points.len().max(1) as f64;
        let offsets = points.iter().map(|point| *point - centre);
        // The axes of the ellipse that the points make when seen from above.
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for offset in offsets.clone() {
            let (x, y) = (offset.dot(across), offset.dot(along));
            xx += x * x;
            xy += x * y;
            yy += y * y;
        }
        let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
        let long = across * angle.cos() + along * angle.sin();
        let short = up.cross(long);
        let width = |axis: DVec3| offsets.clone().map(|offset| offset.dot(axis).abs()).fold(0.0, f64::max);
        let (wide, thick, high) = (width(long), width(short), width(up));
        let thin = 0.03 * wide.max(high);
        if high < thin && !has_gravity && thick > thin {
            return -up;
        }
        let flat = thick <= thin;
        let is_long = wide > thin && xx + yy > 0.0 && (flat || thick < 0.8 * wide);
        let mut right =
            if flat && is_long { long } else { self.run(up).unwrap_or(if is_long { long } else { across }) };
        // From the side where x, or else y, runs to the right.
        let along_axis = |right: DVec3| {
            if right.dot(across).abs() > 1e-3 { right.dot(across) } else { right.dot(along) }
        };
        if along_axis(right) < 0.0 {
            right = -right;
        }
        let forward = up.cross(right);
        let (turns, pitch): (&[f64], f64) =
            if flat { (&[0.0, 180.0], 9.0) } else { (&[28.0, -28.0, 152.0, -152.0], 22.0) };
        let looks = turns.iter().map(|turn| {
            let (sine, cosine) = turn.to_radians().sin_cos();
            let level = forward * cosine - right * sine;
            level * pitch.to_radians().cos() - up * pitch.to_radians().sin()
        });
        // The first from which the fewest planes are seen from behind.
        let hidden = |look: &DVec3| self.planes.iter().filter(|plane| plane.normal.dot(*look) > 0.0).count();
        looks.reduce(|best, look| if hidden(&look) < hidden(&best) { look } else { best }).unwrap_or(forward)
    }

    /// What should run across the picture: down a slope, or along the line that things hang from.
    fn run(&self, up: DVec3) -> Option<DVec3> {
        let slopes = self.planes.iter().map(|plane| plane.normal.reject_from_normalized(up));
        let slope = slopes.into_iter().find(|slope| slope.length() > 0.05 && slope.length() < 0.99);
        slope.or_else(|| self.hold_line(up)).and_then(DVec3::try_normalize)
    }

    fn hold_line(&self, up: DVec3) -> Option<DVec3> {
        let particles = self.model.particles.iter();
        let held = particles.filter(|particle| particle.hold != Hold::Free);
        let places: Vec<DVec3> = held.map(|particle| DVec3::from_array(particle.position)).collect();
        let first = *places.first()?;
        let reach = |place: &DVec3| (*place - first).length_squared();
        let far = *places.iter().max_by(|a, b| reach(a).total_cmp(&reach(b)))?;
        let line = (far - first).try_normalize()?;
        let off = |place: &DVec3| (*place - first).reject_from_normalized(line).length();
        let is_straight = places.iter().all(|place| off(place) < 0.01 * (far - first).length());
        let level = line.reject_from_normalized(up);
        (is_straight && level.length() > 0.5).then_some(level)
    }
}
