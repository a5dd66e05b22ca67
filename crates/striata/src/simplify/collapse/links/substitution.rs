//! Updates links when a position is removed, by a collapse or by filling its hole.

use std::ops::Range;

use super::edge::{LinkEdge, LinkKind};
use super::hubs::{HUB_ENTRIES, HubList, remove_entry};
use super::{Links, Slab};

/// Lists of more edges than this stay lists.
const MAX_ORDERED_EDGES: usize = 256;

impl Links {
    /// Replaces `v` by `u` in every link and drops the triangles that lose a corner; the link of `v`
    /// becomes empty.
    ///
    /// Works for any two positions, neighbors or not; the caller decides whether the collapse makes sense.
    pub(in crate::simplify) fn collapse(&mut self, v: u32, u: u32) {
        if !self.splice(v, u) {
            self.merge(v, u);
        }
        // `ring` now contains the neighbors of v, each at least once.
        let mut ring = std::mem::take(&mut self.ring);
        if self.slabs[v as usize].kind == LinkKind::Edges {
            // Rings name each neighbor once; only edge lists repeat them.
            ring.sort_unstable();
            ring.dedup();
        }
        ring.iter().filter(|&&w| w != u).for_each(|&w| self.substitute(w, v, u));
        self.ring = ring;
        self.hubs.forget(v);
        let slab = &mut self.slabs[v as usize];
        slab.kind = LinkKind::Empty;
        slab.len = 0;
    }

    /// Removes `v` with the triangles around it and inserts the triangles of `floor` instead: their
    /// indices, and their corners, which must be neighbors of `v`.
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
        self.hubs.forget(v);
        let slab = &mut self.slabs[v as usize];
        slab.kind = LinkKind::Empty;
        slab.len = 0;
        (self.edges, self.ring) = (edges, ring);
    }

    /// Updates the link of `u` for the collapse if both links are rings; returns false if they are not,
    /// or if the result is not a ring. Leaves the neighbors of `v` in `self.ring`.
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
        // The part of v's ring that replaces v in u's ring.
        let arc: Range<usize>;
        if sv.kind == LinkKind::Closed {
            // u must have v between the same two neighbors.
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
        // The remaining entries may be too few for a ring.
        let least = if su.kind == LinkKind::Closed { 3 } else { 2 };
        if m - 1 + arc.len() < least {
            return false;
        }
        // A neighbor that both rings contain outside the shared triangles would appear twice.
        if arc.clone().any(|i| old.contains(&self.ring[i % n])) {
            return false;
        }
        self.write_splice(v, u, j, arc);
        true
    }

    /// Writes u's ring with entry `j` (which is v) replaced by the arc of v's ring.
    fn write_splice(&mut self, v: u32, u: u32, j: usize, arc: Range<usize>) {
        self.hubs.forget(u);
        let (sv, su) = (self.slabs[v as usize], self.slabs[u as usize]);
        let (n, m) = (sv.len as usize, su.len as usize);
        let len = m - 1 + arc.len();
        if self.follows_triangles {
            // Entry i of the new ring begins the triangle with entry i + 1: the triangles of v follow
            // the arc, shifted by one since the entry before the arc begins the arc's first triangle.
            let own = &self.triangles[su.start as usize..][..m];
            let other = &self.triangles[sv.start as usize..][..n];
            self.ring_triangles.clear();
            self.ring_triangles.extend_from_slice(&own[..j.saturating_sub(1)]);
            if sv.kind == LinkKind::Closed {
                let mut moved: Vec<u32> = (arc.start - 1..arc.end).map(|i| other[i % n]).collect();
                if j == 0 {
                    // The entry before v is the last one of a cycle.
                    let last = moved.remove(0);
                    self.ring_triangles.extend_from_slice(&moved);
                    self.ring_triangles.extend_from_slice(&own[1..m - 1]);
                    self.ring_triangles.push(last);
                } else {
                    self.ring_triangles.extend_from_slice(&moved);
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
        let at = self.reserve(u, v, len);
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

    /// Updates the link of `u` for the collapse, for links of any kind.
    fn merge(&mut self, v: u32, u: u32) {
        let mut edges = std::mem::take(&mut self.edges);
        if self.is_hub(u) {
            self.edges_into(v, &mut edges);
            edges.retain(|e| e.a != u && e.b != u);
            let is_merged = self.merge_into_hub(v, u, &edges);
            if is_merged {
                self.edges = edges;
                return;
            }
        }
        let mut all = Vec::new();
        self.edges_into(u, &mut edges);
        all.extend(edges.iter().filter(|e| e.a != v && e.b != v));
        self.edges_into(v, &mut edges);
        all.extend(edges.iter().filter(|e| e.a != u && e.b != u));
        self.set(u, &all);
        self.edges = edges;
    }

    /// Whether `v` has so many triangles in a list of edges that the list is edited in place. It is not
    /// ordered into a ring before it is shorter, since that would take quadratic time in total.
    fn is_hub(&self, v: u32) -> bool {
        let Slab { len, kind, .. } = self.slabs[v as usize];
        kind == LinkKind::Edges && len as usize > 2 * MAX_ORDERED_EDGES
    }

    /// The long list of edges of `w`, with the places of each of its neighbors.
    fn hub_list(&mut self, w: u32) -> HubList<'_> {
        let slab = &mut self.slabs[w as usize];
        let entries = &mut self.entries[slab.start as usize..][..slab.capacity as usize];
        let triangles = match self.follows_triangles {
            true => &mut self.triangles[slab.start as usize..][..slab.capacity as usize],
            false => &mut [],
        };
        self.hubs.list(w, entries, triangles, &mut slab.len)
    }

    /// Replaces the edges at `v` in the list of `u` by `added`; returns false, having changed nothing, if
    /// there is no room or few edges are left.
    fn merge_into_hub(&mut self, v: u32, u: u32, added: &[LinkEdge]) -> bool {
        self.hub_list(u).replace(v, added, 2 * MAX_ORDERED_EDGES)
    }

    /// Replaces `v` by `u` in the link of `w`, a neighbor of v.
    fn substitute(&mut self, w: u32, v: u32, u: u32) {
        let slab = self.slabs[w as usize];
        let (start, n) = (slab.start as usize, slab.len as usize);
        let ring = &mut self.entries[start..start + n];
        if slab.kind != LinkKind::Edges {
            let is_hub = n > HUB_ENTRIES;
            let hubs = &mut self.hubs;
            let mut place = |ring: &[u32], p| if is_hub { hubs.find(w, ring, p) } else { find(ring, p) };
            let Some(i) = place(ring, v) else { return };
            let (next, last) = (if i + 1 == n { 0 } else { i + 1 }, if i == 0 { n - 1 } else { i - 1 });
            // They are usually adjacent.
            let adjacent = [next, last].into_iter().find(|&k| ring[k] == u);
            let Some(other) = adjacent.or_else(|| place(ring, u)) else {
                ring[i] = u;
                self.hubs.rename(w, v, u);
                return;
            };
            let is_closed = slab.kind == LinkKind::Closed;
            let follows = other == next && (is_closed || next == i + 1);
            let precedes = other == last && (is_closed || last + 1 == i);
            let stays_ring = if is_closed { n > 3 } else { n > 2 };
            if stays_ring && follows != precedes {
                self.hubs.remove(w, v);
                let places = slab.start as usize..(slab.start + slab.len) as usize;
                let is_head = remove_entry(&mut self.entries, places.clone(), i);
                if self.follows_triangles {
                    // The triangle between v and u vanishes; if u comes first, it gets v's other triangle.
                    if precedes {
                        self.triangles[start + last] = self.triangles[start + i];
                    }
                    remove_entry(&mut self.triangles, places, i);
                }
                let slab = &mut self.slabs[w as usize];
                slab.len -= 1;
                slab.start += u32::from(is_head);
                slab.capacity -= u32::from(is_head);
                return;
            }
        }
        if self.is_hub(w) {
            self.hub_list(w).rename(v, u);
            return;
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
}

/// Index of a position in a ring. Blocks are compared as a whole, which is several times faster at hubs.
pub(super) fn find(ring: &[u32], p: u32) -> Option<usize> {
    const BLOCK: usize = 32;
    let has = |block: &[u32]| block.iter().fold(false, |found, &x| found | (x == p));
    let block = ring.chunks(BLOCK).position(has)?;
    let start = block * BLOCK;
    let within = ring[start..].iter().position(|&x| x == p)?;
    Some(start + within)
}
