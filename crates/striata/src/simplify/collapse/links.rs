//! The link of every position: what surrounds it, kept up to date while collapses eat the mesh.
//!
//! The link of `v` is the set of edges opposite to `v` in its triangles. On a manifold it is one cycle or, at
//! a boundary, one path, and is stored as the ordered **ring** of neighbours; no triangle needs to be stored
//! at all. Anywhere else it is stored as a plain list of edges, so that bow-ties, books and repeated triangles
//! work too. A half-edge collapse is then substitution in the links around it:
//!
//! ```text
//!        r1 --- r2                r1 --- r2       ring(u) = .. r1 [v] r5 ..
//!       /  \   /  \              /    /    \      ring(v) = u r1 r2 r3 r4 r5
//!      u -- v -- r3     v -> u  u ------- r3      after: ring(u) = .. r1 r2 r3 r4 r5 ..
//!       \  /   \  /              \    \    /      ring(r1), ring(r5) lose v, the others read u for v
//!        r5 --- r4                r5 --- r4
//! ```
//!
//! Memory: 4 bytes per entry plus slack, 16 bytes a position. Cost of a collapse: the sizes of the links it touches.

/// How the link of a position is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(in crate::simplify) enum LinkKind {
    /// No triangle.
    Empty,
    /// A cycle: entry `i` and its successor, cyclically, span a triangle.
    Closed,
    /// A path: the same, but the last entry has no successor.
    Open,
    /// Pairs of entries, one a triangle.
    Edges,
}

#[derive(Clone, Copy, Debug)]
struct Slab {
    start: u32,
    len: u32,
    capacity: u32,
    kind: LinkKind,
}

/// One edge of a link: the triangle `(v, a, b)`, with its number where triangles are followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::simplify) struct LinkEdge {
    pub(in crate::simplify) a: u32,
    pub(in crate::simplify) b: u32,
    pub(in crate::simplify) triangle: u32,
}

/// All links of a mesh.
#[derive(Debug)]
pub(in crate::simplify) struct Links {
    slabs: Vec<Slab>,
    entries: Vec<u32>,
    /// Beside `entries`: the triangle that the entry begins. Empty unless triangles are followed.
    triangles: Vec<u32>,
    follows_triangles: bool,
    ring: Vec<u32>,
    ring_triangles: Vec<u32>,
    edges: Vec<LinkEdge>,
    chain: Chain,
}

/// Room that a new slab gets beyond its content.
const SLACK: u32 = 2;

impl Links {
    /// Links of `position_count` positions from triangles of positions.
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
            ring: Vec::new(),
            ring_triangles: Vec::new(),
            edges: Vec::new(),
            chain: Chain::default(),
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
        links
    }

    /// True where links know the numbers of their triangles.
    pub(in crate::simplify) fn follows_triangles(&self) -> bool {
        self.follows_triangles
    }

    /// Whether a position lies on an edge of one triangle.
    pub(in crate::simplify) fn is_boundary(&self, v: u32) -> bool {
        match self.kind(v) {
            LinkKind::Open => true,
            LinkKind::Edges => {
                let entries = self.entries(v);
                entries.iter().any(|w| entries.iter().filter(|x| *x == w).count() == 1)
            }
            _ => false,
        }
    }

    /// How the link of `v` is stored.
    #[inline]
    pub(in crate::simplify) fn kind(&self, v: u32) -> LinkKind {
        self.slabs[v as usize].kind
    }

    /// The entries of the link of `v`, as its kind reads them.
    #[inline]
    pub(in crate::simplify) fn entries(&self, v: u32) -> &[u32] {
        let slab = self.slabs[v as usize];
        &self.entries[slab.start as usize..][..slab.len as usize]
    }

    /// The triangles that the entries of `v` begin; only where triangles are followed.
    #[inline]
    pub(in crate::simplify) fn entry_triangles(&self, v: u32) -> &[u32] {
        let slab = self.slabs[v as usize];
        &self.triangles[slab.start as usize..][..slab.len as usize]
    }

    /// Triangles around `v`.
    pub(in crate::simplify) fn triangle_count(&self, v: u32) -> usize {
        let slab = self.slabs[v as usize];
        match slab.kind {
            LinkKind::Empty => 0,
            LinkKind::Closed => slab.len as usize,
            LinkKind::Open => slab.len as usize - 1,
            LinkKind::Edges => slab.len as usize / 2,
        }
    }

    /// The link of `v` edge by edge, into `out`.
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

    /// Replaces `v` by `u` in every link and drops the triangles that lose a corner; the link of `v` ends empty.
    ///
    /// Legal for any two positions, neighbours or not: what is sensible is the caller's business.
    pub(in crate::simplify) fn collapse(&mut self, v: u32, u: u32) {
        if !self.splice(v, u) {
            self.merge(v, u);
        }
        // `ring` now holds the neighbours of v, each at least once.
        let ring = std::mem::take(&mut self.ring);
        for (i, &w) in ring.iter().enumerate() {
            // Rings name each neighbour once; only edge lists repeat them.
            if w != u && (self.slabs[v as usize].kind != LinkKind::Edges || !ring[..i].contains(&w)) {
                self.substitute(w, v, u);
            }
        }
        self.ring = ring;
        let slab = &mut self.slabs[v as usize];
        slab.kind = LinkKind::Empty;
        slab.len = 0;
    }

    /// Takes out `v` with the triangles around it and puts in `floor` instead: numbers and corners of triangles that
    /// have neighbours of `v` at their corners.
    pub(in crate::simplify) fn fill(&mut self, v: u32, floor: &[(u32, [u32; 3])]) {
        let mut edges = std::mem::take(&mut self.edges);
        let mut ring = std::mem::take(&mut self.ring);
        ring.clear();
        ring.extend_from_slice(self.entries(v));
        ring.sort_unstable();
        ring.dedup();
        for &w in &ring {
            self.edges_into(w, &mut edges);
            edges.retain(|e| e.a != v && e.b != v);
            for &(triangle, [a, b, c]) in floor {
                for [corner, a, b] in [[a, b, c], [b, c, a], [c, a, b]] {
                    if corner == w {
                        edges.push(LinkEdge { a, b, triangle });
                    }
                }
            }
            self.set(w, &edges);
        }
        let slab = &mut self.slabs[v as usize];
        slab.kind = LinkKind::Empty;
        slab.len = 0;
        (self.edges, self.ring) = (edges, ring);
    }

    /// The link of `u` after the collapse, where both links are rings; false where they are not, or
    /// where the result is no ring. Leaves the neighbours of `v` in `self.ring`.
    fn splice(&mut self, v: u32, u: u32) -> bool {
        let (sv, su) = (self.slabs[v as usize], self.slabs[u as usize]);
        let is_ring = |kind| matches!(kind, LinkKind::Closed | LinkKind::Open);
        self.ring.clear();
        self.ring.extend_from_slice(&self.entries[sv.start as usize..][..sv.len as usize]);
        if !is_ring(sv.kind) || !is_ring(su.kind) {
            return false;
        }
        let n = self.ring.len();
        let old = &self.entries[su.start as usize..][..su.len as usize];
        let m = old.len();
        let (Some(k), Some(j)) = (self.ring.iter().position(|&w| w == u), old.iter().position(|&w| w == v))
        else {
            return false;
        };
        // The part of v's ring that u takes over, and where it enters u's ring.
        let arc: std::ops::Range<usize>;
        if sv.kind == LinkKind::Closed {
            // u must see v between the same two neighbours.
            let interior = su.kind == LinkKind::Closed || (j > 0 && j + 1 < m);
            if !interior || n < 3 || m < 3 {
                return false;
            }
            let (before, after) = (old[(j + m - 1) % m], old[(j + 1) % m]);
            if before != self.ring[(k + 1) % n] || after != self.ring[(k + n - 1) % n] || before == after {
                return false;
            }
            arc = k + 2..k + n - 1;
        } else {
            if su.kind != LinkKind::Open {
                return false;
            }
            if k == 0 && j == m - 1 && m >= 2 && old[m - 2] == self.ring[1] {
                arc = 2..n;
            } else if k == n - 1 && j == 0 && m >= 2 && old[1] == self.ring[n - 2] {
                arc = 0..n - 2;
            } else {
                return false;
            }
        }
        // What is left may be too small for a ring.
        let least = if su.kind == LinkKind::Closed { 3 } else { 2 };
        if m - 1 + arc.len() < least {
            return false;
        }
        // A neighbour that both rings name outside the shared triangles would stand twice.
        if arc.clone().any(|i| old.contains(&self.ring[i % n])) {
            return false;
        }
        self.write_splice(v, u, j, arc);
        true
    }

    /// Writes u's ring with entry `j` (that is, v) replaced by the arc of v's ring.
    fn write_splice(&mut self, v: u32, u: u32, j: usize, arc: std::ops::Range<usize>) {
        let (sv, su) = (self.slabs[v as usize], self.slabs[u as usize]);
        let (n, m) = (sv.len as usize, su.len as usize);
        let len = m - 1 + arc.len();
        if self.follows_triangles {
            // Entry i of the new ring begins the triangle with entry i + 1: the triangles of v follow the
            // arc, shifted by one since the entry before the arc begins the arc's first triangle.
            let own = &self.triangles[su.start as usize..][..m];
            let other = &self.triangles[sv.start as usize..][..n];
            self.ring_triangles.clear();
            self.ring_triangles.extend_from_slice(&own[..j.saturating_sub(1)]);
            if sv.kind == LinkKind::Closed {
                let mut taken: Vec<u32> = (arc.start - 1..arc.end).map(|i| other[i % n]).collect();
                if j == 0 {
                    // The entry before v is the last one of a cycle.
                    let last = taken.remove(0);
                    self.ring_triangles.extend_from_slice(&taken);
                    self.ring_triangles.extend_from_slice(&own[1..m - 1]);
                    self.ring_triangles.push(last);
                } else {
                    self.ring_triangles.extend_from_slice(&taken);
                    self.ring_triangles.extend_from_slice(&own[j + 1..]);
                }
            } else if arc.start == 2 {
                // .. r1 v  ->  .. r1 r2 .. rm: r1 begins the triangle (r1, r2), which was v's entry 1.
                self.ring_triangles.extend((1..n).map(|i| other[i]));
            } else {
                // v r(n-2) ..  ->  r0 r1 .. r(n-2) ..
                self.ring_triangles.extend((0..n - 2).map(|i| other[i]));
                self.ring_triangles.extend_from_slice(&own[1..]);
            }
            debug_assert_eq!(self.ring_triangles.len(), len, "one triangle entry for each ring entry");
        }
        let at = self.room(u, v, len);
        let (start, end) = (at as usize, at as usize + len);
        if at == su.start {
            // In place: move the tail, then fill the gap.
            self.entries.copy_within(start + j + 1..start + m, start + j + arc.len());
        } else {
            self.entries.copy_within(su.start as usize..su.start as usize + j, start);
            self.entries.copy_within(su.start as usize + j + 1..su.start as usize + m, start + j + arc.len());
        }
        for (slot, i) in self.entries[start + j..end].iter_mut().zip(arc) {
            *slot = self.ring[if i >= n { i - n } else { i }];
        }
        if self.follows_triangles {
            self.triangles[start..end].copy_from_slice(&self.ring_triangles);
        }
    }

    /// Gives `u` a slab for `len` entries: its own, the dying `v`'s, or a new one.
    fn room(&mut self, u: u32, v: u32, len: usize) -> u32 {
        let (sv, su) = (self.slabs[v as usize], self.slabs[u as usize]);
        let slab = &mut self.slabs[u as usize];
        if len > su.capacity as usize {
            if v != u && len <= sv.capacity as usize {
                (slab.start, slab.capacity) = (sv.start, sv.capacity);
                let dying = &mut self.slabs[v as usize];
                (dying.start, dying.capacity) = (su.start, su.capacity);
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

    /// The link of `u` after the collapse, for links of any kind.
    fn merge(&mut self, v: u32, u: u32) {
        let mut edges = std::mem::take(&mut self.edges);
        let mut all = Vec::new();
        self.edges_into(u, &mut edges);
        all.extend(edges.iter().filter(|e| e.a != v && e.b != v));
        self.edges_into(v, &mut edges);
        all.extend(edges.iter().filter(|e| e.a != u && e.b != u));
        self.set(u, &all);
        self.edges = edges;
    }

    /// Reads `u` for `v` in the link of `w`, a neighbour of v.
    fn substitute(&mut self, w: u32, v: u32, u: u32) {
        let slab = self.slabs[w as usize];
        let (start, n) = (slab.start as usize, slab.len as usize);
        let ring = &mut self.entries[start..start + n];
        if slab.kind != LinkKind::Edges {
            let Some(i) = ring.iter().position(|&x| x == v) else { return };
            let Some(other) = ring.iter().position(|&x| x == u) else {
                ring[i] = u;
                return;
            };
            let (next, last) = (if i + 1 == n { 0 } else { i + 1 }, if i == 0 { n - 1 } else { i - 1 });
            let is_closed = slab.kind == LinkKind::Closed;
            let follows = other == next && (is_closed || next == i + 1);
            let precedes = other == last && (is_closed || last + 1 == i);
            let stays_ring = if is_closed { n > 3 } else { n > 2 };
            if stays_ring && follows != precedes {
                ring.copy_within(i + 1.., i);
                self.slabs[w as usize].len -= 1;
                if self.follows_triangles {
                    // The triangle between v and u vanishes; where u comes first, it takes over v's other one.
                    let triangles = &mut self.triangles[start..start + n];
                    if precedes {
                        triangles[last] = triangles[i];
                    }
                    triangles.copy_within(i + 1.., i);
                }
                return;
            }
        }
        let mut edges = std::mem::take(&mut self.edges);
        self.edges_into(w, &mut edges);
        for e in &mut edges {
            for x in [&mut e.a, &mut e.b] {
                if *x == v {
                    *x = u;
                }
            }
        }
        edges.retain(|e| e.a != e.b);
        self.set(w, &edges);
        self.edges = edges;
    }

    /// Stores a link, as a ring if it is one.
    fn set(&mut self, v: u32, edges: &[LinkEdge]) {
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
        let at = self.room(v, v, len) as usize;
        self.slabs[v as usize].kind = kind;
        self.entries[at..at + len].copy_from_slice(&chain.entries);
        if self.follows_triangles {
            self.triangles[at..at + len].copy_from_slice(&chain.triangles);
        }
        self.chain = chain;
    }
}

/// Scratch for putting link edges in order.
#[derive(Debug, Default)]
struct Chain {
    entries: Vec<u32>,
    triangles: Vec<u32>,
    order: Vec<u32>,
}

impl Chain {
    /// Orders the edges head to tail; an edge list where that gives no single cycle or path.
    fn order(&mut self, edges: &[LinkEdge]) -> LinkKind {
        self.entries.clear();
        self.triangles.clear();
        if edges.is_empty() {
            return LinkKind::Empty;
        }
        let kind = if edges.len() <= 24 { self.order_few(edges) } else { self.order_many(edges) };
        if kind == LinkKind::Edges {
            self.entries.clear();
            self.triangles.clear();
            for e in edges {
                self.entries.extend([e.a, e.b]);
                self.triangles.extend([e.triangle; 2]);
            }
        }
        kind
    }

    /// Quadratic search: the usual six edges need no map.
    fn order_few(&mut self, edges: &[LinkEdge]) -> LinkKind {
        let n = edges.len();
        let mut start = 0;
        let mut start_count = 0;
        for (i, e) in edges.iter().enumerate() {
            let mut has_predecessor = false;
            for (j, f) in edges.iter().enumerate() {
                // Two edges may not leave, nor enter, the same neighbour.
                if i != j && (e.a == f.a || e.b == f.b) {
                    return LinkKind::Edges;
                }
                has_predecessor |= e.a == f.b;
            }
            if !has_predecessor {
                start = i;
                start_count += 1;
            }
        }
        if start_count > 1 {
            return LinkKind::Edges;
        }
        let mut e = edges[start];
        for _ in 0..n {
            self.entries.push(e.a);
            self.triangles.push(e.triangle);
            match edges.iter().find(|f| f.a == e.b) {
                Some(f) => e = *f,
                None => break,
            }
            // Back too early: there is a second cycle.
            if e == edges[start] {
                break;
            }
        }
        self.close(n, start_count, edges[start], e)
    }

    /// The same with a sorted order of the edges' tails, for the hubs of large fans.
    fn order_many(&mut self, edges: &[LinkEdge]) -> LinkKind {
        self.order.clear();
        self.order.extend(0..edges.len() as u32);
        self.order.sort_unstable_by_key(|&i| (edges[i as usize].a, i));
        let tail = |&i: &u32| edges[i as usize].a;
        if self.order.windows(2).any(|w| tail(&w[0]) == tail(&w[1])) {
            return LinkKind::Edges;
        }
        let mut heads: Vec<u32> = edges.iter().map(|e| e.b).collect();
        heads.sort_unstable();
        if heads.windows(2).any(|w| w[0] == w[1]) {
            return LinkKind::Edges;
        }
        let mut starts = edges.iter().filter(|e| heads.binary_search(&e.a).is_err());
        let start = starts.next().copied();
        let start_count = usize::from(start.is_some()) + starts.count();
        if start_count > 1 {
            return LinkKind::Edges;
        }
        let first = start.unwrap_or(edges[0]);
        let mut e = first;
        for _ in 0..edges.len() {
            self.entries.push(e.a);
            self.triangles.push(e.triangle);
            match self.order.binary_search_by_key(&e.b, tail) {
                Ok(i) => e = edges[self.order[i] as usize],
                Err(_) => break,
            }
            if e == first {
                break;
            }
        }
        self.close(edges.len(), start_count, first, e)
    }

    fn close(&mut self, n: usize, start_count: usize, first: LinkEdge, last: LinkEdge) -> LinkKind {
        if self.entries.len() != n {
            return LinkKind::Edges;
        }
        if start_count == 1 {
            self.entries.push(last.b);
            self.triangles.push(last.triangle);
            return LinkKind::Open;
        }
        // A cycle of two is a triangle and its reverse: no ring to walk.
        if n < 3 || last != first { LinkKind::Edges } else { LinkKind::Closed }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::canonical_triangles;

    /// All triangles that the links imply, each as often as it is seen from its smallest corner.
    fn triangles_of(links: &Links) -> Vec<[u32; 3]> {
        let mut out = Vec::new();
        let mut edges = Vec::new();
        for v in 0..links.slabs.len() as u32 {
            links.edges_into(v, &mut edges);
            out.extend(edges.iter().filter(|e| v < e.a && v < e.b).map(|e| [v, e.a, e.b]));
        }
        canonical_triangles(&out)
    }

    #[test]
    fn filled_holes_are_what_is_left_of_a_collapse() {
        // A strip, a book of three pages and a tetrahedron on one of them.
        let triangles = [
            [0, 1, 2],
            [2, 1, 3],
            [2, 3, 4],
            [4, 3, 5],
            [1, 0, 6],
            [1, 6, 7],
            [0, 1, 8],
            [8, 1, 9],
            [3, 1, 9],
            [3, 9, 5],
        ];
        for v in 0..10 {
            for u in (0..10).filter(|&u| u != v) {
                let (mut filled, mut collapsed) =
                    (Links::new(10, &triangles, true), Links::new(10, &triangles, true));
                if !collapsed.entries(v).contains(&u) {
                    continue;
                }
                let mut edges = Vec::new();
                filled.edges_into(v, &mut edges);
                let kept = edges.iter().filter(|e| e.a != u && e.b != u);
                let floor: Vec<_> = kept.map(|e| (20 + e.triangle, [u, e.a, e.b])).collect();
                filled.fill(v, &floor);
                collapsed.collapse(v, u);
                assert_eq!(triangles_of(&filled), triangles_of(&collapsed), "{v} -> {u}");
                assert_eq!(filled.kind(v), LinkKind::Empty);
                filled.edges_into(u, &mut edges);
                let numbers: Vec<u32> = edges.iter().map(|e| e.triangle).filter(|&t| t >= 20).collect();
                assert_eq!(numbers.len(), floor.len(), "{v} -> {u}: numbers of new triangles");
            }
        }
    }

    #[test]
    fn links_without_triangles_are_empty() {
        let pillow = [[0, 1, 2], [0, 2, 1]];
        for (triangles, left) in [(&pillow[..1], 0), (&pillow[..], 0)] {
            let mut links = Links::new(3, triangles, false);
            links.collapse(0, 1);
            assert_eq!([0, 1, 2].map(|p| links.kind(p)), [LinkKind::Empty; 3]);
            assert_eq!([0, 1, 2].map(|p| links.triangle_count(p)), [left; 3]);
        }
        // A tetrahedron folds into a pillow.
        let mut links = Links::new(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]], true);
        links.collapse(0, 1);
        assert_eq!([1, 2, 3].map(|p| links.triangle_count(p)), [2; 3]);
        links.collapse(1, 2);
        assert_eq!([1, 2, 3].map(|p| links.kind(p)), [LinkKind::Empty; 3]);
    }

    fn check_against_substitution(triangles: &[[u32; 3]], count: usize, collapses: &[(u32, u32)]) {
        for follows in [true, false] {
            check_one(triangles.to_vec(), count, collapses, follows);
        }
    }

    fn check_one(mut triangles: Vec<[u32; 3]>, count: usize, collapses: &[(u32, u32)], follows: bool) {
        let mut links = Links::new(count, &triangles, follows);
        let numbered = triangles.clone();
        let mut alive: Vec<usize> = (0..triangles.len()).collect();
        for &(v, u) in collapses.iter().filter(|(v, u)| v != u) {
            links.collapse(v, u);
            for t in &mut triangles {
                *t = t.map(|x| if x == v { u } else { x });
            }
            alive.retain(|&t| {
                let [a, b, c] = triangles[t];
                a != b && b != c && c != a
            });
            let expected: Vec<_> = alive.iter().map(|&t| triangles[t]).collect();
            assert_eq!(
                triangles_of(&links),
                canonical_triangles(&expected),
                "after {v} -> {u} of {numbered:?}"
            );
            let mut edges = Vec::new();
            for w in (0..count as u32).filter(|_| follows) {
                links.edges_into(w, &mut edges);
                for e in &edges {
                    let found = canonical_triangles(&[[w, e.a, e.b]]);
                    assert_eq!(
                        found,
                        canonical_triangles(&[triangles[e.triangle as usize]]),
                        "triangle numbers"
                    );
                }
            }
        }
    }

    #[test]
    fn hexagon_is_one_ring_and_collapses_to_a_fan() {
        let fan: Vec<[u32; 3]> = (0..6).map(|i| [0, 1 + i, 1 + (i + 1) % 6]).collect();
        let links = Links::new(7, &fan, false);
        assert_eq!(links.kind(0), LinkKind::Closed);
        assert_eq!(links.kind(1), LinkKind::Open);
        check_against_substitution(&fan, 7, &[(0, 1), (3, 4), (5, 1)]);
    }

    #[test]
    fn rings_of_a_grid_equal_substitution() {
        // Interior and border vertices, each collapsed to each neighbour in turn.
        let at = |x: u32, y: u32| 5 * y + x;
        let mut grid = Vec::new();
        for y in 0..4 {
            for x in 0..4 {
                grid.extend([
                    [at(x, y), at(x + 1, y), at(x + 1, y + 1)],
                    [at(x, y), at(x + 1, y + 1), at(x, y + 1)],
                ]);
            }
        }
        let links = Links::new(25, &grid, false);
        for v in 0..25 {
            for &u in links.entries(v) {
                for &w in links.entries(u) {
                    check_against_substitution(&grid, 25, &[(v, u), (u, if w == v { u } else { w })]);
                }
            }
        }
    }

    #[test]
    fn bow_tie_of_equal_cycles_is_no_ring() {
        for n in [3u32, 30] {
            let cone = |base: u32| (0..n).map(move |i| [0, base + i, base + (i + 1) % n]);
            let both: Vec<[u32; 3]> = cone(1).chain(cone(1 + n)).collect();
            let links = Links::new(1 + 2 * n as usize, &both, false);
            assert_eq!(links.kind(0), LinkKind::Edges);
            assert_eq!(links.triangle_count(0), 2 * n as usize);
        }
    }

    #[test]
    fn random_collapses_of_random_soups_equal_substitution() {
        let mut state = 1u64;
        let mut next = move |n: u64| {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 33) % n
        };
        for round in 0..300 {
            let count = 5 + next(12) as u32;
            let mut triangles = Vec::new();
            if round % 2 == 0 {
                // A strip-like grid, mostly manifold.
                for i in 0..count - 2 {
                    triangles.push(if i % 2 == 0 { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] });
                }
                triangles.push([count - 1, count - 2, 0]);
            }
            for _ in 0..next(20) {
                let t = [next(u64::from(count)), next(u64::from(count)), next(u64::from(count))]
                    .map(|x| x as u32);
                if t[0] != t[1] && t[1] != t[2] && t[2] != t[0] {
                    triangles.push(t);
                }
            }
            let mut left: Vec<u32> = (0..count).collect();
            let mut collapses = Vec::new();
            while left.len() > 1 {
                let v = left.swap_remove(next(left.len() as u64) as usize);
                collapses.push((v, left[next(left.len() as u64) as usize]));
            }
            check_against_substitution(&triangles, count as usize, &collapses);
        }
    }
}
