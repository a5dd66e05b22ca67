//! Scene streams with an uncompressed document and correct checksums, so that damage reaches the code behind.

use std::io::Write;

use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;

/// Length of the header of a stream, bytes.
const HEADER: usize = 16;

/// Kind of the packet whose payload is compressed as a whole.
const DOCUMENT: u8 = 1;

/// Returns a stream as the input of a fuzzer: without checksums, its document uncompressed.
pub fn unpacked(stream: &[u8]) -> Vec<u8> {
    let mut out = stream[..HEADER].to_vec();
    for (kind, index, payload) in packets(&stream[HEADER..], 4) {
        let mut plain = Vec::new();
        let payload = match kind {
            DOCUMENT => {
                let read = std::io::Read::read_to_end(&mut DeflateDecoder::new(payload), &mut plain);
                read.expect("the stream is our own");
                &plain[..]
            }
            _ => payload,
        };
        put_head(kind, index, payload.len() as u64, &mut out);
        out.extend(payload);
    }
    out
}

/// Returns the stream that [`unpacked`] bytes describe.
pub fn packed(bytes: &[u8]) -> Vec<u8> {
    let (header, rest) = bytes.split_at(bytes.len().min(HEADER));
    let mut out = header.to_vec();
    for (kind, index, payload) in packets(rest, 0) {
        let mut deflated = Vec::new();
        let payload = if kind == DOCUMENT {
            let mut encoder = DeflateEncoder::new(&mut deflated, Compression::fast());
            encoder.write_all(payload).and_then(|()| encoder.finish().map(drop)).expect("memory suffices");
            &deflated[..]
        } else {
            payload
        };
        let mut head = Vec::new();
        put_head(kind, index, payload.len() as u64, &mut head);
        let mut checksum = crc32fast::Hasher::new();
        checksum.update(&head);
        checksum.update(payload);
        out.extend(head);
        out.extend(checksum.finalize().to_le_bytes());
        out.extend(payload);
    }
    if out.len() >= HEADER {
        let length = out.len() as u64;
        out[8..HEADER].copy_from_slice(&length.to_le_bytes());
    }
    out
}

/// Kind, index and payload of a packet.
type Packet<'a> = (u8, u64, &'a [u8]);

/// Splits bytes into packets that have `checksum` bytes between lengths and payloads; the last may be cut.
fn packets(mut bytes: &[u8], checksum: usize) -> Vec<Packet<'_>> {
    let mut found = Vec::new();
    while let Some((&kind, rest)) = bytes.split_first() {
        bytes = rest;
        let (index, length) = (varint(&mut bytes), varint(&mut bytes));
        bytes = bytes.get(checksum..).unwrap_or_default();
        let length = usize::try_from(length).unwrap_or(usize::MAX).min(bytes.len());
        let (payload, rest) = bytes.split_at(length);
        found.push((kind, index, payload));
        bytes = rest;
    }
    found
}

fn put_head(kind: u8, index: u64, length: u64, out: &mut Vec<u8>) {
    out.push(kind);
    for mut value in [index, length] {
        while value >= 0x80 {
            out.push(value as u8 | 0x80);
            value >>= 7;
        }
        out.push(value as u8);
    }
}

fn varint(bytes: &mut &[u8]) -> u64 {
    let mut value = 0;
    for place in 0..9 {
        let Some((&byte, rest)) = bytes.split_first() else { break };
        *bytes = rest;
        value |= u64::from(byte & 0x7f) << (7 * place);
        if byte < 0x80 {
            break;
        }
    }
    value
}
