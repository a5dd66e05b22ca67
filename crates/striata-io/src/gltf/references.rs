//! Places of a document that refer to accessors and buffer views.

use std::convert::Infallible;

use serde_json::Value;

/// Kind of entry that a reference refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Referent {
    Accessor(Use),
    View,
}

/// Use of an accessor; accessors of different uses may not share a buffer view.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Use {
    /// Vertex attribute or morph target.
    Vertices,
    /// Indices of a primitive, or of its outline.
    Indices,
    /// Transforms of the instances of a node.
    Instances,
    /// Inverse bind matrices of a skin.
    BindMatrices,
    /// Times or values of an animation.
    Animation,
    /// Collapse targets of vertices, or tables of clusters.
    Targets,
}

/// Receives each reference; it may change them.
pub(super) type Visit<'v, E> = dyn FnMut(Referent, &mut Value) -> Result<(), E> + 'v;

/// Whether a primitive is blended with any of its materials, so that its triangles are drawn over each other in their
/// order.
pub(crate) fn is_blended(document: &Value, primitive: &Value) -> bool {
    let of_material = |material: &Value| {
        let material = document.pointer(&format!("/materials/{material}"));
        material.and_then(|material| material.get("alphaMode")).is_some_and(|mode| mode == "BLEND")
    };
    let variants = primitive.pointer("/extensions/KHR_materials_variants/mappings").and_then(Value::as_array);
    let variants = variants.into_iter().flatten().filter_map(|variant| variant.get("material"));
    primitive.get("material").into_iter().chain(variants).any(of_material)
}

/// Whether a primitive consists of triangles, which levels of detail are built from.
pub(crate) fn has_triangles(primitive: &Value) -> bool {
    let mode = primitive.get("mode").map_or(Some(4), Value::as_u64);
    let has_positions = primitive.get("attributes").is_some_and(|a| a.get("POSITION").is_some());
    has_positions && matches!(mode, Some(4..=6))
}

/// Visits all references but those of accessors to their views.
pub(super) fn for_each(root: &mut Value, mut visit: impl FnMut(Referent, &mut Value)) {
    let mut visit = |referent, value: &mut Value| {
        visit(referent, value);
        Ok::<(), Infallible>(())
    };
    // Nothing can fail.
    let Ok(()) = for_each_carried(root, |_| false, &mut visit);
}

/// Visits all references like [`for_each`], other than those of the triangle primitives of meshes for which
/// `is_geometry` returns true.
pub(super) fn for_each_carried<E>(
    root: &mut Value,
    is_geometry: impl Fn(usize) -> bool,
    visit: &mut Visit<'_, E>,
) -> Result<(), E> {
    for (index, mesh) in entries(root, "meshes").enumerate() {
        if let Some(extension) = mesh.pointer_mut("/extensions/STRIATA_lod") {
            of_member(extension, "bufferView", Referent::View, visit)?;
        }
        for primitive in entries(mesh, "primitives") {
            if !(is_geometry(index) && has_triangles(primitive)) {
                of_primitive(primitive, visit)?;
            }
        }
    }
    for node in entries(root, "nodes") {
        if let Some(instancing) = node.pointer_mut("/extensions/EXT_mesh_gpu_instancing") {
            of_members(instancing.get_mut("attributes"), Use::Instances, visit)?;
        }
    }
    for skin in entries(root, "skins") {
        of_member(skin, "inverseBindMatrices", Referent::Accessor(Use::BindMatrices), visit)?;
    }
    for animation in entries(root, "animations") {
        for sampler in entries(animation, "samplers") {
            of_member(sampler, "input", Referent::Accessor(Use::Animation), visit)?;
            of_member(sampler, "output", Referent::Accessor(Use::Animation), visit)?;
        }
    }
    for image in entries(root, "images") {
        of_member(image, "bufferView", Referent::View, visit)?;
    }
    of_root_extensions(root, visit)
}

/// Visits the references of a primitive.
pub(super) fn of_primitive<E>(primitive: &mut Value, visit: &mut Visit<'_, E>) -> Result<(), E> {
    of_members(primitive.get_mut("attributes"), Use::Vertices, visit)?;
    for target in entries(primitive, "targets") {
        of_members(Some(target), Use::Vertices, visit)?;
    }
    of_member(primitive, "indices", Referent::Accessor(Use::Indices), visit)?;
    for (extension, key, referent) in [
        ("KHR_draco_mesh_compression", "bufferView", Referent::View),
        ("CESIUM_primitive_outline", "indices", Referent::Accessor(Use::Indices)),
        ("STRIATA_clusters", "clusters", Referent::Accessor(Use::Targets)),
        ("STRIATA_clusters", "indices", Referent::Accessor(Use::Indices)),
        ("STRIATA_order", "indices", Referent::Accessor(Use::Indices)),
        ("STRIATA_order", "targets", Referent::Accessor(Use::Targets)),
    ] {
        if let Some(extension) = primitive.pointer_mut(&format!("/extensions/{extension}")) {
            of_member(extension, key, referent, visit)?;
        }
    }
    Ok(())
}

fn of_root_extensions<E>(root: &mut Value, visit: &mut Visit<'_, E>) -> Result<(), E> {
    for (extension, array) in [
        ("EXT_lights_ies", "lights"),
        ("KHR_audio", "audio"),
        ("KHR_audio_emitter", "audio"),
        ("MSFT_audio_emitter", "clips"),
    ] {
        let Some(extension) = root.pointer_mut(&format!("/extensions/{extension}")) else { continue };
        for entry in entries(extension, array) {
            of_member(entry, "bufferView", Referent::View, visit)?;
        }
    }
    let Some(metadata) = root.pointer_mut("/extensions/EXT_structural_metadata") else { return Ok(()) };
    for table in entries(metadata, "propertyTables") {
        let Some(Value::Object(properties)) = table.get_mut("properties") else { continue };
        for property in properties.values_mut() {
            for key in ["values", "arrayOffsets", "stringOffsets"] {
                of_member(property, key, Referent::View, visit)?;
            }
        }
    }
    Ok(())
}

/// Visits the references of an accessor to its views.
pub(super) fn for_each_view(accessor: &mut Value, visit: &mut impl FnMut(&mut Value)) {
    for pointer in ["/bufferView", "/sparse/indices/bufferView", "/sparse/values/bufferView"] {
        if let Some(view) = accessor.pointer_mut(pointer) {
            visit(view);
        }
    }
}

fn of_member<E>(
    object: &mut Value,
    key: &str,
    referent: Referent,
    visit: &mut Visit<'_, E>,
) -> Result<(), E> {
    object.get_mut(key).map_or(Ok(()), |value| visit(referent, value))
}

fn of_members<E>(object: Option<&mut Value>, usage: Use, visit: &mut Visit<'_, E>) -> Result<(), E> {
    let members = object.and_then(Value::as_object_mut).into_iter().flat_map(|map| map.values_mut());
    for value in members {
        visit(Referent::Accessor(usage), value)?;
    }
    Ok(())
}

/// Entries of an array; none if there is no such array.
pub(crate) fn entries<'v>(value: &'v mut Value, key: &str) -> impl Iterator<Item = &'v mut Value> {
    value.get_mut(key).and_then(Value::as_array_mut).into_iter().flatten()
}
