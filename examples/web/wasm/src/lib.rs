//! Hooke for WebAssembly: the functions of the C interface, in single precision, on the memory that whoever loads the
//! module lays out: worlds are made anywhere above `__heap_base`.
#![no_std]

pub use hooke_c::*;
