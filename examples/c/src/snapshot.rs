//! A world's state as bytes, little-endian: what it is made of, what has been chosen, and where everything is.

use hooke::{Balance, Ledger, Real};

use crate::code::{HookeCode, Outcome};
use crate::engine::{Choices, Engine, SpringGiven};
use crate::method::MaybeLedger;
use crate::options::{HookeCollision, HookeHold, HookeStepper};

/// The first bytes; the last is the version of what follows.
const MAGIC: [u8; 8] = *b"hooke\0\0\x01";
/// Time, tolerance, gravity, and what the ledger has come to.
const NUMBERS: usize = 2 + 3 + 5;
/// The width of a real, the counts, stepper, collision, whether there is a ledger, whether steps may do without a factor.
const WORDS: usize = 1 + 3 + 4;
const HEADER: usize = MAGIC.len() + 4 * WORDS + 8 * NUMBERS;
const HELD: u32 = 1;

/// How long the parts of a snapshot are.
#[derive(Clone, Copy)]
struct Extents {
    real: usize,
    counts: [u32; 3],
}

impl Extents {
    fn of<R: Real>(engine: &Engine<R>) -> Self {
        Self { real: size_of::<R>(), counts: engine.counts() }
    }

    /// State and hold.
    fn particle(self) -> usize {
        6 * self.real + 4
    }

    /// Ends and parameters.
    fn spring(self) -> usize {
        8 + 3 * self.real
    }

    /// Normal, offset and restitution.
    fn plane(self) -> usize {
        5 * self.real
    }

    fn parts(self) -> [usize; 4] {
        let [particles, springs, planes] = self.counts.map(|count| count as usize);
        [HEADER, particles * self.particle(), springs * self.spring(), planes * self.plane()]
    }
}

/// A place in some bytes, to write from.
struct Writer<'a> {
    bytes: &'a mut [u8],
    real: usize,
}

impl Writer<'_> {
    fn bytes(&mut self, bytes: &[u8]) {
        let (to, rest) = core::mem::take(&mut self.bytes).split_at_mut_checked(bytes.len()).unwrap_or_default();
        to.copy_from_slice(bytes.get(..to.len()).unwrap_or_default());
        self.bytes = rest;
    }

    fn word(&mut self, word: u32) {
        self.bytes(&word.to_le_bytes());
    }

    fn number(&mut self, number: f64) {
        self.bytes(&number.to_le_bytes());
    }

    fn real(&mut self, real: f64) {
        // Exact: it was of that width.
        if self.real == 4 { self.bytes(&(real as f32).to_le_bytes()) } else { self.number(real) }
    }
}

/// A place in some bytes, to read from; 0 past their end.
#[derive(Clone, Copy)]
struct Reader<'a> {
    bytes: &'a [u8],
    real: usize,
}

impl Reader<'_> {
    fn bytes<const COUNT: usize>(&mut self) -> [u8; COUNT] {
        let (first, rest) = self.bytes.split_first_chunk().unwrap_or((&[0; COUNT], &[]));
        self.bytes = rest;
        *first
    }

    fn word(&mut self) -> u32 {
        u32::from_le_bytes(self.bytes())
    }

    fn number(&mut self) -> f64 {
        f64::from_le_bytes(self.bytes())
    }

    fn real(&mut self) -> f64 {
        if self.real == 4 { f64::from(f32::from_le_bytes(self.bytes())) } else { self.number() }
    }

    fn reals<const COUNT: usize>(&mut self) -> [f64; COUNT] {
        core::array::from_fn(|_| self.real())
    }

    /// From so many bytes further on.
    fn at(self, start: usize) -> Self {
        Self { bytes: self.bytes.get(start..).unwrap_or_default(), ..self }
    }
}

/// What comes before the particles.
struct Header {
    time: f64,
    choices: Choices,
    gravity: [f64; 3],
    ledger: Option<Balance>,
}

impl Header {
    fn read<R: Real>(mut bytes: Reader<'_>, extents: &Extents) -> Option<Self> {
        let is_ours = bytes.bytes() == MAGIC
            && bytes.word() == extents.real as u32
            && extents.counts.iter().all(|count| bytes.word() == *count);
        let (stepper, collision) = (bytes.word(), bytes.word());
        let (has_ledger, may_do_without_factor) = (bytes.word() == 1, bytes.word() == 1);
        let (time, tolerance) = (bytes.number(), bytes.number());
        let mut numbers = || bytes.number();
        let gravity = [numbers(), numbers(), numbers()];
        let balance = Balance {
            lost_to_damping: numbers(),
            lost_in_impacts: numbers(),
            lost_to_sleep: numbers(),
            work_of_pins: numbers(),
            opened_with: numbers(),
            // The rest follows from the state.
            ..Balance::default()
        };
        let choices = Choices {
            stepper: HookeStepper::numbered(stepper)?,
            collision: HookeCollision::numbered(collision)?,
            tolerance,
            may_do_without_factor,
        };
        let is_sound = time.is_finite()
            && tolerance > 0.0
            && tolerance.is_finite()
            // What a double holds may be past what the world does.
            && gravity.iter().all(|component| R::from_f64(*component).is_finite())
            && is_finite(&balance);
        (is_ours && is_sound).then_some(Self { time, choices, gravity, ledger: has_ledger.then_some(balance) })
    }
}

impl<R: Real> Engine<R> {
    /// How many bytes a snapshot has.
    pub fn snapshot_size(&self) -> usize {
        Extents::of(self).parts().iter().sum()
    }

    /// Writes one. What follows the state begins anew, so that the world moves from here to the bit as one does that the
    /// snapshot is put back into.
    pub fn snapshot(&mut self, bytes: &mut [u8]) -> Outcome {
        let extents = Extents::of(self);
        if bytes.len() != self.snapshot_size() {
            return Err(HookeCode::Length.into());
        }
        self.begin_anew();
        let mut header = Writer { bytes: &mut *bytes, real: extents.real };
        header.bytes(&MAGIC);
        header.word(extents.real as u32);
        extents.counts.into_iter().for_each(|count| header.word(count));
        header.word(self.choices.stepper as u32);
        header.word(self.choices.collision as u32);
        // A ledger past all numbers is none, lest the snapshot be refused.
        let carried = self.carried.filter(is_finite);
        header.word(u32::from(carried.is_some()));
        header.word(u32::from(self.choices.may_do_without_factor));
        header.number(self.time());
        header.number(self.choices.tolerance);
        self.world.gravity().into_iter().for_each(|component| header.number(component.to_f64()));
        let carried = carried.unwrap_or_default();
        energies(&carried).into_iter().for_each(|energy| header.number(energy));
        let mut particles = header;
        for (number, state) in (0..).zip(self.states()) {
            state.into_iter().flatten().for_each(|component| particles.real(component));
            particles.word(if self.world.is_held(number) == Some(true) { HELD } else { 0 });
        }
        let [header, particles, springs, _] = extents.parts();
        for (number, spring) in self.world.springs() {
            let start = header + particles + number as usize * extents.spring();
            let mut place = Writer { bytes: bytes.get_mut(start..).unwrap_or_default(), real: extents.real };
            spring.between.into_iter().for_each(|end| place.word(end));
            for parameter in [spring.stiffness, spring.damping, spring.rest_length] {
                place.real(parameter.to_f64());
            }
        }
        let start = header + particles + springs;
        let mut planes = Writer { bytes: bytes.get_mut(start..).unwrap_or_default(), real: extents.real };
        for plane in self.world.planes() {
            let normal = plane.normal().into().map(Real::to_f64);
            normal.into_iter().for_each(|component| planes.real(component));
            planes.real(plane.offset().to_f64());
            planes.real(plane.restitution().to_f64());
        }
        Ok(())
    }

    /// Puts one back, of a world with the same particles, springs and planes.
    pub fn restore(&mut self, bytes: &[u8]) -> Outcome {
        let extents = Extents::of(self);
        let all = Reader { bytes, real: extents.real };
        let header = Header::read::<R>(all, &extents).filter(|_| bytes.len() == self.snapshot_size());
        let header = header.ok_or(HookeCode::Snapshot)?;
        let [start, particles, springs, _] = extents.parts();
        let (particles, springs, planes) =
            (all.at(start), all.at(start + particles), all.at(start + particles + springs));
        if !(are_states(particles, extents) && self.has_springs(springs, extents) && self.has_planes(planes)) {
            return Err(HookeCode::Snapshot.into());
        }
        self.set_springs_from(springs, extents)?;
        let mut bytes = planes;
        for plane in 0..extents.counts[2] {
            let [.., restitution] = bytes.reals::<5>();
            self.set_restitution(plane, restitution)?;
        }
        let mut bytes = particles;
        for number in 0..extents.counts[0] {
            let [x, y, z, u, v, w] = bytes.reals();
            // A pinned particle is one that moves with the velocity 0.
            let hold = if bytes.word() == HELD { HookeHold::Kinematic } else { HookeHold::Free };
            self.set_hold(number, hold)?;
            self.set_position(number, [x, y, z])?;
            self.set_velocity(number, [u, v, w])?;
        }
        self.set_gravity(header.gravity)?;
        self.world.set_time(header.time)?;
        self.choices = header.choices;
        self.carried = header.ledger;
        self.ledger = MaybeLedger(header.ledger.map(|_| Ledger::open(&self.world.view())));
        self.begin_anew_without_ledger();
        Ok(())
    }

    fn set_springs_from(&mut self, springs: Reader<'_>, extents: Extents) -> Outcome {
        self.set_numbered_springs(|number, spring| {
            let [stiffness, damping, rest_length] = springs.at(number as usize * extents.spring() + 8).reals();
            SpringGiven { stiffness, damping, rest_length, ..spring }
        })
    }

    fn has_springs(&self, springs: Reader<'_>, extents: Extents) -> bool {
        self.world.springs().all(|(number, spring)| {
            let mut bytes = springs.at(number as usize * extents.spring());
            let mut between = [bytes.word(), bytes.word()];
            let mut ours = spring.between;
            // Which end comes first is no part of what a spring is.
            between.sort_unstable();
            ours.sort_unstable();
            between == ours && bytes.reals::<3>().iter().all(|parameter| *parameter >= 0.0 && parameter.is_finite())
        })
    }

    fn has_planes(&self, mut bytes: Reader<'_>) -> bool {
        self.world.planes().iter().all(|plane| {
            let [x, y, z, offset, restitution] = bytes.reals();
            plane.normal().into().map(Real::to_f64) == [x, y, z]
                && plane.offset().to_f64() == offset
                && (0.0..=1.0).contains(&restitution)
        })
    }
}

/// Those of a ledger's energies that do not follow from the state, in the order of the header.
fn energies(balance: &Balance) -> [f64; 5] {
    let Balance { lost_to_damping, lost_in_impacts, lost_to_sleep, work_of_pins, opened_with, .. } = *balance;
    [lost_to_damping, lost_in_impacts, lost_to_sleep, work_of_pins, opened_with]
}

fn is_finite(balance: &Balance) -> bool {
    energies(balance).iter().all(|energy| energy.is_finite())
}

fn are_states(mut bytes: Reader<'_>, extents: Extents) -> bool {
    (0..extents.counts[0]).all(|_| {
        let is_finite = bytes.reals::<6>().iter().all(|component| component.is_finite());
        is_finite & (bytes.word() <= HELD)
    })
}
