//! Triangles of an OBJ file.

use striata::mesh::{AttributeLayer, LayerData};

use super::shared_vertices::KeyedTriangles;
use crate::ReadError;
use crate::pieces::PieceSource;
use crate::pieces::obj::ObjPieces;
use crate::ply::property_names;

/// Triangles whose corners are identified by the numbers of position, texture coordinate and normal.
pub(super) struct ObjTriangles<'a> {
    pieces: &'a ObjPieces,
}

impl<'a> ObjTriangles<'a> {
    pub(super) fn new(pieces: &'a ObjPieces) -> Self {
        Self { pieces }
    }
}

impl KeyedTriangles for ObjTriangles<'_> {
    fn name(&self) -> &str {
        &self.pieces.summary().name
    }

    fn properties(&self) -> Vec<String> {
        let names = self.pieces.summary().layers.iter().flat_map(|kind| {
            let data = LayerData::F32(Vec::new());
            let (component_count, normalized) = (kind.component_count, kind.normalized);
            property_names(&AttributeLayer {
                semantic: kind.semantic.clone(),
                component_count,
                normalized,
                data,
            })
        });
        names.collect()
    }

    fn for_each(
        &self,
        visit: &mut dyn FnMut([[u32; 3]; 3]) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        self.pieces.for_each_triangle(visit)
    }

    fn push_row(&self, key: [u32; 3], row: &mut Vec<u8>) {
        self.pieces.push_row(key, row);
    }
}
