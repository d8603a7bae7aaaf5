//! The room for a factor, what is known of it from step to step, and whether it is worth its work.

use super::block::{Block, Symmetric};
use super::factor::Factor;
use super::ordering::{Node, Ordering};
use super::structure::{Structure, analyse, fingerprint};
use super::worth::{Elimination, LinearSolver, stiffness};
use crate::Real;
use crate::world::{Column, Storage, System};

/// 9 reals and 40 bytes a particle, 8 bytes a spring, and `FILL` blocks of 12 reals and 4 bytes a spring.
pub struct Room<R: Real, M: Storage, const FILL: usize> {
    nodes: M::Particles<Node>,
    turn_of: M::Particles<u32>,
    slot_at: M::Particles<u32>,
    column_end: M::Particles<u32>,
    links: M::Springs<[u32; 2]>,
    rows: M::Springs<[u32; FILL]>,
    blocks: M::Springs<[Block<R>; FILL]>,
    diagonal: M::Particles<Symmetric<R>>,
    solution: M::Particles<[R; 3]>,
    /// The topology that has been analysed, and what came of it: nothing if the factor is too large.
    analysed: Option<(u64, Option<Elimination>)>,
    solver: LinearSolver,
}

/// A factor that may be made in a step.
pub struct Direct<'a, R> {
    /// The factor, or room for it.
    pub factor: Factor<'a, R>,
    /// What it is worth.
    pub solver: LinearSolver,
    /// Whether there is a factor, of a matrix earlier in this step.
    pub is_made: bool,
    /// Whether this step uses one.
    pub is_chosen: bool,
}

impl<R: Real, M: Storage, const FILL: usize> Room<R, M, FILL> {
    pub const fn new() -> Self {
        Self {
            nodes: Column::EMPTY,
            turn_of: Column::EMPTY,
            slot_at: Column::EMPTY,
            column_end: Column::EMPTY,
            links: Column::EMPTY,
            rows: Column::EMPTY,
            blocks: Column::EMPTY,
            diagonal: Column::EMPTY,
            solution: Column::EMPTY,
            analysed: None,
            solver: LinearSolver::NOTHING,
        }
    }

    /// Makes sure of what a factor would be worth in a step of `dt`; the springs are only analysed if it may be any.
    pub fn prepare(&mut self, system: &System<'_, R>, dt: R) -> LinearSolver {
        let stiffness = stiffness(system, dt);
        let elimination = Elimination::without_fill(&system.plan);
        let mut solver = LinearSolver::of(&system.plan, elimination, stiffness);
        if solver.is_direct() {
            let elimination = self.analyse(system).unwrap_or(Elimination::IMPOSSIBLE);
            solver = LinearSolver::of(&system.plan, elimination, stiffness);
        } else {
            // It is not analysed, so there is no factor to fall back to.
            solver.patience = f64::INFINITY;
        }
        self.solver = solver;
        solver
    }

    /// What eliminating all particles takes; nothing where that is more than there is room for.
    pub fn analyse(&mut self, system: &System<'_, R>) -> Option<Elimination> {
        let topology = fingerprint(system);
        if let Some((known, elimination)) = self.analysed
            && known == topology
        {
            return elimination;
        }
        let elimination = self.order(system);
        self.analysed = Some((topology, elimination));
        elimination
    }

    /// Seeks an order that leaves no more entries than there is room for.
    fn order(&mut self, system: &System<'_, R>) -> Option<Elimination> {
        let (particles, springs) = (system.plan.attached as usize, system.plan.springs as usize);
        self.nodes.fit(particles).ok()?;
        for column in [&mut self.turn_of, &mut self.slot_at, &mut self.column_end] {
            column.fit(particles).ok()?;
        }
        self.links.fit(springs).ok()?;
        let mut chunks = if FILL == 0 { 0 } else { springs.div_ceil(FILL) };
        let found = loop {
            // Whatever has room for the springs has room for these, but there is no harm in none.
            reach(&mut self.rows, [0; FILL], chunks)?;
            let ordering = Ordering {
                nodes: self.nodes.items_mut(),
                nowhere: Node::NOWHERE,
                links: self.links.items_mut().as_flattened_mut(),
                turn_of: self.turn_of.items_mut(),
                slot_at: self.slot_at.items_mut(),
                column_end: self.column_end.items_mut(),
                rows: first(self.rows.items_mut().as_flattened_mut(), chunks * FILL),
            };
            if let Some(found) = analyse(system, ordering) {
                break found;
            }
            if chunks >= springs || FILL == 0 {
                return None;
            }
            chunks = springs.min(2 * chunks);
        };
        self.diagonal.fit(found.particles as usize).ok()?;
        self.solution.fit(found.particles as usize).ok()?;
        reach(&mut self.blocks, const { [[[R::ZERO; 4]; 3]; FILL] }, (found.blocks as usize).div_ceil(FILL.max(1)))?;
        Some(found)
    }

    /// As slices.
    pub fn lend(&mut self) -> Direct<'_, R> {
        let blocks = self.analysed.and_then(|(_, found)| found).map_or(0, |found| found.blocks);
        let structure = Structure {
            turn_of: self.turn_of.items(),
            slot_at: self.slot_at.items(),
            column_end: self.column_end.items(),
            rows: self.rows.items().as_flattened(),
            entry_of: self.links.items().as_flattened(),
        };
        let factor = Factor {
            structure,
            blocks: first(self.blocks.items_mut().as_flattened_mut(), blocks as usize),
            diagonal: self.diagonal.items_mut(),
            solution: self.solution.items_mut(),
        };
        Direct { factor, solver: self.solver, is_made: false, is_chosen: self.solver.is_direct() }
    }
}

/// Makes a column at least so long. Nothing where there is no room.
fn reach<T: Copy>(column: &mut impl Column<T>, item: T, length: usize) -> Option<()> {
    while column.items().len() < length {
        column.push(item).ok()?;
    }
    Some(())
}

/// The first so many items, or all if there are fewer.
fn first<T>(items: &mut [T], count: usize) -> &mut [T] {
    let count = count.min(items.len());
    items.get_mut(..count).unwrap_or_default()
}
