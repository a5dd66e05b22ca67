//! Remarks on data of a mesh that a format cannot store, one for each layer.

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};

use crate::Format;
use crate::Warning;
use crate::error::Place;
use crate::report::{Warnings, shortened};

/// Warns of data of triangles that a file of this format will not contain, and of numbers that it rounds.
pub(crate) fn warn(format: Format, mesh: &IndexedMesh, warnings: &mut Warnings) {
    for layer in &mesh.layers {
        warn_of_gaps(format, layer, warnings);
        if let Some(what) = vertex_loss(format, mesh, layer) {
            warnings.push(Place::File, format!("the property {} of vertices {what}", name_of(layer)));
        }
    }
    for layer in &mesh.triangle_layers {
        if let Some(what) = triangle_loss(format, mesh, layer) {
            warnings.push(Place::File, format!("the property {} of faces {what}", name_of(layer)));
        }
    }
    if !mesh.appearance.georeference.is_empty() && !keeps_georeference(format) {
        warnings.push(Place::File, format!("the georeference {}", left_out(format)));
    }
}

/// Returns a remark on each property of a mesh that a file of this format would not hold as it is; `file` is its
/// name for messages. Writers of meshes say so themselves.
pub fn losses(format: Format, mesh: &IndexedMesh, file: &str) -> Vec<Warning> {
    let mut warnings = Warnings::of_file(file);
    warn(format, mesh, &mut warnings);
    warnings.into_list()
}

/// Returns a remark on each property of the meshes of a scene that a file of this format does not hold as it is; `file` is
/// its name for messages. The writer of 3MF names properties itself.
#[cfg(feature = "gltf")]
pub fn scene_losses(format: Format, scene: &crate::Scene, file: &str) -> Vec<Warning> {
    let mut warnings = Warnings::of_file(file);
    if !matches!(format, Format::Gltf | Format::Glb | Format::Striata | Format::Stream) {
        warn_of_motion(scene, &mut warnings);
    }
    for mesh in scene.meshes().iter().flatten() {
        match format {
            Format::Gltf | Format::Glb => warn(format, mesh, &mut warnings),
            Format::Striata | Format::ThreeMf => {}
            Format::Stream => warn_of_faces(mesh, "the stream of a scene", &mut warnings),
            _ => {
                let medium = "a scene that becomes one mesh";
                for layer in mesh.layers.iter().filter(|layer| crate::gltf::is_unstorable(mesh, layer)) {
                    let name = name_of(layer);
                    let reason =
                        format!("the property {name} of vertices is left out: {medium} cannot have it");
                    warnings.push(Place::File, reason);
                }
                warn_of_faces(mesh, medium, &mut warnings);
            }
        }
    }
    warnings.into_list()
}

/// Warns of what moves a scene: a mesh has only the pose in which it is stored.
#[cfg(feature = "gltf")]
fn warn_of_motion(scene: &crate::Scene, warnings: &mut Warnings) {
    let layers = scene.meshes().iter().flatten().flat_map(|mesh| &mesh.layers);
    let targets = layers.filter(|layer| matches!(layer.semantic, Semantic::MorphPosition(_))).count();
    warn_of_motion_in(scene.document(), targets, warnings);
}

/// Warns of the animations and skins of a glTF document and of this many morph targets, which a mesh cannot have.
#[cfg(feature = "gltf")]
pub(crate) fn warn_of_motion_in(document: &serde_json::Value, targets: usize, warnings: &mut Warnings) {
    let count = |key: &str| document.get(key).and_then(|list| list.as_array()).map_or(0, Vec::len);
    for (count, one, many) in [
        (count("animations"), "animation is", "animations are"),
        (count("skins"), "skin is", "skins are"),
        (targets, "morph target is", "morph targets are"),
    ] {
        if count > 0 {
            let what = if count == 1 { one } else { many };
            warnings.push(Place::File, format!("{count} {what} left out: the mesh keeps its rest pose"));
        }
    }
}

#[cfg(feature = "gltf")]
fn warn_of_faces(mesh: &IndexedMesh, medium: &str, warnings: &mut Warnings) {
    for layer in &mesh.triangle_layers {
        let reason = format!("the property {} of faces is left out: {medium} cannot have it", name_of(layer));
        warnings.push(Place::File, reason);
    }
}

/// Returns a remark on the names of groups, which [`Scene::from_mesh`](crate::Scene::from_mesh) does not keep; `file`
/// is the name of the file for messages.
#[cfg(feature = "gltf")]
pub fn lost_group_names(mesh: &IndexedMesh, file: &str) -> Vec<Warning> {
    let mut names: Vec<&str> = mesh.groups.iter().map(|group| group.name.as_str()).collect();
    names.retain(|name| !name.is_empty());
    names.sort_unstable();
    names.dedup();
    let mut warnings = Warnings::of_file(file);
    if let Some(first) = names.first() {
        let (count, first) = (names.len(), shortened(first));
        let what = match count {
            1 => format!("the name of the group `{first}` is left out"),
            _ => format!("the names of {count} groups, such as `{first}`, are left out"),
        };
        warnings.push(Place::File, format!("{what}: scenes have materials only"));
    }
    warnings.into_list()
}

/// Name for messages: that of the file for layers without a meaning of their own.
pub(crate) fn name_of(layer: &AttributeLayer) -> String {
    match &layer.semantic {
        Semantic::Generic(name) => format!("`{name}`"),
        semantic => semantic.to_string(),
    }
}

/// Warns of values that are no numbers, where they may be and the format has no place for them.
fn warn_of_gaps(format: Format, layer: &AttributeLayer, warnings: &mut Warnings) {
    let is_generic = matches!(layer.semantic, Semantic::Generic(_));
    if !is_generic || !matches!(format, Format::Gltf | Format::Glb) {
        return;
    }
    let is_gap = |index: &usize| !layer.data.number(*index).is_finite();
    let count = match &layer.data {
        LayerData::F32(_) | LayerData::F64(_) => (0..layer.data.len()).filter(is_gap).count(),
        _ => 0,
    };
    if count > 0 {
        let reason = format!(
            "the property {} of vertices has values that are not finite, which {format} cannot store; they \
             are written as 0",
            name_of(layer)
        );
        warnings.push(Place::File, reason);
    }
}

/// Whether files of this format say where on the Earth a terrain is.
fn keeps_georeference(format: Format) -> bool {
    use Format::{Glb, Gltf, Obj, Ply, Stream, Striata};
    matches!(format, Ply | Obj | Gltf | Glb | Striata | Stream)
}

fn left_out(format: Format) -> String {
    format!("is left out: {format} cannot store it")
}

/// Returns the loss of a layer of vertices in words, besides those that writers leave out themselves.
fn vertex_loss(format: Format, mesh: &IndexedMesh, layer: &AttributeLayer) -> Option<String> {
    #[cfg(feature = "gltf")]
    if matches!(format, Format::Gltf | Format::Glb) && crate::gltf::is_unstorable(mesh, layer) {
        return Some(left_out(format));
    }
    let LayerData::F64(values) = &layer.data else { return None };
    let is_single = matches!(format, Format::Gltf | Format::Glb);
    let is_rounded = |x: &f64| f64::from(*x as f32) != *x && !x.is_nan();
    (is_single && values.iter().any(is_rounded))
        .then(|| format!("is rounded to single precision in {format}"))
}

fn triangle_loss(format: Format, mesh: &IndexedMesh, layer: &AttributeLayer) -> Option<String> {
    let is_color = layer.semantic == Semantic::Color(0) && matches!(layer.component_count, 3 | 4);
    match format {
        Format::Ply | Format::Striata | Format::Stream => None,
        Format::Vtk | Format::Vtp | Format::Vtu => None,
        Format::Off if is_color => None,
        #[cfg(feature = "stl")]
        Format::Stl => match crate::stl::is_exact(mesh, layer) {
            Some(true) => None,
            Some(false) => Some("is rounded to 5 bits per channel, without alpha".to_owned()),
            None => Some(left_out(format)),
        },
        _ => Some(left_out(format)),
    }
}
