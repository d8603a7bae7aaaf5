//! A world's state as bytes, little-endian: what it is made of, what has been chosen, and where everything is.

use hooke::{Balance, Ledger, Plane, Real};

use crate::code::{HookeCode, Outcome};
use crate::engine::{Choices, Engine, numbers, parameters_of};
use crate::method::MaybeLedger;
use crate::options::{HookeCollision, HookeHold, HookeStepper};

/// The first bytes; the last is the version of what follows.
const MAGIC: u64 = u64::from_le_bytes(*b"hooke\0\0\x01");
/// What comes before the particles, bytes: the width of a real, the counts, stepper, collision, whether there is a ledger,
/// whether steps may do without a factor; time, tolerance, gravity, and what the ledger has come to.
const HEADER: usize = 8 + 4 * (1 + 3 + 4) + 8 * (2 + 3 + 5);
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

    /// Where particles, springs and planes begin, and where all of it ends.
    fn bounds(self) -> [usize; 4] {
        let [particles, springs, planes] = self.counts;
        let first_spring = HEADER + particles as usize * self.particle();
        let first_plane = first_spring + springs as usize * self.spring();
        [HEADER, first_spring, first_plane, first_plane + planes as usize * self.plane()]
    }
}

/// A place in some bytes, to write from.
struct Writer<'a> {
    bytes: &'a mut [u8],
    place: usize,
    real: usize,
}

impl Writer<'_> {
    fn bits(&mut self, bits: u64, width: usize) {
        let end = self.place + width;
        let to = self.bytes.get_mut(self.place..end).unwrap_or_default();
        for (to, byte) in to.iter_mut().zip(bits.to_le_bytes()) {
            *to = byte;
        }
        self.place = end;
    }

    fn word(&mut self, word: u32) {
        self.bits(word.into(), 4);
    }

    fn number(&mut self, number: f64) {
        self.bits(number.to_bits(), 8);
    }

    fn numbers(&mut self, numbers: &[f64]) {
        for number in numbers {
            self.number(*number);
        }
    }

    fn reals(&mut self, reals: &[f64]) {
        for real in reals {
            // Exact: it was of that width.
            if self.real == 4 { self.word((*real as f32).to_bits()) } else { self.number(*real) }
        }
    }
}

/// A place in some bytes, to read from; 0 past their end.
#[derive(Clone, Copy)]
struct Reader<'a> {
    bytes: &'a [u8],
    place: usize,
    real: usize,
}

impl Reader<'_> {
    fn bits(&mut self, width: usize) -> u64 {
        let end = self.place + width;
        let bytes = self.bytes.get(self.place..end).unwrap_or_default();
        self.place = end;
        bytes.iter().rev().fold(0, |bits, byte| bits << 8 | u64::from(*byte))
    }

    fn word(&mut self) -> u32 {
        self.bits(4) as u32
    }

    fn number(&mut self) -> f64 {
        f64::from_bits(self.bits(8))
    }

    fn real(&mut self) -> f64 {
        if self.real == 4 { f32::from_bits(self.word()).into() } else { self.number() }
    }

    fn vector(&mut self) -> [f64; 3] {
        [self.real(), self.real(), self.real()]
    }

    /// Goes past so many reals, and tells whether all of them are finite and not below `least`.
    fn are_from(&mut self, least: f64, count: u32) -> bool {
        let mut are = true;
        for _ in 0..count {
            let real = self.real();
            are &= real >= least && real.is_finite();
        }
        are
    }
}

/// What comes before the particles, of a snapshot that fits the world.
struct Header {
    time: f64,
    choices: Choices,
    gravity: [f64; 3],
    ledger: Option<Balance>,
}

impl Header {
    fn read<R: Real>(from: &mut Reader<'_>, extents: Extents) -> Option<Self> {
        let is_ours = from.bits(8) == MAGIC
            && from.word() == extents.real as u32
            && extents.counts.iter().all(|count| from.word() == *count);
        let (stepper, collision) = (from.word(), from.word());
        let (has_ledger, may_do_without_factor) = (from.word() == 1, from.word() == 1);
        let (time, tolerance) = (from.number(), from.number());
        let gravity = [from.number(), from.number(), from.number()];
        let balance = Balance {
            lost_to_damping: from.number(),
            lost_in_impacts: from.number(),
            lost_to_sleep: from.number(),
            work_of_pins: from.number(),
            opened_with: from.number(),
            // The rest follows from the state.
            ..Balance::default()
        };
        let stepper = HookeStepper::numbered(stepper)?;
        let collision = HookeCollision::numbered(collision)?;
        let is_sound = time.is_finite()
            && tolerance > 0.0
            && tolerance.is_finite()
            // What a double holds may be past what the world does.
            && gravity.iter().all(|component| R::from_f64(*component).is_finite())
            && are_finite(&energies(&balance));
        let choices = Choices { stepper, collision, tolerance, may_do_without_factor };
        (is_ours && is_sound).then_some(Self { time, choices, gravity, ledger: has_ledger.then_some(balance) })
    }
}

impl<R: Real> Engine<R> {
    /// How many bytes a snapshot has.
    pub fn snapshot_size(&self) -> usize {
        let [.., end] = Extents::of(self).bounds();
        end
    }

    /// Writes one. What follows the state begins anew, so that the world moves from here to the bit as one does that the
    /// snapshot is put back into.
    pub fn snapshot(&mut self, bytes: &mut [u8]) -> Outcome {
        let extents = Extents::of(self);
        let [_, springs, planes, end] = extents.bounds();
        if bytes.len() != end {
            return Err(HookeCode::Length.into());
        }
        self.begin_anew();
        let mut to = Writer { bytes, place: 0, real: extents.real };
        self.write_header(&mut to, extents);
        for (number, [position, velocity]) in (0..).zip(self.states()) {
            to.reals(&position);
            to.reals(&velocity);
            to.word(if self.world.is_held(number) == Some(true) { HELD } else { 0 });
        }
        for (number, spring) in self.world.springs() {
            to.place = springs + number as usize * extents.spring();
            let [first, second] = spring.between;
            to.word(first);
            to.word(second);
            to.reals(&parameters_of(&spring));
        }
        to.place = planes;
        for plane in self.world.planes() {
            to.reals(&plane_numbers(plane));
        }
        Ok(())
    }

    fn write_header(&self, to: &mut Writer<'_>, extents: Extents) {
        // A ledger past all numbers is none, lest the snapshot be refused.
        let carried = self.carried.filter(|balance| are_finite(&energies(balance)));
        to.bits(MAGIC, 8);
        to.word(extents.real as u32);
        for count in extents.counts {
            to.word(count);
        }
        to.word(self.choices.stepper as u32);
        to.word(self.choices.collision as u32);
        to.word(carried.is_some().into());
        to.word(self.choices.may_do_without_factor.into());
        to.number(self.time());
        to.number(self.choices.tolerance);
        for component in self.world.gravity() {
            to.number(component.to_f64());
        }
        to.numbers(&energies(&carried.unwrap_or_default()));
    }

    /// Puts one back, of a world with the same particles, springs and planes.
    pub fn restore(&mut self, bytes: &[u8]) -> Outcome {
        let extents = Extents::of(self);
        let [particles, springs, planes, end] = extents.bounds();
        let [particle_count, _, plane_count] = extents.counts;
        let mut from = Reader { bytes, place: 0, real: extents.real };
        let header = Header::read::<R>(&mut from, extents).filter(|_| bytes.len() == end);
        let header = header.ok_or(HookeCode::Snapshot)?;
        let is_sound = (0..particle_count).all(|_| from.are_from(f64::MIN, 6) & (from.word() <= HELD))
            && self.has_springs(Reader { place: springs, ..from }, extents)
            && self.has_planes(Reader { place: planes, ..from });
        if !is_sound {
            return Err(HookeCode::Snapshot.into());
        }
        self.change_springs(&|number, parameters| {
            let place = springs + number as usize * extents.spring() + 8;
            *parameters = Reader { place, ..from }.vector();
        })?;
        from.place = planes;
        for plane in 0..plane_count {
            from.place += 4 * extents.real;
            self.set_restitution(plane, from.real())?;
        }
        from.place = particles;
        for number in 0..particle_count {
            let (position, velocity) = (from.vector(), from.vector());
            // A pinned particle is one that moves with the velocity 0.
            let hold = if from.word() == HELD { HookeHold::Kinematic } else { HookeHold::Free };
            self.set_hold(number, hold)?;
            self.set_position(number, &position)?;
            self.set_velocity(number, &velocity)?;
        }
        self.set_gravity(&header.gravity)?;
        self.world.set_time(header.time)?;
        self.choices = header.choices;
        self.carried = header.ledger;
        self.ledger = MaybeLedger(header.ledger.map(|_| Ledger::open(&self.world.view())));
        self.begin_anew_without_ledger();
        Ok(())
    }

    fn has_springs(&self, mut from: Reader<'_>, extents: Extents) -> bool {
        let first_place = from.place;
        self.world.springs().all(|(number, spring)| {
            from.place = first_place + number as usize * extents.spring();
            let (one, other) = (from.word(), from.word());
            let [first, second] = spring.between;
            // Which end comes first is no part of what a spring is.
            let is_between = (one == first && other == second) || (one == second && other == first);
            is_between && from.are_from(0.0, 3)
        })
    }

    fn has_planes(&self, mut from: Reader<'_>) -> bool {
        self.world.planes().iter().all(|plane| {
            let [x, y, z, offset, _] = plane_numbers(plane);
            let is_same = from.real() == x && from.real() == y && from.real() == z && from.real() == offset;
            is_same && (0.0..=1.0).contains(&from.real())
        })
    }
}

/// Normal, offset and restitution.
fn plane_numbers<R: Real>(plane: &Plane<R>) -> [f64; 5] {
    let [x, y, z] = numbers::<R>(plane.normal());
    [x, y, z, plane.offset().to_f64(), plane.restitution().to_f64()]
}

/// Those of a ledger's energies that do not follow from the state, in the order of the header.
fn energies(balance: &Balance) -> [f64; 5] {
    let Balance { lost_to_damping, lost_in_impacts, lost_to_sleep, work_of_pins, opened_with, .. } = *balance;
    [lost_to_damping, lost_in_impacts, lost_to_sleep, work_of_pins, opened_with]
}

fn are_finite(numbers: &[f64]) -> bool {
    numbers.iter().all(|number| number.is_finite())
}
