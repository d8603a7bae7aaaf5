//! What becomes of a small change, over time step, stiffness and damping.

use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use super::frequency::Frequency;
use super::frozen::Frozen;
use super::growth::{Trend, growth};
use super::noise::noise;
use crate::model::{Hold, Model, ModelSpring};
use crate::scene::{Settings, StepperName};
use crate::simulate::{AnyResponse, AnyStepper, BuildError, largest_stable_step, world};

/// What a cell may cost, in force evaluations times particles and springs; enough for [`LEAST`] of them in any case.
const WORK: f64 = 4e5;
/// Fewer do not tell what fades from what turns round.
const LEAST: f64 = 300.0;
/// The same of a whole map; it has the fewer cells, the larger the scene is.
const MAP: f64 = 2e9;
/// Columns and rows of a panel, at most and at least.
const COLUMNS: [f64; 2] = [96.0, 32.0];
/// Rows for a column.
const ROWS: f64 = 0.625;
/// Decades that time steps reach to both sides of the limit of the scene itself.
const DECADES: f64 = 2.0;
/// Decades that stiffness reaches to both sides of the scene's.
const STIFFNESS: f64 = 3.0;
/// Steps in which the scene itself may explode.
const STEPS: u64 = 400;
/// A spring so many times as long as the scene is large has exploded.
const FAR: f64 = 10.0;
/// How far particles are moved to give the scene itself something to amplify, relative to the length of springs.
const CHANGE: f64 = 1e-3;

/// What becomes of a small change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It fades.
    Damped,
    /// It stays as large as it is.
    Kept,
    /// It grows, and the scene itself stays bounded.
    Growing,
    /// It grows, and the scene itself explodes: a number is not finite, or a spring ten times as long as the scene is large.
    Exploded,
}

impl Fate {
    /// All, from the best on.
    pub const ALL: [Self; 4] = [Self::Damped, Self::Kept, Self::Growing, Self::Exploded];

    /// As legends have it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Damped => "damped",
            Self::Kept => "stable",
            Self::Growing => "growing",
            Self::Exploded => "exploded",
        }
    }
}

/// A stepper's panels, one for each damping.
#[derive(Clone, Debug)]
pub struct Map {
    /// Whose.
    pub stepper: StepperName,
    /// In the middle of each column, s.
    pub time_steps: Vec<f64>,
    /// In the middle of each row, times the scene's.
    pub stiffness: Vec<f64>,
    /// With little damping and with much.
    pub panels: Vec<Panel>,
}

/// One damping.
#[derive(Clone, Debug)]
pub struct Panel {
    /// What it is, as a person would say it.
    pub damping: String,
    /// Row by row.
    pub cells: Vec<Fate>,
    /// The bound of each row, s: infinite where nothing limits the stepper.
    pub bounds: Vec<f64>,
}

/// How damping is changed.
#[derive(Clone, Copy, Debug)]
enum Damping {
    /// So many times what it is.
    Times(f64),
    /// So much of what is critical at the highest frequency of the scene itself, times 2k/ω.
    Of(f64, f64),
}

impl Map {
    /// Of a scene; nothing if it was interrupted, or no spring pulls at a free particle. Tells how much is done, from 0 to 1.
    ///
    /// # Errors
    /// If the scene cannot be stepped.
    pub fn of(
        model: &Model,
        settings: &Settings,
        stepper: StepperName,
        interrupted: &AtomicBool,
        tell: impl Fn(f64),
    ) -> Result<Option<Self>, BuildError> {
        let Some(frequency) = Frequency::of(&Frozen::of(model))? else { return Ok(None) };
        let items = (model.particles.len() + model.springs.len()) as f64;
        let cost = 2.0 * WORK.max(LEAST * items);
        let columns = (MAP / cost / ROWS / 3.0).sqrt().clamp(COLUMNS[1], COLUMNS[0]) as usize;
        let time_steps = logarithmic(columns, (2.0 / frequency.highest).log10(), DECADES);
        let stiffness = logarithmic((ROWS * columns as f64) as usize, 0.0, STIFFNESS);
        let mut map = Self { stepper, time_steps, stiffness, panels: Vec::new() };
        let dampings = dampings(model, stepper, &frequency);
        for (number, damping) in dampings.iter().enumerate() {
            let Some(panel) = map.panel(model, settings, *damping, interrupted)? else { return Ok(None) };
            map.panels.push(panel);
            tell((number + 1) as f64 / dampings.len() as f64);
        }
        Ok(Some(map))
    }

    fn panel(
        &self,
        model: &Model,
        settings: &Settings,
        damping: Damping,
        interrupted: &AtomicBool,
    ) -> Result<Option<Panel>, BuildError> {
        let rows = self.stiffness.par_iter().map(|factor| {
            let scene = changed(model, *factor, damping);
            let bound = world::<f64>(&scene, [0.0; 3])?.view().stability();
            let bound = bound.map_or(f64::INFINITY, |bound| largest_stable_step(self.stepper, &bound));
            let frozen = Frozen::of(&scene);
            let highest = Frequency::of(&frozen)?.map_or(0.0, |frequency| frequency.highest);
            let cell = |dt: &f64| self.cell(&scene, settings, &frozen, highest, *dt, interrupted);
            let cells = self.time_steps.iter().map(cell).collect::<Result<Option<Vec<_>>, _>>()?;
            Ok(cells.map(|cells| (cells, bound)))
        });
        let rows = rows.collect::<Result<Option<Vec<_>>, BuildError>>()?;
        let Some(rows) = rows else { return Ok(None) };
        let (cells, bounds): (Vec<_>, Vec<_>) = rows.into_iter().unzip();
        Ok(Some(Panel { damping: damping.name(), cells: cells.concat(), bounds }))
    }

    fn cell(
        &self,
        scene: &Model,
        settings: &Settings,
        frozen: &Frozen,
        highest: f64,
        dt: f64,
        interrupted: &AtomicBool,
    ) -> Result<Option<Fate>, BuildError> {
        let work = WORK.max(LEAST * (scene.particles.len() + scene.springs.len()) as f64);
        let Some(growth) = growth(frozen, highest, self.stepper, dt, work, interrupted)? else { return Ok(None) };
        Ok(Some(match growth.trend {
            Trend::Damped => Fate::Damped,
            Trend::Kept => Fate::Kept,
            Trend::Growing if explodes(scene, settings, frozen.length, self.stepper, dt, interrupted)? => {
                Fate::Exploded
            }
            Trend::Growing => Fate::Growing,
        }))
    }
}

/// Whether the scene itself explodes, with gravity, planes and all.
fn explodes(
    scene: &Model,
    settings: &Settings,
    length: f64,
    stepper: StepperName,
    dt: f64,
    interrupted: &AtomicBool,
) -> Result<bool, BuildError> {
    let mut scene = scene.clone();
    for (number, particle) in (0..).zip(&mut scene.particles) {
        if particle.hold == Hold::Free {
            let by = noise(number);
            particle.position = [0, 1, 2].map(|axis| particle.position[axis] + CHANGE * length * by[axis]);
        }
    }
    let most = FAR * crate::stress::battery::size(&scene);
    let mut world = world::<f64>(&scene, settings.gravity)?;
    let mut stepper = AnyStepper::<f64>::named(stepper, settings.tolerance);
    let mut response = AnyResponse::<f64>::named(settings.collision);
    for step in 0..STEPS {
        if interrupted.load(Ordering::Relaxed) {
            break;
        }
        if world.step(stepper.any(), &mut response, dt).is_err() {
            return Ok(true);
        }
        if step % 8 == 7 && is_torn(&scene, &world, most) {
            return Ok(true);
        }
    }
    Ok(false)
}

fn is_torn(scene: &Model, world: &crate::simulate::HeapWorld<f64>, most: f64) -> bool {
    let place = |end: u32| world.position(end).unwrap_or_default();
    scene.springs.iter().any(|spring| place(spring.between[0]).distance(place(spring.between[1])) > most)
}

fn changed(model: &Model, factor: f64, damping: Damping) -> Model {
    let change = |spring: &ModelSpring| ModelSpring {
        stiffness: factor * spring.stiffness,
        damping: match damping {
            Damping::Times(times) => times * spring.damping,
            Damping::Of(part, rate) => part * rate * spring.stiffness,
        },
        ..*spring
    };
    Model { springs: model.springs.iter().map(change).collect(), ..model.clone() }
}

/// Of a scene that has none, some is made up.
fn dampings(model: &Model, stepper: StepperName, frequency: &Frequency) -> Vec<Damping> {
    if !stepper.knows_damping() {
        vec![Damping::Times(0.0)]
    } else if model.damped_springs() > 0 {
        [0.0, 1.0, 10.0].map(Damping::Times).to_vec()
    } else {
        [0.0, 0.1, 1.0].map(|part| Damping::Of(part, 2.0 / frequency.highest)).to_vec()
    }
}

impl Damping {
    fn name(self) -> String {
        match self {
            Self::Times(0.0) | Self::Of(0.0, _) => "undamped".to_owned(),
            Self::Times(1.0) => "damped as it is".to_owned(),
            Self::Times(times) => format!("damped {times} times as much"),
            Self::Of(part, _) => format!("damped by {part} of critical"),
        }
    }
}

/// Evenly spaced in their logarithms, so many decades to both sides of 10 to the power of `middle`.
fn logarithmic(count: usize, middle: f64, decades: f64) -> Vec<f64> {
    let place = |number: usize| 2.0 * (number as f64 + 0.5) / count as f64 - 1.0;
    (0..count).map(|number| 10.0_f64.powf(middle + decades * place(number))).collect()
}
