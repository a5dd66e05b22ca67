//! Passes arbitrary files to the reader in blocks: the result is blocks with valid vertices, which can be
//! stripified and written, or an error.
#![no_main]

use std::path::PathBuf;

use libfuzzer_sys::fuzz_target;
use striata_fuzz::allow_contained_panics;
use striata_io::{Format, StripSpool, TriangleBlocks};
use striata_strip::{BlockOptions, stripify_blocks};

const NAMES: [&str; 7] = ["x.ply", "x.obj", "x.stl", "x.off", "x.gltf", "x.glb", "x.obj.zst"];

fuzz_target!(|data: &[u8]| {
    let Some((&name, bytes)) = data.split_first() else { return };
    allow_contained_panics();
    let folder = folder();
    let path = folder.join(NAMES[usize::from(name) % NAMES.len()]);
    std::fs::write(&path, bytes).expect("the folder is writable");
    if let Ok(mut blocks) = TriangleBlocks::open(&path, 7, &folder) {
        let vertex_count = blocks.vertex_count();
        let mut spool = StripSpool::new(Format::Ply, &folder).expect("PLY can be written");
        let report = stripify_blocks(&mut blocks, &BlockOptions::default(), &mut |_, strip| {
            assert!(
                strip.iter().all(|&vertex| vertex < vertex_count),
                "a strip uses a vertex that is missing"
            );
            spool.push(strip)
        });
        // An index may be the one that is reserved for restarts.
        if report.is_ok() {
            let _ = spool.write(&folder.join("out.ply"), &blocks);
        }
    }
});

/// A folder of this process.
fn folder() -> PathBuf {
    let folder = std::env::temp_dir().join(format!("striata-fuzz-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("the folder for temporary files is writable");
    folder
}
