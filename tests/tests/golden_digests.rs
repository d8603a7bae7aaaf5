//! The bits of 200 steps, per precision and stepper: the same on every machine and in every profile.
//!
//! To mint new ones after a change that is meant to change bits, run this test and copy what it prints.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::Real;
use hooke_runner::scene::{CollisionForm, StepperName};
use hooke_tests::runs::Run;
use hooke_tests::{digest, scenes};

/// In the order of `StepperName::ALL`, hits answered at the end of the step. `auto` is Verlet here: nothing is too stiff
/// for it, and hits are not located.
const SINGLE: [u64; 6] = [
    0x6380_62b4_4269_d632,
    0x6e26_8a5a_67b6_57a6,
    0xd192_9376_c713_58f1,
    0x3c25_70cb_c324_5aea,
    0x8700_d61e_5bc5_ad61,
    0x8700_d61e_5bc5_ad61,
];
const DOUBLE: [u64; 6] = [
    0xe509_0d86_9fd2_ce05,
    0xadb6_9f5d_1f63_5a92,
    0x8c8c_cd31_8ac5_2ad1,
    0x4333_9dfb_5bea_9bb5,
    0xa837_b33d_6287_876c,
    0xa837_b33d_6287_876c,
];

/// Likewise, hits located inside the step: `auto` then flies exactly what no spring pulls at.
const SINGLE_LOCATED: [u64; 6] = [
    0xdc3d_c3e1_a5d1_de30,
    0xaa13_ca91_af42_862a,
    0x4692_6453_befe_f71f,
    0xe1e5_3b4c_df00_7e09,
    0xc3eb_d209_b581_cf7d,
    0xbf04_f081_8254_58fc,
];
const DOUBLE_LOCATED: [u64; 6] = [
    0x5155_c1b4_9f54_bbc7,
    0x7c52_78ca_b9a7_71d6,
    0xb455_f43e_8b07_3169,
    0x93aa_193c_abca_ca60,
    0xded1_ddc3_da22_e1aa,
    0xb13c_8ec4_432f_2ea1,
];

#[test]
fn in_single_precision() {
    compare::<f32>(CollisionForm::Project, SINGLE);
}

#[test]
fn in_double_precision() {
    compare::<f64>(CollisionForm::Project, DOUBLE);
}

#[test]
fn in_single_precision_with_located_hits() {
    compare::<f32>(CollisionForm::TimeOfImpact, SINGLE_LOCATED);
}

#[test]
fn in_double_precision_with_located_hits() {
    compare::<f64>(CollisionForm::TimeOfImpact, DOUBLE_LOCATED);
}

fn compare<R: Real>(form: CollisionForm, expected: [u64; 6]) {
    let (model, settings) = scenes::load("golden");
    let digests = StepperName::ALL.iter().map(|&stepper| {
        let mut run = Run::<R>::new(&model, settings.gravity, stepper, form).with_tolerance(stepper, 1e-5);
        let report = run.steps(200, 2e-3);
        assert!(report.hits > 20 && report.converged, "{stepper}: {report:?}");
        digest::of(&run.world.view())
    });
    let digests: Vec<u64> = digests.collect();
    let mint = digests.iter().map(|digest| format!("{digest:#018x}"));
    assert_eq!(digests, expected, "now: [{}]", mint.collect::<Vec<_>>().join(", "));
}
