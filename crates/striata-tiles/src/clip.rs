//! Triangles cut at the planes between tiles.
//!
//! A point on a plane is computed from the two ends of the edge in one order, whichever triangle and tile it is
//! computed for, and axes are always cut in the same order. So triangles with a common edge, and tiles with a common
//! plane, have equal points there.

/// A corner of a part of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Corner {
    /// Position, from the origin of the lattice.
    pub place: [f64; 3],
    /// Weights of the corners of the triangle.
    pub weights: [f64; 3],
}

/// Corners of a whole triangle.
pub(crate) fn corners(places: [[f64; 3]; 3]) -> Vec<Corner> {
    let weights = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    places.into_iter().zip(weights).map(|(place, weights)| Corner { place, weights }).collect()
}

/// The part of a convex polygon between two planes across an axis; fewer than three corners if there is none.
pub(crate) fn between(polygon: &[Corner], axis: usize, planes: [f64; 2]) -> Vec<Corner> {
    let mut part = Vec::with_capacity(polygon.len() + 2);
    for (from, to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (x, y) = (from.place[axis], to.place[axis]);
        if planes[0] <= x && x <= planes[1] {
            part.push(*from);
        }
        let [first, last] = if x < y { planes } else { [planes[1], planes[0]] };
        for plane in [first, last] {
            if x.min(y) < plane && plane < x.max(y) {
                part.push(at_plane(from, to, axis, plane));
            }
        }
    }
    part
}

/// The point of an edge on a plane.
fn at_plane(from: &Corner, to: &Corner, axis: usize, plane: f64) -> Corner {
    let [low, high] = if from.place[axis] < to.place[axis] { [from, to] } else { [to, from] };
    let share = (plane - low.place[axis]) / (high.place[axis] - low.place[axis]);
    let mix = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]));
    let mut place = mix(low.place, high.place);
    place[axis] = plane;
    Corner { place, weights: mix(low.weights, high.weights) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_of_a_triangle_are_cut_from_its_own_edges() {
        let triangle = corners([[0.0, 0.0, 0.0], [4.0, 0.0, 1.0], [0.0, 4.0, 2.0]]);
        let parts: Vec<Vec<Corner>> =
            (0..4).map(|i| between(&triangle, 0, [f64::from(i), f64::from(i + 1)])).collect();
        assert_eq!(parts.iter().map(Vec::len).collect::<Vec<_>>(), [4, 4, 4, 3]);
        let on = |part: &[Corner], x: f64| {
            let mut on: Vec<[f64; 3]> = part.iter().map(|c| c.place).filter(|place| place[0] == x).collect();
            on.sort_by(|a, b| a[1].total_cmp(&b[1]));
            on
        };
        for i in 1..4 {
            let x = f64::from(i);
            assert_eq!(on(&parts[i as usize - 1], x), on(&parts[i as usize], x));
            assert_eq!(on(&parts[i as usize], x).len(), 2);
        }
        for corner in parts.iter().flatten() {
            assert!((corner.weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        }
        assert!(between(&triangle, 1, [4.5, 5.0]).is_empty());
        // It only touches this interval, so there is no polygon.
        assert!(between(&triangle, 1, [4.0, 5.0]).len() < 3);
    }
}
