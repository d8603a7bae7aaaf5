//! The digests that the programs for microcontrollers have to tell: `few` or `many`.

use std::process::ExitCode;

use hooke::StepError;
use hooke_firmware_scenes::{Balls, Exported, Few, Many, Tell, bouncing, exported, few, many};

/// Lines on standard output.
struct Lines;

impl Tell for Lines {
    fn tell(&mut self, scene: &str, stepper: &str, digest: Result<u64, StepError>) {
        match digest {
            Ok(digest) => println!("{scene}, {stepper}: {digest:016x}"),
            Err(error) => println!("{scene}, {stepper}: {error}"),
        }
    }
}

fn main() -> ExitCode {
    match std::env::args().nth(1).as_deref() {
        Some("few") => {
            few(&mut Box::new(Few::EMPTY), &mut Lines);
            bouncing(&mut Box::new(Balls::new()), &mut Lines);
        }
        Some("many") => {
            many(&mut Box::new(Many::EMPTY), &mut Lines);
            exported(&mut Box::new(Exported::EMPTY), &mut Lines);
        }
        _ => {
            eprintln!("say which digests: few or many");
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}
