//! Bounds for criteria: a sphere and a normal cone over all leaves of each hierarchy node.
//!
//! Following \[Hop97\], the sphere of a leaf contains the triangles of the full mesh around it, and its cone
//! contains their normals. Those of a parent contain its children's; the sphere keeps its center, which is
//! the parent's vertex. Vertices that a split needs in addition, to be legal, are not included.

use glam::DVec3;
use striata::mesh::{RefinableMesh, is_proper};
use striata::model::PartRecord;
use striata::view::{NormalCone, Sphere};

/// Computes the part of each step: the bounds of everything its split can restore.
pub(super) fn parts(refinable: &RefinableMesh) -> Vec<PartRecord> {
    let sequence = &refinable.sequence;
    let mut leaves = leaves(refinable);
    let mut parts: Vec<PartRecord> = Vec::with_capacity(sequence.step_count());
    for step in (0..sequence.step_count()).rev() {
        let vertex = sequence.step_vertices(step).start;
        let below = leaves[vertex as usize];
        let node = &mut leaves[sequence.target(vertex) as usize];
        node.enclose(&below);
        parts.push(PartRecord::holding(node.sphere.radius, &node.cone, sequence.error_at(step)));
    }
    parts.reverse();
    parts
}

/// Bounds of all leaves below a node.
#[derive(Clone, Copy)]
struct SubtreeBounds {
    sphere: Sphere,
    cone: NormalCone,
    /// Sum of the area-weighted normals, from which a parent's axis is derived.
    normals: DVec3,
}

impl SubtreeBounds {
    fn enclose(&mut self, other: &Self) {
        self.sphere = self.sphere.with_sphere(&other.sphere);
        self.normals += other.normals;
        let kept = self.cone.with_cone(&other.cone);
        let between =
            NormalCone::around(self.normals.to_array()).with_cone(&self.cone).with_cone(&other.cone);
        self.cone = if between.cos > kept.cos { between } else { kept };
    }
}

fn leaves(refinable: &RefinableMesh) -> Vec<SubtreeBounds> {
    let mesh = &refinable.mesh;
    let mut leaves: Vec<SubtreeBounds> = mesh
        .positions
        .iter()
        .map(|&p| SubtreeBounds { sphere: Sphere::point(p), cone: NormalCone::ALL, normals: DVec3::ZERO })
        .collect();
    let triangles = || mesh.triangles.iter().filter(|t| is_proper(t));
    for triangle in triangles() {
        let corners = triangle.map(|v| mesh.positions[v as usize]);
        let normal = normal(&corners);
        for &v in triangle {
            let leaf = &mut leaves[v as usize];
            leaf.sphere = corners.iter().fold(leaf.sphere, |sphere, &p| sphere.with_point(p));
            leaf.normals += normal;
        }
    }
    leaves.iter_mut().for_each(|leaf| leaf.cone = NormalCone::around(leaf.normals.to_array()));
    for triangle in triangles() {
        let normal = normal(&triangle.map(|v| mesh.positions[v as usize]));
        // A degenerate triangle has no normal.
        if normal.length_squared() > 0.0 {
            let cone = NormalCone::around(normal.to_array());
            triangle
                .iter()
                .map(|&v| v as usize)
                .for_each(|v| leaves[v].cone = leaves[v].cone.with_cone(&cone));
        }
    }
    leaves
}

/// The normal of a triangle, with a length of twice its area.
fn normal(corners: &[[f32; 3]; 3]) -> DVec3 {
    let [a, b, c] = corners.map(|p| DVec3::from(p.map(f64::from)));
    (b - a).cross(c - a)
}
