//! A column of vertex indices, packed in as many bits as the largest possible index needs. Zero bytes follow
//! the last one, so that any index can be read with one 64-bit load.

use std::borrow::Cow;

use super::ModelError;
use super::bits::{Bits, PADDING, field, width_of};

/// Vertex indices of equal width, lowest bit first; may be borrowed from a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct PackedVertices<'a> {
    bytes: Cow<'a, [u8]>,
    /// Bits of an index, 1 to 32.
    width: u32,
    len: usize,
}

/// Number of bits for indices below `vertex_count`.
fn width_for(vertex_count: usize) -> u32 {
    width_of(vertex_count as u64).clamp(1, u32::BITS)
}

impl PackedVertices<'static> {
    /// Packs indices below `vertex_count`.
    pub(crate) fn pack(vertices: &[u32], vertex_count: usize) -> Self {
        let width = width_for(vertex_count);
        let mut bits = Bits::default();
        for &vertex in vertices {
            debug_assert!((vertex as usize) < vertex_count, "vertex {vertex} of {vertex_count}");
            bits.push(u64::from(vertex), width);
        }
        Self { bytes: bits.into_padded().into(), width, len: vertices.len() }
    }
}

impl<'a> PackedVertices<'a> {
    /// Wraps the bytes of `len` indices below `vertex_count`. The indices themselves are not checked.
    ///
    /// # Errors
    /// [`ModelError::Length`] with this name if there are too many or too few bytes.
    pub(crate) fn from_bytes(
        bytes: Cow<'a, [u8]>,
        len: usize,
        vertex_count: usize,
        what: &'static str,
    ) -> Result<Self, ModelError> {
        let (found, expected) = (bytes.len(), Self::byte_count(len, vertex_count));
        if found != expected {
            return Err(ModelError::Length { what, found, expected });
        }
        Ok(Self { bytes, width: width_for(vertex_count), len })
    }

    /// Number of bytes of `len` indices below `vertex_count`, with padding.
    pub(crate) fn byte_count(len: usize, vertex_count: usize) -> usize {
        len.saturating_mul(width_for(vertex_count) as usize).div_ceil(8) + PADDING
    }

    /// Returns a copy that owns its bytes.
    pub(crate) fn into_owned(self) -> PackedVertices<'static> {
        PackedVertices { bytes: self.bytes.into_owned().into(), ..self }
    }

    /// The bytes as they are stored, padding included.
    pub(crate) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Number of indices.
    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// Returns one index.
    ///
    /// # Panics
    /// If there is no such index, except in its padding.
    #[inline]
    pub(crate) fn get(&self, i: usize) -> u32 {
        let found = field(&self.bytes, i * self.width as usize, self.width);
        found.expect("indices are padded") as u32
    }

    /// Returns the indices of a range.
    ///
    /// # Panics
    /// If the range exceeds the column.
    #[inline]
    pub(crate) fn range(&self, range: std::ops::Range<usize>) -> impl Iterator<Item = u32> + '_ {
        assert!(range.end <= self.len, "indices {range:?} of {}", self.len);
        range.map(|i| self.get(i))
    }

    /// Returns all indices.
    pub(crate) fn to_vec(&self) -> Vec<u32> {
        self.range(0..self.len).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_read_back_in_any_width() {
        for vertex_count in [1, 2, 3, 255, 256, 257, 40_000, 1 << 24, 1 << 30, (1 << 32) - 1] {
            let last = vertex_count as u32 - 1;
            let vertices: Vec<u32> = (0..50).map(|i| last / (i % 7 + 1)).collect();
            let packed = PackedVertices::pack(&vertices, vertex_count);
            assert_eq!(packed.to_vec(), vertices);
            let bytes = packed.bytes().to_vec();
            let again = PackedVertices::from_bytes((&bytes[..]).into(), 50, vertex_count, "indices").unwrap();
            assert_eq!(again, packed);
            let wrong = PackedVertices::from_bytes((&bytes[1..]).into(), 50, vertex_count, "indices");
            let (found, expected) = (bytes.len() - 1, bytes.len());
            assert_eq!(wrong, Err(ModelError::Length { what: "indices", found, expected }));
        }
        assert_eq!(PackedVertices::pack(&[], 0).to_vec(), [0; 0]);
    }
}
