//! Builds the resulting mesh when the loop ends.

use super::Merger;
use crate::mesh::{IndexedMesh, gather_layers};

impl Merger<'_> {
    /// Returns the simplified mesh.
    pub(in crate::simplify::place) fn finish(mut self) -> IndexedMesh {
        let positions = &self.welded.positions;
        for v in 0..self.targets.len() {
            let mut root = self.targets[v];
            while self.targets[root as usize] != root {
                root = self.targets[root as usize];
            }
            let mut p = v;
            while p as u32 != root {
                p = std::mem::replace(&mut self.targets[p], root) as usize;
            }
        }
        let source = &self.welded.mesh;
        let mut mesh = IndexedMesh {
            positions: source.positions.clone(),
            origin: source.origin,
            exact_positions: source.exact_positions.clone(),
            triangles: Vec::with_capacity(self.triangle_count),
            layers: self.layers,
            triangle_layers: Vec::new(),
            groups: source.groups.clone(),
            appearance: source.appearance.clone(),
        };
        for (v, position) in mesh.positions.iter_mut().enumerate() {
            let p = positions.position_of(v as u32) as usize;
            if self.is_moved[p] {
                *position = self.space.unscaled(self.positions[p]);
                if let Some(exact) = mesh.exact_positions.get_mut(v) {
                    *exact = source.in_file(*position);
                }
            }
        }
        let targets = &self.targets;
        let remaining = |t: &[u32; 3]| {
            let corners = t.map(|v| targets[v as usize]);
            let [a, b, c] = corners.map(|v| positions.position_of(v));
            (a != b && b != c && c != a).then_some(corners)
        };
        if !source.triangle_layers.is_empty() {
            let triangles = (0..).zip(&source.triangles);
            let kept: Vec<u32> = triangles.filter_map(|(i, t)| remaining(t).map(|_| i)).collect();
            mesh.triangle_layers = gather_layers(&source.triangle_layers, &kept);
        }
        if source.groups.is_empty() {
            mesh.triangles.extend(source.triangles.iter().filter_map(remaining));
        }
        for group in &mut mesh.groups {
            let first = mesh.triangles.len();
            mesh.triangles.extend(source.triangles[group.range()].iter().filter_map(remaining));
            (group.first, group.count) = (first as u32, (mesh.triangles.len() - first) as u32);
        }
        mesh.without_unused_vertices()
    }
}
