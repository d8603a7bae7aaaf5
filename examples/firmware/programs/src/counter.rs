//! Instructions, counted. Under `qemu -icount shift=0` each takes a nanosecond, and SysTick counts those.

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// What SysTick counts down from: all of its 24 bits.
const RELOAD: u32 = 0x00ff_ffff;

/// Instructions from one tick to the next: the clock of the MPS2's core is 25 MHz.
const PER_TICK: u32 = 40;

/// Counts the instructions that `work` takes, up to 671 million, to 40.
pub fn instructions(clock: &mut SYST, work: impl FnOnce()) -> u32 {
    clock.set_clock_source(SystClkSource::Core);
    clock.set_reload(RELOAD);
    clock.clear_current();
    clock.enable_counter();
    let start = SYST::get_current();
    work();
    let end = SYST::get_current();
    clock.disable_counter();
    (start.wrapping_sub(end) & RELOAD) * PER_TICK
}
