//! Where the memory of QEMU's machines lies. The stack has the lowest addresses of the RAM: below it is nothing, so that one
//! that overflows faults, and overwrites no world.

use std::path::PathBuf;
use std::{env, fs, io};

/// Sizes of flash, RAM, and the stack in it.
type Sizes = [&'static str; 3];

/// BBC micro:bit, a Cortex-M0.
const MICROBIT: Sizes = ["256K", "16K", "12K"];
/// MPS2, with the FPGA images AN385, a Cortex-M3, or AN386, a Cortex-M4.
const MPS2: Sizes = ["4M", "4M", "256K"];

fn main() -> io::Result<()> {
    let target = env::var("TARGET").unwrap_or_default();
    let roomy = env::var_os("CARGO_FEATURE_MPS2").is_some();
    let [flash, ram, stack] = if target.starts_with("thumbv6m") && !roomy { MICROBIT } else { MPS2 };
    let folder = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    let memory = format!(
        "MEMORY {{\n    FLASH : ORIGIN = 0, LENGTH = {flash}\n    RAM : ORIGIN = 0x20000000 + {stack}, LENGTH = {ram} - {stack}\n}}\n\
         _stack_end = 0x20000000;\n_stack_start = 0x20000000 + {stack};\n"
    );
    fs::write(folder.join("memory.x"), memory)?;
    // The programs' table of interrupts needs no names.
    fs::write(folder.join("device.x"), "")?;
    println!("cargo:rustc-link-search={}", folder.display());
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    println!("cargo:rerun-if-changed=build.rs");
    Ok(())
}
