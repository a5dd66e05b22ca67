//! How a mesh is written.

/// How a mesh is written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct WriteOptions {
    /// Writes PLY as text instead of binary little-endian. Default: false.
    pub ascii: bool,
    /// glTF only: for each triangle group, one list of indices that form a single triangle strip
    /// (joined by degenerate triangles, without restart indices), written instead of the triangles. A group whose list is
    /// empty is written as single triangles. Default: none, so that all groups are.
    pub strips: Option<Vec<Vec<u32>>>,
    /// glTF only: for each triangle group its fans, each a list of indices, written instead of the triangles. glTF
    /// knows no restart index, so each fan becomes a primitive, which takes some 140 bytes of JSON. Default: none.
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

    /// Sets [`fans`](Self::fans), and no strips.
    #[must_use]
    pub fn with_fans(self, fans: Vec<Vec<Vec<u32>>>) -> Self {
        Self { strips: None, fans: Some(fans), ..self }
    }
}
