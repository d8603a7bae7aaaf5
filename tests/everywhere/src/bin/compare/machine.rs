//! Something that steps rows, and can be asked.

use std::process::{Command, Stdio};
use std::thread;

/// A machine, or a way to use one.
pub struct Machine {
    /// What the table calls it.
    pub name: String,
    command: String,
}

impl Machine {
    /// Of a line: name, tab, command.
    pub fn of(line: &str) -> Result<Self, String> {
        let (name, command) = line.split_once('\t').ok_or_else(|| format!("{line}: not a name and a command"))?;
        Ok(Self { name: name.to_owned(), command: command.to_owned() })
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
pub fn ask_all(machines: &[Machine]) -> Result<Vec<Vec<String>>, String> {
    thread::scope(|scope| {
        let asked: Vec<_> = machines.iter().map(|machine| scope.spawn(|| machine.ask(""))).collect();
        let answers = asked.into_iter().map(|answer| answer.join().map_err(|_| "a thread has panicked".to_owned())?);
        answers.collect()
    })
}
