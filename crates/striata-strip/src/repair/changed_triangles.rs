//! List of the triangles whose strips have changed.

/// Triangles that steps and repair have changed, removed or restored, or whose solid links they have changed.
///
/// Nothing is recorded until a buffer watches, so that other users pay nothing.
#[derive(Clone, Debug, Default)]
pub(super) struct ChangedTriangles {
    triangles: Vec<u32>,
    /// Whether each triangle is in the list; empty if nothing is recorded.
    is_listed: Vec<bool>,
}

impl ChangedTriangles {
    /// Begins to record, with an empty list.
    pub(super) fn watch(&mut self, triangle_count: usize) {
        self.triangles.clear();
        self.is_listed.clear();
        self.is_listed.resize(triangle_count, false);
    }

    /// Adds a triangle, unless it is listed already.
    #[inline]
    pub(super) fn add(&mut self, triangle: u32) {
        if let Some(is_listed) = self.is_listed.get_mut(triangle as usize)
            && !std::mem::replace(is_listed, true)
        {
            self.triangles.push(triangle);
        }
    }

    /// Moves the list into `out` and clears it here.
    pub(super) fn take_into(&mut self, out: &mut Vec<u32>) {
        out.clear();
        std::mem::swap(&mut self.triangles, out);
        for &triangle in out.iter() {
            self.is_listed[triangle as usize] = false;
        }
    }

    /// Number of bytes that it owns.
    pub(super) fn bytes(&self) -> usize {
        4 * self.triangles.capacity() + self.is_listed.len()
    }
}
