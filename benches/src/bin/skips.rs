//! What leaving something out gains, and what it costs to look whether it can be: time, in turns, and instructions, as
//! far as valgrind is there to count them.
//!
//! `cargo run --release -p hooke-benches --bin skips` prints a table and writes `benches/results/skip.csv`.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use hooke_benches::interleaved::{Contender, least_times};
use hooke_benches::skips::{PAIRS, Pair, Shows};
use hooke_benches::stamp::stamp;

const ROUNDS: u32 = 15;
const STEPS: u32 = 100;
/// Steps under valgrind: those of the shorter run are taken from those of the longer one, and with them the set-up.
const COUNTED: [u32; 2] = [20, 60];

fn main() -> std::io::Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [pair, side, steps] = arguments.as_slice() {
        take(pair, side, steps);
        return Ok(());
    }
    let mut csv = format!("# {}\npair,shows,side,ns_per_step,instructions_per_step\n", stamp());
    println!("{:28} {:>10} {:>10} {:>7}   {:>12} {:>12}", "", "ns with", "without", "ratio", "instr. with", "without");
    for pair in &PAIRS {
        let mut contenders: Vec<Contender<'_>> =
            vec![("with".to_owned(), (pair.with)()), ("without".to_owned(), (pair.without)())];
        let times = least_times(&mut contenders, ROUNDS, STEPS);
        let counts = ["with", "without"].map(|side| instructions(pair, side));
        let told = counts.map(|count| count.map_or_else(|| "not counted".to_owned(), |count| format!("{count:.0}")));
        let (with, without, ratio) = (times[0], times[1], times[0] / times[1]);
        print!("{:28} {with:10.0} {without:10.0} {ratio:7.2}   {:>12} {:>12}", pair.name, told[0], told[1]);
        match (pair.shows, counts) {
            (Shows::Cost, [Some(with), Some(without)]) => {
                println!("   costs {:.2} % more instructions", 100.0 * (with / without - 1.0));
            }
            _ => println!(),
        }
        for (side, (time, count)) in ["with", "without"].into_iter().zip(times.iter().zip(&told)) {
            let _ = writeln!(csv, "{},{:?},{side},{time:.0},{count}", pair.name, pair.shows);
        }
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("results");
    std::fs::create_dir_all(&folder)?;
    std::fs::write(folder.join("skip.csv"), csv)
}

/// What is run under valgrind: one side of one pair.
fn take(name: &str, side: &str, steps: &str) {
    let (Some(pair), Ok(count)) = (PAIRS.iter().find(|pair| pair.name == name), steps.parse()) else {
        eprintln!("no such pair, or no number of steps: {name:?} {steps:?}");
        return;
    };
    let make = if side == "with" { pair.with } else { pair.without };
    make()(count);
}

/// Of a step; nothing if nobody counts them.
fn instructions(pair: &Pair, side: &str) -> Option<f64> {
    let own = std::env::current_exe().ok()?;
    let [fewer, more] = COUNTED.map(|steps| {
        let valgrind = Command::new("valgrind")
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(&own)
            .args([pair.name, side, &steps.to_string()])
            .output()
            .ok()?;
        let told = String::from_utf8_lossy(&valgrind.stderr).into_owned();
        let collected = told.lines().find_map(|line| line.split_once("Collected : "))?.1;
        collected.trim().parse::<f64>().ok()
    });
    Some((more? - fewer?) / f64::from(COUNTED[1] - COUNTED[0]))
}
