//! What can be known of a run's pictures before its first step.

use glam::DVec3;

use super::camera::Camera;
use super::floor::{Floor, Plane};
use super::looks::Looks;
use super::outlook::Outlook;
use super::reach::{extent, reach};
use super::view::{View, middle};
use crate::model::{CameraChoice, Model};

/// A scene as the pictures need it, apart from the model it was made of.
#[derive(Clone, Debug)]
pub struct Scenery {
    pub(super) name: String,
    /// The particles it joins, and its rest length, m.
    pub(super) springs: Vec<([u32; 2], f64)>,
    pub(super) looks: Looks,
    pub(super) floor: Floor,
    pub(super) down: Option<DVec3>,
    pub(super) view: View,
    /// Depths beyond the nearest and before the farthest of what there is at the start, m.
    pub(super) depths: [f64; 2],
}

impl Scenery {
    /// Looks at a model under gravity (m/s²) and chooses how to show it.
    #[must_use]
    pub fn new(model: &Model, gravity: [f64; 3], name: &str, choice: &CameraChoice) -> Self {
        let gravity = Some(DVec3::from_array(gravity)).filter(|gravity| gravity.is_finite());
        let down = gravity.and_then(DVec3::try_normalize);
        let planes: Vec<Plane> = model.planes.iter().filter_map(plane).collect();
        let points = reach(model, down.and(gravity).unwrap_or(DVec3::ZERO), &planes);
        let extent = extent(&points);
        let looks = Looks::new(model, extent);
        // A scene that is one point still needs some room around it.
        let room = looks.largest.max(0.02 * extent);
        let view = View::new(&points, room, down, &Outlook { model, planes: &planes }, choice);
        let lowered = planes.iter().map(|plane| Plane { offset: plane.offset - looks.largest, ..*plane });
        let floor = Floor {
            planes: lowered.collect(),
            middle: middle(&points),
            radius: 1.25 * extent,
            up: down.map_or(DVec3::Z, |down| -down),
        };
        let camera = view.camera();
        let depths = points.iter().map(|point| camera.seen(*point)[2]);
        let depths = depths.fold([f64::MAX, f64::MIN], |[near, far], depth| [near.min(depth), far.max(depth)]);
        let springs = model.springs.iter().map(|spring| (spring.between, spring.rest_length)).collect();
        Self { name: name.to_owned(), springs, looks, floor, down, view, depths }
    }

    /// The camera as it is before the first frame.
    #[must_use]
    pub fn camera(&self) -> Camera {
        self.view.camera()
    }
}

fn plane(plane: &crate::model::ModelPlane) -> Option<Plane> {
    let normal = DVec3::from_array(plane.normal).try_normalize()?;
    let offset = normal.dot(DVec3::from_array(plane.point));
    offset.is_finite().then_some(Plane { normal, offset })
}
