//! Ctrl-C: once to end in order, twice to end at once.

use std::sync::atomic::{AtomicBool, Ordering};

use super::print;

/// 128 and the number of the signal, as shells have it.
pub(super) const EXIT_CODE: u8 = 130;

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// Becomes true at the first Ctrl-C from now on.
pub(super) fn watch() -> &'static AtomicBool {
    let watched = ctrlc::set_handler(|| {
        if INTERRUPTED.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(EXIT_CODE));
        }
    });
    if let Err(error) = watched {
        print::message(&format!("warning: Ctrl-C will not be answered in order: {error}"));
    }
    &INTERRUPTED
}
