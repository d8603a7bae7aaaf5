//! Where things will plausibly go: what a camera that can't know the future should leave room for.

use std::collections::VecDeque;

use glam::DVec3;

use super::floor::Plane;
use super::shadow::below;
use crate::model::{Hold, Model};

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
    let keys = model
        .tracks
        .iter()
        .flat_map(|track| track.keys.iter().map(|key| key.1));
    let particles = model.particles.iter().map(|particle| particle.position);
    let usable = |point: &DVec3| point.is_finite() && point.abs().max_element() < 1e15;
    particles
        .chain(keys)
        .map(DVec3::from_array)
        .filter(usable)
        .collect()
}

/// Where a plane lies not far below things: seeing it tells how high they are.
fn floor_below(points: &[DVec3], gravity: DVec3, planes: &[Plane]) -> Option<DVec3> {
    let down = gravity.try_normalize()?;
    let lowest = points
        .iter()
        .copied()
        .max_by(|a, b| a.dot(down).total_cmp(&b.dot(down)))?;
    let (_, depth, foot) = below(planes, down, lowest)?;
    (depth < 0.8 * extent(points)).then_some(foot)
}

/// The diagonal of the box around points; 1 m if that is nothing.
pub(super) fn extent(points: &[DVec3]) -> f64 {
    let low = points
        .iter()
        .fold(DVec3::INFINITY, |low, point| low.min(*point));
    let high = points
        .iter()
        .fold(DVec3::NEG_INFINITY, |high, point| high.max(*point));
    let diagonal = (high - low).length();
    if diagonal.is_finite() && diagonal > 0.0 {
        diagonal
    } else {
        1.0
    }
}

/// Particles that springs join, from the held ones outwards.
struct Island {
    /// Each with the one it was reached from (itself if it is held or the first) and the spring's number.
    members: Vec<(usize, usize, usize)>,
    hold_count: usize,
    spring_count: usize,
}

impl Island {
    /// More springs than a tree or a ring has.
    fn is_mesh(&self) -> bool {
        self.spring_count > self.members.len()
    }
}

/// Each particle's springs: `springs[starts[i]..starts[i + 1]]` are particle i's, with the other ends.
struct Joints {
    starts: Vec<usize>,
    springs: Vec<(usize, usize)>,
}

fn joints(model: &Model) -> Joints {
    let count = model.particles.len();
    let ends = || {
        model
            .springs
            .iter()
            .enumerate()
            .filter_map(move |(number, spring)| {
                let [from, to] = spring.between.map(|end| end as usize);
                (from < count && to < count && from != to).then_some((number, from, to))
            })
    };
    let mut starts = vec![0usize; count + 1];
    for (_, from, to) in ends() {
        starts[from + 1] += 1;
        starts[to + 1] += 1;
    }
    for index in 0..count {
        starts[index + 1] += starts[index];
    }
    let mut next = starts.clone();
    let mut springs = vec![(0, 0); starts[count]];
    for (number, from, to) in ends() {
        springs[next[from]] = (number, to);
        next[from] += 1;
        springs[next[to]] = (number, from);
        next[to] += 1;
    }
    Joints { starts, springs }
}

fn islands(model: &Model) -> Vec<Island> {
    let joints = joints(model);
    let count = model.particles.len();
    let held = |index: usize| model.particles[index].hold != Hold::Free;
    let mut found = vec![false; count];
    let mut islands = Vec::new();
    for seed in 0..count {
        if found[seed] {
            continue;
        }
        // All of the island first, to know what holds it; then again, outwards from what does.
        let whole = spread(&joints, &[seed], &mut found);
        let holds: Vec<usize> = whole
            .iter()
            .map(|member| member.0)
            .filter(|&index| held(index))
            .collect();
        let ends: usize = whole
            .iter()
            .map(|member| joints.starts[member.0 + 1] - joints.starts[member.0])
            .sum();
        let members = if holds.is_empty() {
            whole
        } else {
            for member in &whole {
                found[member.0] = false;
            }
            spread(&joints, &holds, &mut found)
        };
        islands.push(Island {
            members,
            hold_count: holds.len(),
            spring_count: ends / 2,
        });
    }
    islands
}

/// Everything that springs join to the seeds, nearest in number of springs first.
fn spread(joints: &Joints, seeds: &[usize], found: &mut [bool]) -> Vec<(usize, usize, usize)> {
    let mut queue: VecDeque<usize> = seeds.iter().copied().collect();
    let mut members = Vec::new();
    for &seed in seeds {
        found[seed] = true;
        members.push((seed, seed, 0));
    }
    while let Some(from) = queue.pop_front() {
        for &(spring, to) in &joints.springs[joints.starts[from]..joints.starts[from + 1]] {
            if !found[to] {
                found[to] = true;
                members.push((to, from, spring));
                queue.push_back(to);
            }
        }
    }
    members
}

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
        let far = holds.iter().fold(first, |far, point| {
            if (*point - first).length() > (far - first).length() {
                *point
            } else {
                far
            }
        });
        let Some(direction) = (far - first).try_normalize() else {
            return Self::Point(first);
        };
        let off = |point: &DVec3| (*point - first).reject_from_normalized(direction).length();
        if holds
            .iter()
            .all(|point| off(point) < 0.01 * (far - first).length())
        {
            Self::Line(first, direction)
        } else {
            Self::Fixed
        }
    }

    fn nearest(&self, point: DVec3) -> DVec3 {
        match self {
            Self::Point(pivot) => *pivot,
            Self::Line(first, direction) => {
                *first + (point - *first).project_onto_normalized(*direction)
            }
            Self::Fixed => point,
        }
    }
}

/// The shortest way of each particle to what holds it. Islands share it, each with its own particles.
struct Tree {
    /// Of the particle and all that hang on it, kg.
    load: Vec<f64>,
    /// From the hold, along springs stretched by their load, m.
    length: Vec<f64>,
    hold: Vec<usize>,
}

impl Tree {
    fn new(count: usize) -> Self {
        Self {
            load: vec![0.0; count],
            length: vec![0.0; count],
            hold: vec![0; count],
        }
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
            let stretch = if stretch > 0.0 {
                stretch.min(span.max(start))
            } else {
                0.0
            };
            self.length[index] = self.length[from] + span + stretch;
        }
    }

    /// Room for what hangs: straight down from its hold, and swung across to the other side.
    fn hang(
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
    let tracks = holds
        .iter()
        .filter_map(|&index| match model.particles[index].hold {
            Hold::Track(number) => model.tracks.get(number as usize),
            _ => None,
        });
    let moves: Vec<DVec3> = tracks
        .flat_map(|track| {
            let first = track.keys.first().map_or([0.0; 3], |key| key.1);
            track
                .keys
                .iter()
                .map(move |key| DVec3::from_array(key.1) - DVec3::from_array(first))
        })
        .collect();
    for axis in [
        DVec3::X,
        DVec3::Y,
        DVec3::Z,
        -DVec3::X,
        -DVec3::Y,
        -DVec3::Z,
    ] {
        let extreme = moves
            .iter()
            .copied()
            .max_by(|a, b| a.dot(axis).total_cmp(&b.dot(axis)));
        offsets.extend(extreme.filter(|offset| offset.dot(axis) > 0.0));
    }
    offsets
}

/// The point, or if it lies under a floor, the floor above it.
fn above(planes: &[Plane], mut point: DVec3, down: DVec3) -> DVec3 {
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
fn fly(
    model: &Model,
    island: &Island,
    gravity: DVec3,
    planes: &[Plane],
    extent: f64,
    points: &mut Vec<DVec3>,
) {
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
                points.push(above(
                    planes,
                    place + downhill * extent * MARGIN * 1.5,
                    down,
                ));
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
    [helper / pull, height / helper]
        .into_iter()
        .filter(|time| *time > 0.0 && *time < 1e3)
        .min_by(f64::total_cmp)
}
