//! Which triangles of a group share an edge with opposite directions, so that a strip may pass.

/// No half-edge.
pub(super) const NONE: u32 = u32::MAX;

/// For each half-edge `3 * triangle + corner` (from that corner to the next) its twin in another triangle,
/// or [`NONE`]. Where more than two triangles meet at an edge, opposite directions are paired in order
/// of the triangles, and what is left over stays without a twin. Two counting sorts: linear time.
pub(super) fn twins(triangles: &[[u32; 3]]) -> Vec<u32> {
    let vertex_limit = triangles.iter().flatten().max().map_or(0, |&v| v as usize + 1);
    let ends = |h: u32| {
        let t = &triangles[h as usize / 3];
        let corner = h as usize % 3;
        (t[corner], t[(corner + 1) % 3])
    };
    let is_proper = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    let half_edges: Vec<u32> =
        (0..3 * triangles.len() as u32).filter(|&h| is_proper(&triangles[h as usize / 3])).collect();
    let by_high = counting_sort(&half_edges, vertex_limit, |h| ends(h).0.max(ends(h).1));
    let sorted = counting_sort(&by_high, vertex_limit, |h| ends(h).0.min(ends(h).1));
    let mut twins = vec![NONE; 3 * triangles.len()];
    let same_edge = |&a: &u32, &b: &u32| {
        let ((a0, a1), (b0, b1)) = (ends(a), ends(b));
        (a0, a1) == (b0, b1) || (a0, a1) == (b1, b0)
    };
    for edge in sorted.chunk_by(same_edge) {
        let (ups, downs): (Vec<u32>, Vec<u32>);
        let pairs: &mut dyn Iterator<Item = (u32, u32)> = if let &[a, b] = edge {
            &mut (ends(a).0 != ends(b).0).then_some((a, b)).into_iter()
        } else {
            (ups, downs) = edge.iter().partition(|&&h| ends(h).0 < ends(h).1);
            &mut ups.into_iter().zip(downs)
        };
        for (a, b) in pairs {
            twins[a as usize] = b;
            twins[b as usize] = a;
        }
    }
    twins
}

fn counting_sort(items: &[u32], key_limit: usize, key: impl Fn(u32) -> u32) -> Vec<u32> {
    let mut starts = vec![0u32; key_limit + 1];
    for &item in items {
        starts[key(item) as usize + 1] += 1;
    }
    for k in 1..starts.len() {
        starts[k] += starts[k - 1];
    }
    let mut out = vec![0; items.len()];
    for &item in items {
        let at = &mut starts[key(item) as usize];
        out[*at as usize] = item;
        *at += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_opposite_directions_are_twins() {
        assert_eq!(twins(&[[0, 1, 2], [2, 1, 3]]), [NONE, 3, NONE, 1, NONE, NONE]);
        // The second triangle is turned over: no strip may pass.
        assert!(twins(&[[0, 1, 2], [1, 2, 3]]).iter().all(|&t| t == NONE));
        // Three on an edge: the first two opposite ones are paired.
        assert_eq!(
            twins(&[[0, 1, 2], [1, 0, 3], [1, 0, 4], [5, 5, 0]])[..7],
            [3, NONE, NONE, 0, NONE, NONE, NONE]
        );
    }
}
