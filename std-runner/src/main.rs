//! The command line `hooke`.

use std::process::ExitCode;

use clap::Parser;
use hooke_runner::cli::{Arguments, Failure, set_up_messages};

fn main() -> ExitCode {
    set_up_messages();
    Arguments::parse().execute().map_or_else(Failure::tell, ExitCode::from)
}
