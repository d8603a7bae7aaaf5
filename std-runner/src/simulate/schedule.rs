//! When steps end, and when frames are taken.

/// Times that differ by less than this part of a step are the same.
const SAME: f64 = 1e-9;

/// Up to here, every whole number is an `f64`: the time of a step or a frame is told apart from the one before.
pub const MOST: u64 = 1 << 53;

/// The steps and the frames of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schedule {
    duration: f64,
    frame_rate: f64,
    /// Nothing where each frame is a step.
    time_step: Option<f64>,
    steps: u64,
    frames: u64,
}

impl Schedule {
    /// Steps of `time_step` seconds, the last one shorter if the duration is not a whole number of them; without a time
    /// step, one from each frame to the next. Frames at every 1/`frame_rate` seconds and at the end.
    #[must_use]
    pub fn new(duration: f64, time_step: Option<f64>, frame_rate: f64) -> Self {
        let frames = parts(duration * frame_rate).saturating_add(1);
        let steps = time_step.map_or(frames - 1, |time_step| parts(duration / time_step));
        Self { duration, frame_rate, time_step, steps, frames }
    }

    /// Whether it has at most [`MOST`] steps and frames. One that has more never ends.
    #[must_use]
    pub fn is_countable(&self) -> bool {
        self.steps.max(self.frames) <= MOST
    }

    /// How many steps there are.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.steps
    }

    /// How many frames there are, the start included.
    #[must_use]
    pub fn frames(&self) -> u64 {
        self.frames
    }

    /// When a step ends, s; step 0 ends at the start.
    #[must_use]
    pub fn step_end(&self, step: u64) -> f64 {
        match self.time_step {
            Some(_) if step == self.steps => self.duration,
            Some(time_step) => step as f64 * time_step,
            None => self.frame_time(step),
        }
    }

    /// How long a step is, s.
    #[must_use]
    pub fn step_length(&self, step: u64) -> f64 {
        match self.time_step {
            Some(time_step) if step < self.steps || self.short_step().is_none() => time_step,
            _ => self.step_end(step) - self.step_end(step.saturating_sub(1)),
        }
    }

    /// The length of the last step if it is shorter than the others, s.
    #[must_use]
    pub fn short_step(&self) -> Option<f64> {
        let time_step = self.time_step?;
        let last = self.duration - (self.steps - 1) as f64 * time_step;
        (last < time_step * (1.0 - SAME * self.steps as f64)).then_some(last)
    }

    /// When a frame is taken, s.
    #[must_use]
    pub fn frame_time(&self, frame: u64) -> f64 {
        if frame + 1 >= self.frames { self.duration } else { frame as f64 / self.frame_rate }
    }

    /// Whether there is such a frame before the end of a step: not at it, up to rounding.
    #[must_use]
    pub fn is_before_end(&self, frame: u64, step: u64) -> bool {
        frame < self.frames && self.frame_time(frame) < self.step_end(step) - SAME * self.step_length(step)
    }

    /// Whether there is such a frame at the end of a step, up to rounding.
    #[must_use]
    pub fn is_at_end(&self, frame: u64, step: u64) -> bool {
        frame < self.frames && (self.frame_time(frame) - self.step_end(step)).abs() <= SAME * self.step_length(step)
    }
}

/// How many whole parts and a rest a ratio is; a rest that is only rounding does not count.
fn parts(ratio: f64) -> u64 {
    let nearest = ratio.round();
    let whole = if (ratio - nearest).abs() <= SAME * ratio.max(1.0) { nearest } else { ratio.ceil() };
    (whole as u64).max(1)
}
