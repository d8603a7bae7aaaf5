//! How long the next steps are to be.

/// The part of the error asked for that steps of a method of this order are to use up. What is wrong for a moment, as a
/// rope is that snaps taut, is several times what stays wrong, and an error that has been made cannot be made good: with a
/// low order only a run that begins anew could, in much shorter steps.
pub(super) fn aim(order: u32) -> f64 {
    if order < 4 { 0.2 } else { 0.35 }
}

/// However much of it is used up already, the next steps may use this part.
const LEAST: f64 = 0.1;
/// Steps stay as they are while they are between these parts of what they could be: the methods that keep energy do so for
/// steps of one length.
const STEADY: (f64, f64) = (0.7, 1.1);
/// They change by so much at most, and so much at least, at a time.
const CHANGE: (f64, f64) = (0.7, 1.15);
/// What is left of the error asked for where a run goes back to shorten its steps, and by how much it shortens them.
const AFTER_GOING_BACK: f64 = 0.35;
const SHORTENED: (f64, f64) = (0.25, 0.7);

/// The time step of a run whose error is to be what was asked for at its end.
///
/// The error of a method of order p grows by c dtᵖ each second; c is what the error so far shows, whatever the steps were.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// s
    time_step: f64,
    /// s
    longest: f64,
    /// m
    asked: f64,
    /// The part of it that steps are to use up.
    aim: f64,
    order: f64,
    /// s
    duration: f64,
    /// s
    time: f64,
    /// ∫ dtᵖ, with the first step as the unit of dt.
    worked: f64,
    /// s
    unit: f64,
}

impl Pace {
    /// Steps of a method of that order over `duration` seconds, none longer than `longest` (s), for an error of `asked`
    /// metres at the end.
    #[must_use]
    pub fn new(time_step: f64, longest: f64, order: u32, asked: f64, duration: f64) -> Self {
        let unit = time_step.min(longest);
        let (aim, order) = (aim(order), f64::from(order.max(1)));
        Self { time_step: unit, longest, asked, aim, order, duration, time: 0.0, worked: 0.0, unit }
    }

    /// The length of the next step, s.
    #[must_use]
    pub fn time_step(&self) -> f64 {
        self.time_step
    }

    /// No step is to be longer than this, s, from here on.
    pub fn limit(&mut self, longest: f64) {
        self.longest = longest;
        self.time_step = self.time_step.min(longest);
    }

    /// Hears of the largest error (m) up to a time (s).
    pub fn hear(&mut self, error: f64, time: f64) {
        self.worked += (self.time_step / self.unit).powf(self.order) * (time - self.time);
        self.time = time;
        let left = (self.aim * self.asked - error).max(LEAST * self.asked);
        let rate = left / (self.duration - time).max(f64::MIN_POSITIVE);
        let possible = self.unit * (rate * self.worked / error).powf(1.0 / self.order);
        let part = self.time_step / possible.min(self.longest);
        if !(STEADY.0..=STEADY.1).contains(&part) {
            self.time_step = (self.time_step * (0.9 / part).clamp(CHANGE.0, CHANGE.1)).min(self.longest);
        }
    }

    /// Goes on from here after an error (m) in steps of `failed` seconds was more than was asked for.
    pub fn come_back(&mut self, error: f64, failed: f64) {
        let change = (AFTER_GOING_BACK * self.asked / error).powf(1.0 / self.order).clamp(SHORTENED.0, SHORTENED.1);
        self.time_step = failed * change;
        self.longest = self.longest.min(failed);
    }
}
