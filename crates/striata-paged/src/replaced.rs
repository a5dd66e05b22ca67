//! Triangles that finer pages have replaced.
//!
//! A page lists the triangles of the surface at its own full detail. When a finer page is refined, it replaces some
//! of these triangles, and names them by their corners.

use std::collections::HashMap;

use crate::hash::IndexHash;

/// Corners in the numbering of all loaded pages, beginning with the smallest, and the [tag](crate::Page::tag_of).
type Key = [u32; 4];

/// Triangles of one page that finer pages have replaced, with their number.
#[derive(Debug, Default)]
pub(crate) struct Replaced(HashMap<Key, u32, IndexHash>);

impl Replaced {
    /// Adds a triangle.
    pub(crate) fn add(&mut self, corners: [u32; 3], tag: u32) {
        *self.0.entry(key_of(corners, tag)).or_default() += 1;
    }

    /// Adds the triangles that another finer page has replaced.
    pub(crate) fn add_all(&mut self, triangles: &[([u32; 3], u32)]) {
        self.0.reserve(triangles.len());
        triangles.iter().for_each(|&(corners, tag)| self.add(corners, tag));
    }

    /// Whether no triangle has been replaced.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether a triangle has been replaced. Of equal triangles, as many are as have been added.
    pub(crate) fn take(&mut self, corners: [u32; 3], tag: u32) -> bool {
        match self.0.get_mut(&key_of(corners, tag)) {
            Some(count) if *count > 0 => {
                *count -= 1;
                true
            }
            _ => false,
        }
    }
}

/// Corners beginning with the smallest, and the tag.
fn key_of([a, b, c]: [u32; 3], tag: u32) -> Key {
    if a <= b && a <= c {
        [a, b, c, tag]
    } else if b <= a && b <= c {
        [b, c, a, tag]
    } else {
        [c, a, b, tag]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_triangles_are_counted() {
        let mut replaced = Replaced::default();
        replaced.add_all(&[([3, 1, 2], 0), ([1, 2, 3], 0), ([1, 3, 2], 0)]);
        assert!(!replaced.take([1, 2, 3], 1));
        assert!(replaced.take([2, 3, 1], 0) && replaced.take([3, 1, 2], 0));
        assert!(!replaced.take([1, 2, 3], 0));
        assert!(replaced.take([2, 1, 3], 0));
    }
}
