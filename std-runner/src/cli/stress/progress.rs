//! How far a measurement is, on a terminal.

use indicatif::ProgressBar;

use super::terminal;
use crate::cli::progress::counter;
use crate::stress::News;

/// A bar that counts cases, with a line above it for what is done; nothing where nobody looks.
pub(super) struct Told {
    bar: Option<ProgressBar>,
}

impl Told {
    pub(super) fn new(scene: &str) -> Self {
        Self { bar: counter(scene) }
    }

    pub(super) fn tell(&self, news: News<'_>) {
        let Some(bar) = &self.bar else { return };
        match news {
            News::Limits => bar.set_message("looking for the largest stable time steps"),
            News::Limit(limit) => bar.println(format!("  {}", terminal::limit(limit))),
            News::Map(stepper, part) => bar.set_message(format!("map of {stepper}, {:.0} %", 100.0 * part)),
            News::References => bar.set_message("making references"),
            News::Tried(tried, number, of) => {
                bar.set_length(of as u64);
                bar.set_position(number as u64);
                bar.set_message(tried.case.name.clone());
                bar.println(format!("  {}", terminal::case(tried)));
            }
        }
    }

    /// Takes it off the terminal.
    pub(super) fn clear(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
