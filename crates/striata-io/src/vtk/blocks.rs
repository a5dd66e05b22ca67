//! Bytes of the arrays of XML files: base64, blocks with a header, and their compression.
//!
//! ```text
//! plain       n            n bytes
//! compressed  k u p s1..sk  k blocks of s1 to sk bytes, which unpack to u bytes each, the last one to p
//! ```
//!
//! The numbers of headers have 4 or 8 bytes. In base64, the header is a text of its own if it is followed by
//! compressed blocks, and with some writers also before plain bytes, so that padding may occur in the middle.

use std::io::Read as _;

/// How arrays are stored in a file.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Storage {
    pub is_big_endian: bool,
    /// Whether the numbers of headers have 8 bytes.
    pub has_long_headers: bool,
    pub compression: Option<BlockCompression>,
}

/// Compression of the blocks of arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BlockCompression {
    Zlib,
    Lz4,
}

/// Largest ratio by which deflate shrinks anything.
const MAX_RATIO: u64 = 1032;

/// Bytes of a file that are read from front to back.
pub(super) enum VtkBytes<'a> {
    Raw(&'a [u8]),
    Base64(Base64<'a>),
}

/// Text that is decoded as it is read.
pub(super) struct Base64<'a> {
    text: &'a [u8],
    /// Decoded bytes that have not been read, at most 3.
    pending: Vec<u8>,
}

impl<'a> VtkBytes<'a> {
    pub(super) fn base64(text: &'a [u8]) -> Self {
        Self::Base64(Base64 { text, pending: Vec::new() })
    }

    /// Reads exactly `count` bytes.
    fn take(&mut self, count: u64) -> Result<Vec<u8>, String> {
        let left = match self {
            Self::Raw(bytes) => bytes.len(),
            Self::Base64(base64) => base64.text.len(),
        };
        let too_few = || format!("{count} bytes are declared, but only {left} remain");
        let count = usize::try_from(count).ok().filter(|&count| count <= left + 3).ok_or_else(too_few)?;
        match self {
            Self::Raw(bytes) => {
                let (taken, rest) = bytes.split_at_checked(count).ok_or_else(too_few)?;
                *bytes = rest;
                Ok(taken.to_vec())
            }
            Self::Base64(base64) => base64.take(count),
        }
    }
}

impl Base64<'_> {
    fn take(&mut self, count: usize) -> Result<Vec<u8>, String> {
        let mut out = std::mem::take(&mut self.pending);
        while out.len() < count {
            if !self.decode_group(&mut out)? {
                return Err(format!("the base64 data end after {} of {count} bytes", out.len()));
            }
        }
        self.pending = out.split_off(count);
        Ok(out)
    }

    /// Decodes four characters; false at the end.
    fn decode_group(&mut self, out: &mut Vec<u8>) -> Result<bool, String> {
        let (mut word, mut digit_count, mut padding_count) = (0u32, 0, 0);
        while digit_count + padding_count < 4 {
            let Some((&byte, rest)) = self.text.split_first() else {
                return if digit_count == 0 {
                    Ok(false)
                } else {
                    Err("the base64 data are cut off".to_owned())
                };
            };
            self.text = rest;
            let digit = match byte {
                b'A'..=b'Z' => byte - b'A',
                b'a'..=b'z' => byte - b'a' + 26,
                b'0'..=b'9' => byte - b'0' + 52,
                b'+' => 62,
                b'/' => 63,
                b'=' if digit_count >= 2 => {
                    padding_count += 1;
                    continue;
                }
                _ if byte.is_ascii_whitespace() => continue,
                _ => return Err(format!("`{}` is not a digit of base64", byte.escape_ascii())),
            };
            if padding_count > 0 {
                return Err("there is a digit after the padding of base64".to_owned());
            }
            word = word << 6 | u32::from(digit);
            digit_count += 1;
        }
        let bytes = (word << (6 * padding_count)).to_be_bytes();
        out.extend_from_slice(&bytes[1..4 - padding_count]);
        Ok(true)
    }
}

impl Storage {
    /// Reads the bytes of an array.
    pub(super) fn read(self, mut bytes: VtkBytes<'_>) -> Result<Vec<u8>, String> {
        let number_bytes = if self.has_long_headers { 8 } else { 4 };
        let number = |bytes: &mut VtkBytes<'_>| -> Result<u64, String> {
            let taken = bytes.take(number_bytes)?;
            let digits: &mut dyn Iterator<Item = &u8> =
                if self.is_big_endian { &mut taken.iter() } else { &mut taken.iter().rev() };
            Ok(digits.fold(0, |value, &byte| value << 8 | u64::from(byte)))
        };
        let first = number(&mut bytes)?;
        let Some(compression) = self.compression else { return bytes.take(first) };
        if first == 0 {
            return Ok(Vec::new());
        }
        let (block_bytes, last_bytes) = (number(&mut bytes)?, number(&mut bytes)?);
        let mut sizes = Vec::new();
        for _ in 0..first {
            sizes.push(number(&mut bytes)?);
        }
        let mut out = Vec::new();
        for (index, &size) in sizes.iter().enumerate() {
            let is_last = index + 1 == sizes.len();
            let unpacked_bytes = if is_last && last_bytes > 0 { last_bytes } else { block_bytes };
            if unpacked_bytes > size.saturating_mul(MAX_RATIO) {
                return Err(format!("a block of {size} bytes cannot unpack to {unpacked_bytes} bytes"));
            }
            let packed = bytes.take(size)?;
            unpack(compression, &packed, unpacked_bytes, &mut out)?;
        }
        Ok(out)
    }
}

fn unpack(
    compression: BlockCompression,
    packed: &[u8],
    unpacked_bytes: u64,
    out: &mut Vec<u8>,
) -> Result<(), String> {
    let before = out.len();
    match compression {
        BlockCompression::Zlib => {
            let decoder = flate2::read::ZlibDecoder::new(packed);
            let read = decoder.take(unpacked_bytes).read_to_end(out);
            read.map_err(|error| format!("the zlib data are damaged: {error}"))?;
        }
        BlockCompression::Lz4 => {
            // The check of the ratio has limited the size.
            let block = lz4_flex::block::decompress(packed, unpacked_bytes as usize);
            out.extend(block.map_err(|error| format!("the LZ4 data are damaged: {error}"))?);
        }
    }
    let found = (out.len() - before) as u64;
    if found != unpacked_bytes {
        return Err(format!("a block unpacks to {found} bytes instead of {unpacked_bytes}"));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn padding_may_occur_in_the_middle() {
        let plain = Storage::default();
        // The header `5 0 0 0` and the bytes `hello`, in one text and in two.
        for text in ["BQAAAGhlbGxv", "BQAAAA==aGVsbG8=", " BQAA AGhl\nbGxv"] {
            assert_eq!(plain.read(VtkBytes::base64(text.as_bytes())), Ok(b"hello".to_vec()), "{text}");
        }
        for text in ["", "BQAAAGhlbG", "BQAA=AGh", "BQAAAGhl*Gxv", "/////2hlbGxv"] {
            assert!(plain.read(VtkBytes::base64(text.as_bytes())).is_err(), "{text}");
        }
    }

    #[test]
    fn blocks_are_not_larger_than_declared() {
        use std::io::Write as _;
        let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::fast());
        encoder.write_all(&[7; 100]).unwrap();
        let packed = encoder.finish().unwrap();
        let with_header = |numbers: [u32; 3]| {
            let mut bytes: Vec<u8> = numbers.iter().flat_map(|n| n.to_be_bytes()).collect();
            bytes.extend((packed.len() as u32).to_be_bytes());
            bytes.extend(&packed);
            bytes
        };
        let storage =
            Storage { is_big_endian: true, compression: Some(BlockCompression::Zlib), ..Storage::default() };
        let read = |numbers| storage.read(VtkBytes::Raw(&with_header(numbers)));
        assert_eq!(read([1, 100, 0]), Ok(vec![7; 100]));
        assert_eq!(read([1, 4096, 100]), Ok(vec![7; 100]));
        assert!(read([1, 101, 0]).is_err() && read([1, u32::MAX, 0]).is_err());
        assert!(read([u32::MAX, 100, 0]).is_err());
    }
}
