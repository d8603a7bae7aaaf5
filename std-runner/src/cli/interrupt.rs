//! Ctrl-C, or being asked to terminate: once to end in order, twice to end at once.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};

use super::print;

/// 128 and the number of Ctrl-C's signal, as shells have it.
pub(super) const EXIT_CODE: u8 = 130;

static INTERRUPTED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

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
    #[cfg(unix)]
    if let Err(error) = watch_termination() {
        print::message(&format!("warning: SIGTERM will not be answered in order: {error}"));
    }
    &INTERRUPTED
}

/// The same for SIGTERM. A hang-up keeps its meaning: `nohup` is to make it nothing.
#[cfg(unix)]
fn watch_termination() -> std::io::Result<()> {
    use signal_hook::{consts::SIGTERM, flag};
    // In this order: the second time finds what the first has set.
    flag::register_conditional_shutdown(SIGTERM, EXIT_CODE.into(), Arc::clone(&INTERRUPTED))?;
    flag::register(SIGTERM, Arc::clone(&INTERRUPTED)).map(|_| ())
}
