//! Conversion of corners with three indices each to vertices with one.

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};

use crate::normals;
use crate::wedges::number_wedges;

/// Marks a missing texture coordinate or normal.
pub(super) const NONE: u32 = u32::MAX;

/// Position, texture coordinate and normal indices of a corner; the last two may be [`NONE`].
pub(super) type Corner = [u32; 3];

/// Values of the `v`, `vt` and `vn` statements.
#[derive(Default)]
pub(super) struct CornerTables {
    pub positions: Vec<[f32; 3]>,
    /// The positions in doubles, if single precision does not keep all digits; otherwise empty.
    pub file_positions: Vec<[f64; 3]>,
    /// Three values per position, up to the last position that has a color; empty if none has.
    pub colors: Vec<f32>,
    pub texcoords: Vec<[f32; 2]>,
    pub normals: Vec<[f32; 3]>,
}

/// Builds the mesh; every index other than [`NONE`] must be valid.
pub(super) fn assemble(mut tables: CornerTables, corners: &[Corner]) -> IndexedMesh {
    if !tables.colors.is_empty() {
        tables.colors.resize(tables.positions.len() * 3, 1.0);
    }
    let has = |kind: usize| corners.iter().any(|c| c[kind] != NONE);
    let (has_texcoord, has_normal) = (has(1), has(2));
    if has_common_indices(&tables, corners, [has_texcoord, has_normal]) {
        return in_file_order(tables, corners, [has_texcoord, has_normal]);
    }
    let (vertices, triangles) = number_wedges(tables.positions.len(), corners);
    let positions: Vec<[f32; 3]> = vertices.iter().map(|v| tables.positions[v[0] as usize]).collect();
    let mut mesh = IndexedMesh::new(positions, triangles);
    if !tables.file_positions.is_empty() {
        mesh.set_file_positions(vertices.iter().map(|v| tables.file_positions[v[0] as usize]).collect());
    }
    let mut layers = Vec::new();
    if has_normal {
        let normals = normals_of(&tables, &vertices, &mesh.positions, &mesh.triangles);
        layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    }
    if has_texcoord {
        let texcoord = |v: &Corner| tables.texcoords.get(v[1] as usize).copied().unwrap_or([0.0; 2]);
        let texcoords = vertices.iter().flat_map(texcoord).collect();
        layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords));
    }
    if !tables.colors.is_empty() {
        let colors =
            vertices.iter().flat_map(|v| &tables.colors[v[0] as usize * 3..][..3]).copied().collect();
        layers.push(AttributeLayer::from_f32(Semantic::Color(0), 3, colors));
    }
    IndexedMesh { layers, ..mesh }
}

/// Whether all three indices of every corner agree, as far as texture coordinates and normals are used at
/// all.
fn has_common_indices(tables: &CornerTables, corners: &[Corner], used: [bool; 2]) -> bool {
    let count = tables.positions.len();
    (!used[0] || tables.texcoords.len() == count)
        && (!used[1] || tables.normals.len() == count)
        && corners.iter().all(|c| (!used[0] || c[1] == c[0]) && (!used[1] || c[2] == c[0]))
}

fn in_file_order(
    tables: CornerTables,
    corners: &[Corner],
    [has_texcoord, has_normal]: [bool; 2],
) -> IndexedMesh {
    let mut layers = Vec::new();
    if has_normal {
        layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, tables.normals.into_flattened()));
    }
    if has_texcoord {
        layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, tables.texcoords.into_flattened()));
    }
    if !tables.colors.is_empty() {
        layers.push(AttributeLayer::from_f32(Semantic::Color(0), 3, tables.colors));
    }
    let triangles = corners.chunks_exact(3).map(|t| [t[0][0], t[1][0], t[2][0]]).collect();
    let mut mesh = IndexedMesh { layers, ..IndexedMesh::new(tables.positions, triangles) };
    if !tables.file_positions.is_empty() {
        mesh.set_file_positions(tables.file_positions);
    }
    mesh
}

/// Returns the normals of the vertices; a corner without one gets the normal of its triangles.
fn normals_of(
    tables: &CornerTables,
    vertices: &[Corner],
    positions: &[[f32; 3]],
    triangles: &[[u32; 3]],
) -> Vec<f32> {
    let computed = if vertices.iter().any(|v| v[2] == NONE) {
        normals::of_vertices(positions, triangles, 0..positions.len())
    } else {
        Vec::new()
    };
    let normal = |(index, v): (usize, &Corner)| {
        if v[2] == NONE { computed[index] } else { tables.normals[v[2] as usize] }
    };
    vertices.iter().enumerate().flat_map(normal).collect()
}
