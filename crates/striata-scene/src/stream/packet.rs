//! The outermost layer of a scene stream: its header, and packets with checksums.

use striata::file::SCENE_STREAM_MAGIC;

use super::SceneStreamError;
use super::bytes::{Fields, put_varint};

/// Version of a stream in which every mesh has a stream of its own.
pub(super) const PLAIN_VERSION: u8 = 1;

/// Version of a stream in which meshes have the streams of others; the newest one.
pub(super) const SHARING_VERSION: u8 = 2;

/// Length of the header before the first packet, bytes.
pub(super) const HEADER_BYTES: usize = 16;

/// Content of a packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum PacketKind {
    /// The document with the table of everything else.
    Document,
    /// The next bytes of a mesh's own stream.
    Mesh,
    /// A part of the scene's buffer.
    Buffer,
    /// A small version of an image.
    Preview,
    /// The next bytes of an image.
    Image,
}

const KINDS: [PacketKind; 5] =
    [PacketKind::Document, PacketKind::Mesh, PacketKind::Buffer, PacketKind::Preview, PacketKind::Image];

/// The fields before the payload of a packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PacketHead {
    pub kind: PacketKind,
    /// Index of the mesh, image or part.
    pub index: u32,
    /// Length of the payload, bytes.
    pub length: usize,
    /// CRC-32 of the other fields and the payload.
    checksum: u32,
    /// Length of these fields, bytes.
    pub head_bytes: usize,
}

/// Version and length in the header of a stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PacketHeader {
    pub version: u8,
    /// Length of the whole stream, bytes.
    pub length: u64,
}

/// Appends the header of a stream of which the length is not known yet.
pub(super) fn begin(version: u8, out: &mut Vec<u8>) {
    out.extend(SCENE_STREAM_MAGIC);
    out.extend([version, 0, 0, 0]);
    out.extend([0; 8]);
}

/// Stores the length of a complete stream in its header.
pub(super) fn end(out: &mut [u8]) {
    let length = out.len() as u64;
    out[8..HEADER_BYTES].copy_from_slice(&length.to_le_bytes());
}

/// Reads the header; [`None`] if there are too few bytes.
pub(super) fn read_header(bytes: &[u8]) -> Result<Option<PacketHeader>, SceneStreamError> {
    let shown = bytes.len().min(4);
    if bytes[..shown] != SCENE_STREAM_MAGIC[..shown] {
        return Err(SceneStreamError::Magic { found: bytes[..bytes.len().min(8)].to_vec() });
    }
    let Some(header) = bytes.first_chunk::<HEADER_BYTES>() else { return Ok(None) };
    let [_, _, _, _, version, reserved @ .., a, b, c, d, e, f, g, h] = *header;
    if !(PLAIN_VERSION..=SHARING_VERSION).contains(&version) {
        let supported = u32::from(SHARING_VERSION);
        return Err(SceneStreamError::Version { found: u32::from(version), supported });
    }
    if reserved != [0; 3] {
        let reason = "reserved bytes of the header are not zero".to_owned();
        return Err(SceneStreamError::Packet { offset: 5, reason });
    }
    Ok(Some(PacketHeader { version, length: u64::from_le_bytes([a, b, c, d, e, f, g, h]) }))
}

/// Appends a packet.
pub(super) fn put_packet(kind: PacketKind, index: usize, payload: &[u8], out: &mut Vec<u8>) {
    let start = out.len();
    out.push(KINDS.iter().position(|&other| other == kind).map_or(0, |at| at as u8 + 1));
    put_varint(index as u64, out);
    put_varint(payload.len() as u64, out);
    let checksum = checksum(&out[start..], payload);
    out.extend(checksum.to_le_bytes());
    out.extend_from_slice(payload);
}

fn checksum(fields: &[u8], payload: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(fields);
    hasher.update(payload);
    hasher.finalize()
}

/// Most bytes of the fields before a payload.
const MAX_HEAD_BYTES: usize = 1 + 5 + 5 + 4;

impl PacketHead {
    /// Reads the fields at the front of `bytes`, at a byte offset of the stream; [`None`] if there are too
    /// few bytes.
    pub(super) fn read(bytes: &[u8], offset: u64) -> Result<Option<Self>, SceneStreamError> {
        let fail = |reason: &str| Err(SceneStreamError::Packet { offset, reason: reason.to_owned() });
        let Some(&code) = bytes.first() else { return Ok(None) };
        let Some(&kind) = usize::from(code).checked_sub(1).and_then(|at| KINDS.get(at)) else {
            return fail("unknown kind");
        };
        let mut fields = Fields::new(&bytes[1..]);
        let read = (fields.varint_u32(), fields.varint_u32(), fields.array());
        let (Some(index), Some(length), Some(checksum)) = read else {
            return if bytes.len() < MAX_HEAD_BYTES { Ok(None) } else { fail("a number is too large") };
        };
        let head_bytes = bytes.len() - fields.rest().len();
        let checksum = u32::from_le_bytes(checksum);
        Ok(Some(Self { kind, index, length: length as usize, checksum, head_bytes }))
    }

    /// Length of the packet with its payload, bytes.
    pub(super) fn whole_bytes(&self) -> u64 {
        self.head_bytes as u64 + self.length as u64
    }

    /// Compares the checksum with that of the complete packet at the front of `bytes`.
    pub(super) fn check(&self, bytes: &[u8], offset: u64) -> Result<(), SceneStreamError> {
        let payload = &bytes[self.head_bytes..self.head_bytes + self.length];
        let found = checksum(&bytes[..self.head_bytes - 4], payload);
        if found == self.checksum {
            return Ok(());
        }
        Err(SceneStreamError::Checksum { offset, found, expected: self.checksum })
    }
}
