//! Reading and writing the fields of a stream header: little-endian integers, varints and length-prefixed
//! text.

use striata::file::EncodeError;

use crate::format::error::DecodeError;

/// Reads fields one after the other from a header; every length is checked against the bytes that remain.
pub(crate) struct ByteReader<'a> {
    bytes: &'a [u8],
    offset: usize,
}

impl<'a> ByteReader<'a> {
    /// Starts at the first byte.
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, offset: 0 }
    }

    /// Returns an error at the current offset.
    pub(crate) fn malformed(&self, reason: &'static str) -> DecodeError {
        DecodeError::Malformed { offset: self.offset, reason }
    }

    /// Reads the next `count` bytes.
    pub(crate) fn bytes(&mut self, count: usize) -> Result<&'a [u8], DecodeError> {
        let end = self.offset.checked_add(count).filter(|&end| end <= self.bytes.len());
        let end = end.ok_or_else(|| self.malformed("ends too early"))?;
        let bytes = &self.bytes[self.offset..end];
        self.offset = end;
        Ok(bytes)
    }

    pub(crate) fn u8(&mut self) -> Result<u8, DecodeError> {
        Ok(self.bytes(1)?[0])
    }

    pub(crate) fn u32(&mut self) -> Result<u32, DecodeError> {
        let bytes = self.bytes(4)?;
        Ok(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
    }

    /// Reads an unsigned LEB128 integer: 7 bits per byte, low bits first.
    pub(crate) fn varint(&mut self) -> Result<u32, DecodeError> {
        let mut rest = &self.bytes[self.offset..];
        let value = read_varint(&mut rest).ok_or_else(|| self.malformed("an integer does not end"))?;
        self.offset = self.bytes.len() - rest.len();
        Ok(value)
    }

    /// Reads a count of items and checks that the remaining bytes suffice, at `item_bytes` or more per item.
    /// The caller can therefore allocate that many.
    pub(crate) fn short_count(&mut self, item_bytes: usize) -> Result<usize, DecodeError> {
        let count = self.varint()? as usize;
        if count > (self.bytes.len() - self.offset) / item_bytes {
            return Err(self.malformed("more items than bytes"));
        }
        Ok(count)
    }

    pub(crate) fn f64(&mut self) -> Result<f64, DecodeError> {
        let (low, high) = (self.u32()?, self.u32()?);
        Ok(f64::from_bits(u64::from(low) | u64::from(high) << 32))
    }

    pub(crate) fn f32(&mut self) -> Result<f32, DecodeError> {
        Ok(f32::from_bits(self.u32()?))
    }

    /// Reads a block of bytes that is preceded by its length.
    pub(crate) fn block(&mut self) -> Result<&'a [u8], DecodeError> {
        let length = self.varint()? as usize;
        self.bytes(length)
    }

    /// Reads a UTF-8 string that is preceded by its length.
    pub(crate) fn text(&mut self) -> Result<String, DecodeError> {
        let bytes = self.block()?;
        let text = std::str::from_utf8(bytes).map_err(|_| self.malformed("the text is not valid UTF-8"))?;
        Ok(text.to_owned())
    }

    /// Checks that every byte has been read.
    pub(crate) fn end(self) -> Result<(), DecodeError> {
        if self.offset == self.bytes.len() { Ok(()) } else { Err(self.malformed("bytes are left over")) }
    }
}

/// Reads a varint from the front of `bytes`, or returns `None` if it ends too early or exceeds 32 bits.
fn read_varint(bytes: &mut &[u8]) -> Option<u32> {
    let mut value = 0;
    for shift in (0..32).step_by(7) {
        let (&byte, rest) = bytes.split_first()?;
        *bytes = rest;
        let part = u32::from(byte & 0x7f);
        value |= part << shift;
        if byte < 0x80 {
            return (value >> shift == part).then_some(value);
        }
    }
    None
}

/// Appends an unsigned LEB128 integer: 7 bits per byte, low bits first.
pub(crate) fn write_varint(mut value: u32, out: &mut Vec<u8>) {
    while value >= 0x80 {
        out.push(value as u8 | 0x80);
        value >>= 7;
    }
    out.push(value as u8);
}

/// Appends a block of bytes, preceded by its length as a varint.
pub(crate) fn put_block(what: &'static str, bytes: &[u8], out: &mut Vec<u8>) -> Result<(), EncodeError> {
    let length = bytes.len();
    write_varint(u32::try_from(length).map_err(|_| EncodeError::TooLong { what, length })?, out);
    out.extend_from_slice(bytes);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn varints_round_trip_and_longer_ones_are_rejected() {
        for value in [0, 1, 127, 128, 16383, 16384, 1 << 28, u32::MAX] {
            let mut bytes = Vec::new();
            write_varint(value, &mut bytes);
            assert_eq!(read_varint(&mut &bytes[..]), Some(value));
            assert_eq!(read_varint(&mut &bytes[..bytes.len() - 1]), None);
        }
        for too_large in [[0xff, 0xff, 0xff, 0xff, 0x1f], [0xff; 5]] {
            assert_eq!(read_varint(&mut &too_large[..]), None);
        }
    }
}
