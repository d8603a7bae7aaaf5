//! Which planes a tile of particles can meet: the others are not tested, particle by particle.

use core::ops::Range;

use crate::Real;
use crate::lanes::{self, Kernel, Present, Set};
use crate::rounding::rounding;
use crate::types::Plane;
use crate::vectors::{Columns, read, triples, window};
use crate::world::State;

/// Boxes that are grown at once, one a lane: the largest and the smallest of many are found lane by lane.
const LANES: usize = 16;

/// The box that particles stay in during a step: through their positions at its ends, and what the paths between them
/// may bend out of it.
#[derive(Clone, Copy, Debug)]
pub struct Reach<R> {
    low: [R; 3],
    high: [R; 3],
    /// |x' − x − dt·v| at most.
    bend: [R; 3],
}

impl<R: Real> Reach<R> {
    /// Of particles that stay where they are.
    pub fn at(lanes: Present, position: Columns<'_, R>, slots: Range<u32>) -> Self {
        lanes::run(lanes, Enclose(window(position, slots)))
    }

    /// Of particles on parabolas from one state to the other, `dt` seconds later.
    pub fn between(lanes: Present, from: &State<'_, R>, to: &State<'_, R>, dt: R, slots: Range<u32>) -> Self {
        let [from_position, velocity, to] =
            [&from.position, &from.velocity, &to.position].map(|columns| window(read(columns), slots.clone()));
        lanes::run(lanes, Grow { from: from_position, velocity, to, dt })
    }

    /// Whether any of them may come to touch a plane. If not, none is near enough for roundings to matter.
    pub fn may_meet(&self, plane: &Plane<R>) -> bool {
        let quarter = R::from_f64(0.25);
        let (mut lowest, mut size) = (-plane.offset, plane.offset.abs());
        let corners = self.low.into_iter().zip(self.high).zip(self.bend);
        for (n, ((low, high), bend)) in plane.normal.into_iter().zip(corners) {
            // A parabola through both ends of a chord is at most a quarter of its bend away from it.
            lowest += if n > R::ZERO { n * low } else { n * high } - n.abs() * quarter * bend;
            size += low.abs().at_least(high.abs());
        }
        // Not below and not NaN.
        let clear = lowest > R::from_f64(8.0) * rounding(size);
        !clear
    }
}

/// The box around points.
struct Enclose<'a, R>(Columns<'a, R>);

impl<R: Real> Kernel for Enclose<'_, R> {
    type Output = Reach<R>;

    #[inline(always)]
    fn run(self, _set: impl Set) -> Reach<R> {
        let mut reach = Reach { low: [R::INFINITY; 3], high: [-R::INFINITY; 3], bend: [R::ZERO; 3] };
        for (column, (low, high)) in self.0.into_iter().zip(reach.low.iter_mut().zip(&mut reach.high)) {
            let mut lows = [R::INFINITY; LANES];
            let mut highs = [-R::INFINITY; LANES];
            let (chunks, rest) = column.as_chunks::<LANES>();
            for chunk in chunks {
                enclose(&mut lows, &mut highs, chunk);
            }
            enclose(&mut lows, &mut highs, rest);
            (*low, *high) = (least(lows), most(highs));
        }
        reach
    }
}

/// Of all lanes.
#[inline(always)]
fn least<R: Real>(lanes: [R; LANES]) -> R {
    lanes.into_iter().fold(R::INFINITY, R::at_most)
}

/// Of all lanes.
#[inline(always)]
fn most<R: Real>(lanes: [R; LANES]) -> R {
    lanes.into_iter().fold(-R::INFINITY, R::at_least)
}

/// Lane by lane.
#[inline(always)]
fn enclose<R: Real>(lows: &mut [R], highs: &mut [R], points: &[R]) {
    for ((low, high), point) in lows.iter_mut().zip(highs).zip(points) {
        *low = low.at_most(*point);
        *high = high.at_least(*point);
    }
}

struct Grow<'a, R> {
    from: Columns<'a, R>,
    velocity: Columns<'a, R>,
    to: Columns<'a, R>,
    dt: R,
}

impl<R: Real> Kernel for Grow<'_, R> {
    type Output = Reach<R>;

    #[inline(always)]
    fn run(self, _set: impl Set) -> Reach<R> {
        let Self { from, velocity, to, dt } = self;
        let mut reach = Reach { low: [R::INFINITY; 3], high: [-R::INFINITY; 3], bend: [R::ZERO; 3] };
        let axes = from.into_iter().zip(velocity).zip(to);
        let boxes = reach.low.iter_mut().zip(&mut reach.high).zip(&mut reach.bend);
        for (((from, velocity), to), ((low, high), bend)) in axes.zip(boxes) {
            let mut lows = [R::INFINITY; LANES];
            let mut highs = [-R::INFINITY; LANES];
            let mut bends = [R::ZERO; LANES];
            let (from_chunks, from_rest) = from.as_chunks::<LANES>();
            let (velocity_chunks, velocity_rest) = velocity.as_chunks::<LANES>();
            let (to_chunks, to_rest) = to.as_chunks::<LANES>();
            for ((from, velocity), to) in from_chunks.iter().zip(velocity_chunks).zip(to_chunks) {
                grow(&mut lows, &mut highs, &mut bends, [from, velocity, to], dt);
            }
            grow(&mut lows, &mut highs, &mut bends, [from_rest, velocity_rest, to_rest], dt);
            (*low, *high, *bend) = (least(lows), most(highs), most(bends));
        }
        reach
    }
}

#[inline(always)]
fn grow<R: Real>(lows: &mut [R], highs: &mut [R], bends: &mut [R], [from, velocity, to]: [&[R]; 3], dt: R) {
    enclose(lows, highs, from);
    enclose(lows, highs, to);
    for (bend, [from, velocity, to]) in bends.iter_mut().zip(triples([from, velocity, to])) {
        *bend = bend.at_least((to - from - dt * velocity).abs());
    }
}
