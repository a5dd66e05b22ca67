//! The mapping between positions and their vertices (wedges).

/// Maps positions to vertices and back, for a mesh whose wedges are consecutive: position `p` owns the
/// vertices `first[p]..first[p + 1]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PositionIndex {
    first: Vec<u32>,
    /// Position of each vertex; empty if every position has one vertex, since the two indices are then equal.
    position_of: Vec<u32>,
}

impl PositionIndex {
    /// Creates an index in which every position has exactly one vertex.
    pub fn identity(vertex_count: usize) -> Self {
        Self { first: (0..=vertex_count as u32).collect(), position_of: Vec::new() }
    }

    /// Creates an index from the first vertex of each position, followed by the vertex count.
    ///
    /// # Panics
    /// If `first` does not start at 0 or is not strictly increasing.
    pub fn from_first(first: Vec<u32>) -> Self {
        assert_eq!(first.first(), Some(&0), "positions start at vertex 0");
        assert!(first.windows(2).all(|w| w[0] < w[1]), "every position owns at least one vertex");
        let (position_count, vertex_count) = (first.len() - 1, first[first.len() - 1] as usize);
        if position_count == vertex_count {
            return Self { first, position_of: Vec::new() };
        }
        let mut position_of = vec![0; vertex_count];
        for (p, w) in first.windows(2).enumerate() {
            position_of[w[0] as usize..w[1] as usize].fill(p as u32);
        }
        Self { first, position_of }
    }

    /// Number of positions.
    pub fn position_count(&self) -> usize {
        self.first.len() - 1
    }

    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.first[self.first.len() - 1] as usize
    }

    /// Whether every position has exactly one vertex.
    pub fn is_identity(&self) -> bool {
        self.position_of.is_empty()
    }

    /// The position of a vertex.
    #[inline]
    pub fn position_of(&self, vertex: u32) -> u32 {
        if self.position_of.is_empty() { vertex } else { self.position_of[vertex as usize] }
    }

    /// The first vertex of a position.
    #[inline]
    pub fn first_vertex(&self, position: u32) -> u32 {
        self.first[position as usize]
    }

    /// The vertices (wedges) of a position.
    #[inline]
    pub fn wedges(&self, position: u32) -> std::ops::Range<u32> {
        self.first[position as usize]..self.first[position as usize + 1]
    }

    /// First vertex of every position, followed by the vertex count.
    pub fn first_vertices(&self) -> &[u32] {
        &self.first
    }
}
