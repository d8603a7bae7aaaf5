//! What fits into 16 KiB of RAM, told likewise.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use hooke_firmware::console::Console;
use hooke_firmware::finish;
use hooke_firmware_scenes::{Few, few};

#[entry]
fn main() -> ! {
    static mut FEW: Few = Few::EMPTY;
    few(FEW, &mut Console);
    finish(true)
}
