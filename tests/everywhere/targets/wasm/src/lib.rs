//! Steps the rows in WebAssembly: `page.js` beside it knows how to ask.
#![cfg_attr(target_arch = "wasm32", no_std)]

#[cfg(target_arch = "wasm32")]
mod exports;
