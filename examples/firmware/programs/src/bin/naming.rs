//! `smallest` that also names every other stepper, and uses none of them: it takes not a byte more.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use hooke::{
    Auto, BlanesMoanS6, Dop853, DormandPrinceRkn8, ExplicitEuler, Fixed, ImplicitEuler, ImplicitEulerLinearised,
    ImplicitMidpoint, Rk4, Stepper, TrBdf2, VelocityVerlet,
};
use hooke_firmware::smallest::{Scene, fill, step};

type Room = Fixed<4, 4, 1>;

/// What a program might step with some day.
#[allow(dead_code, reason = "that nothing calls it is what this program is for")]
fn step_by_any(world: &mut Scene) -> bool {
    fn by(world: &mut Scene, stepper: &mut impl Stepper<f32>) -> bool {
        world.step(stepper, &mut hooke::TimeOfImpact::<f32, Room>::new(), 1e-3).is_ok()
    }
    by(world, &mut ExplicitEuler)
        && by(world, &mut VelocityVerlet::<f32, Room>::new())
        && by(world, &mut Rk4::<f32, Room>::new())
        && by(world, &mut BlanesMoanS6::<f32, Room>::new())
        && by(world, &mut Dop853::<f32, Room>::new())
        && by(world, &mut DormandPrinceRkn8::<f32, Room>::new())
        && by(world, &mut ImplicitEuler::<f32, Room>::new(1e-5))
        && by(world, &mut ImplicitEulerLinearised::<f32, Room>::new(1e-5))
        && by(world, &mut ImplicitMidpoint::<f32, Room>::new(1e-5))
        && by(world, &mut TrBdf2::<f32, Room>::new(1e-5))
        && by(world, &mut Auto::<f32, Room>::new(1e-5))
}

#[entry]
fn main() -> ! {
    static mut WORLD: Scene = Scene::new();
    let mut going = fill(WORLD).is_some();
    while going {
        going = step(WORLD);
    }
    loop {
        cortex_m::asm::wfi();
    }
}
