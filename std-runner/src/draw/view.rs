//! Choosing where a scene is seen from.

use glam::DVec3;

use super::camera::Camera;
use super::outlook::Outlook;
use crate::model::CameraChoice;

/// Degrees from top to bottom, where it is free to choose: little distortion, yet clear depth.
const FIELD_OF_VIEW: f64 = 35.0;

/// A camera, and how it keeps things in the picture.
#[derive(Clone, Debug)]
pub(super) struct View {
    camera: Camera,
    frame: Frame,
    /// From the eye to the middle of things, m.
    distance: f64,
    /// Whether it may be moved back: not if the user said where it is.
    may_move: bool,
    /// How far back it is now, and how far it is going, m.
    pulled: f64,
    goal: f64,
    /// How far back each point wants the camera: to be comfortably inside, and just inside.
    needs: Vec<[f64; 2]>,
}

/// The part of the picture meant for things: tangents to the side, up and down.
#[derive(Clone, Copy, Debug)]
struct Frame {
    side: f64,
    top: f64,
    bottom: f64,
}

impl Frame {
    fn of(camera: &Camera) -> Self {
        let [across, along] = camera.slopes();
        let [width, height] = camera.size().map(f64::from);
        // Text stands above and below; a tiny picture has none and needs no room for it.
        let line = (height / 480.0).clamp(0.75, 4.0) * 44.0;
        Self {
            side: across * (1.0 - (24.0 / width).min(0.2)),
            top: along * (1.0 - (2.0 * line / height).min(0.3)),
            bottom: along * (1.0 - (2.0 * line / height).min(0.3)),
        }
    }

    /// How far ahead of the eye a ball must at least be to be inside, given where it is across.
    fn depth(&self, [x, y, _]: [f64; 3], radius: f64) -> f64 {
        let aside = (x.abs() + radius * (1.0 + self.side * self.side).sqrt()) / self.side;
        let upright = if y > 0.0 { self.top } else { self.bottom };
        aside.max((y.abs() + radius * (1.0 + upright * upright).sqrt()) / upright)
    }
}

impl View {
    /// A view of these points, each with a ball of this radius (m) around it.
    pub(super) fn new(
        points: &[DVec3],
        radius: f64,
        down: Option<DVec3>,
        outlook: &Outlook<'_>,
        choice: &CameraChoice,
    ) -> Self {
        let usable = |vector: Option<[f64; 3]>| vector.map(DVec3::from_array).filter(|v| v.is_finite());
        let size = choice.size.unwrap_or([640, 480]).map(|side| side.clamp(16, 8192));
        let up = usable(choice.up).and_then(DVec3::try_normalize);
        let up = up.or(down.map(|down| -down)).unwrap_or(DVec3::Z);
        let degrees = choice.field_of_view.filter(|degrees| *degrees > 0.0 && *degrees < 180.0);
        let degrees = degrees.map(|degrees| degrees.clamp(0.1, 179.0));
        let angle = degrees.unwrap_or(FIELD_OF_VIEW).to_radians();
        let (position, target) = (usable(choice.position), usable(choice.target));
        let middle = middle(points);
        let camera = if let Some(eye) = position {
            let forward = target.unwrap_or(middle) - eye;
            let camera = Camera::new(eye, forward, up, angle, size);
            match degrees {
                Some(_) => camera,
                None => Camera::new(eye, forward, up, wide_enough(&camera, points, radius), size),
            }
        } else {
            let forward = outlook.direction(points, up, down.is_some());
            let camera = Camera::new(target.unwrap_or(middle), forward, up, angle, size);
            fitted(camera, points, radius, target.is_some())
        };
        Self {
            camera,
            frame: Frame::of(&camera),
            distance: (middle - camera.eye_point()).length().max(f64::MIN_POSITIVE),
            may_move: position.is_none(),
            pulled: 0.0,
            goal: 0.0,
            needs: Vec::new(),
        }
    }

    /// The camera as it is now.
    pub(super) fn camera(&self) -> Camera {
        self.camera.pulled_back(self.pulled)
    }

    /// From the eye to the middle of things, m.
    pub(super) fn distance(&self) -> f64 {
        self.distance + self.pulled
    }

    /// How many times farther away than at the start.
    pub(super) fn growth(&self) -> f64 {
        1.0 + self.pulled / self.distance
    }

    /// Moves the camera back, and only ever back, so that these points stay in the picture.
    ///
    /// What has gone so far that the rest would become too small is let go.
    pub(super) fn follow(&mut self, points: impl Iterator<Item = DVec3>, radius: f64) {
        if !self.may_move {
            return;
        }
        let [across, along] = self.camera.slopes();
        let edge = Frame { side: across, top: along, bottom: along };
        self.needs.clear();
        self.needs.extend(points.filter_map(|point| {
            let seen = self.camera.seen(point);
            let need = [&self.frame, &edge].map(|frame| frame.depth(seen, radius) - seen[2]);
            need.iter().all(|need| need.is_finite()).then_some(need)
        }));
        // For a few strays the rest is not made small, but if most go, they are what there is to see.
        let place = self.needs.len() * 3 / 4;
        if self.needs.is_empty() {
            return;
        }
        let usual = self.needs.select_nth_unstable_by(place, |a, b| a[0].total_cmp(&b[0])).1[0];
        let farthest = (2.0 * usual).clamp(3.0 * self.distance, 20.0 * self.distance);
        let (mut comfortable, mut inside) = (0.0f64, 0.0f64);
        for need in self.needs.iter().filter(|need| need[0] <= farthest) {
            comfortable = comfortable.max(need[0]);
            inside = inside.max(need[1]);
        }
        if comfortable > 1e-6 * self.distance {
            // A little farther than needed, so that it comes to rest instead of following every move.
            self.goal = self.goal.max((comfortable * 1.25).min(farthest));
        }
        let eased = self.pulled + 0.12 * (self.goal - self.pulled);
        // Never a jump, even where the limit changes.
        let inside = inside.min(self.pulled + 0.2 * self.distance());
        self.pulled = eased.max(inside).max(self.pulled);
    }
}

/// The middle of the box around points.
pub(super) fn middle(points: &[DVec3]) -> DVec3 {
    let low = points.iter().copied().reduce(DVec3::min).unwrap_or(DVec3::ZERO);
    let high = points.iter().copied().reduce(DVec3::max).unwrap_or(DVec3::ZERO);
    low + (high - low) * 0.5
}

/// The field of view that shows all points from a given eye, radians, between 10° and 100°.
fn wide_enough(camera: &Camera, points: &[DVec3], radius: f64) -> f64 {
    let [width, height] = camera.size().map(f64::from);
    let slope = points
        .iter()
        .map(|point| camera.seen(*point))
        .filter(|seen| seen[2] > 0.0)
        .fold(0.0f64, |slope, [x, y, depth]| {
            slope.max(((x.abs() + radius) * height / width).max(y.abs() + radius) / depth)
        });
    (2.0 * (slope * 1.2).atan()).clamp(10f64.to_radians(), 100f64.to_radians())
}

/// The camera moved to where it is as near as can be with all points in its frame.
///
/// Each side of the frame is a plane through the eye that no ball may cross: a linear bound on the eye.
fn fitted(camera: Camera, points: &[DVec3], radius: f64, keep_axis: bool) -> Camera {
    let frame = Frame::of(&camera);
    if keep_axis {
        let needed = points.iter().map(|point| camera.seen(*point));
        let back = needed.map(|seen| frame.depth(seen, radius) - seen[2]).fold(0.0, f64::max);
        return camera.pulled_back(if back > 0.0 { back } else { 1.0 });
    }
    let bound = |axis: usize, slope: f64, sign: f64| {
        points
            .iter()
            .map(|point| camera.seen(*point))
            .map(|seen| seen[2] - (sign * seen[axis] + radius * (1.0 + slope * slope).sqrt()) / slope)
            .fold(f64::MAX, f64::min)
    };
    let (right, left) = (bound(0, frame.side, 1.0), bound(0, frame.side, -1.0));
    let (top, bottom) = (bound(1, frame.top, 1.0), bound(1, frame.bottom, -1.0));
    // Where both bounds of an axis meet is as far ahead as that axis allows.
    let ahead_across = (right + left) * 0.5;
    let upward = (bottom - top) / (1.0 / frame.top + 1.0 / frame.bottom);
    let ahead = ahead_across.min(top + upward / frame.top);
    let across = frame.side * (left - right) * 0.5;
    let upward = 0.5 * (frame.top * (ahead - top) + frame.bottom * (bottom - ahead));
    camera.moved([across, upward, ahead])
}
