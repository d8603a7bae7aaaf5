//! Where things will plausibly go: what a camera that can't know the future should leave room for.

use glam::DVec3;

use super::floor::Plane;
use super::hang::Tree;
use super::islands::{Island, islands};
use super::shadow::below;
use crate::model::Model;

/// The share of the scene's extent that free things get where nothing says how far they will go.
const MARGIN: f64 = 0.5;

/// Points that the picture should have room for.
pub(super) fn reach(model: &Model, gravity: DVec3, planes: &[Plane]) -> Vec<DVec3> {
    let mut points = starts(model);
    let extent = extent(&points);
    let mut tree = Tree::new(model.particles.len());
    for island in islands(model) {
        if island.hold_count == 0 {
            fly(model, &island, gravity, planes, extent, &mut points);
        } else if gravity != DVec3::ZERO {
            tree.hang(model, &island, gravity, planes, &mut points);
        }
    }
    points.retain(|point| point.is_finite());
    points.extend(floor_below(&points, gravity, planes));
    if points.is_empty() {
        points.push(DVec3::ZERO);
    }
    points
}

/// Where everything is at the start, and every key of every track.
fn starts(model: &Model) -> Vec<DVec3> {
    let keys = model.tracks.iter().flat_map(|track| track.keys.iter().map(|key| key.1));
    let particles = model.particles.iter().map(|particle| particle.position);
    let usable = |point: &DVec3| point.is_finite() && point.abs().max_element() < 1e15;
    particles.chain(keys).map(DVec3::from_array).filter(usable).collect()
}

/// Where a plane lies not far below things: seeing it tells how high they are.
fn floor_below(points: &[DVec3], gravity: DVec3, planes: &[Plane]) -> Option<DVec3> {
    let down = gravity.try_normalize()?;
    let lowest = points.iter().copied().max_by(|a, b| a.dot(down).total_cmp(&b.dot(down)))?;
    let (_, depth, foot) = below(planes, down, lowest)?;
    (depth < 0.8 * extent(points)).then_some(foot)
}

/// The diagonal of the box around points; 1 m if that is nothing.
pub(super) fn extent(points: &[DVec3]) -> f64 {
    let low = points.iter().fold(DVec3::INFINITY, |low, point| low.min(*point));
    let high = points.iter().fold(DVec3::NEG_INFINITY, |high, point| high.max(*point));
    let diagonal = (high - low).length();
    if diagonal.is_finite() && diagonal > 0.0 { diagonal } else { 1.0 }
}

/// The point, or if it lies under a floor, the floor above it.
pub(super) fn above(planes: &[Plane], mut point: DVec3, down: DVec3) -> DVec3 {
    for plane in planes {
        let slope = plane.normal.dot(down);
        let depth = plane.height(point);
        if slope < -1e-3 && depth < 0.0 {
            point -= down * (depth / slope);
        }
    }
    point
}

/// Room for what flies: up as far as it is thrown, then down to the first plane.
fn fly(model: &Model, island: &Island, gravity: DVec3, planes: &[Plane], extent: f64, points: &mut Vec<DVec3>) {
    for &(index, ..) in &island.members {
        let start = DVec3::from_array(model.particles[index].position);
        let velocity = DVec3::from_array(model.particles[index].velocity);
        let strength = gravity.length();
        if strength == 0.0 {
            points.push(start + velocity.normalize_or_zero() * extent * MARGIN);
            continue;
        }
        let down = gravity / strength;
        let rise = -velocity.dot(down) / strength;
        if rise > 0.0 {
            points.push(start + velocity * rise + 0.5 * gravity * rise * rise);
        }
        let landing = planes
            .iter()
            .filter_map(|plane| Some((fall_time(plane, start, velocity, gravity)?, plane)))
            .min_by(|a, b| a.0.total_cmp(&b.0));
        match landing {
            Some((time, plane)) => {
                let place = start + velocity * time + 0.5 * gravity * time * time;
                // On a slope it will go on downhill.
                let downhill = down.reject_from_normalized(plane.normal);
                points.push(place);
                points.push(above(planes, place + downhill * extent * MARGIN * 1.5, down));
            }
            None => points.push(above(planes, start + down * extent * MARGIN, down)),
        }
    }
}

/// When a thrown particle comes to a plane from its front, s.
fn fall_time(plane: &Plane, start: DVec3, velocity: DVec3, gravity: DVec3) -> Option<f64> {
    let (height, speed) = (plane.height(start), plane.normal.dot(velocity));
    let pull = 0.5 * plane.normal.dot(gravity);
    if height < 0.0 {
        return None;
    }
    // height + speed t + pull t² = 0, in the form that does not cancel.
    let root = (speed * speed - 4.0 * pull * height).sqrt();
    let helper = -0.5 * (speed + if speed < 0.0 { -root } else { root });
    [helper / pull, height / helper].into_iter().filter(|time| *time > 0.0 && *time < 1e3).min_by(f64::total_cmp)
}
