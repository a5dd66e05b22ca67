//! A general step: a position splits off a new one, passes some of its triangles to it, and creates new
//! triangles.

use std::ops::Range;

/// A triangle that a step creates: its corners are the new position, the split position, and a third one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct NewTriangle {
    /// The third position.
    pub third: u32,
    /// Whether the winding is (new, split, third) rather than (new, third, split).
    pub is_forward: bool,
}

impl NewTriangle {
    /// Puts values for the new, the split and the third position into the order of the triangle's corners.
    pub(crate) fn ordered(self, [new, split, third]: [u32; 3]) -> [u32; 3] {
        if self.is_forward { [new, split, third] } else { [new, third, split] }
    }
}

/// A triangle that a step creates, as the writer knows it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReferenceTriangle {
    /// Its third position and winding.
    pub triangle: NewTriangle,
    /// Vertex of the input mesh at its corner at the new position.
    pub wedge: u32,
    /// Vertices of the stream at its other corners: at the split position, and at the third.
    pub others: [u32; 2],
    /// Its group.
    pub group: u32,
}

/// A general step as the writer knows it.
#[derive(Clone, Debug, Default)]
pub(crate) struct ReferenceStep {
    /// The position that splits.
    pub split: u32,
    /// Corners that move to the new position, in ascending order, each with its vertex of the input mesh
    /// after the step.
    pub moved: Vec<(u32, u32)>,
    /// Triangles that the step creates.
    pub new_triangles: Vec<ReferenceTriangle>,
    /// Vertices of the input mesh at the new position.
    pub wedges: Range<u32>,
    /// Vertex of the stream to which each of them collapses.
    pub targets: Vec<u32>,
    /// Grid coordinates of the new position.
    pub grid_point: [i32; 3],
    /// Exact coordinates of the new position, mesh units.
    pub exact: [f32; 3],
}

impl ReferenceStep {
    /// Whether a corner moves to the new position.
    pub(crate) fn moves(&self, corner: u32) -> bool {
        self.moved.binary_search_by_key(&corner, |moved| moved.0).is_ok()
    }

    /// Returns the vertex of the stream to which a vertex of the new position collapses.
    pub(crate) fn target_of(&self, wedge: u32) -> Option<u32> {
        self.targets.get(wedge.checked_sub(self.wedges.start)? as usize).copied()
    }

    /// Returns the vertex of the input mesh that a moved corner has after the step.
    pub(crate) fn wedge_at(&self, corner: u32) -> Option<u32> {
        let at = self.moved.binary_search_by_key(&corner, |moved| moved.0).ok()?;
        Some(self.moved[at].1)
    }
}

/// A general step as both sides know it.
#[derive(Clone, Debug, Default)]
pub(crate) struct CodedStep {
    /// The position that splits.
    pub split: u32,
    /// Corners that move to the new position, in the order of the complex.
    pub moved: Vec<u32>,
    /// The corners in `moved`, sorted so that neighbors follow each other if possible.
    pub fan: Vec<u32>,
    /// Triangles that the step creates.
    pub new_triangles: Vec<NewTriangle>,
    /// For each of them, its index among the writer's triangles.
    pub reference_triangles: Vec<usize>,
    /// Grid coordinates of the new position.
    pub grid_point: [i32; 3],
    /// Vertex of the stream to which each wedge of the new position collapses.
    pub targets: Vec<u32>,
    /// The writer's vertex of each wedge; meaningless for a reader.
    pub reference_wedges: Vec<u32>,
    /// Wedge at each corner of the fan, then at the new corner of each new triangle.
    pub wedges: Vec<u32>,
    /// Vertices at the other two corners of each new triangle: at the split position, and at the third.
    pub others: Vec<[u32; 2]>,
    /// Group of each new triangle.
    pub groups: Vec<u32>,
}

impl CodedStep {
    /// Fills in wedges and groups for meshes with one vertex per position and no groups.
    pub(crate) fn use_one_vertex_per_position(&mut self) {
        self.targets = vec![self.split];
        self.wedges = vec![0; self.fan.len() + self.new_triangles.len()];
        self.others = self.new_triangles.iter().map(|triangle| [self.split, triangle.third]).collect();
        self.groups = vec![0; self.new_triangles.len()];
    }
}
