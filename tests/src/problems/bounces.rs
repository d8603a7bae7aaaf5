//! The bookkeeping that bouncing problems share: when a particle arrives at its plane, how fast, and what follows.

use super::{FAINTEST, Impact};

/// One arrival at the plane.
#[derive(Clone, Copy, Debug)]
struct Arrival {
    /// s
    time: f64,
    /// Downwards, m/s.
    speed: f64,
}

/// All arrivals of one particle at one plane.
#[derive(Clone, Debug)]
pub(super) struct Bounces {
    restitution: f64,
    arrivals: Vec<Arrival>,
    /// When it comes to rest, if ever, s.
    rest: Option<f64>,
}

/// What a particle is doing.
pub(super) enum Phase {
    /// It has not met the plane yet.
    Approach,
    /// It left the plane `since` seconds ago at `speed` m/s upwards.
    Flight { since: f64, speed: f64 },
    /// It lies on the plane.
    Rest,
}

impl Bounces {
    /// Arrivals up to `duration` in s: the first at `time` with `speed`, then e times as fast after each `flight(speed after)`.
    ///
    /// `rests` says whether the flights shrink with the speed so that endlessly many end in a finite time.
    pub fn new(
        restitution: f64,
        [time, speed]: [f64; 2],
        duration: f64,
        rests: bool,
        flight: impl Fn(f64) -> f64,
    ) -> Self {
        let mut next = Arrival { time, speed };
        let mut arrivals = Vec::new();
        while next.time <= duration && next.speed > FAINTEST * speed {
            arrivals.push(next);
            next.speed *= restitution;
            next.time += flight(next.speed);
        }
        let mut rest = None;
        if rests && restitution < 1.0 {
            // Flights shrink by e or so each time: what is left of them soon no longer changes the sum.
            loop {
                next.speed *= restitution;
                let later = next.time + flight(next.speed);
                if later <= next.time {
                    break;
                }
                next.time = later;
            }
            rest = Some(next.time);
        }
        Self { restitution, arrivals, rest }
    }

    /// When it comes to rest, s.
    pub fn rest(&self) -> Option<f64> {
        self.rest
    }

    /// What the particle does at `time` in s.
    pub fn phase(&self, time: f64) -> Phase {
        if self.rest.is_some_and(|rest| time >= rest) {
            return Phase::Rest;
        }
        let before = self.arrivals.partition_point(|arrival| arrival.time <= time);
        match before.checked_sub(1).map(|last| self.arrivals[last]) {
            None => Phase::Approach,
            Some(arrival) => Phase::Flight { since: time - arrival.time, speed: self.restitution * arrival.speed },
        }
    }

    /// The same for a scene's list, of a particle with `mass` in kg at plane 0.
    pub fn impacts(&self, particle: usize, mass: f64) -> Vec<Impact> {
        let kept = self.restitution * self.restitution;
        let impacts = self.arrivals.iter().map(|arrival| Impact {
            time: arrival.time,
            particle,
            plane: 0,
            speed: arrival.speed,
            energy_lost: 0.5 * mass * (1.0 - kept) * arrival.speed * arrival.speed,
        });
        impacts.collect()
    }
}
