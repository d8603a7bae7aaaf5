//! Semi-implicit Euler, springs and one plane, without a word: core and program together take less than 12 KiB.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use hooke_firmware::smallest::{Scene, fill, step};

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
