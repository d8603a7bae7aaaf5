//! Where the memory of QEMU's machines lies.

use std::path::PathBuf;
use std::{env, fs, io};

/// BBC micro:bit, a Cortex-M0.
const MICROBIT: &str = "MEMORY { FLASH : ORIGIN = 0, LENGTH = 256K  RAM : ORIGIN = 0x20000000, LENGTH = 16K }\n";
/// MPS2 with the FPGA image AN386, a Cortex-M4.
const MPS2: &str = "MEMORY { FLASH : ORIGIN = 0, LENGTH = 4M  RAM : ORIGIN = 0x20000000, LENGTH = 4M }\n";

fn main() -> io::Result<()> {
    let target = env::var("TARGET").unwrap_or_default();
    let folder = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    fs::write(folder.join("memory.x"), if target.starts_with("thumbv6m") { MICROBIT } else { MPS2 })?;
    // The programs' table of interrupts needs no names.
    fs::write(folder.join("device.x"), "")?;
    println!("cargo:rustc-link-search={}", folder.display());
    println!("cargo:rustc-link-arg-bins=-Tlink.x");
    println!("cargo:rerun-if-changed=build.rs");
    Ok(())
}
