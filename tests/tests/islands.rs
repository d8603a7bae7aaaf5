//! The islands that sleep and wake together are those that a search of the spring graph finds.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use std::collections::BTreeSet;

use hooke::{Project, SemiImplicitEuler, Sleep};
use hooke_runner::model::{Hold, Model};
use hooke_runner::simulate::{HeapWorld, world};
use hooke_tests::graphs::Graph;

const TIME_STEP: f64 = 1e-3;

/// Looks are so far apart that they take this many steps at most, and a few more after a disturbance.
const STEPS: usize = 40;

/// At rest, in several parts, with pins on one or on many of them.
fn at_rest(seed: u64) -> Model {
    let graph = Graph { particles: 40, springs: 26, strain: [1.0, 1.0], ..Graph::default() };
    let mut model = graph.model(seed);
    model.particles.iter_mut().for_each(|particle| particle.velocity = [0.0; 3]);
    model
}

fn is_held(model: &Model, particle: u32) -> bool {
    model.particles[particle as usize].hold != Hold::Free
}

fn neighbours(model: &Model, particle: u32) -> impl Iterator<Item = u32> {
    let ends = model.springs.iter().map(|spring| spring.between);
    ends.filter_map(move |[i, j]| if i == particle { Some(j) } else { (j == particle).then_some(i) })
}

/// What a walk along springs from a particle comes to, without walking on from held ones.
fn reached(model: &Model, from: u32) -> BTreeSet<u32> {
    let mut found = BTreeSet::from([from]);
    let mut to_visit = vec![from];
    while let Some(particle) = to_visit.pop() {
        for next in neighbours(model, particle) {
            if found.insert(next) && !is_held(model, next) {
                to_visit.push(next);
            }
        }
    }
    found
}

/// Each island with what it alone holds on to.
fn islands(model: &Model) -> Vec<BTreeSet<u32>> {
    let numbers = 0..model.particles.len() as u32;
    let movable = numbers.filter(|number| !is_held(model, *number) && neighbours(model, *number).next().is_some());
    let reached: BTreeSet<BTreeSet<u32>> = movable.map(|particle| reached(model, particle)).collect();
    let owners = |particle: u32| reached.iter().filter(|island| island.contains(&particle)).count();
    reached.iter().map(|island| island.iter().copied().filter(|particle| owners(*particle) == 1).collect()).collect()
}

fn sleeping(model: &Model) -> HeapWorld<f64> {
    let mut world = world::<f64>(model, [0.0; 3]).unwrap();
    world.set_sleep(Some(Sleep::below(1e-3).after(0.01))).unwrap();
    rest(&mut world);
    world
}

fn rest(world: &mut HeapWorld<f64>) {
    for _ in 0..STEPS {
        world.step(&mut SemiImplicitEuler, &mut Project, TIME_STEP).unwrap();
    }
}

#[test]
fn are_what_a_search_finds() {
    let (mut most, mut shared) = (0, false);
    for seed in 0..20 {
        let model = at_rest(seed);
        let islands = islands(&model);
        let mut world = sleeping(&model);
        let plan = *world.view().plan();
        assert_eq!(plan.islands as usize, islands.len(), "seed {seed}");
        assert_eq!(plan.islands_asleep, plan.islands, "seed {seed}");
        assert_eq!(plan.asleep as usize, islands.iter().map(BTreeSet::len).sum::<usize>(), "seed {seed}");
        most = most.max(islands.len());
        let alone = |pin: u32| islands.iter().all(|island| !island.contains(&pin));
        shared |= (0..model.particles.len() as u32)
            .any(|pin| is_held(&model, pin) && neighbours(&model, pin).next().is_some() && alone(pin));
    }
    // Else there was little to find.
    assert!(most >= 5 && shared, "{most} islands at most");
}

#[test]
fn wake_together() {
    for seed in 0..8 {
        let model = at_rest(seed);
        let islands = islands(&model);
        let mut world = sleeping(&model);
        for particle in 0..model.particles.len() as u32 {
            let place = world.position(particle).unwrap();
            world.set_position(particle, place).unwrap();
            let disturbed: BTreeSet<u32> = if is_held(&model, particle) {
                neighbours(&model, particle).filter(|neighbour| !is_held(&model, *neighbour)).collect()
            } else {
                BTreeSet::from([particle])
            };
            let still = islands.iter().filter(|island| island.is_disjoint(&disturbed));
            let plan = *world.view().plan();
            assert_eq!(plan.asleep as usize, still.clone().map(BTreeSet::len).sum::<usize>(), "{seed}: {particle}");
            assert_eq!(plan.islands_asleep as usize, still.count(), "{seed}: {particle}");
            rest(&mut world);
            assert_eq!(world.view().plan().islands_asleep as usize, islands.len(), "{seed}: {particle}");
        }
    }
}
