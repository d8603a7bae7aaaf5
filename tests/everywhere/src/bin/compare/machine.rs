//! Something that steps rows, and can be asked.

use std::process::{Command, Stdio};
use std::thread;

use hooke_everywhere::Row;

/// A machine, or a way to use one.
pub struct Machine {
    /// What the table calls it.
    pub name: String,
    command: String,
    /// Only one row in so many is asked for: it is slow.
    every: usize,
}

/// Of a row that was asked for, its line.
pub type Answer = Option<String>;

impl Machine {
    /// Of a line: name, tab, one row in how many, tab, command.
    pub fn of(line: &str) -> Result<Self, String> {
        let mut fields = line.splitn(3, '\t');
        let (Some(name), Some(every), Some(command)) = (fields.next(), fields.next(), fields.next()) else {
            return Err(format!("{line}: not a name, one row in how many, and a command"));
        };
        let every =
            every.parse().ok().filter(|every| *every > 0).ok_or_else(|| format!("{line}: one row in {every}"))?;
        Ok(Self { name: name.to_owned(), command: command.to_owned(), every })
    }

    /// The lines of its rows.
    fn rows(&self) -> Result<Vec<Answer>, String> {
        if self.every == 1 {
            return Ok(self.ask("")?.into_iter().map(Some).collect());
        }
        let rows: Vec<Row> = Row::all().collect();
        let (first, second) = rows.split_at(rows.len() / 2 / self.every * self.every);
        let ask = |rows: &[Row]| -> Result<Vec<Answer>, String> {
            let one = |(number, row): (usize, &Row)| {
                if number % self.every != 0 {
                    return Ok(None);
                }
                let last = self.ask(&row.to_string())?.pop().unwrap_or_default();
                Ok(Some(format!("{row} {last}")))
            };
            rows.iter().enumerate().map(one).collect()
        };
        thread::scope(|scope| {
            let second = scope.spawn(|| ask(second));
            let first = ask(first)?;
            Ok([first, second.join().map_err(|_| "a thread has panicked".to_owned())??].concat())
        })
    }

    /// The lines that it answers to a question.
    pub fn ask(&self, question: &str) -> Result<Vec<String>, String> {
        let wrong = |what: &str| format!("{}: {what}", self.name);
        let output = Command::new("sh")
            .args(["-c", &format!("{} {question}", self.command)])
            .stdin(Stdio::null())
            .stderr(Stdio::inherit())
            .output()
            .map_err(|error| wrong(&error.to_string()))?;
        let text = String::from_utf8(output.stdout).map_err(|error| wrong(&error.to_string()))?;
        if !output.status.success() {
            let last = text.lines().last().unwrap_or_default();
            return Err(wrong(&format!("{}; the last it said is \"{last}\"", output.status)));
        }
        Ok(text.lines().map(str::to_owned).collect())
    }
}

/// The rows of all of them, which run at the same time.
pub fn ask_all(machines: &[Machine]) -> Result<Vec<Vec<Answer>>, String> {
    thread::scope(|scope| {
        let asked: Vec<_> = machines.iter().map(|machine| scope.spawn(|| machine.rows())).collect();
        let answers = asked.into_iter().map(|answer| answer.join().map_err(|_| "a thread has panicked".to_owned())?);
        answers.collect()
    })
}
