//! The worlds: small enough for a microcontroller, and everything that a step may meet is in one of them.

use hooke::{Hold, Real};

use crate::build::{Builder, Built, Room};
use crate::row::Scene;

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];
const STILL: [f64; 3] = [0.0; 3];
/// A slope of 3 in 4.
const SLOPE: [f64; 3] = [3.0, 0.0, 4.0];

impl Scene {
    /// How many steps it is followed.
    #[must_use]
    pub const fn steps(self) -> u32 {
        match self {
            Self::Rope | Self::Everything => 40,
            Self::Cloth | Self::Stiff => 4,
            Self::Block => 12,
            Self::Balls => 150,
            Self::Mesh => 20,
            Self::Sleepers => 60,
        }
    }

    /// The length of each, s.
    #[must_use]
    pub const fn time_step(self) -> f64 {
        match self {
            Self::Balls => 4e-3,
            _ => 2e-3,
        }
    }

    /// Its world at the start.
    pub(crate) fn build<R: Real>(self) -> Built<R, Room<R>> {
        let mut builder = Builder::new(GRAVITY)?;
        match self {
            Self::Rope => rope(&mut builder, 400.0, 0.05)?,
            Self::Stiff => rope(&mut builder, 1e5, 0.0)?,
            Self::Cloth => cloth(&mut builder)?,
            Self::Block => block(&mut builder)?,
            Self::Balls => balls(&mut builder)?,
            Self::Mesh => mesh(&mut builder)?,
            Self::Everything => everything(&mut builder)?,
            Self::Sleepers => sleepers(&mut builder)?,
        }
        Ok(builder.world)
    }
}

fn rope<R: Real>(builder: &mut Builder<R>, stiffness: f64, damping: f64) -> Built<R> {
    for number in 0..24 {
        let along = f64::from(number) / 23.0;
        let hold = if number == 0 { Hold::Pinned } else { Hold::Free };
        builder.particle([along, 0.1 * along * along, 1.0], [0.0, 0.3, -1.5 * along], 0.01, hold)?;
    }
    for number in 1..24 {
        builder.spring([number - 1, number], stiffness, damping, 1.02)?;
    }
    builder.plane([1.0, 0.0, 0.95], SLOPE, 0.6)
}

fn cloth<R: Real>(builder: &mut Builder<R>) -> Built<R> {
    const WIDTH: u32 = 17;
    const HEIGHT: u32 = 16;
    for v in 0..HEIGHT {
        for u in 0..WIDTH {
            let [x, y] = [u, v].map(|index| 0.05 * f64::from(index));
            let hold = if v == 0 && (u == 0 || u == WIDTH - 1) { Hold::Pinned } else { Hold::Free };
            builder.particle([x, y, 1.0 + 0.02 * x * y], [0.1 * y, 0.0, -0.8 * y], 0.01, hold)?;
        }
    }
    let all = || (0..HEIGHT).flat_map(|v| (0..WIDTH).map(move |u| (u, v)));
    for (du, dv, stiffness, damping) in [(1, 0, 200.0, 0.02), (0, 1, 200.0, 0.02), (1, 1, 80.0, 0.01)] {
        for (u, v) in all().filter(|(u, v)| u + du < WIDTH && v + dv < HEIGHT) {
            let here = v * WIDTH + u;
            builder.spring([here, here + dv * WIDTH + du], stiffness, damping, 1.01)?;
        }
    }
    for (u, v) in all().filter(|(u, v)| *u > 0 && v + 1 < HEIGHT) {
        let here = v * WIDTH + u;
        builder.spring([here, here + WIDTH - 1], 80.0, 0.01, 1.01)?;
    }
    // Only a corner reaches it: located hits cut a step of all springs.
    builder.plane([0.0, 0.75, 0.9965], [0.0, -0.05, 1.0], 0.5)
}

fn block<R: Real>(builder: &mut Builder<R>) -> Built<R> {
    const SIDE: u32 = 4;
    let all = || (0..SIDE * SIDE * SIDE).map(|number| [number % SIDE, number / SIDE % SIDE, number / (SIDE * SIDE)]);
    for place in all() {
        let [x, y, z] = place.map(|index| 0.05 * f64::from(index));
        builder.particle([x, y, z], [0.5, 0.1 * z, -2.0 + 0.2 * y], 0.02, Hold::Free)?;
    }
    // To each neighbour that comes later: along edges, across faces, across the cube.
    for first in all() {
        for second in all() {
            let [i, j] = [first, second].map(|[x, y, z]| (z * SIDE + y) * SIDE + x);
            if j > i && first.iter().zip(second).all(|(a, b)| a.abs_diff(b) <= 1) {
                builder.spring([i, j], 150.0, 0.0, 1.0)?;
            }
        }
    }
    builder.plane([0.0, 0.0, -0.01], SLOPE, 0.3)
}

fn balls<R: Real>(builder: &mut Builder<R>) -> Built<R> {
    for number in 0..20 {
        let part = f64::from(number) / 20.0;
        let velocity = [2.0 - 4.0 * part, 1.0 + part, 0.5 - part];
        builder.particle([part, 0.3, 0.1 + 0.2 * part], velocity, 0.1 + part, Hold::Free)?;
    }
    builder.plane([0.0; 3], [0.0, 0.0, 1.0], 0.8)?;
    builder.plane([-0.2, 0.0, 0.0], [1.0, 0.0, 0.0], 1.0)?;
    builder.plane([1.2, 0.0, 0.0], [-1.0, 0.0, 0.2], 0.0)?;
    builder.plane([0.0, 1.0, 0.0], [0.0, -1.0, 0.3], 0.5)
}

fn mesh<R: Real>(builder: &mut Builder<R>) -> Built<R> {
    const POINTS: u32 = 45;
    let mut drawn = Drawn(0x2545_f491_4f6c_dd1d);
    for number in 0..POINTS {
        let place = [0.0; 3].map(|_: f64| drawn.part());
        let velocity = [0.0; 3].map(|_: f64| drawn.part() - 0.5);
        let hold = if number == 7 { Hold::Pinned } else { Hold::Free };
        builder.particle(place, velocity, 0.01 + 0.02 * drawn.part(), hold)?;
    }
    for _ in 0..3 * POINTS {
        let [i, j] = [drawn.below(POINTS), drawn.below(POINTS)];
        if i != j {
            builder.spring([i, j], 20.0 + 100.0 * drawn.part(), 0.05 * drawn.part(), 0.9 + 0.2 * drawn.part())?;
        }
    }
    builder.plane([0.0, 0.0, 0.1], [0.1, -0.2, 1.0], 0.7)
}

fn everything<R: Real>(builder: &mut Builder<R>) -> Built<R> {
    let pinned = builder.particle([0.0, 0.0, 0.5], STILL, 1.0, Hold::Pinned)?;
    let mut last = pinned;
    for number in 1..12 {
        let along = 0.1 * f64::from(number);
        let mass = if number % 3 == 0 { 0.5 } else { 0.02 };
        let next = builder.particle([along, 0.0, 0.5 - 0.2 * along], [0.0, 0.2, -1.0], mass, Hold::Free)?;
        builder.spring([last, next], 100.0 * f64::from(number), 0.0, 1.0 - 0.01 * f64::from(number))?;
        last = next;
    }
    let mover = builder.particle([1.2, 0.0, 0.4], [0.3, -0.2, 0.1], 1.0, Hold::Kinematic)?;
    builder.spring([last, mover], 300.0, 0.0, 1.1)?;
    // Two between the same ends, one turned round, and a stiff one across.
    builder.spring([mover, last], 50.0, 0.0, 0.9)?;
    builder.spring([last, 3], 2000.0, 0.0, 1.0)?;
    // Two particles in one place.
    let along = 0.1 * 3.0;
    let twin = builder.particle([along, 0.0, 0.5 - 0.2 * along], [0.0, 0.2, -1.0], 0.02, Hold::Free)?;
    builder.spring([3, twin], 80.0, 0.0, 1.0)?;
    for number in 0..4 {
        let side = 0.2 * f64::from(number);
        builder.particle([side, 0.4, 0.3], [0.2, -0.5 * side, -1.0], 0.05, Hold::Free)?;
    }
    builder.plane([0.0, 0.0, 0.25], [0.0, 0.1, 1.0], 0.4)?;
    builder.plane([0.0, 0.0, 0.24], [-0.1, 0.0, 1.0], 0.9)
}

fn sleepers<R: Real>(builder: &mut Builder<R>) -> Built<R> {
    const LINKS: u32 = 8;
    const STIFFNESS: f64 = 200.0;
    const MASS: f64 = 0.01;
    for rope in 0..2 {
        // The first hangs as long as its weight makes it; the second is let go askew.
        let mut place = [f64::from(rope), 0.0, 2.0];
        let mut last = builder.particle(place, STILL, MASS, Hold::Pinned)?;
        for link in 0..LINKS {
            let stretch = f64::from(LINKS - link) * MASS * -GRAVITY[2] / STIFFNESS;
            place[2] -= 0.1 + stretch;
            place[1] += 0.03 * f64::from(rope);
            let next = builder.particle(place, STILL, MASS, Hold::Free)?;
            builder.spring([last, next], STIFFNESS, 0.3, (0.1 + stretch) / 0.1)?;
            last = next;
        }
    }
    builder.sleep(0.02, 0.02)?;
    builder.plane([0.0, 0.0, 1.1], [0.0, 0.0, 1.0], 0.5)
}

/// Numbers without any order to them (Marsaglia's xorshift).
struct Drawn(u64);

impl Drawn {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 32) as u32
    }

    /// From 0 to 1.
    fn part(&mut self) -> f64 {
        f64::from(self.next()) / f64::from(u32::MAX)
    }

    fn below(&mut self, count: u32) -> u32 {
        self.next() % count
    }
}
