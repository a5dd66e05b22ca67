//! A triangle list and its dual graph that follow collapses and vertex splits.
//!
//! Triangles keep the numbers of the full mesh. A collapse `v -> u` writes `u` into the corners at `v`, kills the
//! triangles that had both, and links again only sides along edges at `u`; a split undoes it. A dead
//! triangle keeps the corners that it died with, so its largest vertex is the one whose collapse killed it,
//! and a stack of the dead is all that has to be remembered.
//!
//! ```text
//!        a                     a           t1 and t2 die; the sides u - a
//!      / | \                  / \          of their neighbors find each other,
//!    l t1|  r     v -> u     l | r         and so do the sides u - b
//!    u---v--o    ------->      u - o
//!    l t2|  r                l | r
//!      \ | /                  \ /
//!        b                     b
//! ```
//!
//! Links are those of [`DualGraph`]: opposite directions, one group, each side at most once, and as many as there can
//! be; which of several sides on one edge are linked may differ. A step costs the triangles at `v`, and those at
//! `u` too where a side stays without a twin (borders). 52 bytes a triangle, 8 a vertex.

use striata::mesh::{DualGraph, IndexedMesh, NO_TWIN};
use striata::strip::{next_side, prev_side};

use super::stars::Stars;

/// Triangles of one level, linked.
#[derive(Clone, Debug)]
pub(super) struct LiveGraph {
    corners: Vec<[u32; 3]>,
    twins: Vec<u32>,
    stars: Stars,
    /// Dead triangles, the latest last.
    dead: Vec<u32>,
    /// One past the last triangle of each group.
    group_ends: Vec<u32>,
    /// Kept between steps so that none allocates: sides that look for a twin.
    loose: Vec<u32>,
    sorted: Vec<LooseSide>,
}

/// A side without twin; those that can be linked lie together when sorted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct LooseSide {
    /// The smaller vertex, the larger, the group.
    edge: (u32, u32, u32),
    is_backward: bool,
    side: u32,
}

impl LiveGraph {
    /// The full mesh, whose parts have been checked.
    pub(super) fn new(mesh: &IndexedMesh) -> Self {
        Self {
            corners: mesh.triangles.clone(),
            twins: DualGraph::of_vertices(mesh).twins().to_vec(),
            stars: Stars::new(&mesh.triangles, mesh.vertex_count()),
            dead: Vec::new(),
            group_ends: mesh.groups_or_whole().iter().map(|group| group.first + group.count).collect(),
            loose: Vec::new(),
            sorted: Vec::new(),
        }
    }

    /// The twin of every side, [`NO_TWIN`] where there is none; dead triangles have none.
    pub(super) fn twins(&self) -> &[u32] {
        &self.twins
    }

    /// Corners of a triangle that is shown.
    pub(super) fn corners(&self, triangle: u32) -> [u32; 3] {
        self.corners[triangle as usize]
    }

    /// The corners that stand at a vertex.
    pub(super) fn corners_at(&self, vertex: u32) -> impl Iterator<Item = u32> {
        self.stars.corners(vertex)
    }

    /// All triangles under the numbers of the full mesh; those that are not shown as `[0, 0, 0]`.
    pub(super) fn numbered_triangles(&self) -> Vec<[u32; 3]> {
        let mut triangles = self.corners.clone();
        for &dead in &self.dead {
            triangles[dead as usize] = [0; 3];
        }
        triangles
    }

    /// The group of a triangle.
    pub(super) fn group_of(&self, triangle: u32) -> u32 {
        if self.group_ends.len() == 1 {
            return 0;
        }
        self.group_ends.partition_point(|&end| end <= triangle) as u32
    }

    /// One past the last triangle of each group.
    pub(super) fn group_ends(&self) -> &[u32] {
        &self.group_ends
    }

    /// Lists the triangles that collapsing `vertex` to `target` would kill.
    pub(super) fn dying_into(&self, vertex: u32, target: u32, out: &mut Vec<u32>) {
        out.clear();
        out.extend(self.stars.corners(vertex).map(|c| c / 3).filter(|&t| self.corners(t).contains(&target)));
    }

    /// Collapses a vertex, of which no side is solid in `dying`.
    pub(super) fn collapse(&mut self, vertex: u32, target: u32, dying: &[u32]) {
        self.loose.clear();
        for &triangle in dying {
            for side in 3 * triangle..3 * triangle + 3 {
                let twin = std::mem::replace(&mut self.twins[side as usize], NO_TWIN);
                if twin != NO_TWIN {
                    self.twins[twin as usize] = NO_TWIN;
                    // A dying twin is loose only until its own turn.
                    if !dying.contains(&(twin / 3)) {
                        self.loose.push(twin);
                    }
                }
                self.stars.take_out(side);
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

    /// Begins to undo the collapse of `vertex`: its corners are back, and `parted` lists the sides at them
    /// whose twin now runs along another edge.
    pub(super) fn part_into(&mut self, vertex: u32, target: u32, parted: &mut Vec<u32>) {
        parted.clear();
        self.stars.split(vertex, target);
        for c in self.stars.corners(vertex) {
            self.corners[c as usize / 3][c as usize % 3] = vertex;
        }
        for c in self.stars.corners(vertex) {
            parted.extend([c, prev_side(c)].iter().filter(|&&side| {
                let twin = self.twins[side as usize];
                let edge = (self.origin(side), self.tip(side));
                twin != NO_TWIN && (self.tip(twin), self.origin(twin)) != edge
            }));
        }
    }

    /// Ends what [`Self::part_into`] began: no parted side is solid any more; lists the triangles that come back.
    pub(super) fn revive_into(&mut self, vertex: u32, target: u32, parted: &[u32], revived: &mut Vec<u32>) {
        self.loose.clear();
        revived.clear();
        for &side in parted {
            let twin = std::mem::replace(&mut self.twins[side as usize], NO_TWIN);
            self.twins[twin as usize] = NO_TWIN;
            self.loose.extend([side, twin]);
        }
        // Older dead may have the vertex too, but then a larger one beside it.
        let was_killed = |t: &mut u32| self.corners[*t as usize].iter().max() == Some(&vertex);
        while let Some(triangle) = self.dead.pop_if(was_killed) {
            for side in (3 * triangle..3 * triangle + 3).rev() {
                self.stars.put_back(side);
                self.loose.push(side);
            }
            revived.push(triangle);
        }
        self.link_loose(&[vertex, target]);
    }

    /// Links the sides in `loose`, where they cannot all be linked also with others at these vertices.
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

    /// Links what can be linked among the sides in `loose`; whether none is left.
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

    fn origin(&self, side: u32) -> u32 {
        self.corners[side as usize / 3][side as usize % 3]
    }

    fn tip(&self, side: u32) -> u32 {
        self.origin(next_side(side))
    }

    /// Bytes of what a level owns.
    pub(super) fn bytes(&self) -> usize {
        12 * self.corners.len() + 4 * (self.twins.len() + self.dead.capacity()) + self.stars.bytes()
    }
}
