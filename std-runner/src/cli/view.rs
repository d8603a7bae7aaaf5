//! `hooke view`: a scene in the browser, while it is simulated.

use super::Outcome;
use super::arguments::ViewArguments;
use super::failure::Failure;
use super::interrupt;
use super::print;
use super::scene::{Loaded, warn};
use crate::advice::{Subject, advise};
use crate::view::{Server, Shown};

pub(super) fn view(arguments: &ViewArguments) -> Result<Outcome, Failure> {
    let loaded = Loaded::load(&arguments.scene, &arguments.overrides)?;
    let start = loaded.start()?;
    let settings = loaded.scene.settings().clone();
    warn(&advise(&Subject { model: &loaded.model, settings: &settings, start: &start, recorded_bytes: 0 }));
    if settings.max_error.is_some() {
        print::message("warning: max_error is for `hooke run`: here the time step is chosen for stability");
    }
    let shown = Shown::new(&arguments.scene, loaded.model, settings)?;
    let interrupted = interrupt::watch();
    let server = Server::listen(arguments.port, shown, interrupted)
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
