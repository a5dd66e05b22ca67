//! The meaning of attributes, also of those of morph targets.
//!
//! Displacements of positions, normals and tangents have meanings of their own. Those of other attributes
//! (`TEXCOORD_0`, `COLOR_0`, custom ones) are generic layers whose names tell target and attribute.

use striata::mesh::Semantic;

/// Returns the semantic of an attribute other than the positions.
pub(crate) fn semantic(name: &str) -> Semantic {
    let set = |prefix: &str| name.strip_prefix(prefix).and_then(|digits| digits.parse().ok());
    if name == "NORMAL" {
        Semantic::Normal
    } else if name == "TANGENT" {
        Semantic::Tangent
    } else if let Some(set) = set("TEXCOORD_") {
        Semantic::TexCoord(set)
    } else if let Some(set) = set("COLOR_") {
        Semantic::Color(set)
    } else if let Some(set) = set("JOINTS_") {
        Semantic::Joints(set)
    } else if let Some(set) = set("WEIGHTS_") {
        Semantic::Weights(set)
    } else {
        Semantic::Generic(name.strip_prefix('_').unwrap_or(name).to_owned())
    }
}

/// Returns the meaning of an attribute of a morph target.
pub(crate) fn semantic_in_target(target: u16, name: &str) -> Semantic {
    match name {
        "POSITION" => Semantic::MorphPosition(target),
        "NORMAL" => Semantic::MorphNormal(target),
        "TANGENT" => Semantic::MorphTangent(target),
        _ => Semantic::Generic(format!("morph_{target}_{name}")),
    }
}

/// Returns the morph target that a layer belongs to, and the name of its attribute there.
pub(crate) fn target_of(semantic: &Semantic, component_count: u8) -> Option<(u16, &str)> {
    let of_three = |target: &u16, name| (component_count == 3).then_some((*target, name));
    match semantic {
        Semantic::MorphPosition(target) => of_three(target, "POSITION"),
        Semantic::MorphNormal(target) => of_three(target, "NORMAL"),
        Semantic::MorphTangent(target) => of_three(target, "TANGENT"),
        Semantic::Generic(name) => {
            let (target, name) = name.strip_prefix("morph_")?.split_once('_')?;
            let is_attribute = name.starts_with(|c: char| c == '_' || c.is_ascii_uppercase());
            Some((target.parse().ok()?, name)).filter(|_| is_attribute)
        }
        _ => None,
    }
}
