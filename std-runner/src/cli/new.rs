//! `hooke new`: a scene to start from.

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::Outcome;
use super::arguments::NewArguments;
use super::failure::Failure;
use super::outputs::{check_place, is_standard_output};
use super::print;

pub(super) fn new(arguments: &NewArguments) -> Result<Outcome, Failure> {
    let starter = arguments.starter;
    let path = arguments.file.clone().unwrap_or_else(|| PathBuf::from(format!("{starter}.toml")));
    if is_standard_output(&path) {
        return print::data(starter.text());
    }
    let shown = path.display();
    if path.extension().is_none_or(|ending| ending != "toml") {
        let message = format!("{shown} does not end in .toml: starters are written as TOML");
        return Err(Failure::input(message, format!("call it {}", path.with_extension("toml").display())));
    }
    check_place(&path, "FILE")?;
    write(&path, starter.text(), arguments.force)?;
    let recording = path.with_extension("csv");
    print::message(&format!(
        "wrote {shown}; every line in it is explained. Next:\n  hooke check {shown}\n  hooke run {shown} --out {}",
        recording.display()
    ));
    Ok(Outcome::Done)
}

fn write(path: &Path, text: &str, replace: bool) -> Result<(), Failure> {
    let mut options = OpenOptions::new();
    options.write(true);
    if replace {
        options.create(true).truncate(true)
    } else {
        options.create_new(true)
    };
    let shown = path.display();
    let mut file = options.open(path).map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => {
            Failure::input(format!("{shown} exists already"), "choose another name, or replace it with --force")
        }
        _ => Failure::input(format!("{shown} cannot be written: {error}"), "choose another place"),
    })?;
    file.write_all(text.as_bytes())
        .map_err(|error| Failure::failed(format!("cannot write {shown}: {error}"), "make room there, and try again"))
}
