//! Primitives of a document, as the passes need them.

use serde_json::Value;

use super::parts::{entries, index};
use crate::gltf::references::is_blended;

pub(super) const TRIANGLES: u64 = 4;

/// Primitive whose references are well-formed; what they refer to is unchecked.
#[derive(Clone, Debug)]
pub(super) struct PassPrimitive {
    pub mesh: usize,
    /// Place among the primitives of the mesh.
    pub place: usize,
    pub mode: u64,
    /// Names and accessors.
    pub attributes: Vec<(String, u64)>,
    pub indices: Option<u64>,
    /// Names and accessors of each morph target.
    pub targets: Vec<Vec<(String, u64)>>,
    /// Names of the primitive's extensions.
    pub extensions: Vec<String>,
    /// Whether the order of its triangles is that in which they are drawn over each other.
    pub is_blended: bool,
}

impl PassPrimitive {
    /// Whether the primitive draws triangles.
    pub(super) fn has_triangles(&self) -> bool {
        (4..=6).contains(&self.mode)
    }

    /// Returns the accessor of an attribute.
    pub(super) fn attribute(&self, name: &str) -> Option<u64> {
        self.attributes.iter().find(|(own, _)| own == name).map(|&(_, accessor)| accessor)
    }

    /// Returns the accessors of all attributes and morph targets.
    pub(super) fn vertex_accessors(&self) -> impl Iterator<Item = u64> {
        self.attributes.iter().chain(self.targets.iter().flatten()).map(|&(_, accessor)| accessor)
    }

    /// Returns the path of the primitive in the document.
    pub(super) fn path(&self) -> String {
        format!("/meshes/{}/primitives/{}", self.mesh, self.place)
    }
}

/// Returns all primitives; the second list says for each mesh whether all of its primitives could be read.
pub(super) fn primitives(root: &Value) -> (Vec<PassPrimitive>, Vec<bool>) {
    let (mut found, mut are_read) = (Vec::new(), Vec::new());
    for (mesh, value) in entries(root, "meshes").iter().enumerate() {
        let list = entries(value, "primitives");
        let parse = |(place, primitive)| {
            let is_blended = is_blended(root, primitive);
            Some(PassPrimitive { is_blended, ..parse(primitive, mesh, place)? })
        };
        let parsed: Vec<Option<PassPrimitive>> = list.iter().enumerate().map(parse).collect();
        are_read.push(parsed.iter().all(Option::is_some));
        found.extend(parsed.into_iter().flatten());
    }
    (found, are_read)
}

fn parse(value: &Value, mesh: usize, place: usize) -> Option<PassPrimitive> {
    let optional = |key: &str| match value.get(key) {
        None => Some(None),
        Some(member) => index(member).map(Some),
    };
    let targets = match value.get("targets") {
        None => Vec::new(),
        Some(targets) => targets.as_array()?.iter().map(named_accessors).collect::<Option<_>>()?,
    };
    let extensions = match value.get("extensions") {
        None => Vec::new(),
        Some(extensions) => extensions.as_object()?.keys().cloned().collect(),
    };
    Some(PassPrimitive {
        mesh,
        place,
        mode: optional("mode")?.unwrap_or(TRIANGLES),
        attributes: named_accessors(value.get("attributes")?)?,
        indices: optional("indices")?,
        targets,
        extensions,
        is_blended: false,
    })
}

fn named_accessors(value: &Value) -> Option<Vec<(String, u64)>> {
    let named = |(name, accessor): (&String, &Value)| Some((name.clone(), index(accessor)?));
    value.as_object()?.iter().map(named).collect()
}
