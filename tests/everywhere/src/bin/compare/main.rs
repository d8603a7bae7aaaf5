//! Compares the rows of machines with the golden ones: `compare GOLDEN [mint]`, with a line for each machine on standard input,
//! its name, a tab, and a command that takes the question as its last words.
//!
//! A row that differs is stepped again on both sides, to name the step, the particle and the component that differ first.

mod difference;
mod machine;
mod table;

use std::fs;
use std::io::stdin;
use std::process::ExitCode;

use machine::Machine;
use table::Table;

fn main() -> ExitCode {
    match compare() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(2)
        }
    }
}

/// Whether all is well.
fn compare() -> Result<bool, String> {
    let mut arguments = std::env::args().skip(1);
    let golden = arguments.next().ok_or("compare GOLDEN [mint], with the machines on standard input")?;
    let mints = arguments.next().is_some_and(|word| word == "mint");
    let machines = stdin()
        .lines()
        .map(|line| line.map_err(|error| error.to_string()).and_then(|line| Machine::of(&line)))
        .collect::<Result<Vec<_>, _>>()?;
    let answers = machine::ask_all(&machines)?;
    if !mints {
        let text = fs::read_to_string(&golden).map_err(|error| format!("{golden}: {error}"))?;
        let rows = text.lines().map(str::to_owned).collect();
        return Ok(Table { machines: &machines, answers: &answers, golden: &rows }.tell());
    }
    let first = answers.first().ok_or("there is no machine to mint on")?;
    let agree = Table { machines: &machines, answers: &answers, golden: first }.tell();
    if agree {
        fs::write(&golden, first.join("\n") + "\n").map_err(|error| format!("{golden}: {error}"))?;
        println!("minted {golden}");
    } else {
        println!("nothing is minted while machines differ");
    }
    Ok(agree)
}
