//! The scene's buffer in two parts, each compressed by accessor.
//!
//! Skins, points and lines are needed to draw the scene; animations can come later. Floats that change slowly
//! compress better if each is replaced by the difference of its bits to the element before, and if bytes of
//! equal significance are adjacent. For each accessor the writer tries both and keeps what is smallest.

use std::collections::BTreeSet;

use serde_json::Value;

use super::accessors::place_of;
use super::bytes::{Fields, put_varint};
use super::deflate::{deflate, inflate};
use super::filter::{Filter, apply, common_exponent, undo};
use super::head::{ByteRange, PART_COUNT};
use crate::document::{entries, index};

/// Returns how many bytes may be unpacked from `packed` bytes: more than Deflate can do, but for the limit.
fn limit_of(packed: usize) -> usize {
    packed.saturating_mul(1100).saturating_add(1 << 12)
}

/// Divides the buffer into what is needed for drawing and what only animations need.
pub(super) fn parts_of(document: &Value, buffer_bytes: usize) -> [Vec<ByteRange>; PART_COUNT] {
    let mut late = vec![false; buffer_bytes];
    let animated = animated_accessors(document);
    let accessors = entries(document, "accessors");
    let places = |is_animated: bool| -> Vec<std::ops::Range<usize>> {
        let chosen = accessors.iter().enumerate().filter(|(at, _)| animated.contains(at) == is_animated);
        chosen.filter_map(|(_, accessor)| view_range(document, accessor, buffer_bytes)).collect()
    };
    let (of_animations, others) = (places(true), places(false));
    of_animations.into_iter().for_each(|range| late[range].fill(true));
    others.into_iter().for_each(|range| late[range].fill(false));
    let mut parts: [Vec<ByteRange>; PART_COUNT] = Default::default();
    let mut start = 0;
    for run in late.chunk_by(|a, b| a == b) {
        let range = ByteRange { offset: start as u64, length: run.len() as u64 };
        parts[usize::from(run[0])].push(range);
        start += run.len();
    }
    parts
}

/// Returns the accessors that animations refer to.
pub(super) fn animated_accessors(document: &Value) -> BTreeSet<usize> {
    let samplers =
        entries(document, "animations").iter().flat_map(|animation| entries(animation, "samplers"));
    let of_sampler = |sampler: &Value| [index(sampler, "input"), index(sampler, "output")];
    samplers.flat_map(of_sampler).flatten().collect()
}

/// Returns the bytes of an accessor; all of its view if they are not known exactly.
fn view_range(document: &Value, accessor: &Value, buffer_bytes: usize) -> Option<std::ops::Range<usize>> {
    if let Some(place) = place_of(document, accessor, buffer_bytes) {
        return Some(place.bytes);
    }
    let view = super::json::referred(document, "bufferViews", accessor, "bufferView")?;
    let start = index(view, "byteOffset").unwrap_or(0);
    let end = start.checked_add(index(view, "byteLength")?)?;
    (end <= buffer_bytes).then_some(start..end)
}

/// A run of elements with the same layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct BufferSegment {
    length: usize,
    stride: usize,
    filter: Filter,
}

/// Compresses a part of the buffer.
pub(super) fn pack(document: &Value, buffer: &[u8], part: &[ByteRange]) -> Vec<u8> {
    let (bytes, segments) = gather(document, buffer, part);
    let (mut filtered, mut chosen, mut start) = (Vec::new(), Vec::new(), 0);
    for segment in segments {
        let own = &bytes[start..start + segment.length];
        start += segment.length;
        let mut candidates = vec![Filter::None];
        if segment.stride > 1 {
            candidates.push(Filter::Planes);
        }
        if segment.filter == Filter::Differences {
            candidates.push(Filter::Differences);
            candidates.extend(common_exponent(own).map(|exponent| Filter::Multiples { exponent }));
        }
        let smallest = candidates
            .into_iter()
            .map(|filter| (filter, apply(own, segment.stride, filter)))
            .min_by_key(|(_, bytes)| deflate(bytes, |_| usize::MAX).len());
        let Some((filter, bytes)) = smallest else { continue };
        chosen.push(BufferSegment { filter, ..segment });
        filtered.extend(bytes);
    }
    let mut out = Vec::new();
    put_varint(chosen.len() as u64, &mut out);
    for segment in chosen {
        put_varint(segment.length as u64, &mut out);
        put_varint(segment.stride as u64, &mut out);
        out.extend(segment.filter.code());
    }
    out.extend(filtered);
    deflate(&out, limit_of)
}

/// Collects the bytes of a part, and divides them into segments by accessor. A segment that may be coded by
/// differences is marked as such.
fn gather(document: &Value, buffer: &[u8], part: &[ByteRange]) -> (Vec<u8>, Vec<BufferSegment>) {
    let mut places: Vec<_> = entries(document, "accessors")
        .iter()
        .filter_map(|accessor| place_of(document, accessor, buffer.len()))
        .collect();
    places.sort_unstable_by_key(|place| (place.bytes.start, place.bytes.end));
    let plain = |length| BufferSegment { length, stride: 1, filter: Filter::None };
    let (mut bytes, mut segments) = (Vec::new(), Vec::new());
    for range in part {
        let (mut at, end) = (range.offset as usize, (range.offset + range.length) as usize);
        bytes.extend_from_slice(&buffer[at..end]);
        let first = places.partition_point(|place| place.bytes.start < at);
        for place in &places[first..] {
            if place.bytes.start >= end {
                break;
            }
            if place.bytes.start < at || place.bytes.end > end {
                continue;
            }
            if place.bytes.start > at {
                segments.push(plain(place.bytes.start - at));
            }
            let filter = if place.is_wide && place.stride.is_multiple_of(4) {
                Filter::Differences
            } else {
                Filter::Planes
            };
            segments.push(BufferSegment { length: place.bytes.len(), stride: place.stride, filter });
            at = place.bytes.end;
        }
        if at < end {
            segments.push(plain(end - at));
        }
    }
    (bytes, segments)
}

/// Unpacks a part of the buffer of a known length; [`None`] if it is malformed.
pub(super) fn unpack(packed: &[u8], length: u64) -> Option<Vec<u8>> {
    let bytes = inflate(packed, limit_of(packed.len()))?;
    let mut fields = Fields::new(&bytes);
    let count = fields.count(4)?;
    let mut segments = Vec::with_capacity(count);
    for _ in 0..count {
        let (length, stride) =
            (usize::try_from(fields.varint()?).ok()?, usize::try_from(fields.varint()?).ok()?);
        let filter = Filter::from_code(fields.array()?, stride)?;
        segments.push(BufferSegment { length, stride, filter });
    }
    let mut out = Vec::new();
    for segment in segments {
        out.extend(undo(fields.bytes(segment.length)?, segment.stride, segment.filter));
    }
    (fields.rest().is_empty() && out.len() as u64 == length).then_some(out)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn animations_come_later_and_everything_round_trips() {
        let mut buffer: Vec<u8> = (0..64u32).flat_map(|i| (i as f32 * 0.1).to_le_bytes()).collect();
        buffer.extend(b"odd bytes between");
        buffer.resize(280, 1);
        buffer.extend((0..30u16).flat_map(u16::to_le_bytes));
        let accessor = |view: usize, offset: usize, component: usize, kind: &str, count: usize| json!({ "bufferView": view, "byteOffset": offset, "componentType": component, "type": kind, "count": count });
        let document = json!({
            "bufferViews": [
                { "buffer": 0, "byteLength": 256 },
                { "buffer": 0, "byteOffset": 280, "byteLength": 60 },
            ],
            "accessors": [
                accessor(0, 0, 5126, "SCALAR", 16),
                accessor(0, 64, 5126, "VEC4", 12),
                accessor(1, 0, 5123, "VEC3", 10),
            ],
            "animations": [{ "samplers": [{ "input": 0, "output": 1 }], "channels": [] }],
        });
        let parts = parts_of(&document, buffer.len());
        assert_eq!(parts[1], vec![ByteRange { offset: 0, length: 256 }]);
        assert_eq!(parts[0], vec![ByteRange { offset: 256, length: 84 }]);
        for part in &parts {
            let expected: Vec<u8> = part
                .iter()
                .flat_map(|range| &buffer[range.offset as usize..(range.offset + range.length) as usize])
                .copied()
                .collect();
            let packed = pack(&document, &buffer, part);
            assert_eq!(unpack(&packed, expected.len() as u64).as_ref(), Some(&expected));
            assert_eq!(unpack(&packed, expected.len() as u64 + 1), None);
            for at in 0..packed.len() {
                let mut bad = packed.clone();
                bad[at] ^= 0x55;
                if let Some(found) = unpack(&bad, expected.len() as u64) {
                    assert_eq!(found.len(), expected.len());
                }
            }
        }
    }
}
