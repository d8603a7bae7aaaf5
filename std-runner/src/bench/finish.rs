//! Everybody runs once more, and whoever may win several times, in turns: what slows the machine for a while slows them all.

use super::Course;
use super::point::{Point, time_again};
use super::reference::Reference;
use super::sweep::Swept;
use super::winners::{fastest, levels};
use crate::simulate::RunError;

/// Runs that take up to so many times as long as the winner may win.
const NEAR: f64 = 2.0;
/// Rounds that are run again: in the first by all, in the others by those that may win.
const ROUNDS: u32 = 6;

/// Lowers times, those of the likely winners above all; whether it came to its end. What was kept of an earlier measurement
/// stays as it was.
pub(super) fn finish(course: &Course<'_>, reference: &Reference, swept: &mut [Swept]) -> Result<bool, RunError> {
    for round in 0..ROUNDS {
        let aims = aims(reference, swept);
        for swept in swept.iter_mut() {
            let (contender, settings) = (swept.contender, swept.contender.settings(course.settings));
            for point in &mut swept.points {
                let is_near = |(error, seconds): &(f64, f64)| reaches(point, *error) && point.seconds <= NEAR * seconds;
                let has_ended = point.error.is_some();
                let runs = has_ended && (round == 0 || aims.iter().any(is_near));
                if !runs || course.kept.find(contender, point.asked).is_some() {
                    continue;
                }
                match time_again(course.model, &settings, point.asked, course.interrupted)? {
                    Some(seconds) => point.seconds = point.seconds.min(seconds),
                    None => return Ok(false),
                }
            }
        }
    }
    Ok(true)
}

/// Each error that winners are sought for, m, with what it costs, s.
fn aims(reference: &Reference, swept: &[Swept]) -> Vec<(f64, f64)> {
    let costs = levels(reference).map(|error| Some((error, fastest(swept, error)?.1.seconds)));
    costs.flatten().collect()
}

fn reaches(point: &Point, error: f64) -> bool {
    point.error.is_some_and(|reached| reached <= error)
}
