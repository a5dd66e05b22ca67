//! Affine fit to the ring of a vertex, and the normal of its triangles.
//!
//! Attributes such as texture coordinates vary smoothly over a surface, so the value at a position is
//! approximately a weighted sum of the surrounding values: a least-squares plane through the ring,
//! evaluated at the new vertex. The weights depend only on positions and are the same for all layers. All
//! arithmetic is on integers. If the ring does not determine the fit, it tends to the mean.

/// Fraction bits of a weight.
pub(crate) const WEIGHT_BITS: u32 = 16;

/// Bits to which differences within a ring are reduced, so that products of six of them fit.
const DIFFERENCE_BITS: u32 = 7;

/// Bits to which distances from the center are reduced, so that their products fit.
const ARM_BITS: u32 = 12;

/// Maximum number of ring vertices for a fit.
const MOST: usize = 24;

/// Affine fit to a ring of positions around a center.
#[derive(Clone, Debug, Default)]
pub(crate) struct RingFit {
    /// Weight of each ring vertex, in 1/65536; they sum to approximately one.
    pub weights: Vec<i32>,
    /// Area-weighted sum of the normals of the triangles between center and ring; zero if there are none.
    pub normal: [i64; 3],
    /// Vector from the center to each ring vertex; all are halved until they fit in 12 bits.
    pub arms: Vec<[i64; 3]>,
    /// Whether the last and the first vertex of the ring share a triangle.
    pub is_closed: bool,
    differences: Vec<[i64; 3]>,
}

impl RingFit {
    /// Fits a ring of positions around a center. `is_closed` states whether its last and first vertex
    /// share a triangle.
    pub(crate) fn measure(&mut self, center: [i32; 3], ring: &[[i32; 3]], is_closed: bool) {
        let arm =
            |p: &[i32; 3]| -> [i64; 3] { std::array::from_fn(|a| i64::from(p[a]) - i64::from(center[a])) };
        self.arms.clear();
        self.arms.extend(ring.iter().map(arm));
        let largest = self.arms.iter().flatten().fold(0, |m, x| x.abs().max(m)) as u64;
        let down = (largest.max(1).ilog2() + 1).saturating_sub(ARM_BITS);
        self.arms.iter_mut().flatten().for_each(|x| *x >>= down);
        self.is_closed = is_closed;
        self.normal = normal(&self.arms, is_closed);
        self.weights.clear();
        if ring.is_empty() {
            return;
        }
        let even = (1i64 << WEIGHT_BITS) / ring.len() as i64;
        let slope = (2..=MOST).contains(&ring.len()).then(|| self.slope(center, ring)).flatten();
        let Some((slope, shift)) = slope else {
            self.weights.resize(ring.len(), even as i32);
            return;
        };
        self.weights.extend(self.differences.iter().map(|d| {
            let share = (0..3).map(|a| d[a] * slope[a].clamp(-1 << 50, 1 << 50)).sum::<i64>();
            // Larger weights are never useful.
            (even + (share >> shift)).clamp(-4 << WEIGHT_BITS, 4 << WEIGHT_BITS) as i32
        }));
    }

    /// Returns the vector whose product with a vertex's difference from the ring's mean is the vertex's
    /// share of the weight, and the number of bits to shift the product right by.
    fn slope(&mut self, center: [i32; 3], ring: &[[i32; 3]]) -> Option<([i64; 3], u32)> {
        let n = ring.len() as i64;
        let sum: [i64; 3] = std::array::from_fn(|a| ring.iter().map(|p| i64::from(p[a])).sum());
        let from_mean = |p: [i32; 3]| -> [i64; 3] { std::array::from_fn(|a| n * i64::from(p[a]) - sum[a]) };
        self.differences.clear();
        self.differences.extend(ring.iter().map(|&p| from_mean(p)));
        let largest = self.differences.iter().flatten().fold(0, |m, d| d.abs().max(m)) as u64;
        let down = (largest.max(1).ilog2() + 1).saturating_sub(DIFFERENCE_BITS);
        let rounded = |d: [i64; 3]| d.map(|x| (x + (1 << down >> 1)) >> down);
        self.differences.iter_mut().for_each(|d| *d = rounded(*d));
        let limit = 2 << DIFFERENCE_BITS;
        let to_center = rounded(from_mean(center)).map(|x| x.clamp(-limit, limit));
        let (solved, determinant) = solve(&self.differences, to_center)?;
        // The quotient has 16 bits more than a weight, and the divisor at most 30 bits.
        let spare = (determinant.ilog2() + 1).saturating_sub(30);
        let divisor = (determinant >> spare).max(1);
        let limit = 1 << 36;
        Some((solved.map(|x| ((x >> spare).clamp(-limit, limit) << 26) / divisor), 26 - WEIGHT_BITS))
    }
}

/// Returns the product of the adjugate of the ring's scatter matrix with a vector, and the matrix's
/// determinant.
fn solve(differences: &[[i64; 3]], v: [i64; 3]) -> Option<([i64; 3], i64)> {
    let mut s = [[0i64; 3]; 3];
    for d in differences {
        for (row, x) in s.iter_mut().zip(d) {
            row.iter_mut().zip(d).for_each(|(entry, y)| *entry += x * y);
        }
    }
    // A flat ring does not determine the slope perpendicular to it.
    let ridge = (s[0][0] + s[1][1] + s[2][2]) / 128 + 1;
    (0..3).for_each(|a| s[a][a] += ridge);
    let minor = |a: usize, b: usize| {
        let ([i, j], [k, l]) = ([(a + 1) % 3, (a + 2) % 3], [(b + 1) % 3, (b + 2) % 3]);
        s[i][k] * s[j][l] - s[i][l] * s[j][k]
    };
    let row = |a: usize| [minor(a, 0), minor(a, 1), minor(a, 2)];
    let [x, y, z] = [row(0), row(1), row(2)];
    let determinant = s[0][0] * x[0] + s[0][1] * x[1] + s[0][2] * x[2];
    let dot = |r: [i64; 3]| r[0] * v[0] + r[1] * v[1] + r[2] * v[2];
    (determinant > 0).then(|| ([dot(x), dot(y), dot(z)], determinant))
}

/// Sums the normals of the triangles between the center and the ring.
fn normal(arms: &[[i64; 3]], is_closed: bool) -> [i64; 3] {
    let mut sum = [0i64; 3];
    let mut add = |p: [i64; 3], q: [i64; 3]| {
        for (a, sum) in sum.iter_mut().enumerate() {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            *sum += p[b] * q[c] - p[c] * q[b];
        }
    };
    arms.windows(2).for_each(|w| add(w[0], w[1]));
    if let (true, [first, .., last]) = (is_closed, arms) {
        add(*last, *first);
    }
    sum
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;

    fn fitted(center: [i32; 3], ring: &[[i32; 3]]) -> RingFit {
        let mut fit = RingFit::default();
        fit.measure(center, ring, true);
        fit
    }

    #[test]
    fn predicts_affine_values_within_the_ring() {
        let mut random = Random::new(8);
        for scale in [20, 1000, 1 << 20] {
            for count in 4..9 {
                let mut grid_point = || [(); 3].map(|()| random.below(scale) as i32);
                let ring: Vec<_> = (0..count).map(|_| grid_point()).collect();
                let center: [i32; 3] =
                    std::array::from_fn(|a| ring.iter().take(3).map(|p| p[a]).sum::<i32>() / 3);
                let fit = fitted(center, &ring);
                let value = |p: [i32; 3]| f64::from(p[0]) * 3.0 - f64::from(p[1]) * 2.0 + f64::from(p[2]);
                let found: f64 =
                    ring.iter().zip(&fit.weights).map(|(&p, &w)| value(p) * f64::from(w) / 65536.0).sum();
                let mean: f64 = ring.iter().map(|&p| value(p)).sum::<f64>() / f64::from(count);
                let (off, before) = ((found - value(center)).abs(), (mean - value(center)).abs());
                assert!(off < 0.5 * before + 0.1 * f64::from(scale), "{count}: {off} for {before}");
                let sum: i32 = fit.weights.iter().sum();
                assert!((sum - 65536).abs() < 6000, "{sum}");
            }
        }
    }

    #[test]
    fn a_flat_even_ring_gives_even_weights_and_its_normal() {
        let ring = [[10, 0, 0], [0, 10, 0], [-10, 0, 0], [0, -10, 0]];
        let fit = fitted([0, 0, 3], &ring);
        assert!(fit.weights.iter().all(|w| (w - 16384).abs() < 20), "{:?}", fit.weights);
        assert_eq!(fit.normal, [0, 0, 400]);
        // Moving the center changes the weights accordingly.
        let fit = fitted([5, 0, 0], &ring);
        assert!(fit.weights[0] > 28000 && fit.weights[2] < 5000, "{:?}", fit.weights);
    }

    #[test]
    fn any_ring_gives_a_fit() {
        let mut random = Random::new(3);
        for count in 0..40 {
            for _ in 0..50 {
                let bits = random.below(32);
                let mut grid_point = || [(); 3].map(|()| (random.next_u64() as u32 >> bits) as i32);
                let ring: Vec<_> = (0..count).map(|_| grid_point()).collect();
                assert_eq!(fitted(grid_point(), &ring).weights.len(), count);
            }
            assert_eq!(fitted([1; 3], &vec![[7; 3]; count]).weights.len(), count);
            assert_eq!(fitted([i32::MAX; 3], &vec![[i32::MIN; 3]; count]).weights.len(), count);
        }
    }
}
