//! How much of the stack is used at most: it is painted, and looked at afterwards.
#![allow(unsafe_code, reason = "memory below the stack pointer, which belongs to nobody")]

use core::ptr;

use cortex_m::register::msp;

/// A word that hardly anybody writes.
const PAINT: u32 = 0xa5a5_5a5a;
/// Bytes just below the stack pointer that the functions here may need themselves.
const OWN: u32 = 512;

unsafe extern "C" {
    /// The lowest word of the stack, and where it starts; the linker script has them.
    static _stack_end: u32;
    static _stack_start: u32;
}

/// Bytes of the stack that were used at most since it was painted, from its top; it is painted anew, below the caller.
#[inline(never)]
pub fn high_water() -> u32 {
    // SAFETY: these words are aligned, and lie in the stack and below its pointer; nothing but functions that are called
    // later uses them, and `OWN` keeps clear of this one's calls. Any bits are a number.
    let untouched = words().take_while(|word| unsafe { ptr::read_volatile(*word) } == PAINT).count();
    // SAFETY: likewise.
    words().for_each(|word| unsafe { ptr::write_volatile(word, PAINT) });
    address(&raw const _stack_start) - address(&raw const _stack_end) - 4 * untouched as u32
}

/// Bytes of the stack that `work` uses, below what its caller has of it.
pub fn used_by(work: impl FnOnce()) -> u32 {
    high_water();
    work();
    high_water() - (address(&raw const _stack_start) - msp::read())
}

fn address(symbol: *const u32) -> u32 {
    symbol as u32
}

/// The words from the end of the stack to those that are in use.
fn words() -> impl Iterator<Item = *mut u32> {
    let used = (msp::read() & !3) - OWN;
    (address(&raw const _stack_end)..used).step_by(4).map(|address| address as *mut u32)
}
