//! A closed surface as a corner table, with vertex splits and collapses.
//!
//! A corner is one vertex of one triangle. Corners are numbered `4 * triangle + 0..3`, so that each triangle
//! is one aligned piece of memory. The triangles around a vertex form one cycle: each boundary loop is closed
//! by a **virtual vertex**, and non-manifold vertices have been cut into copies (`cutting.rs`).
//!
//! ```text
//!        r1 --- r2              r1 --- r2         A split gives the triangles of a run of corners at u, the
//!       /  \   /  \            /  \   /  \        patch, to v: here those between r0 and r3. Two triangles
//!     r0 -- u,v -- r3        r0 --- v --- r3      are new: A = (v, u, r0) and B = (v, r3, u).
//!       \  /   \  /            \ A \|/ B /
//!        ..     ..              ..  u  ..
//! ```

/// Marks a missing corner, vertex or label.
pub(crate) const NONE: u32 = u32::MAX;

/// A corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct CornerLinks {
    vertex: u32,
    /// The corner across the edge that faces this corner.
    opposite: u32,
}

/// A run of consecutive triangles around a vertex, which a split moves to the new vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cut {
    /// Corner of the first of these triangles at the vertex that splits.
    pub first: u32,
    /// Number of triangles, counterclockwise.
    pub length: u32,
}

/// Record of a collapse, for undoing it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Undo {
    /// The vertex that remains.
    pub kept: u32,
    /// The run of triangles that moved to it.
    pub cut: Cut,
    /// Corners of the removed vertex in the two removed triangles, A and B.
    pub removed_corners: [u32; 2],
}

/// Returns the next corner of the triangle, counterclockwise.
#[inline]
pub(crate) fn next(corner: u32) -> u32 {
    if corner & 3 == 2 { corner - 2 } else { corner + 1 }
}

/// Returns the previous corner of the triangle.
#[inline]
pub(crate) fn previous(corner: u32) -> u32 {
    if corner & 3 == 0 { corner + 2 } else { corner - 1 }
}

/// Returns the triangle of a corner.
#[inline]
pub(crate) fn triangle_of(corner: u32) -> u32 {
    corner >> 2
}

/// A closed triangulated surface. Vertices `0..virtual_count` are virtual and close boundary loops.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surface {
    /// Four entries for each triangle: its corners, and one that stores the triangle's mark and label.
    corners: Vec<CornerLinks>,
    /// A corner of each vertex.
    corner_of: Vec<u32>,
    virtual_count: u32,
}

/// Why triangles do not form a closed surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceDefect {
    /// A triangle refers to a missing vertex, or to one position twice.
    #[error("triangle {0} does not have three different corners")]
    Corners(u32),
    /// A position has no vertex, or a vertex has no position.
    #[error("position {0} has no vertex")]
    Position(u32),
    /// A half-edge does not have exactly one partner.
    #[error("triangle {0} has an edge that is not shared by exactly two triangles")]
    Edge(u32),
    /// The triangles around a vertex do not form one cycle, or the vertex has no triangle.
    #[error("the triangles around vertex {0} do not form one cycle")]
    Vertex(u32),
}

impl Surface {
    /// Builds a surface from triangles and the corner across each edge: `opposite[3 t + i]` is `3 s + j`,
    /// which means corner `j` of triangle `s`. The input is not checked.
    pub(crate) fn from_opposites(
        triangles: &[[u32; 3]],
        opposite: &[u32],
        vertex_count: usize,
        virtual_count: u32,
    ) -> Self {
        let mut corners = Vec::with_capacity(4 * triangles.len());
        let mut corner_of = vec![NONE; vertex_count];
        for (t, triangle) in triangles.iter().enumerate() {
            for (i, &vertex) in triangle.iter().enumerate() {
                let o = opposite[3 * t + i];
                corner_of[vertex as usize] = corners.len() as u32;
                corners.push(CornerLinks { vertex, opposite: o / 3 * 4 + o % 3 });
            }
            corners.push(CornerLinks { vertex: 0, opposite: 0 });
        }
        Self { corners, corner_of, virtual_count }
    }

    /// Builds a surface like [`from_opposites`](Self::from_opposites), and checks that it is closed.
    ///
    /// # Errors
    /// [`SurfaceDefect`] if it is not.
    pub(crate) fn from_closed(
        triangles: &[[u32; 3]],
        opposite: &[u32],
        vertex_count: usize,
        virtual_count: u32,
    ) -> Result<Self, SurfaceDefect> {
        check_edges(triangles, opposite)?;
        let surface = Self::from_opposites(triangles, opposite, vertex_count, virtual_count);
        surface.check_cycles(triangles.len())?;
        Ok(surface)
    }

    /// Checks that the corners at each vertex form one cycle.
    fn check_cycles(&self, triangle_count: usize) -> Result<(), SurfaceDefect> {
        let mut seen = 0;
        for v in 0..self.corner_of.len() as u32 {
            if self.corner_of[v as usize] == NONE {
                return Err(SurfaceDefect::Vertex(v));
            }
            seen += self.ring(v).count();
        }
        if seen == 3 * triangle_count {
            return Ok(());
        }
        // At least one vertex has corners outside its cycle.
        let mut is_seen = vec![false; self.corners.len()];
        for v in 0..self.corner_of.len() as u32 {
            self.ring(v).for_each(|c| is_seen[c as usize] = true);
        }
        let missed = (0..self.corners.len()).find(|&c| c & 3 != 3 && !is_seen[c]).unwrap_or(0);
        Err(SurfaceDefect::Vertex(self.corners[missed].vertex))
    }

    /// Reserves memory for a number of splits.
    pub(crate) fn reserve(&mut self, splits: usize) {
        self.corners.reserve(8 * splits);
        self.corner_of.reserve(splits);
    }

    /// Number of vertices, including virtual ones, which come first.
    pub(crate) fn vertex_count(&self) -> usize {
        self.corner_of.len()
    }

    /// Number of triangles, including those with a virtual corner.
    pub(crate) fn triangle_count(&self) -> usize {
        self.corners.len() / 4
    }

    /// Whether a vertex closes a boundary loop.
    #[inline]
    pub(crate) fn is_virtual(&self, vertex: u32) -> bool {
        vertex < self.virtual_count
    }

    /// Number of virtual vertices, one for each boundary loop.
    pub(crate) fn virtual_count(&self) -> u32 {
        self.virtual_count
    }

    /// Returns the vertex at a corner.
    #[inline]
    pub(crate) fn vertex(&self, corner: u32) -> u32 {
        self.corners[corner as usize].vertex
    }

    /// Returns the corner on the other side of the edge that faces this corner.
    #[inline]
    pub(crate) fn opposite(&self, corner: u32) -> u32 {
        self.corners[corner as usize].opposite
    }

    /// Returns the vertices of a triangle.
    #[inline]
    pub(crate) fn triangle(&self, triangle: u32) -> [u32; 3] {
        let at = 4 * triangle as usize;
        [self.corners[at].vertex, self.corners[at + 1].vertex, self.corners[at + 2].vertex]
    }

    /// Returns a corner at a vertex. Writer and reader agree on which one.
    #[inline]
    pub(crate) fn corner_of(&self, vertex: u32) -> u32 {
        self.corner_of[vertex as usize]
    }

    /// Returns the corner at the same vertex in the next triangle counterclockwise.
    #[inline]
    pub(crate) fn swing(&self, corner: u32) -> u32 {
        next(self.opposite(next(corner)))
    }

    /// Iterates over the corners at a vertex, counterclockwise from [`Self::corner_of`].
    pub(crate) fn ring(&self, vertex: u32) -> impl Iterator<Item = u32> + '_ {
        let first = self.corner_of[vertex as usize];
        let mut corner = first;
        let mut is_done = false;
        std::iter::from_fn(move || {
            if is_done {
                return None;
            }
            let here = corner;
            corner = self.swing(corner);
            is_done = corner == first;
            Some(here)
        })
    }

    /// Returns the mark, a number that callers may attach to a triangle; initially 0.
    #[inline]
    pub(crate) fn mark(&self, triangle: u32) -> u32 {
        self.corners[4 * triangle as usize + 3].vertex
    }

    /// Sets the mark of a triangle.
    #[inline]
    pub(crate) fn set_mark(&mut self, triangle: u32, mark: u32) {
        self.corners[4 * triangle as usize + 3].vertex = mark;
    }

    /// Returns the label, a second number that callers may attach to a triangle; initially 0.
    #[inline]
    pub(crate) fn label(&self, triangle: u32) -> u32 {
        self.corners[4 * triangle as usize + 3].opposite
    }

    /// Sets the label of a triangle.
    #[inline]
    pub(crate) fn set_label(&mut self, triangle: u32, label: u32) {
        self.corners[4 * triangle as usize + 3].opposite = label;
    }

    /// Makes two corners each other's opposite.
    fn link(&mut self, a: u32, b: u32) {
        self.corners[a as usize].opposite = b;
        self.corners[b as usize].opposite = a;
    }

    /// Splits a vertex: the triangles of `patch`, given by their corners at the vertex, move to a new
    /// vertex, and A and B are appended as the last two triangles. Returns the new vertex, whose index is
    /// the next free one.
    ///
    /// The new vertex's [`corner_of`](Self::corner_of) lies in A, so its ring begins with A: `u, r0, .., rk`.
    ///
    /// # Panics
    /// If the patch is empty.
    pub(crate) fn split(&mut self, patch: &[u32]) -> u32 {
        let (first, last) = (patch[0], patch[patch.len() - 1]);
        let kept = self.vertex(first);
        let v = self.corner_of.len() as u32;
        for &corner in patch {
            self.corners[corner as usize].vertex = v;
        }
        let (before, after) = (previous(first), next(last));
        let [r0, rk] = [next(first), previous(last)].map(|c| self.vertex(c));
        let [outside_a, outside_b] = [self.opposite(before), self.opposite(after)];
        let a = self.corners.len() as u32;
        let b = a + 4;
        self.corners
            .extend([v, kept, r0, 0, v, rk, kept, 0].map(|vertex| CornerLinks { vertex, opposite: 0 }));
        self.link(a, outside_a);
        self.link(a + 1, before);
        self.link(a + 2, b + 1);
        self.link(b, outside_b);
        self.link(b + 2, after);
        self.corner_of.push(a);
        self.corner_of[kept as usize] = a + 1;
        v
    }

    /// Removes a vertex: its triangles move to the neighbor along an edge. `corner` is the corner at the
    /// removed vertex whose next vertex is that neighbor. The two triangles at the edge disappear from
    /// the surface but stay in the table.
    pub(crate) fn collapse(&mut self, corner: u32) -> Undo {
        let a = corner;
        let kept = self.vertex(next(a));
        let first = self.swing(a);
        let (mut last, mut length) = (first, 0);
        let b = loop {
            self.corners[last as usize].vertex = kept;
            length += 1;
            let after = self.swing(last);
            if self.vertex(previous(after)) == kept && self.swing(after) == a {
                break after;
            }
            last = after;
        };
        let (outside_a, inside_a) = (self.opposite(a), self.opposite(next(a)));
        let (outside_b, inside_b) = (self.opposite(b), self.opposite(previous(b)));
        self.link(outside_a, inside_a);
        self.link(outside_b, inside_b);
        let [r0, rk] = [next(first), previous(last)];
        self.corner_of[kept as usize] = first;
        for c in [r0, rk] {
            let vertex = self.vertex(c);
            self.corner_of[vertex as usize] = c;
        }
        Undo { kept, cut: Cut { first, length }, removed_corners: [a, b] }
    }
}

impl Surface {
    /// Undoes the most recent collapse, restoring all indices.
    pub(crate) fn undo_collapse(&mut self, undo: &Undo) {
        let [a, b] = undo.removed_corners;
        let vertex = self.vertex(a);
        let mut corner = undo.cut.first;
        let mut patch = Vec::with_capacity(undo.cut.length as usize);
        for _ in 0..undo.cut.length {
            patch.push(corner);
            corner = self.swing(corner);
        }
        patch.iter().for_each(|&corner| self.corners[corner as usize].vertex = vertex);
        // A and B still know their former neighbors.
        for corner in [a, next(a), b, previous(b)] {
            let outside = self.opposite(corner);
            self.corners[outside as usize].opposite = corner;
        }
        self.corner_of[vertex as usize] = a;
        self.corner_of[undo.kept as usize] = next(a);
    }
}

/// Checks that corners across an edge refer to each other and that their triangles run along it in
/// opposite directions.
///
/// # Errors
/// [`SurfaceDefect::Edge`] with the first triangle for which this does not hold.
fn check_edges(triangles: &[[u32; 3]], opposite: &[u32]) -> Result<(), SurfaceDefect> {
    for (corner, &across) in opposite.iter().enumerate() {
        let is_mutual = opposite.get(across as usize) == Some(&(corner as u32));
        if !is_mutual || across as usize == corner {
            return Err(SurfaceDefect::Edge(corner as u32 / 3));
        }
        let ((a, b), (c, d)) = (edge_facing(triangles, corner as u32), edge_facing(triangles, across));
        if (a, b) != (d, c) {
            return Err(SurfaceDefect::Edge(corner as u32 / 3));
        }
    }
    Ok(())
}

/// Returns every half-edge as a key of its two vertices, smaller first, and the corner that faces it.
pub(crate) fn half_edges(triangles: &[[u32; 3]]) -> Vec<(u64, u32)> {
    let mut edges = Vec::with_capacity(3 * triangles.len());
    for t in 0..triangles.len() as u32 {
        for i in 0..3 {
            let (a, b) = edge_facing(triangles, 3 * t + i);
            edges.push((u64::from(a.min(b)) << 32 | u64::from(a.max(b)), 3 * t + i));
        }
    }
    edges
}

/// Returns the vertices of the half-edge that faces a corner, in its triangle's direction.
pub(crate) fn edge_facing(triangles: &[[u32; 3]], corner: u32) -> (u32, u32) {
    let (t, i) = (corner as usize / 3, corner as usize % 3);
    (triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3])
}

/// Whether the half-edge that faces a corner runs from the smaller vertex index to the larger.
pub(crate) fn is_forward(triangles: &[[u32; 3]], corner: u32) -> bool {
    let (a, b) = edge_facing(triangles, corner);
    a < b
}
