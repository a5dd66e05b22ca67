//! Simplifies a mesh to a given number of triangles.
//!
//! Run with `cargo run --release -p striata --example one_level -- bunny.ply 5000 bunny-5k.glb`.

use std::error::Error;

use striata::simplify::{SimplifyOptions, Target, simplify};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [input, triangles, output] = &arguments[..] else {
        return Err("usage: one_level INPUT TRIANGLES OUTPUT".into());
    };
    let mesh = striata_io::read(input)?;
    let options = SimplifyOptions::default().with_target(Target::Triangles(triangles.parse()?));
    let level = simplify(&mesh, &options)?;
    striata_io::write(output, &level.mesh, &Default::default())?;
    eprintln!("{output}: {} triangles, error {}", level.mesh.triangle_count(), level.error);
    Ok(())
}
