//! How a command fails: a message for the person, a code for the caller.

use std::io::{IsTerminal, Write, stderr};
use std::process::ExitCode;

use miette::{Diagnostic, MietteHandlerOpts, Report};

use crate::scene::SceneError;

/// Why a command was not carried out.
#[derive(Debug)]
pub struct Failure {
    code: u8,
    report: Report,
}

#[derive(Debug, thiserror::Error, Diagnostic)]
#[error("{message}")]
struct Told {
    message: String,
    #[help]
    remedy: String,
}

impl Failure {
    /// What was asked cannot be done; nothing was begun.
    pub(super) fn input(message: String, remedy: impl Into<String>) -> Self {
        Self { code: 2, report: Told { message, remedy: remedy.into() }.into() }
    }

    /// What was asked was begun, and did not come to its end.
    pub(super) fn failed(message: String, remedy: impl Into<String>) -> Self {
        Self { code: 1, report: Told { message, remedy: remedy.into() }.into() }
    }

    /// Tells the person, on standard error, and gives the caller the code.
    #[must_use]
    pub fn tell(self) -> ExitCode {
        // Where standard error is closed there is nobody to tell, and the code still says it.
        let _ = writeln!(stderr(), "{:?}", self.report);
        ExitCode::from(self.code)
    }
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        Self { code: 2, report: error.into() }
    }
}

/// Errors with colours and frames on a terminal; elsewhere plain, with every line whole, so that they can be searched.
pub fn set_up_messages() {
    if stderr().is_terminal() {
        return;
    }
    // It can only be set once: if it is set already, messages look as whoever did that wants.
    let _ = miette::set_hook(Box::new(|_| {
        Box::new(MietteHandlerOpts::new().color(false).unicode(false).terminal_links(false).wrap_lines(false).build())
    }));
}
