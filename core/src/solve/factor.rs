//! The Cholesky factorisation L·D·Lᵀ of an implicit step's matrix, in blocks of 3 × 3.
//!
//! Column by column, each taken from those to its right as soon as it is known (George and Liu, *Computer Solution of
//! Large Sparse Positive Definite Systems*, 1981): the entries stay in place and no room is needed beside them.

use super::block::{
    Block, Symmetric, divide, solve_diagonal, solve_lower, solve_upper, subtract_columns, subtract_product,
    subtract_rows, subtract_spring, subtract_symmetric, take_apart, times_diagonal, transposed,
};
use super::room::Direct;
use super::structure::Structure;
use super::workspace::Scratch;
use crate::Real;
use crate::contact::Support;
use crate::vectors::{at, put};
use crate::world::System;

/// A factor, or the room for one.
pub struct Factor<'a, R> {
    /// Where its entries are.
    pub structure: Structure<'a>,
    /// Below the diagonal, entry by entry.
    pub blocks: &'a mut [Block<R>],
    /// The diagonal, turn by turn: assembled, and then taken apart.
    pub diagonal: &'a mut [Symmetric<R>],
    /// Room for a solution, turn by turn.
    pub solution: &'a mut [[R; 3]],
}

impl<R: Real> Scratch<'_, R> {
    /// Makes the factor of the matrix. If that is not positive definite there is none.
    pub fn factorise(&mut self, system: &System<'_, R>) {
        self.add_up_diagonal(system);
        let Direct { factor, is_made, .. } = &mut self.direct;
        for (entry, slot) in factor.diagonal.iter_mut().zip(factor.structure.slot_at) {
            *entry = at(self.blocks, *slot);
        }
        factor.blocks.as_flattened_mut().as_flattened_mut().fill(R::ZERO);
        let springs = factor.structure.entry_of.iter().take(system.springs.ends.len());
        for (entry, (axis, [stretch, across])) in springs.zip(self.axis.iter().zip(self.resistance.iter())) {
            // There is none where an end is held.
            if let Some(block) = factor.blocks.get_mut(*entry as usize) {
                subtract_spring(block, *axis, *stretch, *across);
            }
        }
        if system.support.is_some() {
            factor.confine(system, self.support);
        }
        *is_made = factor.factorise();
    }
}

impl<R: Real> Factor<'_, R> {
    /// Takes from rows and columns the directions that planes hold up; there the matrix becomes the mass.
    fn confine(&mut self, system: &System<'_, R>, support: &[Support<R>]) {
        for (turn, slot) in (0..).zip(self.structure.slot_at.iter().take(self.diagonal.len())) {
            let held = at(support, *slot);
            let (entries, rows) = self.structure.column(turn);
            let column = self.blocks.get_mut(entries).unwrap_or_default();
            for (block, row) in column.iter_mut().zip(rows) {
                let row_held = at(support, at(self.structure.slot_at, *row));
                if held != Support::None || row_held != Support::None {
                    allow_between(block, held, row_held);
                }
            }
            if held != Support::None
                && let Some(block) = self.diagonal.get_mut(turn as usize)
            {
                *block = confined(*block, held, at(system.mass, *slot));
            }
        }
    }

    /// False if it is not positive definite.
    fn factorise(&mut self) -> bool {
        let Self { structure, blocks, diagonal, .. } = self;
        let turns = diagonal.len() as u32;
        for turn in 0..turns {
            let (entries, rows) = structure.column(turn);
            let Some((pivot, d)) = take_apart(at(diagonal, turn)) else { return false };
            put(diagonal, turn, pivot);
            let Some((done, after)) = blocks.split_at_mut_checked(entries.end) else { return false };
            let column = done.get_mut(entries.clone()).unwrap_or_default();
            for block in column.iter_mut() {
                divide(block, pivot);
            }
            let mut rest = column.iter().zip(rows);
            while let Some((block, row)) = rest.next() {
                let scaled = times_diagonal(*block, d);
                let transpose = transposed(scaled);
                if let Some(target) = diagonal.get_mut(*row as usize) {
                    subtract_symmetric(target, block, &scaled);
                }
                // The column of `row` has an entry for each one below it here, both in ascending order.
                let (targets, target_rows) = structure.column(*row);
                let target_blocks = after.get_mut(targets.start - entries.end..targets.end - entries.end);
                let mut targets = target_rows.iter().zip(target_blocks.unwrap_or_default());
                for (below, row) in rest.clone() {
                    if let Some((_, target)) = targets.find(|(target_row, _)| *target_row == row) {
                        subtract_product(target, below, &transpose);
                    }
                }
            }
        }
        true
    }

    /// Writes A⁻¹ r to `out`, both by slot; 0 where held.
    pub fn solve(&mut self, r: &[[R; 3]], out: &mut [[R; 3]]) {
        let Self { structure, blocks, diagonal, solution } = self;
        for (value, slot) in solution.iter_mut().zip(structure.slot_at) {
            *value = at(r, *slot);
        }
        for (turn, pivot) in (0..).zip(diagonal.iter()) {
            let known = solve_lower(*pivot, at(solution, turn));
            put(solution, turn, solve_diagonal(*pivot, known));
            let (entries, rows) = structure.column(turn);
            for (row, block) in rows.iter().zip(blocks.get(entries).unwrap_or_default()) {
                if let Some(value) = solution.get_mut(*row as usize) {
                    *value = subtract_rows(*value, block, known);
                }
            }
        }
        for (turn, pivot) in (0..diagonal.len() as u32).zip(diagonal.iter()).rev() {
            let (entries, rows) = structure.column(turn);
            let mut value = at(solution, turn);
            for (row, block) in rows.iter().zip(blocks.get(entries).unwrap_or_default()) {
                value = subtract_columns(value, block, at(solution, *row));
            }
            put(solution, turn, solve_upper(*pivot, value));
        }
        for (value, turn) in out.iter_mut().zip(structure.turn_of) {
            *value = at(solution, *turn);
        }
    }
}

/// b P, where P is what a support allows.
fn allow_rows<R: Real>(block: &mut Block<R>, support: Support<R>) {
    for row in block {
        let [a, b, c, _] = *row;
        let [a, b, c] = support.allow([a, b, c]);
        *row = [a, b, c, R::ZERO];
    }
}

/// Q b P, where P is what the first of two supports allows and Q what the second does.
fn allow_between<R: Real>(block: &mut Block<R>, first: Support<R>, second: Support<R>) {
    allow_rows(block, first);
    *block = transposed(*block);
    allow_rows(block, second);
    *block = transposed(*block);
}

/// P b P + m (I − P).
fn confined<R: Real>([xx, yy, zz, xy, xz, yz]: Symmetric<R>, support: Support<R>, m: R) -> Symmetric<R> {
    let o = R::ZERO;
    let mut block = [[xx, xy, xz, o], [xy, yy, yz, o], [xz, yz, zz, o]];
    allow_between(&mut block, support, support);
    let [[xx, ..], [xy, yy, ..], [xz, yz, zz, _]] = block;
    let mut allowed = [[R::ONE, o, o, o], [o, R::ONE, o, o], [o, o, R::ONE, o]];
    allow_rows(&mut allowed, support);
    let [[pxx, pxy, pxz, _], [_, pyy, pyz, _], [_, _, pzz, _]] = allowed;
    [
        xx + m * (R::ONE - pxx),
        yy + m * (R::ONE - pyy),
        zz + m * (R::ONE - pzz),
        xy - m * pxy,
        xz - m * pxz,
        yz - m * pyz,
    ]
}
