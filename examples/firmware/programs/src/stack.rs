//! How much of the stack is used at most: it is painted, and looked at afterwards.
#![allow(unsafe_code, reason = "memory below the stack pointer, which belongs to nobody")]

use core::ptr;

use cortex_m::register::msp;

/// A word that hardly anybody writes.
const PAINT: u32 = 0xa5a5_5a5a;
/// Bytes just below the stack pointer that the functions here may need themselves.
const OWN: u32 = 512;

/// Bytes of the stack that `work` uses, of `most` bytes below the caller's; 0 if it uses all of them.
#[inline(never)]
pub fn high_water(most: u32, work: impl FnOnce()) -> u32 {
    let top = msp::read() & !3;
    let bottom = top - most;
    let words = |from: u32, to: u32| (from..to).step_by(4).map(|address| address as *mut u32);
    // SAFETY: these words lie below the stack pointer and above all statics, as `most` is less than the rest of the RAM;
    // nothing but the stack of functions that are called later uses them, and `OWN` keeps clear of this one's calls.
    words(bottom, top - OWN).for_each(|word| unsafe { ptr::write_volatile(word, PAINT) });
    work();
    // SAFETY: likewise; they are aligned, and any bits are a number.
    let untouched = words(bottom, top - OWN).take_while(|word| unsafe { ptr::read_volatile(*word) } == PAINT).count();
    if untouched == 0 { 0 } else { most - 4 * untouched as u32 }
}
