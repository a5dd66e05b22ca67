//! Tracked cost: follows all removed vertices. Slower than the other costs, and better at coarse levels.
//!
//! Each removed vertex belongs to the triangle nearest to it and is weighted by the area that it represented.
//! The cost of a collapse is the increase of the weighted squared distances of the removed vertices around
//! it. A share of the memoryless cost is added, since points alone do not detect a surface that sticks out.
//!
//! Memory: 20 bytes per position and 4 per triangle. Time: about five times the memoryless cost.

use glam::Vec3;

use super::fan::distance_squared;
use super::star::Star;

/// Share of the memoryless cost that is added to the tracked one.
pub(in crate::simplify) const MEMORYLESS_SHARE: f32 = 0.2;

const NONE: u32 = u32::MAX;

/// Removed vertices by triangle, as linked lists.
#[derive(Debug)]
pub(in crate::simplify) struct Tracker {
    /// First removed vertex of every triangle.
    head: Vec<u32>,
    /// Next removed vertex of the same triangle.
    next: Vec<u32>,
    /// Area that every position represents, scaled units.
    weight: Vec<f32>,
    distance_squared: Vec<f32>,
    points: Vec<(u32, Vec3)>,
}

impl Tracker {
    pub(in crate::simplify) fn new(triangle_count: usize, weight: Vec<f32>) -> Self {
        Self {
            head: vec![NONE; triangle_count],
            next: vec![NONE; weight.len()],
            distance_squared: vec![0.0; weight.len()],
            weight,
            points: Vec::new(),
        }
    }

    /// Loads the removed vertices of the star of `v`, relative to `v`.
    pub(in crate::simplify) fn load(&mut self, star: &Star, positions: &[[f32; 4]], v: u32) {
        self.points.clear();
        let [vx, vy, vz, _] = positions[v as usize];
        for &t in &star.triangles[..star.triangle_count()] {
            let mut p = self.head[t as usize];
            while p != NONE {
                let [x, y, z, _] = positions[p as usize];
                self.points.push((p, Vec3::new(x - vx, y - vy, z - vz)));
                p = self.next[p as usize];
            }
        }
    }

    /// Returns how much collapsing the star's center `v` to neighbor `k` increases the weighted squared
    /// distances of the loaded vertices, at least 0; `own` is the squared distance of `v` from the fan.
    pub(in crate::simplify) fn increase(&self, star: &Star, k: usize, v: u32, own: f32) -> f32 {
        let to = star.offset(k);
        let grown = |&(p, at): &(u32, Vec3)| {
            // If no triangle is left, the distance to the target counts.
            let now = star.fan_distance_squared_of(k, at).min((to - at).length_squared());
            self.weight[p as usize] * (now - self.distance_squared[p as usize])
        };
        (self.weight[v as usize] * own + self.points.iter().map(grown).sum::<f32>()).max(0.0)
    }

    /// Assigns the loaded vertices and `v` itself to the triangles of the fan; returns the largest
    /// squared distance.
    pub(in crate::simplify) fn collapse(&mut self, star: &Star, v: u32, k: usize) -> f32 {
        for &t in &star.triangles[..star.triangle_count()] {
            self.head[t as usize] = NONE;
        }
        self.points.push((v, Vec3::ZERO));
        let mut worst = 0.0f32;
        for &(p, at) in &self.points {
            // The assignment and the reported error use exact distances; costs compare distances from
            // one formula, whose rounding cancels.
            let Some((exact, triangle)) = nearest_exactly(star, k, at) else { continue };
            worst = worst.max(exact);
            if star.triangle(triangle).contains(&k) {
                // No triangle is left here that could keep track of it.
                continue;
            }
            self.distance_squared[p as usize] = star.fan_distance_squared_of(k, at);
            let head = &mut self.head[star.triangles[triangle] as usize];
            self.next[p as usize] = std::mem::replace(head, p);
        }
        worst
    }
}

/// Returns the squared distance of a point from the fan around neighbor `k`, and the index of the nearest
/// triangle. If the fan is empty, measures the vanished triangles, of which the remaining edge counts.
fn nearest_exactly(star: &Star, k: usize, at: Vec3) -> Option<(f32, usize)> {
    let distance = |t: usize| {
        let [i, j] = star.triangle(t);
        distance_squared(star.offset(k) - at, star.offset(i) - at, star.offset(j) - at)
    };
    let vanishes = |t: usize| star.triangle(t).contains(&k);
    let all_vanish = (0..star.triangle_count()).all(vanishes);
    let triangles = (0..star.triangle_count()).filter(|&t| all_vanish || !vanishes(t));
    triangles.map(|t| (distance(t), t)).min_by(|a, b| a.0.total_cmp(&b.0))
}
