//! Divides triangles into clusters that are full and compact.

use glam::Vec3A;

use super::ClusterOptions;
use crate::mesh::IndexedMesh;

/// Parts of more than this many clusters are halved along their longest side. For smaller ones, the best cut is searched.
const SEARCHED_CLUSTERS: usize = 16;

/// Triangles that are divided, and the clusters so far.
pub(super) struct Division<'a> {
    triangles: &'a [[u32; 3]],
    boxes: Vec<TriangleBox>,
    max_triangles: usize,
    max_vertices: usize,
    clusters: Vec<Vec<u32>>,
    /// Scratch: whether each triangle is on the first side of a cut.
    is_before: Vec<bool>,
}

/// Box around triangles.
#[derive(Clone, Copy)]
struct TriangleBox {
    min: Vec3A,
    max: Vec3A,
}

impl TriangleBox {
    const EMPTY: Self = Self { min: Vec3A::INFINITY, max: Vec3A::NEG_INFINITY };

    fn add(&mut self, other: &Self) {
        self.min = self.min.min(other.min);
        self.max = self.max.max(other.max);
    }

    fn center(&self) -> Vec3A {
        0.5 * self.min + 0.5 * self.max
    }

    /// Half of the surface.
    fn area(&self) -> f32 {
        let [x, y, z] = (self.max - self.min).max(Vec3A::ZERO).to_array();
        x * y + y * z + z * x
    }
}

impl<'a> Division<'a> {
    pub(super) fn new(mesh: &IndexedMesh, triangles: &'a [[u32; 3]], options: &ClusterOptions) -> Self {
        let ClusterOptions { max_triangles, max_vertices, .. } = *options;
        let extent = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| Vec3A::from(mesh.positions[v as usize]));
            TriangleBox { min: a.min(b).min(c), max: a.max(b).max(c) }
        };
        Self {
            triangles,
            boxes: triangles.iter().map(extent).collect(),
            max_triangles,
            max_vertices,
            clusters: Vec::new(),
            is_before: vec![false; triangles.len()],
        }
    }

    /// Divides all triangles; returns those of each cluster, in ascending order.
    pub(super) fn divide(mut self) -> Vec<Vec<u32>> {
        let mut all: Vec<u32> = (0..self.triangles.len() as u32).collect();
        self.halve(&mut all);
        for cluster in &mut self.clusters {
            cluster.sort_unstable();
        }
        self.clusters
    }

    /// Halves a part until it is small enough to search for the best cuts.
    fn halve(&mut self, part: &mut [u32]) {
        if part.len() <= SEARCHED_CLUSTERS * self.max_triangles {
            if !part.is_empty() {
                let sorted = [0, 1, 2].map(|axis| self.sorted_along(axis, part));
                self.split(sorted);
            }
            return;
        }
        let middle = (part.len() / 2 / self.max_triangles) * self.max_triangles;
        let axis = self.longest_side(part);
        part.select_nth_unstable_by_key(middle, |&t| self.key(axis, t));
        let (left, right) = part.split_at_mut(middle);
        self.halve(left);
        self.halve(right);
    }

    /// Splits a part, given in the order along each axis, into clusters.
    fn split(&mut self, sorted: [Vec<u32>; 3]) {
        let count = sorted[0].len();
        if count <= self.max_triangles && self.vertex_count(&sorted[0]) <= self.max_vertices {
            let [cluster, ..] = sorted;
            self.clusters.push(cluster);
            return;
        }
        let (axis, at) = self.best_cut(&sorted);
        for (i, &t) in sorted[axis].iter().enumerate() {
            self.is_before[t as usize] = i < at;
        }
        let side = |is_before: bool| {
            [0, 1, 2].map(|axis| {
                let is_on_side = |t: &&u32| self.is_before[**t as usize] == is_before;
                sorted[axis].iter().filter(is_on_side).copied().collect::<Vec<u32>>()
            })
        };
        let (before, after) = (side(true), side(false));
        self.split(before);
        self.split(after);
    }

    /// The axis and the number of triangles at which a part is best cut.
    ///
    /// The cut with the smallest boxes, weighted by the clusters in each, has the shortest borders. It leaves one side
    /// with full clusters.
    fn best_cut(&self, sorted: &[Vec<u32>; 3]) -> (usize, usize) {
        let (count, full) = (sorted[0].len(), self.max_triangles);
        let mut cuts: Vec<usize> = (full..count).step_by(full).flat_map(|at| [at, count - at]).collect();
        if cuts.is_empty() {
            cuts.push(count / 2);
        }
        cuts.sort_unstable();
        cuts.dedup();
        let from_the_end: Vec<usize> = cuts.iter().rev().map(|&at| count - at).collect();
        let clusters = |n: usize| n.div_ceil(full) as f32;
        let mut best = (0, cuts[0]);
        let mut least = f32::INFINITY;
        for (axis, order) in sorted.iter().enumerate() {
            let areas_before = self.areas(order.iter(), &cuts);
            let areas_after = self.areas(order.iter().rev(), &from_the_end);
            for ((&at, before), after) in cuts.iter().zip(areas_before).zip(areas_after.into_iter().rev()) {
                let cost = before * clusters(at) + after * clusters(count - at);
                if cost < least {
                    (least, best) = (cost, (axis, at));
                }
            }
        }
        best
    }

    /// Areas of the boxes around the first triangles in an order, for ascending numbers of them.
    fn areas<'t>(&self, order: impl Iterator<Item = &'t u32>, counts: &[usize]) -> Vec<f32> {
        let mut areas = Vec::with_capacity(counts.len());
        let mut extent = TriangleBox::EMPTY;
        let mut next = counts.iter();
        let mut count = next.next();
        for (i, &t) in order.enumerate() {
            if count == Some(&i) {
                areas.push(extent.area());
                count = next.next();
                if count.is_none() {
                    break;
                }
            }
            extent.add(&self.boxes[t as usize]);
        }
        areas
    }

    fn longest_side(&self, part: &[u32]) -> usize {
        let mut extent = TriangleBox::EMPTY;
        for &t in part {
            let center = self.boxes[t as usize].center();
            extent.add(&TriangleBox { min: center, max: center });
        }
        let [x, y, z] = (extent.max - extent.min).to_array();
        if x >= y && x >= z {
            0
        } else if y >= z {
            1
        } else {
            2
        }
    }

    fn sorted_along(&self, axis: usize, part: &[u32]) -> Vec<u32> {
        let mut keys: Vec<u64> = part.iter().map(|&t| self.key(axis, t)).collect();
        keys.sort_unstable();
        keys.into_iter().map(|key| key as u32).collect()
    }

    /// A key that sorts triangles along an axis, and those at the same place by their number, which is its lower half.
    fn key(&self, axis: usize, t: u32) -> u64 {
        let bits = self.boxes[t as usize].center()[axis].to_bits();
        let ascending = if bits >> 31 == 0 { bits | 1 << 31 } else { !bits };
        u64::from(ascending) << 32 | u64::from(t)
    }

    fn vertex_count(&self, part: &[u32]) -> usize {
        if 3 * part.len() <= self.max_vertices {
            return 3 * part.len();
        }
        let mut vertices: Vec<u32> = part.iter().flat_map(|&t| self.triangles[t as usize]).collect();
        vertices.sort_unstable();
        vertices.dedup();
        vertices.len()
    }
}
