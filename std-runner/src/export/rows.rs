//! Numbers, vectors and tables as Rust source.

use std::fmt::{Debug, Write};

use hooke::Real;

/// A number in its shortest form that reads back to the same bits.
pub fn number<R: Real>(value: f64) -> String {
    debug(R::from_f64(value))
}

/// Any value as Rust writes it: for a float, that form.
pub fn debug(value: impl Debug) -> String {
    format!("{value:?}")
}

/// Three of them.
pub fn vector<R: Real>([x, y, z]: [f64; 3]) -> String {
    format!("[{}, {}, {}]", number::<R>(x), number::<R>(y), number::<R>(z))
}

/// A table: a row a line.
pub fn table(name: &str, kind: &str, length: &str, about: &str, rows: impl Iterator<Item = String>) -> String {
    let mut text = format!("\n/// {about}\npub static {name}: [{kind}; {length}] = [\n");
    for row in rows {
        let _ = writeln!(text, "    {row},");
    }
    text.push_str("];\n");
    text
}

/// A constant.
pub fn constant(name: &str, kind: &str, value: &str, about: &str) -> String {
    format!("\n/// {about}\npub const {name}: {kind} = {value};\n")
}
