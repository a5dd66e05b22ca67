//! Conversion of strips to one index buffer, with primitive restart or stitched by degenerate triangles.

use std::ops::Range;

use super::{StripSet, strip_triangles};

/// The primitive restart index, which ends a strip.
pub const RESTART: u32 = u32::MAX;

/// Strips in a single index buffer, with the range to draw for each group.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StripIndices {
    /// The indices.
    pub indices: Vec<u32>,
    /// Range of `indices` to draw for each group.
    pub group_ranges: Vec<Range<u32>>,
}

impl StripIndices {
    /// Converts the indices to 16 bits, with [`RESTART`] as `0xFFFF`; `None` if a vertex index does not fit.
    pub fn to_u16(&self) -> Option<Vec<u16>> {
        let narrow = |&index: &u32| match index {
            RESTART => Some(u16::MAX),
            // The restart value cannot be used for a vertex.
            _ => u16::try_from(index).ok().filter(|&index| index != u16::MAX),
        };
        self.indices.iter().map(narrow).collect()
    }
}

impl StripSet {
    /// Joins the strips of each group with [`RESTART`] in a single index buffer.
    pub fn to_restart_indices(&self) -> StripIndices {
        self.joined(|indices, _| indices.push(RESTART))
    }

    /// Joins the strips of each group with repeated indices (degenerate triangles) in a single index buffer.
    ///
    /// The buffer needs no primitive restart, as formats such as glTF 2.0 require; all triangles keep their
    /// winding.
    pub fn to_stitched_indices(&self) -> StripIndices {
        self.joined(|indices, next| {
            if let Some(&last) = indices.last() {
                stitch(last, indices.len() % 2 == 1, next, indices);
            }
        })
    }

    /// Joins the strips of each group; `join` appends what separates the buffer so far from the next strip,
    /// given its first index.
    fn joined(&self, join: impl Fn(&mut Vec<u32>, u32)) -> StripIndices {
        let mut out = StripIndices::default();
        // Parity counts from the start of a draw call, hence group by group.
        let mut group_indices = Vec::new();
        for group in 0..self.group_count() {
            group_indices.clear();
            for strip in self.group_strips(group).map(|s| self.strip(s)).filter(|s| s.len() >= 3) {
                if !group_indices.is_empty() {
                    join(&mut group_indices, strip[0]);
                }
                group_indices.extend_from_slice(strip);
            }
            let first = out.indices.len() as u32;
            out.indices.extend_from_slice(&group_indices);
            out.group_ranges.push(first..out.indices.len() as u32);
        }
        out
    }
}

/// Appends the indices that join two strips by degenerate triangles.
///
/// The first strip ends with `last`, and the second begins with `next`. `is_odd` is whether the number of
/// indices so far is odd; the second strip has to begin at an even position.
pub fn stitch(last: u32, is_odd: bool, next: u32, out: &mut Vec<u32>) {
    if last == next {
        out.extend(is_odd.then_some(last));
    } else {
        out.extend([last, last, next].iter().skip(usize::from(!is_odd)));
    }
}

/// Appends the triangles that a GPU with primitive restart draws, without degenerate ones.
pub fn restart_triangles_into(indices: &[u32], out: &mut Vec<[u32; 3]>) {
    for strip in indices.split(|&index| index == RESTART) {
        out.extend(strip_triangles(strip));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::canonical_triangles;

    #[test]
    fn indices_convert_to_16_bits_if_they_fit() {
        let indices = |indices: &[u32]| StripIndices { indices: indices.to_vec(), group_ranges: Vec::new() };
        assert_eq!(indices(&[0, 1, 65_534, RESTART]).to_u16(), Some(vec![0, 1, 65_534, 65_535]));
        assert_eq!(indices(&[0, 1, 65_535]).to_u16(), None);
        assert_eq!(indices(&[0, 1, 65_536]).to_u16(), None);
    }

    #[test]
    fn restart_and_stitched_buffers_draw_the_same_triangles() {
        let mut set = StripSet::new();
        for strip in [&[0, 1, 2][..], &[2, 1, 3, 4], &[7, 5, 6, 8, 9], &[9, 8, 10], &[]] {
            set.push(strip);
        }
        set.end_group();
        set.push(&[11, 12, 13, 14]);
        set.end_group();
        let mut expected = Vec::new();
        set.triangles_into(&mut expected);
        let restart = set.to_restart_indices();
        let stitched = set.to_stitched_indices();
        for joined in [&restart, &stitched] {
            let mut found = Vec::new();
            for range in &joined.group_ranges {
                let indices = &joined.indices[range.start as usize..range.end as usize];
                restart_triangles_into(indices, &mut found);
            }
            assert_eq!(canonical_triangles(&found), canonical_triangles(&expected));
        }
        assert_eq!(restart.indices.len(), 15 + 3 + 4);
        assert!(!stitched.indices.contains(&RESTART));
    }
}
