//! Words in and out of the machine, through the debugger that QEMU plays.
#![allow(unsafe_code, reason = "a call of the debugger hands it addresses")]

use core::fmt;

use cortex_m_semihosting::{hio, nr, syscall1};

/// The debugger has no command line for the program, or a longer one than there is room for.
#[derive(Clone, Copy, Debug)]
pub struct NoCommandLine;

/// The command line of the program.
pub fn command_line(room: &mut [u8]) -> Result<&str, NoCommandLine> {
    let mut block = [room.as_mut_ptr() as usize, room.len()];
    // SAFETY: the block holds the address and the length of room that is lent for the time of the call.
    let answer = unsafe { syscall1(nr::GET_CMDLINE, block.as_mut_ptr() as usize) };
    let line = room.get(..block[1]).filter(|_| answer == 0).ok_or(NoCommandLine)?;
    core::str::from_utf8(line).map_err(|_| NoCommandLine)
}

/// Standard output, a line at a time: each call of the debugger stops the machine.
pub struct Lines {
    out: hio::HostStream,
    line: [u8; 256],
    length: usize,
}

impl Lines {
    pub fn new() -> Result<Self, fmt::Error> {
        let out = hio::hstdout().map_err(|_| fmt::Error)?;
        Ok(Self { out, line: [0; 256], length: 0 })
    }

    pub fn flush(&mut self) -> fmt::Result {
        let written = self.out.write_all(self.line.get(..self.length).unwrap_or_default());
        self.length = 0;
        written.map_err(|_| fmt::Error)
    }
}

impl fmt::Write for Lines {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            if self.length == self.line.len() {
                self.flush()?;
            }
            if let Some(place) = self.line.get_mut(self.length) {
                *place = byte;
                self.length += 1;
            }
            if byte == b'\n' {
                self.flush()?;
            }
        }
        Ok(())
    }
}
