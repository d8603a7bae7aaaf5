//! `smallest` with one index that may be out of bounds: the negative control of the check that nothing can panic.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use hooke_firmware::smallest::{Scene, fill, step};

#[entry]
fn main() -> ! {
    static mut WORLD: Scene = Scene::new();
    let mut going = fill(WORLD).is_some();
    let taken = [1_u8, 2, 3];
    while going {
        let steps = WORLD.time() as usize;
        going = step(WORLD) && taken[steps] > 0;
    }
    loop {
        cortex_m::asm::wfi();
    }
}
