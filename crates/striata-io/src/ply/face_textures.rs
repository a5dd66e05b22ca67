//! Texture coordinates and texture numbers of faces, as MeshLab and photogrammetry programs write them.
//!
//! ```text
//! comment TextureFile wood.png                 one image for each number
//! property list uchar float texcoord           u and v of each corner
//! property int texnumber                       which image, -1 for none
//! ```
//!
//! A vertex whose corners have different coordinates becomes several vertices, in the order of their first
//! corners. If no vertex has to be split, all stay as they are. An empty list stands for the coordinates of
//! the vertices, or those of other faces at the same vertex.

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};

use crate::wedges::number_wedges;

/// Marks a missing coordinate; a NaN that files cannot contain, because theirs are replaced by another one.
const MISSING: u32 = u32::MAX;

/// A vertex and the bits of its texture coordinates.
type Corner = [u32; 3];

/// Texture data of all faces read so far; both lists may be shorter than the list of triangles.
#[derive(Default)]
pub(crate) struct FaceTextures {
    /// Three corners per triangle.
    corners: Vec<Corner>,
    /// Texture number per triangle; -1 for none.
    numbers: Vec<i64>,
    /// Whether some faces have a property with the number.
    has_numbers: bool,
}

/// Returns the bits of a number; all NaN have the same bits, which are not [`MISSING`].
fn bits(value: f32) -> u32 {
    if value.is_nan() { f32::NAN.to_bits() } else { value.to_bits() }
}

impl FaceTextures {
    /// Notes that faces have a property with the number of a texture.
    pub(super) fn expect_numbers(&mut self) {
        self.has_numbers = true;
    }

    /// Adds missing data for the triangles at the end.
    pub(super) fn pad(&mut self, triangles: &[[u32; 3]]) {
        let missing = triangles[self.numbers.len()..].iter().flatten();
        self.corners.extend(missing.map(|&vertex| [vertex, MISSING, MISSING]));
        self.numbers.resize(triangles.len(), -1);
    }

    /// Adds a triangle of a polygon, given the places of its corners there; there may be no texture coordinates.
    pub(super) fn push(&mut self, polygon: &[u32], places: [usize; 3], texcoords: &[f32], number: i64) {
        let corner = |place: usize| match texcoords.get(2 * place..2 * place + 2) {
            Some(&[u, v]) => [polygon[place], bits(u), bits(v)],
            _ => [polygon[place], MISSING, MISSING],
        };
        self.corners.extend(places.map(corner));
        self.numbers.push(number);
    }

    /// Whether there are no texture data at all.
    pub(crate) fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// Returns the texture number of each triangle, or nothing if the faces have no such property.
    pub(crate) fn numbers(&self) -> &[i64] {
        if self.has_numbers { &self.numbers } else { &[] }
    }

    /// Gives the mesh the coordinates of the corners. All vertex indices must be valid, and there must be
    /// data for all triangles, or for none.
    pub(crate) fn split_vertices(&mut self, mesh: &mut IndexedMesh) {
        let mut corners = std::mem::take(&mut self.corners);
        if corners.iter().all(|corner| corner[1] == MISSING) {
            return;
        }
        let fallback = coordinates_of_vertices(mesh, &corners);
        for corner in corners.iter_mut().filter(|corner| corner[1] == MISSING) {
            [corner[1], corner[2]] = fallback[corner[0] as usize];
        }
        let coordinates = match coordinates_of_whole_vertices(fallback, &corners) {
            Some(coordinates) => coordinates,
            None => split(mesh, &corners),
        };
        let data = coordinates.into_flattened().into_iter().map(f32::from_bits).collect();
        let layer = AttributeLayer::from_f32(Semantic::TexCoord(0), 2, data);
        match mesh.layers.iter_mut().find(|layer| layer.semantic == Semantic::TexCoord(0)) {
            Some(own) => *own = layer,
            None => mesh.layers.push(layer),
        }
    }
}

/// Returns coordinates for the corners that have none: those of the vertex, otherwise those of its first
/// corner, so that it is not split.
fn coordinates_of_vertices(mesh: &IndexedMesh, corners: &[Corner]) -> Vec<[u32; 2]> {
    let own = mesh.layer(&Semantic::TexCoord(0)).filter(|layer| layer.component_count == 2);
    if let Some(layer) = own {
        let of_vertex = |vertex| [0, 1].map(|component| bits(layer.get(vertex, component)));
        return (0..mesh.positions.len()).map(of_vertex).collect();
    }
    let mut out = vec![[0, 0]; mesh.positions.len()];
    for &[vertex, u, v] in corners.iter().rev().filter(|corner| corner[1] != MISSING) {
        out[vertex as usize] = [u, v];
    }
    out
}

/// Returns the coordinates of each vertex, or [`None`] if some vertex has several. Unused vertices keep
/// those in `coordinates`.
fn coordinates_of_whole_vertices(
    mut coordinates: Vec<[u32; 2]>,
    corners: &[Corner],
) -> Option<Vec<[u32; 2]>> {
    let mut is_known = vec![false; coordinates.len()];
    for &[vertex, u, v] in corners {
        let vertex = vertex as usize;
        if !std::mem::replace(&mut is_known[vertex], true) {
            coordinates[vertex] = [u, v];
        } else if coordinates[vertex] != [u, v] {
            return None;
        }
    }
    Some(coordinates)
}

/// Makes a vertex of each distinct corner, and returns the coordinates of the vertices.
fn split(mesh: &mut IndexedMesh, corners: &[Corner]) -> Vec<[u32; 2]> {
    let (vertices, triangles) = number_wedges(mesh.positions.len(), corners);
    let order: Vec<u32> = vertices.iter().map(|vertex| vertex[0]).collect();
    mesh.positions = order.iter().map(|&vertex| mesh.positions[vertex as usize]).collect();
    if !mesh.exact_positions.is_empty() {
        mesh.exact_positions = order.iter().map(|&vertex| mesh.exact_positions[vertex as usize]).collect();
    }
    mesh.layers.iter_mut().for_each(|layer| *layer = layer.gather(&order));
    mesh.triangles = triangles;
    vertices.into_iter().map(|[_, u, v]| [u, v]).collect()
}
