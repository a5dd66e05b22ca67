//! Encodes a glTF file as a progressive stream, and shows what each prefix contains.
//!
//! ```text
//! cargo run --release -p striata-scene --example stream_scene -- helmet.glb helmet.stri
//! ```

use std::time::Instant;

use striata_scene::stream::{SceneStreamDecoder, SceneStreamOptions, encode_scene};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(input), output) = (arguments.next(), arguments.next()) else {
        return Err("give the path of a scene, and optionally that of the stream".into());
    };
    let scene = striata_io::read_scene(&input)?;
    let started = Instant::now();
    let stream = encode_scene(&scene, &SceneStreamOptions::default())?;
    eprintln!("{} bytes in {:.2?}: {:?}", stream.bytes.len(), started.elapsed(), stream.sizes);
    if let Some(output) = output {
        std::fs::write(output, &stream.bytes)?;
    }
    let started = Instant::now();
    let mut decoder = SceneStreamDecoder::new();
    for (index, piece) in stream.bytes.chunks(stream.bytes.len().div_ceil(20).max(1)).enumerate() {
        decoder.push(piece)?;
        if decoder.is_drawable() {
            let (scene, error) = (decoder.scene()?, decoder.error().unwrap_or(0.0));
            eprintln!("{:3} %: {} triangles, error {error:.2e}", 5 * (index + 1), scene.triangle_count());
        }
    }
    eprintln!("decoded in {:.2?}", started.elapsed());
    Ok(())
}
