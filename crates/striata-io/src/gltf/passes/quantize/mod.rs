//! Quantization: attributes become small integers (`KHR_mesh_quantization`).
//!
//! Positions lie on a grid with cubic cells. All primitives of a mesh share a grid, and so do meshes that
//! share vertices or touch (`shared_grids`), so that no cracks appear. The scene converts grid steps back to
//! lengths: see `placement`. Points and lines of such a mesh get positions on its grid too, since they are shown by the
//! same node; apart from that, primitives without triangles stay as they are.
//!
//! The error of a coordinate is at most half a grid step, that is, half of the longest side of the
//! bounding box divided by 2^bits - 1; twice as much if a mesh touches a larger one that has no bits to spare.
//! Normals, tangents, colors and weights become normalized integers, and so do texture coordinates from 0 to 1.
//! Others remain floats, rounded to multiples of 2^-bits, which `meshopt` compresses as integers. That takes a quarter fewer bytes than fractions of 65535, so it is the
//! rule for all texture coordinates if `meshopt` follows. The alternative, integers with a texture
//! transform (`KHR_texture_transform`), would change materials, which other meshes and animations use.
//!
//! Draco's primitives, and meshes with extensions that may depend on coordinates, stay as they are.

mod animations;
mod attributes;
mod changes;
mod convert;
mod grid;
mod placement;
pub(super) mod shared_grids;
mod skins;
mod transforms;

use std::collections::BTreeSet;

use self::attributes::AttributeQuantizer;
use self::changes::DocumentChanges;
pub(in crate::gltf) use self::changes::Texcoords;
use super::additions::{Additions, plain_view};
use super::compact::compact;
use super::extensions;
use super::parts::{GltfParts, open};
use super::primitives::primitives;
use crate::QuantizeOptions;
use crate::report::Warnings;

const EXTENSION: &str = "KHR_mesh_quantization";

/// Quantizes the meshes of a document.
pub(in crate::gltf) fn quantize(
    parts: &mut GltfParts,
    options: &QuantizeOptions,
    texcoords: Texcoords,
    warnings: &mut Warnings,
) {
    let snapshot = parts.root.clone();
    let document = open(&snapshot, &parts.binary);
    let (primitives, are_read) = primitives(&snapshot);
    let additions = Additions::new(&snapshot);
    let mut changes = DocumentChanges {
        root: &mut parts.root,
        additions,
        replaced: BTreeSet::new(),
        needs_extension: false,
    };
    let mut grids = shared_grids::grids(&document, &primitives, &are_read, options);
    let placements = placement::placements(&document, &mut grids);
    grids.warn_of_merging(&document, &primitives, warnings);
    let mut attributes = AttributeQuantizer::new(&document, &grids, options, texcoords, &mut changes);
    primitives.iter().for_each(|primitive| attributes.quantize(primitive));
    animations::quantize(&document, options, texcoords, &mut changes);
    placement::apply(&document, &grids, placements, &mut changes);
    let DocumentChanges { additions, replaced, needs_extension, .. } = changes;
    additions.apply(parts, plain_view);
    if needs_extension {
        extensions::require(&mut parts.root, EXTENSION);
    }
    compact(parts, &replaced);
}
