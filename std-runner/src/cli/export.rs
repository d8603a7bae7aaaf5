//! `hooke export`: a scene as source of a program.

use std::fs;

use super::Outcome;
use super::arguments::ExportArguments;
use super::failure::Failure;
use super::outputs::{check_place, is_standard_output};
use super::print;
use super::scene::Loaded;
use crate::accuracy::leaves_open;
use crate::export::firmware;
use crate::scene::{Precision, Settings, TimeStep};
use crate::simulate::Start;

pub(super) fn export(arguments: &ExportArguments) -> Result<Outcome, Failure> {
    let loaded = Loaded::load(&arguments.scene, &arguments.overrides)?;
    let (model, settings) = (&loaded.model, loaded.scene.settings());
    let start = loaded.start()?;
    let exported = match settings.precision {
        Precision::F64 => firmware::<f64>(model, settings, &start, "f64"),
        // What is stepped in neither is refused.
        Precision::F32 | Precision::F32Compensated => firmware::<f32>(model, settings, &start, "f32"),
    };
    let text = exported.map_err(|refused| {
        let message = format!("{} cannot be exported: {refused}", arguments.scene.display());
        Failure::input(message, refused.remedy)
    })?;
    if is_standard_output(&arguments.out) {
        print::message(&stepped(settings, &start));
        return print::data(text);
    }
    let shown = arguments.out.display();
    if arguments.out.extension().is_none_or(|ending| ending != "rs") {
        let message = format!("{shown} does not end in .rs: what is exported is Rust source");
        return Err(Failure::input(message, format!("call it {}", arguments.out.with_extension("rs").display())));
    }
    check_place(&arguments.out, "--out")?;
    fs::write(&arguments.out, text)
        .map_err(|error| Failure::failed(format!("cannot write {shown}: {error}"), "choose another place"))?;
    print::message(&format!("wrote {shown}: `mod` it beside a program that uses hooke"));
    print::message(&stepped(settings, &start));
    Ok(Outcome::Done)
}

/// What was written of the steps, and what `hooke run` has to be told to take the same. Of a scene that leaves its stepper and
/// its time step open, it looks for both by pilot runs, and what it finds may be other ones.
fn stepped(settings: &Settings, start: &Start) -> String {
    let (stepper, steps) = (settings.stepper, start.schedule.steps());
    let Some(time_step) = start.time_step else {
        return format!("stepper {stepper}, {steps} steps, from frame to frame: `hooke run` ends in the same bits");
    };
    let same = if settings.time_step == TimeStep::Auto {
        format!("`hooke run` ends in the same bits with --stepper {stepper} --time-step {time_step:?}")
    } else {
        "`hooke run` ends in the same bits".to_owned()
    };
    let and = if leaves_open(settings) { "; without them, it looks for better ones by pilot runs" } else { "" };
    format!("stepper {stepper}, {steps} steps of {time_step:?} s: {same}{and}")
}
