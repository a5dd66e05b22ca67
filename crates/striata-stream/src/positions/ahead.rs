//! Predictions for the positions of a whole stretch of vertices before any of them is coded.
//!
//! Almost everything around a new vertex is older than the stretch. Vertices of one batch are never
//! neighbors, so the whole ring is older; beyond the ring, we use the vertices that lie there before the
//! splits of the stretch are applied. All lookups and arithmetic for many vertices can therefore be done
//! in one go, without waiting for decisions in between, and the decisions can then be decoded without
//! waiting for memory.

use wide::i32x4;

use super::local::LANES;
use super::position_density::INVERSES;

/// Three grid coordinates and a flag of 1, or all zeros for unknown and virtual vertices.
type KnownCoords = [i32; 4];

/// The surroundings of a new vertex: its ring, starting at the vertex that split, and the vertex across
/// the edge from each ring vertex to the next one.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Surroundings {
    /// Length of both lists.
    pub count: usize,
    /// Ring vertices.
    pub ring: [KnownCoords; LANES],
    /// Vertices across the ring edges.
    pub across: [KnownCoords; LANES],
}

/// Number of points that a prediction blends: the mean of parallelograms across ring edges, the vertex
/// that split, and the midpoint of its neighbors in the ring.
pub(super) const POINTS: usize = 3;

/// Everything needed to predict a new vertex. Local units are chosen so that the ring's radius has eleven
/// bits.
#[derive(Clone, Debug)]
pub(super) struct Prediction {
    /// The vertex that split; other coordinates are relative to it.
    base: [i32; 3],
    /// Center of the ring, in 1/16 grid steps.
    middle: [i32; 3],
    /// Local units are 1/16 grid steps, shifted left by `up` and then right by `down`.
    up: u32,
    down: u32,
    /// Size class of the ring's radius, two for each doubling.
    pub size: usize,
    /// Radius of the ring, in local units.
    pub radius: i32,
    /// Number of ring vertices.
    pub count: usize,
    /// Axes from the most tangential to the most normal, and how the surface rises along the last one
    /// over each of the others, in 1/4096.
    pub axes: [usize; 3],
    pub slopes: [i32; 2],
    /// For each axis, the distances of the blended points from the center of the ring, in local units.
    pub features: [[i32; POINTS]; 3],
}

/// Limit of local coordinates.
const REACH: i32 = 4095;
/// Radii, in 1/16 grid steps, have at most this many bits.
const RADIUS_BITS: u32 = 28;

impl Prediction {
    /// Computes the prediction data from a vertex's surroundings.
    #[inline]
    pub(super) fn new(around: &Surroundings) -> Self {
        let n = around.count.min(LANES);
        let base = i32x4::new(around.ring[0]);
        let rings = around.ring[..n].iter().fold(i32x4::ZERO, |sum, &spot| sum + i32x4::new(spot));
        let middle = mean(rings, base).map(i32x4::new).unwrap_or_default();
        let off = |sum: Option<[i32; 4]>| sum.map_or(i32x4::ZERO, |mean| i32x4::new(mean) - middle);
        let of_one = |spot: KnownCoords| off(mean(i32x4::new(spot), base));
        let quarter = (n / 4).max(1);
        let [d, e] = [[0, n / 2], [quarter, (quarter + n / 2) % n.max(1)]]
            .map(|[i, j]| of_one(around.ring[i]) - of_one(around.ring[j]));
        let reach = (d.abs() >> 2u32) + (e.abs() >> 2u32);
        let [x, y, z, _] = reach.to_array();
        // Manhattan distances exceed Euclidean ones by about half.
        let radius = ((x + y + z).clamp(12, 1 << (RADIUS_BITS - 1)) as u32 / 3) * 2;
        let scale = 10 - radius.ilog2() as i32;
        let (up, down) = (scale.max(0) as u32, (-scale).max(0) as u32);
        let radius = ((radius << up) >> down) as i32;
        let adjacent = i32x4::new(around.ring[1]) + i32x4::new(around.ring[n.max(1) - 1]);
        let points = [off(mean(parallelograms(around, n, rings), base)), -middle, off(mean(adjacent, base))];
        let limit = i32x4::splat((REACH << down) >> up);
        let to_local = |x: i32x4| ((x.max(-limit).min(limit) << up) >> down).to_array();
        let points = points.map(to_local);
        let (axes, slopes) = axes_and_slopes(to_local(d), to_local(e));
        let [base, middle] = [base, middle].map(|x| x.to_array()).map(|[x, y, z, _]| [x, y, z]);
        let size = (2 * (20 + scale) + (radius >> 9 & 1)).clamp(0, 63) as usize;
        let features = [0, 1, 2].map(|a| points.map(|point| point[a]));
        Self { base, middle, up, down, size, radius, count: n, axes, slopes, features }
    }

    /// Returns the grid coordinate nearest to a distance from the center, given in local units.
    #[inline]
    pub(super) fn to_grid(&self, local: i32, axis: usize) -> i32 {
        let off = (local << self.down) >> self.up;
        self.base[axis].wrapping_add((self.middle[axis] + off + 8) >> 4)
    }

    /// Returns a grid coordinate's distance from the center, in local units.
    #[inline]
    pub(super) fn distance_from_center(&self, coordinate: i32, axis: usize) -> i32 {
        let off = coordinate.wrapping_sub(self.base[axis]).clamp(-1 << 26, 1 << 26);
        let limit = (REACH << self.down) >> self.up;
        (((off << 4) - self.middle[axis]).clamp(-limit, limit) << self.up) >> self.down
    }

    /// Number of lowest bits of the residual that are noise, by the rank of the axis; not 0 only if rings
    /// are wide.
    #[inline]
    pub(super) fn noise(&self, slot: usize) -> u32 {
        (self.down + 1).saturating_sub(self.up + slot as u32 / 2)
    }
}

/// Sums the parallelogram predictions: the opposite vertices, mirrored at the midpoints of their ring edges.
fn parallelograms(around: &Surroundings, n: usize, rings: i32x4) -> i32x4 {
    let across = around.across[..n].iter().fold(i32x4::ZERO, |sum, &spot| sum + i32x4::new(spot));
    if rings.to_array()[3] + across.to_array()[3] == 2 * n as i32 {
        return rings + rings - across;
    }
    let mut sum = i32x4::ZERO;
    for i in 0..n {
        let [p, q] = [i, if i + 1 < n { i + 1 } else { 0 }].map(|i| around.ring[i]);
        let r = around.across[i];
        if p[3] & q[3] & r[3] != 0 {
            sum += i32x4::new(p) + i32x4::new(q) - i32x4::new(r);
        }
    }
    sum
}

/// Divides a sum of points by their number. The result is relative to `base`, in 1/16 grid steps.
#[inline]
fn mean(sum: i32x4, base: i32x4) -> Option<[i32; 4]> {
    let [x, y, z, count] = sum.to_array();
    let [a, b, c, _] = base.to_array();
    let inverse = i64::from(*INVERSES.get(count as usize)?);
    let part = |x: i32, a: i32| ((i64::from(x.wrapping_sub(a.wrapping_mul(count))) * inverse) >> 8) as i32;
    (count > 0).then(|| [part(x, a), part(y, b), part(z, c), 0])
}

/// Returns the axes from the most tangential to the most normal, and the slopes, from two diagonals of
/// the ring.
fn axes_and_slopes(d: [i32; 4], e: [i32; 4]) -> ([usize; 3], [i32; 2]) {
    let normal = [[1, 2], [2, 0], [0, 1]].map(|[a, b]| d[a] * e[b] - d[b] * e[a]);
    let steep = normal.map(i32::unsigned_abs);
    // Sorts three values without unpredictable branches.
    let [xy, xz, yz] = [steep[0] > steep[1], steep[0] > steep[2], steep[1] > steep[2]].map(usize::from);
    let mut axes = [0; 3];
    for (axis, rank) in [xy + xz, 1 - xy + yz, 2 - xz - yz].into_iter().enumerate() {
        axes[rank] = axis;
    }
    let steepest = normal[axes[2]] >> 12;
    let slope = |a: usize| if steepest == 0 { 0 } else { (normal[a] / steepest).clamp(-4096, 4096) };
    (axes, [slope(axes[0]), slope(axes[1])])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hexagon around a vertex at (1000, 2000, 300), and the vertices across its edges.
    fn hexagon() -> Surroundings {
        let mut around = Surroundings { count: 6, ..Surroundings::default() };
        let corners = [[200, 0], [100, 173], [-100, 173], [-200, 0], [-100, -173], [100, -173]];
        let spot = |[x, y]: [i32; 2]| [1000 + x, 2000 + y, 300, 1];
        for (i, [x, y]) in corners.into_iter().enumerate() {
            let [p, q] = corners[(i + 1) % 6];
            around.ring[i] = spot([x, y]);
            around.across[i] = spot([x + p, y + q]);
        }
        around
    }

    #[test]
    fn all_predictions_of_a_regular_ring_agree() {
        let prediction = Prediction::new(&hexagon());
        let coords = [0, 1, 2].map(|a| prediction.to_grid(0, a));
        assert_eq!(coords, [1000, 2000, 300]);
        assert_eq!((prediction.axes[2], prediction.slopes), (2, [0, 0]));
        assert!((1024..2048).contains(&prediction.radius), "{}", prediction.radius);
        for feature in prediction.features {
            assert!(feature[0].abs() < 12, "{:?}", prediction.features);
        }
        // The vertex that split is one radius away.
        assert!((900..2048).contains(&prediction.features[0][1]), "{:?}", prediction.features);
    }

    #[test]
    fn unknown_points_are_ignored() {
        let whole = Prediction::new(&hexagon());
        let mut around = hexagon();
        around.across[2] = [0; 4];
        assert!(Prediction::new(&around).features[0][0].abs() < 12);
        around.ring[3] = [0; 4];
        let part = Prediction::new(&around);
        // The center of the remaining five moves away from the missing one by a fifth of the radius.
        assert_eq!(whole.to_grid(0, 0) + 40, part.to_grid(0, 0));
    }

    #[test]
    fn coordinates_survive_conversion_to_local_units() {
        for factor in [1, 7, 1000, 40_000] {
            let mut around = hexagon();
            let scaled = |spot: KnownCoords| [spot[0] * factor, spot[1] * factor, spot[2] * factor, spot[3]];
            around.ring = around.ring.map(scaled);
            around.across = around.across.map(scaled);
            let prediction = Prediction::new(&around);
            assert_eq!(prediction.axes[2], 2);
            for off in [-150, -3, 0, 40, 199] {
                let coords = (1000 + off) * factor;
                let found = prediction.to_grid(prediction.distance_from_center(coords, 0), 0);
                // If rings are wide, local units are coarser than the grid.
                assert!((found - coords).abs() <= factor / 4 + 1, "{found} for {coords}");
            }
        }
    }
}
