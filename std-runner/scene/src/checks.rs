//! The rules that numbers in a scene keep.

use super::error::Problem;

/// m, m/s or m/s²: beyond this the square of a distance would no longer be a number.
const FARTHEST: f64 = 1e150;

/// Refuses what is not finite and more than 0.
pub(super) fn positive(key: &str, value: f64, unit: &str) -> Result<(), Problem> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    let rule = "it must be finite and more than 0";
    Err(Problem::new(key, value, rule, format!("write a number of {unit} more than 0")))
}

/// Refuses what is not finite and 0 or more.
pub(super) fn not_negative(key: &str, value: f64, unit: &str) -> Result<(), Problem> {
    if value.is_finite() && value >= 0.0 {
        return Ok(());
    }
    let rule = "it must be finite and not negative";
    Err(Problem::new(key, value, rule, format!("write a number of {unit}, 0 or more")))
}

/// Refuses what is not a number from 0 to 1.
pub(super) fn fraction(key: &str, value: f64) -> Result<(), Problem> {
    if (0.0..=1.0).contains(&value) {
        return Ok(());
    }
    let remedy = "write 0 for no bounce, 1 for a bounce that loses nothing, or a number between";
    Err(Problem::new(key, value, "it must be from 0 to 1", remedy))
}

/// Refuses vectors whose length is no number.
pub(super) fn vector(key: &str, value: [f64; 3], unit: &str) -> Result<(), Problem> {
    if value.iter().all(|component| component.abs() <= FARTHEST) {
        return Ok(());
    }
    let rule = format!("every component must be finite, and at most {FARTHEST:e} either way");
    Err(Problem::new(key, value, rule, format!("write three finite numbers of {unit}")))
}

/// Refuses vectors that give no direction.
pub(super) fn direction(key: &str, value: [f64; 3]) -> Result<(), Problem> {
    vector(key, value, "any one unit")?;
    if value.iter().any(|&component| component != 0.0) {
        return Ok(());
    }
    let remedy = "write a direction such as [0.0, 0.0, 1.0]; it need not have length 1";
    Err(Problem::new(key, value, "it must have a direction", remedy))
}

/// Refuses fewer particles than a side needs.
pub(super) fn count(key: &str, value: u32, least: u32) -> Result<(), Problem> {
    if value >= least {
        return Ok(());
    }
    let remedy = format!("write a whole number, {least} or more");
    Err(Problem::new(key, value, format!("it must be at least {least}"), remedy))
}

/// Refuses a side with fewer than the two particles that a spring needs.
pub(super) fn sides<const DIMENSIONS: usize>(value: [u32; DIMENSIONS]) -> Result<(), Problem> {
    if value.iter().all(|&side| side >= 2) {
        return Ok(());
    }
    let remedy = format!("write {DIMENSIONS} whole numbers, each 2 or more");
    Err(Problem::new("particles", value, "every side must have at least 2", remedy))
}
