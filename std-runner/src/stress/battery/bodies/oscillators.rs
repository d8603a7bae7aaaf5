//! A mass on a spring from a pin, along no axis; and two masses on one.

use super::Body;
use crate::model::{Hold, Model, ModelParticle, ModelSpring};
use crate::stress::battery::case::{Case, Group, Known, whole};

/// Where springs lie.
const ALONG: [f64; 3] = [0.6, 0.0, 0.8];
/// Steps where drift is looked for, by default.
const DRIFT: f64 = 1e5;

/// Of 1 kg, unless it is said otherwise.
#[derive(Clone, Copy, Debug)]
struct Oscillator {
    /// rad/s
    omega: f64,
    zeta: f64,
    /// m
    rest_length: f64,
    /// From the rest length at the start, m.
    away: f64,
    /// m/s
    speed: f64,
    /// Of the pin, m.
    at: [f64; 3],
    /// All lengths are multiplied by it.
    scale: f64,
    /// kg
    mass: f64,
}

impl Default for Oscillator {
    /// About one swing a second, but so that no whole number of seconds is one of swings.
    fn default() -> Self {
        Self { omega: 6.1, zeta: 0.0, rest_length: 1.0, away: 0.1, speed: 0.2, at: [0.0; 3], scale: 1.0, mass: 1.0 }
    }
}

/// At time steps, stiffnesses, dampings, lengths and places of all kinds.
pub fn oscillators(effort: f64) -> Vec<Case> {
    let plain = Oscillator::default();
    let mut cases = Vec::new();
    for (exponent, steps) in [(-9, 1000), (-6, 1000), (-4, 20_000), (-3, 2000), (-2, 200), (-1, 20), (0, 20), (1, 20)] {
        for zeta in [0.0, 0.1, 10.0] {
            let name = format!("damped by {zeta} of critical, steps of 1e{exponent} s");
            let duration = f64::from(steps) * 10.0_f64.powi(exponent);
            cases.push(Oscillator { zeta, ..plain }.case(Group::TimeStep, &name, duration, steps as u64));
        }
    }
    for exponent in [3, 6, 9] {
        // k is the square of it.
        let omega = plain.omega * 10.0_f64.powf(0.5 * f64::from(exponent));
        let stiff = Oscillator { omega, speed: 0.0, zeta: 0.01, ..plain };
        cases.push(stiff.case(Group::Stiffness, &format!("k = 3.7e{} N/m, steps of 1 ms", exponent + 1), 1.0, 1000));
        let heavy = two_bodies(10.0_f64.powi(exponent), format!("two bodies, 1 to 1e{exponent}"));
        cases.push(heavy);
    }
    let slack = Oscillator { rest_length: 0.0, ..plain };
    cases.push(Oscillator { away: 0.5, speed: 0.0, ..slack }.plain(Group::Collapse, "rest length 0, through the pin"));
    cases.push(Oscillator { away: 0.0, speed: 2.0, ..slack }.plain(Group::Collapse, "rest length 0, from the pin"));
    let born = Oscillator { away: -1.0, speed: 2.0, ..plain };
    cases.push(born.case(Group::Collapse, "from length 0, where it pushes nowhere", 0.5, 5000));
    let far = Oscillator { at: [1e6, -1e6, 1e6], ..plain };
    cases.push(far.plain(Group::Offset, "1e6 m from the origin"));
    for exponent in [-60, -130, -500, -1040] {
        let scale = 2.0_f64.powi(exponent);
        cases.push(Oscillator { scale, ..plain }.plain(Group::Tiny, &format!("all lengths times 2^{exponent}")));
    }
    for exponent in [-100, -140, -1040] {
        let mass = 2.0_f64.powi(exponent);
        cases.push(Oscillator { mass, ..plain }.plain(Group::Tiny, &format!("all masses times 2^{exponent}")));
    }
    let steps = whole(effort * DRIFT);
    let name = format!("energy over {steps} steps");
    let long = plain.body(Group::Drift, name, 0.01 * steps as f64, steps);
    cases.push(long.known(Known::Energy));
    cases
}

impl Oscillator {
    fn plain(self, group: Group, name: &str) -> Case {
        self.case(group, name, 1.1, 4400)
    }

    fn case(self, group: Group, name: &str, duration: f64, steps: u64) -> Case {
        let place = |time: f64| vec![self.at, self.place(self.rest_length + self.motion(time))];
        self.body(group, format!("an oscillator: {name}"), duration, steps).moving(place)
    }

    fn body(self, group: Group, name: String, duration: f64, steps: u64) -> Body {
        let Self { omega, zeta, rest_length, away, speed, at, scale, mass } = self;
        let velocity = ALONG.map(|part| scale * speed * part);
        let particle = |position, velocity, hold| ModelParticle { position, velocity, mass, hold };
        let spring = ModelSpring {
            between: [0, 1],
            stiffness: mass * omega * omega,
            damping: 2.0 * zeta * mass * omega,
            rest_length: scale * rest_length,
        };
        let pin = particle(at, [0.0; 3], Hold::Pinned);
        let particles = vec![pin, particle(self.place(rest_length + away), velocity, Hold::Free)];
        let model = Model { particles, springs: vec![spring], ..Model::default() };
        Body { group, name, model, gravity: [0.0; 3], duration, steps }
    }

    fn place(&self, along: f64) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.at[axis] + self.scale * along * ALONG[axis])
    }

    /// From the rest length, m.
    fn motion(&self, time: f64) -> f64 {
        let Self { omega, zeta, away, speed, .. } = *self;
        if zeta < 1.0 {
            let damped = omega * (1.0 - zeta * zeta).sqrt();
            let (sine, cosine) = (damped * time).sin_cos();
            return (-zeta * omega * time).exp() * (away * cosine + (speed + zeta * omega * away) / damped * sine);
        }
        let root = (zeta * zeta - 1.0).sqrt();
        let (slow, fast) = (-omega / (zeta + root), -omega * (zeta + root));
        let first = (speed - fast * away) / (slow - fast);
        first * (slow * time).exp() + (away - first) * (fast * time).exp()
    }
}

/// A light and a heavy one that swing about their centre of mass, which stays where it is.
fn two_bodies(ratio: f64, name: String) -> Case {
    let (light, heavy) = (1.0, ratio);
    let reduced = light * heavy / (light + heavy);
    let omega = Oscillator::default().omega;
    let particle = |along: f64, mass| ModelParticle {
        position: ALONG.map(|part| along * part),
        velocity: [0.0; 3],
        mass,
        hold: Hold::Free,
    };
    // At the start 1.1 m apart, about 0.
    let parts = [-heavy / (light + heavy), light / (light + heavy)];
    let spring = ModelSpring { between: [0, 1], stiffness: reduced * omega * omega, damping: 0.0, rest_length: 1.0 };
    let body = Body {
        group: Group::Mass,
        name,
        model: Model {
            particles: vec![particle(1.1 * parts[0], light), particle(1.1 * parts[1], heavy)],
            springs: vec![spring],
            ..Model::default()
        },
        gravity: [0.0; 3],
        duration: 1.1,
        steps: 4400,
    };
    body.moving(|time| {
        let apart = 1.0 + 0.1 * (omega * time).cos();
        parts.map(|part| ALONG.map(|along| apart * part * along)).to_vec()
    })
}
