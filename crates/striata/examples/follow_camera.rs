//! Refines a view-dependent instance while a camera approaches.
//!
//! Run with `cargo run --release -p striata --example follow_camera -- bunny.ply`.

use std::error::Error;
use std::time::Instant;

use striata::view::Camera;
use striata::{Lod, LodOptions};

fn main() -> Result<(), Box<dyn Error>> {
    let input = std::env::args().nth(1).ok_or("usage: follow_camera INPUT")?;
    let lod = Lod::build(&striata_io::read(&input)?, &LodOptions::default())?;
    let bounds = lod.mesh().bounds().ok_or("the mesh has no vertices")?;
    let center = [0, 1, 2].map(|axis| (bounds.min[axis] + bounds.max[axis]) / 2.0);
    let diagonal = lod.mesh().diagonal() as f32;

    let mut view = lod.view();
    for frame in 0..=10 {
        // Move from 4 diagonals away to a tenth of a diagonal.
        let distance = diagonal * (4.0 - 0.39 * frame as f32);
        let eye = [center[0], center[1], center[2] + distance];
        let camera = Camera::new(eye, center, [0.0, 1.0, 0.0], 0.577, [1920, 1080])?;
        let started = Instant::now();
        let update = view.update(&camera, 1.0);
        eprintln!(
            "frame {frame}: {} triangles, {} steps changed, {:.2} ms",
            view.triangle_count(),
            update.split_count + update.collapse_count,
            1e3 * started.elapsed().as_secs_f64()
        );
        // Draw view.indices() over the vertices of lod.mesh().
    }
    Ok(())
}
