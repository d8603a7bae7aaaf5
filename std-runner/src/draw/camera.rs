//! From points in space to points in the picture.

use glam::DVec3;

/// An eye in space and the picture it sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    eye: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    /// Half the picture's height over its distance from the eye.
    slope: f64,
    size: [u32; 2],
}

impl Camera {
    /// An eye that looks along `forward` with `up` upwards in the picture; `field_of_view` in radians.
    pub(super) fn new(eye: DVec3, forward: DVec3, up: DVec3, field_of_view: f64, size: [u32; 2]) -> Self {
        let forward = forward.try_normalize().unwrap_or(DVec3::Y);
        // Looking straight along `up`, any direction across will do.
        let right = [up, DVec3::Y, DVec3::X]
            .into_iter()
            .find_map(|up| {
                let right = forward.cross(up.normalize_or_zero());
                (right.length() > 1e-6).then(|| right.normalize())
            })
            .unwrap_or(DVec3::X);
        Self { eye, right, up: right.cross(forward), forward, slope: (field_of_view * 0.5).tan(), size }
    }

    /// The eye, m.
    #[must_use]
    pub fn eye(&self) -> [f64; 3] {
        self.eye.to_array()
    }

    /// The direction it looks along, of length 1.
    #[must_use]
    pub fn forward(&self) -> [f64; 3] {
        self.forward.to_array()
    }

    /// The direction that is up in the picture, of length 1.
    #[must_use]
    pub fn up(&self) -> [f64; 3] {
        self.up.to_array()
    }

    /// Pixels across and down.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// From the top of the picture to its bottom, degrees.
    #[must_use]
    pub fn field_of_view(&self) -> f64 {
        (2.0 * self.slope.atan()).to_degrees()
    }

    /// Where a point in space (m) is in the picture: pixels from the left and from the top.
    /// `None` if it is behind the eye or not finite.
    #[must_use]
    pub fn project(&self, point: [f64; 3]) -> Option<[f64; 2]> {
        let [x, y, depth] = self.seen(DVec3::from_array(point));
        let scale = self.pixels_per_metre(depth);
        let [width, height] = self.size.map(f64::from);
        let place = [width * 0.5 + x * scale, height * 0.5 - y * scale];
        (depth > 0.0 && place[0].is_finite() && place[1].is_finite()).then_some(place)
    }

    /// A point as the eye has it: to the right, up, and ahead, m.
    pub(super) fn seen(&self, point: DVec3) -> [f64; 3] {
        let offset = point - self.eye;
        [offset.dot(self.right), offset.dot(self.up), offset.dot(self.forward)]
    }

    /// How many pixels a metre across takes at this depth.
    pub(super) fn pixels_per_metre(&self, depth: f64) -> f64 {
        f64::from(self.size[1]) * 0.5 / (self.slope * depth)
    }

    /// How far to the side and up per metre ahead the picture's corner is.
    pub(super) fn slopes(&self) -> [f64; 2] {
        let [width, height] = self.size.map(f64::from);
        [self.slope * width / height, self.slope]
    }

    /// The direction of what is seen at a point of the picture; one long along `forward`.
    pub(super) fn ray(&self, x: f64, y: f64) -> DVec3 {
        let [width, height] = self.size.map(f64::from);
        let [across, along] = self.slopes();
        self.forward + self.right * ((2.0 * x / width - 1.0) * across) + self.up * ((1.0 - 2.0 * y / height) * along)
    }

    /// The eye.
    pub(super) fn eye_point(&self) -> DVec3 {
        self.eye
    }

    /// The same camera with its eye moved: to the right, up and ahead, m.
    pub(super) fn moved(mut self, [right, up, ahead]: [f64; 3]) -> Self {
        self.eye += self.right * right + self.up * up + self.forward * ahead;
        self
    }

    /// The same camera, farther back by this many metres.
    pub(super) fn pulled_back(self, distance: f64) -> Self {
        self.moved([0.0, 0.0, -distance])
    }
}
