//! Closed surfaces as a corner table, with vertex splits and collapses.
//!
//! A corner is one of the three of a triangle; corners are numbered `4 * triangle + 0..3`, so that a triangle is one
//! aligned piece of memory. Around a vertex the triangles form one cycle: boundary loops are closed by a **virtual
//! vertex** each, and vertices that are not manifold were cut into copies (`cutting.rs`).
//!
//! ```text
//!        r1 --- r2              r1 --- r2         A split gives the triangles of a run of corners at u, the
//!       /  \   /  \            /  \   /  \        patch, to v: here those between r0 and r3. Two triangles
//!     r0 -- u,v -- r3        r0 --- v --- r3      are new: A = (v, u, r0) and B = (v, r3, u).
//!       \  /   \  /            \ A \|/ B /
//!        ..     ..              ..  u  ..
//! ```

/// A corner that is not there.
pub(crate) const NONE: u32 = u32::MAX;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Corner {
    vertex: u32,
    /// The corner across the edge between the two others of the triangle.
    opposite: u32,
}

/// A run of triangles around a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cut {
    /// The corner, at the vertex that splits, of the first triangle that goes to the new vertex.
    pub(crate) first: u32,
    /// Triangles that go to it, counter-clockwise.
    pub(crate) length: u32,
}

/// A collapse as it was done, for undoing it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Undo {
    /// The vertex that stays.
    pub(crate) kept: u32,
    /// Its run of corners.
    pub(crate) cut: Cut,
    /// The corners of the vertex that went in the two triangles that went with it, A and B.
    pub(crate) gone: [u32; 2],
}

/// The next corner of the triangle, counter-clockwise.
#[inline]
pub(crate) fn next(corner: u32) -> u32 {
    if corner & 3 == 2 { corner - 2 } else { corner + 1 }
}

/// The previous corner of the triangle.
#[inline]
pub(crate) fn previous(corner: u32) -> u32 {
    if corner & 3 == 0 { corner + 2 } else { corner - 1 }
}

/// The triangle of a corner.
#[inline]
pub(crate) fn triangle_of(corner: u32) -> u32 {
    corner >> 2
}

/// A closed triangulated surface whose vertices `0..virtual_count` stand for boundary loops.
#[derive(Clone, Debug, Default)]
pub(crate) struct Surface {
    /// Four a triangle; the fourth keeps the triangle's mark and label.
    corners: Vec<Corner>,
    corner_of: Vec<u32>,
    virtual_count: u32,
}

/// Why triangles are no closed surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceDefect {
    /// A triangle names vertices that are not there, or one position twice.
    #[error("triangle {0} does not have three different corners")]
    Corners(u32),
    /// Vertices that are no position, or positions that no vertex is at.
    #[error("position {0} is at no vertex")]
    Position(u32),
    /// A half-edge has no partner, or several.
    #[error("triangle {0} has an edge that is not shared by two triangles")]
    Edge(u32),
    /// The triangles around a vertex are not one cycle, or there are none.
    #[error("the triangles around vertex {0} are not one cycle")]
    Vertex(u32),
}

impl Surface {
    /// From triangles over `vertex_count` vertices with the corner across each edge: `opposite[3 t + i]` is `3 s + j`.
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
                corners.push(Corner { vertex, opposite: o / 3 * 4 + o % 3 });
            }
            corners.push(Corner { vertex: 0, opposite: 0 });
        }
        Self { corners, corner_of, virtual_count }
    }

    /// The same, where it is to be seen whether that is a closed surface.
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
        // Some vertex has more corners than its cycle.
        let mut is_seen = vec![false; self.corners.len()];
        for v in 0..self.corner_of.len() as u32 {
            self.ring(v).for_each(|c| is_seen[c as usize] = true);
        }
        let missed = (0..self.corners.len()).find(|&c| c & 3 != 3 && !is_seen[c]).unwrap_or(0);
        Err(SurfaceDefect::Vertex(self.corners[missed].vertex))
    }

    /// Makes room for so many splits.
    pub(crate) fn reserve(&mut self, splits: usize) {
        self.corners.reserve(8 * splits);
        self.corner_of.reserve(splits);
    }

    /// Vertices, virtual ones first.
    pub(crate) fn vertex_count(&self) -> usize {
        self.corner_of.len()
    }

    /// Triangles, those with a virtual corner included.
    pub(crate) fn triangle_count(&self) -> usize {
        self.corners.len() / 4
    }

    /// True for the vertex of a boundary loop.
    #[inline]
    pub(crate) fn is_virtual(&self, vertex: u32) -> bool {
        vertex < self.virtual_count
    }

    /// Vertices of boundary loops.
    pub(crate) fn virtual_count(&self) -> u32 {
        self.virtual_count
    }

    /// The vertex at a corner.
    #[inline]
    pub(crate) fn vertex(&self, corner: u32) -> u32 {
        self.corners[corner as usize].vertex
    }

    /// The corner across the edge that faces this one.
    #[inline]
    pub(crate) fn opposite(&self, corner: u32) -> u32 {
        self.corners[corner as usize].opposite
    }

    /// The vertices of a triangle.
    #[inline]
    pub(crate) fn triangle(&self, triangle: u32) -> [u32; 3] {
        let at = 4 * triangle as usize;
        [self.corners[at].vertex, self.corners[at + 1].vertex, self.corners[at + 2].vertex]
    }

    /// Some corner at a vertex, the same on both sides of a stream.
    #[inline]
    pub(crate) fn corner_of(&self, vertex: u32) -> u32 {
        self.corner_of[vertex as usize]
    }

    /// The corner of the next triangle around the same vertex, counter-clockwise.
    #[inline]
    pub(crate) fn swing(&self, corner: u32) -> u32 {
        next(self.opposite(next(corner)))
    }

    /// The corners at a vertex, counter-clockwise from [`Self::corner_of`].
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

    /// A number that the caller keeps with a triangle; 0 at first.
    #[inline]
    pub(crate) fn mark(&self, triangle: u32) -> u32 {
        self.corners[4 * triangle as usize + 3].vertex
    }

    /// Sets the number that is kept with a triangle.
    #[inline]
    pub(crate) fn set_mark(&mut self, triangle: u32, mark: u32) {
        self.corners[4 * triangle as usize + 3].vertex = mark;
    }

    /// Another number that the caller keeps with a triangle; 0 at first.
    #[inline]
    pub(crate) fn label(&self, triangle: u32) -> u32 {
        self.corners[4 * triangle as usize + 3].opposite
    }

    /// Sets the other number that is kept with a triangle.
    #[inline]
    pub(crate) fn set_label(&mut self, triangle: u32, label: u32) {
        self.corners[4 * triangle as usize + 3].opposite = label;
    }

    fn link(&mut self, a: u32, b: u32) {
        self.corners[a as usize].opposite = b;
        self.corners[b as usize].opposite = a;
    }

    /// Gives the triangles of a cut, `patch` being its corners, to a new vertex, the next one; A and B become the last two
    /// triangles.
    ///
    /// The new vertex's [`corner_of`](Self::corner_of) is A's, so its ring begins with A: `u, r0, .., rk`.
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
        self.corners.extend([v, kept, r0, 0, v, rk, kept, 0].map(|vertex| Corner { vertex, opposite: 0 }));
        self.link(a, outside_a);
        self.link(a + 1, before);
        self.link(a + 2, b + 1);
        self.link(b, outside_b);
        self.link(b + 2, after);
        self.corner_of.push(a);
        self.corner_of[kept as usize] = a + 1;
        v
    }

    /// Takes a vertex away: its triangles go to the neighbor at the edge of `corner`, the corner at the vertex whose
    /// next one is the neighbor. The two triangles at that edge vanish but stay in the table.
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
        Undo { kept, cut: Cut { first, length }, gone: [a, b] }
    }
}

impl Surface {
    /// Takes a collapse back, the last one that was done; all numbers are as they were before.
    pub(crate) fn take_back(&mut self, undo: &Undo) {
        let [a, b] = undo.gone;
        let vertex = self.vertex(a);
        let mut corner = undo.cut.first;
        let mut patch = Vec::with_capacity(undo.cut.length as usize);
        for _ in 0..undo.cut.length {
            patch.push(corner);
            corner = self.swing(corner);
        }
        patch.iter().for_each(|&corner| self.corners[corner as usize].vertex = vertex);
        // A and B still know who was beside them.
        for corner in [a, next(a), b, previous(b)] {
            let beside = self.opposite(corner);
            self.corners[beside as usize].opposite = corner;
        }
        self.corner_of[vertex as usize] = a;
        self.corner_of[undo.kept as usize] = next(a);
    }
}

/// # Errors
/// Where the triangles at an edge do not name each other, or do not run along it in opposite directions.
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

/// Every half-edge as its two vertices, smaller first, and the corner that faces it.
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

/// The half-edge that faces a corner, as its triangle runs along it.
pub(crate) fn edge_facing(triangles: &[[u32; 3]], corner: u32) -> (u32, u32) {
    let (t, i) = (corner as usize / 3, corner as usize % 3);
    (triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3])
}

/// True where the half-edge that faces a corner runs from the smaller vertex to the larger.
pub(crate) fn is_forward(triangles: &[[u32; 3]], corner: u32) -> bool {
    let (a, b) = edge_facing(triangles, corner);
    a < b
}
