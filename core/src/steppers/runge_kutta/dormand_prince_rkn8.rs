//! A Nyström method of order 8.

use super::embedded::{Difference, Embedded, less};
use super::tableau::{Tableau, row};
use super::{Adaptive, RungeKutta};

/// RKN8(6)9FM of Dormand, El-Mikkawy and Prince (*High-order embedded Runge-Kutta-Nyström formulae*, IMA Journal of
/// Numerical Analysis 7, 1987).
#[derive(Clone, Copy, Debug)]
pub struct DormandPrince;

/// The Runge-Kutta-Nyström method 8(6) of Dormand and Prince: eighth order, eight force evaluations a step, for worlds
/// without damping: its stages have no velocities.
pub type DormandPrinceRkn8<R, M> = RungeKutta<R, M, DormandPrince, 9>;

/// The same with steps as long as its embedded formula of sixth order allows.
pub type AdaptiveDormandPrinceRkn8<R, M> = Adaptive<R, M, DormandPrince, 9>;

const WEIGHTS: [f64; 9] =
    [223.0 / 7938.0, 0.0, 1175.0 / 8064.0, 925.0 / 6048.0, 41.0 / 448.0, 925.0 / 14112.0, 1175.0 / 72576.0, 0.0, 0.0];

impl Tableau<9> for DormandPrince {
    const NODES: [f64; 9] = [0.0, 0.05, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0, 1.0];
    const POSITION: [[f64; 9]; 9] = [
        row(&[]),
        row(&[1.0 / 800.0]),
        row(&[1.0 / 600.0, 1.0 / 300.0]),
        row(&[9.0 / 200.0, -9.0 / 100.0, 9.0 / 100.0]),
        row(&[-66_701.0 / 197_352.0, 28_325.0 / 32_892.0, -2_665.0 / 5_482.0, 2_170.0 / 24_669.0]),
        row(&[
            227_015_747.0 / 304_251_000.0,
            -54_897_451.0 / 30_425_100.0,
            12_942_349.0 / 10_141_700.0,
            -9_499.0 / 304_251.0,
            539.0 / 9_250.0,
        ]),
        row(&[
            -1_131_891_597.0 / 901_789_000.0,
            41_964_921.0 / 12_882_700.0,
            -6_663_147.0 / 3_220_675.0,
            270_954.0 / 644_135.0,
            -108.0 / 5_875.0,
            114.0 / 1_645.0,
        ]),
        row(&[
            13_836_959.0 / 3_667_458.0,
            -17_731_450.0 / 1_833_729.0,
            1_063_919_505.0 / 156_478_208.0,
            -33_213_845.0 / 39_119_552.0,
            13_335.0 / 28_544.0,
            -705.0 / 14_272.0,
            1_645.0 / 57_088.0,
        ]),
        WEIGHTS,
    ];
    const VELOCITY: Option<[[f64; 9]; 9]> = None;
    const POSITION_WEIGHTS: [f64; 9] = WEIGHTS;
    const VELOCITY_WEIGHTS: [f64; 9] = [
        223.0 / 7938.0,
        0.0,
        5875.0 / 36288.0,
        4625.0 / 21168.0,
        41.0 / 224.0,
        4625.0 / 21168.0,
        5875.0 / 36288.0,
        223.0 / 7938.0,
        0.0,
    ];
    const ORDER: u32 = 8;
    const FIRST_SAME_AS_LAST: bool = true;
}

impl Embedded<9> for DormandPrince {
    /// Of the sixth order.
    const DIFFERENCES: [Option<Difference<9>>; 2] = [
        Some(Difference { position: less(WEIGHTS, SIXTH), velocity: less(Self::VELOCITY_WEIGHTS, SIXTH_VELOCITY) }),
        None,
    ];
    const ESTIMATED_ORDER: u32 = 7;

    fn estimate([sixth, _]: [f64; 2]) -> f64 {
        sixth
    }
}

const SIXTH: [f64; 9] = [
    7_987_313.0 / 109_941_300.0,
    0.0,
    1_610_737.0 / 44_674_560.0,
    10_023_263.0 / 33_505_920.0,
    -497_221.0 / 12_409_600.0,
    10_023_263.0 / 78_180_480.0,
    1_610_737.0 / 402_071_040.0,
    0.0,
    0.0,
];

const SIXTH_VELOCITY: [f64; 9] = [
    7_987_313.0 / 109_941_300.0,
    0.0,
    1_610_737.0 / 40_207_104.0,
    10_023_263.0 / 23_454_144.0,
    -497_221.0 / 6_204_800.0,
    10_023_263.0 / 23_454_144.0,
    1_610_737.0 / 40_207_104.0,
    -4_251_941.0 / 54_970_650.0,
    3.0 / 20.0,
];
