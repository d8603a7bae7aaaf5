//! How far a measurement is, on a terminal.

use std::cell::Cell;

use indicatif::ProgressBar;

use crate::bench::{Contender, News, Swept};
use crate::cli::progress::counter;
use crate::units::{metres, seconds};

/// A bar that counts contenders, with a line above it for each that is done; nothing where nobody looks.
pub(super) struct Told {
    bar: Option<ProgressBar>,
    runs: Cell<u32>,
    contender: Cell<Option<Contender>>,
}

impl Told {
    pub(super) fn new(scene: &str) -> Self {
        Self { bar: counter(scene), runs: Cell::new(0), contender: Cell::new(None) }
    }

    pub(super) fn tell(&self, news: News<'_>) {
        let Some(bar) = &self.bar else { return };
        match news {
            News::Reference => bar.set_message("making a reference"),
            News::Begins(contender, number, of) => {
                bar.set_length(of as u64);
                bar.set_position(number as u64 - 1);
                bar.set_message(contender.to_string());
                self.runs.set(0);
                self.contender.set(Some(contender));
            }
            News::Point(point) => {
                self.runs.set(self.runs.get() + 1);
                let contender = self.contender.get().map_or_else(String::new, |contender| contender.to_string());
                bar.set_message(format!("{contender}: {} runs, the last of {}", self.runs.get(), point.asked));
            }
            News::Swept(swept) => bar.println(format!("  {}", best(swept))),
            News::Finish => bar.set_message("all run once more, and those that may win several times"),
            News::Traces => bar.set_message("error and energy over time"),
        }
    }

    /// Takes it off the terminal.
    pub(super) fn clear(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

/// A contender's best.
fn best(swept: &Swept) -> String {
    let Swept { contender, points } = swept;
    let runs = points.len();
    let reached = points.iter().filter_map(|point| Some((point.error?, point.seconds)));
    match reached.min_by(|(left, _), (right, _)| left.total_cmp(right)) {
        Some((error, time)) => format!("{contender}: {runs} runs, down to {} in {}", metres(error), seconds(time)),
        None => format!("{contender}: {runs} runs, all of which diverged"),
    }
}
