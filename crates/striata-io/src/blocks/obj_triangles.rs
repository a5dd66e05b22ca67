//! Triangles of an OBJ file.

use super::shared_vertices::{KeyedTriangle, KeyedTriangles};
use crate::ReadError;
use crate::pieces::obj::ObjPieces;
use crate::pieces::{PieceSource as _, PieceSummary};

/// Triangles whose corners are identified by the numbers of position, texture coordinate and normal.
pub(super) struct ObjTriangles<'a>(pub(super) &'a ObjPieces);

impl KeyedTriangles for ObjTriangles<'_> {
    fn summary(&self) -> &PieceSummary {
        self.0.summary()
    }

    fn for_each(
        &self,
        visit: &mut dyn FnMut(&KeyedTriangle<'_>) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        self.0.for_each_triangle(|keys| {
            visit(&KeyedTriangle { keys, push_row: &|k, row| self.0.push_row(keys[k], row) })
        })
    }
}
