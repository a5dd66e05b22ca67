//! Skins of quantized meshes: their inverse bind matrices convert grid steps to lengths first.

use std::collections::BTreeMap;

use glam::DMat4;
use serde_json::{Value, json};

use super::changes::DocumentChanges;
use super::grid::{Grids, MeshGrid};
use crate::gltf::accessor::accessor;
use crate::gltf::component_type::GltfComponentType;
use crate::gltf::document::GltfDocument;
use crate::gltf::passes::additions::ViewKind;
use crate::gltf::passes::elements::Elements;
use crate::gltf::passes::parts::{array_length, entries, entries_mut, index, index_at, push_entries};

/// Node that shows a quantized mesh with a skin.
#[derive(Clone, Copy, Debug)]
pub(super) struct SkinUse {
    pub node: usize,
    pub skin: usize,
    /// Number of the mesh's grid.
    pub grid: usize,
}

/// Returns the inverse bind matrices of a skin, with the conversion applied first.
pub(super) fn matrices(document: &GltfDocument<'_>, skin: usize, grid: &MeshGrid) -> Option<Elements> {
    let skin = entries(document.root.value, "skins").get(skin)?;
    let joint_count = entries(skin, "joints").len();
    let numbers = match skin.get("inverseBindMatrices") {
        Some(value) => {
            let source = accessor(document, index(value)?, &document.root).ok()?;
            let is_fit = source.component == GltfComponentType::F32
                && source.component_count == 16
                && source.count >= joint_count;
            is_fit.then(|| source.floats())?
        }
        None => DMat4::IDENTITY.as_mat4().to_cols_array().repeat(joint_count),
    };
    let convert = grid.matrix();
    let fold = |matrix: &[f32; 16]| {
        (DMat4::from_cols_array(&matrix.map(f64::from)) * convert).as_mat4().to_cols_array()
    };
    let matrices = numbers.as_chunks::<16>().0.iter().flat_map(fold).collect::<Vec<f32>>();
    let is_fit = !matrices.is_empty() && matrices.iter().all(|x| x.is_finite());
    is_fit.then(|| Elements::floats(&matrices, 16))
}

/// Gives each combination of skin and grid its own matrices; skins that serve several are copied.
pub(super) fn apply(
    document: &GltfDocument<'_>,
    grids: &Grids,
    uses: &[SkinUse],
    changes: &mut DocumentChanges<'_>,
) {
    let root = document.root.value;
    let mut use_counts: BTreeMap<usize, usize> = BTreeMap::new();
    for skin in entries(root, "nodes").iter().filter_map(|node| index_at(node, "skin")) {
        *use_counts.entry(skin).or_default() += 1;
    }
    let mut skins: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for &SkinUse { node, skin, grid } in uses {
        let number = match skins.get(&(skin, grid)) {
            Some(&number) => number,
            None => {
                // The first grid may take the skin itself, unless other meshes need it as it is.
                let count = uses.iter().filter(|other| other.skin == skin).count();
                let is_first = !skins.keys().any(|&(other, _)| other == skin);
                let is_free = is_first && use_counts.get(&skin) == Some(&count);
                let Some(number) = grids.grids[grid]
                    .and_then(|grid| matrices(document, skin, &grid))
                    .and_then(|matrices| converted_skin(changes, root, skin, is_free, &matrices))
                else {
                    continue;
                };
                skins.insert((skin, grid), number);
                number
            }
        };
        if let Some(node) = entries_mut(changes.root, "nodes").get_mut(node) {
            node["skin"] = json!(number);
        }
    }
}

/// Sets the matrices of a skin or of a copy of it, and returns its number.
fn converted_skin(
    changes: &mut DocumentChanges<'_>,
    snapshot: &Value,
    skin: usize,
    is_free: bool,
    matrices: &Elements,
) -> Option<usize> {
    let value: &Value = entries(snapshot, "skins").get(skin)?;
    changes.replaced.extend(value.get("inverseBindMatrices").and_then(index));
    let mut value = value.clone();
    let kind = ViewKind::of_others("matrices", matrices);
    let accessor = changes.additions.push(kind, matrices, matrices.accessor());
    value["inverseBindMatrices"] = json!(accessor);
    if is_free {
        *entries_mut(changes.root, "skins").get_mut(skin)? = value;
        return Some(skin);
    }
    let number = array_length(changes.root, "skins");
    push_entries(changes.root, "skins", vec![value]);
    Some(number)
}
