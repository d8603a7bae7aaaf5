//! A particle written out by itself.

use schemars::JsonSchema;
use serde::Deserialize;

use crate::model::{Hold, Model, ModelParticle, Track};

use super::checks;
use super::error::Problem;

/// One particle.
#[derive(Clone, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct Particle {
    /// Where it starts, m. Only a particle with keyframes may leave it out: it starts where they say.
    position: Option<[f64; 3]>,
    /// How it starts to move, m/s. A particle that is pinned or has keyframes has none of its own.
    #[serde(default)]
    velocity: [f64; 3],
    /// kg, more than 0.
    #[serde(default = "one_kilogram")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    mass: f64,
    /// Whether it stays where it is.
    #[serde(default)]
    pinned: bool,
    /// Rows of t, x, y, z (s and m), times increasing: it moves straight from each to the next, and rests before the
    /// first and after the last.
    keyframes: Option<Vec<[f64; 4]>>,
}

/// The mass of a particle that is given none.
pub(super) const fn one_kilogram() -> f64 {
    1.0
}

impl Particle {
    pub(super) fn check(&self) -> Result<(), Problem> {
        checks::vector("velocity", self.velocity, "m/s")?;
        checks::positive("mass", self.mass, "kg")?;
        if let Some(position) = self.position {
            checks::vector("position", position, "metres")?;
        }
        let Some(keyframes) = &self.keyframes else {
            if self.position.is_none() {
                let rule = "a particle without keyframes starts somewhere";
                return Err(Problem::absent("position", rule, "add position = [x, y, z], in metres"));
            }
            return self.check_still(self.pinned, "pinned");
        };
        if self.pinned {
            let rule = "a particle with keyframes follows them";
            return Err(Problem::new("pinned", true, rule, "keep either `pinned` or `keyframes`"));
        }
        self.check_still(true, "on keyframes")?;
        check_keyframes(keyframes)?;
        self.check_start(keyframes)
    }

    /// Refuses a velocity that would be ignored.
    fn check_still(&self, held: bool, how: &str) -> Result<(), Problem> {
        if !held || self.velocity == [0.0; 3] {
            return Ok(());
        }
        let rule = format!("a particle that is {how} does not choose how it moves");
        Err(Problem::new("velocity", self.velocity, rule, "take the velocity away, or let the particle go"))
    }

    /// Refuses a position that the keyframes contradict.
    fn check_start(&self, keyframes: &[[f64; 4]]) -> Result<(), Problem> {
        let (start, _) = at_time_zero(keyframes);
        let Some(position) = self.position else {
            return Ok(());
        };
        // Room for the rounding of a start that lies between two keys.
        let near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-9 * a.abs().max(b.abs()).max(1e-3);
        if position.iter().zip(&start).all(near) {
            return Ok(());
        }
        let rule = format!("the keyframes have it at {start:?} at time 0");
        Err(Problem::new("position", position, rule, "leave the position out, or make the two agree"))
    }

    pub(super) fn expand(&self, model: &mut Model) {
        let (position, velocity, hold) = match &self.keyframes {
            Some(keyframes) => {
                let (position, velocity) = at_time_zero(keyframes);
                let number = model.tracks.len() as u32;
                let keys = keyframes.iter().map(|&[time, x, y, z]| (time, [x, y, z])).collect();
                model.tracks.push(Track { keys });
                (position, velocity, Hold::Track(number))
            }
            None if self.pinned => (self.position.unwrap_or_default(), [0.0; 3], Hold::Pinned),
            None => (self.position.unwrap_or_default(), self.velocity, Hold::Free),
        };
        model.particles.push(ModelParticle { position, velocity, mass: self.mass, hold });
    }
}

fn check_keyframes(keyframes: &[[f64; 4]]) -> Result<(), Problem> {
    if keyframes.is_empty() {
        let remedy = "write rows of t, x, y, z, such as [[0.0, 0.0, 0.0, 2.0]]";
        return Err(Problem::new("keyframes", keyframes, "it must have a row", remedy));
    }
    for (number, row) in keyframes.iter().enumerate() {
        let [time, x, y, z] = *row;
        let problem = |rule: &str, remedy: &str| Problem::item("keyframes", number, row, rule, remedy);
        if !time.is_finite() || checks::vector("keyframes", [x, y, z], "metres").is_err() {
            return Err(problem(
                "t, x, y and z must be finite",
                "write four finite numbers: t in s, then x, y, z in m",
            ));
        }
        let earlier = number.checked_sub(1).and_then(|previous| keyframes.get(previous));
        if earlier.is_some_and(|earlier| earlier[0] >= time) {
            return Err(problem(
                "its time must be later than the row before it",
                "put the rows in order of time, one to a time",
            ));
        }
    }
    Ok(())
}

/// Where the track is at the start, and how fast it goes there.
fn at_time_zero(keyframes: &[[f64; 4]]) -> ([f64; 3], [f64; 3]) {
    let place = |row: &[f64; 4]| [row[1], row[2], row[3]];
    let later = keyframes.partition_point(|row| row[0] <= 0.0);
    let before = later.checked_sub(1).and_then(|index| keyframes.get(index));
    match (before, keyframes.get(later)) {
        (Some(from), Some(to)) => {
            let span = to[0] - from[0];
            let velocity = [1, 2, 3].map(|axis| (to[axis] - from[axis]) / span);
            let position = [0, 1, 2].map(|axis| from[axis + 1] - from[0] * velocity[axis]);
            (position, velocity)
        }
        (Some(only), None) | (None, Some(only)) => (place(only), [0.0; 3]),
        (None, None) => Default::default(),
    }
}
