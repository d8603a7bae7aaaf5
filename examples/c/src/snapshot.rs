//! A world's state as bytes, little-endian: what it is made of, what has been chosen, and where everything is.

use hooke::{Balance, Ledger, Plane, Real};

use crate::code::{HookeCode, Outcome};
use crate::engine::{Choices, Engine, numbers, parameters_of};
use crate::method::MaybeLedger;
use crate::options::{HookeCollision, HookeHold, HookeStepper};

/// The first bytes; the last is the version of what follows.
const MAGIC: u64 = u64::from_le_bytes(*b"hooke\0\0\x01");
/// What comes before the particles, bytes.
const HEADER: usize = size_of::<Header>();
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
    real: usize,
}

impl Writer<'_> {
    fn bits(&mut self, bits: u64, width: usize) {
        let (to, rest) = core::mem::take(&mut self.bytes).split_at_mut_checked(width).unwrap_or_default();
        for (to, byte) in to.iter_mut().zip(bits.to_le_bytes()) {
            *to = byte;
        }
        self.bytes = rest;
    }

    fn words(&mut self, words: &[u32]) {
        for word in words {
            self.bits((*word).into(), 4);
        }
    }

    fn reals(&mut self, reals: &[f64]) {
        for real in reals {
            // Exact: it was of that width.
            let bits = if self.real == 4 { (*real as f32).to_bits().into() } else { real.to_bits() };
            self.bits(bits, self.real);
        }
    }

    /// From so many bytes further on.
    fn at(&mut self, start: usize) -> Writer<'_> {
        Writer { bytes: self.bytes.get_mut(start..).unwrap_or_default(), real: self.real }
    }
}

/// A place in some bytes, to read from; 0 past their end.
#[derive(Clone, Copy)]
struct Reader<'a> {
    bytes: &'a [u8],
    real: usize,
}

impl Reader<'_> {
    fn bits(&mut self, width: usize) -> u64 {
        let (bytes, rest) = self.bytes.split_at_checked(width).unwrap_or_default();
        self.bytes = rest;
        bytes.iter().rev().fold(0, |bits, byte| bits << 8 | u64::from(*byte))
    }

    fn word(&mut self) -> u32 {
        self.bits(4) as u32
    }

    fn real(&mut self) -> f64 {
        let bits = self.bits(self.real);
        if self.real == 4 { f32::from_bits(bits as u32).into() } else { f64::from_bits(bits) }
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

    /// From so many bytes further on.
    fn at(self, start: usize) -> Self {
        Self { bytes: self.bytes.get(start..).unwrap_or_default(), ..self }
    }
}

/// What comes before the particles.
struct Header {
    magic: u64,
    /// The width of a real, the counts, stepper, collision, whether there is a ledger, whether steps may do without a factor.
    words: [u32; 1 + 3 + 4],
    /// Time, tolerance, gravity, and what the ledger has come to.
    numbers: [f64; 2 + 3 + 5],
}

impl Header {
    fn of<R: Real>(engine: &Engine<R>, extents: Extents) -> Self {
        let [particles, springs, planes] = extents.counts;
        let Choices { stepper, collision, tolerance, may_do_without_factor } = engine.choices;
        // A ledger past all numbers is none, lest the snapshot be refused.
        let carried = engine.carried.filter(|balance| are_finite(&energies(balance)));
        let [x, y, z] = engine.world.gravity();
        let [damping, impacts, sleep, pins, opened_with] = energies(&carried.unwrap_or_default());
        let (x, y, z) = (x.to_f64(), y.to_f64(), z.to_f64());
        Self {
            magic: MAGIC,
            words: [
                extents.real as u32,
                particles,
                springs,
                planes,
                stepper as u32,
                collision as u32,
                carried.is_some().into(),
                may_do_without_factor.into(),
            ],
            numbers: [engine.time(), tolerance, x, y, z, damping, impacts, sleep, pins, opened_with],
        }
    }

    fn write(&self, to: Writer<'_>) {
        let mut to = Writer { real: 8, ..to };
        to.bits(self.magic, 8);
        to.words(&self.words);
        to.reals(&self.numbers);
    }

    fn read(from: Reader<'_>) -> Self {
        let mut from = Reader { real: 8, ..from };
        let mut header = Self { magic: from.bits(8), words: [0; 8], numbers: [0.0; 10] };
        for word in &mut header.words {
            *word = from.word();
        }
        for number in &mut header.numbers {
            *number = from.real();
        }
        header
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
        let [particles, springs, planes, end] = extents.bounds();
        if bytes.len() != end {
            return Err(HookeCode::Length.into());
        }
        self.begin_anew();
        let mut all = Writer { bytes, real: extents.real };
        Header::of(self, extents).write(all.at(0));
        let mut to = all.at(particles);
        for (number, [position, velocity]) in (0..).zip(self.states()) {
            to.reals(&position);
            to.reals(&velocity);
            to.words(&[if self.world.is_held(number) == Some(true) { HELD } else { 0 }]);
        }
        for (number, spring) in self.world.springs() {
            let mut to = all.at(springs + number as usize * extents.spring());
            to.words(&spring.between);
            to.reals(&parameters_of(&spring));
        }
        let mut to = all.at(planes);
        for plane in self.world.planes() {
            to.reals(&plane_numbers(plane));
        }
        Ok(())
    }

    /// Puts one back, of a world with the same particles, springs and planes.
    pub fn restore(&mut self, bytes: &[u8]) -> Outcome {
        let extents = Extents::of(self);
        let [particles, springs, planes, end] = extents.bounds();
        let all = Reader { bytes, real: extents.real };
        let (mut particles, springs, mut planes) = (all.at(particles), all.at(springs), all.at(planes));
        let header = Header::read(all);
        let [real, particle_count, spring_count, plane_count, stepper, collision, has_ledger, without_factor] =
            header.words;
        let [time, tolerance, x, y, z, damping, impacts, sleep, pins, opened_with] = header.numbers;
        let (stepper, collision) = (HookeStepper::numbered(stepper), HookeCollision::numbered(collision));
        let (Some(stepper), Some(collision)) = (stepper, collision) else { return Err(HookeCode::Snapshot.into()) };
        let is_ours = [particle_count, spring_count, plane_count].iter().zip(&extents.counts).all(|(a, b)| a == b);
        let is_sound = header.magic == MAGIC
            && real == extents.real as u32
            && is_ours
            && bytes.len() == end
            && are_finite(&header.numbers)
            && tolerance > 0.0
            // What a double holds may be past what the world does.
            && [x, y, z].iter().all(|component| R::from_f64(*component).is_finite())
            && are_states(particles, particle_count)
            && self.has_springs(springs, extents)
            && self.has_planes(planes);
        if !is_sound {
            return Err(HookeCode::Snapshot.into());
        }
        self.change_springs(&|number, parameters| {
            *parameters = springs.at(number as usize * extents.spring() + 8).vector();
        })?;
        for plane in 0..plane_count {
            planes = planes.at(4 * extents.real);
            self.set_restitution(plane, planes.real())?;
        }
        for number in 0..particle_count {
            let (position, velocity) = (particles.vector(), particles.vector());
            // A pinned particle is one that moves with the velocity 0.
            let hold = if particles.word() == HELD { HookeHold::Kinematic } else { HookeHold::Free };
            self.set_hold(number, hold)?;
            self.set_position(number, &position)?;
            self.set_velocity(number, &velocity)?;
        }
        self.set_gravity(&[x, y, z])?;
        self.world.set_time(time)?;
        self.choices = Choices { stepper, collision, tolerance, may_do_without_factor: without_factor == 1 };
        let carried = Balance {
            lost_to_damping: damping,
            lost_in_impacts: impacts,
            lost_to_sleep: sleep,
            work_of_pins: pins,
            opened_with,
            // The rest follows from the state.
            ..Balance::default()
        };
        self.carried = (has_ledger == 1).then_some(carried);
        self.ledger = MaybeLedger(self.carried.map(|_| Ledger::open(&self.world.view())));
        self.begin_anew_without_ledger();
        Ok(())
    }

    fn has_springs(&self, springs: Reader<'_>, extents: Extents) -> bool {
        self.world.springs().all(|(number, spring)| {
            let mut from = springs.at(number as usize * extents.spring());
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
            let is_same = [x, y, z, offset].iter().fold(true, |is_same, number| is_same & (from.real() == *number));
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

fn are_states(mut from: Reader<'_>, count: u32) -> bool {
    (0..count).all(|_| from.are_from(f64::MIN, 6) & (from.word() <= HELD))
}
