//! The integers of attribute layers, and the neighborhood in which a vertex's attributes are coded.

use crate::layers::ring_fit::RingFit;

/// Number of vertex kinds; see [`LayerNeighborhood::kind`].
pub(crate) const KINDS: usize = 4;
/// Kind of the base mesh's vertices.
pub(crate) const BASE_KIND: usize = 3;

/// The neighborhood in which a vertex's attributes are coded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LayerNeighborhood<'a> {
    /// The vertex that it collapses to, or any nearby vertex; `None` for the very first vertex.
    pub target: Option<u32>,
    /// Vertices that share triangles with it, in ring order.
    pub ring: &'a [u32],
    /// Affine fit to the positions of the ring.
    pub fit: &'a RingFit,
    /// Number of preceding vertices at the same position.
    pub sibling_count: u32,
    /// Target of the preceding vertex at the same position.
    pub sibling_target: Option<u32>,
    /// Ring of the whole position, if it has several vertices.
    pub whole: Option<(&'a [u32], &'a RingFit)>,
    /// Whether no triangle refers to the vertex yet. Its ring is then that of the whole position.
    pub is_hidden: bool,
    /// Whether it belongs to the base mesh, where the ring contains only vertices that were coded before it.
    pub is_base: bool,
}

impl<'a> LayerNeighborhood<'a> {
    /// Creates the neighborhood of the only vertex of a position.
    pub(crate) fn new(target: Option<u32>, ring: &'a [u32], fit: &'a RingFit) -> Self {
        Self {
            target,
            ring,
            fit,
            sibling_count: 0,
            sibling_target: None,
            whole: None,
            is_hidden: false,
            is_base: false,
        }
    }

    /// Returns the kind of vertex: 0 for the only vertex of a position, 1 for one of several, 2 for one
    /// that no triangle refers to yet, 3 for one of the base mesh.
    pub(crate) fn kind(&self) -> usize {
        match (self.is_base, self.is_hidden, self.whole) {
            (true, ..) => BASE_KIND,
            (_, true, _) => 2,
            (_, _, Some(_)) => 1,
            _ => 0,
        }
    }
}

/// The integers of a layer, vertex by vertex.
#[derive(Clone, Debug, Default)]
pub(crate) struct LayerValues {
    integers: Vec<i32>,
    /// Number of integers per vertex.
    count: usize,
}

impl LayerValues {
    /// Creates an empty layer with a number of integers per vertex.
    pub(crate) fn new(integer_count: usize) -> Self {
        Self { integers: Vec::new(), count: integer_count }
    }

    /// Wraps the integers of a complete layer.
    pub(crate) fn from_integers(integers: Vec<i32>, integer_count: usize) -> Self {
        Self { integers, count: integer_count }
    }

    /// Number of integers per vertex.
    pub(crate) fn integer_count(&self) -> usize {
        self.count
    }

    /// Returns the integers of a vertex.
    #[inline]
    pub(crate) fn of(&self, vertex: u32) -> &[i32] {
        &self.integers[vertex as usize * self.count..][..self.count]
    }

    /// Returns the integers of all vertices.
    pub(crate) fn integers(&self) -> &[i32] {
        &self.integers
    }

    /// Appends integers of the next vertex.
    pub(crate) fn push(&mut self, integers: &[i32]) {
        self.integers.extend_from_slice(integers);
    }

    /// Appends a vertex with the same integers as another one.
    pub(crate) fn copy(&mut self, vertex: u32) {
        let from = vertex as usize * self.count;
        self.integers.extend_from_within(from..from + self.count);
    }

    /// Number of complete vertices.
    pub(crate) fn vertex_count(&self) -> usize {
        self.integers.len() / self.count
    }

    /// Removes all but the first vertices.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        self.integers.truncate(vertex_count * self.count);
    }
}
