//! `digests` without a word: nothing that it steps, by any stepper, in either precision, with any response, can panic.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use hooke::StepError;
use hooke_firmware as _;
use hooke_firmware_scenes::{Exported, Many, Tell, exported, many};

struct Nobody;

impl Tell for Nobody {
    fn tell(&mut self, _: &str, _: &str, digest: Result<u64, StepError>) {
        let _ = black_box(digest);
    }
}

#[entry]
fn main() -> ! {
    static mut MANY: Many = Many::EMPTY;
    static mut EXPORTED: Exported = Exported::EMPTY;
    many(MANY, &mut Nobody);
    exported(EXPORTED, &mut Nobody);
    loop {
        cortex_m::asm::wfi();
    }
}
