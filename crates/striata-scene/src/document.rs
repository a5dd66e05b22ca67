//! Access to glTF documents, and changes of them.

use serde_json::{Map, Value, json};

/// Entries of an array; none if there is no such array.
pub(crate) fn entries<'v>(value: &'v Value, key: &str) -> &'v [Value] {
    value.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// Returns a member that is an index.
pub(crate) fn index(value: &Value, key: &str) -> Option<usize> {
    usize::try_from(value.get(key)?.as_u64()?).ok()
}

/// Whether a primitive of a mesh consists of triangles.
pub(crate) fn has_triangles(primitive: &Value) -> bool {
    let mode = primitive.get("mode").map_or(Some(4), Value::as_u64);
    let has_positions = primitive.pointer("/attributes/POSITION").is_some();
    has_positions && matches!(mode, Some(4..=6))
}

/// Returns the place of an extension in an object of the document, which is created if it is missing;
/// [`None`] if the value is not an object, or its extensions are not.
pub(crate) fn extension_slot<'v>(object: &'v mut Value, extension: &str) -> Option<&'v mut Value> {
    let extensions = object.as_object_mut()?.entry("extensions").or_insert_with(|| Value::Object(Map::new()));
    Some(extensions.as_object_mut()?.entry(extension).or_insert(Value::Null))
}

/// Adds an extension to `extensionsUsed`.
pub(crate) fn use_extension(document: &mut Value, extension: &str) {
    let Some(names) = array(document, "extensionsUsed") else { return };
    if !names.iter().any(|name| name == extension) {
        names.push(json!(extension));
    }
}

/// Returns an array of an object, which is created if it is missing; [`None`] if it is something else.
pub(crate) fn array<'v>(object: &'v mut Value, key: &str) -> Option<&'v mut Vec<Value>> {
    let entry = object.as_object_mut()?.entry(key).or_insert_with(|| Value::Array(Vec::new()));
    entry.as_array_mut()
}
