//! Writing: a plain glTF file at full detail with the extension `STRIATA_order`.

use std::borrow::Cow;

use serde_json::Value;
use striata_io::WriteError;

use super::{OrderedMesh, OrderedPrimitive};
use crate::extended_glb::{ExtendedGlb, ExtendedPrimitive};
use crate::lod_scene::LodScene;

/// Name of the extension.
pub const ORDER_EXTENSION: &str = "STRIATA_order";

/// A GLB file with the extension `STRIATA_order`, and what is in it.
#[derive(Clone, Debug, PartialEq)]
pub struct OrderedGlb {
    /// The file.
    pub bytes: Vec<u8>,
    /// Size of the file without the extension.
    pub plain_bytes: usize,
    /// Bytes of the targets and the tables of levels.
    pub order_bytes: usize,
    /// Bytes of the index ranges; 0 without any.
    pub range_bytes: usize,
    /// Meshes of the document, as [`LodScene::ordered`] makes them.
    pub meshes: Vec<Option<OrderedMesh>>,
}

impl LodScene {
    /// Encodes the full scene as a GLB file that any viewer opens, and from which ten lines of code make every level:
    /// the vertices of each mesh are in refinement order, and the extension `STRIATA_order` of each triangle primitive has
    /// the targets of the vertices, a table of levels and, if `range_count` is not 0, that many index ranges.
    ///
    /// Primitives without triangles of any area are left out; points and lines stay as they are.
    ///
    /// # Errors
    /// [`WriteError`] if a mesh contains numbers that glTF cannot store, or the file would be larger than 4 GiB.
    pub fn to_ordered_glb(&self, range_count: usize) -> Result<OrderedGlb, WriteError> {
        let meshes = self.ordered(range_count);
        let bytes = self.glb_of(&meshes, OrderContents::Ranges)?;
        let plain_bytes = self.glb_of(&meshes, OrderContents::Plain)?.len();
        let ordered =
            if range_count == 0 { bytes.len() } else { self.glb_of(&meshes, OrderContents::Order)?.len() };
        Ok(OrderedGlb {
            plain_bytes,
            order_bytes: ordered - plain_bytes,
            range_bytes: bytes.len() - ordered,
            bytes,
            meshes,
        })
    }

    fn glb_of(&self, meshes: &[Option<OrderedMesh>], contents: OrderContents) -> Result<Vec<u8>, WriteError> {
        let mut file = ExtendedGlb::new(self.scene(), ORDER_EXTENSION);
        for (index, mesh) in meshes.iter().enumerate() {
            if let Some(ordered) = mesh {
                let groups = ordered.mesh.groups_or_whole();
                let primitives = ordered.primitives.iter().zip(&groups).map(|(levels, group)| {
                    extended(levels, &ordered.mesh.triangles[group.range()], &ordered.targets, contents)
                });
                file.put_mesh(index, &ordered.mesh, primitives.collect());
            }
        }
        file.into_glb()
    }
}

/// A primitive with the parts of the extension that are written.
fn extended<'m>(
    levels: &'m OrderedPrimitive,
    full: &'m [[u32; 3]],
    targets: &'m [u32],
    contents: OrderContents,
) -> ExtendedPrimitive<'m> {
    let has_ranges = contents == OrderContents::Ranges && !levels.ranges.is_empty();
    let mut extension = levels.to_json();
    if has_ranges {
        extension["indices"] = Value::Null;
    } else if let Some(members) = extension.as_object_mut() {
        members.remove("ranges");
    }
    ExtendedPrimitive {
        triangles: Cow::Borrowed(if has_ranges { levels.indices.as_chunks().0 } else { full }),
        shown: full.len(),
        extension: (contents != OrderContents::Plain).then_some(extension),
        numbers: vec![("targets", Cow::Borrowed(targets))],
    }
}

/// Parts of the extension that are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum OrderContents {
    Plain,
    Order,
    Ranges,
}
