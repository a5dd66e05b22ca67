//! The committed header is the one that cbindgen writes.

use std::env;
use std::fs;
use std::path::Path;

/// Writes the header with `STRIATA_WRITE_HEADER=1 cargo test -p striata-capi --test capi`.
#[test]
fn the_header_is_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(folder.join("cbindgen.toml")).expect("a configuration");
    let builder = cbindgen::Builder::new().with_config(config).with_src(folder.join("src/lib.rs"));
    let mut written = Vec::new();
    builder.generate().expect("bindings").write(&mut written);
    let header = without_safety(&String::from_utf8(written).expect("text"));
    let path = folder.join("include/striata.h");
    if env::var_os("STRIATA_WRITE_HEADER").is_some() {
        fs::write(&path, &header).expect("the header is written");
    }
    let found = fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    assert!(found == header, "include/striata.h is stale; set STRIATA_WRITE_HEADER=1 to write it");
}

/// Leaves out the safety sections: the beginning of the header says what holds for all pointers.
fn without_safety(header: &str) -> String {
    let (mut kept, mut is_safety): (Vec<&str>, bool) = (Vec::new(), false);
    for line in header.lines() {
        if line == "// # Safety" {
            is_safety = true;
            kept.pop_if(|line| *line == "//");
        } else if !line.starts_with("//") {
            is_safety = false;
        }
        if !is_safety {
            kept.push(line);
        }
    }
    kept.join("\n") + "\n"
}
