//! Streams of fragments: removals with any filling of their holes, and collapses to new vertices.

use striata::mesh::{FragmentedMesh, IndexedMesh, canonical_triangles, replay_fragments, shapes};
use striata::simplify::{
    PlacedOptions, RemovalOptions, RemovalOrder, build_fragments, build_placed_fragments,
};
use striata_stream::{EncodedStream, Precision, StreamDecoder, StreamInfo, StreamOptions, encode_fragments};
use striata_testing::meshes;

fn removals(mesh: &IndexedMesh) -> FragmentedMesh {
    build_fragments(mesh, &RemovalOptions::default()).expect("a sound mesh").fragmented
}

fn lossless(fragmented: &FragmentedMesh) -> EncodedStream {
    let options = StreamOptions::default().with_precision(Precision::Lossless);
    encode_fragments(fragmented, &options).expect("a mesh that can be encoded")
}

/// Panics unless the decoder shows what the replay of the source shows, vertex by vertex.
fn check_level(name: &str, decoder: &StreamDecoder, fragmented: &FragmentedMesh, encoded: &EncodedStream) {
    let split_count = decoder.split_count();
    let expected = replay_fragments(fragmented, split_count);
    let in_source = |triangle: &[u32; 3]| triangle.map(|v| encoded.source_vertex[v as usize]);
    let shown: Vec<[u32; 3]> = decoder.triangles().iter().map(in_source).collect();
    assert_eq!(
        canonical_triangles(&shown),
        canonical_triangles(&expected.triangles),
        "{name}, split {split_count}"
    );
    for (vertex, position) in decoder.positions().iter().enumerate() {
        let source = encoded.source_vertex[vertex] as usize;
        assert_eq!(position, &fragmented.mesh.positions[source], "{name}, vertex {vertex}");
    }
}

/// Pushes a stream chunk by chunk, and checks each level on the way.
fn check(name: &str, fragmented: &FragmentedMesh) {
    let encoded = lossless(fragmented);
    let info = StreamInfo::read(&encoded.bytes).expect("a header").expect("all of it");
    let mut decoder = StreamDecoder::new();
    let mut at = info.head_bytes as usize;
    decoder.push(&encoded.bytes[..at]).expect("a header");
    for chunk in &info.chunks {
        let end = at + chunk.bytes as usize;
        decoder.push(&encoded.bytes[at..end]).expect("a chunk");
        assert_eq!(decoder.split_count(), chunk.split_count, "{name}");
        check_level(name, &decoder, fragmented, &encoded);
        at = end;
    }
    assert!(decoder.is_complete() && decoder.has_fragments() && decoder.refinable_mesh().is_none());
    let received = decoder.steps().expect("a sequence").fragments().into_owned();
    assert_eq!(received.fragments.step_count(), fragmented.fragments.step_count());
    assert_eq!(received.mesh.layers.len(), fragmented.mesh.layers.len());
    for step in [0, received.fragments.step_count() / 2] {
        let (ours, theirs) = (replay_fragments(&received, step), replay_fragments(fragmented, step));
        assert_eq!(ours.triangle_count(), theirs.triangle_count(), "{name}");
        let named = |triangle: &[u32; 3]| triangle.map(|v| encoded.source_vertex[v as usize]);
        let ours: Vec<[u32; 3]> = ours.triangles.iter().map(named).collect();
        assert_eq!(canonical_triangles(&ours), canonical_triangles(&theirs.triangles), "{name}");
        let errors = [&received, fragmented].map(|found| found.fragments.levels().error_at(step));
        // A header has no error above this one.
        assert!(errors[0] >= errors[1].min(f32::from_bits(0x7f7f_0000)), "{name}, step {step}: {errors:?}");
    }
}

#[test]
fn removals_decode_to_the_replay_at_every_chunk() {
    check("sphere", &removals(&shapes::icosphere(4, 1.0)));
    check("terrain", &removals(&shapes::terrain(40, 3)));
    check("two materials", &removals(&shapes::two_material_sphere(24, 32)));
    let strict = RemovalOptions::default().with_order(RemovalOrder::Hausdorff);
    check(
        "strict",
        &build_fragments(&shapes::torus(32, 24, 1.0, 0.4), &strict).expect("a sound mesh").fragmented,
    );
}

#[test]
fn new_vertices_decode_to_the_replay_at_every_chunk() {
    for mesh in [shapes::icosphere(3, 1.0), shapes::terrain(16, 3)] {
        let built = build_placed_fragments(&mesh, &PlacedOptions::default()).expect("a sound mesh");
        check("new vertices", &built.fragmented);
    }
}

#[test]
fn nasty_meshes_decode_to_the_replay() {
    for (name, mesh) in meshes::nasty().into_iter().filter(|(_, mesh)| mesh.check().is_ok()) {
        let Ok(built) = build_fragments(&mesh, &RemovalOptions::default()) else { continue };
        if built.fragmented.mesh.triangle_layers.is_empty() && built.fragmented.mesh.triangle_count() > 0 {
            check(name, &built.fragmented);
        }
    }
}

#[test]
fn rounded_positions_stay_within_a_step() {
    let fragmented = removals(&shapes::torus(32, 24, 1.0, 0.4));
    let options = StreamOptions::default().with_precision(Precision::Tolerance(0.002));
    let encoded = encode_fragments(&fragmented, &options).expect("a mesh that can be encoded");
    let mut decoder = StreamDecoder::new();
    decoder.push(&encoded.bytes).expect("a stream");
    for (vertex, position) in decoder.positions().iter().enumerate() {
        let source = fragmented.mesh.positions[encoded.source_vertex[vertex] as usize];
        let distance = (0..3).map(|k| (position[k] - source[k]).powi(2)).sum::<f32>().sqrt();
        assert!(distance <= 0.002, "vertex {vertex} moved by {distance}");
    }
    let bits = encoded.sizes.connectivity_bits / fragmented.fragments.step_count() as f64;
    assert!(bits < 30.0, "{bits} bits of connectivity a fragment; 44 are published");
}

#[test]
fn a_stream_that_is_cut_off_is_a_level() {
    let fragmented = removals(&shapes::icosphere(4, 1.0));
    let encoded = lossless(&fragmented);
    let info = StreamInfo::read(&encoded.bytes).expect("a header").expect("all of it");
    let first = (info.head_bytes + info.chunks[0].bytes) as usize;
    for length in (first..encoded.bytes.len()).step_by(97) {
        let mut decoder = StreamDecoder::new();
        decoder.push(&encoded.bytes[..length]).expect("a part of a stream");
        decoder.finish().expect("the base has arrived");
        check_level("cut off", &decoder, &fragmented, &encoded);
    }
}

#[test]
fn damaged_streams_are_errors_or_meshes() {
    let fragmented = removals(&shapes::two_material_sphere(8, 10));
    let encoded = lossless(&fragmented);
    let info = StreamInfo::read(&encoded.bytes).expect("a header").expect("all of it");
    for at in 0..encoded.bytes.len() {
        for bit in [0, 3, 7] {
            let mut damaged = encoded.bytes.clone();
            damaged[at] ^= 1 << bit;
            // Without its last byte, the last chunk has no checksum to be compared with.
            damaged.pop();
            let mut decoder = StreamDecoder::new();
            if decoder.push(&damaged).is_ok() && at as u64 >= info.head_bytes {
                let _ = decoder.finish();
            }
            for triangle in decoder.triangles().iter().flatten() {
                assert!((*triangle as usize) < decoder.positions().len(), "byte {at}, bit {bit}");
            }
            if let Some(received) = decoder.steps() {
                assert!(received.mesh().check().is_ok(), "byte {at}, bit {bit}");
            }
        }
    }
}
