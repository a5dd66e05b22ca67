//! Prepares a chain of levels for an engine: one vertex buffer for each mesh, and for each level one index list for
//! each material, with the error that decides when to switch.
//!
//! ```text
//! cargo run --release -p striata-scene --example engine_levels -- robot.glb
//! ```

use std::error::Error;

use striata::mesh::shapes;
use striata::{LodOptions, Target};
use striata_io::{Scene, read_scene};
use striata_scene::LodScene;

fn main() -> Result<(), Box<dyn Error>> {
    let scene = match std::env::args().nth(1) {
        Some(path) => read_scene(path)?,
        None => Scene::from_mesh(shapes::torus(64, 32, 1.0, 0.4))?,
    };
    let lods = LodScene::build(&scene, &LodOptions::default())?;
    let full = lods.full_scene();
    for (number, mesh) in full.meshes().iter().enumerate() {
        let Some(mesh) = mesh else { continue };
        // Upload `mesh.positions` and `mesh.layers` once.
        eprintln!("mesh {number}: {} vertices for all levels", mesh.vertex_count());
    }
    // Each level has half of the triangles of the one before.
    for lod in 0..6 {
        let level = lods.level(Target::Triangles(lods.triangle_count() >> lod));
        let indices = lods.indices(&level);
        let counts: Vec<Vec<usize>> =
            indices.iter().map(|lists| lists.iter().map(Vec::len).collect()).collect();
        eprintln!("LOD{lod}: error {:.6}, indices of each primitive {counts:?}", level.error);
        // At distance d, an error e covers e * height / (2 d tan(fov / 2)) pixels.
        let (height, half_angle) = (1080.0, 30.0f64.to_radians());
        eprintln!("      one pixel at distance {:.1}", level.error * height / (2.0 * half_angle.tan()));
    }
    Ok(())
}
