//! Options of the writers.

/// Options of [`write()`](crate::write()) and [`to_bytes`](crate::to_bytes).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct WriteOptions {
    /// Whether to write PLY as text instead of binary little-endian. Default: false.
    pub ascii: bool,
    /// glTF only: triangle strips to write instead of the triangles, one index list for each triangle
    /// group. Each list is a single strip (joined by degenerate triangles, without restart indices). A
    /// group with an empty list is written as single triangles. Default: [`None`], so all groups are.
    pub strips: Option<Vec<Vec<u32>>>,
    /// glTF only: fans to write instead of the triangles, for each triangle group a list of index lists.
    /// glTF has no restart index, so each fan becomes a primitive, which takes some 140 bytes of JSON.
    /// Default: [`None`].
    pub fans: Option<Vec<Vec<Vec<u32>>>>,
}

impl WriteOptions {
    /// Sets [`ascii`](Self::ascii).
    #[must_use]
    pub fn with_ascii(self, ascii: bool) -> Self {
        Self { ascii, ..self }
    }

    /// Sets [`strips`](Self::strips).
    #[must_use]
    pub fn with_strips(self, strips: Vec<Vec<u32>>) -> Self {
        Self { strips: Some(strips), ..self }
    }

    /// Sets [`fans`](Self::fans), and clears the strips.
    #[must_use]
    pub fn with_fans(self, fans: Vec<Vec<Vec<u32>>>) -> Self {
        Self { strips: None, fans: Some(fans), ..self }
    }
}
