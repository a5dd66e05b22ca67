//! Reads the counts of a model from the first bytes of its file, for the list of models.
//!
//! A count is reported only if the header proves it. For example, the faces of a PLY are counted as
//! triangles only if the file has exactly the length that triangles give. Cost: one read of at most 64 KiB,
//! or 1 MiB if a stream's header is that long.

use std::collections::BTreeSet;
use std::io::{self, Read, Seek, SeekFrom};

use serde::Deserialize;
use striata::file::FileHead;
use striata_io::Format;
use striata_paged::{PAGED_MAGIC, PagedReader};
use striata_stream::StreamInfo;

/// Bytes read at first.
const HEAD_BYTES: usize = 64 << 10;
/// Bytes read if the first read was too short.
const LONG_HEAD_BYTES: usize = 1 << 20;

/// Facts from the header of a model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct HeaderFacts {
    /// Whether the model can be streamed.
    pub streams: bool,
    /// Triangle count of the full mesh, if known.
    pub triangle_count: Option<u64>,
    /// Vertex count of the full mesh, if known.
    pub vertex_count: Option<u64>,
    /// Size of the files that the model refers to, bytes.
    pub companion_bytes: u64,
}

impl HeaderFacts {
    /// Reads the facts from a file's first bytes; empty if they are damaged.
    pub(super) fn read(name: &str, file: &mut (impl Read + Seek), length: u64) -> Self {
        let read = |file: &mut _, bytes| first_bytes(file, bytes).unwrap_or_default();
        let bytes = read(file, HEAD_BYTES);
        // The contents of compressed files are unknown without decompressing them.
        match Format::detect(&bytes, name) {
            _ if matches!(bytes.as_slice(), [0x1f, 0x8b, ..] | [0x28, 0xb5, 0x2f, 0xfd, ..]) => None,
            Some(Format::Striata) if bytes.starts_with(PAGED_MAGIC) => of_paged(file),
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

/// Longest document whose references are looked up, bytes.
const MAX_DOCUMENT_BYTES: u64 = 16 << 20;

/// URIs of the buffers and images of a glTF document, each once; none for other files.
pub(super) fn companions(name: &str, file: &mut (impl Read + Seek), length: u64) -> BTreeSet<String> {
    #[derive(Deserialize)]
    struct Entry {
        uri: Option<String>,
    }
    #[derive(Deserialize)]
    struct Document {
        #[serde(default)]
        buffers: Vec<Entry>,
        #[serde(default)]
        images: Vec<Entry>,
    }
    if Format::from_extension(name) != Some(Format::Gltf) || length > MAX_DOCUMENT_BYTES {
        return BTreeSet::new();
    }
    let bytes = first_bytes(file, MAX_DOCUMENT_BYTES as usize).unwrap_or_default();
    let Ok(document) = serde_json::from_slice::<Document>(&bytes) else { return BTreeSet::new() };
    let uris = document.buffers.into_iter().chain(document.images).filter_map(|entry| entry.uri);
    uris.filter(|uri| !uri.starts_with("data:")).collect()
}

fn first_bytes(file: &mut (impl Read + Seek), count: usize) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.seek(SeekFrom::Start(0))?;
    file.take(count as u64).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn of_container(bytes: &[u8]) -> Option<HeaderFacts> {
    let head = FileHead::read(bytes).ok()??;
    Some(HeaderFacts {
        streams: head.stream().is_some(),
        triangle_count: Some(head.summary.triangle_count as u64),
        vertex_count: Some(head.summary.vertex_count as u64),
        ..HeaderFacts::default()
    })
}

fn of_paged(file: &mut (impl Read + Seek)) -> Option<HeaderFacts> {
    let mut reader = PagedReader::new();
    while reader.metadata().is_none() {
        let want = reader.wants().into_iter().next()?;
        let length = (want.range.end - want.range.start).min(MAX_DOCUMENT_BYTES);
        file.seek(SeekFrom::Start(want.range.start)).ok()?;
        let mut bytes = Vec::new();
        file.take(length).read_to_end(&mut bytes).ok()?;
        reader.supply(&want, &bytes).ok()?;
    }
    let metadata = reader.metadata()?;
    Some(HeaderFacts {
        streams: true,
        triangle_count: Some(metadata.triangle_count),
        vertex_count: Some(metadata.vertex_count),
        ..HeaderFacts::default()
    })
}

fn of_stream(bytes: &[u8]) -> Option<HeaderFacts> {
    let facts = StreamInfo::read(bytes).ok()??;
    let [triangle_count, vertex_count] = [facts.triangle_count, facts.vertex_count].map(|n| Some(n as u64));
    Some(HeaderFacts { streams: true, triangle_count, vertex_count, ..HeaderFacts::default() })
}

fn of_stl(bytes: &[u8], length: u64) -> Option<HeaderFacts> {
    let count = u64::from(u32::from_le_bytes(*bytes.get(80..84)?.first_chunk()?));
    let is_binary = length == 84 + 50 * count;
    is_binary.then_some(HeaderFacts { triangle_count: Some(count), ..HeaderFacts::default() })
}

fn of_off(bytes: &[u8]) -> Option<HeaderFacts> {
    let text = String::from_utf8_lossy(bytes);
    let lines = text.lines().map(|line| line.split('#').next().unwrap_or_default());
    let mut words = lines.flat_map(str::split_whitespace);
    // The keyword also marks binary files and dimensions other than three, which are not supported here.
    let keyword = words.next().filter(|word| word.ends_with("OFF") && !word.contains(['4', 'n']))?;
    debug_assert!(!keyword.is_empty());
    Some(HeaderFacts { vertex_count: words.next()?.parse().ok(), ..HeaderFacts::default() })
}

/// Header of a PLY file.
#[derive(Debug, Default)]
struct PlyHeader {
    /// Elements in order: name, count, bytes of the fixed properties, and bytes of the list properties of
    /// a triangle.
    elements: Vec<(String, u64, u64, u64)>,
    is_binary: bool,
}

fn of_ply(bytes: &[u8], length: u64) -> Option<HeaderFacts> {
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
    Some(HeaderFacts {
        vertex_count: count("vertex"),
        triangle_count: are_triangles.then_some(faces),
        ..HeaderFacts::default()
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

    fn head(name: &str, bytes: &[u8]) -> HeaderFacts {
        HeaderFacts::read(name, &mut Cursor::new(bytes), bytes.len() as u64)
    }

    fn counts(head: HeaderFacts) -> [Option<u64>; 2] {
        [head.triangle_count, head.vertex_count]
    }

    #[test]
    fn headers_report_only_certain_counts() {
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
        assert_eq!(counts(head("a.ply", &longer)), [None, vertices], "the length does not match triangles");
        let ascii = to_bytes(Format::Ply, &mesh, &WriteOptions::default().with_ascii(true));
        assert_eq!(counts(head("a.ply", &ascii.expect("a small mesh"))), [None, vertices]);
    }

    #[test]
    fn companions_are_those_of_the_document() {
        let json = br#"{"buffers": [{"uri": "a%20b.bin"}, {"byteLength": 3}], "images": [{"uri": "x.png"},
            {"uri": "x.png"}, {"uri": "data:image/png;base64,AA=="}, {"bufferView": 1}]}"#;
        let found = |name| companions(name, &mut Cursor::new(&json[..]), json.len() as u64);
        assert_eq!(found("a.gltf").into_iter().collect::<Vec<_>>(), ["a%20b.bin", "x.png"]);
        assert!(found("a.obj").is_empty());
        assert!(companions("a.gltf", &mut Cursor::new(b"{"), 1).is_empty());
    }

    #[test]
    fn damaged_headers_report_nothing() {
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
            assert_eq!(head(name, bytes), HeaderFacts::default(), "{name}: {}", bytes.escape_ascii());
        }
        let enormous = b"ply\nformat binary_little_endian 1.0\nelement face 18446744073709551615\n\
                         property list uchar int vertex_indices\nend_header\n";
        assert_eq!(counts(head("a.ply", enormous)), [None, None]);
    }
}
