//! Triangle list and dual graph that follow collapses and vertex splits.
//!
//! Triangles keep their indices in the full mesh. A collapse `v -> u` writes `u` into the corners at `v`,
//! removes the triangles that had both vertices, and links only sides along edges at `u` again; a split
//! undoes it. A removed (dead) triangle keeps its last corners, so its largest vertex is the one whose
//! collapse removed it. A stack of the dead triangles is all that must be stored.
//!
//! ```text
//!        a                     a           t1 and t2 are removed; the sides u - a
//!      / | \                  / \          of their neighbors are linked to each other,
//!    l t1|  r     v -> u     l | r         and so are the sides u - b
//!    u---v--o    ------->      u - o
//!    l t2|  r                l | r
//!      \ | /                  \ /
//!        b                     b
//! ```
//!
//! Links follow the rules of [`DualGraph`]: opposite directions, one group, each side at most once, and as
//! many as possible; which of several sides on one edge are linked may differ. A step costs time for the
//! triangles at `v`, and also for those at `u` if a side remains without a twin (at boundaries). 52 bytes
//! per triangle, 8 per vertex.

use striata::mesh::{DualGraph, IndexedMesh, NO_TWIN};
use striata::strip::{next_side, prev_side};

use super::stars::CornerStars;

/// Linked triangles of the current level.
#[derive(Clone, Debug)]
pub(super) struct LiveGraph {
    corners: Vec<[u32; 3]>,
    twins: Vec<u32>,
    stars: CornerStars,
    /// Dead triangles, the latest last.
    dead: Vec<u32>,
    /// One past the last triangle of each group.
    group_ends: Vec<u32>,
    /// Sides that need a twin; reused between steps, so that no step allocates.
    loose: Vec<u32>,
    sorted: Vec<LooseSide>,
}

/// Side without a twin; sorting brings sides together that can be linked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct LooseSide {
    /// The smaller vertex, the larger vertex, and the group.
    edge: (u32, u32, u32),
    is_backward: bool,
    side: u32,
}

impl LiveGraph {
    /// Creates the graph of the full mesh, which must be consistent.
    pub(super) fn new(mesh: &IndexedMesh) -> Self {
        Self {
            corners: mesh.triangles.clone(),
            twins: DualGraph::of_vertices(mesh).twins().to_vec(),
            stars: CornerStars::new(&mesh.triangles, mesh.vertex_count()),
            dead: Vec::new(),
            group_ends: mesh.groups_or_whole().iter().map(|group| group.first + group.count).collect(),
            loose: Vec::new(),
            sorted: Vec::new(),
        }
    }

    /// Returns the twin of every side, or [`NO_TWIN`]; dead triangles have no twins.
    pub(super) fn twins(&self) -> &[u32] {
        &self.twins
    }

    /// Returns the vertices of an active triangle.
    pub(super) fn corners(&self, triangle: u32) -> [u32; 3] {
        self.corners[triangle as usize]
    }

    /// Returns the vertices of all triangles; dead ones keep their last.
    pub(super) fn all_corners(&self) -> &[[u32; 3]] {
        &self.corners
    }

    /// Iterates over the corners at a vertex.
    pub(super) fn corners_at(&self, vertex: u32) -> impl Iterator<Item = u32> {
        self.stars.corners(vertex)
    }

    /// Returns all triangles by their index in the full mesh; dead ones are `[0, 0, 0]`.
    pub(super) fn numbered_triangles(&self) -> Vec<[u32; 3]> {
        let mut triangles = self.corners.clone();
        for &dead in &self.dead {
            triangles[dead as usize] = [0; 3];
        }
        triangles
    }

    /// Returns the group of a triangle.
    pub(super) fn group_of(&self, triangle: u32) -> u32 {
        if self.group_ends.len() == 1 {
            return 0;
        }
        self.group_ends.partition_point(|&end| end <= triangle) as u32
    }

    /// Returns one past the last triangle of each group.
    pub(super) fn group_ends(&self) -> &[u32] {
        &self.group_ends
    }

    /// Lists the triangles that collapsing `vertex` to `target` would remove.
    pub(super) fn dying_into(&self, vertex: u32, target: u32, out: &mut Vec<u32>) {
        out.clear();
        out.extend(self.stars.corners(vertex).map(|c| c / 3).filter(|&t| self.corners(t).contains(&target)));
    }

    /// Collapses a vertex; no side of the triangles in `dying` may be solid.
    pub(super) fn collapse(&mut self, vertex: u32, target: u32, dying: &[u32]) {
        self.loose.clear();
        for &triangle in dying {
            for side in 3 * triangle..3 * triangle + 3 {
                let twin = std::mem::replace(&mut self.twins[side as usize], NO_TWIN);
                if twin != NO_TWIN {
                    self.twins[twin as usize] = NO_TWIN;
                    // A twin in a dying triangle is processed with that triangle.
                    if !dying.contains(&(twin / 3)) {
                        self.loose.push(twin);
                    }
                }
                self.stars.remove(side);
            }
            self.dead.push(triangle);
        }
        for c in self.stars.corners(vertex) {
            self.corners[c as usize / 3][c as usize % 3] = target;
            self.loose.extend([c, prev_side(c)].iter().filter(|&&side| self.twins[side as usize] == NO_TWIN));
        }
        self.stars.collapse(vertex, target);
        self.link_loose(&[target]);
    }

    /// Begins to undo the collapse of `vertex`: restores its corners and lists in `detached` the sides there
    /// whose twin now lies along another edge.
    pub(super) fn detach_into(&mut self, vertex: u32, target: u32, detached: &mut Vec<u32>) {
        detached.clear();
        self.stars.split(vertex, target);
        for c in self.stars.corners(vertex) {
            self.corners[c as usize / 3][c as usize % 3] = vertex;
        }
        for c in self.stars.corners(vertex) {
            detached.extend([c, prev_side(c)].iter().filter(|&&side| {
                let twin = self.twins[side as usize];
                let edge = (self.origin(side), self.tip(side));
                twin != NO_TWIN && (self.tip(twin), self.origin(twin)) != edge
            }));
        }
    }

    /// Completes [`Self::detach_into`], after all links of detached sides were made dashed, and lists the
    /// restored triangles.
    pub(super) fn restore_into(
        &mut self,
        vertex: u32,
        target: u32,
        detached: &[u32],
        restored: &mut Vec<u32>,
    ) {
        self.loose.clear();
        restored.clear();
        for &side in detached {
            let twin = std::mem::replace(&mut self.twins[side as usize], NO_TWIN);
            self.twins[twin as usize] = NO_TWIN;
            self.loose.extend([side, twin]);
        }
        // Triangles that died earlier may have the vertex too, but then they also have a larger one.
        let was_removed = |t: &mut u32| self.corners[*t as usize].iter().max() == Some(&vertex);
        while let Some(triangle) = self.dead.pop_if(was_removed) {
            for side in (3 * triangle..3 * triangle + 3).rev() {
                self.stars.restore(side);
                self.loose.push(side);
            }
            restored.push(triangle);
        }
        self.link_loose(&[vertex, target]);
    }

    /// Links the sides in `loose`; if some remain, tries again with all unlinked sides at these vertices.
    fn link_loose(&mut self, vertices: &[u32]) {
        if self.link_sorted() {
            return;
        }
        self.loose.clear();
        for &vertex in vertices {
            for c in self.stars.corners(vertex) {
                self.loose
                    .extend([c, prev_side(c)].iter().filter(|&&side| self.twins[side as usize] == NO_TWIN));
            }
        }
        self.link_sorted();
    }

    /// Links the sides in `loose` as far as possible. Returns whether none is left.
    fn link_sorted(&mut self) -> bool {
        self.sorted.clear();
        for &side in &self.loose {
            let (origin, tip) = (self.origin(side), self.tip(side));
            let edge = (origin.min(tip), origin.max(tip), self.group_of(side / 3));
            self.sorted.push(LooseSide { edge, is_backward: tip < origin, side });
        }
        self.sorted.sort_unstable();
        self.sorted.dedup();
        let mut is_complete = true;
        for run in self.sorted.chunk_by(|a, b| a.edge == b.edge) {
            let (forward, backward) = run.split_at(run.partition_point(|loose| !loose.is_backward));
            is_complete &= forward.len() == backward.len();
            for (a, b) in forward.iter().zip(backward) {
                self.twins[a.side as usize] = b.side;
                self.twins[b.side as usize] = a.side;
            }
        }
        is_complete
    }

    /// Returns the vertex from which a side runs.
    fn origin(&self, side: u32) -> u32 {
        self.corners[side as usize / 3][side as usize % 3]
    }

    /// Returns the vertex to which a side runs.
    fn tip(&self, side: u32) -> u32 {
        self.origin(next_side(side))
    }

    /// Returns the size of the owned data in bytes.
    pub(super) fn bytes(&self) -> usize {
        12 * self.corners.len() + 4 * (self.twins.len() + self.dead.capacity()) + self.stars.bytes()
    }
}
