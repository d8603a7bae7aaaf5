//! Which particles springs join, and what holds them.

use std::collections::VecDeque;

use crate::model::{Hold, Model};

/// Particles that springs join, from the held ones outwards.
pub(super) struct Island {
    /// Each with the one it was reached from (itself if it is held or the first) and the spring's number.
    pub(super) members: Vec<(usize, usize, usize)>,
    pub(super) hold_count: usize,
    spring_count: usize,
}

impl Island {
    /// More springs than a tree or a ring has.
    pub(super) fn is_mesh(&self) -> bool {
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
        model.springs.iter().enumerate().filter_map(move |(number, spring)| {
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

/// All particles, by what springs join.
pub(super) fn islands(model: &Model) -> Vec<Island> {
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
        let holds: Vec<usize> = whole.iter().map(|member| member.0).filter(|&index| held(index)).collect();
        let ends: usize = whole.iter().map(|member| joints.starts[member.0 + 1] - joints.starts[member.0]).sum();
        let members = if holds.is_empty() {
            whole
        } else {
            for member in &whole {
                found[member.0] = false;
            }
            spread(&joints, &holds, &mut found)
        };
        islands.push(Island { members, hold_count: holds.len(), spring_count: ends / 2 });
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
