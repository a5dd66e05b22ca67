//! Strips as models store them: a length in one byte each, and their indices packed.

use std::borrow::Cow;
use std::ops::Range;

use super::ModelError;
use super::packed_vertices::PackedVertices;
use crate::strip::{StripSet, check_offsets};

/// Longest strip of a model. Longer strips are cut when a model is built, so that an edit moves few indices.
pub const MAX_STRIP_INDICES: usize = 128;

/// A set of strips; may be borrowed from a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct StoredStrips<'a> {
    /// First strip of each group, followed by the strip count.
    pub group_offsets: Cow<'a, [u32]>,
    /// Number of indices of each strip.
    pub lengths: Cow<'a, [u8]>,
    /// Indices of all strips, one after the other. Each place here is a *slot*.
    pub indices: PackedVertices<'a>,
    /// First slot of each strip, followed by the slot count; derived from the lengths.
    firsts: Vec<u32>,
}

impl StoredStrips<'static> {
    /// Packs strips of at most [`MAX_STRIP_INDICES`] indices below `vertex_count`.
    pub(crate) fn pack(strips: &StripSet, vertex_count: usize) -> Self {
        debug_assert!(strips.strips().all(|strip| strip.len() <= MAX_STRIP_INDICES), "a strip is too long");
        Self {
            group_offsets: strips.group_offsets().to_vec().into(),
            lengths: strips.strips().map(|strip| strip.len() as u8).collect(),
            indices: PackedVertices::pack(strips.indices(), vertex_count),
            firsts: strips.offsets().to_vec(),
        }
    }
}

impl<'a> StoredStrips<'a> {
    /// Wraps stored arrays; `bytes` are the packed indices.
    ///
    /// # Errors
    /// [`ModelError`] if the arrays do not match each other, or a strip is too long or uses a vertex that
    /// does not exist.
    pub(crate) fn from_parts(
        group_offsets: Cow<'a, [u32]>,
        lengths: Cow<'a, [u8]>,
        bytes: Cow<'a, [u8]>,
        vertex_count: usize,
    ) -> Result<Self, ModelError> {
        check_offsets("group", &group_offsets, lengths.len())?;
        if let Some(&found) = lengths.iter().find(|&&length| usize::from(length) > MAX_STRIP_INDICES) {
            let (found, expected) = (usize::from(found), MAX_STRIP_INDICES);
            return Err(ModelError::Length { what: "indices of a strip", found, expected });
        }
        let slot_count: u64 = lengths.iter().map(|&length| u64::from(length)).sum();
        if slot_count > u64::from(u32::MAX) {
            let (found, limit) = (slot_count, u64::from(u32::MAX));
            return Err(ModelError::TooMany { what: "indices of strips", found, limit });
        }
        let indices =
            PackedVertices::from_bytes(bytes, slot_count as usize, vertex_count, "bytes of strips")?;
        let firsts = std::iter::once(0).chain(lengths.iter().scan(0, |end, &length| {
            *end += u32::from(length);
            Some(*end)
        }));
        let strips = Self { firsts: firsts.collect(), group_offsets, lengths, indices };
        strips.check_vertices(vertex_count)?;
        Ok(strips)
    }

    fn check_vertices(&self, vertex_count: usize) -> Result<(), ModelError> {
        let is_wrong = |&vertex: &u32| vertex as usize >= vertex_count;
        for strip in 0..self.strip_count() {
            if let Some(vertex) = self.indices.range(self.slots(strip)).find(is_wrong) {
                return Err(ModelError::Vertex { strip, vertex, vertex_count });
            }
        }
        Ok(())
    }

    /// Returns a copy that owns its arrays.
    pub(crate) fn into_owned(self) -> StoredStrips<'static> {
        StoredStrips {
            group_offsets: self.group_offsets.into_owned().into(),
            lengths: self.lengths.into_owned().into(),
            indices: self.indices.into_owned(),
            firsts: self.firsts,
        }
    }

    /// Number of strips.
    #[inline]
    pub(crate) fn strip_count(&self) -> usize {
        self.lengths.len()
    }

    /// Number of slots of all strips.
    #[inline]
    pub(crate) fn slot_count(&self) -> usize {
        self.indices.len()
    }

    /// First slot of each strip, followed by the slot count.
    #[inline]
    pub(crate) fn firsts(&self) -> &[u32] {
        &self.firsts
    }

    /// The slots of a strip.
    ///
    /// # Panics
    /// If the strip does not exist.
    #[inline]
    pub(crate) fn slots(&self, strip: usize) -> Range<usize> {
        self.firsts[strip] as usize..self.firsts[strip + 1] as usize
    }

    /// The strips of a group.
    ///
    /// # Panics
    /// If the group does not exist.
    #[inline]
    pub(crate) fn group_strips(&self, group: usize) -> Range<usize> {
        self.group_offsets[group] as usize..self.group_offsets[group + 1] as usize
    }

    /// Copies all strips into a set.
    pub(crate) fn to_strip_set(&self) -> StripSet {
        let offsets = self.firsts.clone();
        let parts = StripSet::from_parts(self.indices.to_vec(), offsets, self.group_offsets.to_vec());
        parts.expect("the offsets were checked or come from a set")
    }

    /// Size in bytes: indices, and everything else.
    pub(crate) fn bytes(&self) -> [usize; 2] {
        let offsets =
            size_of_val(&self.group_offsets[..]) + self.lengths.len() + size_of_val(&self.firsts[..]);
        [self.indices.bytes().len(), offsets]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strips() -> StripSet {
        let mut strips = StripSet::new();
        strips.push(&[0, 1, 2, 3]);
        strips.push(&[]);
        strips.end_group();
        strips.end_group();
        strips.push(&[4, 2, 1]);
        strips.end_group();
        strips
    }

    fn again(groups: &[u32], lengths: &[u8], bytes: &[u8]) -> Result<StripSet, ModelError> {
        let stored = StoredStrips::from_parts(groups.into(), lengths.into(), bytes.into(), 5)?;
        Ok(stored.to_strip_set())
    }

    #[test]
    fn strips_read_back() {
        let stored = StoredStrips::pack(&strips(), 5);
        assert_eq!((stored.slots(2), stored.group_strips(2)), (4..7, 2..3));
        let bytes = stored.indices.bytes();
        assert_eq!(again(&stored.group_offsets, &stored.lengths, bytes), Ok(strips()));
    }

    #[test]
    fn inconsistent_arrays_are_rejected() {
        let stored = StoredStrips::pack(&strips(), 5);
        let (groups, lengths, bytes) =
            (&stored.group_offsets[..], &stored.lengths[..], stored.indices.bytes());
        assert!(matches!(again(&groups[..3], lengths, bytes), Err(ModelError::Offsets(_))));
        let too_long = again(groups, &[4, 0, 129], bytes);
        assert_eq!(
            too_long,
            Err(ModelError::Length { what: "indices of a strip", found: 129, expected: 128 })
        );
        assert!(matches!(again(groups, &[4, 0, 9], bytes), Err(ModelError::Length { .. })));
        // The same bytes with indices of three bits: 5 and 6 are possible, but do not exist.
        let mut bad = bytes.to_vec();
        bad[1] = 0xff;
        assert!(matches!(again(groups, lengths, &bad), Err(ModelError::Vertex { .. })));
    }
}
