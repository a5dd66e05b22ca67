//! Connected parts of a mesh, and the cost of letting one of them vanish.
//!
//! A part exists as long as it has a triangle. Its last triangles vanish together, at a cost that
//! depends on the distance of the *original* part from the remaining surface of the others: a screw in
//! its hole costs little, a part in free space as much as its own extent. The **hosts** of a vanished
//! part are the parts that replace it. They inherit its area, and the **reach** of a part is the
//! largest distance at which anything that it replaces may lie. A host that vanishes later is charged
//! for both.
//!
//! Time: one pass over the mesh to find the parts, and up to 64 distances for each part that is down to
//! its last triangles.

use glam::Vec3;

use crate::mesh::{DisjointSets, Welded};

use super::attributes::AttributeSpace;
use super::fan::point;
use super::rest::{Rest, RestPoint};

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
pub(in crate::simplify) struct Fate {
    pub(in crate::simplify) cost: f32,
    /// Largest distance of the part, and of everything it replaces, from its hosts.
    pub(in crate::simplify) distance: f32,
    /// A corner of the triangle nearest to the part's first sample.
    pub(in crate::simplify) host: u32,
    /// The parts that replace it.
    hosts: Vec<u32>,
    /// Build number of the triangle tree that was used for measuring.
    generation: u32,
}

impl Fate {
    pub(in crate::simplify) fn distance_squared(&self) -> f32 {
        self.distance * self.distance
    }
}

/// What is lost with a vanishing part, and what could make up for it.
pub(in crate::simplify) struct Estate {
    /// The area that the part should cover.
    pub(in crate::simplify) cover: f32,
    /// A corner of the host.
    pub(in crate::simplify) host: u32,
    /// Whether the host is so close that it already covers the same space.
    pub(in crate::simplify) is_covered: bool,
}

#[derive(Debug, Default)]
struct Part {
    triangle_count: usize,
    /// Area of the original part, and of the vanished parts for which it has grown.
    cover: f32,
    /// Area of the original part, and of everything that it replaces.
    area: f32,
    reach: f32,
    /// Half the diagonal of its bounds.
    radius: f32,
    fate: Option<Fate>,
}

/// All connected parts of a mesh.
#[derive(Debug)]
pub(in crate::simplify) struct Parts {
    of_position: Vec<u32>,
    parts: Vec<Part>,
    /// The part that each part was merged into, or itself.
    merged: Vec<u32>,
    /// Original triangles by part, once a part may vanish.
    members: Option<Members>,
}

/// Original triangles sorted by part, and the first one of each part.
#[derive(Debug)]
struct Members {
    triangles: Vec<u32>,
    first: Vec<u32>,
}

/// Data for measuring distances between parts.
pub(in crate::simplify) struct Surroundings<'a> {
    pub(in crate::simplify) welded: &'a Welded,
    pub(in crate::simplify) positions: &'a [[f32; 4]],
    pub(in crate::simplify) attributes: Option<&'a AttributeSpace>,
    pub(in crate::simplify) rest: &'a Rest,
    /// Build number of the triangle tree.
    pub(in crate::simplify) generation: u32,
}

/// Sample point of a part.
struct Sample {
    at: Vec3,
    normal: Vec3,
    vertices: [u32; 3],
    weights: [f32; 3],
    share: f32,
}

impl Parts {
    /// Finds the parts of the original mesh. Their triangles are not counted yet; see [`Self::count`].
    pub(in crate::simplify) fn new(welded: &Welded) -> Self {
        let position_count = welded.positions.position_count();
        let of = |t: &[u32; 3]| t.map(|v| welded.positions.position_of(v));
        let mut sets = DisjointSets::new(position_count);
        for [a, b, c] in welded.mesh.triangles.iter().map(of) {
            sets.join(a, b);
            sets.join(a, c);
        }
        let mut number = vec![u32::MAX; position_count];
        let mut count = 0;
        let mut of_position = Vec::with_capacity(position_count);
        for p in 0..position_count as u32 {
            let root = sets.root(p) as usize;
            if number[root] == u32::MAX {
                number[root] = count;
                count += 1;
            }
            of_position.push(number[root]);
        }
        let parts = (0..count).map(|_| Part::default()).collect();
        Self { of_position, parts, merged: (0..count).collect(), members: None }
    }

    /// Resets all triangle counts to 0.
    pub(in crate::simplify) fn clear_counts(&mut self) {
        self.parts.iter_mut().for_each(|part| part.triangle_count = 0);
    }

    /// Measures the areas and extents of all parts in the original mesh.
    fn measure(&mut self, welded: &Welded, positions: &[[f32; 4]]) {
        let members = Members::new(welded, &self.of_position, self.parts.len());
        for part in 0..self.parts.len() as u32 {
            let mut area = 0.0;
            let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            for &t in members.of(part) {
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
        self.members = Some(members);
    }

    fn members_of(&self, part: u32) -> &[u32] {
        self.members.as_ref().map_or(&[], |members| members.of(part))
    }

    /// Returns the area that a part replaces, per remaining triangle, and its reach.
    pub(in crate::simplify) fn share(&self, part: u32) -> (f32, f32) {
        let Part { triangle_count, area, reach, .. } = self.parts[part as usize];
        (area / triangle_count.max(1) as f32, reach)
    }

    /// Returns what is lost if a part vanishes, if the vanishing has been estimated.
    pub(in crate::simplify) fn estate(&self, part: u32) -> Option<Estate> {
        let Part { cover, radius, fate, .. } = &self.parts[part as usize];
        let Fate { host, distance, .. } = fate.as_ref()?;
        Some(Estate { cover: *cover, host: *host, is_covered: *distance < COVERED_SHARE * radius })
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
        let Part { triangle_count, area, cover, reach, radius, .. } =
            std::mem::take(&mut self.parts[small as usize]);
        let into = &mut self.parts[large as usize];
        into.triangle_count += triangle_count;
        into.area += area;
        into.cover += cover;
        into.reach = into.reach.max(reach);
        into.radius = into.radius.max(radius);
        into.fate = None;
    }

    /// Whether a stored estimate with this squared distance is still valid.
    pub(in crate::simplify) fn knows_fate(&self, part: u32, generation: u32, distance_squared: f32) -> bool {
        let fate = self.parts[part as usize].fate.as_ref();
        self.is_up_to_date(part, generation)
            && fate.is_some_and(|fate| fate.distance_squared() == distance_squared)
    }

    fn is_up_to_date(&self, part: u32, generation: u32) -> bool {
        let fate = self.parts[part as usize].fate.as_ref();
        fate.is_some_and(|fate| {
            fate.generation == generation
                && fate.hosts.iter().all(|&host| self.parts[host as usize].triangle_count > 0)
        })
    }

    /// Estimates what happens if a part vanishes; `None` if no other part is left.
    pub(in crate::simplify) fn fate(&mut self, part: u32, around: &Surroundings<'_>) -> Option<&Fate> {
        if self.members.is_none() {
            self.measure(around.welded, around.positions);
        }
        if !self.is_up_to_date(part, around.generation) {
            let fate = self.find_fate(part, around);
            self.parts[part as usize].fate = fate;
        }
        self.parts[part as usize].fate.as_ref()
    }

    fn find_fate(&self, part: u32, around: &Surroundings<'_>) -> Option<Fate> {
        let Part { area, reach, radius, .. } = self.parts[part as usize];
        let is_host = |host: u32| host != part && self.parts[host as usize].triangle_count > 0;
        let (mut sum, mut share_sum, mut farthest) = (0.0, 0.0, 0.0f32);
        let (mut hosts, mut nearest): (Vec<u32>, Option<u32>) = (Vec::new(), None);
        let mut last: Option<(Vec3, f32)> = None;
        // Triangles share corners, so the same points are queried repeatedly.
        let mut seen: Vec<(Vec3, RestPoint)> = Vec::with_capacity(4 * MAX_SAMPLES);
        for sample in self.samples(part, around) {
            // The host of the last sample is at most this far away.
            let reachable = last.map_or(f32::INFINITY, |(at, distance)| {
                let bound = distance + at.distance(sample.at);
                bound * bound * 1.001 + f32::MIN_POSITIVE
            });
            let find = |limit: f32| {
                around.rest.nearest(around.positions, sample.at, limit, |triangle| {
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
            let squared = found.distance_squared + difference_squared(around, &sample, &found);
            sum += sample.share * squared.min(radius * radius);
            share_sum += sample.share;
        }
        let extent = (sum / share_sum.max(f32::MIN_POSITIVE)).sqrt() + reach;
        let squared = extent * extent;
        Some(Fate {
            cost: vanishing_cost(area, squared),
            distance: farthest.sqrt() + reach,
            host: nearest?,
            hosts,
            generation: around.generation,
        })
    }

    /// Returns sample points of the original part: centroids and corners of some of its triangles.
    fn samples(&self, part: u32, around: &Surroundings<'_>) -> Vec<Sample> {
        let members = self.members_of(part);
        let count = members.len().min(MAX_SAMPLES);
        let mut samples = Vec::with_capacity(4 * count);
        for i in 0..count {
            let t = members[i * members.len() / count];
            let vertices = around.welded.mesh.triangles[t as usize];
            let corners = vertices.map(|v| point(around.positions, around.welded.positions.position_of(v)));
            let [a, b, c] = corners;
            let doubled = (b - a).cross(c - a);
            // Triangles without area get a tiny weight, so that the sum is never zero.
            let area = doubled.length() + 1e-12;
            let normal = doubled.normalize_or_zero();
            let third = 1.0 / 3.0;
            samples.push(Sample {
                at: (a + b + c) * third,
                normal,
                vertices,
                weights: [third; 3],
                share: 0.75 * area,
            });
            for k in 0..3 {
                let mut weights = [0.0; 3];
                weights[k] = 1.0;
                samples.push(Sample { at: corners[k], normal, vertices, weights, share: area / 12.0 });
            }
        }
        samples
    }

    /// Appends the corners of some triangles of the original part to `out`.
    pub(in crate::simplify) fn corners_into(
        &self,
        part: u32,
        (welded, positions): (&Welded, &[[f32; 4]]),
        out: &mut Vec<Vec3>,
    ) {
        let members = self.members_of(part);
        let count = members.len().min(MAX_CORNER_SAMPLES);
        for i in 0..count {
            let vertices = welded.mesh.triangles[members[i * members.len() / count] as usize];
            out.extend(vertices.map(|v| point(positions, welded.positions.position_of(v))));
        }
    }

    /// Records that a part has vanished: its hosts replace it from now on.
    pub(in crate::simplify) fn bequeath(&mut self, part: u32, around: &Surroundings<'_>) -> Option<Fate> {
        let Part { area, fate, .. } = std::mem::take(&mut self.parts[part as usize]);
        let mut fate = fate?;
        self.add_hosts_along(part, &mut fate, around);
        for &host in &fate.hosts {
            let host = &mut self.parts[host as usize];
            host.reach = host.reach.max(fate.distance);
            host.fate = None;
        }
        let first = self.part_of(fate.host);
        self.parts[first as usize].area += area;
        Some(fate)
    }

    /// Adds hosts along the edges of a part that is long compared with its distance from them. All of
    /// them replace the part; otherwise a rod could lose one host after another as if each replaced
    /// only itself.
    fn add_hosts_along(&self, part: u32, fate: &mut Fate, around: &Surroundings<'_>) {
        let members = self.members_of(part);
        let count = members.len().min(MAX_SAMPLES);
        let spacing = 2.0 * fate.distance.max(f32::MIN_POSITIVE);
        let mut left = MAX_HOST_SAMPLES;
        for i in 0..count {
            let t = members[i * members.len() / count];
            let corners = around.welded.mesh.triangles[t as usize]
                .map(|v| point(around.positions, around.welded.positions.position_of(v)));
            for (a, b) in [(0, 1), (1, 2), (2, 0)].map(|(a, b)| (corners[a], corners[b])) {
                let steps = (a.distance(b) / spacing).min(left as f32) as usize;
                left -= steps;
                for k in 1..=steps {
                    let at = a.lerp(b, k as f32 / (steps + 1) as f32);
                    let limit = 4.0 * spacing * spacing;
                    let found = around.rest.nearest(around.positions, at, limit, |triangle| {
                        let host = self.part_of(triangle.positions[0]);
                        host != part && self.parts[host as usize].triangle_count > 0
                    });
                    let host = found.map(|found| self.part_of(found.triangle.positions[0]));
                    if let Some(host) = host.filter(|host| !fate.hosts.contains(host)) {
                        fate.hosts.push(host);
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
fn difference_squared(around: &Surroundings<'_>, sample: &Sample, found: &RestPoint) -> f32 {
    let [a, b, c] = found.triangle.positions.map(|p| point(around.positions, p));
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let turned = NORMAL_WEIGHT * normal.distance_squared(sample.normal);
    let attributes = around.attributes.map_or(0.0, |space| {
        space.points_difference_squared(
            (sample.vertices, sample.weights),
            (found.triangle.vertices, found.weights),
        )
    });
    turned + attributes
}

impl Members {
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
        for (number, t) in (0..).zip(&welded.mesh.triangles) {
            let slot = &mut next[part_of(t)];
            triangles[*slot as usize] = number;
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
        weld(&mesh).expect("it is sound")
    }

    fn around<'a>(welded: &'a Welded, positions: &'a [[f32; 4]], rest: &'a Rest) -> Surroundings<'a> {
        Surroundings { welded, positions, attributes: None, rest, generation: 1 }
    }

    fn fates(heights: &[f32]) -> Vec<Option<Fate>> {
        let welded = with_decals(heights);
        let positions: Vec<[f32; 4]> =
            welded.mesh.positions.iter().map(|&[x, y, z]| [x, y, z, 0.0]).collect();
        let mut parts = Parts::new(&welded);
        for t in &welded.mesh.triangles {
            parts.count(t[0]);
        }
        assert_eq!(parts.len(), 1 + heights.len());
        let rest = Rest::new(&Links::new(positions.len(), &welded.mesh.triangles, false), None, &positions);
        let around = around(&welded, &positions, &rest);
        let small = welded.mesh.triangles[1..].iter().map(|t| parts.part_of(t[0])).collect::<Vec<_>>();
        small.into_iter().map(|part| parts.fate(part, &around).cloned()).collect()
    }

    #[test]
    fn what_lies_close_vanishes_cheaply() {
        let costs: Vec<f32> = [0.01, 0.1, 100.0, 1000.0]
            .map(|z| fates(&[z]).remove(0).expect("there is a host"))
            .map(|fate| fate.cost)
            .to_vec();
        assert!(costs.is_sorted(), "{costs:?}");
        assert_eq!(costs[2], costs[3], "a part is lost by no more than its extent");
    }

    #[test]
    fn distances_reach_the_nearest_part() {
        let found = fates(&[0.5, 0.75]);
        for fate in found {
            assert_eq!(fate.expect("there are hosts").distance, 0.25);
        }
    }

    #[test]
    fn hosts_inherit() {
        let welded = with_decals(&[0.5]);
        let positions: Vec<[f32; 4]> =
            welded.mesh.positions.iter().map(|&[x, y, z]| [x, y, z, 0.0]).collect();
        let mut parts = Parts::new(&welded);
        welded.mesh.triangles.iter().for_each(|t| parts.count(t[0]));
        let rest = Rest::new(&Links::new(positions.len(), &welded.mesh.triangles, false), None, &positions);
        let around = around(&welded, &positions, &rest);
        let [large, small] = [0, 1].map(|t: usize| welded.mesh.triangles[t]);
        let (host, gone) = (parts.part_of(large[0]), parts.part_of(small[0]));
        assert!(parts.fate(gone, &around).is_some());
        parts.collapse(small[0], small[1], 1);
        assert!(parts.bequeath(gone, &around).is_some_and(|fate| parts.part_of(fate.host) == host));
        let Part { area, reach, .. } = parts.parts[host as usize];
        assert_eq!((area, reach), (41.0, 0.5));
        assert_eq!(parts.triangle_count(gone), 0);
        assert!(parts.fate(host, &around).is_none(), "nothing else is left");
    }
}
