//! A set of strips, stored in three flat arrays.

use std::ops::Range;

use crate::mesh::IndexedMesh;

/// Why the arrays of a [`StripSet`] are inconsistent.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum StripSetError {
    /// The offsets are not an ascending sequence that starts at 0 and ends at the length of the array that
    /// they divide.
    #[error("{what} offset {index} is {found}, after {previous}: offsets must rise from 0 to {limit}")]
    Offset {
        /// Kind of the offsets: `strip` or `group`.
        what: &'static str,
        /// Index of the offset.
        index: usize,
        /// The offset found.
        found: u32,
        /// The previous offset.
        previous: u32,
        /// The value that the last offset must have.
        limit: usize,
    },
}

/// Triangle strips, sorted by group: a flat list of indices, divided into strips, which are divided into
/// groups.
///
/// Group `g` of the set contains the triangles of group `g` of its mesh (a single group if the mesh has
/// none); no strip crosses from one group into another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StripSet {
    indices: Vec<u32>,
    offsets: Vec<u32>,
    group_offsets: Vec<u32>,
}

impl Default for StripSet {
    fn default() -> Self {
        Self::new()
    }
}

impl StripSet {
    /// Creates a set without strips and groups.
    pub fn new() -> Self {
        Self { indices: Vec::new(), offsets: vec![0], group_offsets: vec![0] }
    }

    /// Creates a set from its arrays: all indices, the first index of each strip followed by the number of
    /// indices, and the first strip of each group followed by the number of strips.
    ///
    /// # Errors
    /// [`StripSetError`] if the offsets do not increase from 0 to the end.
    pub fn from_parts(
        indices: Vec<u32>,
        offsets: Vec<u32>,
        group_offsets: Vec<u32>,
    ) -> Result<Self, StripSetError> {
        check_offsets("strip", &offsets, indices.len())?;
        check_offsets("group", &group_offsets, offsets.len() - 1)?;
        Ok(Self { indices, offsets, group_offsets })
    }

    /// Appends a strip to the current group.
    pub fn push(&mut self, strip: &[u32]) {
        self.indices.extend_from_slice(strip);
        self.offsets.push(self.indices.len() as u32);
    }

    /// Ends the current group, which consists of all strips pushed since the previous group ended; it may
    /// be empty.
    pub fn end_group(&mut self) {
        self.group_offsets.push(self.strip_count() as u32);
    }

    /// Number of strips.
    pub fn strip_count(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Number of groups.
    pub fn group_count(&self) -> usize {
        self.group_offsets.len() - 1
    }

    /// Indices of a strip.
    ///
    /// # Panics
    /// If the strip does not exist.
    pub fn strip(&self, strip: usize) -> &[u32] {
        &self.indices[self.offsets[strip] as usize..self.offsets[strip + 1] as usize]
    }

    /// All strips in order.
    pub fn strips(&self) -> impl Iterator<Item = &[u32]> {
        self.offsets.windows(2).map(|w| &self.indices[w[0] as usize..w[1] as usize])
    }

    /// Range of the strips in a group.
    ///
    /// # Panics
    /// If the group does not exist.
    pub fn group_strips(&self, group: usize) -> Range<usize> {
        self.group_offsets[group] as usize..self.group_offsets[group + 1] as usize
    }

    /// Indices of all strips, one after another, without restarts.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// First index of each strip, followed by the number of indices.
    pub fn offsets(&self) -> &[u32] {
        &self.offsets
    }

    /// First strip of each group, followed by the number of strips.
    pub fn group_offsets(&self) -> &[u32] {
        &self.group_offsets
    }

    /// Appends the triangles of all strips, without degenerate ones.
    pub fn triangles_into(&self, out: &mut Vec<[u32; 3]>) {
        for strip in self.strips() {
            out.extend(strip_triangles(strip));
        }
    }

    /// Returns the strips of a mesh over the vertices that its triangles use, as
    /// [`without_unused_vertices`](IndexedMesh::without_unused_vertices) numbers them; [`None`] if a strip passes through
    /// others.
    pub fn on_used_vertices(&self, mesh: &IndexedMesh) -> Option<Self> {
        let mut is_used = vec![false; mesh.vertex_count()];
        mesh.triangles.iter().flatten().for_each(|&v| is_used[v as usize] = true);
        // The remaining vertices keep their order.
        let numbered = is_used.into_iter().scan(0, |next, is_used| {
            let index = is_used.then_some(*next);
            *next += u32::from(is_used);
            Some(index)
        });
        let numbered: Vec<Option<u32>> = numbered.collect();
        let indices = self.indices.iter().map(|&v| numbered[v as usize]).collect::<Option<_>>()?;
        Some(Self { indices, ..self.clone() })
    }

    /// Cuts every strip into pieces of at most `max_indices` indices.
    ///
    /// Each piece starts with the last two indices of the piece before it, at an even position, so that
    /// every triangle keeps its winding. Degenerate triangles at a cut are not repeated.
    ///
    /// # Panics
    /// If `max_indices` is less than 4, since a piece could then not advance.
    pub fn cut(&self, max_indices: usize) -> Self {
        assert!(max_indices >= 4, "a piece of {max_indices} indices cannot advance");
        // An even number of triangles per piece keeps the parity of the next piece.
        let advance = (max_indices - 2) & !1;
        let mut out = Self::new();
        for group in 0..self.group_count() {
            for strip in self.group_strips(group) {
                let strip = self.strip(strip);
                let mut first = 0;
                while strip.len() - first > max_indices {
                    out.push(&strip[first..first + advance + 2]);
                    first += advance;
                }
                out.push(&strip[first..]);
            }
            out.end_group();
        }
        out
    }
}

/// Checks that offsets start at 0, never decrease and end at `limit`.
pub(crate) fn check_offsets(what: &'static str, offsets: &[u32], limit: usize) -> Result<(), StripSetError> {
    let error = |index, found, previous| StripSetError::Offset { what, index, found, previous, limit };
    let mut previous = 0;
    for (index, &found) in offsets.iter().enumerate() {
        if found < previous || found as usize > limit || (index == 0 && found != 0) {
            return Err(error(index, found, previous));
        }
        previous = found;
    }
    if offsets.is_empty() || previous as usize != limit {
        return Err(error(offsets.len().saturating_sub(1), previous, previous));
    }
    Ok(())
}

/// The triangles of a strip with their winding, without degenerate ones.
pub fn strip_triangles(strip: &[u32]) -> impl Iterator<Item = [u32; 3]> {
    strip.windows(3).enumerate().filter_map(|(i, w)| {
        let is_degenerate = w[0] == w[1] || w[1] == w[2] || w[2] == w[0];
        (!is_degenerate).then(|| if i % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{canonical_triangles, shapes};
    use crate::strip::stripify;

    #[test]
    fn odd_triangles_are_swapped_and_degenerate_ones_are_left_out() {
        let triangles: Vec<_> = strip_triangles(&[0, 1, 2, 3, 2, 4]).collect();
        assert_eq!(triangles, vec![[0, 1, 2], [2, 1, 3], [2, 3, 4]]);
    }

    #[test]
    fn cutting_keeps_every_triangle_and_its_winding() {
        let mut set = StripSet::new();
        set.push(&(0..23).collect::<Vec<u32>>());
        set.end_group();
        set.end_group();
        let mut whole = Vec::new();
        set.triangles_into(&mut whole);
        for max in 4..25 {
            let cut = set.cut(max);
            assert!(cut.strips().all(|s| s.len() <= max));
            assert_eq!(cut.group_count(), 2);
            let mut pieces = Vec::new();
            cut.triangles_into(&mut pieces);
            assert_eq!(pieces, whole, "at most {max} indices");
        }
    }

    #[test]
    fn invalid_offsets_are_rejected() {
        assert!(StripSet::from_parts(vec![0, 1, 2], vec![0, 3], vec![0, 1]).is_ok());
        for (offsets, groups) in [
            (vec![], vec![0]),
            (vec![1, 3], vec![0, 1]),
            (vec![0, 4], vec![0, 1]),
            (vec![0, 2], vec![0, 1]),
            (vec![0, 3], vec![0, 0]),
            (vec![0, 3, 2, 3], vec![0, 3]),
        ] {
            assert!(StripSet::from_parts(vec![0, 1, 2], offsets, groups).is_err());
        }
    }

    #[test]
    fn strips_are_renumbered_when_unused_vertices_are_removed() {
        let mut mesh = shapes::grid(2, 1);
        mesh.positions.insert(0, [7.0; 3]);
        mesh.triangles.iter_mut().flatten().for_each(|v| *v += 1);
        let strips = stripify(&mesh).expect("the mesh is consistent");
        let (less, renumbered) = (mesh.without_unused_vertices(), strips.on_used_vertices(&mesh));
        assert_eq!(less.vertex_count() + 1, mesh.vertex_count());
        let mut triangles = Vec::new();
        renumbered.expect("all of its vertices are used").triangles_into(&mut triangles);
        assert_eq!(canonical_triangles(&triangles), canonical_triangles(&less.triangles));
        // A strip that passes through an unused vertex cannot be kept.
        let mut others = StripSet::new();
        others.push(&[1, 0, 0, 2]);
        others.end_group();
        assert_eq!(others.on_used_vertices(&mesh), None);
    }
}
