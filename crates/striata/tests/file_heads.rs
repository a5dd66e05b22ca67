//! Heads of `.striata` files: read from the first bytes, refused where they are damaged.

mod meshes;
mod support;

use striata::codec::progressive::{EncodedStream, StreamOptions, encode_stream};
use striata::codec::{FileHead, FileModel, StriataFile, WriteOptions, to_striata};
use striata::mesh::{RefinableMesh, shapes};
use striata::model::LodStrips;
use striata::simplify::{BatchOptions, build_batches};
use striata::strip::stripify;

struct Made {
    refinable: RefinableMesh,
    stream: EncodedStream,
}

fn make() -> Made {
    let mesh = shapes::torus(24, 12, 1.0, 0.4);
    let built = build_batches(&mesh, &BatchOptions::default(), &mut striata::ignore_progress).unwrap();
    let stream = encode_stream(&built.built.refinable, &built.batches, &StreamOptions::default()).unwrap();
    Made { refinable: stream.reorder(&built.built.refinable), stream }
}

fn with_strips(made: &Made, has_stream: bool) -> Vec<u8> {
    let strips = stripify(&made.refinable.mesh).unwrap();
    let model = LodStrips::build(&made.refinable, &strips).unwrap();
    let mut models = vec![FileModel::LodStrips(&model)];
    models.extend(has_stream.then_some(FileModel::Progressive(&made.stream.bytes)));
    to_striata(&made.refinable, &models, &WriteOptions::default()).unwrap()
}

fn stream_alone(made: &Made) -> Vec<u8> {
    let models = [FileModel::Progressive(&made.stream.bytes)];
    to_striata(&made.refinable, &models, &WriteOptions::default()).unwrap()
}

#[test]
fn a_head_is_that_of_the_whole_file() {
    let made = make();
    for (bytes, has_stream) in
        [(with_strips(&made, false), false), (with_strips(&made, true), true), (stream_alone(&made), true)]
    {
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
fn the_stream_lies_where_the_head_says() {
    let made = make();
    let bytes = with_strips(&made, true);
    let section = FileHead::read(&bytes[..2048]).unwrap().unwrap().stream().unwrap();
    assert_eq!(&bytes[section.offset as usize..][..section.bytes as usize], made.stream.bytes);
}

#[test]
fn a_damaged_head_is_refused() {
    let bytes = with_strips(&make(), false);
    let first = StriataFile::parse(&bytes).unwrap().sections()[0].offset as usize;
    let table = StriataFile::parse(&bytes).unwrap().sections().len() * 32 + 64;
    for place in (0..table).chain(first..first + 40) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 4;
        assert!(FileHead::read(&damaged).is_err(), "damage at byte {place} was not seen");
    }
}
