//! Connected parts of a mesh, and the cost of letting one of them vanish.
//!
//! A part exists as long as it has a triangle. Its last triangles vanish together, at a cost that depends on
//! the distance of the *original* part from the remaining surface of the others: a screw in its hole costs
//! little, a part in free space as much as its own extent. The **hosts** of a vanished part are the parts
//! that replace it. They inherit its area, and the **reach** of a part is the largest distance at which
//! anything that it replaces may lie. A host that vanishes later is charged for both.
//!
//! Time: one pass over the mesh to find the parts, and up to 64 distances for each part that is down to
//! its last triangles.

use glam::Vec3;

use crate::mesh::{DisjointSets, Welded};

use super::attributes::AttributeSpace;
use super::fan::point;
use super::surface_snapshot::{SnapshotPoint, SurfaceSnapshot};

/// Maximum number of triangles of the original part that are sampled.
const MAX_SAMPLES: usize = 16;
/// Maximum number of triangles of a vanished part whose corners are measured for the error.
const MAX_CORNER_SAMPLES: usize = 32;
/// If a part's distance from its host is below this share of its radius, the host already covers the
/// same space.
const COVERED_SHARE: f32 = 0.25;
/// Maximum number of points on the edges of a vanished part that are used to find further hosts.
const MAX_HOST_SAMPLES: usize = 48;
/// Weight of the squared difference of unit normals against squared distances, so that decals and the
/// two sides of a sheet do not vanish at no cost.
const NORMAL_WEIGHT: f32 = 1e-4;
/// Weight of the squared distance, added to the area that vanishes, in [`vanishing_cost`].
const EXTENT_WEIGHT: f32 = 1.0;

/// Cost and distance if a part vanishes.
#[derive(Clone, Debug)]
pub(in crate::simplify) struct VanishingEstimate {
    pub cost: f32,
    /// Largest distance of the part, and of everything it replaces, from its hosts.
    pub distance: f32,
    /// A corner of the triangle nearest to the part's first sample.
    pub host: u32,
    /// The parts that replace it.
    hosts: Vec<u32>,
    /// Build number of the surface snapshot that was used for measuring.
    generation: u32,
}

impl VanishingEstimate {
    pub(in crate::simplify) fn distance_squared(&self) -> f32 {
        self.distance * self.distance
    }
}

/// Area that is lost with a vanishing part, and the host that could make up for it.
pub(in crate::simplify) struct LostCover {
    /// The area that the part should cover.
    pub cover: f32,
    /// A corner of the host.
    pub host: u32,
    /// Whether the host is so close that it already covers the same space.
    pub is_covered: bool,
}

#[derive(Debug, Default)]
struct PartState {
    triangle_count: usize,
    /// Area of the original part, and of the vanished parts for which it has grown.
    cover: f32,
    /// Area of the original part, and of everything that it replaces.
    area: f32,
    reach: f32,
    /// Half the diagonal of its bounds.
    radius: f32,
    estimate: Option<VanishingEstimate>,
}

/// All connected parts of a mesh.
#[derive(Debug)]
pub(in crate::simplify) struct MeshParts {
    of_position: Vec<u32>,
    parts: Vec<PartState>,
    /// The part that each part was merged into, or itself.
    merged: Vec<u32>,
    /// Original triangles by part, once a part may vanish.
    part_triangles: Option<PartTriangles>,
}

/// Original triangles sorted by part, and the first one of each part.
#[derive(Debug)]
struct PartTriangles {
    triangles: Vec<u32>,
    first: Vec<u32>,
}

/// Data for measuring distances between parts.
pub(in crate::simplify) struct MeasuringContext<'a> {
    pub welded: &'a Welded,
    pub positions: &'a [[f32; 4]],
    pub attributes: Option<&'a AttributeSpace>,
    pub snapshot: &'a SurfaceSnapshot,
    /// Build number of the surface snapshot.
    pub generation: u32,
}

/// Sample point of a part.
struct PartSample {
    at: Vec3,
    normal: Vec3,
    vertices: [u32; 3],
    weights: [f32; 3],
    share: f32,
}

impl MeshParts {
    /// Finds the parts of the original mesh. Their triangles are not counted yet; see [`Self::count`].
    pub(in crate::simplify) fn new(welded: &Welded) -> Self {
        let position_count = welded.positions.position_count();
        let of = |t: &[u32; 3]| t.map(|v| welded.positions.position_of(v));
        let mut sets = DisjointSets::new(position_count);
        for [a, b, c] in welded.mesh.triangles.iter().map(of) {
            sets.join(a, b);
            sets.join(a, c);
        }
        let mut part_of_root = vec![u32::MAX; position_count];
        let mut count = 0;
        let mut of_position = Vec::with_capacity(position_count);
        for p in 0..position_count as u32 {
            let root = sets.root(p) as usize;
            if part_of_root[root] == u32::MAX {
                part_of_root[root] = count;
                count += 1;
            }
            of_position.push(part_of_root[root]);
        }
        let parts = (0..count).map(|_| PartState::default()).collect();
        Self { of_position, parts, merged: (0..count).collect(), part_triangles: None }
    }

    /// Resets all triangle counts to 0.
    pub(in crate::simplify) fn clear_counts(&mut self) {
        self.parts.iter_mut().for_each(|part| part.triangle_count = 0);
    }

    /// Measures the areas and extents of all parts in the original mesh.
    fn measure(&mut self, welded: &Welded, positions: &[[f32; 4]]) {
        let part_triangles = PartTriangles::new(welded, &self.of_position, self.parts.len());
        for part in 0..self.parts.len() as u32 {
            let mut area = 0.0;
            let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            for &t in part_triangles.of(part) {
                let corners = welded.mesh.triangles[t as usize].map(|v| welded.positions.position_of(v));
                let [a, b, c] = corners.map(|p| point(positions, p));
                area += 0.5 * (b - a).cross(c - a).length();
                (min, max) = (min.min(a).min(b).min(c), max.max(a).max(b).max(c));
            }
            let root = self.root(part);
            let into = &mut self.parts[root as usize];
            into.area += area;
            into.cover += area;
            into.radius = into.radius.max(0.5 * (max - min).length());
        }
        self.part_triangles = Some(part_triangles);
    }

    fn triangles_of(&self, part: u32) -> &[u32] {
        self.part_triangles.as_ref().map_or(&[], |part_triangles| part_triangles.of(part))
    }

    /// Returns the area that a part replaces, per remaining triangle, and its reach.
    pub(in crate::simplify) fn share(&self, part: u32) -> (f32, f32) {
        let PartState { triangle_count, area, reach, .. } = self.parts[part as usize];
        (area / triangle_count.max(1) as f32, reach)
    }

    /// Returns the cover that is lost if a part vanishes, if the vanishing has been estimated.
    pub(in crate::simplify) fn lost_cover(&self, part: u32) -> Option<LostCover> {
        let PartState { cover, radius, estimate, .. } = &self.parts[part as usize];
        let VanishingEstimate { host, distance, .. } = estimate.as_ref()?;
        Some(LostCover { cover: *cover, host: *host, is_covered: *distance < COVERED_SHARE * radius })
    }

    /// Area that a part should cover, for itself and for vanished parts next to it.
    pub(in crate::simplify) fn cover(&self, part: u32) -> f32 {
        self.parts[part as usize].cover
    }

    /// Number of parts of the original mesh.
    pub(in crate::simplify) fn len(&self) -> usize {
        self.parts.len()
    }

    /// Returns the part of a position.
    pub(in crate::simplify) fn part_of(&self, position: u32) -> u32 {
        self.root(self.of_position[position as usize])
    }

    /// Returns the part that a part has been merged into.
    fn root(&self, mut part: u32) -> u32 {
        while self.merged[part as usize] != part {
            part = self.merged[part as usize];
        }
        part
    }

    /// Number of triangles that a part still has.
    pub(in crate::simplify) fn triangle_count(&self, part: u32) -> usize {
        self.parts[part as usize].triangle_count
    }

    /// Counts a triangle of the part of `position`.
    pub(in crate::simplify) fn count(&mut self, position: u32) {
        let part = self.part_of(position);
        self.parts[part as usize].triangle_count += 1;
    }

    /// Updates the parts after the collapse of `v` to `u`, which removed `removed` triangles.
    pub(in crate::simplify) fn collapse(&mut self, v: u32, u: u32, removed: usize) {
        let [own, other] = [v, u].map(|p| self.part_of(p));
        if own != other {
            self.merge(own, other);
        }
        let part = self.part_of(u);
        self.parts[part as usize].triangle_count -= removed;
    }

    /// Merges two parts; the result keeps the samples of the one with more triangles.
    fn merge(&mut self, a: u32, b: u32) {
        let is_less = self.parts[a as usize].triangle_count < self.parts[b as usize].triangle_count;
        let (small, large) = if is_less { (a, b) } else { (b, a) };
        self.merged[small as usize] = large;
        let PartState { triangle_count, area, cover, reach, radius, .. } =
            std::mem::take(&mut self.parts[small as usize]);
        let into = &mut self.parts[large as usize];
        into.triangle_count += triangle_count;
        into.area += area;
        into.cover += cover;
        into.reach = into.reach.max(reach);
        into.radius = into.radius.max(radius);
        into.estimate = None;
    }

    /// Whether a stored estimate with this squared distance is still valid.
    pub(in crate::simplify) fn has_valid_estimate(
        &self,
        part: u32,
        generation: u32,
        distance_squared: f32,
    ) -> bool {
        let estimate = self.parts[part as usize].estimate.as_ref();
        self.is_up_to_date(part, generation)
            && estimate.is_some_and(|estimate| estimate.distance_squared() == distance_squared)
    }

    fn is_up_to_date(&self, part: u32, generation: u32) -> bool {
        let estimate = self.parts[part as usize].estimate.as_ref();
        estimate.is_some_and(|estimate| {
            estimate.generation == generation
                && estimate.hosts.iter().all(|&host| self.parts[host as usize].triangle_count > 0)
        })
    }

    /// Estimates what happens if a part vanishes; `None` if no other part is left.
    pub(in crate::simplify) fn estimate(
        &mut self,
        part: u32,
        context: &MeasuringContext<'_>,
    ) -> Option<&VanishingEstimate> {
        if self.part_triangles.is_none() {
            self.measure(context.welded, context.positions);
        }
        if !self.is_up_to_date(part, context.generation) {
            let estimate = self.compute_estimate(part, context);
            self.parts[part as usize].estimate = estimate;
        }
        self.parts[part as usize].estimate.as_ref()
    }

    fn compute_estimate(&self, part: u32, context: &MeasuringContext<'_>) -> Option<VanishingEstimate> {
        let PartState { area, reach, radius, .. } = self.parts[part as usize];
        let is_host = |host: u32| host != part && self.parts[host as usize].triangle_count > 0;
        let (mut sum, mut share_sum, mut farthest) = (0.0, 0.0, 0.0f32);
        let (mut hosts, mut nearest): (Vec<u32>, Option<u32>) = (Vec::new(), None);
        let mut last: Option<(Vec3, f32)> = None;
        // Triangles share corners, so the same points are queried repeatedly.
        let mut seen: Vec<(Vec3, SnapshotPoint)> = Vec::with_capacity(4 * MAX_SAMPLES);
        for sample in self.samples(part, context) {
            // The host of the last sample is at most this far away.
            let reachable = last.map_or(f32::INFINITY, |(at, distance)| {
                let bound = distance + at.distance(sample.at);
                bound * bound * 1.001 + f32::MIN_POSITIVE
            });
            let find = |limit: f32| {
                context.snapshot.nearest(context.positions, sample.at, limit, |triangle| {
                    is_host(self.part_of(triangle.positions[0]))
                })
            };
            let known = seen.iter().find(|(at, _)| *at == sample.at).map(|&(_, found)| found);
            let found = known.or_else(|| find(reachable)).or_else(|| find(f32::INFINITY))?;
            if known.is_none() {
                seen.push((sample.at, found));
            }
            last = Some((sample.at, found.distance_squared.sqrt()));
            let host = self.part_of(found.triangle.positions[0]);
            if !hosts.contains(&host) {
                hosts.push(host);
            }
            nearest.get_or_insert(found.triangle.positions[0]);
            farthest = farthest.max(found.distance_squared);
            let squared = found.distance_squared + difference_squared(context, &sample, &found);
            sum += sample.share * squared.min(radius * radius);
            share_sum += sample.share;
        }
        let extent = (sum / share_sum.max(f32::MIN_POSITIVE)).sqrt() + reach;
        let squared = extent * extent;
        Some(VanishingEstimate {
            cost: vanishing_cost(area, squared),
            distance: farthest.sqrt() + reach,
            host: nearest?,
            hosts,
            generation: context.generation,
        })
    }

    /// Returns sample points of the original part: centroids and corners of some of its triangles.
    fn samples(&self, part: u32, context: &MeasuringContext<'_>) -> Vec<PartSample> {
        let part_triangles = self.triangles_of(part);
        let count = part_triangles.len().min(MAX_SAMPLES);
        let mut samples = Vec::with_capacity(4 * count);
        for i in 0..count {
            let t = part_triangles[i * part_triangles.len() / count];
            let vertices = context.welded.mesh.triangles[t as usize];
            let corners = vertices.map(|v| point(context.positions, context.welded.positions.position_of(v)));
            let [a, b, c] = corners;
            let doubled = (b - a).cross(c - a);
            // Triangles without area get a tiny weight, so that the sum is never zero.
            let area = doubled.length() + 1e-12;
            let normal = doubled.normalize_or_zero();
            let third = 1.0 / 3.0;
            samples.push(PartSample {
                at: (a + b + c) * third,
                normal,
                vertices,
                weights: [third; 3],
                share: 0.75 * area,
            });
            for k in 0..3 {
                let mut weights = [0.0; 3];
                weights[k] = 1.0;
                samples.push(PartSample { at: corners[k], normal, vertices, weights, share: area / 12.0 });
            }
        }
        samples
    }

    /// Appends the corners of some triangles of the original part to `out`.
    pub(in crate::simplify) fn corners_into(
        &self,
        part: u32,
        welded: &Welded,
        positions: &[[f32; 4]],
        out: &mut Vec<Vec3>,
    ) {
        let part_triangles = self.triangles_of(part);
        let count = part_triangles.len().min(MAX_CORNER_SAMPLES);
        for i in 0..count {
            let vertices = welded.mesh.triangles[part_triangles[i * part_triangles.len() / count] as usize];
            out.extend(vertices.map(|v| point(positions, welded.positions.position_of(v))));
        }
    }

    /// Records that a part has vanished: its hosts replace it from now on.
    pub(in crate::simplify) fn vanish(
        &mut self,
        part: u32,
        context: &MeasuringContext<'_>,
    ) -> Option<VanishingEstimate> {
        let PartState { area, estimate, .. } = std::mem::take(&mut self.parts[part as usize]);
        let mut estimate = estimate?;
        self.add_hosts_along(part, &mut estimate, context);
        for &host in &estimate.hosts {
            let host = &mut self.parts[host as usize];
            host.reach = host.reach.max(estimate.distance);
            host.estimate = None;
        }
        let first = self.part_of(estimate.host);
        self.parts[first as usize].area += area;
        Some(estimate)
    }

    /// Adds hosts along the edges of a part that is long compared with its distance from them. All of them
    /// replace the part; otherwise a rod could lose one host after another as if each replaced only itself.
    fn add_hosts_along(&self, part: u32, estimate: &mut VanishingEstimate, context: &MeasuringContext<'_>) {
        let part_triangles = self.triangles_of(part);
        let count = part_triangles.len().min(MAX_SAMPLES);
        let spacing = 2.0 * estimate.distance.max(f32::MIN_POSITIVE);
        let mut left = MAX_HOST_SAMPLES;
        for i in 0..count {
            let t = part_triangles[i * part_triangles.len() / count];
            let corners = context.welded.mesh.triangles[t as usize]
                .map(|v| point(context.positions, context.welded.positions.position_of(v)));
            for (a, b) in [(0, 1), (1, 2), (2, 0)].map(|(a, b)| (corners[a], corners[b])) {
                let steps = (a.distance(b) / spacing).min(left as f32) as usize;
                left -= steps;
                for k in 1..=steps {
                    let at = a.lerp(b, k as f32 / (steps + 1) as f32);
                    let limit = 4.0 * spacing * spacing;
                    let found = context.snapshot.nearest(context.positions, at, limit, |triangle| {
                        let host = self.part_of(triangle.positions[0]);
                        host != part && self.parts[host as usize].triangle_count > 0
                    });
                    let host = found.map(|found| self.part_of(found.triangle.positions[0]));
                    if let Some(host) = host.filter(|host| !estimate.hosts.contains(host)) {
                        estimate.hosts.push(host);
                    }
                }
            }
        }
    }
}

/// Cost of an area that vanishes at this squared distance from the remaining surface.
pub(in crate::simplify) fn vanishing_cost(area: f32, squared: f32) -> f32 {
    (area + EXTENT_WEIGHT * squared) * squared
}

/// Squared difference in attributes and normals between a sample and the point that replaces it.
fn difference_squared(context: &MeasuringContext<'_>, sample: &PartSample, found: &SnapshotPoint) -> f32 {
    let [a, b, c] = found.triangle.positions.map(|p| point(context.positions, p));
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let turned = NORMAL_WEIGHT * normal.distance_squared(sample.normal);
    let attributes = context.attributes.map_or(0.0, |space| {
        space.points_difference_squared(
            sample.vertices,
            sample.weights,
            found.triangle.vertices,
            found.weights,
        )
    });
    turned + attributes
}

impl PartTriangles {
    fn new(welded: &Welded, of_position: &[u32], count: usize) -> Self {
        let part_of = |t: &[u32; 3]| of_position[welded.positions.position_of(t[0]) as usize] as usize;
        let mut first = vec![0u32; count + 1];
        for t in &welded.mesh.triangles {
            first[part_of(t) + 1] += 1;
        }
        for part in 0..count {
            first[part + 1] += first[part];
        }
        let mut next = first.clone();
        let mut triangles = vec![0; welded.mesh.triangle_count()];
        for (index, t) in (0..).zip(&welded.mesh.triangles) {
            let slot = &mut next[part_of(t)];
            triangles[*slot as usize] = index;
            *slot += 1;
        }
        Self { triangles, first }
    }

    /// Returns the triangles of a part.
    fn of(&self, part: u32) -> &[u32] {
        let [from, to] = [part, part + 1].map(|p| self.first[p as usize] as usize);
        &self.triangles[from..to]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{IndexedMesh, weld};
    use crate::simplify::collapse::links::Links;

    /// A large triangle, and a small one above it at each height.
    fn with_decals(heights: &[f32]) -> Welded {
        let mut mesh = IndexedMesh::new(vec![[0., 0., 0.], [9., 0., 0.], [0., 9., 0.]], vec![[0, 1, 2]]);
        for &z in heights {
            let first = mesh.positions.len() as u32;
            mesh.positions.extend([[1., 1., z], [2., 1., z], [1., 2., z]]);
            mesh.triangles.push([first, first + 1, first + 2]);
        }
        weld(&mesh).expect("the mesh is valid")
    }

    fn context<'a>(
        welded: &'a Welded,
        positions: &'a [[f32; 4]],
        snapshot: &'a SurfaceSnapshot,
    ) -> MeasuringContext<'a> {
        MeasuringContext { welded, positions, attributes: None, snapshot, generation: 1 }
    }

    fn estimates(heights: &[f32]) -> Vec<Option<VanishingEstimate>> {
        let welded = with_decals(heights);
        let positions: Vec<[f32; 4]> =
            welded.mesh.positions.iter().map(|&[x, y, z]| [x, y, z, 0.0]).collect();
        let mut parts = MeshParts::new(&welded);
        for t in &welded.mesh.triangles {
            parts.count(t[0]);
        }
        assert_eq!(parts.len(), 1 + heights.len());
        let snapshot = SurfaceSnapshot::new(
            &Links::new(positions.len(), &welded.mesh.triangles, false),
            None,
            &positions,
        );
        let context = context(&welded, &positions, &snapshot);
        let small = welded.mesh.triangles[1..].iter().map(|t| parts.part_of(t[0])).collect::<Vec<_>>();
        small.into_iter().map(|part| parts.estimate(part, &context).cloned()).collect()
    }

    #[test]
    fn close_parts_vanish_cheaply() {
        let costs: Vec<f32> = [0.01, 0.1, 100.0, 1000.0]
            .map(|z| estimates(&[z]).remove(0).expect("there is a host"))
            .map(|estimate| estimate.cost)
            .to_vec();
        assert!(costs.is_sorted(), "{costs:?}");
        assert_eq!(costs[2], costs[3], "the extent of the part limits its cost");
    }

    #[test]
    fn distances_reach_the_nearest_part() {
        let found = estimates(&[0.5, 0.75]);
        for estimate in found {
            assert_eq!(estimate.expect("there are hosts").distance, 0.25);
        }
    }

    #[test]
    fn hosts_inherit_area_and_reach() {
        let welded = with_decals(&[0.5]);
        let positions: Vec<[f32; 4]> =
            welded.mesh.positions.iter().map(|&[x, y, z]| [x, y, z, 0.0]).collect();
        let mut parts = MeshParts::new(&welded);
        welded.mesh.triangles.iter().for_each(|t| parts.count(t[0]));
        let snapshot = SurfaceSnapshot::new(
            &Links::new(positions.len(), &welded.mesh.triangles, false),
            None,
            &positions,
        );
        let context = context(&welded, &positions, &snapshot);
        let [large, small] = [0, 1].map(|t: usize| welded.mesh.triangles[t]);
        let (host, gone) = (parts.part_of(large[0]), parts.part_of(small[0]));
        assert!(parts.estimate(gone, &context).is_some());
        parts.collapse(small[0], small[1], 1);
        assert!(parts.vanish(gone, &context).is_some_and(|estimate| parts.part_of(estimate.host) == host));
        let PartState { area, reach, .. } = parts.parts[host as usize];
        assert_eq!((area, reach), (41.0, 0.5));
        assert_eq!(parts.triangle_count(gone), 0);
        assert!(parts.estimate(host, &context).is_none(), "nothing else is left");
    }
}
