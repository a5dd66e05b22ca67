//! A weighted sum of predictions whose weights are learned by least squares.
//!
//! Where predictions resemble each other, following the gradient takes far too long. So the normal equations are kept, older
//! vertices fading, and a few steps of Gauss and Seidel solve them as they change. Errors count by their size, not its
//! square, since a few large ones would rule. Integers only: both sides of a stream get the same weights.

/// How fast earlier vertices fade: by one part in 2 to this each time.
const FADE: u32 = 7;
/// Vertices from one step of the solver to the next, once it has begun well.
const PERIOD: u32 = 8;
const BEGIN: u32 = 256;
/// What holds weights to their first values, as if this had been seen, and as a share of what was.
const HOLD: i64 = 1 << 29;
const HOLD_SHARE: u32 = 6;
/// Largest numbers in the equations, as a power of two.
const MOST_LOG: u32 = 38;
/// Weights stay within this, in 1/65536.
const LIMIT: i64 = 4 << 16;
/// Differences stay within this.
const REACH: i64 = 1 << 18;

/// Weights of `N` differences from a first prediction.
#[derive(Clone, Debug)]
pub(crate) struct LeastSquares<const N: usize> {
    products: [[i64; N]; N],
    aims: [i64; N],
    /// In 1/65536.
    weights: [i64; N],
    first: [i64; N],
    seen: u32,
}

impl<const N: usize> LeastSquares<N> {
    /// These weights at first, in 1/65536.
    pub(crate) fn new(first: [i64; N]) -> Self {
        Self { products: [[0; N]; N], aims: [0; N], weights: first, first, seen: 0 }
    }

    /// The weighted sum of differences.
    pub(crate) fn predict<const D: usize>(&self, differences: &[[i64; D]; N]) -> [i64; D] {
        std::array::from_fn(|axis| {
            let terms = self.weights.iter().zip(differences).map(|(w, d)| w * d[axis].clamp(-REACH, REACH));
            (terms.sum::<i64>() + (1 << 15)) >> 16
        })
    }

    /// Learns what the sum should have been; errors much below `small` count alike.
    pub(crate) fn learn<const D: usize>(&mut self, differences: &[[i64; D]; N], meant: [i64; D], small: i64) {
        let meant = meant.map(|x| x.clamp(-REACH, REACH));
        let differences = differences.map(|d| d.map(|x| x.clamp(-REACH, REACH)));
        let predicted = self.predict(&differences);
        let error: i64 = meant.iter().zip(predicted).map(|(m, p)| (m - p).abs()).sum();
        let share = (1 << 16) / (error + small.max(128));
        let dot = |a: &[i64; D], b: &[i64; D]| a.iter().zip(b).map(|(x, y)| x * y).sum::<i64>();
        for (i, d) in differences.iter().enumerate() {
            for (j, other) in differences.iter().enumerate().skip(i) {
                let product = self.products[i][j];
                let product = product + share * dot(d, other) - (product >> FADE);
                self.products[i][j] = product;
                self.products[j][i] = product;
            }
            self.aims[i] += share * dot(d, &meant) - (self.aims[i] >> FADE);
        }
        self.seen = self.seen.saturating_add(1);
        if self.seen < BEGIN || self.seen.is_multiple_of(PERIOD) {
            self.solve();
        }
    }

    /// Moves each weight to where it is best, given the others.
    fn solve(&mut self) {
        let largest = (0..N).fold(0, |m, k| m.max(self.products[k][k]).max(self.aims[k].abs()));
        let down = (largest.max(1).ilog2() + 1).saturating_sub(MOST_LOG);
        for k in 0..N {
            let row = self.products[k].map(|product| product >> down);
            let hold = (row[k] >> HOLD_SHARE) + (HOLD >> down);
            let met: i64 = row.iter().zip(&self.weights).map(|(product, weight)| product * weight).sum();
            let gap = ((self.aims[k] >> down) << 16) - met - hold * (self.weights[k] - self.first[k]);
            let moved = self.weights[k] + gap / (row[k] + hold + 1);
            self.weights[k] = moved.clamp(-LIMIT, LIMIT);
        }
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;

    #[test]
    fn weights_of_predictions_that_resemble_each_other_are_found() {
        let mut random = Random::new(6);
        let mut sum = LeastSquares::new([0; 3]);
        let mut any = |limit: u32| random.below(2 * limit) as i64 - i64::from(limit);
        let mut off = 0;
        for vertex in 0..3000 {
            let common = [any(3000), any(3000)];
            let differences: [[i64; 2]; 3] =
                std::array::from_fn(|_| [common[0] + any(500), common[1] + any(500)]);
            let [a, b, c] = differences;
            // Now and then something quite different comes.
            let meant: [i64; 2] = std::array::from_fn(|i| match vertex % 20 {
                0 => any(20_000),
                _ => a[i] / 2 - b[i] / 4 + c[i] / 8 + any(8),
            });
            if vertex > 1000 && vertex % 20 != 0 {
                let found = sum.predict(&differences);
                off += (found[0] - meant[0]).abs() + (found[1] - meant[1]).abs();
            }
            sum.learn(&differences, meant, 64);
        }
        // What is predicted is some 1,500 long.
        assert!(off / 1900 < 200, "{}", off / 1900);
    }

    #[test]
    fn nothing_is_too_large() {
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
