//! The scene's buffer in two parts, each compressed by accessor.
//!
//! Skins, points and lines are needed to draw the scene; animations can come later. Floats that change slowly
//! compress better if each is replaced by the difference of its bits to the element before, and if bytes of equal
//! significance are adjacent. For each accessor the writer tries both and keeps what is smallest.

use std::collections::BTreeSet;

use serde_json::Value;

use super::accessors::place_of;
use super::bytes::{Fields, put_varint};
use super::deflate::{deflate, inflate};
use super::head::{ByteRange, PART_COUNT};
use super::json::{entries, index};

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

/// Returns the accessors that only animations refer to.
fn animated_accessors(document: &Value) -> BTreeSet<usize> {
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

/// How the bytes of a segment are rearranged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Filter {
    /// Not at all.
    None,
    /// Bytes at the same place of all elements are adjacent.
    Planes,
    /// Differences of 32-bit integers to the element before, then planes.
    Differences,
    /// Floats that are multiples of 2 to the power of `-exponent`: differences of the multiples to the element
    /// before, with the sign in the lowest bit, then planes.
    Multiples { exponent: i8 },
}

impl Filter {
    fn code(self) -> [u8; 2] {
        match self {
            Self::None => [0, 0],
            Self::Planes => [1, 0],
            Self::Differences => [2, 0],
            Self::Multiples { exponent } => [3, exponent as u8],
        }
    }

    /// Returns the filter for a code and the stride of a segment, if both are valid.
    fn from_code(code: [u8; 2], stride: usize) -> Option<Self> {
        let filter = match code {
            [0, 0] => Self::None,
            [1, 0] => Self::Planes,
            [2, 0] => Self::Differences,
            [3, exponent] => Self::Multiples { exponent: exponent as i8 },
            _ => return None,
        };
        let is_of_words = matches!(filter, Self::Differences | Self::Multiples { .. });
        (stride > 0 && (!is_of_words || stride.is_multiple_of(4))).then_some(filter)
    }
}

/// Range of exponents of [`Filter::Multiples`].
const EXPONENTS: std::ops::RangeInclusive<i8> = -64..=64;

/// Returns the smallest exponent for which all floats are multiples, below 2^24, of its power of two.
fn common_exponent(bytes: &[u8]) -> Option<i8> {
    let words = bytes.as_chunks::<4>().0.iter().map(|word| f32::from_le_bytes(*word));
    let mut exponent = *EXPONENTS.start();
    for number in words {
        while !is_multiple(number, exponent) {
            exponent += 1;
            EXPONENTS.contains(&exponent).then_some(())?;
        }
    }
    // Larger numbers may have passed before the exponent rose.
    let mut words = bytes.as_chunks::<4>().0.iter();
    words.all(|word| is_multiple(f32::from_le_bytes(*word), exponent)).then_some(exponent)
}

fn is_multiple(number: f32, exponent: i8) -> bool {
    from_multiple(multiple(number, exponent), exponent).to_bits() == number.to_bits()
}

fn multiple(number: f32, exponent: i8) -> i32 {
    let multiple = f64::from(number) * power_of_two(exponent);
    if multiple.abs() < f64::from(1 << 24) { multiple as i32 } else { 0 }
}

fn from_multiple(multiple: i32, exponent: i8) -> f32 {
    (f64::from(multiple) / power_of_two(exponent)) as f32
}

/// Returns 2 to the power of a number.
fn power_of_two(exponent: i8) -> f64 {
    f64::from_bits((1023 + i64::from(exponent)) as u64 * (1 << 52))
}

/// Puts the sign into the lowest bit.
fn folded(number: i32) -> u32 {
    ((number << 1) ^ (number >> 31)) as u32
}

fn unfolded(number: u32) -> i32 {
    (number >> 1) as i32 ^ -((number & 1) as i32)
}

/// A run of elements with the same layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Segment {
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
        chosen.push(Segment { filter, ..segment });
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
fn gather(document: &Value, buffer: &[u8], part: &[ByteRange]) -> (Vec<u8>, Vec<Segment>) {
    let mut places: Vec<_> = entries(document, "accessors")
        .iter()
        .filter_map(|accessor| place_of(document, accessor, buffer.len()))
        .collect();
    places.sort_unstable_by_key(|place| (place.bytes.start, place.bytes.end));
    let plain = |length| Segment { length, stride: 1, filter: Filter::None };
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
            segments.push(Segment { length: place.bytes.len(), stride: place.stride, filter });
            at = place.bytes.end;
        }
        if at < end {
            segments.push(plain(end - at));
        }
    }
    (bytes, segments)
}

fn apply(bytes: &[u8], stride: usize, filter: Filter) -> Vec<u8> {
    match filter {
        Filter::None => bytes.to_vec(),
        Filter::Planes => planes(bytes, stride),
        Filter::Differences => {
            let (words, rest) = bytes.as_chunks::<4>();
            let lanes = stride / 4;
            let word = |at: usize| u32::from_le_bytes(words[at]);
            let before = |at: usize| at.checked_sub(lanes).map_or(0, word);
            let differences = (0..words.len()).flat_map(|at| word(at).wrapping_sub(before(at)).to_le_bytes());
            planes(&differences.chain(rest.iter().copied()).collect::<Vec<u8>>(), stride)
        }
        Filter::Multiples { exponent } => {
            let (words, rest) = bytes.as_chunks::<4>();
            let lanes = stride / 4;
            let value = |at: usize| multiple(f32::from_le_bytes(words[at]), exponent);
            let before = |at: usize| at.checked_sub(lanes).map_or(0, value);
            let differences =
                (0..words.len()).flat_map(|at| folded(value(at).wrapping_sub(before(at))).to_le_bytes());
            planes(&differences.chain(rest.iter().copied()).collect::<Vec<u8>>(), stride)
        }
    }
}

/// Undoes [`apply`].
fn undo(bytes: &[u8], stride: usize, filter: Filter) -> Vec<u8> {
    match filter {
        Filter::None => bytes.to_vec(),
        Filter::Planes => from_planes(bytes, stride),
        Filter::Differences => {
            let mut bytes = from_planes(bytes, stride);
            let lanes = stride / 4;
            let (words, _) = bytes.as_chunks_mut::<4>();
            for at in lanes..words.len() {
                let sum = u32::from_le_bytes(words[at]).wrapping_add(u32::from_le_bytes(words[at - lanes]));
                words[at] = sum.to_le_bytes();
            }
            bytes
        }
        Filter::Multiples { exponent } => {
            let mut bytes = from_planes(bytes, stride);
            let mut before = vec![0i32; (stride / 4).min(bytes.len() / 4)];
            let lanes = before.len().max(1);
            for (at, word) in bytes.as_chunks_mut::<4>().0.iter_mut().enumerate() {
                let value = before[at % lanes].wrapping_add(unfolded(u32::from_le_bytes(*word)));
                before[at % lanes] = value;
                *word = from_multiple(value, exponent).to_le_bytes();
            }
            bytes
        }
    }
}

fn planes(bytes: &[u8], stride: usize) -> Vec<u8> {
    (0..stride.min(bytes.len())).flat_map(|lane| bytes.iter().skip(lane).step_by(stride)).copied().collect()
}

fn from_planes(bytes: &[u8], stride: usize) -> Vec<u8> {
    let mut out = vec![0; bytes.len()];
    let mut source = bytes.iter();
    for lane in 0..stride.min(bytes.len()) {
        out.iter_mut().skip(lane).step_by(stride).zip(source.by_ref()).for_each(|(slot, &byte)| *slot = byte);
    }
    out
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
        segments.push(Segment { length, stride, filter });
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

    #[test]
    fn filters_are_inverted_at_any_length() {
        for length in [0usize, 1, 3, 4, 7, 16, 33, 100] {
            let bytes: Vec<u8> = (0..length).map(|i| (i * i * 7) as u8).collect();
            for stride in [1, 2, 4, 12, 16, 200] {
                let filters = [Filter::None, Filter::Planes, Filter::Differences];
                for filter in filters {
                    if Filter::from_code(filter.code(), stride).is_none() {
                        continue;
                    }
                    let there = apply(&bytes, stride, filter);
                    assert_eq!(there.len(), bytes.len());
                    assert_eq!(undo(&there, stride, filter), bytes, "{length} {stride} {filter:?}");
                }
            }
        }
    }
    #[test]
    fn multiples_of_powers_of_two_are_exact() {
        let floats: Vec<f32> = (0..100).map(|i| (i * i % 37) as f32 / 256.0 - 3.0).collect();
        let bytes: Vec<u8> = floats.iter().flat_map(|x| x.to_le_bytes()).collect();
        let exponent = common_exponent(&bytes).unwrap();
        assert_eq!(exponent, 8);
        for stride in [4, 12, 16, 4000] {
            let filter = Filter::Multiples { exponent };
            assert_eq!(undo(&apply(&bytes, stride, filter), stride, filter), bytes);
        }
        for odd in [f32::NAN, f32::INFINITY, -0.0, 1e30, 1e-30, std::f32::consts::PI * 1e8] {
            let bytes: Vec<u8> = floats.iter().chain([&odd]).flat_map(|x| x.to_le_bytes()).collect();
            assert_eq!(common_exponent(&bytes), None, "{odd}");
        }
    }
}
