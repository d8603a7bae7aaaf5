//! One of the two runs of a pair.

use std::ops::Range;

use hooke::{Real, StepError, StepReport};

use super::frames::Frames;
use super::quintic::Knot;
use crate::model::Model;
use crate::scene::Settings;
use crate::simulate::{Audit, BuildError, HeapWorld, Stepped, Threads, Tracks, Walk, world_with};

/// A world, what steps it, and how far it has come.
pub(super) struct Side<'a, R: Stepped> {
    pub(super) world: HeapWorld<R>,
    pub(super) walk: Walk<'a, R>,
    pub(super) time: f64,
    settings: Settings,
    size: f64,
    tracks: &'a Tracks<'a>,
    threads: Option<&'a Threads>,
}

/// Where one can come back to.
pub(super) struct Saved<R: Stepped> {
    world: HeapWorld<R>,
    audit: Option<Audit>,
    pub(super) time: f64,
}

impl<'a, R: Stepped> Side<'a, R> {
    pub(super) fn new(
        model: &Model,
        settings: Settings,
        tracks: &'a Tracks<'a>,
        threads: Option<&'a Threads>,
        ledger: bool,
    ) -> Result<Self, BuildError> {
        let mut world = world_with::<R>(model, &settings)?;
        let audit = ledger.then(|| Audit::open(&world.view()));
        let walk = Walk::new(&settings, model.size(), audit, threads);
        Ok(Self { world, walk, time: 0.0, settings, size: model.size(), tracks, threads })
    }

    /// One step up to a time, s.
    pub(super) fn step(&mut self, to: f64, count: &mut dyn FnMut(&StepReport)) -> Result<(), StepError> {
        let span = self.time..to;
        self.walk.step(&mut self.world, self.tracks, span.clone(), to - self.time, count)?;
        self.time = to;
        Ok(())
    }

    /// Whether prescribed motion changes its direction within a span of time (s).
    pub(super) fn has_keys_in(&self, span: &Range<f64>) -> bool {
        self.tracks.stops(span.start, span.end).len() > 1
    }

    pub(super) fn save(&self) -> Saved<R> {
        Saved { world: self.world.clone(), audit: self.walk.audit.clone(), time: self.time }
    }

    pub(super) fn restore(&mut self, saved: &Saved<R>) {
        self.world = saved.world.clone();
        self.time = saved.time;
        self.walk = Walk::new(&self.settings, self.size, saved.audit.clone(), self.threads);
    }

    /// A run of its own from here, which leaves this one as it is.
    pub(super) fn branch(&self) -> Self {
        Self {
            world: self.world.clone(),
            walk: Walk::new(&self.settings, self.size, None, self.threads),
            time: self.time,
            settings: self.settings.clone(),
            size: self.size,
            tracks: self.tracks,
            threads: self.threads,
        }
    }

    /// All particles, in the order of their numbers.
    pub(super) fn knots(&mut self, into: &mut Vec<Knot>) {
        into.clear();
        let mut view = self.world.view();
        into.extend(view.states().map(|(position, velocity)| Knot {
            position: wide::<R>(position),
            velocity: wide::<R>(velocity),
            acceleration: [0.0; 3],
        }));
        for (knot, acceleration) in into.iter_mut().zip(view.accelerations()) {
            knot.acceleration = wide::<R>(acceleration);
        }
    }

    /// A frame of it as it is.
    pub(super) fn show(&mut self, frames: &mut Frames<R::Coordinate>) {
        frames.hold(self.world.view().states().map(|(x, v)| (wide::<R>(x), wide::<R>(v))));
    }

    /// Where all particles are (m), in the order of their numbers.
    pub(super) fn positions(&mut self, into: &mut Vec<[f64; 3]>) {
        into.clear();
        into.extend(self.world.view().states().map(|(position, _)| wide::<R>(position)));
    }
}

/// A vector in `f64`.
pub(super) fn wide<R: Stepped>(vector: R::Vec3) -> [f64; 3] {
    let components: [R::Coordinate; 3] = vector.into();
    components.map(Real::to_f64)
}
