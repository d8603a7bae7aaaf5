//! What fits into 16 KiB of RAM, told likewise, and what it takes of the stack.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use hooke_firmware::console::Watching;
use hooke_firmware::{end_at_faults, finish};
use hooke_firmware_scenes::{Few, few};

end_at_faults!();

#[entry]
fn main() -> ! {
    static mut FEW: Few = Few::EMPTY;
    let mut watching = Watching::new();
    few(FEW, &mut watching);
    watching.finish();
    finish(true)
}
