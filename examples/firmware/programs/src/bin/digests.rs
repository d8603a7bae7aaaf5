//! Every stepper on every scene, its digest told over semihosting: the lines are those of the desktop.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use hooke_firmware::console::Console;
use hooke_firmware::{end_at_faults, finish};
use hooke_firmware_scenes::{Exported, Many, exported, many};

end_at_faults!();

#[entry]
fn main() -> ! {
    static mut MANY: Many = Many::EMPTY;
    static mut EXPORTED: Exported = Exported::EMPTY;
    many(MANY, &mut Console);
    exported(EXPORTED, &mut Console);
    finish(true)
}
