//! Counts from the first bytes of a file: what a list can tell of a model without reading it.
//!
//! A number is told only where the head is sure of it: polygons of a PLY, for one, are triangles only if the file is just as
//! long as triangles make it. Cost: one read of at most 64 KiB, or 1 MiB where a stream's head is that long.

use std::io::{self, Read, Seek, SeekFrom};

use striata::file::FileHead;
use striata_io::Format;
use striata_stream::StreamInfo;

/// Bytes that are read at first.
const HEAD_BYTES: usize = 64 << 10;
/// Bytes that are read where those do not do.
const LONG_HEAD_BYTES: usize = 1 << 20;

/// What the head of a model tells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Head {
    /// Whether the model can be shown from its first bytes on.
    pub(super) streams: bool,
    /// Triangles of the full mesh.
    pub(super) triangle_count: Option<u64>,
    /// Vertices of the full mesh.
    pub(super) vertex_count: Option<u64>,
}

impl Head {
    /// What the first bytes of a file tell; nothing where they are damaged.
    pub(super) fn read(name: &str, file: &mut (impl Read + Seek), length: u64) -> Self {
        let read = |file: &mut _, bytes| first_bytes(file, bytes).unwrap_or_default();
        let bytes = read(file, HEAD_BYTES);
        // Packed files tell nothing: their name says what they hold, their bytes do not.
        match Format::detect(&bytes, name) {
            _ if matches!(bytes.as_slice(), [0x1f, 0x8b, ..] | [0x28, 0xb5, 0x2f, 0xfd, ..]) => None,
            Some(Format::Striata) => {
                of_container(&bytes).or_else(|| of_container(&read(file, LONG_HEAD_BYTES)))
            }
            Some(Format::Stream) => of_stream(&bytes).or_else(|| of_stream(&read(file, LONG_HEAD_BYTES))),
            Some(Format::Ply) => of_ply(&bytes, length),
            Some(Format::Stl) => of_stl(&bytes, length),
            Some(Format::Off) => of_off(&bytes),
            _ => None,
        }
        .unwrap_or_default()
    }
}

fn first_bytes(file: &mut (impl Read + Seek), count: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.seek(SeekFrom::Start(0))?;
    file.take(count as u64).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn of_container(bytes: &[u8]) -> Option<Head> {
    let head = FileHead::read(bytes).ok()??;
    Some(Head {
        streams: head.stream().is_some(),
        triangle_count: Some(head.summary.triangle_count as u64),
        vertex_count: Some(head.summary.vertex_count as u64),
    })
}

fn of_stream(bytes: &[u8]) -> Option<Head> {
    let facts = StreamInfo::read(bytes).ok()??;
    let [triangle_count, vertex_count] = [facts.triangle_count, facts.vertex_count].map(|n| Some(n as u64));
    Some(Head { streams: true, triangle_count, vertex_count })
}

fn of_stl(bytes: &[u8], length: u64) -> Option<Head> {
    let count = u64::from(u32::from_le_bytes(*bytes.get(80..84)?.first_chunk()?));
    let is_binary = length == 84 + 50 * count;
    is_binary.then_some(Head { triangle_count: Some(count), ..Head::default() })
}

fn of_off(bytes: &[u8]) -> Option<Head> {
    let text = String::from_utf8_lossy(bytes);
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or_default());
    let mut words = lines.flat_map(str::split_whitespace);
    // Binary ones say so, and those of other dimensions have a number first.
    let keyword = words.next().filter(|word| word.ends_with("OFF") && !word.contains(['4', 'n']))?;
    debug_assert!(!keyword.is_empty());
    Some(Head { vertex_count: words.next()?.parse().ok(), ..Head::default() })
}

/// What a PLY's header tells.
#[derive(Debug, Default)]
struct PlyHeader {
    /// Elements in their order: name, count, bytes of the fixed properties, and of a triangle's list.
    elements: Vec<(String, u64, u64, u64)>,
    is_binary: bool,
}

fn of_ply(bytes: &[u8], length: u64) -> Option<Head> {
    const END: &[u8] = b"end_header\n";
    let end = bytes.windows(END.len()).position(|window| window == END)? + END.len();
    let header = PlyHeader::parse(&String::from_utf8_lossy(&bytes[..end]))?;
    let count = |name: &str| header.elements.iter().find(|(known, ..)| known == name).map(|&(_, n, ..)| n);
    let faces = count("face").unwrap_or(0);
    let as_triangles = header
        .elements
        .iter()
        .try_fold(end as u64, |sum, &(_, n, fixed, list)| sum.checked_add(n.checked_mul(fixed + list)?));
    let are_triangles = faces == 0 || header.is_binary && as_triangles == Some(length);
    Some(Head {
        vertex_count: count("vertex"),
        triangle_count: are_triangles.then_some(faces),
        streams: false,
    })
}

impl PlyHeader {
    fn parse(text: &str) -> Option<Self> {
        let mut header = Self::default();
        for line in text.lines() {
            let words: Vec<&str> = line.split_whitespace().collect();
            match words.as_slice() {
                ["format", format, ..] => header.is_binary = *format != "ascii",
                ["element", name, count] => {
                    header.elements.push(((*name).to_owned(), count.parse().ok()?, 0, 0));
                }
                ["property", "list", count, index, _] => {
                    let (_, _, _, list) = header.elements.last_mut()?;
                    *list += bytes_of(count)? + 3 * bytes_of(index)?;
                }
                ["property", number, _] => {
                    let (_, _, fixed, _) = header.elements.last_mut()?;
                    *fixed += bytes_of(number)?;
                }
                _ => {}
            }
        }
        Some(header)
    }
}

fn bytes_of(number: &str) -> Option<u64> {
    Some(match number {
        "char" | "uchar" | "int8" | "uint8" => 1,
        "short" | "ushort" | "int16" | "uint16" => 2,
        "int" | "uint" | "float" | "int32" | "uint32" | "float32" => 4,
        "double" | "float64" => 8,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use striata::mesh::shapes;
    use striata_io::{WriteOptions, to_bytes};

    use super::*;

    fn head(name: &str, bytes: &[u8]) -> Head {
        Head::read(name, &mut Cursor::new(bytes), bytes.len() as u64)
    }

    fn counts(head: Head) -> [Option<u64>; 2] {
        [head.triangle_count, head.vertex_count]
    }

    #[test]
    fn heads_tell_what_they_are_sure_of() {
        let mesh = shapes::icosphere(2, 1.0);
        let [triangles, vertices] = [mesh.triangle_count(), mesh.vertex_count()].map(|n| Some(n as u64));
        let bytes = |format| to_bytes(format, &mesh, &WriteOptions::default()).expect("a small mesh");
        assert_eq!(counts(head("a.ply", &bytes(Format::Ply))), [triangles, vertices]);
        assert_eq!(counts(head("a.stl", &bytes(Format::Stl))), [triangles, None]);
        assert_eq!(counts(head("a.off", &bytes(Format::Off))), [None, vertices]);
        assert_eq!(counts(head("a.obj", &bytes(Format::Obj))), [None, None]);
        assert_eq!(counts(head("a.glb", &bytes(Format::Glb))), [None, None]);
        let mut longer = bytes(Format::Ply);
        longer.push(0);
        assert_eq!(counts(head("a.ply", &longer)), [None, vertices], "not as long as triangles make it");
        let ascii = to_bytes(Format::Ply, &mesh, &WriteOptions::default().with_ascii(true));
        assert_eq!(counts(head("a.ply", &ascii.expect("a small mesh"))), [None, vertices]);
    }

    #[test]
    fn damaged_heads_tell_nothing() {
        for (name, bytes) in [
            ("a.striata", &b"STRIATA\0\x01\0\0\0\xff\xff\xff\xff"[..]),
            ("a.stri", b"\x89STR\x01"),
            ("a.ply", b"ply\nformat ascii 1.0\nelement vertex -1\nend_header\n"),
            ("a.ply", b"ply\nelement vertex 99999999999999999999999\nend_header\n"),
            ("a.ply", b"ply\nproperty float x\nend_header\n"),
            ("a.ply", b""),
            ("a.off", b"OFF"),
            ("a.stl", b"solid"),
            ("a.ply.gz", b"\x1f\x8b\x08"),
        ] {
            assert_eq!(head(name, bytes), Head::default(), "{name}: {}", bytes.escape_ascii());
        }
        let enormous = b"ply\nformat binary_little_endian 1.0\nelement face 18446744073709551615\n\
                         property list uchar int vertex_indices\nend_header\n";
        assert_eq!(counts(head("a.ply", enormous)), [None, None]);
    }
}
