//! Ways to write a loop for vector instructions, compared: one diagonal of 256 damped springs in the first cache, `f32`.
//! Plain loops compiled for a set of instructions, intrinsics, and the crates `pulp` (which chooses the set when the
//! program runs) and `wide` (which has that of the whole program). All are checked to give the same bits.
#![allow(missing_docs, clippy::expect_used, clippy::too_many_arguments)]
#![allow(
    unsafe_code,
    reason = "intrinsics, and calls into functions for instructions that the machine has been found to have"
)]

use criterion::{Criterion, criterion_group, criterion_main};

/// Springs.
const PLACES: usize = 256;
/// Between the ends of a spring, in particles.
const OFFSET: usize = 63;
const STIFFNESS: f32 = 100.0;
const DAMPING: f32 = 0.05;
const REST_LENGTH: f32 = 0.01;

type Column = [f32; PLACES + OFFSET];

/// Position and velocity, and the forces from above and from below.
struct Diagonal {
    state: [Column; 6],
    forces: [Column; 6],
}

/// A way to add the forces to six columns.
type Way = fn(&[Column; 6], [&mut [f32]; 6]);

fn diagonal() -> Diagonal {
    let mut state = [[0.0; PLACES + OFFSET]; 6];
    for (axis, column) in state.iter_mut().enumerate() {
        for (index, value) in column.iter_mut().enumerate() {
            *value = (index * (axis + 3) % 17) as f32 * 0.011 + index as f32 * 0.002;
        }
    }
    Diagonal { state, forces: [[0.0; PLACES + OFFSET]; 6] }
}

fn add(diagonal: &mut Diagonal, way: Way) {
    let Diagonal { state, forces } = diagonal;
    let [a, b, c, d, e, f] = forces;
    let above = [a, b, c].map(|column| &mut column[..PLACES]);
    let below = [d, e, f].map(|column| &mut column[OFFSET..]);
    let ([a, b, c], [d, e, f]) = (above, below);
    way(state, [a, b, c, d, e, f]);
}

mod plain {
    use super::{Column, DAMPING, OFFSET, PLACES, REST_LENGTH, STIFFNESS};

    #[inline(always)]
    fn body(
        state: &[Column; 6],
        a: &mut [f32],
        b: &mut [f32],
        c: &mut [f32],
        d: &mut [f32],
        e: &mut [f32],
        f: &mut [f32],
    ) {
        let lower: [&[f32]; 6] = state.each_ref().map(|column| &column[..PLACES]);
        let upper: [&[f32]; 6] = state.each_ref().map(|column| &column[OFFSET..]);
        // One by one: in an array they would no longer be known not to overlap.
        let (a, b, c) = (&mut a[..PLACES], &mut b[..PLACES], &mut c[..PLACES]);
        let (d, e, f) = (&mut d[..PLACES], &mut e[..PLACES], &mut f[..PLACES]);
        for i in 0..PLACES {
            let (x, y, z) = (upper[0][i] - lower[0][i], upper[1][i] - lower[1][i], upper[2][i] - lower[2][i]);
            let (u, v, w) = (upper[3][i] - lower[3][i], upper[4][i] - lower[4][i], upper[5][i] - lower[5][i]);
            let length = (x * x + y * y + z * z).sqrt();
            let inverse = 1.0 / length;
            let rate = (u * x + v * y + w * z) * inverse;
            let tension = STIFFNESS * (length - REST_LENGTH) + DAMPING * rate;
            let q = f32::from_bits((tension * inverse).to_bits() & u32::from(length != 0.0).wrapping_neg());
            a[i] += q * x;
            b[i] += q * y;
            c[i] += q * z;
            d[i] -= q * x;
            e[i] -= q * y;
            f[i] -= q * z;
        }
    }

    macro_rules! compiled {
        ($name:ident, $(#[$attribute:meta])*) => {
            $(#[$attribute])*
            fn $name(
                state: &[Column; 6],
                a: &mut [f32],
                b: &mut [f32],
                c: &mut [f32],
                d: &mut [f32],
                e: &mut [f32],
                f: &mut [f32],
            ) {
                body(state, a, b, c, d, e, f);
            }
        };
    }

    compiled!(baseline, #[inline(never)]);
    compiled!(avx2, #[cfg(target_arch = "x86_64")] #[target_feature(enable = "avx2")]);

    pub fn for_baseline(state: &[Column; 6], [a, b, c, d, e, f]: [&mut [f32]; 6]) {
        baseline(state, a, b, c, d, e, f);
    }

    #[cfg(target_arch = "x86_64")]
    pub fn for_avx2(state: &[Column; 6], [a, b, c, d, e, f]: [&mut [f32]; 6]) {
        // SAFETY: it is run only where the machine has been found to have AVX2.
        unsafe { avx2(state, a, b, c, d, e, f) };
    }
}

#[cfg(target_arch = "x86_64")]
mod intrinsics {
    use core::arch::x86_64::{
        _CMP_NEQ_UQ, _mm256_add_ps as add, _mm256_and_ps as and, _mm256_cmp_ps as compare, _mm256_div_ps as divide,
        _mm256_loadu_ps as load, _mm256_mul_ps as multiply, _mm256_set1_ps as all, _mm256_setzero_ps as zero,
        _mm256_sqrt_ps as root, _mm256_storeu_ps as store, _mm256_sub_ps as subtract,
    };

    use super::{Column, DAMPING, OFFSET, PLACES, REST_LENGTH, STIFFNESS};

    pub fn for_avx2(state: &[Column; 6], forces: [&mut [f32]; 6]) {
        // SAFETY: it is run only where the machine has been found to have AVX2.
        unsafe { body(state, forces) };
    }

    #[target_feature(enable = "avx2")]
    fn body(state: &[Column; 6], mut forces: [&mut [f32]; 6]) {
        assert!(forces.iter().all(|column| column.len() >= PLACES));
        for first in (0..PLACES).step_by(8) {
            let d: [_; 6] = core::array::from_fn(|axis| {
                let column = state[axis].as_ptr();
                // SAFETY: a column has PLACES + OFFSET items, and the last of these eight is before PLACES.
                let (lower, upper) = unsafe { (load(column.add(first)), load(column.add(first + OFFSET))) };
                subtract(upper, lower)
            });
            let dot = |from: usize| {
                let [x, y, z] = core::array::from_fn(|axis| multiply(d[from + axis], d[axis]));
                add(add(x, y), z)
            };
            let length = root(dot(0));
            let inverse = divide(all(1.0), length);
            let rate = multiply(dot(3), inverse);
            let stretch = multiply(all(STIFFNESS), subtract(length, all(REST_LENGTH)));
            let tension = add(stretch, multiply(all(DAMPING), rate));
            let q = and(multiply(tension, inverse), compare::<_CMP_NEQ_UQ>(length, zero()));
            for (number, column) in forces.iter_mut().enumerate() {
                let force = multiply(q, d[number % 3]);
                let place = column[first..].as_mut_ptr();
                // SAFETY: a column has PLACES items at least, and the last of these eight is before PLACES.
                let sum = unsafe { load(place) };
                let sum = if number < 3 { add(sum, force) } else { subtract(sum, force) };
                // SAFETY: likewise.
                unsafe { store(place, sum) };
            }
        }
    }
}

mod with_wide {
    use wide::f32x8;

    use super::{Column, DAMPING, OFFSET, PLACES, REST_LENGTH, STIFFNESS};

    fn load(column: &[f32]) -> f32x8 {
        f32x8::from(*column.first_chunk::<8>().expect("eight of them"))
    }

    #[inline(never)]
    pub fn for_baseline(state: &[Column; 6], mut forces: [&mut [f32]; 6]) {
        for first in (0..PLACES).step_by(8) {
            let d: [f32x8; 6] =
                core::array::from_fn(|axis| load(&state[axis][first + OFFSET..]) - load(&state[axis][first..]));
            let [x, y, z, u, v, w] = d;
            let length = (x * x + y * y + z * z).sqrt();
            let inverse = f32x8::splat(1.0) / length;
            let rate = (u * x + v * y + w * z) * inverse;
            let tension = f32x8::splat(STIFFNESS) * (length - f32x8::splat(REST_LENGTH)) + f32x8::splat(DAMPING) * rate;
            let q = (tension * inverse) & length.simd_ne(f32x8::splat(0.0));
            for (number, column) in forces.iter_mut().enumerate() {
                let (sum, force) = (load(&column[first..]), q * d[number % 3]);
                let sum = if number < 3 { sum + force } else { sum - force };
                column[first..first + 8].copy_from_slice(&sum.to_array());
            }
        }
    }
}

mod with_pulp {
    use pulp::{Arch, Simd, WithSimd};

    use super::{Column, DAMPING, OFFSET, PLACES, REST_LENGTH, STIFFNESS};

    struct Body<'a>(&'a [Column; 6], [&'a mut [f32]; 6]);

    impl WithSimd for Body<'_> {
        type Output = ();

        #[inline(always)]
        fn with_simd<S: Simd>(self, simd: S) {
            let Body(state, forces) = self;
            let lower = state.each_ref().map(|column| S::as_simd_f32s(&column[..PLACES]).0);
            let upper = state.each_ref().map(|column| S::as_simd_f32s(&column[OFFSET..OFFSET + PLACES]).0);
            let count = lower[0].len();
            let (lower, upper) = (lower.map(|column| &column[..count]), upper.map(|column| &column[..count]));
            let [a, b, c, d, e, f] = forces.map(|column| &mut S::as_mut_simd_f32s(column).0[..count]);
            let (multiply, add) = (|a, b| simd.mul_f32s(a, b), |a, b| simd.add_f32s(a, b));
            let subtract = |a, b| simd.sub_f32s(a, b);
            let all = |value| simd.splat_f32s(value);
            for i in 0..count {
                let [x, y, z, u, v, w] = core::array::from_fn(|axis| subtract(upper[axis][i], lower[axis][i]));
                let length = simd.sqrt_f32s(add(add(multiply(x, x), multiply(y, y)), multiply(z, z)));
                let inverse = simd.div_f32s(all(1.0), length);
                let rate = multiply(add(add(multiply(u, x), multiply(v, y)), multiply(w, z)), inverse);
                let stretch = multiply(all(STIFFNESS), subtract(length, all(REST_LENGTH)));
                let tension = add(stretch, multiply(all(DAMPING), rate));
                let none = simd.equal_f32s(length, all(0.0));
                let q = simd.select_f32s(none, all(0.0), multiply(tension, inverse));
                a[i] = add(a[i], multiply(q, x));
                b[i] = add(b[i], multiply(q, y));
                c[i] = add(c[i], multiply(q, z));
                d[i] = subtract(d[i], multiply(q, x));
                e[i] = subtract(e[i], multiply(q, y));
                f[i] = subtract(f[i], multiply(q, z));
            }
        }
    }

    pub fn chosen_at_run_time(state: &[Column; 6], forces: [&mut [f32]; 6]) {
        Arch::new().dispatch(Body(state, forces));
    }
}

fn lanes(criterion: &mut Criterion) {
    let mut ways: Vec<(&str, Way)> = vec![
        ("plain loop, baseline", plain::for_baseline),
        ("wide, baseline", with_wide::for_baseline),
        ("pulp, chosen at run time", with_pulp::chosen_at_run_time),
    ];
    #[cfg(target_arch = "x86_64")]
    if std::is_x86_feature_detected!("avx2") {
        ways.push(("plain loop, AVX2", plain::for_avx2));
        ways.push(("intrinsics, AVX2", intrinsics::for_avx2));
    }
    let bits = |way: Way| {
        let mut diagonal = diagonal();
        add(&mut diagonal, way);
        diagonal.forces.map(|column| column.map(f32::to_bits))
    };
    let mut group = criterion.benchmark_group("lanes");
    group.throughput(criterion::Throughput::Elements(PLACES as u64));
    for (name, way) in ways {
        assert!(bits(way) == bits(plain::for_baseline), "{name}: other bits");
        let mut diagonal = diagonal();
        group.bench_function(name, |bencher| bencher.iter(|| add(&mut diagonal, way)));
    }
    group.finish();
}

criterion_group!(benches, lanes);
criterion_main!(benches);
