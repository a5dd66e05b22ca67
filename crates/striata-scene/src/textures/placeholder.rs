//! Images of a single pixel, shown until anything better has arrived.

use std::io::Write;

use flate2::Compression;
use flate2::write::ZlibEncoder;

/// Encodes a PNG of one pixel with this color, as 8-bit RGBA.
pub fn placeholder_png(rgba: [u8; 4]) -> Vec<u8> {
    let mut out = b"\x89PNG\r\n\x1a\n".to_vec();
    chunk(&mut out, b"IHDR", &[0, 0, 0, 1, 0, 0, 0, 1, 8, 6, 0, 0, 0]);
    let [r, g, b, a] = rgba;
    let mut packed = ZlibEncoder::new(Vec::new(), Compression::fast());
    let written = packed.write_all(&[0, r, g, b, a]).and_then(|()| packed.finish());
    chunk(&mut out, b"IDAT", &written.unwrap_or_default());
    chunk(&mut out, b"IEND", &[]);
    out
}

fn chunk(out: &mut Vec<u8>, name: &[u8; 4], data: &[u8]) {
    out.extend((data.len() as u32).to_be_bytes());
    let start = out.len();
    out.extend_from_slice(name);
    out.extend_from_slice(data);
    let checksum = crc32fast::hash(&out[start..]);
    out.extend(checksum.to_be_bytes());
}
