//! What a page calls. It writes through the pointers that it is given; no code here does.
#![expect(unsafe_code, reason = "names that a page can call are not mangled, which the compiler counts as unsafe")]

use std::cell::RefCell;

thread_local! {
    static REQUEST: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Where a request of `length` bytes is to be written.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    REQUEST.with_borrow_mut(|request| {
        request.clear();
        request.resize(length, 0);
        request.as_mut_ptr()
    })
}

/// Answers what was written: 1 if the answer is a scene, 0 if it is a refusal.
#[unsafe(no_mangle)]
pub extern "C" fn read() -> u32 {
    let request = REQUEST.take();
    let (is_scene, bytes) = crate::answer(&request);
    ANSWER.set(bytes);
    u32::from(is_scene)
}

/// Where the answer is.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.as_ptr())
}

/// How long it is, bytes.
#[unsafe(no_mangle)]
pub extern "C" fn answer_length() -> usize {
    ANSWER.with_borrow(Vec::len)
}
