//! `hooke stress`: numerical stability.

mod figures;
mod progress;
mod table;
mod terminal;

use super::Outcome;
use super::arguments::StressArguments;
use super::failure::Failure;
use super::figures::Outputs;
use super::interrupt;
use super::scene::{Loaded, longest, not_measured};
use crate::scene::Overrides;
use crate::stress::battery::Effort;
use crate::stress::{Ask, Stressed, stress_bodies, stress_scene};
use progress::Told;

/// By how many times more `--thorough` looks.
const THOROUGH: f64 = 100.0;

pub(super) fn stress(arguments: &StressArguments) -> Result<Outcome, Failure> {
    let load = |path| Loaded::load(path, &Overrides::default());
    let scenes = arguments.scenes.iter().map(|path| load(path)).collect::<Result<Vec<_>, _>>()?;
    let outputs = Outputs::check(&arguments.out, &arguments.scenes)?;
    let ask = Ask { only: arguments.stepper.clone(), effort: effort(arguments)?, maps: outputs.has_pictures() };
    let interrupted = interrupt::watch();
    let mut all: Vec<Stressed> = Vec::new();
    for loaded in &scenes {
        let settings = loaded.scene.settings();
        let told = Told::new(&settings.name);
        let stressed = stress_scene(&loaded.model, settings, &ask, interrupted, |news| told.tell(news));
        told.clear();
        let stressed = stressed.map_err(|error| not_measured(&error))?;
        outputs.tell(&terminal::scene(&loaded.model, &stressed))?;
        all.push(stressed);
        // After each scene, so that what is done is safe.
        outputs.write(all.as_slice())?;
        if all.iter().any(|stressed| stressed.interrupted) {
            break;
        }
    }
    if all.iter().all(|stressed| !stressed.interrupted) {
        let told = Told::new("bodies");
        let stressed = stress_bodies(&ask, interrupted, |news| told.tell(news));
        told.clear();
        outputs.tell(&terminal::bodies(&stressed))?;
        all.push(stressed);
        outputs.write(all.as_slice())?;
    }
    outputs.write_to_standard_output(all.as_slice())?;
    ended(&all)
}

fn ended(all: &[Stressed]) -> Result<Outcome, Failure> {
    if all.iter().any(Stressed::has_defect) {
        let message = "a run of the battery went wrong in silence: the lines that say DEFECT tell which";
        return Err(Failure::failed(message.to_owned(), "this is a defect of Hooke: tell its authors"));
    }
    Ok(if all.iter().any(|stressed| stressed.interrupted) { Outcome::Interrupted } else { Outcome::Done })
}

fn effort(arguments: &StressArguments) -> Result<Effort, Failure> {
    let usual = if arguments.thorough { 120.0 } else { 2.0 };
    let longest = longest(arguments.longest.unwrap_or(usual))?;
    Ok(Effort { longest, steps: if arguments.thorough { THOROUGH } else { 1.0 } })
}
