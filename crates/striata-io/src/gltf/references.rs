//! Places of a document that refer to accessors, and extensions known to refer to none.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::gltf_json::extensions_in;

/// What an accessor is used for; accessors of different uses may not share a buffer view.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Use {
    /// Vertex attribute or morph target of points or lines.
    Vertices,
    /// Indices of points or lines.
    Indices,
    /// Transforms of the instances of a node.
    Instances,
    /// Inverse bind matrices of a skin.
    BindMatrices,
    /// Times or values of an animation.
    Animation,
}

/// Extensions that contain no indices of accessors or buffer views, or only ones that are known here.
const WITHOUT_REFERENCES: [&str; 21] = [
    "EXT_lights_image_based",
    "EXT_mesh_features",
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "EXT_texture_avif",
    "EXT_texture_webp",
    "KHR_animation_pointer",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_mesh_quantization",
    "KHR_meshopt_compression",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_node_visibility",
    "KHR_texture_basisu",
    "KHR_texture_procedurals",
    "KHR_texture_transform",
    "KHR_xmp_json_ld",
    "MSFT_lod",
    "MSFT_texture_dds",
    "STRIATA_lod",
];

/// Whether an extension of the document may refer to accessors or buffer views that are not known here.
///
/// Indices must then keep their meaning.
pub(super) fn has_unknown_references(root: &Value) -> bool {
    let mut extensions = BTreeSet::new();
    extensions_in(root, &mut extensions);
    let is_known = |name: &str| WITHOUT_REFERENCES.contains(&name) || name.starts_with("KHR_materials_");
    !extensions.iter().all(|name| is_known(name))
}

/// Whether a primitive consists of triangles, which levels of detail are built from.
pub(crate) fn has_triangles(primitive: &Value) -> bool {
    let mode = primitive.get("mode").map_or(Some(4), Value::as_u64);
    let has_positions = primitive.get("attributes").is_some_and(|a| a.get("POSITION").is_some());
    has_positions && matches!(mode, Some(4..=6))
}

/// Calls `visit` for each reference to an accessor, other than those of meshes for which `is_geometry`
/// returns true and of their triangle primitives.
pub(super) fn for_each_carried<E>(
    root: &mut Value,
    mut is_geometry: impl FnMut(usize) -> bool,
    visit: &mut dyn FnMut(&mut Value, Use) -> Result<(), E>,
) -> Result<(), E> {
    for (index, mesh) in entries(root, "meshes").enumerate() {
        let is_geometry = is_geometry(index);
        for primitive in entries(mesh, "primitives") {
            if !(is_geometry && has_triangles(primitive)) {
                of_primitive(primitive, visit)?;
            }
        }
    }
    for node in entries(root, "nodes") {
        let instancing = node.pointer_mut("/extensions/EXT_mesh_gpu_instancing");
        for accessor in instancing.into_iter().flat_map(|at| members(at, "attributes")) {
            visit(accessor, Use::Instances)?;
        }
    }
    for skin in entries(root, "skins") {
        if let Some(accessor) = skin.get_mut("inverseBindMatrices") {
            visit(accessor, Use::BindMatrices)?;
        }
    }
    for animation in entries(root, "animations") {
        for sampler in entries(animation, "samplers") {
            for key in ["input", "output"] {
                if let Some(accessor) = sampler.get_mut(key) {
                    visit(accessor, Use::Animation)?;
                }
            }
        }
    }
    Ok(())
}

/// Calls `visit` for each reference of a primitive to an accessor.
pub(super) fn of_primitive<E>(
    primitive: &mut Value,
    visit: &mut dyn FnMut(&mut Value, Use) -> Result<(), E>,
) -> Result<(), E> {
    for accessor in members(primitive, "attributes") {
        visit(accessor, Use::Vertices)?;
    }
    for target in entries(primitive, "targets") {
        for accessor in target.as_object_mut().into_iter().flat_map(|map| map.values_mut()) {
            visit(accessor, Use::Vertices)?;
        }
    }
    match primitive.get_mut("indices") {
        Some(accessor) => visit(accessor, Use::Indices),
        None => Ok(()),
    }
}

/// Entries of an array; none if there is no such array.
pub(super) fn entries<'v>(value: &'v mut Value, key: &str) -> impl Iterator<Item = &'v mut Value> {
    value.get_mut(key).and_then(Value::as_array_mut).into_iter().flatten()
}

/// Members of an object; none if there is no such object.
fn members<'v>(value: &'v mut Value, key: &str) -> impl Iterator<Item = &'v mut Value> {
    value.get_mut(key).and_then(Value::as_object_mut).into_iter().flat_map(|map| map.values_mut())
}
