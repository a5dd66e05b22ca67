//! Images of a single pixel, shown until anything better has arrived.

/// Encodes a PNG of one pixel with this color, as 8-bit RGBA.
pub fn placeholder_png(rgba: [u8; 4]) -> Vec<u8> {
    let mut out = b"\x89PNG\r\n\x1a\n".to_vec();
    chunk(&mut out, b"IHDR", &[0, 0, 0, 1, 0, 0, 0, 1, 8, 6, 0, 0, 0]);
    chunk(&mut out, b"IDAT", &stored_zlib(rgba));
    chunk(&mut out, b"IEND", &[]);
    out
}

/// The row of one pixel as a zlib stream with one stored block: an encoder would be larger than all of this
/// crate's code for web pages.
fn stored_zlib([r, g, b, a]: [u8; 4]) -> Vec<u8> {
    let row = [0, r, g, b, a];
    let mut out = vec![0x78, 0x01, 1, row.len() as u8, 0, !(row.len() as u8), 0xff];
    out.extend(row);
    // Adler-32, whose sums do not reach its modulus with so few bytes.
    let (mut first, mut second) = (1u32, 0u32);
    for byte in row {
        first += u32::from(byte);
        second += first;
    }
    out.extend((second << 16 | first).to_be_bytes());
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
