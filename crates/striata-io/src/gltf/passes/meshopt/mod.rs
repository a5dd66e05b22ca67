//! Compression of buffer views with meshoptimizer (`EXT_meshopt_compression`).
//!
//! Compressed are the attributes, morph targets and indices of triangle primitives, the data of animations,
//! inverse bind matrices and the transforms of instances. Accessors keep their numbers and only move to
//! other views, so everything that refers to them still finds them. Accessors of one kind share a view.
//!
//! `order` first sorts triangles and vertices, because the codecs store differences of neighbors.
//! Everything is kept exactly but normals, tangents and rotations: small integers pass through the octahedral filter
//! or that of quaternions, which round them once more. Floats that are multiples of a power of two, such as texture coordinates
//! after `quantize`, are stored as integers by the exponential filter, which is exact for them.
//!
//! Version 0 of the vertex codec and version 1 of the index codecs are what the extension defines.

#[cfg(feature = "meshopt")]
mod codec;
#[cfg(feature = "meshopt")]
mod order;
#[cfg(feature = "meshopt")]
mod roles;

use super::parts::GltfParts;
use crate::QuantizeOptions;

/// Compresses a document; `quantization` says how normals were quantized before.
#[cfg(not(feature = "meshopt"))]
pub(in crate::gltf) fn meshopt(_: &mut GltfParts, _: Option<&QuantizeOptions>) {}

/// Compresses a document; `quantization` says how normals were quantized before.
#[cfg(feature = "meshopt")]
pub(in crate::gltf) fn meshopt(parts: &mut GltfParts, quantization: Option<&QuantizeOptions>) {
    use super::additions::Additions;
    use super::compact::compact;
    use super::extensions;
    use super::parts::open;
    use super::primitives::primitives;

    let snapshot = parts.root.clone();
    let document = open(&snapshot, &parts.binary);
    let (primitives, _) = primitives(&snapshot);
    let roles = roles::roles(&snapshot, &primitives);
    let order = order::order(&document, &primitives, &roles);
    let mut additions = Additions::new(&snapshot);
    for (&accessor, role) in &roles {
        if let Some(role) = role {
            codec::move_accessor(
                &document,
                codec::RoledAccessor { index: accessor, role },
                &order,
                &mut parts.root,
                &mut additions,
            );
        }
    }
    let mut fallback = codec::Fallback::new(&snapshot, quantization);
    additions.apply(parts, |parts, shelf| fallback.view(parts, shelf));
    if fallback.bytes > 0 {
        fallback.declare(&mut parts.root);
        extensions::require(&mut parts.root, codec::EXTENSION);
    }
    compact(parts, &std::collections::BTreeSet::new());
}
