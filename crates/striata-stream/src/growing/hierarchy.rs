//! [`GrowingHierarchy`]: the steps decoded so far, their dependencies, and the tree that a view descends.

use striata::view::Part;

/// No step: the parent of a root node, or the end of a list.
pub(super) const NONE: u32 = u32::MAX;

/// Marks an entry of `dependencies` that stands for a step and all older ones.
pub(super) const ALL_UP_TO: u32 = 1 << 31;

/// A vertex hierarchy of the steps decoded so far; see the [module](super).
///
/// The hierarchy does not copy the mesh:
/// [`HierarchyCut::triangles_into`](super::HierarchyCut::triangles_into) takes the mesh as of the last
/// [`grow`](Self::grow), or with further steps.
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
/// let (mut decoder, mut hierarchy) = (StreamDecoder::new(), GrowingHierarchy::new());
/// let mut cut = HierarchyCut::new();
/// for piece in stream.bytes.chunks(500) {
///     let update = decoder.push(piece)?;
///     let error = |step| decoder.error_at(step).unwrap_or(0.0);
///     hierarchy.grow(&decoder.prefix(), &update.changed_triangles, error);
///     let is_near = |part: &Part| if part.sphere.center[0] + part.sphere.radius > 0.5 { 2.0 } else { 0.0 };
///     let shown = cut.refine(&hierarchy, &is_near, usize::MAX);
///     println!("{} triangles", shown.triangle_count);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct GrowingHierarchy {
    pub(super) base_vertex_count: u32,
    /// First triangle of each step, followed by the triangle count; empty until the base mesh has been
    /// decoded.
    pub(super) first_triangles: Vec<u32>,
    /// Step that created each vertex beyond the base.
    pub(super) steps: Vec<u32>,
    pub(super) parents: Vec<u32>,
    /// First child of the base and of each step; siblings are in falling order of steps.
    pub(super) first_root: u32,
    pub(super) first_children: Vec<u32>,
    pub(super) next_siblings: Vec<u32>,
    /// Steps that each step depends on, and the start of each step's list, followed by the number of entries.
    pub(super) dependencies: Vec<u32>,
    pub(super) first_dependencies: Vec<u32>,
    pub(super) parts: Vec<Part>,
}

impl GrowingHierarchy {
    /// Creates a hierarchy without any steps.
    pub fn new() -> Self {
        Self::default()
    }

    /// Returns the number of steps.
    pub fn step_count(&self) -> usize {
        self.parents.len()
    }

    /// Returns the number of triangles of the base mesh.
    pub fn base_triangle_count(&self) -> usize {
        self.first_triangles.first().map_or(0, |&count| count as usize)
    }

    /// Returns the number of triangles at the finest level so far.
    pub fn triangle_count(&self) -> usize {
        self.first_triangles.last().map_or(0, |&count| count as usize)
    }

    /// Returns the parent of a step in the tree, or `None` for a root, whose parent is the base.
    ///
    /// # Panics
    /// If `step` is out of range.
    pub fn parent(&self, step: u32) -> Option<u32> {
        let parent = self.parents[step as usize];
        (parent != NONE).then_some(parent)
    }

    /// Returns the bounds and error that a criterion evaluates for a step: those of the step and all its
    /// descendants.
    ///
    /// # Panics
    /// If `step` is out of range.
    #[inline]
    pub fn part(&self, step: u32) -> Part {
        self.parts[step as usize]
    }

    /// Returns the memory that the hierarchy owns, in bytes.
    pub fn bytes(&self) -> usize {
        let lists = [
            &self.first_triangles,
            &self.steps,
            &self.parents,
            &self.first_children,
            &self.next_siblings,
            &self.dependencies,
            &self.first_dependencies,
        ];
        lists.iter().map(|list| 4 * list.capacity()).sum::<usize>()
            + size_of::<Part>() * self.parts.capacity()
    }

    /// Returns the range of triangles that a step adds.
    pub(super) fn added_triangles(&self, step: u32) -> std::ops::Range<usize> {
        self.first_triangles[step as usize] as usize..self.first_triangles[step as usize + 1] as usize
    }

    /// Returns the step that created a vertex, or `None` for a vertex of the base.
    #[inline]
    pub(super) fn step_of(&self, vertex: u32) -> Option<u32> {
        vertex.checked_sub(self.base_vertex_count).map(|beyond| self.steps[beyond as usize])
    }

    /// Returns the number of vertices of the base and all steps so far.
    pub fn vertex_count(&self) -> usize {
        self.base_vertex_count as usize + self.steps.len()
    }

    /// Returns the steps that a step depends on.
    pub(super) fn dependencies_of(&self, step: u32) -> &[u32] {
        &self.dependencies[self.first_dependencies[step as usize] as usize
            ..self.first_dependencies[step as usize + 1] as usize]
    }

    /// Visits the children of a step in the tree, or the roots if `parent` is `NONE`.
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
