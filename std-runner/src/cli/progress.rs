//! How far a run is, on a terminal.

use std::cell::Cell;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::simulate::Progress;
use crate::units::seconds;

/// Between two looks at the bar.
const BETWEEN_DRAWINGS: Duration = Duration::from_millis(100);
/// The bar counts in this part of the duration.
const PARTS: f64 = 1e6;
/// At most so many steps pass between two looks at the clock.
const LONGEST_STRIDE: u32 = 4096;

/// A bar with the time that is left, or nothing.
pub(super) struct Bar {
    bar: Option<ProgressBar>,
    /// A step may take less time than a look at the clock: so many pass in between, as many as fit in a millisecond.
    stride: Cell<u32>,
    steps_left: Cell<u32>,
    looked: Cell<Instant>,
    drawn: Cell<Instant>,
}

impl Bar {
    pub(super) fn new(shown: bool) -> Self {
        let bar = shown.then(|| {
            let bar = ProgressBar::with_draw_target(Some(PARTS as u64), ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}  {eta} left");
            bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        });
        let now = Instant::now();
        Self { bar, stride: Cell::new(1), steps_left: Cell::new(0), looked: Cell::new(now), drawn: Cell::new(now) }
    }

    /// Takes it off the terminal.
    pub(super) fn clear(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

impl Progress for Bar {
    fn reached(&self, time: f64, duration: f64) {
        let Some(bar) = &self.bar else {
            return;
        };
        if self.steps_left.get() > 0 {
            self.steps_left.set(self.steps_left.get() - 1);
            return;
        }
        let now = Instant::now();
        let quick = now.duration_since(self.looked.get()) < Duration::from_millis(1);
        self.stride.set(if quick { (2 * self.stride.get()).min(LONGEST_STRIDE) } else { self.stride.get() / 2 });
        self.steps_left.set(self.stride.get());
        self.stride.set(self.stride.get().max(1));
        self.looked.set(now);
        if now.duration_since(self.drawn.get()) >= BETWEEN_DRAWINGS {
            self.drawn.set(now);
            bar.set_message(format!("{} of {}", seconds(time), seconds(duration)));
            bar.set_position((time / duration * PARTS) as u64);
        }
    }
}
