//! A world with what steps it, in one precision.

use hooke::{Balance, Container, Hold, Ledger, Particle, Plane, Real, SetError, Spring, StabilityBound, StepReport};

use crate::arena::{Arena, Capacity, InArena};
use crate::code::{HookeCode, Outcome};
use crate::method::{AnyResponse, AnyStepper, MaybeLedger};
use crate::options::{HookeCollision, HookeHold, HookeStepper};
use crate::pace::Pace;
use crate::report::{HookeLedger, HookeReport};

/// A world with what steps it.
pub struct Engine<R: Real> {
    pub(crate) world: Container<R, InArena>,
    stepper: AnyStepper<R>,
    response: AnyResponse<R>,
    pub(crate) ledger: MaybeLedger,
    /// What an earlier ledger had come to when this one was opened.
    pub(crate) carried: Option<Balance>,
    pub(crate) choices: Choices,
    pub(crate) pace: Pace,
    /// The time step that the stepper is known to have room for; nothing after a change.
    prepared_for: Option<f64>,
    home: Arena,
    workspace: Arena,
}

/// What a caller has chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choices {
    pub stepper: HookeStepper,
    pub collision: HookeCollision,
    pub tolerance: f64,
    /// Whether implicit steps go on without a factor that there is no room for.
    pub may_do_without_factor: bool,
}

/// What a spring pulls by: its stiffness (N/m), damping (N s/m) and rest length (m).
pub type Parameters = [f64; 3];

/// What columns of a world take at most, bytes.
pub fn home_bytes(real: usize, capacity: Capacity) -> usize {
    let [particles, springs, planes] = capacity.of;
    // As in the core's `layout.rs`: 14 reals, three words and a byte a particle; three reals, 34 bytes a spring.
    Arena::bytes_of_all(&[
        (14, particles, real),
        (3, particles, 4),
        (1, particles, 1),
        (3, springs, real),
        (2, springs, 4),
        (1, springs, 8),
        (1, springs, 16),
        (1, springs, 2),
        (1, planes, 5 * real),
    ])
}

impl<R: Real> Engine<R> {
    /// Without anything in it, at 0 s.
    pub fn new(home: Arena, workspace: Arena) -> Self {
        let choices = Choices {
            stepper: HookeStepper::SemiImplicitEuler,
            collision: HookeCollision::Reflect,
            tolerance: 1e-6,
            may_do_without_factor: false,
        };
        Self {
            world: Container::new(),
            stepper: AnyStepper::named(choices.stepper, choices.tolerance),
            response: AnyResponse::named(choices.collision),
            ledger: MaybeLedger(None),
            carried: None,
            choices,
            pace: Pace::default(),
            prepared_for: None,
            home,
            workspace,
        }
    }

    /// The stepper and the response begin anew, without anything that they remember.
    pub fn renew(&mut self) {
        self.stepper = AnyStepper::named(self.choices.stepper, self.choices.tolerance);
        self.response = AnyResponse::named(self.choices.collision);
        self.workspace.take_back();
        self.prepared_for = None;
    }

    /// The same, where they have been made for a world that is about to change.
    fn change(&mut self) {
        if self.workspace.is_used() {
            self.renew();
        }
        self.prepared_for = None;
    }

    pub fn choose(&mut self, choices: Choices) {
        self.choices = choices;
        self.renew();
    }

    pub fn set_workspace(&mut self, workspace: Arena) {
        self.workspace = workspace;
        self.renew();
    }

    pub fn add_particle(
        &mut self,
        position: &[f64; 3],
        velocity: &[f64; 3],
        mass: f64,
        hold: HookeHold,
    ) -> Outcome<u32> {
        self.change();
        let (position, velocity) = (vector::<R>(position), vector::<R>(velocity));
        let particle = Particle { position, velocity, mass: R::from_f64(mass), hold: held(hold) };
        let Self { world, home, .. } = self;
        Ok(home.lend(|| world.add_particle(particle))?)
    }

    pub fn add_spring(&mut self, between: [u32; 2], parameters: &Parameters) -> Outcome<u32> {
        self.change();
        let spring = with_parameters(between, parameters);
        let Self { world, home, .. } = self;
        Ok(home.lend(|| world.add_spring(spring))?)
    }

    pub fn add_plane(&mut self, point: &[f64; 3], normal: &[f64; 3], restitution: f64) -> Outcome<u32> {
        self.change();
        let plane = Plane::<R>::through(vector::<R>(point), vector::<R>(normal), R::from_f64(restitution))?;
        let Self { world, home, .. } = self;
        Ok(home.lend(|| world.add_plane(plane))?)
    }

    pub fn set_gravity(&mut self, gravity: &[f64; 3]) -> Outcome {
        Ok(self.world.set_gravity(vector::<R>(gravity))?)
    }

    pub fn set_position(&mut self, particle: u32, position: &[f64; 3]) -> Outcome {
        Ok(self.world.set_position(particle, vector::<R>(position))?)
    }

    pub fn set_velocity(&mut self, particle: u32, velocity: &[f64; 3]) -> Outcome {
        Ok(self.world.set_velocity(particle, vector::<R>(velocity))?)
    }

    pub fn set_hold(&mut self, particle: u32, hold: HookeHold) -> Outcome {
        self.prepared_for = None;
        Ok(self.world.set_hold(particle, held(hold))?)
    }

    pub fn drive(&mut self, particle: u32, position: &[f64; 3], velocity: &[f64; 3]) -> Outcome {
        self.world.drive(particle, vector::<R>(position), vector::<R>(velocity))?;
        if self.world.is_held(particle) == Some(false) {
            self.set_hold(particle, HookeHold::Kinematic)?;
        }
        Ok(())
    }

    /// Gives one spring other parameters.
    pub fn set_spring(&mut self, number: u32, parameters: &Parameters) -> Outcome {
        let [_, springs, _] = self.counts();
        if number >= springs {
            return Err(HookeCode::NoSuchSpring.about(number));
        }
        self.change_springs(&|other, now| {
            if other == number {
                *now = *parameters;
            }
        })
    }

    /// Gives every spring the parameters that `change` makes of its number and of those that it has.
    pub fn change_springs(&mut self, change: &dyn Fn(u32, &mut Parameters)) -> Outcome {
        self.prepared_for = None;
        let outcome = self.world.change_springs(|number, spring| {
            let mut parameters = parameters_of(&spring);
            change(number, &mut parameters);
            with_parameters(spring.between, &parameters)
        });
        let Err(SetError::Spring(refused)) = outcome else { return Ok(outcome?) };
        let mut parameters = self.spring(refused)?;
        change(refused, &mut parameters);
        let is_refused = |parameter: &f64| {
            let rounded = R::from_f64(*parameter);
            !(rounded >= R::ZERO && rounded.is_finite())
        };
        Err(match parameters.iter().position(is_refused) {
            Some(0) => HookeCode::Stiffness,
            Some(1) => HookeCode::Damping,
            _ => HookeCode::RestLength,
        }
        .about(refused))
    }

    /// The parameters of one spring.
    pub fn spring(&self, number: u32) -> Outcome<Parameters> {
        let found = self.world.springs().find(|(other, _)| *other == number);
        found.map(|(_, spring)| parameters_of(&spring)).ok_or(HookeCode::NoSuchSpring.about(number))
    }

    pub fn set_restitution(&mut self, plane: u32, restitution: f64) -> Outcome {
        Ok(self.world.set_restitution(plane, R::from_f64(restitution))?)
    }

    /// Takes so many steps, or as many as can be taken.
    pub fn step(&mut self, dt: f64, count: u32, report: &mut HookeReport) -> Outcome {
        self.pace.keep(dt, self.world.time());
        let mut total = StepReport::default();
        let (mut steps, mut without_factor) = (0, false);
        let mut outcome = Ok(());
        while steps < count && outcome.is_ok() {
            outcome = self.step_once(dt, &mut total);
            if outcome.is_ok() {
                steps += 1;
                without_factor = self.workspace.has_refused();
            }
        }
        *report = HookeReport::of(&total, steps, self.world.time(), without_factor);
        outcome
    }

    fn step_once(&mut self, dt: f64, total: &mut StepReport) -> Outcome {
        let Self { world, stepper, response, ledger, pace, prepared_for, workspace, choices, .. } = self;
        let length = R::from_f64(dt);
        workspace.lend(|| {
            let mut view = world.view();
            if *prepared_for != Some(dt) && length > R::ZERO && length.is_finite() {
                stepper.any().accept(view.plan())?;
                stepper.any().fit(view.plan())?;
                stepper.prepare(&view, length)?;
                if workspace.has_refused() && !choices.may_do_without_factor {
                    return Err(HookeCode::Workspace.into());
                }
                *prepared_for = Some(dt);
            }
            total.add(&view.step_to(stepper.any(), response, length, pace.next_end(), ledger)?);
            pace.count += 1;
            Ok(())
        })
    }

    pub fn time(&self) -> f64 {
        self.world.time()
    }

    /// How many particles, springs and planes there are.
    pub fn counts(&self) -> [u32; 3] {
        [self.world.particle_count(), self.world.springs().len() as u32, self.world.planes().len() as u32]
    }

    /// Positions (m) and velocities (m/s), by number.
    pub fn states(&self) -> impl Iterator<Item = [[f64; 3]; 2]> {
        self.world.states().map(|(position, velocity)| [numbers::<R>(position), numbers::<R>(velocity)])
    }

    /// Opens a ledger, or opens it anew.
    pub fn open_ledger(&mut self) {
        self.carried = None;
        self.ledger = MaybeLedger(Some(Ledger::open(&self.world.view())));
    }

    /// What the ledger says; without one, one that has just been opened would.
    pub fn balance(&mut self) -> HookeLedger {
        let view = self.world.view();
        let open = self.ledger.0.unwrap_or_else(|| Ledger::open(&view));
        HookeLedger::of(&carry(self.carried.as_ref(), &open.balance(&view)))
    }

    /// Whatever follows the state begins anew with it, so that one that is put back moves as this one does.
    pub fn begin_anew(&mut self) {
        if let Some(ledger) = self.ledger.0 {
            let view = self.world.view();
            self.carried = Some(carry(self.carried.as_ref(), &ledger.balance(&view)));
            self.ledger.0 = Some(Ledger::open(&view));
        }
        self.begin_anew_without_ledger();
    }

    /// The same, but for the ledger.
    pub fn begin_anew_without_ledger(&mut self) {
        self.renew();
        self.pace = Pace::default();
    }

    pub fn stability(&mut self) -> Option<StabilityBound> {
        self.world.view().stability()
    }

    pub fn digest(&self) -> u64 {
        self.states().fold(hooke_digest::OF_NOTHING, hooke_digest::with)
    }
}

/// What two ledgers, one after the other, come to.
fn carry(earlier: Option<&Balance>, now: &Balance) -> Balance {
    let Some(earlier) = earlier else { return *now };
    Balance {
        lost_to_damping: earlier.lost_to_damping + now.lost_to_damping,
        lost_in_impacts: earlier.lost_in_impacts + now.lost_in_impacts,
        lost_to_sleep: earlier.lost_to_sleep + now.lost_to_sleep,
        work_of_pins: earlier.work_of_pins + now.work_of_pins,
        opened_with: earlier.opened_with,
        ..*now
    }
}

/// A vector rounded to `R`.
fn vector<R: Real>([x, y, z]: &[f64; 3]) -> R::Vec3 {
    [R::Coordinate::from_f64(*x), R::Coordinate::from_f64(*y), R::Coordinate::from_f64(*z)].into()
}

/// A vector of `R`.
pub fn numbers<R: Real>(vector: R::Vec3) -> [f64; 3] {
    let [x, y, z] = vector.into();
    [x.to_f64(), y.to_f64(), z.to_f64()]
}

pub fn parameters_of<R: Real>(spring: &Spring<R>) -> Parameters {
    [spring.stiffness.to_f64(), spring.damping.to_f64(), spring.rest_length.to_f64()]
}

fn with_parameters<R: Real>(between: [u32; 2], [stiffness, damping, rest_length]: &Parameters) -> Spring<R> {
    Spring {
        between,
        stiffness: R::from_f64(*stiffness),
        damping: R::from_f64(*damping),
        rest_length: R::from_f64(*rest_length),
    }
}

fn held(hold: HookeHold) -> Hold {
    match hold {
        HookeHold::Free => Hold::Free,
        HookeHold::Pinned => Hold::Pinned,
        HookeHold::Kinematic => Hold::Kinematic,
    }
}
