//! Extensions that allow passes to change values or order, and declarations of extensions.

use serde_json::{Value, json};

use super::parts::entries;

/// Extensions of primitives that do not depend on the values of attributes.
const FREE_OF_VALUES: [&str; 3] = ["KHR_materials_variants", "EXT_mesh_features", "EXT_structural_metadata"];

/// Extensions of primitives that do not depend on the order of vertices and triangles either. Features may
/// be numbered by vertex.
const FREE_OF_ORDER: [&str; 1] = ["KHR_materials_variants"];

/// Whether the attributes of a primitive may change their values.
pub(super) fn are_free_of_values(extensions: &[String]) -> bool {
    extensions.iter().all(|name| FREE_OF_VALUES.contains(&name.as_str()))
}

/// Whether the vertices and triangles of a primitive may change their order.
pub(super) fn are_free_of_order(extensions: &[String]) -> bool {
    extensions.iter().all(|name| FREE_OF_ORDER.contains(&name.as_str()))
}

/// Declares that a document uses an extension, and cannot be read without it.
pub(super) fn require(root: &mut Value, extension: &str) {
    for key in ["extensionsUsed", "extensionsRequired"] {
        if !entries(root, key).iter().any(|name| name == extension) {
            super::parts::push_entries(root, key, vec![json!(extension)]);
        }
    }
}
