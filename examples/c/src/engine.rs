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

/// A spring as it is handed over.
#[derive(Clone, Copy, Debug)]
pub struct SpringGiven {
    pub between: [u32; 2],
    pub stiffness: f64,
    pub damping: f64,
    pub rest_length: f64,
}

/// What columns of a world take at most, bytes.
pub fn home_bytes(real: usize, capacity: Capacity) -> usize {
    let [particles, springs, planes] = capacity.of;
    let columns = |count: usize, items: usize, size: usize| Arena::bytes_of(items, size).saturating_mul(count);
    // As in the core's `layout.rs`: 14 reals, three words and a byte a particle; three reals, 34 bytes a spring.
    [
        columns(14, particles, real),
        columns(3, particles, 4),
        columns(1, particles, 1),
        columns(3, springs, real),
        columns(2, springs, 4),
        columns(1, springs, 8),
        columns(1, springs, 16),
        columns(1, springs, 2),
        columns(1, planes, 5 * real),
    ]
    .into_iter()
    .fold(0, usize::saturating_add)
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

    pub fn add_particle(&mut self, state: [[f64; 3]; 2], mass: f64, hold: HookeHold) -> Outcome<u32> {
        self.change();
        let [position, velocity] = state.map(vector::<R>);
        let particle = Particle { position, velocity, mass: R::from_f64(mass), hold: held(hold) };
        let Self { world, home, .. } = self;
        Ok(home.lend(|| world.add_particle(particle))?)
    }

    pub fn add_spring(&mut self, spring: SpringGiven) -> Outcome<u32> {
        self.change();
        let Self { world, home, .. } = self;
        let spring = Spring {
            between: spring.between,
            stiffness: R::from_f64(spring.stiffness),
            damping: R::from_f64(spring.damping),
            rest_length: R::from_f64(spring.rest_length),
        };
        Ok(home.lend(|| world.add_spring(spring))?)
    }

    pub fn add_plane(&mut self, point: [f64; 3], normal: [f64; 3], restitution: f64) -> Outcome<u32> {
        self.change();
        let plane = Plane::<R>::through(vector::<R>(point), vector::<R>(normal), R::from_f64(restitution))?;
        let Self { world, home, .. } = self;
        Ok(home.lend(|| world.add_plane(plane))?)
    }

    pub fn set_gravity(&mut self, gravity: [f64; 3]) -> Outcome {
        Ok(self.world.set_gravity(vector::<R>(gravity))?)
    }

    pub fn set_position(&mut self, particle: u32, position: [f64; 3]) -> Outcome {
        Ok(self.world.set_position(particle, vector::<R>(position))?)
    }

    pub fn set_velocity(&mut self, particle: u32, velocity: [f64; 3]) -> Outcome {
        Ok(self.world.set_velocity(particle, vector::<R>(velocity))?)
    }

    pub fn set_hold(&mut self, particle: u32, hold: HookeHold) -> Outcome {
        self.prepared_for = None;
        Ok(self.world.set_hold(particle, held(hold))?)
    }

    pub fn drive(&mut self, particle: u32, position: [f64; 3], velocity: [f64; 3]) -> Outcome {
        let is_held = self.world.is_held(particle).ok_or(SetError::NoSuchParticle(particle))?;
        let [position, velocity] = [position, velocity].map(vector::<R>);
        self.world.drive(particle, position, velocity)?;
        if !is_held {
            self.set_hold(particle, HookeHold::Kinematic)?;
        }
        Ok(())
    }

    /// Gives springs other parameters: those of one, or of all.
    pub fn set_springs(&mut self, which: Option<u32>, change: impl Fn(SpringGiven) -> SpringGiven) -> Outcome {
        let [_, springs, _] = self.counts();
        if let Some(number) = which.filter(|number| *number >= springs) {
            return Err(HookeCode::NoSuchSpring.about(number));
        }
        self.set_numbered_springs(|number, spring| match which {
            Some(which) if which != number => spring,
            _ => change(spring),
        })
    }

    /// Gives every spring the parameters that `change` makes of its number and of what it is.
    pub fn set_numbered_springs(&mut self, change: impl Fn(u32, SpringGiven) -> SpringGiven) -> Outcome {
        let changed = |number, spring: Spring<R>| {
            let SpringGiven { between, stiffness, damping, rest_length } = change(
                number,
                SpringGiven {
                    between: spring.between,
                    stiffness: spring.stiffness.to_f64(),
                    damping: spring.damping.to_f64(),
                    rest_length: spring.rest_length.to_f64(),
                },
            );
            let [stiffness, damping, rest_length] = [stiffness, damping, rest_length].map(R::from_f64);
            Spring { between, stiffness, damping, rest_length }
        };
        self.prepared_for = None;
        let outcome = self.world.change_springs(changed);
        let Err(SetError::Spring(refused)) = outcome else { return Ok(outcome?) };
        let spring = self.world.springs().find(|(number, _)| *number == refused);
        let valid = |value: R| value >= R::ZERO && value.is_finite();
        Err(match spring.map(|(number, spring)| changed(number, spring)) {
            Some(spring) if !valid(spring.stiffness) => HookeCode::Stiffness,
            Some(spring) if !valid(spring.damping) => HookeCode::Damping,
            _ => HookeCode::RestLength,
        }
        .about(refused))
    }

    /// One of the springs.
    pub fn spring(&self, number: u32) -> Outcome<SpringGiven> {
        let found = self.world.springs().find(|(other, _)| *other == number);
        let (_, Spring { between, stiffness, damping, rest_length }) =
            found.ok_or(HookeCode::NoSuchSpring.about(number))?;
        let [stiffness, damping, rest_length] = [stiffness, damping, rest_length].map(Real::to_f64);
        Ok(SpringGiven { between, stiffness, damping, rest_length })
    }

    pub fn set_restitution(&mut self, plane: u32, restitution: f64) -> Outcome {
        Ok(self.world.set_restitution(plane, R::from_f64(restitution))?)
    }

    /// Takes so many steps, or as many as can be taken.
    pub fn step(&mut self, dt: f64, count: u32, report: &mut HookeReport) -> Outcome {
        let Self { world, stepper, response, ledger, pace, prepared_for, workspace, choices, .. } = self;
        let length = R::from_f64(dt);
        let mut total = StepReport::default();
        pace.keep(dt, world.time());
        *report = HookeReport::of(&total, 0, world.time(), false);
        for steps in 0..count {
            let taken: Outcome<StepReport> = workspace.lend(|| {
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
                Ok(view.step_to(stepper.any(), response, length, pace.next_end(), ledger)?)
            });
            total.add(&taken?);
            pace.count += 1;
            *report = HookeReport::of(&total, steps + 1, world.time(), workspace.has_refused());
        }
        Ok(())
    }

    pub fn time(&self) -> f64 {
        self.world.time()
    }

    /// How many particles, springs and planes there are.
    pub fn counts(&self) -> [u32; 3] {
        [self.world.particle_count(), self.world.springs().len() as u32, self.world.planes().len() as u32]
    }

    /// Positions (m) and velocities (m/s), by number.
    pub fn states(&self) -> impl ExactSizeIterator<Item = [[f64; 3]; 2]> {
        let told = |vector: Option<R::Vec3>| vector.map_or([0.0; 3], |vector| vector.into().map(Real::to_f64));
        (0..self.world.particle_count())
            .map(move |number| [told(self.world.position(number)), told(self.world.velocity(number))])
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

    pub fn digest(&mut self) -> u64 {
        hooke_digest::of(&self.world.view())
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
pub fn vector<R: Real>(vector: [f64; 3]) -> R::Vec3 {
    vector.map(R::Coordinate::from_f64).into()
}

fn held(hold: HookeHold) -> Hold {
    match hold {
        HookeHold::Free => Hold::Free,
        HookeHold::Pinned => Hold::Pinned,
        HookeHold::Kinematic => Hold::Kinematic,
    }
}
