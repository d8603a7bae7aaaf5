//! What every peer does when it is asked.

use std::error::Error;

use rustix::time::{ClockId, clock_gettime};

/// A run from the start of the scene.
#[derive(Clone, Copy, Debug, serde::Deserialize)]
pub struct Request {
    /// The time step, s, or the tolerance of a method that chooses its steps.
    pub setting: f64,
    /// s
    pub duration: f64,
    /// Whether the positions are wanted.
    #[serde(default)]
    pub state: bool,
}

impl Request {
    /// Of a peer whose setting is a time step.
    pub fn steps(&self) -> usize {
        (self.duration / self.setting).round() as usize
    }
}

/// How a run went.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Outcome {
    /// Of this process, s.
    pub cpu: f64,
    /// x, y, z of each particle, m.
    pub position: Vec<f64>,
}

/// Something that runs a scene.
pub trait Peer {
    /// Starts the scene anew and runs it; only the running is timed.
    fn run(&mut self, request: &Request) -> Result<Outcome, Box<dyn Error>>;
}

/// The processor time that `work` took, s, and what it gave.
pub fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = processor_time();
    let made = work();
    (processor_time() - start, made)
}

fn processor_time() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}
