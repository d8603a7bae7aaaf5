//! The header says what the library has.
#![allow(clippy::expect_used, reason = "a test fails where it cannot go on")]

use std::fs::{read_to_string, write};
use std::path::Path;

/// With `HOOKE_WRITE_HEADER` set it is written anew instead.
#[test]
fn the_header_is_that_of_the_library() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let configuration = cbindgen::Config::from_file(folder.join("cbindgen.toml")).expect("its configuration is sound");
    let interface =
        ["create.rs", "add.rs", "change.rs", "step.rs", "read.rs", "keep.rs"].map(|name| format!("interface/{name}"));
    let sources = ["block.rs", "code.rs", "options.rs", "report.rs"].map(str::to_owned).into_iter().chain(interface);
    let builder = sources.fold(cbindgen::Builder::new().with_config(configuration), |builder, source| {
        builder.with_src(folder.join("src").join(source))
    });
    let mut bytes = Vec::new();
    builder.generate().expect("the sources can be read").write(&mut bytes);
    let header = String::from_utf8(bytes).expect("it is text");
    let file = folder.join("hooke.h");
    if std::env::var_os("HOOKE_WRITE_HEADER").is_some() {
        write(&file, &header).expect("it can be written");
    }
    let kept = read_to_string(file).expect("there is a header");
    assert!(
        kept == header,
        "hooke.h is not that of the library: HOOKE_WRITE_HEADER=1 cargo test --features std --test header"
    );
    for function in ["hooke_create", "hooke_step", "hooke_restore", "hooke_digest"] {
        assert!(header.contains(&format!("{function}(")), "{function}");
    }
}
