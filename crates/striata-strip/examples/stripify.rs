//! Compares three stripifiers on a mesh.
//!
//! `cargo run --release -p striata-strip --example stripify -- bunny.ply`

use std::error::Error;

use striata_strip::{StripOptions, Stripifier, stripify};

fn main() -> Result<(), Box<dyn Error>> {
    let input = std::env::args().nth(1).ok_or("usage: stripify INPUT")?;
    let mesh = striata_io::read(&input)?;
    for stripifier in [Stripifier::Greedy, Stripifier::Tunnel { max_length: 17 }, Stripifier::Cheapest] {
        let strips = stripify(&mesh, &StripOptions::default().with_stripifier(stripifier))?;
        let cost = strips.cost();
        let indices = strips.to_restart_indices().indices;
        eprintln!(
            "{stripifier}: {} strips, {} indices, {:.3} per triangle",
            cost.strip_count,
            indices.len(),
            indices.len() as f64 / mesh.triangle_count() as f64
        );
    }
    Ok(())
}
