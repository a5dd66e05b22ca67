//! Damaged binary files are refused with the place and the reason.

use striata::mesh::shapes;
use striata_io::Format;

use super::{Folder, bytes_of, mixed_ply};

#[test]
fn damaged_ply_files_are_refused() {
    let folder = Folder::new();
    let mesh = shapes::torus(15, 10, 2.0, 0.5);
    let bytes = bytes_of(Format::Ply, &mesh, false);
    for length in [bytes.len() - 1, bytes.len() / 2, 40] {
        folder.error("cut.ply", &bytes[..length]);
    }
    let mut bad = bytes.clone();
    let last = bad.len() - 4;
    bad[last..].copy_from_slice(&9999u32.to_le_bytes());
    let message = folder.error("index.ply", &bad);
    assert!(message.contains("vertex 9999 does not exist: there are 150"), "{message}");
    assert!(message.contains(&format!("byte {last}")), "{message}");
    let body = bytes.windows(11).position(|w| w == b"end_header\n").unwrap() + 11;
    let text = String::from_utf8_lossy(&bytes[..body]).replace("vertex 150", "vertex 4000000000");
    let giant = [text.as_bytes(), &bytes[body..]].concat();
    assert!(folder.error("giant.ply", &giant).contains("4000000000 rows of `vertex` are declared"));
    let mut long = mixed_ply();
    let body = long.windows(11).position(|w| w == b"end_header\n").unwrap() + 11 + 5;
    long[body..body + 4].copy_from_slice(&u32::MAX.to_be_bytes());
    folder.error("long.ply", &long);
}

#[test]
fn damaged_stl_files_are_refused() {
    let folder = Folder::new();
    let bytes = bytes_of(Format::Stl, &shapes::torus(15, 10, 2.0, 0.5), false);
    assert!(folder.error("cut.stl", &bytes[..bytes.len() - 1]).contains("the header declares 300 triangles"));
    assert!(folder.error("unknown.qqq", b"hello").contains("neither the content nor the extension"));
}
