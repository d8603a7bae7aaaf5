//! What cortex-m-rt asks of a device: its interrupts, of which these programs use none.
#![allow(unsafe_code, reason = "symbols that are linked by their names")]

use core::panic::PanicInfo;

use crate::fault::end;

// SAFETY: the linker script asks for a table of this name in this section; one entry of 0 is none that is ever taken.
#[unsafe(link_section = ".vector_table.interrupts")]
#[unsafe(no_mangle)]
static __INTERRUPTS: [u32; 1] = [0];

/// A program in which nothing can panic does not contain this.
#[panic_handler]
fn panicked(_: &PanicInfo<'_>) -> ! {
    end("panic")
}
