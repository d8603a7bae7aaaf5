//! What a scene far from the origin is stepped relative to, so that no digits are spent on how far it is.

use std::borrow::Cow;

use hooke::Real;

use crate::model::Model;

/// A scene that is at least so many times as far away as it is wide is far.
const FAR: f64 = 16.0;

/// A place in the middle of a scene, m; nothing where it is not far from the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor(Option<[f64; 3]>);

impl Anchor {
    /// Of a model, by where its particles start.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        let edges = model.extents();
        let width = edges.iter().fold(0.0_f64, |width, (least, most)| width.max(most - least));
        // Whole metres: they add up to what they were taken from.
        let middle = edges.map(|(least, most)| (0.5 * (least + most)).round());
        let is_far = middle.iter().any(|place| place.abs() > FAR * width.max(1.0));
        Self((is_far && middle.iter().all(|place| place.is_finite())).then_some(middle))
    }

    /// A model as it is seen from there.
    #[must_use]
    pub fn relative(self, model: &Model) -> Cow<'_, Model> {
        let Some(anchor) = self.0 else { return Cow::Borrowed(model) };
        let mut model = model.clone();
        let particles = model.particles.iter_mut().map(|particle| &mut particle.position);
        let planes = model.planes.iter_mut().map(|plane| &mut plane.point);
        let keys = model.tracks.iter_mut().flat_map(|track| &mut track.keys).map(|(_, place)| place);
        for place in particles.chain(planes).chain(keys) {
            *place = difference(*place, anchor);
        }
        Cow::Owned(model)
    }

    /// How far a place of the scene is from there, m.
    #[must_use]
    pub fn from_there(self, place: [f64; 3]) -> [f64; 3] {
        self.0.map_or(place, |anchor| difference(place, anchor))
    }

    /// A place that is seen from there, as it is in the scene, m.
    pub(crate) fn in_scene<R: Real>(self, place: [R; 3]) -> [R; 3] {
        let Some([x, y, z]) = self.0 else { return place };
        let [u, v, w] = place.map(R::to_f64);
        [u + x, v + y, w + z].map(R::from_f64)
    }
}

fn difference([x, y, z]: [f64; 3], [u, v, w]: [f64; 3]) -> [f64; 3] {
    [x - u, y - v, z - w]
}
