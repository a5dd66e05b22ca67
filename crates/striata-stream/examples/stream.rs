//! Encodes a mesh as a progressive stream, then decodes it in pieces as if it arrived over a network.
//!
//! `cargo run --release -p striata-stream --example stream -- bunny.ply`

use std::error::Error;

use striata::simplify::build_batches;
use striata_stream::{StreamDecoder, StreamOptions, encode_stream};

fn main() -> Result<(), Box<dyn Error>> {
    let input = std::env::args().nth(1).ok_or("usage: stream INPUT")?;
    let built = build_batches(&striata_io::read(&input)?, &Default::default())?;
    let stream = encode_stream(&built.built.refinable, &built.batches, &StreamOptions::default())?;
    eprintln!("{} bytes", stream.bytes.len());

    let mut decoder = StreamDecoder::new();
    for (piece, bytes) in stream.bytes.chunks(10_000).enumerate() {
        let update = decoder.push(bytes)?;
        eprintln!(
            "after {} kB: {} triangles and {} vertices; {} earlier triangles changed",
            (10_000 * piece + bytes.len()) / 1000,
            decoder.triangles().len(),
            decoder.positions().len(),
            update.changed_triangles.len()
        );
    }
    Ok(())
}
