//! Warnings about parts of a mesh that a format cannot store.

use std::collections::BTreeSet;

use striata::mesh::{AttributeLayer, IndexedMesh};

use crate::Format;
use crate::error::Place;
use crate::report::{Warnings, shortened};

/// Warns about each layer of vertices that is not kept; `lost_data` does so for those of triangles.
pub(crate) fn of_layers(
    mesh: &IndexedMesh,
    format: Format,
    is_kept: impl Fn(&AttributeLayer) -> bool,
    warnings: &mut Warnings,
) {
    for layer in mesh.layers.iter().filter(|layer| !is_kept(layer)) {
        let reason = format!("{format} cannot store the layer {}; it is left out", layer.semantic);
        warnings.push(Place::File, reason);
    }
}

/// Warns about each material in use that says more than its name.
pub(crate) fn of_materials(mesh: &IndexedMesh, format: Format, warnings: &mut Warnings) {
    for material in used_materials(mesh) {
        let Some(known) = mesh.appearance.materials.get(material) else { continue };
        if is_added(known) {
            continue;
        }
        let label = label(material, &known.name);
        warnings.push(Place::File, format!("{format} cannot store the material {label}; it is left out"));
    }
}

#[cfg(feature = "gltf")]
pub(crate) use crate::gltf::is_added;

/// Whether a material is one that the writer of glTF adds: without that format, none is.
#[cfg(not(feature = "gltf"))]
pub(crate) fn is_added(_: &striata::mesh::Material) -> bool {
    false
}

/// Returns the name of a material for messages; its number if it has no name.
pub(crate) fn label(material: usize, name: &str) -> String {
    if name.trim().is_empty() {
        return format!("number {material}, which has no name");
    }
    format!("`{}`", shortened(name))
}

/// Warns about coordinates that single precision rounds, by how much.
pub(crate) fn of_positions(mesh: &IndexedMesh, format: Format, warnings: &mut Warnings) {
    if !mesh.needs_doubles() {
        return;
    }
    let rounding = (0..mesh.vertex_count()).flat_map(|vertex| mesh.file_position(vertex));
    let rounding = rounding.map(|x| (x - f64::from(x as f32)).abs()).fold(0.0, f64::max);
    // As much as single precision keeps near the origin is no loss.
    if rounding > 1e-7 * mesh.diagonal() {
        let reason =
            format!("{format} has single precision; coordinates are rounded by up to {rounding:.3e}");
        warnings.push(Place::File, reason);
    }
}

/// Warns about names of groups.
pub(crate) fn of_group_names(mesh: &IndexedMesh, format: Format, warnings: &mut Warnings) {
    let names: BTreeSet<&str> =
        mesh.groups.iter().map(|group| group.name.as_str()).filter(|name| !name.is_empty()).collect();
    if let Some(first) = names.first() {
        let (count, first) = (names.len(), shortened(first));
        let reason = match count {
            1 => format!("{format} cannot store the group `{first}`; its name is left out"),
            _ => format!("{format} cannot store {count} groups, such as `{first}`; their names are left out"),
        };
        warnings.push(Place::File, reason);
    }
}

/// Returns the indices of the materials that groups with triangles have, in order.
pub(crate) fn used_materials(mesh: &IndexedMesh) -> BTreeSet<usize> {
    let groups = mesh.groups.iter().filter(|group| group.count > 0);
    groups.filter_map(|group| group.material).map(|material| material as usize).collect()
}
