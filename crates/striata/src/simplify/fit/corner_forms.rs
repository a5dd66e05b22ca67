//! Least squares over the corners of triangles.

/// Wishes for the change of a value that is interpolated over a triangle, as a quadratic form of the changes
/// at its corners with `N` components each.
#[derive(Clone, Copy, Debug)]
pub(super) struct CornerForm<const N: usize> {
    /// Weighted products of the shares of two corners: 00, 11, 22, 01, 12, 20.
    products: [f64; 6],
    /// Weighted products of a corner's share and the wish.
    sides: [[f64; N]; 3],
}

impl<const N: usize> Default for CornerForm<N> {
    fn default() -> Self {
        Self { products: [0.0; 6], sides: [[0.0; N]; 3] }
    }
}

impl<const N: usize> CornerForm<N> {
    /// Adds a wish for the change at the point with these shares of the corners.
    pub(super) fn add(&mut self, weight: f64, shares: [f64; 3], wish: [f64; N]) {
        let [a, b, c] = shares;
        for (sum, product) in self.products.iter_mut().zip([a * a, b * b, c * c, a * b, b * c, c * a]) {
            *sum += weight * product;
        }
        for (side, share) in self.sides.iter_mut().zip(shares) {
            for (sum, wish) in side.iter_mut().zip(wish) {
                *sum += weight * share * wish;
            }
        }
    }

    /// Weight of a corner's change.
    pub(super) fn weight(&self, corner: usize) -> f64 {
        self.products[corner]
    }

    /// Returns the weighted wish that remains for a corner after the changes at the other two; its own does not count.
    pub(super) fn rest(&self, corner: usize, changes: [[f64; N]; 3]) -> [f64; N] {
        let (next, last) = ((corner + 1) % 3, (corner + 2) % 3);
        let (to_next, to_last) = (self.products[3 + corner], self.products[3 + last]);
        std::array::from_fn(|k| {
            self.sides[corner][k] - to_next * changes[next][k] - to_last * changes[last][k]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rest_vanishes_at_the_solution() {
        // Wishes that a linear function satisfies.
        let solution = [[1.0, 5.0], [2.0, -1.0], [4.0, 0.5]];
        let mut form = CornerForm::<2>::default();
        for shares in [[0.2, 0.3, 0.5], [1.0, 0.0, 0.0], [0.0, 0.7, 0.3], [0.25, 0.5, 0.25]] {
            let wish = std::array::from_fn(|k| (0..3).map(|c| shares[c] * solution[c][k]).sum());
            form.add(0.5 + shares[0], shares, wish);
        }
        for corner in 0..3 {
            let rest = form.rest(corner, solution);
            for (rest, value) in rest.iter().zip(solution[corner]) {
                assert!((rest - form.weight(corner) * value).abs() < 1e-12, "{corner}");
            }
        }
    }
}
