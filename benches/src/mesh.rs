//! An irregular mesh: no two of its springs need lie on one diagonal.

use hooke_runner::model::{Hold, Model, ModelParticle, ModelSpring};

/// A square metre of about `side`² particles, each at a random place in its cell, joined along the edges of triangles
/// whose diagonals go either way at random. Springs have the lengths that they begin with; the four corners are pinned.
#[must_use]
pub fn irregular(side: u32) -> Model {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let cell = 1.0 / f64::from(side);
    let mut model = Model::default();
    for v in 0..side {
        for u in 0..side {
            let place = |index: u32, random: &mut Random| (f64::from(index) + 0.2 + 0.6 * random.next()) * cell;
            let is_corner = (u == 0 || u + 1 == side) && (v == 0 || v + 1 == side);
            model.particles.push(ModelParticle {
                position: [place(u, &mut random), place(v, &mut random), 0.0],
                velocity: [0.0; 3],
                mass: 0.01,
                hold: if is_corner { Hold::Pinned } else { Hold::Free },
            });
        }
    }
    // Neighbours in the mesh are neighbours in memory as far as whoever made the mesh took care of that: not in a row.
    let mut number: Vec<u32> = (0..side * side).collect();
    for block in number.chunks_mut(64) {
        for last in (1..block.len()).rev() {
            block.swap(last, (random.next() * (last + 1) as f64) as usize);
        }
    }
    let mut particles = model.particles.clone();
    for (particle, number) in model.particles.iter().zip(&number) {
        particles[*number as usize] = *particle;
    }
    model.particles = particles;
    let number = |u: u32, v: u32| number[(v * side + u) as usize];
    for v in 0..side {
        for u in 0..side {
            let mut join = |first: u32, second: u32| {
                let ends = [first, second].map(|end| model.particles[end as usize].position);
                let square: f64 = ends[0].iter().zip(ends[1]).map(|(a, b)| (a - b) * (a - b)).sum();
                model.springs.push(ModelSpring {
                    between: [first, second],
                    stiffness: 100.0,
                    damping: 0.05,
                    rest_length: square.sqrt(),
                });
            };
            if u + 1 < side {
                join(number(u, v), number(u + 1, v));
            }
            if v + 1 < side {
                join(number(u, v), number(u, v + 1));
            }
            if u + 1 < side && v + 1 < side {
                if random.next() < 0.5 {
                    join(number(u, v), number(u + 1, v + 1));
                } else {
                    join(number(u + 1, v), number(u, v + 1));
                }
            }
        }
    }
    model
}

/// Numbers from 0 to 1 that are the same everywhere (`SplitMix64`; Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}
