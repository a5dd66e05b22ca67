//! Changes of a document by quantization.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::gltf::passes::additions::Additions;

/// Type of texture coordinates from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::gltf) enum Texcoords {
    /// Normalized 16-bit integers, the smallest without compression.
    Integers,
    /// Floats that `meshopt` compresses as integers.
    Floats,
}

/// Changes that a pass has made so far.
pub(super) struct DocumentChanges<'a> {
    /// The document to change; `snapshot` is what it was before.
    pub root: &'a mut Value,
    pub additions: Additions,
    /// Accessors that others have replaced.
    pub replaced: BTreeSet<u64>,
    /// Whether anything needs the extension.
    pub needs_extension: bool,
}
