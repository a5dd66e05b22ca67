//! Times the library without Python, for `benchmarks/peers.py`: `one_level POINTS FACES TRIANGLES REPEATS`.
//!
//! The arrays are raw files of 32-bit numbers. Prints the seconds of each run of one level, then of the whole
//! sequence with the models of `Lod`, as two lines of numbers.

use std::env::args;
use std::error::Error;
use std::io::{Write as _, stdout};
use std::time::Instant;

use striata::mesh::IndexedMesh;
use striata::simplify::{SimplifyOptions, Target, simplify};
use striata::{Lod, LodOptions};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = args().skip(1).filter(|argument| argument != "--bench").collect();
    // `cargo test` runs benches without arguments.
    let [points, faces, triangles, repeats] = arguments.as_slice() else { return Ok(()) };
    let rows = |path: &str| -> Result<Vec<[u32; 3]>, Box<dyn Error>> {
        let words: Vec<u32> = bytemuck::pod_collect_to_vec(&std::fs::read(path)?);
        Ok(words.as_chunks::<3>().0.to_vec())
    };
    let positions = rows(points)?.into_iter().map(|row| row.map(f32::from_bits)).collect();
    let mesh = IndexedMesh::new(positions, rows(faces)?);
    let (triangles, repeats) = (triangles.parse()?, repeats.parse::<usize>()?);
    let options = SimplifyOptions::default().with_target(Target::Triangles(triangles));
    let mut one_level = Vec::with_capacity(repeats);
    let mut all_levels = Vec::with_capacity(repeats);
    for _ in 0..repeats {
        let started = Instant::now();
        drop(simplify(&mesh, &options)?);
        one_level.push(started.elapsed().as_secs_f64().to_string());
        let started = Instant::now();
        drop(Lod::build(&mesh, &LodOptions::default())?);
        all_levels.push(started.elapsed().as_secs_f64().to_string());
    }
    Ok(writeln!(stdout(), "{}\n{}", one_level.join(" "), all_levels.join(" "))?)
}
