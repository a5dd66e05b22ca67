//! Reading and writing of small sections that mix numbers and texts.

use super::error::{DecodeError, EncodeError};
use super::section_kind::SectionKind;

/// Reads numbers and texts from a section; checks every length against the bytes that remain.
pub(super) struct SectionReader<'a> {
    kind: SectionKind,
    bytes: &'a [u8],
    at: usize,
}

impl<'a> SectionReader<'a> {
    pub(super) fn new(kind: SectionKind, bytes: &'a [u8]) -> Self {
        Self { kind, bytes, at: 0 }
    }

    pub(super) fn malformed(&self, reason: &'static str) -> DecodeError {
        DecodeError::Malformed { kind: self.kind, offset: self.at, reason }
    }

    pub(super) fn bytes(&mut self, count: usize) -> Result<&'a [u8], DecodeError> {
        let end = self.at.checked_add(count).filter(|&end| end <= self.bytes.len());
        let end = end.ok_or_else(|| self.malformed("ends too early"))?;
        let bytes = &self.bytes[self.at..end];
        self.at = end;
        Ok(bytes)
    }

    pub(super) fn u8(&mut self) -> Result<u8, DecodeError> {
        Ok(self.bytes(1)?[0])
    }

    pub(super) fn u32(&mut self) -> Result<u32, DecodeError> {
        let bytes = self.bytes(4)?;
        Ok(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
    }

    pub(super) fn f32(&mut self) -> Result<f32, DecodeError> {
        Ok(f32::from_bits(self.u32()?))
    }

    /// Reads a count of items of at least `item_bytes` each, so that it is safe to allocate memory for them.
    pub(super) fn count(&mut self, item_bytes: usize) -> Result<usize, DecodeError> {
        let count = self.u32()? as usize;
        if count > (self.bytes.len() - self.at) / item_bytes {
            return Err(self.malformed("more items than bytes"));
        }
        Ok(count)
    }

    pub(super) fn block(&mut self) -> Result<&'a [u8], DecodeError> {
        let length = self.u32()? as usize;
        self.bytes(length)
    }

    pub(super) fn text(&mut self) -> Result<String, DecodeError> {
        let bytes = self.block()?;
        let text = std::str::from_utf8(bytes).map_err(|_| self.malformed("a text is not valid UTF-8"))?;
        Ok(text.to_owned())
    }

    pub(super) fn texts(&mut self) -> Result<Vec<String>, DecodeError> {
        let count = self.count(4)?;
        (0..count).map(|_| self.text()).collect()
    }

    pub(super) fn is_at_end(&self) -> bool {
        self.at == self.bytes.len()
    }

    pub(super) fn end(self) -> Result<(), DecodeError> {
        if self.is_at_end() { Ok(()) } else { Err(self.malformed("bytes are left over")) }
    }
}

pub(super) fn put_u32(value: u32, out: &mut Vec<u8>) {
    out.extend(value.to_le_bytes());
}

/// Appends a block of bytes, preceded by its length.
pub(super) fn put_block(what: &'static str, bytes: &[u8], out: &mut Vec<u8>) -> Result<(), EncodeError> {
    let length = bytes.len();
    put_u32(u32::try_from(length).map_err(|_| EncodeError::TooLong { what, length })?, out);
    out.extend_from_slice(bytes);
    Ok(())
}

pub(super) fn put_texts(what: &'static str, texts: &[String], out: &mut Vec<u8>) -> Result<(), EncodeError> {
    put_u32(texts.len() as u32, out);
    texts.iter().try_for_each(|text| put_block(what, text.as_bytes(), out))
}
