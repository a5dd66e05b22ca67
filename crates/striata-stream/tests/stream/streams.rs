//! Progressive streams: decoded meshes equal the encoded ones at any prefix, and damaged bytes do no harm.

use std::ops::ControlFlow;

use striata_testing::meshes;
use striata_testing::support;

use proptest::prelude::*;
use striata::mesh::{
    AttributeLayer, CollapseSequence, IndexedMesh, LayerData, PositionIndex, RefinableMesh, Semantic,
    SequenceParts, canonical_triangles, replay, shapes,
};
use striata::simplify::{BatchOptions, SequenceOptions, TopologyRule, build_batches, build_sequence};
use striata_stream::{
    DecodeError, Effort, EncodedStream, Precision, StreamDecoder, StreamError, StreamOptions, encode_stream,
    encode_stream_with_progress,
};
use support::{Random, RandomSequenceOptions, random_refinable, soup, with_seams_and_groups};

const EFFORTS: [Effort; 2] = [Effort::Fast, Effort::Compact];

/// Options with each effort.
fn each_effort() -> [StreamOptions; 2] {
    EFFORTS.map(|effort| StreamOptions::default().with_effort(effort))
}

struct Written {
    source: RefinableMesh,
    stream: EncodedStream,
}

fn write(mesh: &IndexedMesh, options: &StreamOptions) -> Written {
    // With as many levels as possible, so that small meshes have general batches too.
    let built = build_batches(mesh, &BatchOptions::default().with_general_floor(0)).unwrap();
    let stream = encode_stream(&built.built.refinable, &built.batches, options).unwrap();
    Written { source: built.built.refinable, stream }
}

fn read(bytes: &[u8]) -> StreamDecoder {
    let mut decoder = StreamDecoder::new();
    decoder.push(bytes).unwrap();
    assert!(decoder.is_complete());
    decoder
}

/// Returns the triangles of each group, in the vertex numbering of the source mesh.
fn groups_of(mesh: &IndexedMesh, vertex: impl Fn(u32) -> u32) -> Vec<Vec<[u32; 3]>> {
    let triangles = |range: std::ops::Range<usize>| {
        let renamed: Vec<_> = mesh.triangles[range].iter().map(|t| t.map(&vertex)).collect();
        canonical_triangles(&renamed)
    };
    mesh.groups_or_whole().iter().map(|g| triangles(g.range())).collect()
}

fn check_whole(written: &Written, options: &StreamOptions) -> RefinableMesh {
    let Written { source, stream } = written;
    let decoded = read(&stream.bytes).refinable_mesh().unwrap();
    decoded.mesh.check().unwrap();
    assert_eq!(decoded.sequence.step_count(), source.sequence.step_count());
    assert_eq!(decoded.sequence.base_vertex_count(), source.sequence.base_vertex_count());
    let original = |v: u32| stream.source_vertex[v as usize];
    assert_eq!(groups_of(&decoded.mesh, original), groups_of(&source.mesh, |v| v));
    for (v, &from) in stream.source_vertex.iter().enumerate() {
        let (found, expected) = (decoded.mesh.positions[v], source.mesh.positions[from as usize]);
        match options.precision {
            Precision::Lossless => assert_eq!(found.map(f32::to_bits), expected.map(f32::to_bits)),
            Precision::Tolerance(limit) => {
                let off: f64 = (0..3).map(|a| (f64::from(found[a]) - f64::from(expected[a])).powi(2)).sum();
                assert!(off.sqrt() <= limit, "vertex {v}: {found:?} for {expected:?}");
            }
            _ => {}
        }
        if v >= decoded.sequence.base_vertex_count() {
            let target = decoded.sequence.target(v as u32);
            assert_eq!(original(target), source.sequence.target(from));
        }
    }
    check_layers(written, options, &decoded);
    decoded
}

fn check_layers(written: &Written, options: &StreamOptions, decoded: &RefinableMesh) {
    let Written { source, stream } = written;
    assert_eq!(decoded.mesh.layers.len(), source.mesh.layers.len());
    for (found, layer) in decoded.mesh.layers.iter().zip(&source.mesh.layers) {
        let expected = layer.gather(&stream.source_vertex);
        let kind = (&found.semantic, found.component_count, found.normalized);
        assert_eq!(kind, (&expected.semantic, expected.component_count, expected.normalized));
        if options.precision == Precision::Lossless || !matches!(expected.data, LayerData::F32(_)) {
            assert_eq!(found.data.as_bytes(), expected.data.as_bytes(), "{}", found.semantic);
            continue;
        }
        // Components with a common unit share their grid step; directions may differ by a thousandth of a
        // circle.
        let n = usize::from(layer.component_count);
        let number = |v: usize| expected.get(v / n, v % n);
        let range_of = |component: usize| {
            let all = || (0..expected.data.len() / n).map(|v| expected.get(v, component));
            all().fold(f32::MIN, f32::max) - all().fold(f32::MAX, f32::min)
        };
        let range = (0..n).map(range_of).fold(2.0, f32::max);
        for v in 0..expected.data.len() {
            let off = (found.get(v / n, v % n) - number(v)).abs();
            // A zero vector may become any direction.
            let is_nothing = (0..n).all(|component| expected.get(v / n, component) == 0.0);
            assert!(
                off <= range / 200.0 || !number(v).is_finite() || is_nothing,
                "{}: {off} of {range}",
                found.semantic
            );
        }
    }
}

fn check_prefix(decoder: &StreamDecoder, whole: &RefinableMesh) {
    let level = decoder.refinable_mesh().unwrap();
    level.mesh.check().unwrap();
    let split_count = decoder.split_count();
    assert_eq!(level.sequence.step_count(), split_count);
    let expected = replay(whole, split_count);
    assert_eq!(level.mesh.positions, expected.positions);
    for (found, expected) in level.mesh.layers.iter().zip(&expected.layers) {
        // Compared as bytes because there may be NaN among the values.
        assert_eq!(found.data.as_bytes(), expected.data.as_bytes(), "{}", found.semantic);
    }
    assert_eq!(groups_of(&level.mesh, |v| v), groups_of(&expected, |v| v), "level {split_count}");
    assert_eq!(level.sequence.targets(), &whole.sequence.targets()[..level.sequence.targets().len()]);
}

/// Decodes in slices and from prefixes.
fn check_parts(bytes: &[u8], whole: &RefinableMesh, random: &mut Random) {
    let mut decoder = StreamDecoder::new();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let end = (at + 1 + random.below(bytes.len() / 7 + 2)).min(bytes.len());
        let update = decoder.push(&bytes[at..end]).unwrap();
        // A viewer keeps its own copy and applies the updates.
        assert_eq!(update.triangles.start, triangles.len());
        for &t in &update.changed_triangles {
            triangles[t as usize] = decoder.triangles()[t as usize];
        }
        triangles.extend_from_slice(&decoder.triangles()[update.triangles]);
        assert_eq!(triangles, decoder.triangles());
        assert_eq!(update.vertices.end, decoder.positions().len());
        at = end;
    }
    assert!(decoder.is_complete());
    let groups = decoder.triangle_groups();
    for (group, expected) in whole.mesh.groups.iter().enumerate().filter(|_| !groups.is_empty()) {
        let count = groups.iter().filter(|&&g| g as usize == group).count();
        assert_eq!(count, expected.count as usize);
    }
    for _ in 0..12 {
        let cut = random.below(bytes.len());
        let mut decoder = StreamDecoder::new();
        decoder.push(&bytes[..cut]).unwrap();
        let promised = (0..=whole.sequence.step_count())
            .take_while(|&s| decoder.bytes_for(s).is_some_and(|b| b <= cut as u64));
        let promised = promised.last();
        match decoder.finish() {
            Ok(_) => {
                check_prefix(&decoder, whole);
                assert!(Some(decoder.split_count()) >= promised);
            }
            Err(_) => assert_eq!(promised, None, "{cut} of {} bytes", bytes.len()),
        }
    }
}

fn check(mesh: &IndexedMesh, options: &StreamOptions, seed: u64) {
    let written = write(mesh, options);
    let whole = check_whole(&written, options);
    check_parts(&written.stream.bytes, &whole, &mut Random::new(seed));
}

#[test]
fn decodes_all_meshes_completely_and_in_parts() {
    for (index, (name, mesh)) in meshes::all().into_iter().enumerate() {
        eprintln!("{name}");
        each_effort().into_iter().for_each(|options| check(&mesh, &options, index as u64));
    }
}

#[test]
fn positions_have_the_requested_precision() {
    for (name, mesh) in meshes::all() {
        eprintln!("{name}");
        let options = StreamOptions::default().with_effort(Effort::Fast);
        check(&mesh, &options.clone().with_precision(Precision::Lossless), 1);
        let tolerance = (mesh.diagonal() * 1e-3).max(1e-30);
        // Far from the origin, floats themselves are coarser.
        let size = mesh.positions.iter().flatten().fold(0.0f32, |size, x| size.max(x.abs()));
        if tolerance > f64::from(size) * 1e-6 {
            check(&mesh, &options.clone().with_precision(Precision::Tolerance(tolerance)), 2);
        }
        for bits in [1, 8, 20, 24] {
            check(&mesh, &options.clone().with_precision(Precision::Bits(bits)), 3);
        }
    }
}

#[test]
fn decodes_seams_groups_and_layers() {
    for (name, mesh) in meshes::all() {
        eprintln!("{name}");
        let mesh = with_seams_and_groups(mesh);
        each_effort().into_iter().for_each(|options| check(&mesh, &options, 4));
        check(&mesh, &StreamOptions::default().with_precision(Precision::Lossless), 5);
    }
}

/// Decals, sheets from both sides, and parts that only their joints move apart.
#[test]
fn copies_in_the_same_place_have_small_bases() {
    let ball = shapes::icosphere(2, 1.0);
    let meshes = [
        ("joints", meshes::on_joints(&ball, 8)),
        ("twice", meshes::copies(&ball, 2)),
        ("inside out", meshes::inside_out(ball)),
        ("two-sided", meshes::two_sided(shapes::terrain(16, 3))),
        ("decal", meshes::decal(shapes::terrain(16, 3))),
    ];
    for (name, mesh) in meshes {
        for options in each_effort() {
            let written = write(&mesh, &options);
            let base = written.source.sequence.triangle_count_at(0);
            assert!(10 * base <= mesh.triangle_count(), "{name}: {base} of {}", mesh.triangle_count());
            let whole = check_whole(&written, &options);
            let mut decoder = StreamDecoder::new();
            for piece in written.stream.bytes.chunks(40) {
                decoder.push(piece).unwrap();
                if decoder.refinable_mesh().is_some() {
                    check_prefix(&decoder, &whole);
                }
            }
            assert!(decoder.is_complete());
        }
    }
}

/// Rings so large that the choice of a run is coded by sums.
#[test]
fn decodes_hubs_of_thousands_of_triangles() {
    for mesh in [shapes::closed_fan(5000), shapes::uv_sphere(3, 3000, 1.0)] {
        each_effort().into_iter().for_each(|options| check(&mesh, &options, 9));
    }
}

/// A cone whose triangles share no vertices, so that its tip has as many vertices as there are triangles.
fn split_cone(n: u32) -> RefinableMesh {
    let rim = |i: u32| {
        let angle = f64::from(i) / f64::from(n) * std::f64::consts::TAU;
        [angle.cos() as f32, angle.sin() as f32, 0.0]
    };
    let normal = |i: u32| [0.6 * rim(i)[0], 0.6 * rim(i)[1], 0.8];
    let (mut positions, mut normals) = (Vec::new(), Vec::new());
    for i in 0..n {
        // Vertex in the triangle that begins at this point of the rim, and in the previous one.
        positions.extend([rim(i); 2]);
        normals.extend([normal(i), normal((i + n - 1) % n)]);
    }
    positions.extend((0..n).map(|_| [0.0, 0.0, 1.0]));
    normals.extend((0..n).map(normal));
    // The step removes the last two triangles.
    let order = (1..n - 1).chain([0, n - 1]);
    let triangles = order.map(|i| [2 * n + i, 2 * i, 2 * ((i + 1) % n) + 1]).collect();
    let mut mesh = IndexedMesh::new(positions, triangles);
    let normals = normals.into_iter().flatten().collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    let first = (0..n).map(|i| 2 * i).chain([2 * n, 3 * n]).collect();
    let sequence = CollapseSequence::from_parts(SequenceParts {
        positions: PositionIndex::from_first(first),
        base_position_count: n as usize,
        targets: (0..n).map(|i| u32::from(i == n - 1)).collect(),
        errors: vec![1.0],
        removed_triangle_counts: vec![2],
        triangle_count: n as usize,
    });
    RefinableMesh { mesh, sequence: sequence.unwrap() }
}

/// Comparing each vertex of a hub with all others would take a minute.
#[test]
fn hubs_of_thousands_of_vertices_take_linear_time() {
    let cone = split_cone(100_000);
    let options = StreamOptions::default();
    let stream = encode_stream(&cone, &[0, 1], &options).unwrap();
    assert!(stream.sizes.wedge_bits < 40.0 * 100_000.0, "{:?}", stream.sizes);
    check_whole(&Written { source: cone, stream }, &options);
    let made = build_batches(&split_cone(5000).mesh, &BatchOptions::default());
    let made = made.unwrap();
    let source = made.built.refinable;
    let stream = encode_stream(&source, &made.batches, &options).unwrap();
    check_whole(&Written { source, stream }, &options);
}

/// The order of steps is arbitrary if each is a separate batch.
#[test]
fn single_steps_are_valid_batches() {
    for mesh in [shapes::torus(24, 12, 1.0, 0.4), shapes::icosphere(3, 1.0), support::grid(16, true)] {
        // Steps that change the topology would be general batches.
        let options = SequenceOptions::default().with_topology(TopologyRule::Keep);
        let built = build_sequence(&mesh, &options).unwrap();
        let batches: Vec<u32> = (0..=built.refinable.sequence.step_count() as u32).collect();
        let options = StreamOptions::default();
        let stream = encode_stream(&built.refinable, &batches, &options).unwrap();
        check_whole(&Written { source: built.refinable, stream }, &options);
    }
}

#[test]
fn rejects_bytes_after_the_end() {
    let bytes = write(&shapes::torus(20, 10, 1.0, 0.4), &StreamOptions::default()).stream.bytes;
    let expected = bytes.len() as u64;
    let longer = [&bytes[..], &[1, 2, 3]].concat();
    let mut at_once = StreamDecoder::new();
    assert_eq!(at_once.push(&longer).unwrap_err(), DecodeError::FileLength { found: expected + 3, expected });
    let mut later = read(&bytes);
    assert!(later.push(&[]).is_ok());
    assert_eq!(later.push(&[0]).unwrap_err(), DecodeError::FileLength { found: expected + 1, expected });
    for decoder in [at_once, later] {
        assert!(decoder.is_complete(), "the decoded mesh must remain available");
        assert_eq!(decoder.triangles().len(), 400);
    }
}

#[test]
fn damaged_bytes_are_rejected_or_give_a_mesh() {
    let mesh = with_seams_and_groups(support::grid(14, true));
    for options in each_effort() {
        let bytes = write(&mesh, &options).stream.bytes;
        for at in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[at] ^= 1 << (at % 8);
            let mut decoder = StreamDecoder::new();
            // A head that claims to be longer waits for bytes that never arrive.
            let error = decoder.push(&damaged).and_then(|_| decoder.finish());
            assert!(error.is_err(), "checksums must cover every byte");
            if let Some(level) = decoder.refinable_mesh() {
                level.mesh.check().unwrap();
            }
        }
    }
}

/// A truncated chunk is decoded without its checksum, so its contents may be arbitrary.
#[test]
fn garbage_in_a_truncated_chunk_gives_a_mesh() {
    let mut random = Random::new(8);
    let mesh = with_seams_and_groups(support::grid(20, false));
    for options in each_effort() {
        let bytes = write(&mesh, &options).stream.bytes;
        for _ in 0..300 {
            let mut damaged = bytes[..bytes.len() - 1].to_vec();
            for _ in 0..1 + random.below(4) {
                let from_end = 1 + random.below(damaged.len() / 3);
                let at = damaged.len() - from_end;
                damaged[at] = random.below(256) as u8;
            }
            let mut decoder = StreamDecoder::new();
            if decoder.push(&damaged).and_then(|_| decoder.finish()).is_ok() {
                let level = decoder.refinable_mesh().unwrap();
                level.mesh.check().unwrap();
                let step_count = level.sequence.step_count();
                assert_eq!(replay(&level, step_count).triangles.len(), level.mesh.triangle_count());
                for split_count in [0, step_count / 2] {
                    let expected = level.sequence.triangle_count_at(split_count);
                    assert_eq!(replay(&level, split_count).triangles.len(), expected);
                }
            }
        }
    }
}

/// A mesh with a boundary, seams, groups and layers. Streams of it are stored next to the tests.
fn stored_surface() -> IndexedMesh {
    meshes::with_patches(meshes::rough(shapes::terrain(24, 3), 0.01, 7), 140)
}

/// The source of a stored stream.
struct StoredStream {
    name: &'static str,
    mesh: IndexedMesh,
    options: StreamOptions,
}

/// The stored streams; the last one has general batches.
fn stored_streams() -> Vec<StoredStream> {
    let options = StreamOptions::default().with_precision(Precision::Bits(12)).with_effort(Effort::Compact);
    let surfaces = [
        ("fast", options.clone().with_effort(Effort::Fast)),
        ("compact", options.clone()),
        ("exact", options.clone().with_precision(Precision::Lossless)),
    ]
    .map(|(name, options)| StoredStream { name, mesh: stored_surface(), options });
    surfaces
        .into_iter()
        .chain([StoredStream { name: "parts", mesh: meshes::asset(12, 5), options }])
        .collect()
}

fn stored_path(name: &str) -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/stored_streams/{name}.stri"))
}

/// The stored files were written by a build with different optimizations, usually on a different machine
/// from the one that runs this test.
#[test]
fn streams_have_the_same_bits_on_every_machine() {
    for StoredStream { name, mesh, options } in stored_streams() {
        let bytes = std::fs::read(stored_path(name)).expect("stored stream");
        let written = write(&mesh, &options);
        assert!(written.stream.bytes == bytes, "{name}: this build writes a different stream");
        check_whole(&written, &options);
        let decoded = read(&bytes).refinable_mesh().unwrap();
        assert_eq!(decoded.mesh.triangle_count(), written.source.mesh.triangle_count());
    }
}

/// A reader says what to do with a stream of another version.
#[test]
fn streams_of_other_versions_are_refused() {
    let mut bytes = write(&shapes::icosphere(1, 1.0), &StreamOptions::default()).stream.bytes;
    bytes[4] = 1;
    let error = StreamDecoder::new().push(&bytes).unwrap_err();
    assert_eq!(error, DecodeError::Version { found: 1, supported: 3 });
    assert_eq!(
        error.to_string(),
        "the stream has format version 1, but this reader supports only version 3; an older version of striata made \
         it, so it must be encoded again"
    );
    bytes[4] = 4;
    let error = StreamDecoder::new().push(&bytes).unwrap_err();
    assert_eq!(error.to_string(), "the stream has format version 4, but this reader supports only version 3");
}

/// Run by hand after a change of the bitstream format: `cargo test --release --test stream -- --ignored`.
#[test]
#[ignore = "writes the streams that are kept"]
fn rewrite_stored_streams() {
    for StoredStream { name, mesh, options } in stored_streams() {
        let path = stored_path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, write(&mesh, &options).stream.bytes).unwrap();
    }
}

/// Divides the steps of a sequence into random batches.
fn random_batches(refinable: &RefinableMesh, random: &mut Random) -> Vec<u32> {
    let step_count = refinable.sequence.step_count() as u32;
    let mut batches = vec![0];
    while *batches.last().unwrap() < step_count {
        let last = *batches.last().unwrap();
        batches.push((last + 1 + random.below(30) as u32).min(step_count));
    }
    batches
}

/// Removes the coarsest levels until all positions of the base are used by triangles.
fn with_used_base(refinable: RefinableMesh) -> RefinableMesh {
    let is_used = |&split_count: &usize| {
        let level = replay(&refinable, split_count);
        (0..level.positions.len() as u32).all(|v| level.triangles.as_flattened().contains(&v))
    };
    let first = (0..refinable.sequence.step_count()).find(is_used).unwrap_or(refinable.sequence.step_count());
    refinable.clone().without_levels_below(first)
}

/// Repeats runs of triangles, some of them reversed, with their own vertices or the same ones.
fn with_random_copies(mut mesh: IndexedMesh, random: &mut Random) -> IndexedMesh {
    for _ in 0..random.below(4) {
        let count = mesh.triangle_count();
        let first = random.below(count);
        let mut copies = mesh.triangles[first..first + 1 + random.below(count - first)].to_vec();
        if random.below(2) == 0 {
            copies.iter_mut().for_each(|t| t.reverse());
        }
        if random.below(2) == 0 {
            let n = mesh.vertex_count() as u32;
            copies.iter_mut().for_each(|t| *t = t.map(|v| v + n));
            mesh.positions.extend_from_within(..);
        }
        mesh.triangles.extend(copies);
    }
    mesh
}

fn check_sequence(source: RefinableMesh, options: &StreamOptions, seed: u64) {
    let mut random = Random::new(seed);
    let batches = random_batches(&source, &mut random);
    let stream = encode_stream(&source, &batches, options).unwrap();
    let written = Written { source, stream };
    let whole = check_whole(&written, options);
    check_parts(&written.stream.bytes, &whole, &mut random);
}

/// Parts that disappear, edges of many triangles, folds: a stream can encode all of them.
#[test]
fn assets_simplify_to_very_small_bases() {
    for seed in 0..6 {
        let mesh = meshes::asset(40, seed);
        let built = build_batches(&mesh, &BatchOptions::default().with_general_floor(60));
        let built = built.unwrap();
        let sequence = &built.built.refinable.sequence;
        let (full, base) = (mesh.triangle_count(), sequence.triangle_count_at(0));
        assert!(full > 500 && base <= 60, "{base} of {full} triangles are left");
        for effort in EFFORTS {
            let options = StreamOptions::default().with_effort(effort);
            let stream = encode_stream(&built.built.refinable, &built.batches, &options).unwrap();
            let written = Written { source: built.built.refinable.clone(), stream };
            let whole = check_whole(&written, &options);
            check_parts(&written.stream.bytes, &whole, &mut Random::new(seed));
        }
    }
}

proptest! {
    #[test]
    fn decodes_any_sequence_in_any_batches(
        seed: u64,
        vertices in 3usize..40,
        triangles in 0usize..80,
        far in 0usize..60,
    ) {
        let mut random = Random::new(seed);
        let mesh = soup(vertices, triangles, &mut random);
        let sequence_options = RandomSequenceOptions { far_percent: far, base_position_count: 1 };
        let source = with_used_base(random_refinable(&mesh, sequence_options, &mut random));
        let options = StreamOptions::default().with_effort(EFFORTS[seed as usize % 2]);
        check_sequence(source, &options, seed);
    }

    #[test]
    fn decodes_sequences_of_assets_in_any_batches(seed: u64, pieces in 1usize..12) {
        let mesh = meshes::asset(pieces, seed);
        let built = build_sequence(&mesh, &SequenceOptions::default()).unwrap();
        let options = StreamOptions::default().with_effort(EFFORTS[seed as usize % 2]);
        check_sequence(built.refinable, &options, seed);
    }

    #[test]
    fn random_identifiers_in_floats_are_exact(
        seed: u64,
        bits in 0u32..=24,
        is_signed: bool,
        count in 1usize..4,
        is_lossless: bool,
    ) {
        let mesh = shapes::torus(12, 8, 1.0, 0.4);
        let mut random = Random::new(seed);
        let mut id = || {
            let id = random.below(1 << bits) as f32;
            if is_signed && random.below(2) == 0 { 0.0 - id } else { id }
        };
        let ids: Vec<f32> = (0..count * mesh.vertex_count()).map(|_| id()).collect();
        let precision = if is_lossless { Precision::Lossless } else { Precision::default() };
        for options in each_effort() {
            check_ids(&with_ids(&mesh, LayerData::F32(ids.clone())), &options.with_precision(precision));
        }
    }

    #[test]
    fn decodes_streams_of_meshes_with_copies(seed: u64, holes in 0usize..40, has_seams: bool) {
        let mut random = Random::new(seed);
        let mut mesh = shapes::torus(8, 6, 2.0, 0.8);
        for _ in 0..holes {
            mesh.triangles.swap_remove(random.below(mesh.triangles.len()));
        }
        mesh = with_random_copies(mesh, &mut random);
        if has_seams {
            mesh = with_seams_and_groups(mesh);
        }
        let options = StreamOptions::default().with_effort(EFFORTS[seed as usize % 2]);
        check(&mesh, &options, seed);
    }

    #[test]
    fn decodes_streams_of_triangle_soups(
        seed in any::<u64>(),
        vertices in 3usize..40,
        triangles in 0usize..80,
        has_seams: bool,
    ) {
        let mut mesh = soup(vertices, triangles, &mut Random::new(seed));
        if has_seams {
            mesh = with_seams_and_groups(mesh);
        }
        let options = StreamOptions::default().with_effort(EFFORTS[seed as usize % 2]);
        check(&mesh, &options, seed);
    }
}

#[test]
fn encoding_and_decoding_report_progress_and_can_be_cancelled() {
    let built = build_batches(&shapes::terrain(150, 1), &BatchOptions::default()).unwrap();
    let (refinable, batches) = (&built.built.refinable, &built.batches);
    let options = StreamOptions::default();
    let mut seen = Vec::new();
    let stream = encode_stream_with_progress(refinable, batches, &options, &mut |now| {
        assert!(now.done <= now.total && seen.last().is_none_or(|&last| last <= now.done), "{now:?}");
        seen.push(now.done);
        ControlFlow::Continue(())
    });
    let bytes = stream.unwrap().bytes;
    assert_eq!(bytes, encode_stream(refinable, batches, &options).unwrap().bytes);
    for last in 1..=seen.len() {
        let mut calls = 0;
        let stopped = encode_stream_with_progress(refinable, batches, &options, &mut |_| {
            calls += 1;
            if calls < last { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        assert!(matches!(stopped, Err(StreamError::Cancelled(_))), "report {last}");
        assert_eq!(calls, last);
    }
    // Longer than the pieces that are decoded between two reports.
    let built = build_batches(&shapes::terrain(250, 1), &BatchOptions::default()).unwrap();
    let bytes = encode_stream(&built.built.refinable, &built.batches, &options).unwrap().bytes;
    let mut decoder = StreamDecoder::new();
    let mut calls = 0;
    let accepted = decoder.push_with_progress(&bytes, &mut |_| {
        calls += 1;
        if calls < 2 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    let accepted = accepted.unwrap();
    assert!(0 < accepted && accepted < bytes.len() && !decoder.is_complete(), "{accepted}");
    let rest = decoder.push_with_progress(&bytes[accepted..], &mut striata::ignore_progress);
    assert_eq!(rest, Ok(bytes.len() - accepted));
    assert!(decoder.is_complete());
}

/// Data of triangles arrive after the last chunk, and belong to the same triangles as before.
#[test]
fn data_of_triangles_are_lossless() {
    let mut mesh = shapes::torus(16, 8, 1.0, 0.4);
    let corners = |t: &[u32; 3]| t.map(|v| mesh.positions[v as usize].map(f64::from));
    // Each triangle gets its centroid, so that it can be recognized.
    let centroid = |t: &[u32; 3]| {
        let [a, b, c] = corners(t);
        [0, 1, 2].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0)
    };
    let centroids: Vec<f64> = mesh.triangles.iter().flat_map(centroid).collect();
    let ids: Vec<i32> = (0..mesh.triangle_count() as i32).map(|i| i * 7_654_321 - 5).collect();
    let layer = |name: &str, component_count, data| striata::mesh::AttributeLayer {
        semantic: striata::mesh::Semantic::Generic(name.to_owned()),
        component_count,
        normalized: false,
        data,
    };
    mesh.triangle_layers =
        vec![layer("centroid", 3, LayerData::F64(centroids)), layer("id", 1, LayerData::I32(ids.clone()))];
    let built = build_batches(&mesh, &BatchOptions::default()).unwrap();
    let options = StreamOptions::default().with_precision(striata_stream::Precision::Lossless);
    let stream = encode_stream(&built.built.refinable, &built.batches, &options).unwrap();
    let mut decoder = StreamDecoder::new();
    decoder.push(&stream.bytes[..stream.bytes.len() - 1]).unwrap();
    assert!(!decoder.is_complete());
    assert!(decoder.refinable_mesh().unwrap().mesh.triangle_layers.is_empty());
    decoder.push(&stream.bytes[stream.bytes.len() - 1..]).unwrap();
    assert!(decoder.is_complete());
    let read = decoder.refinable_mesh().unwrap().mesh;
    read.check().unwrap();
    let LayerData::F64(found) = &read.triangle_layers[0].data else { panic!() };
    for (t, found) in read.triangles.iter().zip(found.as_chunks::<3>().0) {
        let [a, b, c] = t.map(|v| read.positions[v as usize].map(f64::from));
        for axis in 0..3 {
            assert!(((a[axis] + b[axis] + c[axis]) / 3.0 - found[axis]).abs() < 1e-12);
        }
    }
    let LayerData::I32(found) = &read.triangle_layers[1].data else { panic!() };
    let mut found = found.clone();
    found.sort_unstable();
    assert_eq!(found, ids);
    let mut damaged = stream.bytes.clone();
    *damaged.last_mut().unwrap() ^= 1;
    assert!(StreamDecoder::new().push(&damaged).is_err());
}

/// A mesh with a layer of identifiers of any type.
fn with_ids(mesh: &IndexedMesh, data: LayerData) -> IndexedMesh {
    let component_count = (data.len() / mesh.vertex_count()) as u8;
    let semantic = Semantic::Generic("FEATURE_ID_0".to_owned());
    let mut mesh = mesh.clone();
    mesh.layers.push(AttributeLayer { semantic, component_count, normalized: false, data });
    mesh
}

/// Encodes a mesh whose last layer has identifiers, and checks them at every level.
fn check_ids(mesh: &IndexedMesh, options: &StreamOptions) {
    let Written { source, stream } = write(mesh, options);
    let expected = source.mesh.layers.last().unwrap().gather(&stream.source_vertex);
    let mut decoder = StreamDecoder::new();
    for bytes in stream.bytes.chunks(stream.bytes.len() / 9 + 1) {
        decoder.push(bytes).unwrap();
        let Some(level) = decoder.refinable_mesh() else { continue };
        let found = level.mesh.layers.last().unwrap();
        assert_eq!(found.data, expected.data.slice(0..found.data.len()), "{options:?}");
    }
    assert!(decoder.is_complete());
}

#[test]
fn identifiers_in_floats_are_exact_at_every_level_and_as_small_as_integers() {
    let mesh = shapes::uv_sphere(32, 48, 1.0);
    let regions = |v: usize| mesh.positions[v].map(|x| (3.0 * x).floor() as i32 + 3);
    let ids_of: [&dyn Fn(usize) -> i32; 4] = [
        &|v| (v * 197 % 300_001) as i32,
        &|v| 100_000 - v as i32,
        &|v| regions(v)[0] * 9173 + regions(v)[1] * 83 + regions(v)[2],
        &|_| 7,
    ];
    for options in each_effort() {
        for id_of in ids_of {
            let ids: Vec<i32> = (0..mesh.vertex_count()).map(id_of).collect();
            let floats = with_ids(&mesh, LayerData::F32(ids.iter().map(|&id| id as f32).collect()));
            check_ids(&floats, &options);
            check_ids(&floats, &options.clone().with_precision(Precision::Lossless));
            let [size, integer_size] = [floats, with_ids(&mesh, LayerData::I32(ids))]
                .map(|mesh| write(&mesh, &options).stream.bytes.len());
            // The grid takes 12 bytes of the head.
            assert!(size <= integer_size + integer_size / 100 + 12, "{size} and {integer_size}: {options:?}");
        }
    }
}
