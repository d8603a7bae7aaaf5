//! What a scene that leaves its stepper and its time step open was stepped with, and why.

use crate::accuracy::Aim;
use crate::units::{metres, seconds};

/// What is told of it in the summary; nothing where nothing was open.
pub(super) fn aim(aim: &Aim) -> Option<[String; 2]> {
    let found = match aim {
        Aim::Found(aimed) if aimed.prefix > 0.0 => format!(
            "the cheapest steps that pilot runs of {} let expect errors below {} with, a thousandth of the scene's size; \
             --max-error keeps to one",
            seconds(aimed.prefix),
            metres(aimed.error)
        ),
        Aim::Found(aimed) => format!(
            "steps for errors below {}, a thousandth of the scene's size, without pilot runs: so few of them are over as \
             soon",
            metres(aimed.error)
        ),
        Aim::Lost => "a quarter of the largest stable time step: pilot runs left the finite numbers".to_owned(),
        Aim::Given | Aim::Interrupted => return None,
    };
    Some(["found".to_owned(), found])
}
