//! Conditions for collapses on a closed surface, in addition to those of [`Legality`].
//!
//! `Legality` tests positions. In a non-manifold mesh these share vertices that are separate in the
//! coder's manifold copy, so it rejects more than necessary. It does not know the virtual vertices that
//! close holes. They add a neighbor to each position on a boundary, and only at an **ear**, a triangle
//! between two boundary edges, can that break the link condition: if the triangle's third edge has no
//! other side, or is not manifold.

use crate::simplify::collapse::legality::Legality;
use crate::simplify::collapse::links::{LinkKind, Links};

/// Number of triangles around the manifold position `v` on the closed surface.
pub(super) fn valence(links: &Links, v: u32) -> usize {
    let virtual_triangles = if links.kind(v) == LinkKind::Open { 2 } else { 0 };
    links.triangle_count(v) + virtual_triangles
}

/// Whether the triangles around `v` form a single fan.
pub(super) fn is_manifold(links: &Links, v: u32) -> bool {
    matches!(links.kind(v), LinkKind::Closed | LinkKind::Open)
}

/// Whether the manifold position `v` may be collapsed to its neighbor `u` on the closed surface.
pub(super) fn allows(legality: &mut Legality, links: &Links, v: u32, u: u32) -> bool {
    if links.kind(v) == LinkKind::Open {
        let ring = links.entries(v);
        let last = ring.len() - 1;
        if u != ring[0] && u != ring[last] {
            return false;
        }
        let opposite = if u == ring[0] { ring[last] } else { ring[0] };
        if last == 1 && !is_inner_edge(links, u, opposite) {
            return false;
        }
    }
    legality.allows(links, v, u)
}

/// Whether exactly two triangles of opposite winding meet at the edge between `u` and `w`.
fn is_inner_edge(links: &Links, u: u32, w: u32) -> bool {
    // Either end has the triangles of the edge; one of them may be the middle of a disc.
    let (u, w) = if links.triangle_count(w) < links.triangle_count(u) { (w, u) } else { (u, w) };
    let entries = links.entries(u);
    match links.kind(u) {
        LinkKind::Empty => false,
        LinkKind::Closed => entries.contains(&w),
        LinkKind::Open => entries[1..entries.len() - 1].contains(&w),
        LinkKind::Edges => [0, 1].into_iter().all(|side| {
            // There may be very many, so none is counted after the second one.
            let mut found = entries.iter().skip(side).step_by(2).filter(|x| **x == w);
            found.next().is_some() && found.next().is_none()
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn may_go(triangles: &[[u32; 3]], v: u32, u: u32) -> bool {
        allows(&mut Legality::default(), &Links::new(12, triangles, false), v, u)
    }

    #[test]
    fn ears_collapse_if_a_surface_is_left_at_their_base() {
        assert!(may_go(&[[0, 1, 2], [2, 1, 3], [2, 3, 4]], 0, 1));
        assert!(!may_go(&[[0, 1, 2]], 0, 1), "nothing would be left");
        let pages = [[0, 1, 2], [2, 1, 3], [2, 1, 4], [3, 1, 5], [4, 2, 6]];
        assert!(!may_go(&pages, 0, 1), "the edge 1-2 has three triangles, so this one is a separate part");
        let bow_ties = [[0, 1, 2], [1, 3, 4], [2, 5, 6]];
        assert!(!may_go(&bow_ties, 0, 1), "1 and 2 have other triangles, but not at their edge");
    }

    #[test]
    fn boundary_vertices_collapse_only_along_the_boundary() {
        // A fan of three around 0, which is on the boundary with 1 and 4.
        let fan = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [2, 1, 5], [3, 2, 6], [4, 3, 7]];
        assert!(may_go(&fan, 0, 1) && may_go(&fan, 0, 4));
        assert!(!may_go(&fan, 0, 2) && !may_go(&fan, 0, 3));
        assert_eq!(valence(&Links::new(8, &fan, false), 0), 5);
    }
}
