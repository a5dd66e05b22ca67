//! Walks over the surface, from star to star, to the point nearest to a given point.

use glam::Vec3;

use super::fan::nearest;
use super::links::{LinkEdge, Links};

const NONE: u32 = u32::MAX;
/// Stars that one search may visit; the next search continues from where this one stopped.
const MAX_VISITED_STARS: usize = 8;

/// Squared distance of a point from the current surface, and a position near the nearest surface point.
pub(in crate::simplify) type NearestStar = (f32, u32);

/// Walks from the star of `position` to neighboring stars while that reduces the distance from a query
/// point; `offset` returns the vector from the query point to a position.
#[inline]
pub(in crate::simplify) fn walk_to_nearest(
    links: &Links,
    edges: &mut Vec<LinkEdge>,
    mut position: u32,
    offset: impl Fn(u32) -> Vec3,
) -> NearestStar {
    let mut least = f32::INFINITY;
    for _ in 0..MAX_VISITED_STARS {
        let center = offset(position);
        links.sampled_edges_into(position, edges);
        // If the nearest point is on the rim, the star beyond the rim may be nearer still.
        let mut beyond = NONE;
        let before = least;
        for e in edges.iter() {
            let (a, b) = (offset(e.a), offset(e.b));
            let [x, y, z] = nearest(center, a, b);
            let distance_squared = (center * x + a * y + b * z).length_squared();
            if distance_squared < least {
                least = distance_squared;
                let rim = if y >= z { e.a } else { e.b };
                beyond = if x > 0.0 { NONE } else { rim };
            }
        }
        if edges.is_empty() {
            least = least.min(center.length_squared());
        }
        if beyond == NONE || least >= before {
            break;
        }
        position = beyond;
    }
    (least, position)
}
