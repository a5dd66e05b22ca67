//! A vertex hierarchy that grows while steps arrive, and view-dependent cuts of what has arrived.
//!
//! Each step is a node. To refine a step, every position around the restored vertex has to be active, and the position that it
//! collapses to; the hierarchy lists these steps for each step (`grow.rs`). A **cut** is a set of refined steps that holds what each of
//! them needs (`cut.rs`). It shows the triangles that its steps add, and each corner of a triangle is the first active vertex along the
//! chain of targets. These are the triangles of [`FanInstance`](striata::model::FanInstance) for the same set of steps, whatever the topology of
//! the steps is.
//!
//! ```text
//! steps so far      | arriving      grow: replay the new steps backward, only over the triangles that they changed
//! ------------------+---------->          to find what each needs, its parent, and its bounds;
//!  needs, parents,  |                     then widen the bounds of the ancestors until nothing changes
//!  bounds (nodes)   |
//! ```
//!
//! Parents form the tree that a view descends: a step's bounds hold those of its children \[Hop97\], so a step that the view does
//! not want has nothing wanted below it.
//!
//! Differs: in \[Hop97\] bounds are built from the leaves. Here leaves arrive last, so a node begins with the bounds of its own change and is
//! widened by its descendants. Cones keep the axis of the node's own triangles.
//!
//! Cost: growing is linear in the triangles around the new vertices, and in the ancestors whose bounds they widen. A node takes about 85
//! bytes, up to 125 with the room that lists keep. A cut costs a question for each step in or next to it and one pass over the vertices.
//!
//! Invariants: parents and needs are older than their step; bounds are nested.

mod cut;
mod grow;

pub use cut::{CutUpdate, HierarchyCut};

use striata::view::Part;

/// No step: the parent of a node that hangs from the base, or the end of a list.
const NONE: u32 = u32::MAX;

/// Marks an entry of `needs` that stands for every step up to its number.
const ALL_THROUGH: u32 = 1 << 31;

/// Steps of a mesh as a hierarchy; see the [module](self).
///
/// The hierarchy keeps no copy of the mesh: [`HierarchyCut::triangles_into`] takes the mesh as it is after the last [`grow`](Self::grow), or with
/// further steps.
///
/// # Example
/// ```
/// use striata::mesh::shapes;
/// use striata::simplify::{BatchOptions, build_batches};
/// use striata::view::Part;
/// use striata_stream::{GrowingHierarchy, HierarchyCut, StreamDecoder, StreamOptions, encode_stream};
///
/// let built = build_batches(&shapes::torus(32, 16, 1.0, 0.4), &BatchOptions::default())?;
/// let stream = encode_stream(&built.built.refinable, &built.batches, &StreamOptions::default())?;
/// let (mut decoder, mut hierarchy, mut cut) = (StreamDecoder::new(), GrowingHierarchy::new(), HierarchyCut::new());
/// for piece in stream.bytes.chunks(500) {
///     let update = decoder.push(piece)?;
///     hierarchy.grow(&decoder.prefix(), &update.changed_triangles, |step| decoder.error_at(step).unwrap_or(0.0));
///     let is_near = |part: &Part| if part.sphere.center[0] + part.sphere.radius > 0.5 { 2.0 } else { 0.0 };
///     let shown = cut.refine(&hierarchy, &is_near, usize::MAX);
///     println!("{} triangles", shown.triangle_count);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct GrowingHierarchy {
    base_vertex_count: u32,
    /// First triangle of each step, followed by the triangle count; empty before the base has arrived.
    first_triangles: Vec<u32>,
    /// The step of each vertex beyond the base.
    steps: Vec<u32>,
    parents: Vec<u32>,
    /// First child of the base, and lists of siblings in falling order.
    first_root: u32,
    first_children: Vec<u32>,
    next_siblings: Vec<u32>,
    /// Steps that each step needs, and the first entry of each, followed by the number of entries.
    needs: Vec<u32>,
    first_needs: Vec<u32>,
    parts: Vec<Part>,
}

impl GrowingHierarchy {
    /// A hierarchy without any steps.
    pub fn new() -> Self {
        Self::default()
    }

    /// Steps that have arrived.
    pub fn step_count(&self) -> usize {
        self.parents.len()
    }

    /// Triangles of the base mesh.
    pub fn base_triangle_count(&self) -> usize {
        self.first_triangles.first().map_or(0, |&count| count as usize)
    }

    /// Triangles at the finest level that has arrived.
    pub fn triangle_count(&self) -> usize {
        self.first_triangles.last().map_or(0, |&count| count as usize)
    }

    /// The step above a step in the tree; none for a step that hangs from the base.
    ///
    /// # Panics
    /// If there is no such step.
    pub fn parent(&self, step: u32) -> Option<u32> {
        let parent = self.parents[step as usize];
        (parent != NONE).then_some(parent)
    }

    /// What a criterion is asked about a step: the step's own change and all that hangs below it.
    ///
    /// # Panics
    /// If there is no such step.
    #[inline]
    pub fn part(&self, step: u32) -> Part {
        self.parts[step as usize]
    }

    /// Bytes that the hierarchy owns.
    pub fn bytes(&self) -> usize {
        let lists = [
            &self.first_triangles,
            &self.steps,
            &self.parents,
            &self.first_children,
            &self.next_siblings,
            &self.needs,
            &self.first_needs,
        ];
        lists.iter().map(|list| 4 * list.capacity()).sum::<usize>()
            + size_of::<Part>() * self.parts.capacity()
    }

    /// Triangles that a step adds.
    fn added_triangles(&self, step: u32) -> std::ops::Range<usize> {
        self.first_triangles[step as usize] as usize..self.first_triangles[step as usize + 1] as usize
    }

    /// The step of a vertex that the hierarchy knows; none for one of the base.
    #[inline]
    fn step_of(&self, vertex: u32) -> Option<u32> {
        vertex.checked_sub(self.base_vertex_count).map(|beyond| self.steps[beyond as usize])
    }

    /// Vertices of the steps that have arrived, and of the base.
    pub fn vertex_count(&self) -> usize {
        self.base_vertex_count as usize + self.steps.len()
    }

    fn needs_of(&self, step: u32) -> &[u32] {
        &self.needs[self.first_needs[step as usize] as usize..self.first_needs[step as usize + 1] as usize]
    }

    /// Visits the steps right below a step in the tree, or below the base.
    fn for_each_child(&self, parent: u32, mut visit: impl FnMut(u32)) {
        let mut child = match parent {
            NONE if self.parents.is_empty() => NONE,
            NONE => self.first_root,
            parent => self.first_children[parent as usize],
        };
        while child != NONE {
            visit(child);
            child = self.next_siblings[child as usize];
        }
    }
}
