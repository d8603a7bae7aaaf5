//! What became of an accuracy that was asked for.

use std::time::Duration;

use super::choice::Choice;

/// How a run came to its accuracy, and how far it holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Attained {
    /// m
    pub asked: f64,
    /// What the run was made with.
    pub choice: Choice,
    /// What else was tried over the prefix and could have been taken, the cheapest first.
    pub others: Vec<Choice>,
    /// The largest error of any particle at any time, as far as it is known, m.
    pub estimate: f64,
    /// When the error was within what was asked for last, s; nothing if it always was.
    pub held_until: Option<f64>,
    /// The shortest step and the longest, s.
    pub time_steps: (f64, f64),
    /// How often it went back to go on in shorter steps.
    pub returns: u32,
    /// How often it began anew.
    pub restarts: u32,
    /// How long the pilot runs were, s of simulated time.
    pub prefix: f64,
    /// What they took.
    pub pilots: Duration,
    /// What all of it cost, with pilots, the run beside and what was taken back; [`step_cost`](super::step_cost) tells in
    /// what.
    pub cost: f64,
}

impl Attained {
    /// Whether the error is within what was asked for throughout.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.held_until.is_none()
    }
}
