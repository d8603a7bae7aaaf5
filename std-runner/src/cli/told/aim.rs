//! What a scene that leaves its stepper and its time step open was stepped with, and why.

use crate::accuracy::{Aim, Aimed};
use crate::units::{metres, seconds};

/// What is told of it in the summary; nothing where nothing was open.
pub(super) fn aim(aim: &Aim) -> Option<[String; 2]> {
    let found = match aim {
        Aim::Found(aimed) if aimed.prefix > 0.0 => format!(
            "as the cheapest that keeps errors below {}, a thousandth of the scene's size, should they grow no faster than in \
             pilot runs of {}{}; --max-error follows them to the end",
            metres(aimed.error),
            seconds(aimed.prefix),
            rounding(aimed),
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

/// Where it may be more than what is aimed at.
fn rounding(aimed: &Aimed) -> String {
    if aimed.rounding <= aimed.error {
        return String::new();
    }
    format!(", but for rounding in {}, which may come to {}", aimed.settings.precision, metres(aimed.rounding))
}
