//! Files with streams: alone and together with models, complete and truncated.

use striata_testing::support;

use striata::file::{DecodeError, FileModel, SectionKind, WriteOptions, to_striata};
use striata::mesh::{RefinableMesh, canonical_triangles, replay, shapes};
use striata::model::{LodModel, LodStrips};
use striata::simplify::{BatchOptions, build_batches};
use striata::strip::stripify;
use striata_stream::{
    EncodedStream, StreamOptions, encode_stream, file_model, open, open_stream, open_truncated,
};
use support::with_seams_and_groups;

struct Encoded {
    /// The mesh in stream order.
    refinable: RefinableMesh,
    stream: EncodedStream,
}

fn make(mesh: &striata::mesh::IndexedMesh) -> Encoded {
    let built = build_batches(mesh, &BatchOptions::default()).unwrap();
    let stream = encode_stream(&built.built.refinable, &built.batches, &StreamOptions::default()).unwrap();
    Encoded { refinable: stream.reorder(&built.built.refinable), stream }
}

fn file_with_stream(encoded: &Encoded) -> Vec<u8> {
    let options = WriteOptions::default().with_metadata("source", "torus");
    to_striata(&encoded.refinable, &[file_model(&encoded.stream.bytes).unwrap()], &options).unwrap()
}

#[test]
fn a_reordered_mesh_has_the_levels_of_its_stream() {
    let seamed = [shapes::torus(24, 12, 1.0, 0.4), support::grid(14, true)].map(with_seams_and_groups);
    let plain = [shapes::torus(40, 20, 1.0, 0.4), shapes::grid(21, 17), shapes::icosphere(3, 1.0)];
    for mesh in plain.into_iter().chain(seamed) {
        let encoded = make(&mesh);
        let bytes = file_with_stream(&encoded);
        let decoded = open(&bytes).unwrap().refinable_mesh().unwrap();
        let (ours, theirs) = (&encoded.refinable, &decoded);
        assert_eq!(ours.sequence.positions(), theirs.sequence.positions());
        assert_eq!(ours.sequence.targets(), theirs.sequence.targets());
        let groups = |m: &RefinableMesh| m.mesh.groups.iter().map(|g| g.count).collect::<Vec<_>>();
        assert_eq!(groups(ours), groups(theirs));
        assert_eq!(ours.mesh.layers.len(), theirs.mesh.layers.len());
        assert_eq!(ours.sequence.removed_triangle_counts(), theirs.sequence.removed_triangle_counts());
        for split_count in (0..=ours.sequence.step_count()).step_by(17) {
            let [a, b] = [ours, theirs].map(|m| canonical_triangles(&replay(m, split_count).triangles));
            assert_eq!(a, b, "{split_count}");
        }
        let step = mesh.diagonal() / 16383.0;
        for (a, b) in ours.mesh.positions.iter().zip(&theirs.mesh.positions) {
            assert!((0..3).all(|i| f64::from((a[i] - b[i]).abs()) <= step), "{a:?} became {b:?}");
        }
    }
}

#[test]
fn a_file_may_contain_only_a_stream() {
    let encoded = make(&shapes::torus(40, 20, 1.0, 0.4));
    let bytes = file_with_stream(&encoded);
    let file = open(&bytes).unwrap();
    let kinds: Vec<_> = file.sections().iter().map(|s| s.kind).collect();
    assert_eq!(kinds, [SectionKind::SUMMARY, SectionKind::METADATA, SectionKind::STREAM]);
    assert!(file.is_stream_only() && !file.is_truncated() && file.has_collapses());
    assert_eq!(file.stream().unwrap().unwrap(), encoded.stream.bytes);
    assert_eq!(file.metadata().unwrap(), [("source".to_owned(), "torus".to_owned())]);
    let refinable = file.refinable_mesh().unwrap();
    assert_eq!(file.mesh().unwrap(), refinable.mesh);
    assert_eq!(file.sequence().unwrap(), refinable.sequence);
    assert_eq!(file.positions().unwrap(), refinable.mesh.positions);
    assert_eq!(file.errors().unwrap(), refinable.sequence.errors());
    assert_eq!(file.groups().unwrap(), refinable.mesh.groups);
    assert_eq!(file.layers().unwrap(), refinable.mesh.layers);
    let step_count = refinable.sequence.step_count();
    assert_eq!(file.summary().step_count, step_count);
    assert_eq!(file.summary().base_triangle_count, refinable.sequence.triangle_count_at(0));
    assert_eq!(file.level(step_count / 3).unwrap(), replay(&refinable, step_count / 3));
    assert!(matches!(file.level(step_count + 1), Err(DecodeError::SplitCount { .. })));
    assert!(file.lod_strips().is_none() && file.fans().is_none() && file.strips().is_none());
    // The bare stream gives the same result.
    let bare = open_stream(&encoded.stream.bytes).unwrap();
    assert_eq!(bare.refinable_mesh().unwrap(), refinable);
    let (mut a, b) = (file.summary(), bare.summary());
    assert!(a.bounds.take().is_some());
    a.error_max = b.error_max;
    assert_eq!(a, b);
}

#[test]
fn a_file_may_contain_models_and_a_stream() {
    let encoded = make(&shapes::torus(40, 20, 1.0, 0.4));
    let strips = stripify(&encoded.refinable.mesh).unwrap();
    let model = LodStrips::build(&encoded.refinable, &strips).unwrap();
    let models = [file_model(&encoded.stream.bytes).unwrap(), FileModel::LodStrips(&model)];
    let bytes = to_striata(&encoded.refinable, &models, &WriteOptions::default()).unwrap();
    let file = open(&bytes).unwrap();
    assert_eq!(file.sections().last().map(|s| s.kind), Some(SectionKind::STREAM));
    assert!(!file.is_stream_only());
    assert_eq!(file.mesh().unwrap().positions, encoded.refinable.mesh.positions);
    assert_eq!(file.lod_strips().unwrap().unwrap().step_count(), model.step_count());
    let decoded = open_stream(file.stream().unwrap().unwrap()).unwrap().refinable_mesh().unwrap();
    let split_count = model.step_count() / 2;
    let [a, b] = [file.level(split_count).unwrap(), replay(&decoded, split_count)];
    assert_eq!(canonical_triangles(&a.triangles), canonical_triangles(&b.triangles));
}

#[test]
fn a_truncated_file_gives_the_beginning_of_its_stream() {
    let encoded = make(&shapes::torus(40, 20, 1.0, 0.4));
    let bytes = file_with_stream(&encoded);
    let whole = open(&bytes).unwrap();
    let full = whole.refinable_mesh().unwrap();
    let stream = *whole.sections().last().unwrap();
    let offset = stream.offset as usize;
    let mut counts = Vec::new();
    for length in 0..bytes.len() {
        let part = &bytes[..length];
        assert!(open(part).is_err(), "{length}");
        let file = match open_truncated(part) {
            Ok(file) => file,
            Err(error) => {
                assert!(
                    length < offset
                        && matches!(error, DecodeError::FileLength { .. } | DecodeError::Magic { .. }),
                    "{length}: {error}"
                );
                continue;
            }
        };
        assert!(file.is_truncated() && length >= offset);
        assert_eq!(file.stream().unwrap().unwrap(), &encoded.stream.bytes[..length - offset]);
        if length % 23 != 0 {
            continue;
        }
        match file.refinable_mesh() {
            Ok(part) => {
                let split_count = part.sequence.step_count();
                counts.push(split_count);
                let expected = canonical_triangles(&replay(&full, split_count).triangles);
                assert_eq!(canonical_triangles(&part.mesh.triangles), expected);
                assert_eq!(file.level(split_count).unwrap().vertex_count(), part.mesh.vertex_count());
                assert!(file.level(split_count + 1).is_err());
            }
            Err(error) => assert!(counts.is_empty(), "{length}: {error}"),
        }
    }
    assert!(counts.len() > 20 && counts.is_sorted(), "{counts:?}");
    assert!(open_truncated(&bytes).is_ok_and(|file| !file.is_truncated()));
    // A file must not be longer than its header states, and a file without a stream must not be truncated.
    let longer = [&bytes[..], &[0]].concat();
    assert!(matches!(open_truncated(&longer), Err(DecodeError::FileLength { .. })));
    let plain = to_striata(&encoded.refinable, &[], &WriteOptions::default()).unwrap();
    assert!(matches!(open_truncated(&plain[..plain.len() - 1]), Err(DecodeError::FileLength { .. })));
}

#[test]
fn damaged_files_do_no_harm() {
    let encoded = make(&shapes::torus(24, 12, 1.0, 0.4));
    let bytes = file_with_stream(&encoded);
    for at in (0..bytes.len()).step_by(3) {
        let mut hurt = bytes.clone();
        hurt[at] ^= 0x20;
        if let Ok(file) = open(&hurt) {
            // Bytes between sections are ignored.
            if let Ok(mesh) = file.mesh() {
                assert_eq!(mesh.triangle_count(), encoded.refinable.mesh.triangle_count());
            }
        }
        // The end of a truncated file is not checked, so any valid mesh is acceptable.
        let cut = open_truncated(&hurt[..hurt.len() - 1]);
        if let Ok(mesh) = cut.and_then(|file| file.mesh()) {
            mesh.check().unwrap();
        }
    }
}

#[test]
fn rejects_streams_of_other_meshes() {
    let encoded = make(&shapes::torus(24, 12, 1.0, 0.4));
    let other = make(&shapes::torus(24, 11, 1.0, 0.4));
    let refused = |stream: &[u8]| {
        let written = file_model(stream)
            .and_then(|model| to_striata(&encoded.refinable, &[model], &WriteOptions::default()));
        written.unwrap_err()
    };
    assert_eq!(
        refused(&other.stream.bytes).to_string(),
        "the progressive model has 264 vertices, but the mesh has 288"
    );
    let whole = encoded.stream.bytes.len();
    assert_eq!(
        refused(&encoded.stream.bytes[..whole - 1]).to_string(),
        format!("the progressive model has {} bytes, but the mesh has {whole}", whole - 1)
    );
    assert!(refused(&encoded.stream.bytes[..100]).to_string().contains("bytes"));
    assert!(refused(b"no stream").to_string().contains("bytes"));
    assert!(file_model(&[&encoded.stream.bytes[..], &[0]].concat()).is_err());
    let twice = [file_model(&encoded.stream.bytes).unwrap(); 2];
    let error = to_striata(&encoded.refinable, &twice, &WriteOptions::default()).unwrap_err();
    assert!(error.to_string().contains("more than once"), "{error}");
}
