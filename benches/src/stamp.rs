//! What a figure was measured on.

use std::process::Command;

/// The machine and the versions, in a line.
#[must_use]
pub fn stamp() -> String {
    let processor = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = processor.lines().find_map(|line| line.strip_prefix("model name")).unwrap_or("\t: unknown processor");
    let model = model.trim_start_matches(['\t', ' ', ':']);
    let compiler = told("rustc", &["--version"]);
    let commit = told("git", &["describe", "--always", "--dirty"]);
    let lanes = hooke::Lanes::widest();
    format!("{model}; {lanes:?}; {compiler}; hooke {} at {commit}", env!("CARGO_PKG_VERSION"))
}

fn told(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).output();
    output.map_or_else(|_| "unknown".to_owned(), |output| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
