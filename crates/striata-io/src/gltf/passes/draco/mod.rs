//! Compression of primitives with Draco (`KHR_draco_mesh_compression`).
//!
//! Each triangle primitive gets a compressed mesh of its own, with the vertices that its triangles use;
//! strips and fans become single triangles. Positions, normals, tangents, texture coordinates and colors
//! that are floats are quantized; joints, weights and attributes without a standard name are kept exactly.
//! Positions lie on the grid that `quantize` would use, so that parts of a mesh, and meshes that touch, still meet.
//! Encoded primitives are decoded again, because Draco merges and reorders vertices, and accessors must declare what
//! a decoder returns.
//!
//! Primitives stay uncompressed if they have morph targets, which Draco cannot store, extensions that may
//! count vertices, or damaged data, or if compression does not make them smaller.

#[cfg(feature = "draco")]
mod encode;

#[cfg(feature = "draco")]
pub use encode::encode_draco;

use super::parts::GltfParts;
use crate::QuantizeOptions;
use crate::report::Warnings;

/// Compresses a document; without `quantization`, floats are kept exactly.
#[cfg(not(feature = "draco"))]
pub(in crate::gltf) fn draco(_: &mut GltfParts, _: Option<&QuantizeOptions>, _: &mut Warnings) {}

/// Compresses a document; without `quantization`, floats are kept exactly.
#[cfg(feature = "draco")]
pub(in crate::gltf) fn draco(
    parts: &mut GltfParts,
    quantization: Option<&QuantizeOptions>,
    warnings: &mut Warnings,
) {
    use std::collections::{BTreeMap, BTreeSet};

    use serde_json::json;

    use super::additions::{Additions, plain_view};
    use super::compact::compact;
    use super::extensions;
    use super::parts::open;
    use super::primitives::{TRIANGLES, primitives};
    use super::quantize::shared_grids::grids;

    const EXTENSION: &str = "KHR_draco_mesh_compression";

    let snapshot = parts.root.clone();
    let document = open(&snapshot, &parts.binary);
    let mut additions = Additions::new(&snapshot);
    let (mut known, mut replaced) = (BTreeMap::new(), BTreeSet::new());
    let (primitives, are_read) = primitives(&snapshot);
    let grids = quantization.map(|options| grids(&document, &primitives, &are_read, options));
    if let Some(grids) = &grids {
        grids.warn_of_merging(&document, &primitives, warnings);
    }
    for primitive in &primitives {
        let is_free = extensions::are_free_of_order(&primitive.extensions);
        if !primitive.has_triangles() || !primitive.targets.is_empty() || !is_free {
            continue;
        }
        let key = (primitive.attributes.clone(), primitive.indices, primitive.mode);
        let coded = known.entry(key).or_insert_with(|| {
            let cube = grids.as_ref().and_then(|grids| grids.cube(primitive.mesh));
            let coded = encode::coded(&document, primitive, (quantization, cube));
            coded.map(|coded| coded.added_to(&mut additions))
        });
        let Some(value) = parts.root.pointer_mut(&primitive.path()) else { continue };
        let Some(coded) = coded else { continue };
        replaced.extend(primitive.attributes.iter().map(|(_, accessor)| *accessor));
        replaced.extend(primitive.indices);
        value["attributes"] = coded.attributes.clone();
        value["indices"] = json!(coded.indices);
        if value.get("mode").is_some() {
            value["mode"] = json!(TRIANGLES);
        }
        if value.get("extensions").is_none() {
            value["extensions"] = json!({});
        }
        value["extensions"][EXTENSION] = coded.extension.clone();
    }
    let is_used = known.values().any(Option::is_some);
    additions.apply(parts, plain_view);
    if is_used {
        extensions::require(&mut parts.root, EXTENSION);
    }
    compact(parts, &replaced);
}
