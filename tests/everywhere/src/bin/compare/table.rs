//! Who has which rows right.

use hooke_everywhere::Precision;

use crate::difference::first_difference;
use crate::machine::Machine;

/// So many of a machine's differences are looked into.
const EXPLAINED: usize = 3;

/// The rows of all machines, and what they should be.
pub struct Table<'a> {
    /// A column of answers each.
    pub machines: &'a [Machine],
    /// By machine, a line a row.
    pub answers: &'a [Vec<String>],
    /// A line a row.
    pub golden: &'a Vec<String>,
}

impl Table<'_> {
    /// Prints it, and returns whether all rows are right.
    pub fn tell(&self) -> bool {
        let width = self.machines.iter().map(|machine| machine.name.len()).max().unwrap_or(0);
        let titles: Vec<String> = Precision::ALL.iter().map(|precision| format!("{:>16}", precision.name())).collect();
        println!("{:width$}{}", "rows that are right", titles.concat(), width = width.max(20));
        let mut counts = (0, 0);
        let mut wrong = Vec::new();
        for (machine, answer) in self.machines.iter().zip(self.answers) {
            let mut cells = String::new();
            for precision in Precision::ALL {
                let of_it = |row: &(usize, &String)| row.1.split(' ').nth(2) == Some(precision.name());
                let rows = self.golden.iter().enumerate().filter(of_it);
                let (right, others): (Vec<_>, Vec<_>) =
                    rows.partition(|(number, row)| answer.get(*number) == Some(row));
                let all = right.len() + others.len();
                cells += &format!("{:>16}", format!("{}/{all}", right.len()));
                counts = (counts.0 + right.len(), counts.1 + others.len());
                wrong.extend(others.into_iter().map(|(number, _)| (machine, number)));
            }
            println!("{:width$}{cells}", machine.name, width = width.max(20));
            if answer.len() > self.golden.len() {
                println!("  and {} rows more than there should be", answer.len() - self.golden.len());
                counts.1 += answer.len() - self.golden.len();
            }
        }
        let refused = self.golden.iter().filter(|row| row.contains(" refused: ")).count();
        println!(
            "{} rows, {refused} of them refused, as the Nyström method is for worlds without damping",
            self.golden.len()
        );
        self.explain(&wrong);
        let (passed, failed) = counts;
        println!("{passed} passed, {failed} failed");
        failed == 0 && passed > 0
    }

    /// Looks into what is wrong: the first few rows of each machine.
    fn explain(&self, wrong: &[(&Machine, usize)]) {
        for machine in self.machines {
            let of_it = wrong.iter().filter(|(other, _)| std::ptr::eq(*other, machine));
            for (_, number) in of_it.take(EXPLAINED) {
                let row = self.golden.get(*number).map_or("", String::as_str);
                let name: Vec<&str> = row.splitn(5, ' ').take(4).collect();
                let name = name.join(" ");
                let right = self
                    .machines
                    .iter()
                    .zip(self.answers)
                    .find(|(_, answer)| answer.get(*number).is_some_and(|answer| answer == row));
                let told = match right {
                    Some((right, _)) => first_difference(&name, machine, right).unwrap_or_else(|error| error),
                    None => "no machine has the golden bits: what is computed has changed, on all of them".to_owned(),
                };
                println!("{}: {name}: {told}", machine.name);
            }
        }
    }
}
