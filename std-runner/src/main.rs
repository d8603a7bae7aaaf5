//! The command line `hooke`.

fn main() {}
