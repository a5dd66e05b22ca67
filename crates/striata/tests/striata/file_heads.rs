//! File headers of `.striata`: read from the first bytes, rejected if damaged. Also streams without a
//! decoder.

use striata::file::{
    DecodeError, EncodeError, FileHead, FileModel, StoredStream, StriataFile, WriteOptions, to_striata,
};
use striata::mesh::{RefinableMesh, shapes};
use striata::model::LodStrips;
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::stripify;

fn make() -> RefinableMesh {
    let mesh = shapes::torus(24, 12, 1.0, 0.4);
    build_sequence(&mesh, &SequenceOptions::default()).unwrap().refinable
}

/// A stream that claims to belong to a mesh; its bytes are not read in these tests.
fn stream_of<'s>(refinable: &RefinableMesh, bytes: &'s [u8]) -> StoredStream<'s> {
    StoredStream {
        bytes,
        vertex_count: refinable.mesh.vertex_count(),
        triangle_count: refinable.mesh.triangle_count(),
        step_count: refinable.sequence.step_count(),
        group_count: refinable.mesh.groups.len(),
    }
}

fn with_strips(refinable: &RefinableMesh, stream: Option<&[u8]>) -> Vec<u8> {
    let strips = stripify(&refinable.mesh).unwrap();
    let model = LodStrips::build(refinable, &strips).unwrap();
    let mut models = vec![FileModel::LodStrips(&model)];
    models.extend(stream.map(|bytes| FileModel::Progressive(stream_of(refinable, bytes))));
    to_striata(refinable, &models, &WriteOptions::default()).unwrap()
}

fn stream_alone(refinable: &RefinableMesh, stream: &[u8]) -> Vec<u8> {
    let models = [FileModel::Progressive(stream_of(refinable, stream))];
    to_striata(refinable, &models, &WriteOptions::default()).unwrap()
}

#[test]
fn the_head_matches_the_whole_file() {
    let (refinable, stream) = (make(), [7; 5000]);
    for (bytes, has_stream) in [
        (with_strips(&refinable, None), false),
        (with_strips(&refinable, Some(&stream)), true),
        (stream_alone(&refinable, &stream), true),
    ] {
        let whole = StriataFile::parse(&bytes).unwrap();
        let mut least = None;
        for length in 0..=bytes.len() {
            let head = FileHead::read(&bytes[..length]).unwrap();
            let Some(head) = head else {
                assert_eq!(least, None, "what is enough stays enough");
                continue;
            };
            least = least.or(Some(length));
            assert_eq!(head.file_bytes, bytes.len() as u64);
            assert_eq!(head.sections, whole.sections());
            assert_eq!(head.summary, whole.summary());
            assert_eq!(head.summary.triangle_count, 2 * 24 * 12);
            assert_eq!(head.stream().is_some(), has_stream);
        }
        assert!(least.is_some_and(|least| least < 2048), "{least:?} bytes");
    }
}

#[test]
fn the_head_locates_the_stream() {
    let stream = [7; 5000];
    let bytes = with_strips(&make(), Some(&stream));
    let section = FileHead::read(&bytes[..2048]).unwrap().unwrap().stream().unwrap();
    assert_eq!(bytes[section.offset as usize..][..section.bytes as usize], stream);
}

#[test]
fn a_damaged_head_is_rejected() {
    let bytes = with_strips(&make(), None);
    let first = StriataFile::parse(&bytes).unwrap().sections()[0].offset as usize;
    let table = StriataFile::parse(&bytes).unwrap().sections().len() * 32 + 64;
    for place in (0..table).chain(first..first + 40) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 4;
        assert!(FileHead::read(&damaged).is_err(), "damage at byte {place} was not detected");
    }
}

#[test]
fn a_stream_alone_needs_a_decoder() {
    let refinable = make();
    let bytes = stream_alone(&refinable, &[7; 5000]);
    let cut = &bytes[..bytes.len() - 1];
    for file in [StriataFile::parse(&bytes).unwrap(), StriataFile::parse_truncated(cut).unwrap()] {
        assert!(file.is_stream_only());
        assert_eq!(file.summary().vertex_count, refinable.mesh.vertex_count());
        assert_eq!(file.mesh().unwrap_err(), DecodeError::NoStreamCodec);
        assert_eq!(file.sequence().unwrap_err(), DecodeError::NoStreamCodec);
        assert_eq!(file.level(0).unwrap_err(), DecodeError::NoStreamCodec);
        assert_eq!(file.metadata().unwrap_err(), DecodeError::NoStreamCodec);
    }
    assert_eq!(
        DecodeError::NoStreamCodec.to_string(),
        "the mesh is in a progressive stream, which needs the striata-stream crate"
    );
    // With other models in the file, the stream is not needed.
    let bytes = with_strips(&refinable, Some(&[7; 5000]));
    let file = StriataFile::parse(&bytes).unwrap();
    assert_eq!(file.mesh().unwrap().triangle_count(), refinable.mesh.triangle_count());
    assert_eq!(file.metadata().unwrap(), []);
}

#[test]
fn streams_of_other_meshes_are_not_written() {
    let refinable = make();
    let right = stream_of(&refinable, &[7; 50]);
    let refused = |stream: StoredStream<'_>| -> EncodeError {
        to_striata(&refinable, &[FileModel::Progressive(stream)], &WriteOptions::default()).unwrap_err()
    };
    for (wrong, what) in [
        (StoredStream { vertex_count: right.vertex_count + 1, ..right }, "vertices"),
        (StoredStream { triangle_count: right.triangle_count + 1, ..right }, "triangles"),
        (StoredStream { step_count: right.step_count + 1, ..right }, "steps"),
        (StoredStream { group_count: right.group_count + 1, ..right }, "groups"),
    ] {
        let error = refused(wrong);
        assert!(error.to_string().contains(what), "{error}");
    }
}
