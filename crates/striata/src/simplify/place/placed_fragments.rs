//! Builds a sequence of fragments from recorded merges: edge and triangle collapses to new vertices.
//!
//! A merge that moves the position it keeps replaces both by a new one, so that no vertex ever moves. The
//! step removes what was there, the **own** vertices, and creates others, which a coarser step removes in
//! turn. In refinement order a vertex therefore comes after the vertex that it was merged into, every
//! level uses a prefix of the vertices, and the new ones among them are unused from then on.
//!
//! ```text
//!     a --- b          a --- b       ceiling: all triangles at u or v
//!    / \   / \        /  \ /  \      floor: all triangles at w
//!   f -- u -v -- c   f -- w -- c     own vertices, restored by the split: u and v
//!    \ /   \ /        \  / \  /      w is removed by the split, and restored by a later collapse
//!     e --- d          e --- d
//! ```

use super::merger::{LoggedMerge, MergeLog};
use crate::mesh::{
    Face, Fragment, FragmentError, FragmentSequence, FragmentedMesh, IndexedMesh, PositionIndex, Welded,
};

const NONE: u32 = u32::MAX;

/// The mesh and its fragments in refinement order, and for each vertex its row in the log.
pub(super) struct PlacedMesh {
    pub fragmented: FragmentedMesh,
    pub rows: Vec<u32>,
}

/// Returns the merges of each step.
pub(super) fn steps_of(log: &MergeLog) -> impl Iterator<Item = &[LoggedMerge]> {
    log.merges.chunk_by(|_, next| next.continues)
}

/// Builds the fragments of the first `step_count` steps of the log, whose floors have no errors yet.
/// `targets` contains the wedge that each removed wedge was merged into.
///
/// # Errors
/// [`FragmentError`] if the log contradicts the mesh.
pub(super) fn build_placed(
    welded: &Welded,
    log: &MergeLog,
    targets: &[u32],
    step_count: usize,
) -> Result<PlacedMesh, FragmentError> {
    let mut builder = PlacedBuilder::new(welded, targets);
    let mut steps: Vec<(Vec<u32>, Fragment)> =
        steps_of(log).take(step_count).map(|merges| builder.step(merges)).collect();
    steps.reverse();
    let mut order = Vec::with_capacity(builder.vertices.len());
    let mut first = vec![0];
    for p in 0..welded.positions.position_count() as u32 {
        let present = welded.positions.wedges(p).map(|w| builder.vertex_of[w as usize]);
        order.extend(present.filter(|&vertex| vertex != NONE));
        if order.len() as u32 > first[first.len() - 1] {
            first.push(order.len() as u32);
        }
    }
    for (own, _) in &steps {
        order.extend_from_slice(own);
        first.push(order.len() as u32);
    }
    let mut new_index = vec![0; builder.vertices.len()];
    (0..).zip(&order).for_each(|(new, &old)| new_index[old as usize] = new);
    let renumber = |face: Face| Face { corners: face.corners.map(|v| new_index[v as usize]), ..face };
    let base = builder.faces().map(renumber).collect();
    let steps = steps.into_iter().map(|(_, fragment)| Fragment {
        ceiling: fragment.ceiling.into_iter().map(renumber).collect(),
        floor: fragment.floor.into_iter().map(renumber).collect(),
        error: 0.0,
    });
    let fragments = FragmentSequence::from_fragments(PositionIndex::from_first(first), base, steps)?;
    let rows: Vec<u32> = order.iter().map(|&v| builder.vertices[v as usize].row).collect();
    let mesh = IndexedMesh {
        positions: order.iter().map(|&v| builder.vertices[v as usize].position).collect(),
        origin: welded.mesh.origin,
        exact_positions: Vec::new(),
        triangles: welded.mesh.triangles.iter().map(|t| t.map(|v| new_index[v as usize])).collect(),
        layers: log.rows.iter().map(|layer| layer.gather(&rows)).collect(),
        triangle_layers: welded.mesh.triangle_layers.clone(),
        groups: welded.mesh.groups.clone(),
        appearance: welded.mesh.appearance.clone(),
    };
    Ok(PlacedMesh { fragmented: FragmentedMesh { mesh, fragments }, rows })
}

/// A vertex of some level.
#[derive(Clone, Copy, Debug)]
struct PlacedVertex {
    position: [f32; 3],
    /// Row of its attributes in the log.
    row: u32,
}

/// The current mesh, in wedges of the welded mesh, and the vertex that each wedge currently is.
struct PlacedBuilder<'a> {
    welded: &'a Welded,
    targets: &'a [u32],
    groups: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    is_removed: Vec<bool>,
    /// First corner (`3 * triangle + k`) of each wedge's list.
    head: Vec<u32>,
    next: Vec<u32>,
    vertices: Vec<PlacedVertex>,
    /// The current vertex of each wedge; [`NONE`] if it was removed and not created again.
    vertex_of: Vec<u32>,
    /// Position and attributes that a vertex would have if it were created for a wedge now.
    current: Vec<PlacedVertex>,
    touched: Vec<u32>,
    is_touched: Vec<bool>,
}

impl<'a> PlacedBuilder<'a> {
    fn new(welded: &'a Welded, targets: &'a [u32]) -> Self {
        let mesh = &welded.mesh;
        let mut groups = vec![0; mesh.triangle_count()];
        for (index, group) in mesh.groups.iter().enumerate() {
            groups[group.range()].fill(index as u32);
        }
        let vertices: Vec<PlacedVertex> =
            mesh.positions.iter().zip(0..).map(|(&position, row)| PlacedVertex { position, row }).collect();
        let mut builder = Self {
            welded,
            targets,
            groups,
            triangles: mesh.triangles.clone(),
            is_removed: vec![false; mesh.triangle_count()],
            head: vec![NONE; mesh.vertex_count()],
            next: vec![NONE; 3 * mesh.triangle_count()],
            vertex_of: (0..mesh.vertex_count() as u32).collect(),
            current: vertices.clone(),
            vertices,
            touched: Vec::new(),
            is_touched: vec![false; mesh.triangle_count()],
        };
        for corner in (0..builder.next.len()).rev() {
            let wedge = builder.triangles[corner / 3][corner % 3] as usize;
            builder.next[corner] = std::mem::replace(&mut builder.head[wedge], corner as u32);
        }
        builder
    }

    fn face(&self, triangle: u32) -> Face {
        let [a, b, c] = self.triangles[triangle as usize];
        let corners = [a, b, c].map(|wedge| self.vertex_of[wedge as usize]);
        Face { corners, group: self.groups[triangle as usize] }
    }

    /// The faces of the current mesh.
    fn faces(&self) -> impl Iterator<Item = Face> + '_ {
        (0..self.triangles.len() as u32).filter(|&t| !self.is_removed[t as usize]).map(|t| self.face(t))
    }

    /// Applies the merges of one step; returns its own vertices and its fragment.
    fn step(&mut self, merges: &[LoggedMerge]) -> (Vec<u32>, Fragment) {
        let mut own = Vec::new();
        let mut fragment = Fragment::default();
        for merge in merges {
            let moved = merge.moved.map(|_| merge.kept);
            for p in [Some(merge.removed), moved].into_iter().flatten() {
                self.touch(p, &mut fragment.ceiling);
            }
            for p in [Some(merge.removed), moved].into_iter().flatten().chain(merge.lost.iter().copied()) {
                self.retire(p, &mut own);
            }
            for wedge in self.welded.positions.wedges(merge.removed) {
                self.move_corners(wedge, self.targets[wedge as usize]);
            }
            if let Some((position, first_row)) = merge.moved {
                for (wedge, row) in self.welded.positions.wedges(merge.kept).zip(first_row..) {
                    self.current[wedge as usize] = PlacedVertex { position, row };
                }
            }
        }
        for triangle in std::mem::take(&mut self.touched) {
            self.is_touched[triangle as usize] = false;
            if !self.is_removed[triangle as usize] {
                self.create_corners(triangle);
                fragment.floor.push(self.face(triangle));
            }
        }
        (own, fragment)
    }

    /// Adds the triangles around a position to the ceiling, unless they are there.
    fn touch(&mut self, p: u32, ceiling: &mut Vec<Face>) {
        for wedge in self.welded.positions.wedges(p) {
            let mut corner = self.head[wedge as usize];
            while corner != NONE {
                let triangle = corner / 3;
                corner = self.next[corner as usize];
                let is_new = !std::mem::replace(&mut self.is_touched[triangle as usize], true);
                if is_new && !self.is_removed[triangle as usize] {
                    self.touched.push(triangle);
                    ceiling.push(self.face(triangle));
                } else if is_new {
                    self.is_touched[triangle as usize] = false;
                }
            }
        }
    }

    /// Removes the vertices of a position from the current mesh and adds them to the own vertices.
    fn retire(&mut self, p: u32, own: &mut Vec<u32>) {
        for wedge in self.welded.positions.wedges(p) {
            let vertex = std::mem::replace(&mut self.vertex_of[wedge as usize], NONE);
            if vertex != NONE {
                own.push(vertex);
            }
        }
    }

    /// Moves the corners of a wedge to another one, and removes triangles that become degenerate.
    fn move_corners(&mut self, wedge: u32, target: u32) {
        let mut corner = std::mem::replace(&mut self.head[wedge as usize], NONE);
        while corner != NONE {
            let following = self.next[corner as usize];
            let triangle = corner as usize / 3;
            if !self.is_removed[triangle] {
                self.triangles[triangle][corner as usize % 3] = target;
                let [a, b, c] =
                    self.triangles[triangle].map(|wedge| self.welded.positions.position_of(wedge));
                self.is_removed[triangle] = a == b || b == c || c == a;
                let head = &mut self.head[target as usize];
                self.next[corner as usize] = std::mem::replace(head, corner);
            }
            corner = following;
        }
    }

    /// Creates the vertices of a triangle's wedges that have none.
    fn create_corners(&mut self, triangle: u32) {
        for wedge in self.triangles[triangle as usize] {
            if self.vertex_of[wedge as usize] == NONE {
                self.vertex_of[wedge as usize] = self.vertices.len() as u32;
                self.vertices.push(self.current[wedge as usize]);
            }
        }
    }
}
