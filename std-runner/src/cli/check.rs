//! `hooke check`: a scene explained.

use hooke::{Choice, Coverage, StabilityBound};

use super::Outcome;
use super::arguments::CheckArguments;
use super::failure::Failure;
use super::print;
use super::scene::{Loaded, warning};
use super::table::rows;
use crate::accuracy::{aimed_at, leaves_open};
use crate::advice::{Subject, advise, limit_in_words, needed, skipped};
use crate::model::{Hold, Model};
use crate::scene::{Settings, StepperName, TimeStep};
use crate::simulate::{Start, choose_time_step, chooses_steps, largest_stable_step};
use crate::units::{bytes, count, counted, metres, seconds};

pub(super) fn check(arguments: &CheckArguments) -> Result<Outcome, Failure> {
    let loaded = Loaded::load(&arguments.scene, &arguments.overrides)?;
    let start = loaded.start()?;
    let settings = loaded.scene.settings();
    let mut lines = vec![settings.name.clone()];
    lines.extend(rows(&facts(&loaded, &start), 2));
    list("each step computes", &needed(&start.plan), &mut lines);
    list("left out", &skipped(&start.plan), &mut lines);
    if let Some(bound) = &start.bound {
        lines.push(String::new());
        lines.push("largest stable time step, at the start".to_owned());
        lines.extend(rows(&steppers(&loaded.model, settings, &start, bound), 2));
    }
    let advice = advise(&Subject { model: &loaded.model, settings, start: &start, recorded_bytes: 0 });
    for advice in &advice {
        lines.push(String::new());
        lines.push(warning(advice));
    }
    if advice.is_empty() {
        lines.push(String::new());
        lines.push("nothing to warn of".to_owned());
    }
    print::data(lines.join("\n") + "\n")
}

fn list(title: &str, items: &[String], lines: &mut Vec<String>) {
    if items.is_empty() {
        return;
    }
    lines.push(String::new());
    lines.push(title.to_owned());
    lines.extend(items.iter().map(|item| format!("  {item}")));
}

fn facts(loaded: &Loaded, start: &Start) -> Vec<[String; 2]> {
    let Loaded { model, scene } = loaded;
    let settings = scene.settings();
    let held = |is: fn(&Hold) -> bool| model.particles.iter().filter(|particle| is(&particle.hold)).count() as u64;
    let pinned = held(|hold| *hold == Hold::Pinned);
    let kinematic = held(|hold| matches!(hold, Hold::Track(_)));
    let mut kinds: Vec<String> = [(pinned, "pinned"), (kinematic, "kinematic")]
        .iter()
        .filter(|(number, _)| *number > 0)
        .map(|(number, kind)| format!("{} {kind}", count(*number)))
        .collect();
    if start.plan.free() > 0 {
        kinds.push(format!("{} that no spring pulls at", count(u64::from(start.plan.free()))));
    }
    let kinds = if kinds.is_empty() { String::new() } else { format!(": {}", kinds.join(", ")) };
    let row = |name: &str, value: String| [name.to_owned(), value];
    let mut rows = vec![
        row("particles", format!("{}{kinds}", count(model.particles.len() as u64))),
        row("springs", count(model.springs.len() as u64)),
        row("planes", count(model.planes.len() as u64)),
        row("memory", format!("about {}", bytes(scene.bytes_needed()))),
        row("method", format!("{}, {}, {}", settings.stepper, settings.precision, settings.collision)),
        row("sleep", sleep(settings, start)),
        row("steps", steps(settings, start, model)),
        row("frames", format!("{}, {} a second", count(start.schedule.frames()), settings.frame_rate)),
    ];
    rows.extend(start.linear_solver.map(|solver| row("linear solver", solver.to_string())));
    rows
}

fn sleep(settings: &Settings, start: &Start) -> String {
    let Some(speed) = settings.sleep_speed else {
        return "nothing does; sleep_speed lets what rests be left out".to_owned();
    };
    let islands = counted(start.plan.islands.into(), "island");
    format!("{islands}: what is slower than {speed:?} m/s for a second is left out until something moves it")
}

fn steps(settings: &Settings, start: &Start, model: &Model) -> String {
    let (number, duration) = (start.schedule.steps(), seconds(settings.duration));
    if let Some(asked) = settings.max_error {
        let free = if asked.stepper.is_some() { "" } else { "stepper, " };
        let precision = if asked.precision.is_some() { "" } else { "precision and " };
        return format!(
            "{free}{precision}time step are found by pilot runs for an error of {} at most",
            metres(asked.error)
        );
    }
    if leaves_open(settings) && start.plan.attached > 0 {
        let error = metres(aimed_at(model));
        return format!(
            "stepper and time step are found by pilot runs that aim at errors of {error}, a thousandth of its size"
        );
    }
    if chooses_steps(settings) && start.plan.attached > 0 {
        let Settings { stepper, tolerance, .. } = settings;
        let error = metres(tolerance * model.size());
        return format!("chosen by {stepper} to a tolerance of {tolerance:e}: errors of {error} in each at most");
    }
    let Some(time_step) = start.time_step else {
        return format!("{} for {duration}, from frame to frame: particles fly exactly", count(number));
    };
    let chosen = if settings.time_step == TimeStep::Auto { " (chosen)" } else { "" };
    let last =
        start.schedule.short_step().map_or_else(String::new, |short| format!("; the last is {}", seconds(short)));
    format!("{} of {}{chosen} for {duration}{last}", count(number), seconds(time_step))
}

fn steppers(model: &Model, settings: &Settings, start: &Start, bound: &StabilityBound) -> Vec<[String; 3]> {
    let limit = limit_in_words(model, bound);
    let row = |stepper: &StepperName| {
        let step = largest_stable_step(*stepper, bound);
        let (step, why) = match stepper {
            StepperName::ExplicitEuler if step <= 0.0 => {
                ("none".to_owned(), "it adds energy to undamped springs at any step".to_owned())
            }
            StepperName::ExplicitEuler => (
                format!("below {}", seconds(step)),
                "from the least damping over stiffness; motion across springs still grows".to_owned(),
            ),
            StepperName::SemiImplicitEuler | StepperName::VelocityVerlet => (seconds(step), limit.clone()),
            StepperName::DormandPrinceRkn8 if start.plan.damped != Coverage::None => {
                ("none".to_owned(), "it is for scenes without damping".to_owned())
            }
            StepperName::Rk4 | StepperName::BlanesMoanS6 | StepperName::Dop853 | StepperName::DormandPrinceRkn8 => {
                (seconds(step), "from the highest frequency and the fastest damping of any particle".to_owned())
            }
            StepperName::ImplicitEuler | StepperName::ImplicitEulerLinearised => {
                ("any".to_owned(), "the longer the step, the more motion it damps".to_owned())
            }
            StepperName::ImplicitMidpoint => {
                ("any".to_owned(), "what is too fast for the step is not damped".to_owned())
            }
            StepperName::TrBdf2 => ("any".to_owned(), "it damps what is too fast for the step".to_owned()),
            StepperName::Auto => return None,
        };
        Some([stepper.to_string(), step, why])
    };
    let mut table: Vec<[String; 3]> = StepperName::ALL.iter().filter_map(row).collect();
    let auto = Settings { stepper: StepperName::Auto, ..settings.clone() };
    if let Some(time_step) = choose_time_step(&auto, &start.plan, Some(bound)) {
        table.push(["auto".to_owned(), "any".to_owned(), format!("here {}", Choice::of(Some(*bound), time_step))]);
    }
    table
}
