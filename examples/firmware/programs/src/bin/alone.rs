//! Steps a cloth of 10 × 10 by the steppers that are features of this package, without a word: what each takes of flash and
//! of static RAM, alone and together.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use hooke::{Fixed, Project, Stepper, World};
use hooke_firmware as _;
use hooke_firmware_scenes::cloth;

type Cloth = World<f32, 100, 502, 0>;
#[allow(dead_code, reason = "alone, some steppers need no room")]
type Room = Fixed<100, 502, 0>;

fn step(world: &mut Cloth, stepper: &mut impl Stepper<f32>) {
    let _ = black_box(world.step(stepper, &mut Project, 1.0 / 512.0));
}

/// Steps by a stepper in a static, if it is a feature.
macro_rules! step {
    ($world:ident, $feature:literal, $kind:ty, $new:expr) => {
        #[cfg(feature = $feature)]
        if let Some(stepper) = cortex_m::singleton!(: $kind = $new) {
            step($world, stepper);
        }
    };
}

#[entry]
fn main() -> ! {
    static mut WORLD: Cloth = World::new();
    let _ = cloth(WORLD, 10);
    step!(WORLD, "explicit-euler", hooke::ExplicitEuler, hooke::ExplicitEuler);
    step!(WORLD, "semi-implicit-euler", hooke::SemiImplicitEuler, hooke::SemiImplicitEuler);
    step!(WORLD, "velocity-verlet", hooke::VelocityVerlet<f32, Room>, hooke::VelocityVerlet::new());
    step!(WORLD, "rk4", hooke::Rk4<f32, Room>, hooke::Rk4::new());
    step!(WORLD, "blanes-moan-s6", hooke::BlanesMoanS6<f32, Room>, hooke::BlanesMoanS6::new());
    step!(WORLD, "dop853", hooke::Dop853<f32, Room>, hooke::Dop853::new());
    step!(WORLD, "dormand-prince-rkn8", hooke::DormandPrinceRkn8<f32, Room>, hooke::DormandPrinceRkn8::new());
    step!(WORLD, "implicit-euler", hooke::ImplicitEuler<f32, Room, 2>, hooke::ImplicitEuler::new(1e-5));
    step!(
        WORLD,
        "implicit-euler-linearised",
        hooke::ImplicitEulerLinearised<f32, Room, 2>,
        hooke::ImplicitEulerLinearised::new(1e-5)
    );
    step!(WORLD, "implicit-midpoint", hooke::ImplicitMidpoint<f32, Room, 2>, hooke::ImplicitMidpoint::new(1e-5));
    step!(WORLD, "tr-bdf2", hooke::TrBdf2<f32, Room, 2>, hooke::TrBdf2::new(1e-5));
    step!(WORLD, "auto", hooke::Auto<f32, Room, 2>, hooke::Auto::new(1e-5));
    loop {
        cortex_m::asm::wfi();
    }
}
