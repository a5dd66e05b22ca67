//! Tracks all removed vertices, each with the face nearest to it.
//!
//! Like [`tracked`](crate::simplify::collapse::tracked), but for holes with any triangulation.

use glam::Vec3;

use crate::simplify::collapse::fan::distance_squared;

const NONE: u32 = u32::MAX;

/// A removed vertex near the current star.
#[derive(Clone, Copy, Debug)]
pub(super) struct TrackedVertex {
    pub position: u32,
    /// Position relative to the star's center.
    pub at: Vec3,
    /// Area that it represents, scaled units.
    pub weight: f32,
    /// Squared distance from the current surface.
    pub before: f32,
}

/// Removed vertices by face, as linked lists.
#[derive(Debug)]
pub(super) struct TrackedVertices {
    /// First removed vertex of every face.
    head: Vec<u32>,
    /// Next removed vertex of the same face.
    next: Vec<u32>,
    weight: Vec<f32>,
    distance_squared: Vec<f32>,
    /// The vertices of the star loaded last, followed by its center.
    pub loaded: Vec<TrackedVertex>,
}

impl TrackedVertices {
    /// Creates an empty set; `weight` is the area that each position represents.
    pub(super) fn new(face_count: usize, weight: Vec<f32>) -> Self {
        Self {
            head: vec![NONE; face_count],
            next: vec![NONE; weight.len()],
            distance_squared: vec![0.0; weight.len()],
            weight,
            loaded: Vec::new(),
        }
    }

    /// Loads the removed vertices of some faces and `v` itself, relative to `v`.
    pub(super) fn load(&mut self, faces: &[u32], positions: &[[f32; 4]], v: u32) {
        self.loaded.clear();
        let [vx, vy, vz, _] = positions[v as usize];
        for &face in faces {
            let mut p = self.head[face as usize];
            while p != NONE {
                let i = p as usize;
                let [x, y, z, _] = positions[i];
                self.loaded.push(TrackedVertex {
                    position: p,
                    at: Vec3::new(x - vx, y - vy, z - vz),
                    weight: self.weight[i],
                    before: self.distance_squared[i],
                });
                p = self.next[i];
            }
        }
        let weight = self.weight[v as usize];
        self.loaded.push(TrackedVertex { position: v, at: Vec3::ZERO, weight, before: 0.0 });
    }

    /// Assigns the loaded vertices to the nearest of the triangles `corners`, which become the faces
    /// from `first_face` on; returns the largest squared distance.
    pub(super) fn assign(&mut self, first_face: u32, corners: &[[Vec3; 3]]) -> f32 {
        self.head.resize(first_face as usize + corners.len(), NONE);
        let mut worst = 0.0f32;
        for i in 0..self.loaded.len() {
            let TrackedVertex { position, at, .. } = self.loaded[i];
            let Some((squared, nearest)) = nearest(corners, at) else { break };
            worst = worst.max(squared);
            self.distance_squared[position as usize] = squared;
            let head = &mut self.head[first_face as usize + nearest];
            self.next[position as usize] = std::mem::replace(head, position);
        }
        worst
    }
}

/// Returns the squared distance of a point from the nearest of some triangles, and that triangle's index.
#[inline]
pub(super) fn nearest(corners: &[[Vec3; 3]], at: Vec3) -> Option<(f32, usize)> {
    let mut best = None;
    for (i, &[a, b, c]) in corners.iter().enumerate() {
        let squared = distance_squared(a - at, b - at, c - at);
        if best.is_none_or(|(least, _)| squared < least) {
            best = Some((squared, i));
        }
    }
    best
}
