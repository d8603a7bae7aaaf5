//! Instructions and stack of a step of a cloth of 10 × 10, by every stepper: a line each.
#![no_std]
#![no_main]

use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m_rt::entry;
use cortex_m_semihosting::hprintln;
use hooke::{
    Auto, BlanesMoanS6, Dop853, ExplicitEuler, Fixed, ImplicitEuler, ImplicitEulerLinearised, ImplicitMidpoint,
    Project, Rk4, SemiImplicitEuler, Stepper, TrBdf2, VelocityVerlet, World,
};
use hooke_firmware::{counter, end_at_faults, finish, stack};
use hooke_firmware_scenes::cloth;

type Cloth = World<f32, 100, 502, 0>;
type Room = Fixed<100, 502, 0>;

/// Steps that are measured together.
const STEPS: u32 = 10;
/// At which implicit steps count as solved.
const TOLERANCE: f64 = 1e-5;

fn measure(clock: &mut SYST, world: &mut Cloth, name: &str, stepper: Option<&mut impl Stepper<f32>>) -> bool {
    *world = World::new();
    let (Some(()), Some(stepper)) = (cloth(world, 10), stepper) else { return false };
    let mut step = |world: &mut Cloth| world.step(stepper, &mut Project, 1.0 / 512.0).is_ok();
    // The first one prepares the world: that is in the stack, and not in the instructions.
    let mut taken = true;
    let bytes = stack::used_by(|| taken &= step(world));
    let instructions = counter::instructions(clock, || {
        for _ in 0..STEPS {
            taken &= step(world);
        }
    });
    hprintln!("{} {} {}", name, instructions / STEPS, bytes);
    taken
}

end_at_faults!();

#[entry]
fn main() -> ! {
    static mut WORLD: Cloth = World::new();
    let Some(mut peripherals) = Peripherals::take() else { finish(false) };
    let clock = &mut peripherals.SYST;
    let mut done = true;
    macro_rules! measure {
        ($name:literal, $kind:ty, $new:expr) => {
            done &= measure(clock, WORLD, $name, cortex_m::singleton!(: $kind = $new));
        };
    }
    measure!("explicit-euler", ExplicitEuler, ExplicitEuler);
    measure!("semi-implicit-euler", SemiImplicitEuler, SemiImplicitEuler);
    measure!("velocity-verlet", VelocityVerlet<f32, Room>, VelocityVerlet::new());
    measure!("rk4", Rk4<f32, Room>, Rk4::new());
    measure!("blanes-moan-s6", BlanesMoanS6<f32, Room>, BlanesMoanS6::new());
    measure!("dop853", Dop853<f32, Room>, Dop853::new());
    measure!("implicit-euler", ImplicitEuler<f32, Room, 2>, ImplicitEuler::new(TOLERANCE));
    measure!("implicit-euler-linearised", ImplicitEulerLinearised<f32, Room, 2>, ImplicitEulerLinearised::new(TOLERANCE));
    measure!("implicit-midpoint", ImplicitMidpoint<f32, Room, 2>, ImplicitMidpoint::new(TOLERANCE));
    measure!("tr-bdf2", TrBdf2<f32, Room, 2>, TrBdf2::new(TOLERANCE));
    measure!("auto", Auto<f32, Room, 2>, Auto::new(TOLERANCE));
    finish(done)
}
