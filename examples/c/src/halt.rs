//! The end of a program that cannot go on. No step panics; this is what the linker asks for.
#![allow(unsafe_code, reason = "the C library's function is a foreign one")]

#[panic_handler]
fn panicked(_: &core::panic::PanicInfo<'_>) -> ! {
    #[cfg(target_arch = "wasm32")]
    core::arch::wasm32::unreachable();
    #[cfg(not(target_arch = "wasm32"))]
    {
        unsafe extern "C" {
            fn abort() -> !;
        }
        // SAFETY: it is the C library's, and takes nothing.
        unsafe { abort() }
    }
}

/// The compiled library that comes with Rust names it in its tables for unwinding, which nobody reads: a panic aborts.
#[cfg(not(target_arch = "wasm32"))]
#[unsafe(no_mangle)]
extern "C" fn rust_eh_personality() {}
