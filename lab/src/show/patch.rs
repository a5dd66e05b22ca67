//! A small, nearly flat part of a mesh, and its picture in the plane.

use std::collections::VecDeque;

use glam::{DVec2, DVec3};
use striata::mesh::{DualGraph, IndexedMesh, MeshError, weld};

/// Number of starts that are tried for the flattest part.
const STARTS: usize = 200;

/// A connected part of a mesh, without attributes.
pub(super) struct MeshPatch {
    pub mesh: IndexedMesh,
    /// Directions to the right and up in pictures.
    axes: [DVec3; 2],
}

impl MeshPatch {
    /// Finds the flattest part with `count` triangles; [`None`] if no part has that many.
    ///
    /// # Errors
    /// [`MeshError`] if the mesh is inconsistent.
    pub(super) fn of(mesh: &IndexedMesh, count: usize) -> Result<Option<Self>, MeshError> {
        let welded = weld(mesh)?.mesh;
        let graph = DualGraph::of_vertices(&welded);
        let stride = welded.triangle_count().div_ceil(STARTS).max(1);
        let parts = (0..welded.triangle_count()).step_by(stride).filter_map(|start| {
            let part = around(&graph, start as u32, count)?;
            let normals: Vec<DVec3> = part.iter().map(|&t| doubled_normal(&welded, t)).collect();
            let area: f64 = normals.iter().map(|normal| normal.length()).sum();
            let sum: DVec3 = normals.iter().sum();
            (area > 0.0).then(|| (sum.length() / area, sum, part))
        });
        let flattest = parts.max_by(|a, b| a.0.total_cmp(&b.0));
        Ok(flattest.map(|(_, normal, part)| {
            let triangles = part.iter().map(|&t| welded.triangles[t as usize]).collect();
            let mesh = IndexedMesh::new(welded.positions.clone(), triangles).without_unused_vertices();
            let normal = normal.normalize_or(DVec3::Z);
            // The picture's vertical is the mesh's, unless it is seen from above.
            let up = if normal.y.abs() > 0.9 { DVec3::Z } else { DVec3::Y };
            let right = up.cross(normal).normalize();
            Self { mesh, axes: [right, normal.cross(right)] }
        }))
    }

    /// Positions as seen in the picture, y down.
    pub(super) fn seen(&self, positions: &[[f32; 3]]) -> Vec<DVec2> {
        let [right, up] = self.axes;
        let seen = |&p: &[f32; 3]| {
            let p = DVec3::from(p.map(f64::from));
            DVec2::new(p.dot(right), -p.dot(up))
        };
        positions.iter().map(seen).collect()
    }
}

/// Returns the `count` triangles nearest to one, by links of the dual graph.
fn around(graph: &DualGraph, start: u32, count: usize) -> Option<Vec<u32>> {
    let mut is_known = vec![false; graph.triangle_count()];
    is_known[start as usize] = true;
    let (mut part, mut queue) = (Vec::new(), VecDeque::from([start]));
    while let Some(triangle) = queue.pop_front() {
        part.push(triangle);
        if part.len() == count {
            return Some(part);
        }
        for neighbor in (0..3).filter_map(|k| graph.neighbor(triangle, k)) {
            if !std::mem::replace(&mut is_known[neighbor as usize], true) {
                queue.push_back(neighbor);
            }
        }
    }
    None
}

fn doubled_normal(mesh: &IndexedMesh, triangle: u32) -> DVec3 {
    let at = |v: u32| DVec3::from(mesh.positions[v as usize].map(f64::from));
    let [a, b, c] = mesh.triangles[triangle as usize].map(at);
    (b - a).cross(c - a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::shapes;

    #[test]
    fn a_part_is_seen_from_its_front() {
        let patch =
            MeshPatch::of(&shapes::icosphere(3, 1.0), 40).expect("a valid mesh").expect("enough triangles");
        assert_eq!(patch.mesh.triangle_count(), 40);
        let seen = patch.seen(&patch.mesh.positions);
        for triangle in &patch.mesh.triangles {
            let [a, b, c] = triangle.map(|v| seen[v as usize]);
            // Counterclockwise, with y down.
            assert!((b - a).perp_dot(c - a) < 0.0);
        }
        assert!(MeshPatch::of(&shapes::cube(), 13).expect("a valid mesh").is_none());
    }
}
