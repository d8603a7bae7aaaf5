//! `hooke view`: a scene in the browser, while it is simulated.

use super::Outcome;
use super::arguments::ViewArguments;
use super::failure::Failure;
use super::interrupt;
use super::print;
use super::scene::{Loaded, not_measured, warn};
use super::told;
use crate::accuracy::leaves_open;
use crate::advice::{Subject, advise};
use crate::simulate::{RunError, Summary};
use crate::units::seconds;
use crate::view::{Kept, Server, Shown};

pub(super) fn view(arguments: &ViewArguments) -> Result<Outcome, Failure> {
    let mut texts = Kept::of(&arguments.scene);
    let loaded = Loaded::of(&arguments.scene, &arguments.overrides, &mut |asked, what| texts.read(asked, what))?;
    let start = loaded.start()?;
    let settings = loaded.scene.settings().clone();
    warn(&advise(&Subject { model: &loaded.model, settings: &settings, start: &start, recorded_bytes: 0 }));
    if settings.max_error.is_some() {
        print::message("warning: max_error is for `hooke run`: here the time step is chosen for stability");
    }
    if let Some(time_step) = start.time_step.filter(|_| leaves_open(&settings) && start.plan.attached > 0) {
        print::message(&format!(
            "stepper and time step are open: here it is auto in steps of {}; `hooke run` finds both by pilot runs",
            seconds(time_step)
        ));
    }
    let shown = Shown { model: loaded.model, settings, texts };
    let interrupted = interrupt::watch();
    let server = Server::listen(arguments.port, shown, tell, interrupted)
        .map_err(|error| Failure::failed(error.to_string(), "leave --port out for one that is free"))?;
    let page = format!("http://{}/", server.address());
    print::message(&format!("{page}\nCtrl-C ends it"));
    if !arguments.no_open
        && let Err(error) = open::that_detached(&page)
    {
        print::message(&format!("warning: no browser could be opened: {error}\n    help: open the address above"));
    }
    server.serve_until(interrupted);
    Ok(Outcome::Done)
}

/// Why a run that a page looks at did not go to its end.
fn tell(shown: &Shown, ran: &Result<Summary, RunError>) {
    let failure = match ran {
        Ok(summary) => told::outcome(&shown.model, &shown.settings, summary, false).err(),
        // The page has gone, or was loaded again.
        Err(RunError::Record { .. }) => None,
        Err(error) => Some(not_measured(error)),
    };
    if let Some(failure) = failure {
        // The server goes on: nobody asks for a code.
        let _ = failure.tell();
    }
}
