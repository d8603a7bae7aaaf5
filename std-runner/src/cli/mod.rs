//! The command line: what is asked, checked, done and told.

mod arguments;
mod bench;
mod check;
mod export;
mod failure;
mod figures;
mod format;
mod interrupt;
mod new;
mod outputs;
mod print;
mod progress;
mod run;
mod scene;
mod stress;
mod table;
mod told;
mod view;
mod within;

use std::process::ExitCode;

use clap::CommandFactory;

pub use arguments::Arguments;
use arguments::Verb;
pub use failure::{Failure, set_up_messages};

/// What a command that did not fail has to say to who called it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It did what was asked.
    Done,
    /// It was interrupted, and left things in order.
    Interrupted,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Done => Self::SUCCESS,
            Outcome::Interrupted => Self::from(interrupt::EXIT_CODE),
        }
    }
}

impl Arguments {
    /// Does what is asked.
    ///
    /// # Errors
    /// If the input is wrong, or what was asked failed.
    pub fn execute(self) -> Result<Outcome, Failure> {
        match self.verb {
            Verb::Run(run) => run::run(&run),
            Verb::Check(check) => check::check(&check),
            Verb::Bench(bench) => bench::bench(&bench),
            Verb::Stress(stress) => stress::stress(&stress),
            Verb::View(view) => view::view(&view),
            Verb::Export(export) => export::export(&export),
            Verb::New(new) => new::new(&new),
            Verb::Schema => print::data(crate::scene::schema() + "\n"),
            Verb::Completions { shell } => {
                let mut script = Vec::new();
                clap_complete::generate(shell, &mut Self::command(), "hooke", &mut script);
                print::data(script)
            }
        }
    }
}
