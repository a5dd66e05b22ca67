//! Reading and writing the head of a stream: numbers and texts one after the other.

use striata::file::EncodeError;

use crate::format::error::DecodeError;

/// Takes numbers and texts off a head; every length is checked against what is left.
pub(crate) struct ByteReader<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> ByteReader<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    pub(crate) fn malformed(&self, reason: &'static str) -> DecodeError {
        DecodeError::Malformed { offset: self.at, reason }
    }

    pub(crate) fn bytes(&mut self, count: usize) -> Result<&'a [u8], DecodeError> {
        let end = self.at.checked_add(count).filter(|&end| end <= self.bytes.len());
        let end = end.ok_or_else(|| self.malformed("ends too early"))?;
        let taken = &self.bytes[self.at..end];
        self.at = end;
        Ok(taken)
    }

    pub(crate) fn u8(&mut self) -> Result<u8, DecodeError> {
        Ok(self.bytes(1)?[0])
    }

    pub(crate) fn u32(&mut self) -> Result<u32, DecodeError> {
        let bytes = self.bytes(4)?;
        Ok(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
    }

    /// A number in bytes of 7 bits, low ones first.
    pub(crate) fn varint(&mut self) -> Result<u32, DecodeError> {
        let mut left = &self.bytes[self.at..];
        let value = read_varint(&mut left).ok_or_else(|| self.malformed("a number does not end"))?;
        self.at = self.bytes.len() - left.len();
        Ok(value)
    }

    /// A count of items that take at least `item_bytes` each, so that it can be allocated.
    pub(crate) fn short_count(&mut self, item_bytes: usize) -> Result<usize, DecodeError> {
        let count = self.varint()? as usize;
        if count > (self.bytes.len() - self.at) / item_bytes {
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

    pub(crate) fn block(&mut self) -> Result<&'a [u8], DecodeError> {
        let length = self.u32()? as usize;
        self.bytes(length)
    }

    pub(crate) fn text(&mut self) -> Result<String, DecodeError> {
        let bytes = self.block()?;
        let text = std::str::from_utf8(bytes).map_err(|_| self.malformed("the text is no UTF-8"))?;
        Ok(text.to_owned())
    }

    pub(crate) fn end(self) -> Result<(), DecodeError> {
        if self.at == self.bytes.len() { Ok(()) } else { Err(self.malformed("bytes are left over")) }
    }
}

/// Takes a number off the front; `None` if it ends too early or does not fit.
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

/// A number in bytes of 7 bits, low ones first.
pub(crate) fn write_varint(mut value: u32, out: &mut Vec<u8>) {
    while value >= 0x80 {
        out.push(value as u8 | 0x80);
        value >>= 7;
    }
    out.push(value as u8);
}

pub(crate) fn put_u32(value: u32, out: &mut Vec<u8>) {
    out.extend(value.to_le_bytes());
}

/// A block of bytes behind its length.
pub(crate) fn put_block(what: &'static str, bytes: &[u8], out: &mut Vec<u8>) -> Result<(), EncodeError> {
    let length = bytes.len();
    put_u32(u32::try_from(length).map_err(|_| EncodeError::TooLong { what, length })?, out);
    out.extend_from_slice(bytes);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_written_and_no_others() {
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
