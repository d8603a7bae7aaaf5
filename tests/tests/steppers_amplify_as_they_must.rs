//! What a step does to a damped oscillator: stable just below the limit, exploding just above, and the closed forms of
//! the amplification in between.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use glam::DVec3;
use hooke_runner::model::{Hold, Model, ModelParticle, ModelSpring};
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::problems::skew;
use hooke_tests::runs::Run;
use hooke_tests::stability;

const DAMPING_RATIOS: [f64; 4] = [0.0, 0.1, 0.5, 1.0];

/// The core keeps Verlet's acceleration from one step to the next, computed at the predicted velocity: one force
/// evaluation a step, and the limit is that of the kept variant, 2(√(1 + 4ζ²) − 2ζ).
#[test]
fn limits_are_where_theory_has_them() {
    type Limit = fn(f64) -> f64;
    let limits: [(StepperName, Limit); 3] = [
        (StepperName::ExplicitEuler, stability::explicit_euler_limit),
        (StepperName::SemiImplicitEuler, stability::semi_implicit_euler_limit),
        (StepperName::VelocityVerlet, stability::verlet_kept_limit),
    ];
    for (stepper, limit) in limits {
        for zeta in DAMPING_RATIOS {
            if limit(zeta) == 0.0 {
                continue;
            }
            let [below, above] = [0.99, 1.01].map(|part| growth(stepper, zeta, part * limit(zeta)));
            // Below, a swing may first grow by the condition of the eigenvectors, 1/√(1 − 0.99) or so, and then fades or
            // stays. Above, the least radius is 1.005 (explicit Euler at ζ = 0.1: 1 + h²/100), and 2,000 steps make
            // e^{0.0004 × 2,000} = 2 of even that; the others grow a hundredfold.
            assert!(below < 20.0, "{stepper}, {zeta}: {below:e}");
            let least = if stepper == StepperName::ExplicitEuler { 1.2 } else { 100.0 };
            assert!(above > least * below.min(1.0) && above > least, "{stepper}, {zeta}: {below:e}, {above:e}");
        }
    }
}

/// RK4 is stable where |1 + z + z²/2 + z³/6 + z⁴/24| ≤ 1; at the frequency bound of a world it is stable below every one of
/// these limits.
#[test]
fn rk4_is_stable_up_to_its_limit() {
    for (zeta, near) in [(0.0, 2.828), (0.1, 2.95), (0.5, 2.62), (1.0, 2.785)] {
        let grows = |h: f64| square(polynomial(eigenvalue(zeta, h))) > 1.0;
        let (mut low, mut limit) = (2.0, 3.5);
        while limit - low > 1e-9 {
            let middle = 0.5 * (low + limit);
            if grows(middle) { limit = middle } else { low = middle }
        }
        assert!((limit - near).abs() < 0.01, "{zeta}: {limit}, not {near}");
        let [below, above] = [0.99, 1.01].map(|part| growth(StepperName::Rk4, zeta, part * limit));
        assert!(below < 20.0, "{zeta}: {below:e}");
        assert!(above > 100.0, "{zeta}: {above:e}");
    }
}

/// S₆ undamped, by the trace of its matrix; damped its limit is never lower but where γ is what limits it.
#[test]
fn blanes_moan_s6_is_stable_up_to_its_limit() {
    for zeta in DAMPING_RATIOS {
        let limit = stability::limit(stability::blanes_moan_s6, zeta, 10.0).expect("it has one");
        let bound = 3.13_f64.min(6.0 / (2.0 * zeta));
        assert!(bound < limit, "{zeta}: {limit}");
        assert!(zeta > 0.0 || limit < 1.002 * bound, "{limit}");
        // Past the limit the undamped one grows by 1 % a step as far as h = 3.16, where it is stable once more.
        let [below, above] = [0.99, 1.004].map(|part| growth(StepperName::BlanesMoanS6, zeta, part * limit));
        assert!(below < 20.0, "{zeta}: {below:e}");
        assert!(above > 100.0, "{zeta}: {above:e}");
    }
}

/// Its leading term of frequency and of amplitude is the exact solution's: e^{−2ζh} of the square, but for h⁹.
#[test]
fn high_orders_amplify_like_the_exact_solution() {
    for (stepper, dampings) in [(StepperName::Dop853, &[0.0, 0.3][..]), (StepperName::DormandPrinceRkn8, &[0.0])] {
        for &zeta in dampings {
            let errors =
                [0.5, 1.0].map(|h: f64| (determinant(stepper, zeta, h) - (-2.0 * zeta * h).exp()).abs().max(1e-13));
            assert!(errors[1] < 1e-6, "{stepper}, {zeta}: {errors:?}");
            assert!(errors[0] < errors[1] / 100.0, "{stepper}, {zeta}: {errors:?}");
        }
    }
}

type Complex = [f64; 2];

fn times([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a * c - b * d, a * d + b * c]
}

/// |z|²
fn square([a, b]: Complex) -> f64 {
    a * a + b * b
}

/// dt λ of the oscillator: −ζh + i h √(1 − ζ²).
fn eigenvalue(zeta: f64, h: f64) -> Complex {
    [-zeta * h, h * (1.0 - zeta * zeta).max(0.0).sqrt()]
}

/// 1 + z + z²/2 + z³/6 + z⁴/24
fn polynomial(z: Complex) -> Complex {
    [4.0, 3.0, 2.0, 1.0].into_iter().fold([1.0, 0.0], |sum, divisor| {
        let [a, b] = times(sum, z);
        [1.0 + a / divisor, b / divisor]
    })
}

/// Of TR-BDF2 (Bank and others 1985): (2(2 − γ) + (1 + (1 − γ)²) z)/(γ(1 − γ) z² + (γ² − 2) z + 2(2 − γ)).
fn tr_bdf2(z: Complex) -> f64 {
    let gamma = 2.0 - 2.0_f64.sqrt();
    let constant = 2.0 * (2.0 - gamma);
    let linear = |[a, b]: Complex, factor: f64| [constant + factor * a, factor * b];
    let above = linear(z, 1.0 + (1.0 - gamma).powi(2));
    let [a, b] = linear(z, gamma * gamma - 2.0);
    let [c, d] = times(z, z).map(|part| gamma * (1.0 - gamma) * part);
    square(above) / square([a + c, b + d])
}

/// Drifts keep areas; a kick b takes the first terms of e^{−2ζbh} of them.
fn blanes_moan_s6(zeta: f64, h: f64) -> f64 {
    let half = stability::KICKS.iter().map(|b| {
        let z = -2.0 * zeta * b * h;
        1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))
    });
    half.product::<f64>().powi(2)
}

#[test]
fn amplification_is_the_closed_form() {
    use StepperName::{
        Auto, BlanesMoanS6, ExplicitEuler, ImplicitEuler, ImplicitEulerLinearised, ImplicitMidpoint, Rk4,
        SemiImplicitEuler, TrBdf2, VelocityVerlet,
    };
    for zeta in [0.0, 0.05, 0.3, 0.7] {
        for h in [0.01, 0.1, 0.5, 1.3] {
            let implicit = 1.0 / (1.0 + 2.0 * zeta * h + h * h);
            let mut expected = vec![
                (ExplicitEuler, 1.0 - 2.0 * zeta * h + h * h),
                (SemiImplicitEuler, 1.0 - 2.0 * zeta * h),
                (ImplicitEuler, implicit),
                (ImplicitEulerLinearised, implicit),
                (ImplicitMidpoint, (1.0 - zeta * h + h * h / 4.0) / (1.0 + zeta * h + h * h / 4.0)),
                (TrBdf2, tr_bdf2(eigenvalue(zeta, h))),
                (Rk4, square(polynomial(eigenvalue(zeta, h)))),
                (BlanesMoanS6, blanes_moan_s6(zeta, h)),
            ];
            if zeta == 0.0 {
                // Symplectic: areas are kept. (With damping the kept acceleration makes the state threefold.)
                expected.extend([(VelocityVerlet, 1.0), (Auto, 1.0)]);
            }
            for (stepper, expected) in expected {
                let found = determinant(stepper, zeta, h);
                // Two states 0.1 m apart, 1 m from the pin: rounding, ten times.
                assert!((found - expected).abs() < 1e-13, "{stepper}, {zeta}, {h}: {found}, not {expected}");
            }
        }
    }
}

/// det of the amplification matrix: |λ|² of a complex pair. Its columns are differences of steps from two states.
fn determinant(stepper: StepperName, zeta: f64, h: f64) -> f64 {
    let step = |x: f64, v: f64| {
        let mut run = run(stepper, zeta, [x, v]);
        run.steps(1, h);
        state(&mut run)
    };
    let (x, v) = (step(0.1, 0.0), step(0.0, 0.1));
    (x[0] * v[1] - x[1] * v[0]) / (0.1 * 0.1)
}

/// How much a swing has grown after 2,000 steps, or when it is a thousand times what it was.
fn growth(stepper: StepperName, zeta: f64, h: f64) -> f64 {
    let start = 1e-5;
    let mut run = run(stepper, zeta, [start, 0.0]);
    let size = |[x, v]: [f64; 2]| x.hypot(v) / start;
    for _ in 0..2000 {
        run.steps(1, h);
        if size(state(&mut run)) > 1e3 {
            break;
        }
    }
    size(state(&mut run))
}

/// ẍ = −x − 2ζẋ: 1 kg on a spring of 1 N/m, 1 m from its pin, in a direction that is none of the axes.
fn run(stepper: StepperName, zeta: f64, [x, v]: [f64; 2]) -> Run<f64> {
    let along = skew() * DVec3::X;
    let particle = |x: f64, v: f64, hold| ModelParticle {
        position: (x * along).to_array(),
        velocity: (v * along).to_array(),
        mass: 1.0,
        hold,
    };
    let model = Model {
        particles: vec![particle(0.0, 0.0, Hold::Pinned), particle(1.0 + x, v, Hold::Free)],
        springs: vec![ModelSpring { between: [0, 1], stiffness: 1.0, damping: 2.0 * zeta, rest_length: 1.0 }],
        ..Model::default()
    };
    Run::new(&model, [0.0; 3], stepper, CollisionForm::Reflect).with_tolerance(stepper, 1e-14)
}

fn state(run: &mut Run<f64>) -> [f64; 2] {
    let moment = run.moment();
    let along = skew() * DVec3::X;
    let [x, v] = [&moment.position, &moment.velocity].map(|vectors| along.dot(DVec3::from(vectors[1])));
    [x - 1.0, v]
}
