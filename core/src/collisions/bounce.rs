//! One particle between planes: where its path meets them, what a bounce does, and how it comes to rest.

use crate::Real;
use crate::contact::{Support, lies_on, resting, support, support_by, touching};
use crate::rounding::rounding;
use crate::types::Plane;
use crate::vectors::{across, along, dot, size};
use crate::world::System;

/// Bounces of one particle that are followed within one stretch of time; past them it is stopped on what it touches, and
/// stays there until the end of it.
///
/// An elastic particle in a wedge of angle θ bounces at most ⌈π/θ⌉ times between two visits to its depth; with gravity
/// and losses in a corner there can be infinitely many in a finite time, and only those on a single plane are summed.
pub const MOST_BOUNCES: u32 = 10_000;

/// Bounces shorter than this, in s, are too short to follow: in a corner there are infinitely many of them, and no
/// sum for them. At 10 m/s² they rise by 1e-16 m.
const SHORTEST_BOUNCE: f64 = 1e-8;

/// A particle that nothing but a constant acceleration moves.
#[derive(Clone, Copy, Debug)]
pub struct Flight<R> {
    /// m
    pub position: [R; 3],
    /// m/s
    pub velocity: [R; 3],
}

/// What happened on the way.
#[derive(Clone, Copy, Debug)]
pub struct Bounces {
    /// How many.
    pub hits: u32,
    /// Whether there were too many to follow.
    pub capped: bool,
    /// The kinetic energy lost, over the mass, m²/s².
    pub lost: f64,
}

/// The path x + τ v + β τ² a: β is ½ where it is exact, 0 or 1 where Euler draws it.
#[derive(Clone, Copy, Debug)]
pub struct Path<'a, R> {
    pub planes: &'a [Plane<R>],
    pub gravity: [R; 3],
    /// β
    pub curvature: R,
}

impl Bounces {
    pub const NONE: Self = Self { hits: 0, capped: false, lost: 0.0 };
}

impl<R: Real> Flight<R> {
    /// The state τ later, without planes.
    #[inline(always)]
    pub fn after(self, tau: R, acceleration: [R; 3], curvature: R) -> Self {
        let position = along(self.position, tau, along(self.velocity, curvature * tau, acceleration));
        Self { position, velocity: along(self.velocity, tau, acceleration) }
    }

    /// Takes the roundings since its velocity was `before` from a particle that lay on a plane then, if it still does.
    pub fn keep_on(&mut self, plane: &Plane<R>, before: [R; 3]) {
        if dot(plane.normal, self.velocity).abs() <= resting(before) + resting(self.velocity) {
            self.put_on(plane, R::ZERO);
        }
    }

    /// Gives it this normal velocity, and rounds its position to the plane that it has come to.
    ///
    /// A particle that started beyond the plane stays beyond it: a bounce does not move particles.
    #[cfg_attr(feature = "compact", inline(never))]
    #[cfg_attr(not(feature = "compact"), inline(always))]
    pub fn put_on(&mut self, plane: &Plane<R>, normal_velocity: R) {
        let gap = plane.gap(self.position);
        if gap.abs() <= R::from_f64(4.0) * touching(plane, self.position) {
            self.position = along(self.position, -gap, plane.normal);
        }
        self.velocity = along(across(self.velocity, plane.normal), normal_velocity, plane.normal);
    }
}

/// When c + v τ + b τ² first falls through 0 at a τ > 0, or at once if it is there and falling; c ≥ 0.
///
/// Neither form subtracts nearly equal numbers.
#[cfg_attr(feature = "compact", inline(never))]
#[cfg_attr(not(feature = "compact"), inline(always))]
pub fn first_contact<R: Real>(c: R, v: R, b: R) -> Option<R> {
    let two = R::from_f64(2.0);
    let discriminant = v * v - R::from_f64(4.0) * b * c;
    let root = discriminant.sqrt();
    // One division, and nothing that is skipped: loops over many particles vectorise.
    let comes = v < R::ZERO;
    let (over, under) = if comes { (two * c, root - v) } else { (v + root, -two * b) };
    let tau = over / under;
    ((discriminant >= R::ZERO) & (comes | (b < R::ZERO))).then_some(tau)
}

impl<'a, R: Real> Path<'a, R> {
    /// The path of a particle in free flight; a held one moves uniformly, through planes too.
    pub fn of(system: &System<'a, R>, slot: u32, curvature: R) -> Self {
        if system.is_dynamic(slot) {
            Self::of_dynamic(system, curvature)
        } else {
            Self { planes: &[], gravity: [R::ZERO; 3], curvature }
        }
    }

    /// The path of a particle that is not held, as is every one that has something due: held ones meet no planes.
    pub fn of_dynamic(system: &System<'a, R>, curvature: R) -> Self {
        Self { planes: system.planes, gravity: system.gravity, curvature }
    }

    /// What the planes that it lies on leave of gravity.
    pub fn acceleration(&self, flight: &Flight<R>) -> [R; 3] {
        support(self.planes, flight.position, flight.velocity, self.gravity).allow(self.gravity)
    }

    /// Flies for `duration` (s), bouncing.
    pub fn fly(&self, flight: &mut Flight<R>, duration: R) -> Bounces {
        let mut bounces = Bounces::NONE;
        let mut rest = duration;
        while bounces.hits < MOST_BOUNCES {
            bounces.lost += self.calm(flight);
            let a = self.acceleration(flight);
            let Some((tau, plane, _)) = self.next_hit(flight, a) else { break };
            if tau >= rest {
                break;
            }
            let (speed, impact) = self.impact(flight, tau, plane, a);
            bounces.hits += 1;
            rest -= tau;
            *flight = impact;
            match self.settling_time(plane, speed) {
                Some(settling) if settling <= rest && self.is_alone(flight, plane, settling) => {
                    // Infinitely many bounces fit into the rest of the time: it comes to rest at the end of them.
                    bounces.lost += half_square(speed);
                    self.settle(flight, plane, settling);
                    rest -= settling;
                }
                _ => {
                    let away = plane.restitution * speed;
                    bounces.lost += half_square(speed) - half_square(away);
                    flight.put_on(plane, away);
                }
            }
        }
        bounces.capped = bounces.hits == MOST_BOUNCES;
        if bounces.capped {
            // It stays there for the rest: nobody has looked what it would meet on the way.
            bounces.lost += self.stop(flight);
        } else {
            self.coast(flight, rest);
        }
        bounces
    }

    /// Flies for a time in which it meets no plane. What slides along planes stays on them: the roundings of millions of
    /// steps would else take it away, or where its sliding turns round, those of its fastest would look like a motion.
    fn coast(&self, flight: &mut Flight<R>, duration: R) {
        let before = *flight;
        let a = self.acceleration(&before);
        *flight = before.after(duration, a, self.curvature);
        for plane in self.planes {
            let leaves = dot(plane.normal, a) > rounding(size(self.gravity));
            if !leaves && lies_on(plane, before.position, before.velocity) {
                flight.keep_on(plane, before.velocity);
            }
        }
    }

    /// When the first plane is met, which one it is, and its number.
    pub fn next_hit(&self, flight: &Flight<R>, a: [R; 3]) -> Option<(R, &'a Plane<R>, u32)> {
        let mut first: Option<(R, &Plane<R>, u32)> = None;
        for (number, plane) in (0..).zip(self.planes) {
            if let Some(tau) = self.time_to(plane, flight, a)
                && first.is_none_or(|(earliest, ..)| tau < earliest)
            {
                first = Some((tau, plane, number));
            }
        }
        first
    }

    /// When a plane is met; nothing if it is not, or if the particle lies on it.
    #[cfg_attr(feature = "compact", inline(never))]
    #[cfg_attr(not(feature = "compact"), inline(always))]
    pub fn time_to(&self, plane: &Plane<R>, flight: &Flight<R>, a: [R; 3]) -> Option<R> {
        let gap = plane.gap(flight.position);
        let speed = dot(plane.normal, flight.velocity);
        let pull = dot(plane.normal, a);
        let still = resting(flight.velocity);
        let touches = gap <= touching(plane, flight.position);
        let contact = first_contact(gap.at_least(R::ZERO), speed, self.curvature * pull);
        // What lies on the plane, or slides along it, was held up there already: only a throw brings it back.
        let lies = touches & (speed <= still);
        if touches & (speed < -still) { Some(R::ZERO) } else { contact.filter(|_| !lies) }
    }

    /// The speed of the impact after τ, and the particle there: on the plane, unless it started beyond it by more than
    /// its way there may be rounded.
    #[cfg_attr(feature = "compact", inline(never))]
    #[cfg_attr(not(feature = "compact"), inline(always))]
    pub fn impact(&self, flight: &Flight<R>, tau: R, plane: &Plane<R>, a: [R; 3]) -> (R, Flight<R>) {
        let mut there = flight.after(tau, a, self.curvature);
        let half = R::from_f64(0.5);
        let beyond = -plane.gap(flight.position);
        if tau > R::ZERO && beyond <= touching(plane, flight.position) + rounding(tau * size(flight.velocity)) {
            there.position = along(there.position, -plane.gap(there.position), plane.normal);
        }
        if self.curvature == half && tau > R::ZERO {
            // From the energy, not as a difference of velocities.
            let (v, pull) = (dot(plane.normal, flight.velocity), dot(plane.normal, a));
            let gap = plane.gap(flight.position).at_least(R::ZERO);
            return ((v * v - R::from_f64(2.0) * pull * gap).at_least(R::ZERO).sqrt(), there);
        }
        ((-dot(plane.normal, there.velocity)).at_least(R::ZERO), there)
    }

    /// Takes from a particle that is pressed against planes the velocities with which it would rise no further from them,
    /// or dent them no deeper, than positions are rounded, or than gravity takes them in [`SHORTEST_BOUNCE`]. Returns the
    /// kinetic energy lost, over the mass.
    pub fn calm(&self, flight: &mut Flight<R>) -> f64 {
        let held = support_by(self.planes, self.gravity, |plane| self.calms(plane, flight));
        if held == Support::None {
            return 0.0;
        }
        let before = dot(flight.velocity, flight.velocity);
        flight.velocity = held.allow(flight.velocity);
        0.5 * (before - dot(flight.velocity, flight.velocity)).to_f64()
    }

    /// Whether a particle is at a plane and leaves it, or dents it, by no more than that.
    #[inline(always)]
    pub fn calms(&self, plane: &Plane<R>, flight: &Flight<R>) -> bool {
        let speed = dot(plane.normal, flight.velocity);
        let press = -dot(plane.normal, self.gravity);
        let shortest = R::from_f64(SHORTEST_BOUNCE);
        let reach = touching(plane, flight.position).at_least(press * shortest * shortest);
        // An elastic one rises for ever by whatever it rises, if positions can tell it at all.
        let least = (R::EPSILON * size(flight.position)).at_least(press * shortest * shortest);
        let rise = if plane.restitution < R::ONE { reach } else { least };
        // In a corner it may be the other planes, not gravity, that press it against this one.
        let still = speed.abs() <= shortest * size(self.gravity);
        (plane.gap(flight.position) <= reach) & (still | (speed * speed <= R::from_f64(2.0) * press * rise))
    }

    /// How long the bounces after an impact of this speed go on: 2 e u/(|g_n| (1 − e)); nothing if they never end.
    ///
    /// On a path that is not exact there is no such sum, and only a particle that does not bounce at all settles.
    #[inline(always)]
    pub fn settling_time(&self, plane: &Plane<R>, speed: R) -> Option<R> {
        let press = -dot(plane.normal, self.gravity);
        let exact = self.curvature == R::from_f64(0.5);
        let losing = plane.restitution < R::ONE;
        if !(press > R::ZERO && losing && (exact || plane.restitution == R::ZERO)) {
            return None;
        }
        let away = plane.restitution * speed;
        Some(R::from_f64(2.0) * away / (press * (R::ONE - plane.restitution)))
    }

    /// Whether no other plane is met while it bounces on this one for so long: neither on its way along the plane nor
    /// as high as the first of the bounces takes it.
    pub fn is_alone(&self, flight: &Flight<R>, plane: &Plane<R>, settling: R) -> bool {
        let mut sliding = *flight;
        sliding.put_on(plane, R::ZERO);
        let supported = Support::Normal(plane.normal);
        let a = supported.allow(self.gravity);
        let pull = dot(plane.normal, self.gravity).abs();
        // No bounce rises above the height that half the settling time would fall through.
        let height = R::from_f64(0.125) * pull * settling * settling;
        self.planes.iter().filter(|other| !core::ptr::eq(*other, plane)).all(|other| {
            let lift = height * dot(other.normal, plane.normal).at_most(R::ZERO);
            let gap = other.gap(sliding.position) + lift;
            let speed = dot(other.normal, sliding.velocity);
            gap > touching(other, sliding.position)
                && first_contact(gap, speed, self.curvature * dot(other.normal, a)).is_none_or(|tau| tau > settling)
        })
    }

    /// Comes to rest on a plane, sliding along it meanwhile.
    pub fn settle(&self, flight: &mut Flight<R>, plane: &Plane<R>, settling: R) {
        flight.put_on(plane, R::ZERO);
        let a = Support::Normal(plane.normal).allow(self.gravity);
        *flight = flight.after(settling, a, self.curvature);
        flight.put_on(plane, R::ZERO);
    }

    /// Stops it on the planes that it touches. Returns the kinetic energy lost, over the mass.
    pub fn stop(&self, flight: &mut Flight<R>) -> f64 {
        let before = dot(flight.velocity, flight.velocity).to_f64();
        for plane in self.planes {
            if plane.gap(flight.position) <= touching(plane, flight.position)
                && dot(plane.normal, flight.velocity) != R::ZERO
            {
                flight.put_on(plane, R::ZERO);
            }
        }
        0.5 * (before - dot(flight.velocity, flight.velocity).to_f64())
    }
}

/// ½ u², exactly rounded in `f64`.
#[inline(always)]
pub fn half_square<R: Real>(speed: R) -> f64 {
    0.5 * speed.to_f64() * speed.to_f64()
}
