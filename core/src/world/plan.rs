//! What a world needs, and so what a step of it can leave out.

use crate::Real;

/// How many of the springs have something.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Coverage {
    /// None of them.
    #[default]
    None,
    /// Some of them.
    Some,
    /// All of them.
    All,
}

/// What a world needs: worked out when it is prepared, so that a step does no more.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plan {
    /// Gravity is not 0.
    pub gravity: bool,
    /// Particles that springs pull at; the others are in free flight and need no force but gravity.
    pub attached: u32,
    /// All particles.
    pub particles: u32,
    /// The longest stretch of slots whose particles have one mass and are not held, from one to before another: steps do not
    /// read their masses.
    pub of_one_mass: (u32, u32),
    /// Particles that are pinned or kinematic.
    pub held: u32,
    /// All springs: without any, both force passes are left out.
    pub springs: u32,
    /// Springs between two held particles: they move nothing, and no step looks at them.
    pub idle: u32,
    /// Springs with damping: without any, the force passes read no velocities, but where a program is to be compact.
    pub damped: Coverage,
    /// Springs on diagonals: their particles are contiguous, so that whole vectors of them are stepped at once.
    pub on_diagonals: u32,
    /// The furthest that a spring reaches, in slots.
    pub span: u32,
    /// Particles that are kept in another order than that of their numbers, so that their springs reach less far. Nobody
    /// outside sees it.
    pub renumbered: u32,
    /// The furthest that a spring of theirs reaches, in slots.
    pub reach: u32,
    /// The furthest that a spring of theirs would reach by number.
    pub reach_by_number: u32,
    /// Stretches that those diagonals are cut into.
    pub pieces: u32,
    /// All planes: without any, nothing is tested for hits.
    pub planes: u32,
    /// Islands, the connected parts of the spring graph; held particles do not connect. Where none may sleep nobody
    /// counts them, and this is 0.
    pub islands: u32,
    /// Those of them that sleep.
    pub islands_asleep: u32,
    /// Their particles; no step touches them.
    pub asleep: u32,
    /// Their springs; no step touches them.
    pub springs_asleep: u32,
}

impl Default for Plan {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl Plan {
    /// Of a world without anything in it.
    pub(crate) const EMPTY: Self = Self {
        gravity: false,
        attached: 0,
        particles: 0,
        of_one_mass: (0, 0),
        held: 0,
        springs: 0,
        idle: 0,
        damped: Coverage::None,
        on_diagonals: 0,
        span: 0,
        renumbered: 0,
        reach: 0,
        reach_by_number: 0,
        pieces: 0,
        planes: 0,
        islands: 0,
        islands_asleep: 0,
        asleep: 0,
        springs_asleep: 0,
    };

    /// Particles in free flight: no spring pulls at them.
    #[must_use]
    pub fn free(&self) -> u32 {
        self.particles - self.attached
    }

    /// What is left of it without what sleeps.
    pub(crate) fn awake(&self) -> Self {
        Self {
            particles: self.particles - self.asleep,
            attached: self.attached - self.asleep,
            springs: self.springs - self.springs_asleep,
            asleep: 0,
            springs_asleep: 0,
            ..*self
        }
    }

    /// Springs that steps look at.
    #[must_use]
    pub fn live(&self) -> u32 {
        self.springs - self.springs_asleep - self.idle
    }

    /// The longest run of equal inverse masses that are not 0, from the first to after the last.
    pub(crate) fn of_one_mass<R: Real>(inverse_mass: &[R]) -> (u32, u32) {
        let (mut longest, mut start) = ((0, 0), 0);
        if cfg!(feature = "small") {
            // Every mass is read.
            return longest;
        }
        for run in inverse_mass.chunk_by(|left, right| left == right) {
            let end = start + run.len() as u32;
            if run.first().is_some_and(|inverse| *inverse != R::ZERO) && end - start > longest.1 - longest.0 {
                longest = (start, end);
            }
            start = end;
        }
        longest
    }

    /// How many of the springs are damped.
    pub(crate) fn coverage<R: Real>(damping: &[R]) -> Coverage {
        let damped = damping.iter().filter(|damping| **damping != R::ZERO).count();
        match damped {
            0 => Coverage::None,
            some if some < damping.len() => Coverage::Some,
            _ => Coverage::All,
        }
    }
}
