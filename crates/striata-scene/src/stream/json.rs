//! Access to the parts of a glTF document.

use serde_json::Value;

/// Entries of an array; none if there is no such array.
pub(super) fn entries<'v>(value: &'v Value, key: &str) -> &'v [Value] {
    value.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// The entry of an array that a member refers to by its index.
pub(super) fn referred<'v>(
    document: &'v Value,
    array: &str,
    from: &Value,
    member: &str,
) -> Option<&'v Value> {
    entries(document, array).get(index(from, member)?)
}

/// An index that a member contains.
pub(super) fn index(from: &Value, member: &str) -> Option<usize> {
    usize::try_from(from.get(member)?.as_u64()?).ok()
}

/// The triangle primitives of a mesh, which correspond to the groups of its triangles.
pub(super) fn triangle_primitives(document: &Value, mesh: usize) -> impl Iterator<Item = &Value> {
    let primitives =
        entries(document, "meshes").get(mesh).map_or(&[][..], |mesh| entries(mesh, "primitives"));
    primitives.iter().filter(|primitive| {
        let mode = primitive.get("mode").map_or(Some(4), Value::as_u64);
        let has_positions = primitive.pointer("/attributes/POSITION").is_some();
        has_positions && matches!(mode, Some(4..=6))
    })
}
