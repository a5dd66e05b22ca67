//! What the writer knows of wedges and groups: the vertex that each corner shows at each level.
//!
//! On the way down a corner's vertex follows the targets of the sequence. What the triangles of a step showed when they
//! went is what they show when they come back; what the corners of its patch showed is kept beside.

use crate::mesh::{IndexedMesh, RefinableMesh};

use super::surface::{NONE, Surface, Undo};

/// Vertices of corners, in the numbering of the full surface.
#[derive(Clone, Debug, Default)]
pub(super) struct ShownDown {
    /// For each corner, four a triangle, what it shows now; once its triangle is gone, what it showed last.
    shown: Vec<u32>,
    /// What the corners of patches showed before their steps, the finest step first.
    patches: Vec<u32>,
}

impl ShownDown {
    /// The full mesh, whose triangles are the first of the surface.
    pub(super) fn new(mesh: &IndexedMesh, surface: &Surface) -> Self {
        let mut shown = vec![NONE; 4 * surface.triangle_count()];
        for (corners, triangle) in shown.chunks_exact_mut(4).zip(&mesh.triangles) {
            corners[..3].copy_from_slice(triangle);
        }
        Self { shown, patches: Vec::new() }
    }

    /// A step was done: the corners of its cut show targets now.
    pub(super) fn follow(&mut self, surface: &Surface, undo: &Undo, refinable: &RefinableMesh) {
        let mut corner = undo.cut.first;
        for _ in 0..undo.cut.length {
            let shown = &mut self.shown[corner as usize];
            self.patches.push(*shown);
            if *shown != NONE {
                *shown = refinable.sequence.target(*shown);
            }
            corner = surface.swing(corner);
        }
    }

    /// The way up.
    pub(super) fn into_up(self, undo: &[Undo], group_of: Vec<u32>) -> ShownUp {
        let mut patch_end = Vec::with_capacity(undo.len());
        let mut end = self.patches.len() as u32;
        for step in undo {
            patch_end.push(end);
            end -= step.cut.length;
        }
        ShownUp { down: self, patch_end, group_of, ..ShownUp::default() }
    }
}

/// Vertices of corners and groups of triangles, in the numbering of the surface under refinement.
#[derive(Clone, Debug, Default)]
pub(super) struct ShownUp {
    down: ShownDown,
    /// One past what was kept of each step's patch.
    patch_end: Vec<u32>,
    /// Group of each triangle of the mesh.
    group_of: Vec<u32>,
    /// What each corner shows, four a triangle.
    shown: Vec<u32>,
    /// Group of each triangle; none of virtual ones.
    groups: Vec<u32>,
}

impl ShownUp {
    /// Triangle `fine` of the full surface comes next, turned by so many corners.
    pub(super) fn push(&mut self, fine: u32, turn: u32) {
        let corners = &self.down.shown[4 * fine as usize..][..3];
        // Corner `i` of the full surface is corner `i + turn` here.
        let turned = [0, 1, 2].map(|i| corners[(i + 3 - turn as usize) % 3]);
        self.shown.extend(turned);
        self.shown.push(NONE);
        self.groups.push(self.group_of.get(fine as usize).copied().unwrap_or(NONE));
    }

    /// A step is done: the corners of its patch, counter-clockwise, show what they showed before it was collapsed.
    pub(super) fn refine(&mut self, step: u32, patch: &[u32]) {
        let end = self.patch_end[step as usize] as usize;
        for (corner, &shown) in patch.iter().zip(&self.down.patches[end - patch.len()..end]) {
            self.shown[*corner as usize] = shown;
        }
    }

    /// The vertex of the mesh that a corner shows; none of virtual triangles.
    pub(super) fn wedge(&self, corner: u32) -> u32 {
        self.shown[corner as usize]
    }

    /// The group of a triangle; none of virtual ones.
    pub(super) fn group(&self, triangle: u32) -> u32 {
        self.groups[triangle as usize]
    }
}

/// The group of each triangle of a mesh.
pub(super) fn groups_of_triangles(mesh: &IndexedMesh) -> Vec<u32> {
    let groups = mesh.groups_or_whole();
    groups
        .iter()
        .enumerate()
        .flat_map(|(g, group)| std::iter::repeat_n(g as u32, group.count as usize))
        .collect()
}
