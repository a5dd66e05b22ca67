//! The link of every position, kept up to date during collapses.
//!
//! The link of `v` is the set of edges opposite to `v` in its triangles. On a manifold it is one cycle
//! or, at a boundary, one path, and is stored as the ordered **ring** of neighbors; no triangles need
//! to be stored. Anywhere else it is stored as a plain list of edges, so that bow-ties, books and
//! repeated triangles work too. A half-edge collapse is then a substitution in the links around it:
//!
//! ```text
//!        r1 --- r2                r1 --- r2       ring(u) = .. r1 [v] r5 ..
//!       /  \   /  \              /    /    \      ring(v) = u r1 r2 r3 r4 r5
//!      u -- v -- r3     v -> u  u ------- r3      after: ring(u) = .. r1 r2 r3 r4 r5 ..
//!       \  /   \  /              \    \    /      ring(r1), ring(r5) lose v, the others read u for v
//!        r5 --- r4                r5 --- r4
//! ```
//!
//! Memory: 4 bytes per entry plus slack, and 16 bytes per position. Time of a collapse: the sizes of
//! the links it touches.

mod chain;
mod edge;
mod hubs;
mod substitution;
#[cfg(test)]
mod tests;

pub(in crate::simplify) use edge::{LinkEdge, LinkKind};

use chain::LinkChain;
use hubs::Hubs;

#[derive(Clone, Copy, Debug)]
struct Slab {
    start: u32,
    len: u32,
    capacity: u32,
    kind: LinkKind,
}

/// All links of a mesh.
#[derive(Debug)]
pub(in crate::simplify) struct Links {
    slabs: Vec<Slab>,
    entries: Vec<u32>,
    /// For each of `entries`, the triangle that begins with it. Empty unless triangles are followed.
    triangles: Vec<u32>,
    follows_triangles: bool,
    /// Whether each position had a triangle with an opposite copy in the original mesh; empty if none had.
    has_two_sides: Vec<bool>,
    ring: Vec<u32>,
    ring_triangles: Vec<u32>,
    edges: Vec<LinkEdge>,
    chain: LinkChain,
    hubs: Hubs,
}

/// Maximum number of triangles around one position among which the nearest one is searched.
const MAX_SAMPLED_EDGES: usize = 256;

/// Number of entries that a new slab can grow by.
const SLACK: u32 = 2;

impl Links {
    /// Builds the links of `position_count` positions from triangles of positions.
    pub(in crate::simplify) fn new(
        position_count: usize,
        triangles: &[[u32; 3]],
        follows_triangles: bool,
    ) -> Self {
        let mut first = vec![0u32; position_count + 1];
        for &p in triangles.iter().flatten() {
            first[p as usize + 1] += 1;
        }
        for p in 0..position_count {
            first[p + 1] += first[p];
        }
        let mut cursor = first.clone();
        let mut star = vec![0u32; triangles.len() * 3];
        for (t, corners) in triangles.iter().enumerate() {
            for &p in corners {
                let c = &mut cursor[p as usize];
                star[*c as usize] = t as u32;
                *c += 1;
            }
        }
        drop(cursor);
        let mut links = Self {
            slabs: Vec::with_capacity(position_count),
            entries: Vec::with_capacity(triangles.len() * 3 + position_count * (SLACK as usize + 1)),
            triangles: Vec::new(),
            follows_triangles,
            has_two_sides: Vec::new(),
            ring: Vec::new(),
            ring_triangles: Vec::new(),
            edges: Vec::new(),
            chain: LinkChain::default(),
            hubs: Hubs::default(),
        };
        let mut edges = Vec::new();
        for p in 0..position_count {
            edges.clear();
            for &t in &star[first[p] as usize..first[p + 1] as usize] {
                let [a, b, c] = triangles[t as usize];
                let (a, b) = match p as u32 {
                    p if p == a => (b, c),
                    p if p == b => (c, a),
                    _ => (a, b),
                };
                edges.push(LinkEdge { a, b, triangle: t });
            }
            links.slabs.push(Slab { start: 0, len: 0, capacity: 0, kind: LinkKind::Empty });
            links.set(p as u32, &edges);
        }
        let all = 0..position_count as u32;
        if all.clone().any(|p| links.has_opposite_edges(p)) {
            links.has_two_sides = all.map(|p| links.has_opposite_edges(p)).collect();
        }
        links
    }

    /// Whether a position had a triangle with an opposite copy in the original mesh, as in a sheet that is modeled
    /// from both sides. Closed parts that become flat only later do not count.
    pub(in crate::simplify) fn has_two_sides(&self, v: u32) -> bool {
        self.has_two_sides.get(v as usize).is_some_and(|&has_two| has_two)
    }

    /// Whether two triangles at `v` have the same corners in opposite order.
    fn has_opposite_edges(&self, v: u32) -> bool {
        if self.kind(v) != LinkKind::Edges {
            return false;
        }
        let pairs = self.entries(v).chunks_exact(2);
        let mut pairs: Vec<_> = pairs.map(|e| (e[0].min(e[1]), e[0].max(e[1]), e[0] < e[1])).collect();
        pairs.sort_unstable();
        pairs.windows(2).any(|w| (w[0].0, w[0].1) == (w[1].0, w[1].1) && w[0].2 != w[1].2)
    }

    /// Whether the links store triangle indices.
    pub(in crate::simplify) fn follows_triangles(&self) -> bool {
        self.follows_triangles
    }

    /// Whether a position lies on an edge with only one triangle, or only with both sides of one.
    pub(in crate::simplify) fn is_boundary(&self, v: u32) -> bool {
        match self.kind(v) {
            LinkKind::Open => true,
            LinkKind::Edges => {
                // For each triangle and neighbor, whether the triangle begins with it, and the other neighbor.
                let pairs = self.entries(v).chunks_exact(2);
                let mut sides: Vec<_> =
                    pairs.flat_map(|pair| [(pair[0], true, pair[1]), (pair[1], false, pair[0])]).collect();
                sides.sort_unstable();
                sides.chunk_by(|a, b| a.0 == b.0).any(|run| match *run {
                    [_] => true,
                    [(_, a_begins, a), (_, b_begins, b)] => {
                        self.has_two_sides(v) && a_begins != b_begins && a == b
                    }
                    _ => false,
                })
            }
            _ => false,
        }
    }

    /// Returns how the link of `v` is stored.
    #[inline]
    pub(in crate::simplify) fn kind(&self, v: u32) -> LinkKind {
        self.slabs[v as usize].kind
    }

    /// Returns the entries of the link of `v`; their meaning depends on the kind.
    #[inline]
    pub(in crate::simplify) fn entries(&self, v: u32) -> &[u32] {
        let slab = self.slabs[v as usize];
        &self.entries[slab.start as usize..][..slab.len as usize]
    }

    /// Returns the triangles that begin with the entries of `v`; only if triangles are followed.
    #[inline]
    pub(in crate::simplify) fn entry_triangles(&self, v: u32) -> &[u32] {
        let slab = self.slabs[v as usize];
        &self.triangles[slab.start as usize..][..slab.len as usize]
    }

    /// Number of triangles around `v`.
    #[inline]
    pub(in crate::simplify) fn triangle_count(&self, v: u32) -> usize {
        let slab = self.slabs[v as usize];
        match slab.kind {
            LinkKind::Empty => 0,
            LinkKind::Closed => slab.len as usize,
            LinkKind::Open => slab.len as usize - 1,
            LinkKind::Edges => slab.len as usize / 2,
        }
    }

    /// Collects the edges of the link of `v` into `out`.
    pub(in crate::simplify) fn edges_into(&self, v: u32, out: &mut Vec<LinkEdge>) {
        out.clear();
        let slab = self.slabs[v as usize];
        let entries = &self.entries[slab.start as usize..][..slab.len as usize];
        let triangle = |i: usize| {
            if self.follows_triangles { self.triangles[slab.start as usize + i] } else { 0 }
        };
        let n = entries.len();
        match slab.kind {
            LinkKind::Empty => {}
            LinkKind::Closed => out.extend((0..n).map(|i| LinkEdge {
                a: entries[i],
                b: entries[if i + 1 == n { 0 } else { i + 1 }],
                triangle: triangle(i),
            })),
            LinkKind::Open => out.extend((0..n - 1).map(|i| LinkEdge {
                a: entries[i],
                b: entries[i + 1],
                triangle: triangle(i),
            })),
            LinkKind::Edges => out.extend((0..n / 2).map(|i| LinkEdge {
                a: entries[2 * i],
                b: entries[2 * i + 1],
                triangle: triangle(2 * i),
            })),
        }
    }

    /// Collects the edges of the link of `v` into `out`; of very many edges, only some, evenly spread.
    ///
    /// This is for measuring distances. Visiting every triangle of a hub after each collapse of one of its
    /// neighbors would take quadratic time; the nearest of some triangles is never too near.
    pub(in crate::simplify) fn sampled_edges_into(&self, v: u32, out: &mut Vec<LinkEdge>) {
        let count = self.triangle_count(v);
        if count <= MAX_SAMPLED_EDGES {
            return self.edges_into(v, out);
        }
        out.clear();
        let stride = count.div_ceil(MAX_SAMPLED_EDGES);
        out.extend((0..count).step_by(stride).map(|i| self.edge(v, i)));
    }

    /// Whether two positions have a triangle in common.
    pub(in crate::simplify) fn are_neighbors(&self, p: u32, q: u32) -> bool {
        let (few, many) = if self.entries(p).len() < self.entries(q).len() { (p, q) } else { (q, p) };
        self.entries(few).contains(&many)
    }

    /// Returns edge `i` of the link of `v`.
    fn edge(&self, v: u32, i: usize) -> LinkEdge {
        let slab = self.slabs[v as usize];
        let (first, second) = match slab.kind {
            LinkKind::Edges => (2 * i, 2 * i + 1),
            _ => (i, if i + 1 == slab.len as usize { 0 } else { i + 1 }),
        };
        let start = slab.start as usize;
        LinkEdge {
            a: self.entries[start + first],
            b: self.entries[start + second],
            triangle: if self.follows_triangles { self.triangles[start + first] } else { 0 },
        }
    }

    /// Gives `u` a slab with room for `len` entries: its own, that of the removed `v`, or a new one.
    fn reserve(&mut self, u: u32, v: u32, len: usize) -> u32 {
        let (sv, su) = (self.slabs[v as usize], self.slabs[u as usize]);
        let slab = &mut self.slabs[u as usize];
        if len > su.capacity as usize {
            if v != u && len <= sv.capacity as usize {
                (slab.start, slab.capacity) = (sv.start, sv.capacity);
                let removed = &mut self.slabs[v as usize];
                (removed.start, removed.capacity) = (su.start, su.capacity);
            } else {
                slab.start = self.entries.len() as u32;
                slab.capacity = len as u32 + 2 * SLACK;
                let end = self.entries.len() + slab.capacity as usize;
                self.entries.resize(end, 0);
                if self.follows_triangles {
                    self.triangles.resize(end, 0);
                }
            }
        }
        let slab = &mut self.slabs[u as usize];
        slab.len = len as u32;
        slab.start
    }

    /// Stores a link, as a ring if possible.
    fn set(&mut self, v: u32, edges: &[LinkEdge]) {
        self.hubs.forget(v);
        let mut chain = std::mem::take(&mut self.chain);
        let kind = chain.order(edges);
        let len = chain.entries.len();
        if self.slabs[v as usize].capacity == 0 {
            let slab = &mut self.slabs[v as usize];
            slab.start = self.entries.len() as u32;
            slab.capacity = len as u32 + SLACK;
            let end = self.entries.len() + slab.capacity as usize;
            self.entries.resize(end, 0);
            if self.follows_triangles {
                self.triangles.resize(end, 0);
            }
        }
        let at = self.reserve(v, v, len) as usize;
        self.slabs[v as usize].kind = kind;
        self.entries[at..at + len].copy_from_slice(&chain.entries);
        if self.follows_triangles {
            self.triangles[at..at + len].copy_from_slice(&chain.triangles);
        }
        self.chain = chain;
    }
}
