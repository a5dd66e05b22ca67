//! Codes positions from one prediction; fast to decode.
//!
//! The prediction blends the center of the ring, the points suggested by the surrounding triangles, and
//! the vertex that split, with learned weights. The residual is one symbol per axis and its low bits.

use super::blend::Blend;
use super::local::LANES;
use super::position_density::INVERSES;
use super::residual::{ResidualContext, code_residual};
use crate::entropy::{AdaptiveNumber, AdaptiveSymbol, Coder, Rate, code_symbol, log2_q8};
use crate::topology::neighborhood::Neighborhood;
use crate::topology::surface::next;

/// Numbers of size classes and of spread classes.
const SIZES: usize = 64;
const SPREADS: usize = 16;

/// A position model with one prediction.
#[derive(Clone, Debug)]
pub(super) struct PlainModel {
    /// By direction (along or across the surface) and valence.
    blends: [[Blend<3>; 4]; 2],
    axes: [PlainAxis; 3],
}

/// Codes residuals along an axis: zero, or a sign and a bucket (1, 2 to 3, ..); all else is noise.
#[derive(Clone, Debug)]
struct PlainAxis {
    by_size: Vec<AdaptiveSymbol>,
    by_spread: Vec<AdaptiveSymbol>,
    far: AdaptiveNumber,
}

impl PlainAxis {
    fn new() -> Self {
        Self {
            by_size: vec![AdaptiveSymbol::new(); SIZES],
            by_spread: vec![AdaptiveSymbol::new(); SPREADS],
            far: AdaptiveNumber::new(SIZES, Rate::Steady),
        }
    }

    /// Codes the residual of a prediction.
    #[inline]
    fn code<C: Coder>(&mut self, coder: &mut C, at: ResidualContext, actual: i32) -> i32 {
        let Self { by_size, by_spread, far } = self;
        let (one, other) = (&mut by_size[at.size], &mut by_spread[at.spread]);
        code_residual(coder, far, at, actual, |coder, actual_symbol| {
            code_symbol(coder, one, other, actual_symbol)
        })
    }
}

/// The surroundings of a new vertex, as far as one prediction needs them.
///
/// Sums are in grid steps relative to a ring vertex. Only the results are converted to local units, in
/// which the ring's radius has eleven bits.
struct PlainSurroundings {
    /// The ring vertex that other coordinates are relative to.
    base: [i32; 3],
    /// Center of the ring, in 1/16 grid steps.
    middle: [i32; 3],
    /// Local units are 1/16 grid steps times 2 to this power.
    scale: i32,
    /// Approximate radius of the ring, in local units.
    radius: i32,
    normal: [i32; 3],
    /// Axes from the most tangential to the most normal.
    axes: [usize; 3],
    /// For each axis, the distances of three points from the center of the ring: the mean of parallelograms
    /// across ring edges, the vertex that split, and the midpoint of its neighbors in the ring.
    features: [[i32; 3]; 3],
}

/// Three coordinates and a flag of 1, or all zeros if they are unknown.
type Known = [i32; 4];

/// Limit of local coordinates.
const LOCAL_REACH: i64 = 12_000;

impl PlainSurroundings {
    /// Gathers the surroundings of a vertex.
    fn gather(neighborhood: &Neighborhood<'_>) -> Self {
        let corners = &neighborhood.corners[..neighborhood.corners.len().min(LANES)];
        let n = corners.len();
        let first = neighborhood.surface.virtual_count();
        let is_known = |vertex: u32| first <= vertex && vertex < neighborhood.vertex;
        let mut ids = corners.iter().map(|&corner| neighborhood.surface.vertex(next(corner)));
        let near = ids.find(|&vertex| is_known(vertex)).map(|vertex| vertex as usize);
        let base = near.map_or([0; 3], |near| neighborhood.coords[near]);
        // Without branches, because they would be unpredictable.
        let off = |vertex: u32| {
            let is_known = is_known(vertex);
            let coords = neighborhood.coords[if is_known { vertex as usize } else { near.unwrap_or(0) }];
            let mask = -i32::from(is_known);
            let [x, y, z] = [0, 1, 2].map(|a| coords[a].wrapping_sub(base[a]) & mask);
            [x, y, z, i32::from(is_known)]
        };
        let (mut ring, mut apexes) = ([[0; 4]; LANES + 1], [[0; 4]; LANES]);
        for (i, &corner) in corners.iter().enumerate() {
            ring[i] = off(neighborhood.surface.vertex(next(corner)));
            apexes[i] = off(neighborhood.surface.vertex(neighborhood.surface.opposite(corner)));
        }
        let ring_sum = ring.iter().fold([0; 4], |sum, p| add(sum, *p));
        ring[n] = ring[0];
        let mut sum = [0i32; 4];
        for i in 0..LANES {
            let (p, q, r) = (ring[i], ring[i + 1], apexes[i]);
            // All ones if all three points are known.
            let mask = -(p[3] & q[3] & r[3]);
            (0..4).for_each(|a| {
                sum[a] = sum[a].wrapping_add(p[a].wrapping_add(q[a]).wrapping_sub(r[a]) & mask);
            });
        }
        let middle = mean(ring_sum).unwrap_or_default();
        let from_middle = |p: Known| mean(p).map_or([0; 3], |p| minus(p, middle));
        let quarter = (n / 4).max(1);
        let [d, e] = [[0, n / 2], [quarter, (quarter + n / 2) % n]]
            .map(|[i, j]| minus(from_middle(ring[i]), from_middle(ring[j])));
        // Manhattan distances exceed Euclidean ones by about half.
        let radius = d.iter().chain(&e).map(|x| x.unsigned_abs() >> 2).sum::<u32>().max(12) / 3 * 2;
        let scale = 10 - radius.ilog2() as i32;
        let radius = if scale < 0 { radius >> -scale } else { radius << scale } as i32;
        let mut around =
            Self { base, middle, scale, radius, normal: [0; 3], axes: [0, 1, 2], features: [[0; 3]; 3] };
        let points = [sum, ring[0], add(ring[1], ring[n - 1])].map(from_middle);
        around.features = [0, 1, 2].map(|a| points.map(|p| around.to_local(p[a].into())));
        around.set_normal(d, e);
        around
    }

    /// Computes the normal from two diagonals of the ring, and the order of the axes.
    fn set_normal(&mut self, d: [i32; 3], e: [i32; 3]) {
        let [d, e] = [d, e].map(|x| x.map(|x| self.to_local(x.into())));
        self.normal = [[1, 2], [2, 0], [0, 1]].map(|[a, b]| d[a] * e[b] - d[b] * e[a]);
        let steep = self.normal.map(i32::unsigned_abs);
        self.axes.sort_unstable_by_key(|&a| steep[a]);
    }

    /// Converts a distance from 1/16 grid steps to local units.
    #[inline]
    fn to_local(&self, distance: i64) -> i32 {
        ((distance << 8) >> (8 - self.scale)).clamp(-LOCAL_REACH, LOCAL_REACH) as i32
    }

    /// Returns the grid coordinate nearest to a distance from the center, given in local units.
    #[inline]
    fn to_grid(&self, local: i32, axis: usize) -> i32 {
        let off = (i64::from(local) << (24 - self.scale)) >> 24;
        self.base[axis].wrapping_add(((i64::from(self.middle[axis]) + off + 8) >> 4) as i32)
    }

    /// Returns a grid coordinate's distance from the center, in local units.
    #[inline]
    fn distance_from_center(&self, coordinate: i32, axis: usize) -> i32 {
        let off = coordinate.wrapping_sub(self.base[axis]);
        self.to_local(16 * i64::from(off) - i64::from(self.middle[axis]))
    }
}

#[inline]
fn add(p: Known, q: Known) -> Known {
    [0, 1, 2, 3].map(|a| p[a].wrapping_add(q[a]))
}

/// Divides a sum of points by their number. The result is in 1/16 of the sum's units.
#[inline]
fn mean(sum: Known) -> Option<[i32; 3]> {
    let inverse = i64::from(INVERSES[sum[3] as usize]);
    (sum[3] > 0).then(|| [0, 1, 2].map(|a| ((i64::from(sum[a]) * inverse) >> 8) as i32))
}

#[inline]
fn minus(p: [i32; 3], q: [i32; 3]) -> [i32; 3] {
    [0, 1, 2].map(|a| p[a].wrapping_sub(q[a]))
}

impl PlainModel {
    /// Creates an untrained model.
    pub(super) fn new() -> Self {
        Self {
            blends: [[Blend::new([16_000, 0, 0]); 4]; 2],
            axes: [PlainAxis::new(), PlainAxis::new(), PlainAxis::new()],
        }
    }

    /// Codes the grid coordinates of a new vertex.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        neighborhood: &Neighborhood<'_>,
        actual: [i32; 3],
    ) -> [i32; 3] {
        let around = PlainSurroundings::gather(neighborhood);
        let (normal, axes) = (around.normal, around.axes);
        let valence = neighborhood.corners.len().clamp(4, 7) - 4;
        let size = (2 * (20 + around.scale) + (around.radius >> 9 & 1)).clamp(0, SIZES as i32 - 1) as usize;
        let mut coords = [0; 3];
        // Change of the last axis's prediction due to the first two coordinates.
        let mut rise = 0;
        for (slot, &a) in axes.iter().enumerate() {
            let features = &around.features[a];
            let blend = &mut self.blends[slot / 2][valence];
            let expected = blend.predict(features);
            let lifted = if slot < 2 { expected } else { (expected - rise).clamp(-12_000, 12_000) };
            let center = around.to_grid(lifted, a);
            let spread =
                ((log2_q8(features[0].unsigned_abs() + 16) - 1024) >> 7).clamp(0, SPREADS as i32 - 1);
            // If rings are wide, the lowest bits are noise.
            let noise = (1 - around.scale - slot as i32 / 2).clamp(0, 17) as u32;
            let context = ResidualContext { size, spread: spread as usize, noise };
            let residual = actual[a].wrapping_sub(center);
            coords[a] = center.wrapping_add(self.axes[slot].code(coder, context, residual));
            let found = around.distance_from_center(coords[a], a);
            let error = (found - lifted).clamp(-around.radius, around.radius);
            blend.learn(features, error);
            if slot < 2 && normal[axes[2]] != 0 {
                rise +=
                    (i64::from(found - expected) * i64::from(normal[a]) / i64::from(normal[axes[2]])) as i32;
            }
        }
        coords
    }
}
