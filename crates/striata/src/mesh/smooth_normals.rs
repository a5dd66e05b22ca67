//! Smooth normals of meshes without normals, up to creases.

use super::{AttributeLayer, DisjointSets, IndexedMesh, MeshError, Semantic, index_positions};

/// Largest angle of two triangles that belong to one smooth surface, degrees.
const CREASE: f64 = 50.0;

/// The edges of a mesh between positions: vertices that share a position are one.
///
/// Cost: sorts three sides for each triangle; 16 bytes per side.
#[derive(Debug)]
pub struct PositionEdges<'a> {
    mesh: &'a IndexedMesh,
    /// Sides of triangles, sorted: the ends of the edge as positions, the lower first, and the corner where it
    /// begins.
    sides: Vec<([u32; 2], u32)>,
    /// Position of each vertex.
    position_of: Vec<u32>,
}

impl<'a> PositionEdges<'a> {
    /// Finds the edges of a mesh.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub fn of(mesh: &'a IndexedMesh) -> Result<Self, MeshError> {
        mesh.check()?;
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
        Ok(Self { mesh, sides, position_of })
    }

    /// Whether the triangles enclose bodies and face outward, so that their backs cannot be seen: every edge has
    /// two triangles that face the same way, and no connected part has a negative volume.
    pub fn is_solid(&self) -> bool {
        let IndexedMesh { positions, triangles, .. } = self.mesh;
        let mut parts = DisjointSets::new(triangles.len());
        for edge in self.edges() {
            let &[(_, a), (_, b)] = edge else { return false };
            if self.begin_of(a) == self.begin_of(b) {
                return false;
            }
            parts.join(a / 3, b / 3);
        }
        let mut volumes = vec![0.0f64; triangles.len()];
        let Some(origin) = positions.first() else { return false };
        for (triangle, corners) in (0u32..).zip(triangles) {
            let volume = |[a, b, c]: [[f64; 3]; 3]| {
                let cross = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
                a[0] * cross(1, 2) + a[1] * cross(2, 0) + a[2] * cross(0, 1)
            };
            let corner =
                |v: u32| [0, 1, 2].map(|k| f64::from(positions[v as usize][k]) - f64::from(origin[k]));
            volumes[parts.root(triangle) as usize] += volume(corners.map(corner));
        }
        volumes.iter().all(|&volume| volume >= 0.0)
    }

    /// Position where the side of a triangle at a corner begins.
    fn begin_of(&self, corner: u32) -> u32 {
        self.position_of[self.mesh.triangles.as_flattened()[corner as usize] as usize]
    }

    /// Returns the mesh with smooth normals, as its first layer. Normals are the area-weighted means of the
    /// triangles around a corner, up to creases: edges whose triangles form an angle of more than 50 degrees,
    /// and edges that do not have two triangles. A vertex at a crease is divided.
    pub fn with_smooth_normals(&self) -> IndexedMesh {
        let mesh = self.mesh;
        let corners = mesh.triangles.as_flattened();
        let areas: Vec<[f64; 3]> = mesh.triangles.iter().map(|&t| area_normal(&mesh.positions, t)).collect();
        let mut smooth = self.smooth_surfaces(&areas);
        let mut sums = vec![[0.0f64; 3]; corners.len()];
        for (number, area) in areas.iter().enumerate() {
            for corner in 3 * number..3 * number + 3 {
                let sum = &mut sums[smooth.root(corner as u32) as usize];
                (0..3).for_each(|k| sum[k] += area[k]);
            }
        }
        // Each vertex is divided into one for each smooth surface that it belongs to; the order stays.
        let mut wedges: Vec<(u32, u32, u32)> = (0..corners.len() as u32)
            .map(|corner| (corners[corner as usize], smooth.root(corner), corner))
            .collect();
        wedges.sort_unstable();
        let mut divided = Divided::default();
        let mut triangles = vec![[0; 3]; mesh.triangles.len()];
        let mut last = None;
        for (vertex, surface, corner) in wedges {
            if last != Some((vertex, surface)) {
                // Vertices without triangles stay.
                divided.keep_until(vertex);
                divided.add(vertex, unit(sums[surface as usize]).unwrap_or(UP));
                last = Some((vertex, surface));
            }
            triangles[corner as usize / 3][corner as usize % 3] = divided.order.len() as u32 - 1;
        }
        divided.keep_until(mesh.vertex_count() as u32);
        let Divided { order, normals } = divided;
        let mut layers = vec![AttributeLayer::from_f32(Semantic::Normal, 3, normals.into_flattened())];
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
    fn smooth_surfaces(&self, areas: &[[f64; 3]]) -> DisjointSets {
        let mut smooth = DisjointSets::new(3 * self.mesh.triangles.len());
        let least_cosine = CREASE.to_radians().cos() as f32;
        for edge in self.edges() {
            let &[(_, a), (_, b)] = edge else { continue };
            let [m, n] = [a, b].map(|corner| unit(areas[corner as usize / 3]).unwrap_or([0.0; 3]));
            let is_smooth = m[0] * n[0] + m[1] * n[1] + m[2] * n[2] >= least_cosine;
            // Two triangles that face the same way run along their edge in opposite directions.
            if is_smooth && self.begin_of(a) != self.begin_of(b) {
                smooth.join(a, next(b));
                smooth.join(next(a), b);
            }
        }
        smooth
    }

    fn edges(&self) -> impl Iterator<Item = &[([u32; 2], u32)]> {
        self.sides.chunk_by(|a, b| a.0 == b.0)
    }
}

/// Normal of vertices without triangles that have an area.
const UP: [f32; 3] = [0.0, 0.0, 1.0];

/// Vertices of a mesh, some of them several times.
#[derive(Default)]
struct Divided {
    order: Vec<u32>,
    normals: Vec<[f32; 3]>,
}

impl Divided {
    fn add(&mut self, vertex: u32, normal: [f32; 3]) {
        self.order.push(vertex);
        self.normals.push(normal);
    }

    /// Adds the vertices between the last one and `vertex`.
    fn keep_until(&mut self, vertex: u32) {
        let first = self.order.last().map_or(0, |last| last + 1);
        (first..vertex).for_each(|unused| self.add(unused, UP));
    }
}

/// The next corner of the same triangle.
fn next(corner: u32) -> u32 {
    if corner % 3 == 2 { corner - 2 } else { corner + 1 }
}

/// Normal whose length is twice the area.
fn area_normal(positions: &[[f32; 3]], triangle: [u32; 3]) -> [f64; 3] {
    let [a, b, c] = triangle.map(|v| positions[v as usize].map(f64::from));
    let (u, v) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

/// Normalizes a vector; [`None`] if it is zero or not finite.
fn unit(vector: [f64; 3]) -> Option<[f32; 3]> {
    let largest = vector.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    let scaled = vector.map(|x| x / largest);
    let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    Some(scaled.map(|x| (x / length) as f32))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::shapes;

    #[test]
    fn a_cube_has_creases_and_a_ball_has_none() {
        let corners: Vec<[f32; 3]> =
            (0..8).map(|i| [0, 1, 2].map(|k| if i >> k & 1 == 1 { 1.0 } else { -1.0 })).collect();
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        let cube = IndexedMesh::new(corners, triangles);
        let edges = PositionEdges::of(&cube).unwrap();
        assert!(edges.is_solid());
        let shown = edges.with_smooth_normals();
        assert_eq!(shown.vertex_count(), 24);
        for triangle in &shown.triangles {
            let normal = unit(area_normal(&shown.positions, *triangle)).unwrap();
            for &v in triangle {
                let layer = shown.layer(&Semantic::Normal).unwrap();
                assert_eq!([0, 1, 2].map(|k| layer.get(v as usize, k)), normal);
            }
        }
        let ball = shapes::icosphere(3, 1.0);
        let shown = PositionEdges::of(&ball).unwrap().with_smooth_normals();
        assert_eq!(shown.positions, ball.positions);
        assert_eq!(shown.triangles, ball.triangles);
        let normals = shown.layer(&Semantic::Normal).unwrap();
        for (v, p) in ball.positions.iter().enumerate() {
            let cosine: f32 = (0..3).map(|k| p[k] * normals.get(v, k)).sum();
            assert!(cosine > 0.999, "{cosine}");
        }
    }

    #[test]
    fn backs_of_solids_cannot_be_seen() {
        let is_solid = |mesh: &IndexedMesh| PositionEdges::of(mesh).unwrap().is_solid();
        let mut ball = shapes::icosphere(2, 1.0);
        // The position of the mesh does not matter.
        ball.positions.iter_mut().for_each(|p| p[0] += 100.0);
        let mut open = ball.clone();
        open.triangles.pop();
        let mut inverted = ball.clone();
        inverted.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        let mut mixed = ball.clone();
        mixed.triangles[7].swap(0, 1);
        let mut two = ball.clone();
        two.positions.extend(inverted.positions.iter().map(|p| p.map(|x| x * 0.5)));
        let first = ball.positions.len() as u32;
        two.triangles.extend(inverted.triangles.iter().map(|t| t.map(|v| v + first)));
        assert!(is_solid(&ball));
        for mesh in [&open, &inverted, &mixed, &two] {
            assert!(!is_solid(mesh));
        }
    }

    #[test]
    fn triangles_of_a_soup_share_their_normals() {
        let ball = shapes::icosphere(2, 1.0);
        let positions: Vec<[f32; 3]> =
            ball.triangles.iter().flatten().map(|&v| ball.positions[v as usize]).collect();
        let triangles = (0..ball.triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
        let soup = IndexedMesh::new(positions, triangles);
        let shown = PositionEdges::of(&soup).unwrap().with_smooth_normals();
        assert_eq!(crate::mesh::weld(&shown).unwrap().mesh.vertex_count(), ball.vertex_count());
    }
}
