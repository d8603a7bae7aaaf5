//! What can be asked.

use std::num::NonZeroU32;
use std::path::PathBuf;

use crate::scene::{Overrides, Starter, StepperName};

const EXAMPLES: &str = "\
Examples:
  hooke new rope                              write rope.toml, a scene to start from
  hooke check rope.toml                       what it needs, and which time steps are stable
  hooke run rope.toml --out rope.gif          simulate it, and see it move
  hooke run rope.toml --out - | head          the same, to standard output

Units are SI: metres, seconds, kilograms, newtons.
Exit codes: 0 done, 1 the simulation failed, 2 the input is wrong, 130 interrupted.";

const RUN_EXAMPLES: &str = "\
Examples:
  hooke run cloth.toml                                    only the summary
  hooke run cloth.toml --out cloth.npz                    for numpy.load
  hooke run cloth.toml --out cloth.csv --out cloth.npz    both
  hooke run cloth.toml --out - --frame-rate 10            CSV to standard output
  hooke run cloth.toml --digest                           one number for the last state, to compare machines
  hooke run cloth.toml --stepper velocity-verlet --time-step 1e-4 --precision f64
  hooke run cloth.toml --max-error 1e-4 --out cloth.npz   no particle farther than 0.1 mm from where it should be

With --max-error pilot runs over the beginning find what is likely the cheapest stepper, precision and time step, in place of
the scene's; flags beside it are kept to. A second run beside the first, in longer steps, tells how far off it is; where that
is too much, both go back and on in shorter steps, or begin anew. The summary tells the error, or until when it holds.

CSV has a row for each particle of each frame: frame,time,particle,x,y,z,vx,vy,vz (s, m, m/s).
NPZ has the arrays time (F), position (F, P, 3), velocity (F, P, 3), springs (S, 2).

Ctrl-C or SIGTERM ends the run after the step it is at and leaves every recording readable; a second one ends it at once.
Exit codes: 0 done, 1 the simulation failed, 2 the input is wrong, 130 interrupted.";

const CHECK_EXAMPLES: &str = "\
Examples:
  hooke check rope.toml
  hooke check rope.toml --stepper explicit-euler --time-step 1e-3

Warnings do not change the exit code: 0 if the scene can be run, 2 if it is wrong.";

const EXPORT_EXAMPLES: &str = "\
Examples:
  hooke export rope.toml --firmware --out src/rope.rs             a module for a program that uses the crate hooke
  hooke export rope.toml --firmware --out - --precision f32       to standard output

The module holds the particles, springs and planes of the scene in its precision, in the shortest text that reads back to
the same bits, its gravity, stepper and collision form, and the length and end of every step. A world that is filled and
stepped as it says ends with the digest that `hooke run SCENE --digest` tells. Keyframes, max_error, steps that the stepper
chooses itself, and f32-compensated are refused.

Exit codes: 0 done, 1 the file could not be written, 2 the input is wrong.";

const BENCH_EXAMPLES: &str = "\
Examples:
  hooke bench cloth.toml                                    which stepper is fastest for each error
  hooke bench cloth.toml rope.toml --out bench.html         a page to show, with diagrams
  hooke bench cloth.toml --out cloth.svg --out cloth.csv    the work-precision diagram, and a row for each run
  hooke bench cloth.toml --duration 0.2                     over a shorter time
  hooke bench cloth.toml --out runs.csv --resume runs.csv   go on where it was interrupted
  hooke bench benches/scenes/cloth-32.toml --against benches/results/peers.csv --out peers.svg

Every stepper runs each scene in every precision, and with every form of collision where there are planes, with time steps
from 0.9 of its stability bound down to where shorter ones gain nothing. The error is the largest distance of any particle,
at sixteen times, from DOP853 in f64 with so many steps that more change nothing, confirmed by another method. Times are of one
thread, the shortest of up to 20 runs, without recording. At the end all run once more, in turns, and those that may win six times.

CSV has a row for each run: its errors in position (m), velocity (m/s), energy (J), time of bounces (s), depth in planes (m);
the part of the duration that it survived; seconds, force evaluations, Newton iterations, iterations of linear solvers and
factorisations, and bytes of workspace. A run that diverged has no errors.

Ctrl-C ends it, and what was measured by then is told and written; a second one ends it at once. --resume takes from a table
the runs of the same scene, program and machine: its stamp says which.
Exit codes: 0 done, 1 the measurement failed, 2 the input is wrong, 130 interrupted.";

const STRESS_EXAMPLES: &str = "\
Examples:
  hooke stress cloth.toml                            the largest stable time steps, and the battery
  hooke stress cloth.toml --out cloth.html           and a page with the map of stability
  hooke stress *.toml --out all.csv --out map.svg    every figure, and the maps alone
  hooke stress cloth.toml --stepper velocity-verlet  one stepper

The largest stable time step is found by bisection: a small change of the start is followed through thousands of steps, with
gravity and planes left out, and buckling, which is no fault of a stepper. Beside it stand the bound from each particle's
springs, which `hooke check` has, and what theory makes of the measured highest frequency and its damping.

The map shows what becomes of such a change over time step, stiffness and damping, and where the scene itself explodes.

The battery makes the scene, and bodies with a known motion, hard to step: stiffness and mass ratios up to 1e9, springs
without length, time steps from 1e-9 to 10 s, a million metres from the origin, endless bounces, numbers next to 0. Every run
is judged against something that the stepper has no part in: a closed form, an invariance, or DOP853 in f64.

Ctrl-C ends it; what has been measured is told.
Exit codes: 0 done, 1 a run went wrong in silence, which is a defect of Hooke, 2 the input is wrong, 130 interrupted.";

const VIEW_EXAMPLES: &str = "\
Examples:
  hooke view cloth.toml                                 in the browser, as it is simulated
  hooke view cloth.toml --stepper explicit-euler        with flags, as `hooke run` has them
  hooke view cloth.toml --no-open --port 8080           for a browser that you open yourself

The page shows the run of this program, frame by frame, as it is made; beside it, or in its place, the page steps the scene
itself, by any stepper, with the same bits. Only browsers of this machine are answered. Ctrl-C ends it.
Exit codes: 0 ended, 1 the port is taken, 2 the input is wrong.";

const NEW_EXAMPLES: &str = "\
Examples:
  hooke new cloth                 writes cloth.toml
  hooke new cloth curtain.toml    writes curtain.toml
  hooke new cloth - | less        shows it";

/// Physics-based animation: particles joined by springs, stepped and recorded.
#[derive(Clone, Debug, clap::Parser)]
#[command(name = "hooke", version, after_help = EXAMPLES, max_term_width = 110)]
pub struct Arguments {
    #[command(subcommand)]
    pub(super) verb: Verb,
}

#[derive(Clone, Debug, clap::Subcommand)]
pub(super) enum Verb {
    /// Simulate a scene and record its frames.
    #[command(after_help = RUN_EXAMPLES)]
    Run(RunArguments),
    /// Explain a scene: what it needs, what can be skipped, which time steps are stable, what will go wrong.
    #[command(after_help = CHECK_EXAMPLES)]
    Check(CheckArguments),
    /// Measure every stepper on a scene: run time against error.
    #[command(after_help = BENCH_EXAMPLES)]
    Bench(BenchArguments),
    /// Measure numerical stability: largest stable time steps, what happens past them, and a battery of hard cases.
    #[command(after_help = STRESS_EXAMPLES)]
    Stress(StressArguments),
    /// See a scene move in the browser, while it is simulated.
    #[command(after_help = VIEW_EXAMPLES)]
    View(ViewArguments),
    /// Write a scene as source of a program that steps it elsewhere.
    #[command(after_help = EXPORT_EXAMPLES)]
    Export(ExportArguments),
    /// Write a scene to start from.
    #[command(after_help = NEW_EXAMPLES)]
    New(NewArguments),
    /// Print the JSON Schema of scene files, for editors.
    Schema,
    /// Print the completions of this command line for a shell.
    Completions {
        /// Which shell.
        shell: clap_complete::Shell,
    },
}

#[derive(Clone, Debug, clap::Args)]
pub(super) struct RunArguments {
    /// The scene file, TOML or JSON.
    pub(super) scene: PathBuf,
    /// Where to record to; the ending says how: .gif, .png (one a frame, numbered), .csv or .npz. Repeat it for more than one; - is CSV to standard output.
    /// Without it nothing is recorded.
    #[arg(short, long, value_name = "FILE")]
    pub(super) out: Vec<PathBuf>,
    /// Threads that share the work of each step; the bits are the same with any number. Default: as many as the machine has where the scene is large enough to gain.
    #[arg(long, value_name = "N")]
    pub(super) threads: Option<NonZeroU32>,
    /// Print a digest of the last state, 16 hexadecimal digits, to standard output: the same wherever the bits are the same.
    #[arg(long)]
    pub(super) digest: bool,
    /// Do not keep the energy ledger, which costs two passes over the springs a step.
    #[arg(long)]
    pub(super) no_ledger: bool,
    #[command(flatten, next_help_heading = "In place of what the scene says")]
    pub(super) overrides: Overrides,
}

#[derive(Clone, Debug, clap::Args)]
pub(super) struct CheckArguments {
    /// The scene file, TOML or JSON.
    pub(super) scene: PathBuf,
    #[command(flatten, next_help_heading = "In place of what the scene says")]
    pub(super) overrides: Overrides,
}

#[derive(Clone, Debug, clap::Args)]
pub(super) struct BenchArguments {
    /// The scene files, TOML or JSON.
    #[arg(required = true, value_name = "SCENE")]
    pub(super) scenes: Vec<PathBuf>,
    /// Where to write to; the ending says what: .csv a row for each run, .svg the work-precision diagram, .html a page with everything. Repeat it for more than one; - is CSV to standard output.
    #[arg(short, long, value_name = "FILE")]
    pub(super) out: Vec<PathBuf>,
    /// A table of an earlier measurement: its runs are not made again, as far as they are of the same scene, program and machine.
    #[arg(long, value_name = "FILE.csv")]
    pub(super) resume: Option<PathBuf>,
    /// A table of other engines and solvers, as benches/peers/run writes it: those that ran a scene of the same file name are put on its axes. Errors are then those at the end, as theirs are.
    #[arg(long, value_name = "FILE.csv")]
    pub(super) against: Option<PathBuf>,
    /// The first run of a stepper that takes longer is its last.
    #[arg(long, value_name = "SECONDS", default_value_t = 0.5)]
    pub(super) longest: f64,
    #[command(flatten, next_help_heading = "In place of what the scene says")]
    pub(super) overrides: Overrides,
}

#[derive(Clone, Debug, clap::Args)]
pub(super) struct StressArguments {
    /// The scene files, TOML or JSON.
    #[arg(required = true, value_name = "SCENE")]
    pub(super) scenes: Vec<PathBuf>,
    /// Where to write to; the ending says what: .csv (all figures), .svg (the map) or .html (all on one page). Repeat it for more than one; - is CSV to standard output.
    #[arg(short, long, value_name = "FILE")]
    pub(super) out: Vec<PathBuf>,
    /// Only this stepper; repeat it for more than one. Default: all, and semi-implicit-euler on the map.
    #[arg(long, value_name = "NAME")]
    pub(super) stepper: Vec<StepperName>,
    /// A run of the battery that takes longer is ended. Default: 2, or 120 with --thorough.
    #[arg(long, value_name = "SECONDS")]
    pub(super) longest: Option<f64>,
    /// Take 100 times as many steps in the battery's runs of a scene, and up to 10 million where drift is looked for. This takes hours.
    #[arg(long)]
    pub(super) thorough: bool,
}

#[derive(Clone, Debug, clap::Args)]
pub(super) struct ViewArguments {
    /// The scene file, TOML or JSON.
    pub(super) scene: PathBuf,
    /// The port to serve the page on, of this machine alone. Default: one that is free.
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    pub(super) port: u16,
    /// Do not open the browser; the address is printed.
    #[arg(long)]
    pub(super) no_open: bool,
    #[command(flatten, next_help_heading = "In place of what the scene says")]
    pub(super) overrides: Overrides,
}

#[derive(Clone, Debug, clap::Args)]
pub(super) struct ExportArguments {
    /// The scene file, TOML or JSON.
    pub(super) scene: PathBuf,
    /// Rust source for a program without files and heap: constants, and functions that make a world of them.
    #[arg(long, required = true)]
    pub(super) firmware: bool,
    /// Where to write to, a file that ends in .rs; - is standard output.
    #[arg(short, long, value_name = "FILE")]
    pub(super) out: PathBuf,
    #[command(flatten, next_help_heading = "In place of what the scene says")]
    pub(super) overrides: Overrides,
}

#[derive(Clone, Debug, clap::Args)]
pub(super) struct NewArguments {
    /// Which one.
    pub(super) starter: Starter,
    /// Where to write it; - is standard output. Default: the starter's name, in this folder.
    pub(super) file: Option<PathBuf>,
    /// Replace the file if it exists.
    #[arg(long)]
    pub(super) force: bool,
}
