//! How far a run is, on a terminal.

use std::io::{IsTerminal, stderr};
use std::sync::{Mutex, PoisonError};
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

/// Between two turns of the sign that something goes on.
const TURN: Duration = Duration::from_millis(120);

/// A bar that counts the parts of a measurement of a scene; nothing where nobody looks.
pub(super) fn counter(scene: &str) -> Option<ProgressBar> {
    stderr().is_terminal().then(|| {
        let bar = ProgressBar::with_draw_target(Some(1), ProgressDrawTarget::stderr());
        let style = ProgressStyle::with_template("{spinner} {prefix}  {bar:30} {pos}/{len}  {msg}");
        bar.enable_steady_tick(TURN);
        bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())).with_prefix(scene.to_owned())
    })
}

/// A sign that something goes on, until it is dropped; nothing where nobody looks.
pub(super) struct Waiting(Option<ProgressBar>);

/// Says what is going on before there is a bar.
pub(super) fn waiting(what: &'static str) -> Waiting {
    Waiting(stderr().is_terminal().then(|| {
        let sign = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr()).with_message(what);
        sign.enable_steady_tick(TURN);
        sign
    }))
}

impl Drop for Waiting {
    fn drop(&mut self) {
        if let Some(sign) = &self.0 {
            sign.finish_and_clear();
        }
    }
}

/// A bar with the time that is left, or nothing.
pub(super) struct Bar {
    bar: Option<ProgressBar>,
    pace: Mutex<Pace>,
}

/// How often the bar is looked at.
struct Pace {
    /// A step may take less time than a look at the clock: so many pass in between, as many as fit in a millisecond.
    stride: u32,
    steps_left: u32,
    looked: Instant,
    drawn: Instant,
}

impl Bar {
    pub(super) fn new(shown: bool) -> Self {
        let bar = shown.then(|| {
            let bar = ProgressBar::with_draw_target(Some(PARTS as u64), ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}  {eta} left");
            bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        });
        let now = Instant::now();
        Self { bar, pace: Mutex::new(Pace { stride: 1, steps_left: 0, looked: now, drawn: now }) }
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
        let mut pace = self.pace.lock().unwrap_or_else(PoisonError::into_inner);
        if pace.steps_left > 0 {
            pace.steps_left -= 1;
            return;
        }
        let now = Instant::now();
        let quick = now.duration_since(pace.looked) < Duration::from_millis(1);
        pace.steps_left = if quick { (2 * pace.stride).min(LONGEST_STRIDE) } else { pace.stride / 2 };
        pace.stride = pace.steps_left.max(1);
        pace.looked = now;
        if now.duration_since(pace.drawn) >= BETWEEN_DRAWINGS {
            pace.drawn = now;
            bar.set_message(format!("{} of {}", seconds(time), seconds(duration)));
            bar.set_position((time / duration * PARTS) as u64);
        }
    }
}
