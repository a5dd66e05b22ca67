//! Limit of the meshes that have the data of others: a small file must not expand to any number of triangles.

/// Most memory that copies take, bytes; further ones have data of their own.
const LIMIT_BYTES: u64 = 1 << 30;

/// Memory that the copies of meshes take.
#[derive(Default)]
pub(crate) struct Copies {
    bytes: u64,
}

impl Copies {
    /// Adds a copy, and returns whether it may be one.
    pub(crate) fn add(&mut self, vertex_count: usize, triangle_count: usize) -> bool {
        let own = (vertex_count as u64).saturating_add(triangle_count as u64).saturating_mul(12);
        let bytes = self.bytes.saturating_add(own);
        if bytes <= LIMIT_BYTES {
            self.bytes = bytes;
        }
        bytes <= LIMIT_BYTES
    }
}
