//! What a closed surface demands of a collapse beyond what [`Legality`] does.
//!
//! `Legality` looks at positions, where a mesh that is not manifold shares vertices that the coder's copies do not share: it
//! refuses more. What it does not know is the virtual vertex in each hole. With it a position on a boundary has one
//! neighbor more, and only an **ear**, one triangle between two boundary edges, can break the link condition there: when its
//! third edge has no other side, or none that a surface could go on through.

use crate::simplify::collapse::legality::Legality;
use crate::simplify::collapse::links::{LinkKind, Links};

/// Triangles around `v` on the closed surface, at a position that is manifold.
pub(super) fn valence(links: &Links, v: u32) -> usize {
    let virtual_triangles = if links.kind(v) == LinkKind::Open { 2 } else { 0 };
    links.triangle_count(v) + virtual_triangles
}

/// True where the triangles around `v` are one fan.
pub(super) fn is_manifold(links: &Links, v: u32) -> bool {
    matches!(links.kind(v), LinkKind::Closed | LinkKind::Open)
}

/// Whether the position `v`, which is manifold, may go to its neighbor `u` on the closed surface.
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

/// True where two triangles of opposite winding meet at the edge of `u` and `w`.
fn is_inner_edge(links: &Links, u: u32, w: u32) -> bool {
    let entries = links.entries(u);
    match links.kind(u) {
        LinkKind::Empty => false,
        LinkKind::Closed => entries.contains(&w),
        LinkKind::Open => entries[1..entries.len() - 1].contains(&w),
        LinkKind::Edges => {
            let count = |side: usize| entries.iter().skip(side).step_by(2).filter(|x| **x == w).count();
            count(0) == 1 && count(1) == 1
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn may_go(triangles: &[[u32; 3]], v: u32, u: u32) -> bool {
        allows(&mut Legality::default(), &Links::new(12, triangles, false), v, u)
    }

    #[test]
    fn ears_go_where_a_surface_is_left() {
        assert!(may_go(&[[0, 1, 2], [2, 1, 3], [2, 3, 4]], 0, 1));
        assert!(!may_go(&[[0, 1, 2]], 0, 1), "nothing would be left");
        let pages = [[0, 1, 2], [2, 1, 3], [2, 1, 4], [3, 1, 5], [4, 2, 6]];
        assert!(!may_go(&pages, 0, 1), "the edge 1-2 has three triangles: this one is a part of its own");
        let bow_ties = [[0, 1, 2], [1, 3, 4], [2, 5, 6]];
        assert!(!may_go(&bow_ties, 0, 1), "1 and 2 have other triangles, but not at their edge");
    }

    #[test]
    fn boundaries_keep_their_course() {
        // A fan of three about 0, which is on the boundary with 1 and 4.
        let fan = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [2, 1, 5], [3, 2, 6], [4, 3, 7]];
        assert!(may_go(&fan, 0, 1) && may_go(&fan, 0, 4));
        assert!(!may_go(&fan, 0, 2) && !may_go(&fan, 0, 3));
        assert_eq!(valence(&Links::new(8, &fan, false), 0), 5);
    }
}
