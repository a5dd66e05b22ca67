//! Ranges of the elements of an accessor.

use std::borrow::Cow;
use std::ops::Range;

use crate::gltf::accessor::Accessor;

impl Accessor<'_> {
    /// Returns the bytes of some elements, which must exist, without gaps.
    pub(crate) fn range(&self, range: Range<usize>) -> Cow<'_, [u8]> {
        let (size, start) = (self.element_bytes(), range.start);
        match (self.bytes, &self.sparse) {
            (Some(bytes), None) if self.stride == size => {
                Cow::Borrowed(&bytes[start * size..][..range.len() * size])
            }
            _ => {
                let mut out = self.copied(range.clone());
                self.replace(&mut out, |element| {
                    element.checked_sub(start).filter(|_| range.contains(&element))
                });
                Cow::Owned(out)
            }
        }
    }

    /// Returns the number of elements that are replaced by others; [`range`](Self::range) and
    /// [`gather`](Self::gather) look at all of them.
    pub(super) fn replaced_count(&self) -> usize {
        self.sparse.as_ref().map_or(0, |sparse| sparse.count)
    }
}
