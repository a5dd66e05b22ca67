//! The triangles around a position without coordinates: gathered alike for every kind of star.

use crate::simplify::collapse::links::{LinkEdge, LinkKind, Links};

/// Neighbors and triangles of one position at a time.
#[derive(Debug, Default)]
pub(in crate::simplify) struct StarRing {
    /// Neighbors, each once.
    pub ids: Vec<u32>,
    /// Triangle indices, if the links store them.
    pub triangles: Vec<u32>,
    triangle_count: usize,
    /// Corners of each triangle as indices into `ids`; empty for links that are rings or open ones, whose
    /// triangle i is (i, i + 1).
    pairs: Vec<[u32; 2]>,
    /// Whether triangles with opposite copies belong to a sheet that is modeled from both sides.
    has_two_sides: bool,
    edges: Vec<LinkEdge>,
}

/// Triangles at the edge to a neighbor, as indices.
#[derive(Default)]
struct EdgeTriangles {
    /// The first two that end at the neighbor.
    before: [Option<usize>; 2],
    /// The first two that begin at the neighbor.
    after: [Option<usize>; 2],
    /// Number of triangles that begin or end at the neighbor.
    count: usize,
}

/// How the surface continues at the edge to a neighbor.
pub(in crate::simplify) enum EdgeSides {
    /// The edge has one triangle, or one and its opposite copy.
    Boundary,
    /// The edge has three or more triangles, or two that disagree about its direction.
    Branch,
    /// The pairs of triangles that end and begin at the neighbor. A sheet that is modeled from both sides has two.
    Inner([Option<[usize; 2]>; 2]),
}

impl StarRing {
    /// Gathers the triangles around `v`, with their indices if the links store them.
    pub(in crate::simplify) fn gather(&mut self, links: &Links, v: u32) {
        self.pairs.clear();
        self.has_two_sides = links.has_two_sides(v);
        match links.kind(v) {
            LinkKind::Closed | LinkKind::Open => {
                self.ids.clear();
                self.ids.extend_from_slice(links.entries(v));
                self.triangle_count = links.triangle_count(v);
                if links.follows_triangles() {
                    self.triangles.clear();
                    self.triangles.extend_from_slice(&links.entry_triangles(v)[..self.triangle_count]);
                }
            }
            LinkKind::Empty | LinkKind::Edges => self.gather_edges(links, v),
        }
    }

    fn gather_edges(&mut self, links: &Links, v: u32) {
        links.edges_into(v, &mut self.edges);
        self.triangle_count = self.edges.len();
        self.ids.clear();
        self.ids.extend(self.edges.iter().flat_map(|e| [e.a, e.b]));
        self.ids.sort_unstable();
        self.ids.dedup();
        let index_of = |id: u32| self.ids.binary_search(&id).unwrap_or(0) as u32;
        self.pairs.extend(self.edges.iter().map(|e| [index_of(e.a), index_of(e.b)]));
        self.triangles.clear();
        self.triangles.extend(self.edges.iter().map(|e| e.triangle));
    }

    /// Number of triangles.
    #[inline]
    pub(in crate::simplify) fn triangle_count(&self) -> usize {
        self.triangle_count
    }

    /// Returns the corners of each triangle if they are not consecutive neighbors.
    #[inline]
    pub(super) fn pairs(&self) -> Option<&[[u32; 2]]> {
        if self.pairs.is_empty() { None } else { Some(&self.pairs) }
    }

    /// Returns the two neighbors that span triangle `t`.
    #[inline]
    pub(in crate::simplify) fn triangle(&self, t: usize) -> [usize; 2] {
        if self.pairs.is_empty() {
            [t, if t + 1 == self.ids.len() { 0 } else { t + 1 }]
        } else {
            self.pairs[t].map(|i| i as usize)
        }
    }

    /// Whether neighbors `i` and `k` span a triangle with the center.
    pub(super) fn is_edge(&self, i: usize, k: usize) -> bool {
        if self.pairs.is_empty() {
            let (low, high) = (i.min(k), i.max(k));
            let wraps = self.triangle_count == self.ids.len();
            high - low == 1 || (wraps && low == 0 && high + 1 == self.ids.len())
        } else {
            self.pairs.iter().any(|pair| pair.contains(&(i as u32)) && pair.contains(&(k as u32)))
        }
    }

    /// Visits the triangles that begin or end at neighbor `k`.
    #[inline]
    pub(super) fn visit_triangles_at(&self, k: usize, mut visit: impl FnMut(usize)) {
        if self.pairs.is_empty() {
            // Triangle k begins at the neighbor, the one before ends at it.
            let before = if k == 0 { self.ids.len() - 1 } else { k - 1 };
            [k, before].into_iter().filter(|&t| t < self.triangle_count).for_each(visit);
        } else {
            let at = (0..self.pairs.len()).filter(|&t| self.pairs[t].contains(&(k as u32)));
            at.for_each(&mut visit);
        }
    }

    /// Returns the index of a neighbor.
    pub(in crate::simplify) fn index_of(&self, id: u32) -> Option<usize> {
        self.ids.iter().position(|&other| other == id)
    }

    /// Returns how the surface continues at the edge to neighbor `i`.
    pub(in crate::simplify) fn sides(&self, i: usize) -> EdgeSides {
        let EdgeTriangles { before, after, count } = self.triangles_at(i);
        match (before, after) {
            _ if count == 1 => EdgeSides::Boundary,
            ([Some(t), None], [Some(s), None]) if self.are_opposite(t, s) => EdgeSides::Boundary,
            ([Some(t), None], [Some(s), None]) => EdgeSides::Inner([Some([t, s]), None]),
            ([Some(t), Some(u)], [Some(s), Some(r)]) if count == 4 && self.are_two_sided([t, u], [s, r]) => {
                // The triangle that continues a side at the edge is not the opposite copy.
                let sides = if self.are_opposite(t, s) { [[t, r], [u, s]] } else { [[t, s], [u, r]] };
                EdgeSides::Inner(sides.map(Some))
            }
            _ => EdgeSides::Branch,
        }
    }

    /// Whether each triangle has an opposite copy, as in a sheet that is modeled from both sides.
    pub(in crate::simplify) fn is_two_sided(&self) -> bool {
        self.has_two_sides
            && !self.pairs.is_empty()
            && self.pairs.iter().all(|&[a, b]| self.pairs.contains(&[b, a]))
    }

    /// Whether two triangles are both sides of a sheet: they have the same corners in opposite order.
    fn are_opposite(&self, t: usize, s: usize) -> bool {
        let [a, b] = self.triangle(t);
        self.has_two_sides && self.triangle(s) == [b, a]
    }

    /// Whether four triangles at an edge are two different ones and their opposite copies.
    fn are_two_sided(&self, [t, u]: [usize; 2], [s, r]: [usize; 2]) -> bool {
        self.triangle(t) != self.triangle(u)
            && (self.are_opposite(t, s) && self.are_opposite(u, r)
                || self.are_opposite(t, r) && self.are_opposite(u, s))
    }

    fn triangles_at(&self, i: usize) -> EdgeTriangles {
        if self.pairs.is_empty() {
            let n = self.ids.len();
            let is_closed = self.triangle_count == n;
            let before = if i > 0 { Some(i - 1) } else { is_closed.then_some(n - 1) };
            let after = (i < self.triangle_count).then_some(i);
            let count = usize::from(before.is_some()) + usize::from(after.is_some());
            return EdgeTriangles { before: [before, None], after: [after, None], count };
        }
        let mut found = EdgeTriangles::default();
        for (t, pair) in self.pairs.iter().enumerate() {
            let [a, b] = pair.map(|x| x as usize);
            for (end, side) in [(a, &mut found.after), (b, &mut found.before)] {
                if end == i {
                    found.count += 1;
                    if let Some(place) = side.iter_mut().find(|place| place.is_none()) {
                        *place = Some(t);
                    }
                }
            }
        }
        found
    }
}
