//! Standard output for data that was asked for, standard error for everything else.

use std::io::{ErrorKind, Write, stderr, stdout};

use super::Outcome;
use super::failure::Failure;
use super::outputs::STANDARD_OUTPUT;

/// Data, as it is. A reader who has seen enough and closes the pipe is no error.
pub(super) fn data(bytes: impl AsRef<[u8]>) -> Result<Outcome, Failure> {
    let mut out = stdout().lock();
    match out.write_all(bytes.as_ref()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let message = format!("cannot write {STANDARD_OUTPUT}: {error}");
            Err(Failure::failed(message, "make room there, or write to another place"))
        }
        _ => Ok(Outcome::Done),
    }
}

/// The digest of a state on a line of its own, if it was asked for.
pub(super) fn digest(digest: Option<u64>) -> Result<Outcome, Failure> {
    digest.map_or(Ok(Outcome::Done), |digest| data(format!("{digest:016x}\n")))
}

/// A message for the person. Where standard error is closed there is nobody to read it.
pub(super) fn message(text: &str) {
    let _ = writeln!(stderr(), "{text}");
}
