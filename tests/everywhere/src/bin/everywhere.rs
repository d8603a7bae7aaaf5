//! Steps the rows on a machine with the standard library: `everywhere LANES THREADS [QUESTION]`.

use std::fmt::{self, Write};
use std::io::{self, Write as _};
use std::process::ExitCode;
use std::thread;

use hooke::{Lanes, Workers};
use hooke_everywhere::{Machine, answer};

/// So many threads, started anew each time: nothing here is in a hurry.
#[derive(Debug)]
struct Threads(u32);

impl Workers for Threads {
    fn count(&self) -> u32 {
        self.0
    }

    fn both(&self, first: &mut (dyn FnMut() + Send), second: &mut (dyn FnMut() + Send)) {
        thread::scope(|scope| {
            scope.spawn(first);
            second();
        });
    }
}

struct Out(io::BufWriter<io::Stdout>);

impl Write for Out {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write_all(text.as_bytes()).map_err(|_| fmt::Error)
    }
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [lanes, threads, question @ ..] = arguments.as_slice() else {
        eprintln!("everywhere LANES THREADS [QUESTION]; lanes are baseline, avx2 or avx512");
        return ExitCode::from(2);
    };
    let lanes = match lanes.as_str() {
        "baseline" => Lanes::Baseline,
        "avx2" => Lanes::Avx2,
        "avx512" => Lanes::Avx512,
        other => {
            eprintln!("{other}: lanes are baseline, avx2 or avx512");
            return ExitCode::from(2);
        }
    };
    if lanes > Lanes::widest() {
        eprintln!("this machine, or this build, has no {lanes:?}");
        return ExitCode::from(3);
    }
    let Ok(count @ 1..) = threads.parse() else {
        eprintln!("{threads}: not a number of threads");
        return ExitCode::from(2);
    };
    let threads = Threads(count);
    let machine = Machine { lanes, workers: (count > 1).then_some(&threads as &dyn Workers) };
    let mut out = Out(io::BufWriter::new(io::stdout()));
    let answered = answer(&question.join(" "), machine, &mut out);
    match (answered, out.0.flush()) {
        (Ok(()), Ok(())) => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    }
}
