//! Hostile streams with valid checksums give an error or a mesh, in bounded time and memory.

use striata_testing::meshes;

use striata_testing::support;

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic, shapes};
use striata::simplify::{BatchOptions, build_batches};
use striata_stream::{
    DecodeError, Effort, Precision, StreamDecoder, StreamDefect, StreamInfo, StreamOptions, encode_stream,
};
use support::{Random, soup, with_seams_and_groups};

const EFFORTS: [Effort; 2] = [Effort::Fast, Effort::Compact];

fn stream_of(mesh: &IndexedMesh, options: &StreamOptions) -> Vec<u8> {
    let batches = BatchOptions::default().with_general_floor(0);
    let built = build_batches(mesh, &batches).unwrap();
    encode_stream(&built.built.refinable, &built.batches, options).unwrap().bytes
}

/// Checks that the decoder's current level is a mesh.
fn check(decoder: &StreamDecoder) {
    let Some(steps) = decoder.steps() else {
        let is_expected = decoder.positions().is_empty() || decoder.has_fragments();
        assert!(is_expected, "a decoder without a mesh has no positions");
        return;
    };
    steps.mesh().check().unwrap();
    let step_count = steps.levels().step_count();
    for split_count in [step_count / 2, step_count] {
        let level = steps.level(split_count);
        assert_eq!(level.triangle_count(), steps.levels().triangle_count_at(split_count));
    }
    assert_eq!(steps.level(step_count).triangle_count(), steps.mesh().triangle_count());
}

/// Reads the inputs that fuzzing has collected, including those that revealed defects.
#[test]
fn inputs_from_fuzzing_do_no_harm() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/kept/progressive_stream");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let mut bytes = std::fs::read(entry.unwrap().path()).unwrap();
        let _ = read_with_correct_checksums(&mut bytes);
        count += 1;
    }
    assert!(count > 50, "only {count} streams are stored");
}

/// Reads bytes after correcting each checksum that does not match.
fn read_with_correct_checksums(bytes: &mut [u8]) -> Result<StreamDecoder, DecodeError> {
    loop {
        let mut decoder = StreamDecoder::new();
        let mut result = decoder.push(bytes);
        check(&decoder);
        if result.is_ok() && !decoder.is_complete() {
            result = decoder.finish();
            check(&decoder);
        }
        let error = match result {
            Ok(_) => return Ok(decoder),
            Err(error) => error,
        };
        let (found, expected) = match error {
            DecodeError::HeaderChecksum { found, expected }
            | DecodeError::Stream(StreamDefect::Checksum { found, expected, .. }) => (found, expected),
            _ => return Err(error),
        };
        let Some(at) = bytes.windows(4).position(|b| b == expected.to_le_bytes()) else { return Err(error) };
        bytes[at..at + 4].copy_from_slice(&found.to_le_bytes());
    }
}

fn put_varint(mut number: u32, out: &mut Vec<u8>) {
    while number >= 128 {
        out.push(number as u8 | 128);
        number >>= 7;
    }
    out.push(number as u8);
}

/// Positions, vertices, triangles, steps, and maximum number of triangles of a patch.
type Counts = [u32; 5];

/// A chunk as listed in a head.
struct ListedChunk {
    /// Number of bytes that the head claims.
    claimed: u32,
    /// Number of splits that the head claims.
    splits: u32,
}

/// Appends a chunk with its checksum.
fn put_chunk(chunk: &[u8], out: &mut Vec<u8>) {
    out.extend(crc32fast::hash(chunk).to_le_bytes());
    out.extend(chunk);
}

/// A head without names, layers and groups. Values of `effort` from 2 on: with general batches.
fn head(effort: u8, counts: Counts, chunks: &[ListedChunk]) -> Vec<u8> {
    let mut out = b"\x89STR".to_vec();
    let flags = if effort < 2 { 0 } else { 2 };
    out.extend([3, effort % 2, flags, 0]);
    out.extend([0; 8]);
    counts.into_iter().for_each(|n| put_varint(n, &mut out));
    out.push(14);
    out.extend([0; 12]);
    out.extend(1f64.to_le_bytes());
    out.extend([0; 4]);
    put_varint(chunks.len() as u32, &mut out);
    for &ListedChunk { claimed, splits } in chunks {
        [claimed, splits, 0].into_iter().for_each(|n| put_varint(n, &mut out));
    }
    let length = out.len() as u32;
    out[8..12].copy_from_slice(&length.to_le_bytes());
    let checked = [&out[..12], &out[16..]].concat();
    out[12..16].copy_from_slice(&crc32fast::hash(&checked).to_le_bytes());
    out
}

fn triangle() -> IndexedMesh {
    IndexedMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0, 1, 2]])
}

/// The first chunk of a stream of one triangle, without its checksum.
fn base_of_a_triangle() -> Vec<u8> {
    let bytes = stream_of(&triangle(), &StreamOptions::default());
    let info = StreamInfo::read(&bytes).unwrap().unwrap();
    bytes[info.head_bytes as usize + 4..].to_vec()
}

#[test]
fn a_head_that_claims_billions_does_not_allocate_them() {
    let base = base_of_a_triangle();
    let steps = 3_000_000_000;
    let chunks = [
        ListedChunk { claimed: base.len() as u32, splits: 0 },
        ListedChunk { claimed: steps / 256, splits: steps },
    ];
    for effort in 0..4 {
        let mut bytes = head(effort, [3 + steps, 3 + steps, 1, steps, 7], &chunks);
        put_chunk(&base, &mut bytes);
        let mut decoder = StreamDecoder::new();
        let update = decoder.push(&bytes).unwrap();
        assert_eq!((update.vertices, update.triangles), (0..3, 0..1));
        decoder.finish().unwrap();
        check(&decoder);
    }
}

/// Number of vertices that a first chunk gives if the head promises billions; 0 if it is rejected.
fn vertices_of(chunk: &[u8]) -> usize {
    let chunks = [
        ListedChunk { claimed: chunk.len() as u32, splits: 0 },
        ListedChunk { claimed: 16 << 20, splits: 0 },
    ];
    let mut bytes = head(1, [3, u32::MAX, 1, 0, 7], &chunks);
    put_chunk(chunk, &mut bytes);
    let mut decoder = StreamDecoder::new();
    let result = decoder.push(&bytes);
    check(&decoder);
    result.map_or(0, |update| update.vertices.len())
}

#[test]
fn the_bytes_limit_the_vertices() {
    // Chooses, byte by byte, the continuation that gives the most vertices.
    let base = base_of_a_triangle();
    let mut most = 0;
    for kept in base.len() - 2..=base.len() {
        let mut chunk = base[..kept].to_vec();
        for _ in 0..5 {
            let of = |byte: &u8| vertices_of(&[&chunk[..], &[*byte]].concat());
            let best = (0..=255).max_by_key(of).unwrap();
            chunk.push(best);
            let vertices = vertices_of(&chunk);
            assert!(vertices <= 3 + 256 * (chunk.len() + 1), "{vertices} of {} bytes", chunk.len());
            most = most.max(vertices);
        }
    }
    assert!(most > 1000, "{most}: the claimed counts must have an effect");
}

/// Random chunks with valid checksums.
#[test]
fn random_chunks_give_an_error_or_a_mesh() {
    let mut random = Random::new(6);
    for round in 0..6000u32 {
        let position_count = 3 + random.below(4) as u32;
        let steps = 40;
        let wedges = if round % 2 == 0 { 0 } else { 50 };
        let counts =
            [position_count + steps, position_count + steps + wedges, 9, steps, random.below(300) as u32];
        let [base, splits] = [30, 90].map(|length| {
            let bits = random.below(8);
            // Runs of zeros repeat the same decision many times.
            let count = random.below(length);
            let byte = |_| if random.below(8) < bits { 0 } else { random.below(256) as u8 };
            (0..count).map(byte).collect::<Vec<u8>>()
        });
        let chunks = [
            ListedChunk { claimed: base.len() as u32, splits: 0 },
            ListedChunk { claimed: splits.len() as u32, splits: steps },
        ];
        let mut bytes = head((round % 6) as u8, counts, &chunks);
        put_chunk(&base, &mut bytes);
        put_chunk(&splits, &mut bytes);
        let mut decoder = StreamDecoder::new();
        let result = decoder.push(&bytes);
        check(&decoder);
        if let Err(error) = result {
            assert!(matches!(error, DecodeError::Stream(_)), "{error}");
            assert!(
                decoder.push(&[0]).is_err() && decoder.finish().is_err(),
                "the decoder must not accept more bytes"
            );
            check(&decoder);
        }
    }
}

#[test]
fn changed_bytes_with_valid_checksums_do_no_harm() {
    let mut random = Random::new(7);
    let soup = soup(20, 40, &mut Random::new(2));
    let surface = with_seams_and_groups(support::grid(12, true));
    for mesh in [triangle(), surface, soup.clone(), with_seams_and_groups(soup), meshes::asset(9, 4)] {
        for effort in EFFORTS {
            for precision in [Precision::Bits(10), Precision::Lossless] {
                let options = StreamOptions::default().with_effort(effort).with_precision(precision);
                let bytes = stream_of(&mesh, &options);
                let head_bytes = StreamInfo::read(&bytes).unwrap().unwrap().head_bytes as usize;
                for round in 0..250 {
                    let mut damaged = bytes.clone();
                    let range = if round % 2 == 0 { 0..head_bytes } else { head_bytes..bytes.len() };
                    for _ in 0..1 + random.below(3) {
                        damaged[range.start + random.below(range.len())] = random.below(256) as u8;
                    }
                    let _ = read_with_correct_checksums(&mut damaged);
                }
            }
        }
    }
}

#[test]
fn every_truncation_of_a_small_stream_is_a_prefix() {
    let surface = with_seams_and_groups(support::grid(9, true));
    let streams = [&surface, &meshes::asset(3, 8)]
        .map(|mesh| EFFORTS.map(|effort| stream_of(mesh, &StreamOptions::default().with_effort(effort))));
    for bytes in streams.as_flattened() {
        let info = StreamInfo::read(bytes).unwrap().unwrap();
        let mut whole = StreamDecoder::new();
        whole.push(bytes).unwrap();
        let (mut splits, mut error) = (0, f32::INFINITY);
        for length in 0..bytes.len() {
            let mut decoder = StreamDecoder::new();
            decoder.push(&bytes[..length]).unwrap();
            assert!(!decoder.is_complete());
            if let Err(error) = decoder.finish() {
                let DecodeError::Incomplete { found, needed } = error else { panic!("{length}: {error}") };
                assert!(found == length as u64 && needed > found, "{needed} after {found}");
                assert!(needed <= if found < info.head_bytes { info.head_bytes } else { info.base_bytes });
                continue;
            }
            assert!(length as u64 >= info.base_bytes && decoder.split_count() >= splits);
            splits = decoder.split_count();
            assert!(decoder.error().is_some_and(|now| now <= error));
            error = decoder.error().unwrap();
            assert_eq!(decoder.positions(), &whole.positions()[..decoder.positions().len()]);
            // The attributes of a part equal that part of all attributes.
            let count = decoder.positions().len();
            let part = count / 3..count;
            for (found, all) in decoder.layers_of(part.clone()).iter().zip(whole.layers_of(0..count)) {
                let order: Vec<u32> = part.clone().map(|v| v as u32).collect();
                assert_eq!(found.data.as_bytes(), all.gather(&order).data.as_bytes());
            }
        }
        assert!(splits > 10 && whole.error() == Some(0.0));
        assert_eq!(whole.bytes_for(0), Some(info.base_bytes));
        assert_eq!(whole.bytes_for(info.step_count), Some(info.stream_bytes));
        assert_eq!(whole.bytes_for(info.step_count + 1), None);
    }
}

#[test]
fn unusual_valid_meshes_are_decoded() {
    let mut scaled = shapes::torus(12, 8, 1.0, 0.4);
    scaled.positions.iter_mut().flatten().for_each(|x| *x *= 1e30);
    let mut wild = shapes::torus(12, 8, 1.0, 0.4);
    let numbers = (0..wild.vertex_count()).map(|v| [f32::NAN, f32::INFINITY, v as f32][v % 3]).collect();
    wild.layers.push(AttributeLayer::from_f32(Semantic::Generic("wild".into()), 1, numbers));
    // A tip at which each corner has its own vertex.
    let count = 5000u32;
    let mut tip = IndexedMesh::default();
    for i in 0..count {
        let point = |i: u32| {
            let (angle, far) = (i as f32 / count as f32, 1.0 + (i % 7) as f32 / 9.0);
            [far * (0.5 - angle), far * angle * (1.0 - angle), 1.0]
        };
        tip.positions.extend([[0.0; 3], point(i), point((i + 1) % count)]);
        tip.triangles.push([3 * i, 3 * i + 1, 3 * i + 2]);
    }
    tip.layers.push(AttributeLayer::from_f32(
        Semantic::TexCoord(0),
        2,
        (0..3 * count).flat_map(|v| [(v / 3) as f32, 0.0]).collect(),
    ));
    for (name, mesh) in [("empty", IndexedMesh::default()), ("far", scaled), ("wild", wild), ("tip", tip)] {
        for effort in EFFORTS {
            let bytes = stream_of(&mesh, &StreamOptions::default().with_effort(effort));
            let mut decoder = StreamDecoder::new();
            decoder.push(&bytes).unwrap();
            assert!(decoder.is_complete(), "{name}");
            assert_eq!(decoder.triangles().len(), mesh.triangle_count(), "{name}");
            check(&decoder);
        }
    }
}

#[test]
fn rejects_unknown_flags_and_too_many_layers() {
    let base = base_of_a_triangle();
    let mut bytes = head(1, [3, 3, 1, 0, 0], &[ListedChunk { claimed: base.len() as u32, splits: 0 }]);
    put_chunk(&base, &mut bytes);
    StreamDecoder::new().push(&bytes).unwrap();
    bytes[6] = 32;
    let error = read_with_correct_checksums(&mut bytes).map(|_| ()).unwrap_err();
    assert!(matches!(error, DecodeError::Malformed { .. }), "{error}");
    let mut mesh = triangle();
    for index in 0..17 {
        let semantic = Semantic::Generic(format!("layer {index}"));
        mesh.layers.push(AttributeLayer::from_f32(semantic, 255, vec![1.0; 3 * 255]));
    }
    let built = build_batches(&mesh, &BatchOptions::default()).unwrap();
    let error = encode_stream(&built.built.refinable, &built.batches, &StreamOptions::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the attribute layers have 4335 components per vertex, but a stream can store at most 4096"
    );
}
