//! Some elements of an accessor, of any type and at any distance from each other.

use super::accessor::Accessor;

impl Accessor<'_> {
    /// Returns the bytes of the elements with these increasing numbers, which must exist, without gaps.
    pub(crate) fn gather(&self, numbers: &[u32]) -> Vec<u8> {
        let mut out = self.copied(numbers.iter().map(|&number| number as usize));
        let (first, last) = (numbers.first().copied().unwrap_or(0), numbers.last().copied().unwrap_or(0));
        self.replace(&mut out, |element| {
            let number = u32::try_from(element).ok().filter(|number| (first..=last).contains(number))?;
            numbers.binary_search(&number).ok()
        });
        out
    }

    /// Creates an accessor of the same type over elements that [`gather`](Self::gather) has
    /// returned.
    pub(crate) fn with_elements<'b>(&self, bytes: &'b [u8]) -> Accessor<'b> {
        let (stride, mut shape) = (self.element_bytes(), self.shape.clone());
        shape.count = bytes.len() / stride;
        Accessor { shape, bytes: Some(bytes), stride, sparse: None }
    }

    /// Copies elements without their replacements.
    pub(super) fn copied(&self, numbers: impl ExactSizeIterator<Item = usize>) -> Vec<u8> {
        let size = self.element_bytes();
        let Some(bytes) = self.bytes else { return vec![0; numbers.len() * size] };
        let mut out = Vec::with_capacity(numbers.len() * size);
        for number in numbers {
            out.extend_from_slice(&bytes[number * self.stride..][..size]);
        }
        out
    }

    /// Replaces elements of a copy; `slot` is the place of an element in it.
    pub(super) fn replace(&self, out: &mut [u8], slot: impl Fn(usize) -> Option<usize>) {
        let (size, Some(sparse)) = (self.element_bytes(), &self.sparse) else { return };
        for (element, value) in sparse.indices().zip(sparse.values.chunks_exact(size)) {
            if let Some(slot) = slot(element) {
                out[slot * size..][..size].copy_from_slice(value);
            }
        }
    }
}
