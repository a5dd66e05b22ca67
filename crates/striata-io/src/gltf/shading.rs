//! Normals and a material for meshes that come without, so that they look well in viewers.
//!
//! Without normals, a glTF mesh has flat facets, and without a material, it is a white metal. Normals are the
//! area-weighted means of the triangles around a corner, up to creases: edges whose triangles form an angle of
//! more than [`CREASE`], and edges that do not have two triangles. A vertex at a crease is divided.

use std::borrow::Cow;

use serde_json::json;
use striata::mesh::{AttributeLayer, IndexedMesh, Material, Semantic, TriangleGroup, index_positions};

use crate::normals::{of_triangle, unit};

/// Largest angle of two triangles that belong to one smooth surface, degrees.
const CREASE: f64 = 50.0;

/// Returns the mesh with normals, if it has none, and with a material, if it has none.
pub(super) fn shaded(mesh: &IndexedMesh) -> Cow<'_, IndexedMesh> {
    let has_normals = mesh.layers.iter().any(|layer| layer.semantic == Semantic::Normal);
    let has_materials = !mesh.appearance.materials.is_empty();
    if mesh.triangles.is_empty() || has_normals && has_materials {
        return Cow::Borrowed(mesh);
    }
    let mut is_closed = false;
    let mut out = match PositionEdges::of(mesh) {
        Some(edges) => {
            is_closed = edges.is_closed;
            if has_normals { mesh.clone() } else { with_normals(mesh, &edges) }
        }
        None => mesh.clone(),
    };
    if !has_materials {
        add_material(&mut out, is_closed);
    }
    Cow::Owned(out)
}

/// Light that a mesh without colors reflects: a white one loses its shading under the lights of most viewers.
const GRAY: f64 = 0.5;

/// Gives all triangles a matte material; the inner side of an open surface is shown too.
fn add_material(mesh: &mut IndexedMesh, is_closed: bool) {
    let mut material = json!({ "pbrMetallicRoughness": { "metallicFactor": 0.0, "roughnessFactor": 0.9 } });
    if mesh.layer(&Semantic::Color(0)).is_none() {
        material["pbrMetallicRoughness"]["baseColorFactor"] = json!([GRAY, GRAY, GRAY, 1.0]);
    }
    if !is_closed {
        material["doubleSided"] = json!(true);
    }
    mesh.appearance.materials = vec![Material { name: String::new(), gltf_json: material.to_string() }];
    if mesh.groups.is_empty() {
        let (first, count) = (0, mesh.triangles.len() as u32);
        mesh.groups = vec![TriangleGroup { name: String::new(), material: None, first, count }];
    }
    mesh.groups.iter_mut().for_each(|group| group.material = Some(0));
}

/// Edges of a mesh between positions.
struct PositionEdges {
    /// Sides of triangles, sorted: the ends of the edge as positions, the lower first, and the corner where it
    /// begins.
    sides: Vec<([u32; 2], u32)>,
    /// Position of each vertex.
    position_of: Vec<u32>,
    is_closed: bool,
}

impl PositionEdges {
    /// [`None`] if the mesh is inconsistent, which the writer reports.
    fn of(mesh: &IndexedMesh) -> Option<Self> {
        mesh.check().ok()?;
        let position_of = index_positions(&mesh.positions);
        let position = |corner: u32| position_of[mesh.triangles.as_flattened()[corner as usize] as usize];
        let mut sides = Vec::with_capacity(3 * mesh.triangles.len());
        for corner in 0..3 * mesh.triangles.len() as u32 {
            let (a, b) = (position(corner), position(next(corner)));
            if a != b {
                sides.push(([a.min(b), a.max(b)], corner));
            }
        }
        sides.sort_unstable();
        let is_closed = sides.chunk_by(|a, b| a.0 == b.0).all(|edge| edge.len() == 2);
        Some(Self { sides, position_of, is_closed })
    }
}

/// The next corner of the same triangle.
fn next(corner: u32) -> u32 {
    if corner % 3 == 2 { corner - 2 } else { corner + 1 }
}

fn with_normals(mesh: &IndexedMesh, edges: &PositionEdges) -> IndexedMesh {
    let corners = mesh.triangles.as_flattened();
    let normals: Vec<[f32; 3]> = mesh.triangles.iter().map(|&t| of_triangle(&mesh.positions, t)).collect();
    let mut smooth = CornerSets((0..corners.len() as u32).collect());
    let least_cosine = CREASE.to_radians().cos() as f32;
    for edge in edges.sides.chunk_by(|a, b| a.0 == b.0) {
        let &[(_, a), (_, b)] = edge else { continue };
        let [m, n] = [a, b].map(|corner| normals[corner as usize / 3]);
        let is_smooth = m[0] * n[0] + m[1] * n[1] + m[2] * n[2] >= least_cosine;
        // Two triangles that face the same way run along their edge in opposite directions.
        let begin = [a, b].map(|corner| edges.position_of[corners[corner as usize] as usize]);
        if is_smooth && begin[0] != begin[1] {
            smooth.join(a, next(b));
            smooth.join(next(a), b);
        }
    }
    let mut sums = vec![[0.0f64; 3]; corners.len()];
    for (number, triangle) in mesh.triangles.iter().enumerate() {
        let [p, q, r] = triangle.map(|v| mesh.positions[v as usize].map(f64::from));
        let (u, v) = ([0, 1, 2].map(|k| q[k] - p[k]), [0, 1, 2].map(|k| r[k] - p[k]));
        let area = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        for corner in 3 * number..3 * number + 3 {
            let sum = &mut sums[smooth.find(corner as u32) as usize];
            (0..3).for_each(|k| sum[k] += area[k]);
        }
    }
    // Each vertex is divided into one for each smooth surface that it belongs to; the order stays.
    let mut wedges: Vec<(u32, u32, u32)> = (0..corners.len() as u32)
        .map(|corner| (corners[corner as usize], smooth.find(corner), corner))
        .collect();
    wedges.sort_unstable();
    let mut order: Vec<u32> = Vec::with_capacity(mesh.vertex_count());
    let mut new_normals: Vec<[f32; 3]> = Vec::with_capacity(mesh.vertex_count());
    let mut triangles = vec![[0; 3]; mesh.triangles.len()];
    let mut last = None;
    for (vertex, surface, corner) in wedges {
        if last != Some((vertex, surface)) {
            // Vertices without triangles stay.
            let unused = order.last().map_or(0, |last| last + 1)..vertex;
            new_normals.extend(unused.clone().map(|_| [0.0, 0.0, 1.0]));
            order.extend(unused);
            order.push(vertex);
            new_normals.push(unit(sums[surface as usize]).unwrap_or([0.0, 0.0, 1.0]));
            last = Some((vertex, surface));
        }
        triangles[corner as usize / 3][corner as usize % 3] = order.len() as u32 - 1;
    }
    let unused = order.last().map_or(0, |last| last + 1)..mesh.vertex_count() as u32;
    new_normals.extend(unused.clone().map(|_| [0.0, 0.0, 1.0]));
    order.extend(unused);
    let mut layers = vec![AttributeLayer::from_f32(Semantic::Normal, 3, new_normals.into_flattened())];
    layers.extend(mesh.layers.iter().map(|layer| layer.gather(&order)));
    IndexedMesh {
        positions: order.iter().map(|&v| mesh.positions[v as usize]).collect(),
        layers,
        triangles,
        origin: mesh.origin,
        triangle_layers: mesh.triangle_layers.clone(),
        groups: mesh.groups.clone(),
        appearance: mesh.appearance.clone(),
        ..IndexedMesh::default()
    }
}

/// Sets of corners with one normal.
struct CornerSets(Vec<u32>);

impl CornerSets {
    fn find(&mut self, mut corner: u32) -> u32 {
        while self.0[corner as usize] != corner {
            self.0[corner as usize] = self.0[self.0[corner as usize] as usize];
            corner = self.0[corner as usize];
        }
        corner
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;

    #[test]
    fn a_cube_has_creases_and_a_ball_has_none() {
        let corners: Vec<[f32; 3]> =
            (0..8).map(|i| [0, 1, 2].map(|k| if i >> k & 1 == 1 { 1.0 } else { -1.0 })).collect();
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        let cube = IndexedMesh::new(corners, triangles);
        let shown = shaded(&cube);
        assert_eq!(shown.vertex_count(), 24);
        for triangle in &shown.triangles {
            let normal = of_triangle(&shown.positions, *triangle);
            for &v in triangle {
                let layer = shown.layer(&Semantic::Normal).expect("normals");
                assert_eq!([0, 1, 2].map(|k| layer.get(v as usize, k)), normal);
            }
        }
        assert!(!shown.appearance.materials[0].gltf_json.contains("doubleSided"), "it is closed");
        let ball = shapes::icosphere(3, 1.0);
        let shown = shaded(&ball);
        assert_eq!(shown.positions, ball.positions);
        assert_eq!(shown.triangles, ball.triangles);
        let normals = shown.layer(&Semantic::Normal).expect("normals");
        for (v, p) in ball.positions.iter().enumerate() {
            let cosine: f32 = (0..3).map(|k| p[k] * normals.get(v, k)).sum();
            assert!(cosine > 0.999, "{cosine}");
        }
    }

    #[test]
    fn normals_and_materials_that_exist_stay_and_unused_vertices_too() {
        let mut mesh = shapes::grid(4, 4);
        mesh.positions.insert(3, [9.0; 3]);
        mesh.triangles.iter_mut().flatten().for_each(|v| *v += u32::from(*v >= 3));
        mesh.positions.push([8.0; 3]);
        let shown = shaded(&mesh).into_owned();
        assert_eq!(shown.positions, mesh.positions);
        assert_eq!(shown.triangles, mesh.triangles);
        assert!(shown.appearance.materials[0].gltf_json.contains("doubleSided"), "it is open");
        assert_eq!(shaded(&shown).into_owned(), shown);
    }
}
