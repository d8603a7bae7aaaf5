//! `hooke run` where an accuracy is asked for.

use std::io::{IsTerminal, stderr};

use super::Outcome;
use super::arguments::RunArguments;
use super::failure::Failure;
use super::format::Recording;
use super::outputs::Outputs;
use super::print;
use super::progress::Bar;
use super::run::{options, stopped};
use super::scene::{Loaded, warn};
use super::told;
use crate::accuracy::{Begin, Within, run};
use crate::advice::{Subject, Topic, advise};
use crate::model::Model;
use crate::record::{BoxedRecorder, RecordError, Sample};
use crate::scene::{MaxError, Settings};
use crate::simulate::Start;

pub(super) fn run_within(
    loaded: &Loaded,
    asked: &MaxError,
    outputs: &Outputs,
    arguments: &RunArguments,
) -> Result<Outcome, Failure> {
    if outputs.to_standard_output() {
        let message = "a run to an accuracy may have to begin anew, and what is on standard output stays there";
        return Err(Failure::input(message.to_owned(), "record to a file: --out FILE.csv"));
    }
    let (model, settings) = (&loaded.model, loaded.scene.settings());
    let progress = Bar::new(stderr().is_terminal());
    let ran = run(model, settings, asked, &Files { model, outputs }, &options(arguments, &progress));
    progress.clear();
    match ran {
        Ok(Some(Within { settings, summary, attained })) => {
            let files = outputs.names();
            print::message(&told::summary(&settings, &summary, Some(&attained), &files));
            print::digest(summary.digest)?;
            let outcome = told::outcome(model, &settings, &summary, !files.is_empty())?;
            told::held(&settings, &attained, outcome)
        }
        // Before there was anything to tell of.
        Ok(None) => Ok(Outcome::Interrupted),
        Err(error) => stopped(error, settings, outputs),
    }
}

/// Where it is recorded to.
struct Files<'a> {
    model: &'a Model,
    outputs: &'a Outputs,
}

impl Begin for Files<'_> {
    fn begin<S: Sample>(&self, start: &Start, settings: &Settings) -> Result<Vec<BoxedRecorder<S>>, RecordError> {
        let recording = Recording { model: self.model, settings, start };
        let recorded_bytes = self.outputs.bytes(recording, S::SIZE);
        let advice = advise(&Subject { model: self.model, settings, start, recorded_bytes });
        // Time steps and precisions are not what was asked for here.
        let kept = |topic: Topic| matches!(topic, Topic::BeyondPlane | Topic::LargeRecordings);
        warn(&advice.into_iter().filter(|advice| kept(advice.topic)).collect::<Vec<_>>());
        self.outputs.open::<S>(recording)
    }
}
