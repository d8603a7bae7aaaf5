//! How far a measurement is, on a terminal.

use std::io::{IsTerminal, stderr};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::terminal;
use crate::stress::News;

/// Between two turns of the sign that it goes on.
const TURN: Duration = Duration::from_millis(120);

/// A bar that counts cases, with a line above it for what is done; nothing where nobody looks.
pub(super) struct Told {
    bar: Option<ProgressBar>,
}

impl Told {
    pub(super) fn new(scene: &str) -> Self {
        let bar = stderr().is_terminal().then(|| {
            let bar = ProgressBar::with_draw_target(Some(1), ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{spinner} {prefix}  {bar:30} {pos}/{len}  {msg}");
            bar.enable_steady_tick(TURN);
            bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())).with_prefix(scene.to_owned())
        });
        Self { bar }
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
