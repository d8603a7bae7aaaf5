//! Overflows its stack: the negative control of the checks that a program ends well.
#![no_std]
#![no_main]

use core::hint::black_box;

use cortex_m_rt::entry;
use hooke_firmware::{end_at_faults, finish};

end_at_faults!();

#[inline(never)]
fn deeper(depth: u32) -> u32 {
    let room = black_box([depth; 64]);
    black_box(if depth == 0 { 0 } else { deeper(depth - 1) }) + room.len() as u32
}

#[entry]
fn main() -> ! {
    finish(deeper(100_000) > 0)
}
