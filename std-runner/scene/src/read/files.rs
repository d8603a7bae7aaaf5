//! Texts from files.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::sync::Arc;

use super::source::Unreadable;

/// No scene or mesh is longer than this, bytes: what is read on and on is none.
const LONGEST: u64 = 1 << 28;

/// The text of a file; `what` says what the file should be.
///
/// # Errors
/// If it cannot be read, is longer than any scene or mesh, or is no UTF-8.
pub fn text_of_file(path: &Path, what: &str) -> Result<Arc<str>, Unreadable> {
    let bytes = read(path).map_err(|error| {
        let remedy = match error.kind() {
            io::ErrorKind::NotFound => "check the spelling, and the folder it is looked for in",
            _ if path.is_dir() => "name a file, not a folder",
            io::ErrorKind::FileTooLarge => {
                "check that it is the file you mean; make large scenes of ropes, cloths, blocks and clouds"
            }
            _ => "check that the file may be read",
        };
        Unreadable { message: format!("cannot read {what} here: {error}"), remedy: remedy.to_owned() }
    })?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let offset = error.utf8_error().valid_up_to();
        let byte = error.as_bytes().get(offset).copied().unwrap_or_default();
        let message = format!("not UTF-8 text: byte {offset} is 0x{byte:02x}");
        Unreadable { message, remedy: format!("save it as UTF-8, if it is {what} at all") }
    })?;
    Ok(text.into())
}

fn read(path: &Path) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    let too_long = || io::Error::new(io::ErrorKind::FileTooLarge, format!("it is longer than {} MiB", LONGEST >> 20));
    // What a device or a pipe holds is only known once it has been read.
    let length = file.metadata()?.len();
    if length > LONGEST {
        return Err(too_long());
    }
    let mut bytes = Vec::with_capacity(length as usize);
    file.take(LONGEST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LONGEST { Err(too_long()) } else { Ok(bytes) }
}
