//! Directions on the unfolded octahedron, in integers: conversion, and differences across its folds.
//!
//! The grid is the one of [`octahedral`](super::octahedral). A point of the square represents a
//! direction whose absolute coordinates sum to the half side. Sums of such directions, projected back to
//! the grid, serve as means. If a prediction lies in the lower half, both it and the coded point are
//! flipped to the upper half, so that the seams of the square are always far from the points between
//! which differences are small.

/// A grid of directions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Octahedron {
    /// Largest coordinate on the square.
    side: i32,
}

impl Octahedron {
    /// Creates the grid with this number of bits per coordinate.
    pub(crate) fn new(bits: u32) -> Self {
        Self { side: (1 << (bits - 1)) - 1 }
    }

    /// Returns the largest coordinate on the square.
    pub(crate) fn side(self) -> i64 {
        i64::from(self.side)
    }

    /// Mirrors a point between the upper half of the octahedron (the inner diamond) and the lower half.
    fn fold(self, [x, y]: [i32; 2]) -> [i32; 2] {
        let sign = |v: i32| if v < 0 { -1 } else { 1 };
        [(self.side - y.abs()) * sign(x), (self.side - x.abs()) * sign(y)]
    }

    /// Whether a point lies in the lower half.
    fn is_below(self, [x, y]: [i32; 2]) -> bool {
        x.abs() + y.abs() > self.side
    }

    /// Returns the direction of a point of the square. Its absolute coordinates sum to the side.
    pub(crate) fn direction(self, point: [i32; 2]) -> [i64; 3] {
        let z = self.side - point[0].abs() - point[1].abs();
        let [x, y] = if z < 0 { self.fold(point) } else { point };
        [i64::from(x), i64::from(y), i64::from(z)]
    }

    /// Returns the grid point nearest to a direction of any length; the top for a zero vector.
    pub(crate) fn point(self, direction: [i64; 3]) -> [i32; 2] {
        let [x, y, z] = scaled(direction, self.side());
        // Rounding must not cross into the other half.
        let (x, y) = (x as i32, y as i32);
        let y = y.clamp(x.abs() - self.side, self.side - x.abs());
        if z < 0 || (z == 0 && direction[2] < 0) { self.fold([x, y]) } else { [x, y] }
    }

    /// Returns the difference between a point and its prediction, which is small if they represent
    /// similar directions.
    pub(crate) fn difference(self, point: [i32; 2], predicted: [i32; 2]) -> [i32; 2] {
        let (point, predicted) = if self.is_below(predicted) {
            (self.fold(point), self.fold(predicted))
        } else {
            (point, predicted)
        };
        [0, 1].map(|a| self.wrap(point[a] - predicted[a]))
    }

    /// Applies a difference to a prediction.
    pub(crate) fn moved(self, predicted: [i32; 2], difference: [i32; 2]) -> [i32; 2] {
        let is_below = self.is_below(predicted);
        let from = if is_below { self.fold(predicted) } else { predicted };
        let to = [0, 1].map(|a| self.wrap(from[a].wrapping_add(difference[a])));
        if is_below { self.fold(to) } else { to }
    }

    /// Wraps a difference around to the range of -side to side.
    fn wrap(self, x: i32) -> i32 {
        (i64::from(x) + self.side()).rem_euclid(2 * self.side() + 1) as i32 - self.side
    }
}

/// Scales a direction so that its absolute coordinates sum approximately to `length`. A zero vector
/// remains zero.
pub(crate) fn scaled(direction: [i64; 3], length: i64) -> [i64; 3] {
    let spare = direction.iter().fold(0u64, |m, x| m.max(x.unsigned_abs())).max(1).ilog2().saturating_sub(40);
    let direction = [direction[0] >> spare, direction[1] >> spare, direction[2] >> spare];
    let sum = direction[0].abs() + direction[1].abs() + direction[2].abs();
    if sum == 0 {
        return [0; 3];
    }
    let half = sum / 2;
    let part = |x: i64| if x < 0 { -((half - x * length) / sum) } else { (half + x * length) / sum };
    [part(direction[0]), part(direction[1]), part(direction[2])]
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::super::octahedral;
    use super::*;

    /// One point for each direction of the grid.
    fn points(bits: u32) -> Vec<[i32; 2]> {
        let side = (1 << (bits - 1)) - 1;
        let all = (-side..=side).flat_map(|x: i32| (-side..=side).map(move |y: i32| [x, y]));
        all.filter(|&[x, y]| (x.abs() < side || y >= 0) && (y.abs() < side || x >= 0)).collect()
    }

    #[test]
    fn differences_restore_the_point() {
        let grid = Octahedron::new(4);
        for point in points(4) {
            for x in -7..=7 {
                for y in -7..=7 {
                    let difference = grid.difference(point, [x, y]);
                    assert!(difference.iter().all(|d| d.abs() <= 7));
                    assert_eq!(grid.moved([x, y], difference), point, "{x} {y}");
                }
            }
        }
    }

    #[test]
    fn similar_directions_have_small_differences() {
        let mut random = Random::new(1);
        let grid = Octahedron::new(10);
        for _ in 0..3000 {
            let a = [(); 3].map(|()| random.between(-1.0, 1.0));
            let b = a.map(|x| x + random.between(-0.01, 0.01));
            if a.iter().map(|x| x * x).sum::<f32>() < 0.3 {
                continue;
            }
            let [a, b] = [a, b].map(|d| octahedral::encode(d, 10).map(i32::from));
            let difference = grid.difference(a, b);
            assert!(difference.iter().all(|d| d.abs() < 40), "{a:?} {b:?} {difference:?}");
        }
    }

    #[test]
    fn points_survive_conversion_to_directions() {
        for bits in [2, 3, 5, 8] {
            let grid = Octahedron::new(bits);
            for point in points(bits) {
                let direction = grid.direction(point);
                assert_eq!(direction.iter().map(|x| x.abs()).sum::<i64>(), grid.side());
                assert_eq!(grid.direction(grid.point(direction)), direction, "{point:?}");
                let exact = octahedral::decode(point.map(|x| x as i16), bits);
                let length = direction.iter().map(|x| (x * x) as f32).sum::<f32>().sqrt();
                (0..3).for_each(|a| assert!((exact[a] - direction[a] as f32 / length).abs() < 1e-6));
            }
        }
    }

    #[test]
    fn hostile_values_stay_on_the_square() {
        let mut random = Random::new(7);
        for bits in 2..=16 {
            let grid = Octahedron::new(bits);
            let mut any = || random.next_u64() as i64 >> random.below(60);
            for _ in 0..300 {
                let point = grid.point([any(), any(), any()]);
                let moved = grid.moved(point, [any() as i32, any() as i32]);
                assert!(
                    [point, moved].iter().flatten().all(|x| i64::from(x.abs()) <= grid.side()),
                    "{point:?} {moved:?}"
                );
            }
        }
    }
}
