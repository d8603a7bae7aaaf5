//! The page of a measurement of stability.

use super::page::{Block, Page, Section};
use super::stability::maps_of;
use super::stress_told::{limit_rows, limits_in_words, verdict_rows, wanting_rows};
use crate::bench::machine;
use crate::chart::ChartError;
use crate::stress::Stressed;

/// What the map is.
const MAP: &str = "What becomes of a small change of the start, over time step and stiffness. \
                   Above and to the right of the line, steps are longer than the bound from the springs of each particle, \
                   which hooke check has. Where a change grows, the scene itself was run too: it exploded if a number became \
                   infinite or a spring ten times as long as the scene is large, within 400 steps. Stable is also what creeps back so slowly that \
                   the steps that were followed do not show it.";

/// All scenes, one section each, and the bodies beside them.
///
/// # Errors
/// If a map cannot be drawn.
pub fn stress_page(all: &[Stressed]) -> Result<Page, ChartError> {
    let names: Vec<&str> =
        all.iter().filter(|stressed| stressed.is_scene).map(|stressed| stressed.name.as_str()).collect();
    Ok(Page {
        title: format!("Numerical stability: {}", names.join(", ")),
        lead: "The largest time step at which each stepper is stable, what happens past it, and a battery of runs that are \
               hard on steppers, each judged by something that the stepper has no part in."
            .to_owned(),
        sections: all.iter().map(section).collect::<Result<_, _>>()?,
        made_by: format!("hooke {}, {}", env!("CARGO_PKG_VERSION"), machine()),
    })
}

fn section(stressed: &Stressed) -> Result<Section, ChartError> {
    let mut blocks = Vec::new();
    if stressed.interrupted {
        blocks.push(Block::Text("The measurement was interrupted: not all was tried.".to_owned()));
    }
    if let Some(limits) = &stressed.limits {
        blocks.push(Block::Heading("Largest stable time step".to_owned()));
        blocks.push(Block::Text(limits_in_words(limits)));
        blocks.push(Block::Table {
            rows: limit_rows(limits),
            caption: "Bound: from the springs of each particle. Theory: from the measured highest frequency and its \
                      damping. Found: by bisection, following a small change through thousands of steps."
                .to_owned(),
        });
    }
    if !stressed.maps.is_empty() {
        blocks.push(Block::Heading("Map".to_owned()));
        blocks.push(Block::Figure { svg: maps_of(stressed)?, caption: MAP.to_owned() });
    }
    blocks.push(Block::Heading("Battery".to_owned()));
    blocks.push(Block::Table { rows: verdict_rows(&stressed.tried), caption: "Runs by verdict.".to_owned() });
    let wanting = wanting_rows(&stressed.tried);
    if wanting.len() > 1 {
        let caption = "Every run that is neither exact nor accurate, nor known to be stable only, and why.".to_owned();
        blocks.push(Block::Table { rows: wanting, caption });
    }
    Ok(Section { heading: stressed.name.clone(), blocks })
}
