//! A scene made flat: what its generators made of it, ready to be stepped and drawn.

/// How a particle is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// It moves as the forces on it say.
    Free,
    /// It stays where it is.
    Pinned,
    /// It follows the track of this number in [`Model::tracks`].
    Track(u32),
}

/// One particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelParticle {
    /// m
    pub position: [f64; 3],
    /// m/s
    pub velocity: [f64; 3],
    /// kg, more than 0
    pub mass: f64,
    /// Free, pinned, or on a track.
    pub hold: Hold,
}

/// One spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelSpring {
    /// The particles it joins.
    pub between: [u32; 2],
    /// N/m
    pub stiffness: f64,
    /// N·s/m
    pub damping: f64,
    /// m
    pub rest_length: f64,
}

/// One plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModelPlane {
    /// A point on it, m.
    pub point: [f64; 3],
    /// Its direction, of length 1.
    pub normal: [f64; 3],
    /// 0 to 1
    pub restitution: f64,
}

/// The prescribed positions of a kinematic particle: straight from each key to the next.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// `(t, x)`: s and m, times strictly increasing, at least one.
    pub keys: Vec<(f64, [f64; 3])>,
}

impl Track {
    /// Where it is at a time, m: before the first key and after the last it stands still.
    #[must_use]
    pub fn position(&self, time: f64) -> [f64; 3] {
        match self.around(time) {
            (Some((t_0, x_0)), Some((t_1, x_1))) => {
                let s = (time - t_0) / (t_1 - t_0);
                let mut position = x_0;
                for (component, (a, b)) in position.iter_mut().zip(x_0.into_iter().zip(x_1)) {
                    *component = a + s * (b - a);
                }
                position
            }
            (Some((_, x)), None) | (None, Some((_, x))) => x,
            (None, None) => [0.0; 3],
        }
    }

    /// How fast it moves at a time between keys, m/s.
    #[must_use]
    pub fn velocity(&self, time: f64) -> [f64; 3] {
        match self.around(time) {
            (Some((t_0, x_0)), Some((t_1, x_1))) => {
                let mut velocity = x_1;
                for (component, before) in velocity.iter_mut().zip(x_0) {
                    *component = (*component - before) / (t_1 - t_0);
                }
                velocity
            }
            _ => [0.0; 3],
        }
    }

    /// The last key at or before a time, and the first after it.
    #[expect(clippy::type_complexity, reason = "two keys")]
    fn around(&self, time: f64) -> (Option<(f64, [f64; 3])>, Option<(f64, [f64; 3])>) {
        let after = self.keys.partition_point(|(key, _)| *key <= time);
        (after.checked_sub(1).and_then(|before| self.keys.get(before).copied()), self.keys.get(after).copied())
    }
}

/// Particles, springs and planes, numbered as the scene file says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// In the order of the scene's numbers.
    pub particles: Vec<ModelParticle>,
    /// In file order.
    pub springs: Vec<ModelSpring>,
    /// In file order.
    pub planes: Vec<ModelPlane>,
    /// Of kinematic particles.
    pub tracks: Vec<Track>,
}

impl Model {
    /// The least and the largest coordinate of any particle along each axis, m.
    #[must_use]
    pub fn extents(&self) -> [(f64, f64); 3] {
        [0, 1, 2].map(|axis| {
            let along = || self.particles.iter().map(|particle| particle.position[axis]);
            (along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max))
        })
    }

    /// How many springs have damping.
    #[must_use]
    pub fn damped_springs(&self) -> usize {
        self.springs.iter().filter(|spring| spring.damping != 0.0).count()
    }

    /// The largest distance of a particle from the middle of all at the start, m; 1 where all are at one place.
    #[must_use]
    pub fn size(&self) -> f64 {
        let count = self.particles.len().max(1) as f64;
        let middle = self
            .particles
            .iter()
            .fold([0.0; 3], |sum, particle| [0, 1, 2].map(|axis| sum[axis] + particle.position[axis] / count));
        let far = self.particles.iter().fold(0.0_f64, |far, particle| {
            let square: f64 = particle.position.iter().zip(middle).map(|(x, m)| (x - m) * (x - m)).sum();
            far.max(square.sqrt())
        });
        if far > 0.0 { far } else { 1.0 }
    }
}

/// Where a picture is seen from: what a scene leaves out is chosen to show all of it.
#[derive(Clone, Debug, Default, PartialEq, serde::Deserialize, serde::Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CameraChoice {
    /// The eye, m.
    pub position: Option<[f64; 3]>,
    /// What it looks at, m.
    pub target: Option<[f64; 3]>,
    /// What is up in the picture; against gravity if left out, or z where there is none.
    pub up: Option<[f64; 3]>,
    /// From the top of the picture to its bottom, degrees, more than 0 and less than 180.
    pub field_of_view: Option<f64>,
    /// Width and height of the picture, pixels.
    pub size: Option<[u32; 2]>,
}
