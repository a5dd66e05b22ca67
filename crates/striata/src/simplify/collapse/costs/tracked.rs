//! Tracked cost: follows all removed vertices. Slower than the other costs, and better at coarse levels.
//!
//! Each removed vertex belongs to the triangle nearest to it and is weighted by the area that it represented.
//! The cost of a collapse is the increase of the weighted squared distances of the removed vertices around
//! it. A share of the memoryless cost is added, since points alone do not detect a surface that sticks out.
//!
//! Memory: 20 bytes per position and 4 per triangle. Time: about five times the memoryless cost.

use glam::Vec3;

use super::collapse_cost::{CollapseCost, CostRules, LOCAL};
use crate::simplify::collapse::fan::distance_squared;
use crate::simplify::collapse::links::Links;
use crate::simplify::collapse::star::Star;

/// Share of the memoryless cost that is added to the tracked one.
const MEMORYLESS_SHARE: f32 = 0.2;

const NONE: u32 = u32::MAX;

/// The tracked cost, with the vertices removed so far.
#[derive(Debug, Default)]
pub(super) struct Tracked {
    removed: RemovedVertices,
}

impl CollapseCost for Tracked {
    fn rules(&self) -> CostRules {
        CostRules { surface_share: MEMORYLESS_SHARE, is_local: false, follows_triangles: true, ..LOCAL }
    }

    fn begin(&mut self, star: &mut Star, links: &Links, positions: &[[f32; 4]], triangle_count: usize) {
        self.removed = RemovedVertices::new(star, links, positions, triangle_count);
    }

    fn fill(&self, star: &mut Star, _positions: &[[f32; 4]], _v: u32) {
        star.costs.iter_mut().for_each(|cost| *cost *= MEMORYLESS_SHARE);
    }

    fn load(&mut self, star: &Star, positions: &[[f32; 4]], v: u32) {
        self.removed.load(&star.ring.triangles[..star.ring.triangle_count()], positions, v);
    }

    fn increase(&self, star: &mut Star, k: usize, v: u32, own: f32) -> f32 {
        star.mark_vanishing(Some(k));
        let to = star.offset(k);
        let points = self.removed.loaded.split_last().map_or(&[][..], |(_center, points)| points);
        let grown = |point: &TrackedVertex| {
            // If no triangle is left, the distance to the target counts.
            let now = star.fan_distance_squared_of(k, point.at).min((to - point.at).length_squared());
            point.weight * (now - point.before)
        };
        (self.removed.weight[v as usize] * own + points.iter().map(grown).sum::<f32>()).max(0.0)
    }

    fn collapse(&mut self, star: &mut Star, positions: &[[f32; 4]], v: u32, k: usize) -> Option<f32> {
        star.mark_vanishing(Some(k));
        self.load(star, positions, v);
        let triangles = &star.ring.triangles[..star.ring.triangle_count()];
        triangles.iter().for_each(|&t| self.removed.head[t as usize] = NONE);
        let mut worst = 0.0f32;
        for i in 0..self.removed.loaded.len() {
            let TrackedVertex { position, at, .. } = self.removed.loaded[i];
            // The assignment and the reported error use exact distances; costs compare distances from
            // one formula, whose rounding cancels.
            let Some((exact, triangle)) = nearest_of_fan(star, k, at) else { continue };
            worst = worst.max(exact);
            // If it vanishes, no triangle is left here that could keep track of the vertex.
            if !star.ring.triangle(triangle).contains(&k) {
                let squared = star.fan_distance_squared_of(k, at);
                self.removed.assign(position, triangles[triangle], squared);
            }
        }
        Some(worst)
    }
}

/// Returns the squared distance of a point from the fan around neighbor `k`, and the index of the nearest
/// triangle. If the fan is empty, measures the vanished triangles, of which the remaining edge counts.
fn nearest_of_fan(star: &Star, k: usize, at: Vec3) -> Option<(f32, usize)> {
    let vanishes = |t: usize| star.ring.triangle(t).contains(&k);
    let all_vanish = (0..star.ring.triangle_count()).all(vanishes);
    let triangles = (0..star.ring.triangle_count()).filter(|&t| all_vanish || !vanishes(t));
    nearest(
        triangles.map(|t| {
            let [i, j] = star.ring.triangle(t);
            ([k, i, j].map(|corner| star.offset(corner)), t)
        }),
        at,
    )
}

/// A removed vertex near the current star.
#[derive(Clone, Copy, Debug)]
pub(in crate::simplify) struct TrackedVertex {
    pub position: u32,
    /// Position relative to the star's center.
    pub at: Vec3,
    /// Area that it represents, scaled units.
    pub weight: f32,
    /// Squared distance from the current surface.
    pub before: f32,
}

/// Removed vertices by triangle, as linked lists.
#[derive(Debug, Default)]
pub(in crate::simplify) struct RemovedVertices {
    /// First removed vertex of every triangle.
    head: Vec<u32>,
    /// Next removed vertex of the same triangle.
    next: Vec<u32>,
    /// Area that every position represents, scaled units.
    weight: Vec<f32>,
    distance_squared: Vec<f32>,
    /// The vertices of the star loaded last, followed by its center.
    pub loaded: Vec<TrackedVertex>,
}

impl RemovedVertices {
    /// Creates an empty set for a mesh on which nothing has been collapsed yet.
    pub(in crate::simplify) fn new(
        star: &mut Star,
        links: &Links,
        positions: &[[f32; 4]],
        triangle_count: usize,
    ) -> Self {
        let area = |v| {
            star.gather(links, positions, v);
            star.compute_costs();
            star.area() / 3.0
        };
        Self {
            head: vec![NONE; triangle_count],
            next: vec![NONE; positions.len()],
            weight: (0..positions.len() as u32).map(area).collect(),
            distance_squared: vec![0.0; positions.len()],
            loaded: Vec::new(),
        }
    }

    /// Loads the removed vertices of some triangles and `v` itself, relative to `v`.
    pub(in crate::simplify) fn load(&mut self, triangles: &[u32], positions: &[[f32; 4]], v: u32) {
        self.loaded.clear();
        let [vx, vy, vz, _] = positions[v as usize];
        for &t in triangles {
            let mut p = self.head[t as usize];
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

    fn assign(&mut self, vertex: u32, triangle: u32, distance_squared: f32) {
        self.distance_squared[vertex as usize] = distance_squared;
        self.next[vertex as usize] = std::mem::replace(&mut self.head[triangle as usize], vertex);
    }

    /// Assigns the loaded vertices to the nearest of new triangles, whose indices are those from
    /// `first_triangle` on; returns the largest squared distance.
    pub(in crate::simplify) fn assign_loaded(&mut self, first_triangle: u32, corners: &[[Vec3; 3]]) -> f32 {
        self.head.resize(first_triangle as usize + corners.len(), NONE);
        let mut worst = 0.0f32;
        for i in 0..self.loaded.len() {
            let TrackedVertex { position, at, .. } = self.loaded[i];
            let Some((squared, triangle)) = nearest(corners.iter().copied().zip(first_triangle..), at) else {
                break;
            };
            worst = worst.max(squared);
            self.assign(position, triangle, squared);
        }
        worst
    }
}

/// Returns the squared distance of a point from the nearest of some triangles, and that triangle's index.
#[inline]
pub(in crate::simplify) fn nearest<T>(
    triangles: impl Iterator<Item = ([Vec3; 3], T)>,
    at: Vec3,
) -> Option<(f32, T)> {
    let mut best: Option<(f32, T)> = None;
    for ([a, b, c], index) in triangles {
        let squared = distance_squared(a - at, b - at, c - at);
        if best.as_ref().is_none_or(|(least, _)| squared < *least) {
            best = Some((squared, index));
        }
    }
    best
}
