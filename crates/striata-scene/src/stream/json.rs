//! Access to the parts of a glTF document.

use serde_json::Value;

use crate::document::{entries, has_triangles, index};

/// The entry of an array that a member refers to by its index.
pub(super) fn referred<'v>(
    document: &'v Value,
    array: &str,
    from: &Value,
    member: &str,
) -> Option<&'v Value> {
    entries(document, array).get(index(from, member)?)
}

/// The triangle primitives of a mesh, which correspond to the groups of its triangles.
pub(super) fn triangle_primitives(document: &Value, mesh: usize) -> impl Iterator<Item = &Value> {
    let primitives =
        entries(document, "meshes").get(mesh).map_or(&[][..], |mesh| entries(mesh, "primitives"));
    primitives.iter().filter(|primitive| has_triangles(primitive))
}
