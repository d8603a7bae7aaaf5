//! Steps the rows on a Cortex-M4F: the command line is the question.
#![no_std]
#![no_main]

mod semihosting;

use core::fmt::Write;
use core::panic::PanicInfo;

use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{EXIT_FAILURE, EXIT_SUCCESS, exit};
use hooke::Lanes;
use hooke_everywhere::{Machine, answer};
use semihosting::{Lines, command_line};

#[entry]
fn main() -> ! {
    let mut room = [0; 256];
    let machine = Machine { lanes: Lanes::Baseline, workers: None };
    let answered = match (command_line(&mut room), Lines::new()) {
        (Ok(line), Ok(mut lines)) => {
            // The first word is the program's name.
            let question = line.split_once(' ').map_or("", |(_, question)| question);
            answer(question, machine, &mut lines).is_ok()
        }
        _ => false,
    };
    exit(if answered { EXIT_SUCCESS } else { EXIT_FAILURE });
    loop {
        cortex_m::asm::wfi();
    }
}

#[panic_handler]
fn panicked(info: &PanicInfo<'_>) -> ! {
    if let Ok(mut lines) = Lines::new() {
        let _ = writeln!(lines, "{info}");
        let _ = lines.flush();
    }
    exit(EXIT_FAILURE);
    loop {
        cortex_m::asm::wfi();
    }
}
