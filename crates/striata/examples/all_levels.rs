//! Stores every level of detail of a mesh in one file, then opens the file and extracts some levels.
//!
//! Run with `cargo run --release -p striata --example all_levels -- bunny.ply bunny.striata`.

use std::error::Error;

use striata::{Lod, LodOptions, Target};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [input, output] = &arguments[..] else {
        return Err("usage: all_levels INPUT OUT.striata".into());
    };
    let lod = Lod::build(&striata_io::read(input)?, &LodOptions::default())?;
    striata_io::save(output, &lod)?;

    // Later, in another program, extract any level; all levels share one vertex buffer.
    let lod = striata_io::open(output)?;
    for percent in [100, 50, 25, 10, 5, 2, 1] {
        let triangle_count = lod.mesh().triangle_count() * percent / 100;
        let level = lod.level(Target::Triangles(triangle_count));
        eprintln!(
            "{percent:>3} %: {} triangles over the first {} vertices, error {}",
            level.triangle_count(),
            level.vertex_count(),
            level.error()
        );
    }
    Ok(())
}
