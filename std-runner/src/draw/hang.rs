//! Where things that hang will plausibly go.

use glam::DVec3;

use super::floor::Plane;
use super::islands::Island;
use super::reach::above;
use crate::model::{Hold, Model};

/// What the held particles of an island let the others turn around.
enum Pivot {
    Point(DVec3),
    Line(DVec3, DVec3),
    /// Held at more than a line: they only sag.
    Fixed,
}

impl Pivot {
    fn of(holds: &[DVec3]) -> Self {
        let Some(&first) = holds.first() else {
            return Self::Fixed;
        };
        let far = holds
            .iter()
            .fold(first, |far, point| if (*point - first).length() > (far - first).length() { *point } else { far });
        let Some(direction) = (far - first).try_normalize() else {
            return Self::Point(first);
        };
        let off = |point: &DVec3| (*point - first).reject_from_normalized(direction).length();
        if holds.iter().all(|point| off(point) < 0.01 * (far - first).length()) {
            Self::Line(first, direction)
        } else {
            Self::Fixed
        }
    }

    fn nearest(&self, point: DVec3) -> DVec3 {
        match self {
            Self::Point(pivot) => *pivot,
            Self::Line(first, direction) => *first + (point - *first).project_onto_normalized(*direction),
            Self::Fixed => point,
        }
    }
}

/// The shortest way of each particle to what holds it. Islands share it, each with its own particles.
pub(super) struct Tree {
    /// Of the particle and all that hang on it, kg.
    load: Vec<f64>,
    /// From the hold, along springs stretched by their load, m.
    length: Vec<f64>,
    hold: Vec<usize>,
}

impl Tree {
    pub(super) fn new(count: usize) -> Self {
        Self { load: vec![0.0; count], length: vec![0.0; count], hold: vec![0; count] }
    }

    fn grow(&mut self, model: &Model, island: &Island, strength: f64) {
        let place = |index: usize| DVec3::from_array(model.particles[index].position);
        for &(index, from, _) in island.members.iter().rev() {
            self.load[index] += model.particles[index].mass;
            if from != index {
                self.load[from] += self.load[index];
            }
        }
        // A lone chain dropped from rest overshoots to twice its stretch; in a mesh many paths share the load.
        let share = if island.is_mesh() { 0.15 } else { 2.0 };
        for &(index, from, spring) in &island.members {
            if from == index {
                self.hold[index] = index;
                continue;
            }
            self.hold[index] = self.hold[from];
            let spring = &model.springs[spring];
            let span = spring.rest_length.max(0.0);
            let start = (place(index) - place(from)).length();
            let stretch = share * self.load[index] * strength / spring.stiffness;
            let stretch = if stretch > 0.0 { stretch.min(span.max(start)) } else { 0.0 };
            self.length[index] = self.length[from] + span + stretch;
        }
    }

    /// Room for what hangs: straight down from its hold, and swung across to the other side.
    pub(super) fn hang(
        &mut self,
        model: &Model,
        island: &Island,
        gravity: DVec3,
        planes: &[Plane],
        points: &mut Vec<DVec3>,
    ) {
        self.grow(model, island, gravity.length());
        let down = gravity.normalize();
        let place = |index: usize| DVec3::from_array(model.particles[index].position);
        let (held, free) = island.members.split_at(island.hold_count);
        let holds: Vec<usize> = held.iter().map(|member| member.0).collect();
        let pivot = Pivot::of(&holds.iter().map(|&index| place(index)).collect::<Vec<_>>());
        let travel = travel(model, &holds);
        for &(index, ..) in free {
            let start = place(index);
            let turning = pivot.nearest(start);
            let aside = (turning - place(self.hold[index])).length();
            let sag = (self.length[index].powi(2) - aside.powi(2)).max(0.0).sqrt();
            let aside = (start - turning).reject_from_normalized(down);
            // A mesh bends and comes to rest on the way; what turns about one point swings as high again.
            let across = if island.is_mesh() {
                turning - aside * 0.7 + down * (aside.length() * 0.7)
            } else {
                start - 2.0 * aside
            };
            for offset in &travel {
                for point in [start, turning + down * sag, across] {
                    points.push(above(planes, point + *offset, down));
                }
            }
        }
    }
}

/// How far held particles are carried: the extremes of the offsets on their tracks, and none.
fn travel(model: &Model, holds: &[usize]) -> Vec<DVec3> {
    let mut offsets = vec![DVec3::ZERO];
    let tracks = holds.iter().filter_map(|&index| match model.particles[index].hold {
        Hold::Track(number) => model.tracks.get(number as usize),
        _ => None,
    });
    let moves: Vec<DVec3> = tracks
        .flat_map(|track| {
            let first = track.keys.first().map_or([0.0; 3], |key| key.1);
            track.keys.iter().map(move |key| DVec3::from_array(key.1) - DVec3::from_array(first))
        })
        .collect();
    for axis in [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z] {
        let extreme = moves.iter().copied().max_by(|a, b| a.dot(axis).total_cmp(&b.dot(axis)));
        offsets.extend(extreme.filter(|offset| offset.dot(axis) > 0.0));
    }
    offsets
}
