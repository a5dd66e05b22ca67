//! The integers of attribute layers, and what is known around a vertex before its own are coded.

use crate::layers::ring_fit::RingFit;

/// Kinds of vertices; see [`LayerHood::kind`].
pub(crate) const KINDS: usize = 4;
/// The kind of vertices of the base.
pub(crate) const BASE_KIND: usize = 3;

/// What is known around a vertex when its attributes are coded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LayerHood<'a> {
    /// The vertex that it collapses to, or any that is near; none for the first of all.
    pub(crate) target: Option<u32>,
    /// Vertices that it shares triangles with, in ring order; those of other places are not among them.
    pub(crate) ring: &'a [u32],
    /// Fitted to the places of the ring.
    pub(crate) fit: &'a RingFit,
    /// The vertices just before it that are at the same position.
    pub(crate) sibling_count: u32,
    /// The target of the vertex before it at the same position.
    pub(crate) sibling_target: Option<u32>,
    /// The ring of the whole position, if it has several vertices.
    pub(crate) whole: Option<(&'a [u32], &'a RingFit)>,
    /// True if no triangle shows the vertex yet. Its ring is that of the whole position then.
    pub(crate) is_hidden: bool,
    /// True in the base, where the ring is what was coded before.
    pub(crate) is_base: bool,
}

impl<'a> LayerHood<'a> {
    /// Surroundings of the only vertex of a position.
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

    /// 0 for the only vertex of a position, 1 for one of several, 2 for one that no triangle shows yet, 3 for those of the
    /// base.
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
    count: usize,
}

impl LayerValues {
    /// No vertices, so many integers each.
    pub(crate) fn new(integer_count: usize) -> Self {
        Self { integers: Vec::new(), count: integer_count }
    }

    /// All integers of a layer.
    pub(crate) fn from_integers(integers: Vec<i32>, integer_count: usize) -> Self {
        Self { integers, count: integer_count }
    }

    /// Integers that a vertex has.
    pub(crate) fn integer_count(&self) -> usize {
        self.count
    }

    /// The integers of a vertex.
    #[inline]
    pub(crate) fn of(&self, vertex: u32) -> &[i32] {
        &self.integers[vertex as usize * self.count..][..self.count]
    }

    /// The integers of all vertices.
    pub(crate) fn integers(&self) -> &[i32] {
        &self.integers
    }

    /// Appends integers of the next vertex.
    pub(crate) fn push(&mut self, integers: &[i32]) {
        self.integers.extend_from_slice(integers);
    }

    /// Gives the next vertex the integers of another one.
    pub(crate) fn copy(&mut self, vertex: u32) {
        let from = vertex as usize * self.count;
        self.integers.extend_from_within(from..from + self.count);
    }

    /// Vertices that are whole.
    pub(crate) fn vertex_count(&self) -> usize {
        self.integers.len() / self.count
    }

    /// Forgets all but the first vertices.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        self.integers.truncate(vertex_count * self.count);
    }
}
