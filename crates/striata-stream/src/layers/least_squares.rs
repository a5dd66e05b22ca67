//! A weighted sum of predictions whose weights are learned by least squares.
//!
//! If predictions are similar to each other, gradient descent takes far too long. Instead we keep the normal
//! equations, in which older vertices fade, and update their solution by a few Gauss-Seidel steps. Errors are
//! weighted by their absolute value rather than their square, since a few large ones would otherwise
//! dominate. All arithmetic is on integers, so that both sides of a stream get the same weights.

/// Decay rate: each new vertex reduces the influence of earlier ones by one part in 2 to this power.
const FADE: u32 = 7;
/// Number of vertices between two solver steps, after the first `BEGIN` vertices, which take one each.
const PERIOD: u32 = 8;
const BEGIN: u32 = 256;
/// Regularization that pulls weights to their initial values: a constant, and a share of the diagonal as
/// a right shift.
const REGULARIZATION: i64 = 1 << 29;
const REGULARIZATION_SHIFT: u32 = 6;
/// Largest magnitude in the equations, as a power of two.
const MOST_LOG: u32 = 38;
/// Limit of the weights, in 1/65536.
const LIMIT: i64 = 4 << 16;
/// Limit of the differences.
const REACH: i64 = 1 << 18;

/// Weights of `N` differences from a first prediction.
#[derive(Clone, Debug)]
pub(crate) struct LeastSquares<const N: usize> {
    products: [[i64; N]; N],
    right_side: [i64; N],
    /// Current weights, in 1/65536.
    weights: [i64; N],
    first: [i64; N],
    seen: u32,
}

impl<const N: usize> LeastSquares<N> {
    /// Creates the model with initial weights, in 1/65536.
    pub(crate) fn new(first: [i64; N]) -> Self {
        Self { products: [[0; N]; N], right_side: [0; N], weights: first, first, seen: 0 }
    }

    /// Returns the weighted sum of the differences.
    pub(crate) fn predict<const D: usize>(&self, differences: &[[i64; D]; N]) -> [i64; D] {
        std::array::from_fn(|axis| {
            let terms = self.weights.iter().zip(differences).map(|(w, d)| w * d[axis].clamp(-REACH, REACH));
            (terms.sum::<i64>() + (1 << 15)) >> 16
        })
    }

    /// Learns from the actual value of the sum. Errors much smaller than `small` all count alike.
    pub(crate) fn learn<const D: usize>(
        &mut self,
        differences: &[[i64; D]; N],
        actual: [i64; D],
        small: i64,
    ) {
        let actual = actual.map(|x| x.clamp(-REACH, REACH));
        let differences = differences.map(|d| d.map(|x| x.clamp(-REACH, REACH)));
        let predicted = self.predict(&differences);
        let error: i64 = actual.iter().zip(predicted).map(|(m, p)| (m - p).abs()).sum();
        let share = (1 << 16) / (error + small.max(128));
        let dot = |a: &[i64; D], b: &[i64; D]| a.iter().zip(b).map(|(x, y)| x * y).sum::<i64>();
        for (i, d) in differences.iter().enumerate() {
            for (j, other) in differences.iter().enumerate().skip(i) {
                let product = self.products[i][j];
                let product = product + share * dot(d, other) - (product >> FADE);
                self.products[i][j] = product;
                self.products[j][i] = product;
            }
            self.right_side[i] += share * dot(d, &actual) - (self.right_side[i] >> FADE);
        }
        self.seen = self.seen.saturating_add(1);
        if self.seen < BEGIN || self.seen.is_multiple_of(PERIOD) {
            self.solve();
        }
    }

    /// Moves each weight to its optimum, given the others.
    fn solve(&mut self) {
        let largest = (0..N).fold(0, |m, k| m.max(self.products[k][k]).max(self.right_side[k].abs()));
        let down = (largest.max(1).ilog2() + 1).saturating_sub(MOST_LOG);
        for k in 0..N {
            let row = self.products[k].map(|product| product >> down);
            let regularization = (row[k] >> REGULARIZATION_SHIFT) + (REGULARIZATION >> down);
            let predicted: i64 =
                row.iter().zip(&self.weights).map(|(product, weight)| product * weight).sum();
            let residual = ((self.right_side[k] >> down) << 16)
                - predicted
                - regularization * (self.weights[k] - self.first[k]);
            let moved = self.weights[k] + residual / (row[k] + regularization + 1);
            self.weights[k] = moved.clamp(-LIMIT, LIMIT);
        }
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;

    #[test]
    fn finds_the_weights_of_similar_predictions() {
        let mut random = Random::new(6);
        let mut sum = LeastSquares::new([0; 3]);
        let mut any = |limit: u32| random.below(2 * limit) as i64 - i64::from(limit);
        let mut off = 0;
        for vertex in 0..3000 {
            let common = [any(3000), any(3000)];
            let differences: [[i64; 2]; 3] =
                std::array::from_fn(|_| [common[0] + any(500), common[1] + any(500)]);
            let [a, b, c] = differences;
            // Occasional outliers.
            let actual: [i64; 2] = std::array::from_fn(|i| match vertex % 20 {
                0 => any(20_000),
                _ => a[i] / 2 - b[i] / 4 + c[i] / 8 + any(8),
            });
            if vertex > 1000 && vertex % 20 != 0 {
                let found = sum.predict(&differences);
                off += (found[0] - actual[0]).abs() + (found[1] - actual[1]).abs();
            }
            sum.learn(&differences, actual, 64);
        }
        // The predicted vectors are about 1,500 units long.
        assert!(off / 1900 < 200, "{}", off / 1900);
    }

    #[test]
    fn large_inputs_do_not_overflow() {
        let mut random = Random::new(1);
        let mut sum = LeastSquares::new([1 << 16, -(1 << 15)]);
        for _ in 0..20_000 {
            let bits = random.below(63);
            let mut any = || random.next_u64() as i64 >> bits;
            let differences = [[any(), any(), any()], [any(), any(), any()]];
            let found = sum.predict(&differences);
            assert!(found.iter().all(|x| x.abs() <= 16 * REACH));
            sum.learn(&differences, [any(), any(), any()], 1);
        }
    }
}
