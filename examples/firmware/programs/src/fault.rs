//! What goes wrong is told and ends QEMU: nothing hangs.

use cortex_m_semihosting::hprintln;

use crate::finish;

/// Tells what went wrong, and ends QEMU with a failure.
pub fn end(what: &str) -> ! {
    hprintln!("{}", what);
    finish(false)
}

/// Ends a program so at a fault: a stack that overflows, an address where nothing is, an instruction that is none. What runs
/// without a word has no use for it.
#[macro_export]
macro_rules! end_at_faults {
    () => {
        /// A stack that has overflowed can hold nothing: this begins anew at its top.
        #[allow(unsafe_code, non_snake_case, reason = "the linker knows it by this name")]
        // SAFETY: the table of vectors asks for a function of this name, which does not come back.
        #[unsafe(naked)]
        #[unsafe(no_mangle)]
        extern "C" fn HardFault() -> ! {
            extern "C" fn tell() -> ! {
                $crate::fault::end("hard fault: the stack has overflowed, or an address is wrong")
            }
            core::arch::naked_asm!("ldr r0, =_stack_start", "mov sp, r0", "bl {tell}", ".pool", tell = sym tell)
        }
    };
}
