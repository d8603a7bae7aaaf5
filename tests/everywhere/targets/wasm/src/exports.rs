//! What a page sees of it.
#![allow(unsafe_code, reason = "functions that are known by name outside, and memory that both sides see")]

use core::fmt;
use core::panic::PanicInfo;

use hooke::Lanes;
use hooke_everywhere::{Machine, answer};

const ROOM: usize = 256;
static mut QUESTION: [u8; ROOM] = [0; ROOM];

// SAFETY: the page reads so many bytes from there while the call lasts.
#[link(wasm_import_module = "env")]
unsafe extern "C" {
    safe fn tell(start: *const u8, length: usize);
}

struct Page;

impl fmt::Write for Page {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        tell(text.as_ptr(), text.len());
        Ok(())
    }
}

/// Where the question has to be written to, at most 256 bytes of UTF-8.
// SAFETY: no other function has this name.
#[unsafe(no_mangle)]
pub extern "C" fn question() -> *mut u8 {
    (&raw mut QUESTION).cast()
}

/// Answers it through `tell`; 1 if it could.
// SAFETY: no other function has this name.
#[unsafe(no_mangle)]
pub extern "C" fn ask(length: usize) -> u32 {
    // SAFETY: there is one thread, and the page does not write while this runs.
    let bytes: &[u8] = unsafe { &*(&raw const QUESTION) };
    let question = bytes.get(..length).and_then(|bytes| core::str::from_utf8(bytes).ok());
    let machine = Machine { lanes: Lanes::Baseline, workers: None };
    u32::from(question.is_some_and(|question| answer(question, machine, &mut Page).is_ok()))
}

#[panic_handler]
fn panicked(_: &PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
