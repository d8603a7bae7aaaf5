//! The maps of stability: what becomes of a small change over time step, stiffness and damping.

use crate::chart::{Axis, ChartError, Colour, Dash, Entry, INK, Look, Mosaic, Mosaics, Scale};
use crate::stress::{Fate, Map, Panel, Stressed};
use crate::units::{seconds, short};

/// All maps of some scenes, one below the other.
///
/// # Errors
/// If a map cannot be drawn.
pub fn stability_maps(all: &[Stressed]) -> Result<String, ChartError> {
    let of_scene = |stressed: &Stressed| mosaics(&stressed.name, &stressed.maps);
    let mosaics: Vec<Mosaic> = all.iter().flat_map(of_scene).collect();
    drawn(mosaics)
}

/// The maps of one scene.
pub(super) fn maps_of(stressed: &Stressed) -> Result<String, ChartError> {
    drawn(mosaics("", &stressed.maps))
}

fn drawn(mosaics: Vec<Mosaic>) -> Result<String, ChartError> {
    let columns = if mosaics.len().is_multiple_of(3) { 3 } else { 1 };
    Mosaics { mosaics, columns, legend: legend() }.svg()
}

fn mosaics(scene: &str, maps: &[Map]) -> Vec<Mosaic> {
    maps.iter().flat_map(|map| map.panels.iter().map(|panel| mosaic(scene, map, panel))).collect()
}

fn mosaic(scene: &str, map: &Map, panel: &Panel) -> Mosaic {
    let is_first = map.panels.first().is_some_and(|first| std::ptr::eq(first, panel));
    let whose = if scene.is_empty() { map.stepper.to_string() } else { format!("{scene}: {}", map.stepper) };
    Mosaic {
        heading: if is_first { whose } else { String::new() },
        title: panel.damping.clone(),
        x: Axis::new("time step", Scale::Logarithmic, seconds),
        y: Axis::new("stiffness, times the scene's", Scale::Logarithmic, short),
        columns: map.time_steps.clone(),
        rows: map.stiffness.clone(),
        cells: panel.cells.iter().map(|fate| colour(*fate)).collect(),
        curve: panel.bounds.iter().copied().zip(map.stiffness.iter().copied()).collect(),
    }
}

/// From light to dark as it gets worse, and from blue to red: told apart by people of all kinds of sight, and in grey.
fn colour(fate: Fate) -> Colour {
    match fate {
        Fate::Damped => plotters::style::RGBColor(0xA6, 0xCE, 0xE8),
        Fate::Kept => plotters::style::RGBColor(0xEE, 0xEF, 0xE6),
        Fate::Growing => plotters::style::RGBColor(0xF2, 0xA1, 0x3C),
        Fate::Exploded => plotters::style::RGBColor(0x9C, 0x17, 0x2B),
    }
}

fn legend() -> Vec<Entry> {
    let mut entries = vec![Entry::Heading("a small change is".to_owned())];
    entries.extend(Fate::ALL.map(|fate| Entry::Cell(colour(fate), fate.name().to_owned())));
    let look = Look { colour: INK, dash: Dash::Solid, shape: None, is_filled: false, is_thin: false };
    entries.push(Entry::Curve(look, "bound".to_owned()));
    entries
}
