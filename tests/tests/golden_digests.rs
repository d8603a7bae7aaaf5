//! The bits of 200 steps, per precision and stepper: the same on every machine and in every profile.
//!
//! To mint new ones after a change that is meant to change bits, run this test and copy what it prints.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

use hooke::Real;
use hooke_runner::scene::CollisionForm;
use hooke_tests::runs::Run;
use hooke_tests::{digest, scenes, steppers};

/// In the order of `steppers::all`, hits answered at the end of the step. `auto` is Verlet here: nothing is too stiff
/// for it, and hits are not located.
const SINGLE: [u64; 11] = [
    0x0cef_34a5_8c25_c1ed,
    0xf0ba_7c8f_8b7c_052b,
    0x9d6c_58a1_0bd9_037a,
    0x5920_705d_96f8_9baa,
    0xaf73_bb63_9c75_8cfb,
    0xccd9_d962_fa09_264d,
    0x741a_997b_8d51_1da5,
    0x8efa_915a_ecf3_afa7,
    0x58f4_7105_deda_af45,
    0xf075_fdc4_efb3_ba97,
    0x741a_997b_8d51_1da5,
];
const DOUBLE: [u64; 11] = [
    0xf93f_3150_ae94_d446,
    0x3dbf_2ed2_fbef_05ff,
    0xe0d7_373a_7b0a_e4cf,
    0x7275_1efd_00fb_c330,
    0xe2bf_4f02_cc73_ce4f,
    0x0c17_dd1c_fbd7_9398,
    0x58e5_40e9_5363_b17f,
    0x19ee_15cc_2365_4edc,
    0x5c46_11f9_b287_50f8,
    0x9ddc_501b_d4c8_14b4,
    0x58e5_40e9_5363_b17f,
];

/// Likewise, hits located inside the step: `auto` then flies exactly what no spring pulls at.
const SINGLE_LOCATED: [u64; 11] = [
    0x1bea_f21e_d5cb_b0e4,
    0x17df_58da_7e75_081b,
    0x753b_eda0_328d_c560,
    0x718c_6a76_a5ed_285c,
    0xcb36_be92_1364_1557,
    0x414a_c0f5_671d_ed93,
    0x117b_63e3_8001_f9a0,
    0x9800_2b9e_e383_4118,
    0x457a_e193_6c5d_0914,
    0xf1fd_f7d5_d36b_a702,
    0x0504_24c9_b2a0_85c9,
];
const DOUBLE_LOCATED: [u64; 11] = [
    0x72b7_0e94_4380_3b7f,
    0x6797_d3af_6640_f874,
    0xb51c_da91_0ad8_84d4,
    0x05bd_06f3_826f_3d2f,
    0x10c7_d455_9899_cf75,
    0x66c4_dde5_d0c4_d04e,
    0xe8e8_405b_7169_571a,
    0x692e_5b67_276a_f78c,
    0x319f_d953_6cd2_f440,
    0xe26c_8c11_17ad_08ac,
    0xa1f4_b235_634a_269d,
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

fn compare<R: Real>(form: CollisionForm, expected: [u64; 11]) {
    let (model, settings) = scenes::load("golden");
    let digests = steppers::all().map(|stepper| {
        let mut run = Run::<R>::new(&model, settings.gravity, stepper, form).with_tolerance(stepper, 1e-5);
        let report = run.steps(200, 2e-3);
        assert!(report.hits > 20 && report.converged, "{stepper}: {report:?}");
        digest::of(&run.world.view())
    });
    let digests: Vec<u64> = digests.collect();
    let mint = digests.iter().map(|digest| format!("{digest:#018x}"));
    assert_eq!(digests, expected, "now: [{}]", mint.collect::<Vec<_>>().join(", "));
}
