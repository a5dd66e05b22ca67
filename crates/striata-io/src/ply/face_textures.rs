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

use super::body::{Faces, list_length, read_index, skip_property};
use super::header::Element;
use super::rows::Rows;
use crate::error::Fault;
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

/// Indices of the properties of a face that describe its texture.
#[derive(Clone, Copy)]
pub(crate) struct TextureProperties {
    texcoord: Option<usize>,
    number: Option<usize>,
}

impl TextureProperties {
    /// Finds the properties; [`None`] if there are none. Numbers of no textures are not among them.
    pub(crate) fn of(element: &Element, has_no_textures: bool) -> Option<Self> {
        let find = |name: &str, is_list: bool| {
            element.properties.iter().position(|p| p.name == name && p.list.is_some() == is_list)
        };
        let texcoord = find("texcoord", true);
        let number = find("texnumber", false).filter(|_| !has_no_textures);
        (texcoord.is_some() || number.is_some()).then_some(Self { texcoord, number })
    }

    /// Reads all rows of a face element; `indices` is the property with the vertices.
    pub(crate) fn read_faces<'a, R: Rows<'a>>(
        self,
        element: &Element,
        indices: usize,
        rows: &mut R,
        faces: &mut Faces,
    ) -> Result<(), Fault> {
        faces.pad_textures();
        faces.textures.has_numbers |= self.number.is_some();
        let (mut polygon, mut texcoords): (Vec<u32>, Vec<f32>) = (Vec::new(), Vec::new());
        let mut row = Vec::new();
        for _ in 0..element.count {
            polygon.clear();
            texcoords.clear();
            row.clear();
            let (mut number, mut mark) = (-1, 0);
            for (place, property) in element.properties.iter().enumerate() {
                match property.list {
                    Some(length) if place == indices => {
                        for _ in 0..list_length(length, rows)? {
                            polygon.push(read_index(property.scalar, rows, faces)?);
                        }
                    }
                    Some(length) if Some(place) == self.texcoord => {
                        let length = list_length(length, rows)?;
                        mark = rows.mark();
                        for index in 0..length {
                            // `v` counts from the bottom of the image.
                            let is_v = index % 2 == 1;
                            let scalar = property.scalar;
                            let read = if is_v { rows.one_minus(scalar) } else { rows.float(scalar) };
                            texcoords.push(read?);
                        }
                    }
                    None if Some(place) == self.number => number = rows.integer(property.scalar)?,
                    None if faces.data.is_open() => rows.copy(property.scalar, &mut row)?,
                    _ => skip_property(property, rows)?,
                }
            }
            if !texcoords.is_empty() && texcoords.len() != 2 * polygon.len() {
                let (corners, found) = (polygon.len(), texcoords.len());
                let reason =
                    format!("`texcoord` has {found} numbers for {corners} corners; expected {}", 2 * corners);
                return Err(R::fault_at(mark, reason));
            }
            faces.push_textured(&polygon, &texcoords, number);
            faces.data.push(&row, polygon.len().saturating_sub(2));
        }
        Ok(())
    }
}

impl Faces {
    /// Adds missing texture data for the triangles at the end.
    pub(crate) fn pad_textures(&mut self) {
        let known = self.textures.numbers.len();
        let missing = self.triangles[known..].iter().flatten().map(|&vertex| [vertex, MISSING, MISSING]);
        self.textures.corners.extend(missing);
        self.textures.numbers.resize(self.triangles.len(), -1);
    }

    /// Adds a polygon as a fan; there may be no texture coordinates.
    fn push_textured(&mut self, polygon: &[u32], texcoords: &[f32], number: i64) {
        let corner = |index: usize| match texcoords.get(2 * index..2 * index + 2) {
            Some(&[u, v]) => [polygon[index], bits(u), bits(v)],
            _ => [polygon[index], MISSING, MISSING],
        };
        for last in 2..polygon.len() {
            self.triangles.push([polygon[0], polygon[last - 1], polygon[last]]);
            self.textures.corners.extend([corner(0), corner(last - 1), corner(last)]);
            self.textures.numbers.push(number);
        }
    }
}

/// Returns the bits of a number; all NaN have the same bits, which are not [`MISSING`].
fn bits(value: f32) -> u32 {
    if value.is_nan() { f32::NAN.to_bits() } else { value.to_bits() }
}

impl FaceTextures {
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
