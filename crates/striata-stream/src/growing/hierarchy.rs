//! The hierarchy itself: steps, what they need, and the tree that a view descends.

use striata::view::Part;

/// No step: the parent of a node that hangs from the base, or the end of a list.
pub(super) const NONE: u32 = u32::MAX;

/// Marks an entry of `needs` that stands for every step up to its number.
pub(super) const ALL_THROUGH: u32 = 1 << 31;

/// Steps of a mesh as a hierarchy; see the [module](super).
///
/// The hierarchy keeps no copy of the mesh: [`HierarchyCut::triangles_into`](super::HierarchyCut::triangles_into) takes the mesh as it is after the last [`grow`](Self::grow), or with
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
    pub(super) base_vertex_count: u32,
    /// First triangle of each step, followed by the triangle count; empty before the base has arrived.
    pub(super) first_triangles: Vec<u32>,
    /// The step of each vertex beyond the base.
    pub(super) steps: Vec<u32>,
    pub(super) parents: Vec<u32>,
    /// First child of the base, and lists of siblings in falling order.
    pub(super) first_root: u32,
    pub(super) first_children: Vec<u32>,
    pub(super) next_siblings: Vec<u32>,
    /// Steps that each step needs, and the first entry of each, followed by the number of entries.
    pub(super) needs: Vec<u32>,
    pub(super) first_needs: Vec<u32>,
    pub(super) parts: Vec<Part>,
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
    pub(super) fn added_triangles(&self, step: u32) -> std::ops::Range<usize> {
        self.first_triangles[step as usize] as usize..self.first_triangles[step as usize + 1] as usize
    }

    /// The step of a vertex that the hierarchy knows; none for one of the base.
    #[inline]
    pub(super) fn step_of(&self, vertex: u32) -> Option<u32> {
        vertex.checked_sub(self.base_vertex_count).map(|beyond| self.steps[beyond as usize])
    }

    /// Vertices of the steps that have arrived, and of the base.
    pub fn vertex_count(&self) -> usize {
        self.base_vertex_count as usize + self.steps.len()
    }

    /// Steps that a step needs.
    pub(super) fn needs_of(&self, step: u32) -> &[u32] {
        &self.needs[self.first_needs[step as usize] as usize..self.first_needs[step as usize + 1] as usize]
    }

    /// Visits the steps right below a step in the tree, or below the base.
    pub(super) fn for_each_child(&self, parent: u32, mut visit: impl FnMut(u32)) {
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
