//! What a program that steps rows is asked, and what it answers, as text: all that has to get in and out of a machine.

use core::fmt::{self, Write};

use crate::course::{Machine, Reached};
use crate::row::Row;

/// Answers a question:
///
/// - nothing: a line for each row, with its digest at the end or why a step was refused;
/// - the four names of a row: a line for each of its steps, with the digest after it;
/// - those and a number: the state after that step, a line for each particle, the bits of position and velocity.
///
/// Numbers are hexadecimal, but for that of the step.
///
/// # Errors
/// If it cannot be written, or a question cannot be understood, which is written before.
pub fn answer(question: &str, machine: Machine<'_>, out: &mut impl Write) -> fmt::Result {
    let mut words = question.split_whitespace();
    if words.clone().next().is_none() {
        return Row::all().try_for_each(|row| end(row, machine, out));
    }
    let row = Row::of(&mut words);
    match (row, words.next().map(str::parse)) {
        (Some(row), None) => steps(row, machine, out),
        (Some(row), Some(Ok(step))) => state(row, step, machine, out),
        _ => {
            writeln!(out, "{question}: not a row, or not a step")?;
            Err(fmt::Error)
        }
    }
}

fn end(row: Row, machine: Machine<'_>, out: &mut impl Write) -> fmt::Result {
    let mut written = Ok(());
    row.follow(machine, &mut |reached| match reached {
        Reached::Step { number, digest, .. } if number == row.scene.steps() => {
            written = writeln!(out, "{row} {digest:016x}");
        }
        Reached::Step { .. } => {}
        Reached::Refused(error) => written = writeln!(out, "{row} refused: {error}"),
        Reached::Unbuilt(error) => written = writeln!(out, "{row} not built: {error}"),
    });
    written
}

fn steps(row: Row, machine: Machine<'_>, out: &mut impl Write) -> fmt::Result {
    let mut written = Ok(());
    row.follow(machine, &mut |reached| {
        let line = match reached {
            Reached::Step { digest, .. } => writeln!(out, "{digest:016x}"),
            Reached::Refused(error) => writeln!(out, "refused: {error}"),
            Reached::Unbuilt(error) => writeln!(out, "not built: {error}"),
        };
        written = written.and(line);
    });
    written
}

fn state(row: Row, step: u32, machine: Machine<'_>, out: &mut impl Write) -> fmt::Result {
    let mut written = Ok(());
    row.follow(machine, &mut |reached| {
        if let Reached::Step { number, state, .. } = reached
            && number == step
        {
            for [x, y, z, u, v, w] in state.map(|moment| moment.map(f64::to_bits)) {
                written = written.and(writeln!(out, "{x:016x} {y:016x} {z:016x} {u:016x} {v:016x} {w:016x}"));
            }
        }
    });
    written
}
