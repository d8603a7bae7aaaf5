//! `hooke run`: a scene simulated and recorded.

use std::io::{ErrorKind, IsTerminal, stderr, stdout};
use std::num::NonZeroU32;

use hooke::Compensated;

use super::Outcome;
use super::arguments::RunArguments;
use super::failure::Failure;
use super::format::Recording;
use super::interrupt;
use super::outputs::Outputs;
use super::print;
use super::progress::Bar;
use super::scene::{Loaded, endless, out_of_range, warn};
use super::told;
use super::within;
use crate::advice::{Subject, advise};
use crate::record::Element;
use crate::scene::{Precision, Settings};
use crate::simulate::{Options, RunError, Start, Stepped, run as simulate};
use crate::units::counted;

pub(super) fn run(arguments: &RunArguments) -> Result<Outcome, Failure> {
    let loaded = Loaded::load(&arguments.scene, &arguments.overrides)?;
    let outputs = Outputs::check(&arguments.out, &arguments.scene)?;
    if arguments.digest && outputs.to_standard_output() {
        let message = "--digest and --out - both print to standard output";
        return Err(Failure::input(message.to_owned(), "record to a file: --out FILE.csv"));
    }
    if let Some(asked) = loaded.scene.settings().max_error {
        return within::run_within(&loaded, &asked, &outputs, arguments);
    }
    match loaded.scene.settings().precision {
        Precision::F32 => run_in::<f32>(&loaded, &outputs, arguments),
        Precision::F32Compensated => run_in::<Compensated>(&loaded, &outputs, arguments),
        Precision::F64 => run_in::<f64>(&loaded, &outputs, arguments),
    }
}

fn run_in<R: Stepped>(loaded: &Loaded, outputs: &Outputs, arguments: &RunArguments) -> Result<Outcome, Failure> {
    let (model, settings) = (&loaded.model, loaded.scene.settings());
    let begin = |start: &Start| {
        let recording = Recording { model, settings, start };
        let recorded_bytes = outputs.bytes(recording, R::Coordinate::SIZE);
        warn(&advise(&Subject { model, settings, start, recorded_bytes }));
        outputs.open::<R::Coordinate>(recording)
    };
    // Rows that scroll past and a bar that stays do not go together.
    let rows_on_terminal = outputs.to_standard_output() && stdout().is_terminal();
    let progress = Bar::new(stderr().is_terminal() && !rows_on_terminal);
    let options = options(arguments, &progress);
    let ran = simulate::<R>(model, settings, begin, &options);
    progress.clear();
    match ran {
        Ok(summary) => {
            let files = outputs.names();
            print::message(&told::summary(settings, &summary, None, &files));
            print::digest(summary.digest)?;
            told::outcome(model, settings, &summary, !files.is_empty())
        }
        Err(error) => stopped(error, settings, outputs),
    }
}

pub(super) fn options<'a>(arguments: &RunArguments, progress: &'a Bar) -> Options<'a> {
    Options {
        ledger: !arguments.no_ledger,
        digest: arguments.digest,
        threads: arguments.threads.map(NonZeroU32::get),
        interrupted: interrupt::watch(),
        progress,
    }
}

pub(super) fn stopped(error: RunError, settings: &Settings, outputs: &Outputs) -> Result<Outcome, Failure> {
    match error {
        RunError::Build(error) => Err(out_of_range(&error)),
        RunError::Endless(start) => Err(endless(settings, &start)),
        RunError::Begin(error) => Err(Failure::input(error.to_string(), "choose another place to record to")),
        RunError::Threads(_) => Err(Failure::failed(error.to_string(), "ask for fewer: --threads 1")),
        RunError::Thread(_) => Err(Failure::failed(error.to_string(), "end other programs, or run it without --out")),
        // Who reads the rows has seen enough.
        RunError::Record { error, .. }
            if outputs.only_to_standard_output() && error.source.kind() == ErrorKind::BrokenPipe =>
        {
            Ok(Outcome::Done)
        }
        RunError::Record { error, frames } => {
            let readable = match frames {
                0 => "no frame was recorded".to_owned(),
                frames => format!("what was recorded before can be read: {}", counted(frames, "frame")),
            };
            let message = format!("{error}; {readable}");
            Err(Failure::failed(message, "make room there, record fewer frames (--frame-rate), or record elsewhere"))
        }
    }
}
