//! Link condition: whether a collapse preserves the topology, for any kind of link.
//!
//! On a manifold this is the condition of [DEGN99]: `v` and `u` may share only neighbors that span a triangle
//! with both, or the collapse would pinch the surface. The same condition applies at edges with three or more
//! triangles: a collapse must not create a triangle that exists already, or a neighbor without any triangle.

use super::links::{LinkEdge, LinkKind, Links};

/// A target may not get more neighbors than this, unless it had them before: hubs cost quadratic time.
const MAX_VALENCE: usize = 40;
/// Maximum number of triangles that one collapse may remove, since the sequence counts them in a byte.
pub(in crate::simplify) const MAX_REMOVED: usize = 255;

/// Rules of the link condition, and scratch for links that are not rings.
#[derive(Debug, Default)]
pub(in crate::simplify) struct Legality {
    /// Whether separate parts may merge, which disables the tests against pinching.
    pub may_merge: bool,
    /// Whether whole parts may vanish, so that a soup of parts can shrink.
    pub may_vanish: bool,
    apexes: Vec<u32>,
    edges: Vec<LinkEdge>,
    other: Vec<LinkEdge>,
}

impl Legality {
    /// Whether `v` may be collapsed to its neighbor `u`.
    pub(in crate::simplify) fn allows(&mut self, links: &Links, v: u32, u: u32) -> bool {
        let is_ring = |p| matches!(links.kind(p), LinkKind::Closed | LinkKind::Open);
        if is_ring(v) && is_ring(u) {
            return self.rings_allow(links, v, u);
        }
        self.edges_allow(links, v, u)
    }

    fn edges_allow(&mut self, links: &Links, v: u32, u: u32) -> bool {
        links.edges_into(v, &mut self.edges);
        let other_count = links.triangle_count(u);
        self.apexes.clear();
        let mut removed = 0;
        for e in &self.edges {
            if e.a == u || e.b == u {
                removed += 1;
                self.apexes.push(if e.a == u { e.b } else { e.a });
            }
        }
        self.apexes.sort_unstable();
        let kept = self.edges.len() + other_count - 2 * removed;
        if (kept == 0 && !self.may_vanish) || removed > MAX_REMOVED || kept > MAX_VALENCE.max(other_count) {
            return false;
        }
        if self.may_merge {
            // Merged parts are tangled anyway.
            return true;
        }
        let is_apex = |x: u32| self.apexes.binary_search(&x).is_ok();
        let mut neighbors = self.edges.iter().flat_map(|e| [e.a, e.b]).filter(|&x| x != u);
        if neighbors.any(|x| !is_apex(x) && links.are_neighbors(x, u)) {
            return false;
        }
        // Two apexes joined on both sides: the collapse would fold a tetrahedron flat.
        let both = |e: &&LinkEdge| is_apex(e.a) && is_apex(e.b);
        self.other.clear();
        if self.edges.iter().any(|e| both(&e)) {
            links.edges_into(u, &mut self.other);
        }
        let folds = self
            .edges
            .iter()
            .filter(both)
            .any(|e| self.other.iter().any(|f| (f.a == e.a && f.b == e.b) || (f.a == e.b && f.b == e.a)));
        if folds {
            return false;
        }
        self.apexes.chunk_by(|a, b| a == b).all(|run| links.triangle_count(run[0]) > run.len())
    }

    /// Link condition if both links are rings: the usual case, which needs no scratch.
    fn rings_allow(&self, links: &Links, v: u32, u: u32) -> bool {
        let (ring, other) = (links.entries(v), links.entries(u));
        let n = ring.len();
        let Some(k) = ring.iter().position(|&w| w == u) else { return false };
        let is_closed = links.kind(v) == LinkKind::Closed;
        let has_next = is_closed || k + 1 < n;
        let has_last = is_closed || k > 0;
        let next = if k + 1 == n { 0 } else { k + 1 };
        let last = if k == 0 { n - 1 } else { k - 1 };
        let removed = usize::from(has_next) + usize::from(has_last);
        let kept = links.triangle_count(v) + links.triangle_count(u) - 2 * removed;
        if (kept == 0 && !self.may_vanish) || kept > MAX_VALENCE.max(other.len()) {
            return false;
        }
        for (i, w) in ring.iter().enumerate() {
            let is_apex = (has_next && i == next) || (has_last && i == last);
            if i != k && !is_apex && links.are_neighbors(*w, u) {
                return false;
            }
        }
        if self.may_merge {
            return true;
        }
        // A boundary path of two has one apex only; in a cycle of three the two apexes are joined.
        if is_closed && n == 3 && are_joined(links, u, ring[next], ring[last]) {
            return false;
        }
        (!has_next || links.triangle_count(ring[next]) > 1)
            && (!has_last || links.triangle_count(ring[last]) > 1)
    }
}

/// Whether `a` and `b` are adjacent in the ring of `u`.
fn are_joined(links: &Links, u: u32, a: u32, b: u32) -> bool {
    let ring = links.entries(u);
    let n = ring.len();
    let pairs = if links.kind(u) == LinkKind::Closed { n } else { n - 1 };
    (0..pairs).any(|i| {
        let (x, y) = (ring[i], ring[if i + 1 == n { 0 } else { i + 1 }]);
        (x == a && y == b) || (x == b && y == a)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn allows(triangles: &[[u32; 3]], v: u32, u: u32) -> bool {
        Legality::default().allows(&Links::new(12, triangles, false), v, u)
    }

    #[test]
    fn tetrahedron_and_single_triangle_are_not_collapsed() {
        let tetrahedron = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];
        assert!(!allows(&tetrahedron, 0, 1));
        assert!(!allows(&[[0, 1, 2]], 0, 1));
    }

    #[test]
    fn ear_collapses_unless_a_vertex_would_lose_its_last_triangle() {
        // Position 0 is an ear on the edge 1-2.
        let mesh = [[0, 1, 2], [2, 1, 3], [2, 3, 4]];
        assert!(allows(&mesh, 0, 1));
        assert!(!allows(&mesh, 1, 2), "0 would lose its only triangle");
    }

    #[test]
    fn pinching_is_refused() {
        // A tube with a triangular cross-section: 0 1 2 below, 3 4 5 above; collapsing across would pinch it.
        let mut tube = Vec::new();
        for i in 0..3u32 {
            let j = (i + 1) % 3;
            tube.extend([[i, j, 3 + i], [j, 3 + j, 3 + i]]);
        }
        assert!(!allows(&tube, 0, 1), "vertex 2 is a neighbor of both without a triangle");
    }

    #[test]
    fn book_of_three_pages_collapses_along_its_spine() {
        // Spine 0-1-2 and three pages of three triangles, with outer vertices from 3.
        let mut book = Vec::new();
        for page in 0..3u32 {
            let outer = 3 + 2 * page;
            book.extend([[0, 1, outer], [1, outer + 1, outer], [1, 2, outer + 1]]);
        }
        assert!(allows(&book, 1, 2));
        let mut links = Links::new(9, &book, false);
        links.collapse(1, 2);
        assert_eq!(links.triangle_count(2), 6);
    }
}
