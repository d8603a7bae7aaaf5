//! What is watched while a scene runs: its energy, and what happens at planes.

use std::sync::{Arc, Mutex, PoisonError};

use hooke::Balance;

use super::bounces::{Bounces, OnPlanes};
use super::probe::Eye;
use crate::model::Model;
use crate::record::{Frame, Sample};
use crate::scene::Settings;
use crate::simulate::Progress;

/// What was seen.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    /// What the integrator has added to the energy (lost, if negative) at each checkpoint, J.
    pub energy: Vec<f64>,
    /// The most kinetic energy at a checkpoint, J.
    pub kinetic: f64,
    /// What happened at planes; nothing without any.
    pub bounces: Option<Bounces>,
}

impl Seen {
    /// The largest size of what was added to the energy, or lost, J.
    #[must_use]
    pub fn energy_residual(&self) -> f64 {
        self.energy
            .iter()
            .fold(0.0, |largest, residual| if residual.is_nan() { f64::INFINITY } else { residual.abs().max(largest) })
    }
}

pub(super) struct Watch {
    duration: f64,
    checkpoints: u64,
    energy: Mutex<Seen>,
    /// When hits cut steps, s, in order.
    cuts: Mutex<Vec<f64>>,
    planes: Arc<Mutex<OnPlanes>>,
    has_planes: bool,
}

impl Watch {
    pub(super) fn new(model: &Model, settings: &Settings, checkpoints: u64) -> Self {
        Self {
            duration: settings.duration,
            checkpoints,
            energy: Mutex::default(),
            cuts: Mutex::default(),
            planes: Arc::new(Mutex::new(OnPlanes::new(model, settings))),
            has_planes: !model.planes.is_empty(),
        }
    }

    /// What is to see each frame.
    pub(super) fn on_planes(&self) -> impl Eye + use<> {
        Shared(Arc::clone(&self.planes))
    }

    pub(super) fn seen(&self) -> Seen {
        let mut seen = std::mem::take(&mut *self.energy.lock().unwrap_or_else(PoisonError::into_inner));
        if self.has_planes {
            let cuts = self.cuts.lock().unwrap_or_else(PoisonError::into_inner);
            seen.bounces = Some(self.planes.lock().unwrap_or_else(PoisonError::into_inner).take(&cuts));
        }
        seen
    }
}

struct Shared(Arc<Mutex<OnPlanes>>);

impl Eye for Shared {
    fn see<R: Sample>(&mut self, frame: &Frame<'_, R>) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).see(frame);
    }
}

impl Progress for Watch {
    fn reached(&self, _time: f64, _duration: f64) {}

    fn cut(&self, times: &mut dyn Iterator<Item = f64>) {
        if self.has_planes {
            self.cuts.lock().unwrap_or_else(PoisonError::into_inner).extend(times);
        }
    }

    fn balanced(&self, time: f64, balance: &mut dyn FnMut() -> Balance) {
        let mut seen = self.energy.lock().unwrap_or_else(PoisonError::into_inner);
        let next = (seen.energy.len() + 1) as f64 * self.duration / self.checkpoints as f64;
        // A checkpoint may lie a rounding after the end of its step.
        if time >= next * (1.0 - 1e-9) {
            let balance = balance();
            seen.energy.push(balance.remainder());
            seen.kinetic = seen.kinetic.max(balance.kinetic);
        }
    }
}
