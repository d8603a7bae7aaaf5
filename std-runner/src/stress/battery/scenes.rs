//! A scene made hard.

use super::case::{Case, Group, Known, whole};
use super::distance::size;
use super::known::elsewhere;
use crate::model::{Hold, Model, ModelParticle, ModelPlane, ModelSpring};
use crate::scene::{CollisionForm, Settings};
use crate::simulate::world;
use crate::stress::noise::noise;

/// The part of its stability bound at which a scene is stepped.
const PART: f64 = 0.2;
/// Steps of a run, times particles and springs.
const WORK: f64 = 3e5;
/// The same where drift is looked for.
const DRIFT: f64 = 1e6;
/// What the work of a step is apart from particles and springs, as so many of them.
const OVERHEAD: f64 = 30.0;
/// Steps at least and at most.
const STEPS: [f64; 2] = [20.0, 2000.0];
/// Steps at most where drift is looked for.
const MOST: f64 = 1e7;

/// A scene as the battery steps it: what follows a track stays where it is.
#[derive(Clone, Debug)]
pub struct Start {
    model: Model,
    gravity: [f64; 3],
    duration: f64,
    /// How much may be spent, beside what is spent by default.
    effort: f64,
}

impl Start {
    /// Of a scene; `effort` is 1, or more to look longer.
    pub fn of(model: &Model, settings: &Settings, effort: f64) -> Self {
        let mut model = Model { tracks: Vec::new(), ..model.clone() };
        for particle in &mut model.particles {
            if matches!(particle.hold, Hold::Track(_)) {
                (particle.hold, particle.velocity) = (Hold::Pinned, [0.0; 3]);
            }
        }
        Self { model, gravity: settings.gravity, duration: settings.duration, effort }
    }

    /// The scene itself, nothing known of it yet.
    pub fn as_it_is(&self) -> Case {
        self.case(Group::AsItIs, "the scene".to_owned(), self.model.clone())
    }

    /// All cases that a reference has to be made for.
    pub fn unknown(&self) -> Vec<Case> {
        let mut cases = Vec::new();
        for exponent in [3, 6, 9] {
            let ratio = 10.0_f64.powi(exponent);
            let stiff = self.with_springs(|number, spring| ModelSpring {
                stiffness: if number % 2 == 0 { ratio * spring.stiffness } else { spring.stiffness },
                ..spring
            });
            if self.model.springs.len() > 1 {
                let name = format!("every other spring 1e{exponent} times as stiff");
                cases.push(self.case(Group::Stiffness, name.clone(), stiff.clone()));
                let long = Case {
                    steps: self.as_it_is().steps,
                    duration: self.as_it_is().duration,
                    ..self.case(Group::Stiffness, format!("{name}, steps as before"), stiff)
                };
                cases.push(long);
            }
            let heavy = self.with_particles(|number, particle| ModelParticle {
                mass: if number % 2 == 0 { ratio * particle.mass } else { particle.mass },
                ..particle
            });
            cases.push(self.case(Group::Mass, format!("every other particle 1e{exponent} times as heavy"), heavy));
        }
        if !self.model.springs.is_empty() {
            let slack = self.with_springs(|_, spring| ModelSpring { rest_length: 0.0, ..spring });
            cases.push(self.case(Group::Collapse, "every rest length 0".to_owned(), slack));
        }
        cases.extend([-9, -6, -3, -1, 0, 1].into_iter().map(|exponent| self.in_steps_of(exponent)));
        cases
    }

    /// Steps of a power of ten, s; the long ones are few.
    fn in_steps_of(&self, exponent: i32) -> Case {
        let case = self.as_it_is();
        let time_step = 10.0_f64.powi(exponent);
        let steps = if exponent < 0 { case.steps } else { 20 };
        let name = format!("steps of 1e{exponent} s");
        Case { group: Group::TimeStep, name, steps, duration: steps as f64 * time_step, ..case }
    }

    /// All cases that follow from what is known of the scene itself, or need nothing but the laws of motion.
    pub fn derived(&self, itself: &Known) -> Vec<Case> {
        let mut cases = Vec::new();
        let far = [1e6, -1e6, 1e6];
        if let Some(known) = elsewhere(itself, 1.0, far) {
            let shifted = moved(&self.model, 1.0, far);
            let case = self.case(Group::Offset, "1e6 m from the origin".to_owned(), self.model.clone());
            cases.push(Case { model: shifted, known, ..case });
        }
        for exponent in [-60, -130, -500, -1040] {
            let scale = 2.0_f64.powi(exponent);
            let Some(known) = elsewhere(itself, scale, [0.0; 3]) else { continue };
            let case = self.case(Group::Tiny, format!("all lengths times 2^{exponent}"), self.model.clone());
            let gravity = self.gravity.map(|component| scale * component);
            cases.push(Case { model: moved(&self.model, scale, [0.0; 3]), gravity, known, ..case });
        }
        for exponent in [-100, -140, -1040] {
            let scale = 2.0_f64.powi(exponent);
            let Some(known) = elsewhere(itself, 1.0, [0.0; 3]) else { continue };
            let mut model =
                self.with_particles(|_, particle| ModelParticle { mass: scale * particle.mass, ..particle });
            for spring in &mut model.springs {
                (spring.stiffness, spring.damping) = (scale * spring.stiffness, scale * spring.damping);
            }
            let case =
                self.case(Group::Tiny, format!("all masses and stiffnesses times 2^{exponent}"), self.model.clone());
            cases.push(Case { model, known, ..case });
        }
        if !self.model.springs.is_empty() {
            cases.push(self.collapsed());
            cases.push(self.drift());
        }
        cases
    }

    /// All particles at one place, where no spring has a direction: they fall together.
    fn collapsed(&self) -> Case {
        let place = self.model.particles.first().map_or([0.0; 3], |particle| particle.position);
        let together =
            |_, particle| ModelParticle { position: place, velocity: [0.0; 3], hold: Hold::Free, ..particle };
        let model = Model { planes: Vec::new(), ..self.with_particles(together) };
        let case =
            self.case(Group::Collapse, "all particles at one place: they fall together".to_owned(), self.model.clone());
        let fallen = |part: u64| {
            let time = case.duration * part as f64 / 4.0;
            let at = [0, 1, 2].map(|axis| place[axis] + 0.5 * self.gravity[axis] * time * time);
            vec![at; model.particles.len()]
        };
        let known = Known::Motion { positions: (1..=4).map(fallen).collect(), uncertainty: 0.0 };
        Case { model, known, ..case }
    }

    /// Undamped, and nothing from outside: energy and momentum stay, step after step.
    fn drift(&self) -> Case {
        let model = self.with_springs(|_, spring| ModelSpring { damping: 0.0, ..spring });
        let speed = 1e-3 * size(&self.model) / self.stable(&model);
        let swing = |number: usize, particle: ModelParticle| ModelParticle {
            velocity: noise(number as u64).map(|part| speed * part),
            hold: Hold::Free,
            ..particle
        };
        let particles = model.particles.iter().enumerate().map(|(number, particle)| swing(number, *particle)).collect();
        let free = Model { particles, planes: Vec::new(), ..model };
        let time_step = PART * self.stable(&free);
        let steps = self.steps(DRIFT, MOST);
        Case {
            group: Group::Drift,
            name: format!("energy and momentum over {steps} steps"),
            model: free,
            gravity: [0.0; 3],
            duration: steps as f64 * time_step,
            steps,
            collision: CollisionForm::TimeOfImpact,
            most_hits: None,
            known: Known::EnergyAndMomentum,
        }
    }

    /// At a part of the stability bound, for as many steps as may be spent on it.
    fn case(&self, group: Group, name: String, model: Model) -> Case {
        let stable = self.stable(&model);
        let steps = self.steps(WORK, STEPS[1]);
        let duration = if stable.is_finite() { steps as f64 * PART * stable } else { self.duration };
        Case {
            group,
            name,
            model,
            gravity: self.gravity,
            // Not the whole: scenes like to end after whole swings, where nothing seems to have moved.
            duration: duration.min(0.87 * self.duration),
            steps,
            collision: CollisionForm::TimeOfImpact,
            most_hits: None,
            known: Known::NoMoreEnergy,
        }
    }

    fn steps(&self, work: f64, most: f64) -> u64 {
        let items = (self.model.particles.len() + self.model.springs.len()) as f64 + OVERHEAD;
        whole((self.effort * work / items).clamp(STEPS[0], most))
    }

    /// The least bound of velocity Verlet and semi-implicit Euler, s.
    fn stable(&self, model: &Model) -> f64 {
        let bound = world::<f64>(model, [0.0; 3]).ok().and_then(|mut world| world.view().stability());
        bound.map_or(f64::INFINITY, |bound| bound.velocity_verlet)
    }

    fn with_springs(&self, change: impl Fn(usize, ModelSpring) -> ModelSpring) -> Model {
        let springs = self.model.springs.iter().enumerate().map(|(number, spring)| change(number, *spring));
        Model { springs: springs.collect(), ..self.model.clone() }
    }

    fn with_particles(&self, change: impl Fn(usize, ModelParticle) -> ModelParticle) -> Model {
        let particles = self.model.particles.iter().enumerate().map(|(number, particle)| change(number, *particle));
        Model { particles: particles.collect(), ..self.model.clone() }
    }
}

/// Everything larger, and somewhere else.
fn moved(model: &Model, scale: f64, shift: [f64; 3]) -> Model {
    let place = |position: [f64; 3]| [0, 1, 2].map(|axis| scale * position[axis] + shift[axis]);
    let particle = |particle: &ModelParticle| ModelParticle {
        position: place(particle.position),
        velocity: particle.velocity.map(|component| scale * component),
        ..*particle
    };
    let spring = |spring: &ModelSpring| ModelSpring { rest_length: scale * spring.rest_length, ..*spring };
    let plane = |plane: &ModelPlane| ModelPlane { point: place(plane.point), ..*plane };
    Model {
        particles: model.particles.iter().map(particle).collect(),
        springs: model.springs.iter().map(spring).collect(),
        planes: model.planes.iter().map(plane).collect(),
        tracks: Vec::new(),
    }
}
