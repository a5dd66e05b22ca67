//! What a criterion is asked of each vertex of the hierarchy: a sphere and a cone over all its leaves.
//!
//! As \[Hop97\] has it: the sphere of a leaf holds the triangles of the full mesh around it, and its cone their normals; that of
//! a parent keeps its center, which is its vertex, and holds those of its children. What a split needs beside, to be
//! legal, is not in it.

use glam::DVec3;
use striata::mesh::{RefinableMesh, is_proper};
use striata::view::{NormalCone, Part, Sphere};

/// The part of each step: what its split brings back.
pub(super) fn parts(refinable: &RefinableMesh) -> Vec<Part> {
    let sequence = &refinable.sequence;
    let mut leaves = leaves(refinable);
    let mut parts: Vec<Part> = Vec::with_capacity(sequence.step_count());
    for step in (0..sequence.step_count()).rev() {
        let vertex = sequence.step_vertices(step).start;
        let below = leaves[vertex as usize];
        let node = &mut leaves[sequence.target(vertex) as usize];
        node.hold(&below);
        parts.push(Part { sphere: node.sphere, cone: node.cone, error: sequence.error_at(step) });
    }
    parts.reverse();
    parts
}

/// What lies below a node.
#[derive(Clone, Copy)]
struct Below {
    sphere: Sphere,
    cone: NormalCone,
    /// Normals by area, added up: they tell a parent's axis.
    normals: DVec3,
}

impl Below {
    fn hold(&mut self, other: &Self) {
        self.sphere = self.sphere.with_sphere(&other.sphere);
        self.normals += other.normals;
        let kept = self.cone.with_cone(&other.cone);
        let between =
            NormalCone::around(self.normals.to_array()).with_cone(&self.cone).with_cone(&other.cone);
        self.cone = if between.cos > kept.cos { between } else { kept };
    }
}

fn leaves(refinable: &RefinableMesh) -> Vec<Below> {
    let mesh = &refinable.mesh;
    let mut leaves: Vec<Below> = mesh
        .positions
        .iter()
        .map(|&p| Below { sphere: Sphere::point(p), cone: NormalCone::ALL, normals: DVec3::ZERO })
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
        // A triangle without area has no normal.
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

/// The normal of a triangle, as long as twice its area.
fn normal(corners: &[[f32; 3]; 3]) -> DVec3 {
    let [a, b, c] = corners.map(|p| DVec3::from(p.map(f64::from)));
    (b - a).cross(c - a)
}
