//! Global state that relaxed collapses need: connected parts, where removed positions went, and a
//! snapshot of the surface.

use glam::Vec3;

use crate::mesh::Welded;

use super::fan::{nearest, point};
use super::links::{LinkEdge, Links};
use super::outward_bounds::OutwardBounds;
use super::parts::MeshParts;
use super::surface_snapshot::SurfaceSnapshot;
use super::walk::NearestStar;
use super::wedges::Wedges;

/// Parts with more triangles than this do not count as foliage (see `foliage.rs`).
pub(in crate::simplify) const MAX_LEAF_TRIANGLES: usize = 16;
/// Share of the triangles that must belong to small parts for a mesh to count as foliage.
const LEAF_SHARE: f32 = 0.5;

/// Number of triangles that searches for the nearest point may visit in the beginning, and that each of them adds.
/// Where very many parts have vanished next to each other, every search would visit all of them.
const FIRST_VISITS: usize = 1 << 22;
const VISITS: usize = 1 << 8;

/// The positions removed so far, and the target of every vertex at them.
pub(in crate::simplify) type RemovedPositions<'r> = (&'r [u32], &'r [u32]);

/// Global state of the mesh that relaxed collapses need.
pub(in crate::simplify) struct RelaxedState<'a> {
    pub welded: &'a Welded,
    pub parts: MeshParts,
    /// The position that each position was merged into, with path compression.
    pub current: Vec<u32>,
    /// Next position in the cycle of all positions that were merged together; `follower_count` is the
    /// length of that cycle for each position that still exists.
    pub next: Vec<u32>,
    pub follower_count: Vec<u32>,
    pub triangle_count: usize,
    pub snapshot: SurfaceSnapshot,
    /// Number of times that `snapshot` was built.
    pub generation: u32,
    pub outward: OutwardBounds,
    /// Index of the last search that visited the star of each position.
    pub stamps: Vec<u32>,
    pub search: u32,
    /// Number of triangles that searches may still visit.
    pub visits_left: usize,
    pub keeps_parts: bool,
    /// Whether relaxed collapses begin only after all strict ones.
    pub begins_last: bool,
    /// Whether small parts make up most of the mesh.
    pub is_foliage: bool,
    pub has_locks: bool,
    /// Whether a relaxed collapse has been applied.
    pub has_relaxed: bool,
    pub edges: Vec<LinkEdge>,
    pub order: Vec<u32>,
    pub lost: Vec<u32>,
}

impl<'a> RelaxedState<'a> {
    /// Finds the parts of a mesh; [`Self::begin`] must follow.
    pub(in crate::simplify) fn new(welded: &'a Welded, keeps_parts: bool) -> Self {
        Self {
            welded,
            parts: MeshParts::new(welded),
            current: Vec::new(),
            next: Vec::new(),
            follower_count: Vec::new(),
            triangle_count: 0,
            snapshot: SurfaceSnapshot::default(),
            generation: 0,
            outward: OutwardBounds::default(),
            stamps: Vec::new(),
            search: 0,
            visits_left: FIRST_VISITS,
            keeps_parts,
            begins_last: false,
            is_foliage: false,
            has_locks: false,
            has_relaxed: false,
            edges: Vec::new(),
            order: Vec::new(),
            lost: Vec::new(),
        }
    }

    /// Initializes the state from the mesh after the collapses so far, given by `removed` and `targets`
    /// of their record.
    pub(in crate::simplify) fn begin(
        &mut self,
        links: &Links,
        is_locked: &[bool],
        (removed, targets): RemovedPositions<'_>,
    ) {
        let positions = &self.welded.positions;
        self.current = (0..is_locked.len() as u32).collect();
        self.next.clone_from(&self.current);
        self.follower_count = vec![1; is_locked.len()];
        for &v in removed {
            let target = targets[positions.first_vertex(v) as usize];
            self.follow(v, positions.position_of(target));
        }
        self.parts.clear_counts();
        self.triangle_count = 0;
        for p in 0..is_locked.len() as u32 {
            links.edges_into(p, &mut self.edges);
            for _ in self.edges.iter().filter(|e| p < e.a && p < e.b) {
                self.parts.count(p);
                self.triangle_count += 1;
            }
        }
        self.is_foliage = !self.keeps_parts && self.has_many_leaves(links);
        self.has_locks = is_locked.contains(&true);
    }

    /// Whether small open parts make up most of the mesh.
    fn has_many_leaves(&mut self, links: &Links) -> bool {
        let mut count = 0;
        for p in (0..self.current.len() as u32).filter(|&p| links.is_boundary(p)) {
            if self.parts.triangle_count(self.parts.part_of(p)) <= MAX_LEAF_TRIANGLES {
                links.edges_into(p, &mut self.edges);
                count += self.edges.iter().filter(|e| p < e.a && p < e.b).count();
            }
        }
        count as f32 > LEAF_SHARE * self.triangle_count as f32
    }

    /// Number of connected parts of the original mesh.
    pub(in crate::simplify) fn part_count(&self) -> usize {
        self.parts.len()
    }

    /// Returns the position that a position has been merged into.
    pub(in crate::simplify) fn find_current(&self, mut p: u32) -> u32 {
        while self.current[p as usize] != p {
            p = self.current[p as usize];
        }
        p
    }

    /// Records that `v` and everything merged into it are now merged into `u`.
    pub(in crate::simplify) fn follow(&mut self, v: u32, u: u32) {
        self.current[v as usize] = u;
        // Swapping one link of each of two cycles joins the cycles.
        self.next.swap(v as usize, u as usize);
        self.follower_count[u as usize] += self.follower_count[v as usize];
    }

    /// Rebuilds the surface snapshot if half of its triangles are gone.
    pub(in crate::simplify) fn refresh(
        &mut self,
        links: &Links,
        wedges: Option<&Wedges<'_>>,
        positions: &[[f32; 4]],
    ) {
        if self.generation == 0 || 2 * self.triangle_count < self.snapshot.triangle_count() {
            self.snapshot = SurfaceSnapshot::new(links, wedges, positions);
            self.generation += 1;
        }
    }
}

impl RelaxedState<'_> {
    /// Finds the point of the current surface that is nearest to a given point. The snapshot has
    /// triangles of an earlier surface; the stars of the positions that their corners were merged into
    /// are searched, if `is_counted` accepts those positions. Returns `known` unless something is
    /// nearer, and stops at a squared distance of `enough`, or at any point after very many visits.
    pub(in crate::simplify) fn nearest_star(
        &mut self,
        (links, positions): (&Links, &[[f32; 4]]),
        from: Vec3,
        (known, enough): (NearestStar, f32),
        is_counted: impl Fn(u32) -> bool,
    ) -> NearestStar {
        let Self { snapshot, current, stamps, search, edges, visits_left, .. } = self;
        *visits_left += VISITS;
        stamps.resize(positions.len(), 0);
        *search += 1;
        let (mut least, mut position) = known;
        let limit_of = |least: f32| if least <= enough { 0.0 } else { least };
        snapshot.visit_near(positions, from, limit_of(least), |triangle| {
            for corner in triangle.positions {
                let at = find(current, corner);
                if std::mem::replace(&mut stamps[at as usize], *search) == *search || !is_counted(at) {
                    continue;
                }
                links.sampled_edges_into(at, edges);
                for e in edges.iter() {
                    let [a, b, c] = [at, e.a, e.b].map(|p| point(positions, p) - from);
                    let [x, y, z] = nearest(a, b, c);
                    let distance_squared = (a * x + b * y + c * z).length_squared();
                    if distance_squared < least {
                        (least, position) = (distance_squared, at);
                    }
                }
            }
            *visits_left = visits_left.saturating_sub(1);
            if *visits_left == 0 && least < f32::INFINITY { 0.0 } else { limit_of(least) }
        });
        (least, position)
    }
}

/// Returns the position that a position has been merged into, and compresses the path to it.
pub(in crate::simplify) fn find(current: &mut [u32], mut p: u32) -> u32 {
    while current[p as usize] != p {
        let above = current[p as usize];
        current[p as usize] = current[above as usize];
        p = above;
    }
    p
}
