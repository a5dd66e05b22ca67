//! VTK: legacy files (`.vtk`), and XML files with poly data (`.vtp`) or unstructured grids (`.vtu`).
//!
//! Points, triangles, polygons, strips and quadratic surface cells become the mesh; points, lines and cells
//! with a volume are left out with a warning. Data of the points become layers: normals, two texture
//! coordinates (whose origin VTK has at the bottom left), bytes as colors, and everything else under its name.
//!
//! Own reader: `vtkio` does not read the lists of cells that VTK writes since version 9 (file version 5.1),
//! allocates by the counts of the file, and its errors have no place. Cost: one pass; arrays are held in their
//! own type until the mesh is made.

mod array;
mod blocks;
mod cells;
mod grid;
mod legacy;
mod write;
mod xml;

pub(crate) use write::to_bytes;

use striata::mesh::IndexedMesh;

use crate::error::Fault;
use crate::report::Warnings;

/// Reads a mesh from the bytes of a file.
pub(crate) fn read(bytes: &[u8], warnings: &mut Warnings) -> Result<IndexedMesh, Fault> {
    let grid = if bytes.starts_with(legacy::MAGIC) {
        legacy::read(bytes, warnings)?
    } else {
        xml::read(bytes, warnings)?
    };
    grid.into_mesh(warnings)
}
