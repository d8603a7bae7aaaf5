//! Bouncing balls in 16 KiB of RAM, told likewise, and what it takes of the stack.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use hooke_firmware::console::Watching;
use hooke_firmware::{end_at_faults, finish};
use hooke_firmware_scenes::{Balls, bouncing};

end_at_faults!();

#[entry]
fn main() -> ! {
    static mut BALLS: Balls = Balls::new();
    let mut watching = Watching::new();
    bouncing(BALLS, &mut watching);
    watching.finish();
    finish(true)
}
