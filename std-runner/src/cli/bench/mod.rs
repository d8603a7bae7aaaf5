//! `hooke bench`: run time against error.

mod figures;
mod progress;
mod told;

use std::path::Path;

use super::Outcome;
use super::arguments::BenchArguments;
use super::failure::Failure;
use super::figures::Outputs;
use super::interrupt;
use super::print;
use super::scene::{Loaded, longest, not_measured};
use crate::bench::{Bench, Compared, Course, Kept, PEERS_RUN, Peer, Stamp, bench as measure, kept, peers};
use crate::units::{count, counted};
use progress::Told;

pub(super) fn bench(arguments: &BenchArguments) -> Result<Outcome, Failure> {
    // All of them first: nobody waits for an hour to learn that the last one is wrong.
    let load = |path| Loaded::load(path, &arguments.overrides);
    let scenes = arguments.scenes.iter().map(|path| load(path)).collect::<Result<Vec<_>, _>>()?;
    let outputs = Outputs::check(&arguments.out, &arguments.scenes)?;
    let longest = longest(arguments.longest)?;
    // Peers say how far they are off at the end.
    let compared = if arguments.against.is_some() { Compared::AtEnd } else { Compared::Throughout };
    let resumed = |scene| resumed(arguments.resume.as_deref(), scene, compared);
    let earlier = scenes.iter().map(resumed).collect::<Result<Vec<_>, _>>()?;
    let paths = arguments.scenes.iter().zip(&scenes);
    let rivals =
        paths.map(|(path, scene)| against(arguments.against.as_deref(), path, scene)).collect::<Result<Vec<_>, _>>()?;
    let interrupted = interrupt::watch();
    let mut benches: Vec<Bench> = Vec::new();
    for ((loaded, kept), peers) in scenes.iter().zip(&earlier).zip(rivals) {
        let course = Course {
            model: &loaded.model,
            settings: loaded.scene.settings(),
            compared,
            longest,
            kept,
            is_traced: outputs.has_page(),
            interrupted,
        };
        let told = Told::new(&course.settings.name);
        let measured = measure(&course, |news| told.tell(news));
        told.clear();
        let Some(mut measured) = measured.map_err(|error| not_measured(&error))? else {
            return Ok(Outcome::Interrupted);
        };
        measured.peers = peers;
        outputs.tell(&told::report(&measured))?;
        let is_interrupted = measured.interrupted;
        benches.push(measured);
        // After each scene, so that what is done is safe.
        outputs.write(benches.as_slice())?;
        if is_interrupted {
            break;
        }
    }
    outputs.write_to_standard_output(benches.as_slice())?;
    let is_whole = benches.len() == scenes.len() && benches.iter().all(|bench| !bench.interrupted);
    Ok(if is_whole { Outcome::Done } else { Outcome::Interrupted })
}

/// What an earlier measurement of a scene has left to use.
fn resumed(file: Option<&Path>, loaded: &Loaded, compared: Compared) -> Result<Kept, Failure> {
    let Some(file) = file else { return Ok(Kept::default()) };
    let settings = loaded.scene.settings();
    let (kept, others) = kept(file, Stamp::of(&loaded.model, settings, compared)).map_err(|error| {
        let message = format!("--resume {}: {error}", file.display());
        Failure::input(message, "name a table that hooke bench has written: --out FILE.csv")
    })?;
    let used = counted(kept.count() as u64, "run");
    let rest = match others {
        0 => String::new(),
        others => format!("; {} are of another scene, program or machine", count(others as u64)),
    };
    print::message(&format!("{}: {used} of {} still hold{rest}", settings.name, file.display()));
    Ok(kept)
}

/// Who else ran a scene: of the name that its file has.
fn against(file: Option<&Path>, scene: &Path, loaded: &Loaded) -> Result<Vec<Peer>, Failure> {
    let Some(file) = file else { return Ok(Vec::new()) };
    let name = scene.file_stem().unwrap_or_default().to_string_lossy();
    let found = peers(file, &name).map_err(|error| {
        let message = format!("--against {}: {error}", file.display());
        Failure::input(message, "name a table that benches/peers/run has written, such as benches/results/peers.csv")
    })?;
    if found.is_empty() {
        print::message(&format!("warning: {} has no errors of a scene {name}", file.display()));
        return Ok(found);
    }
    let duration = loaded.scene.settings().duration;
    if duration != PEERS_RUN {
        let message =
            format!("--against {}: peers ran {name} for {PEERS_RUN} s, and this is for {duration} s", file.display());
        return Err(Failure::input(message, format!("use --duration {PEERS_RUN}")));
    }
    Ok(found)
}
