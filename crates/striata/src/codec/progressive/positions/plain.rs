//! Positions from one prediction: quick to read.
//!
//! The prediction blends the middle of the ring, what the triangles around it point to, and the vertex that split, by learned
//! weights. What is left is one symbol an axis, and the bits below.

use super::super::super::entropy::{AdaptiveNumber, AdaptiveSymbol, Coder, Rate, code_symbol, log2_q8};
use super::super::hood::Hood;
use super::blend::Blend;
use super::local::Local;
use super::sight::{INVERSES, mean, normal_order};

/// Kinds of sizes, and kinds of disagreement.
const SIZES: usize = 64;
const SPREADS: usize = 16;

/// A model of positions with one prediction.
#[derive(Clone, Debug)]
pub(super) struct PlainModel {
    local: Local,
    /// Along the surface and across it, by valence.
    blends: [[Blend<3>; 4]; 2],
    axes: [PlainAxis; 3],
}

/// How far off predictions are along an axis: zero, or a sign and a bucket (1, 2 to 3, ..), all else being noise.
#[derive(Clone, Debug)]
struct PlainAxis {
    by_size: Vec<AdaptiveSymbol>,
    by_spread: Vec<AdaptiveSymbol>,
    far: AdaptiveNumber,
}

/// The symbol of what lies in no bucket.
const FAR: usize = 15;
/// The buckets that have symbols, and the number that lies beyond them.
const NEAR: u32 = 1 << 7;

impl PlainAxis {
    fn new() -> Self {
        Self {
            by_size: vec![AdaptiveSymbol::new(); SIZES],
            by_spread: vec![AdaptiveSymbol::new(); SPREADS],
            far: AdaptiveNumber::new(SIZES, Rate::Steady),
        }
    }

    /// Codes how far off the prediction is; `span_log` is what the ring's radius lets expect.
    fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        (size, spread, span_log): (usize, usize, u32),
        actual: i32,
    ) -> i32 {
        // Where rings are wide the lowest bits tell nothing.
        let noise = span_log.saturating_sub(6);
        let high = actual >> noise;
        let distance = high.unsigned_abs();
        let bucket = distance.max(1).ilog2();
        let meant = match distance {
            0 => 0,
            NEAR.. => FAR,
            _ => 1 + 2 * bucket as usize + usize::from(high < 0),
        };
        let symbol = code_symbol(coder, &mut self.by_size[size], &mut self.by_spread[spread], meant);
        let high = match symbol {
            0 => 0,
            FAR => self.far.signed(coder, size, high),
            _ => {
                let bucket = (symbol as u32 - 1) / 2;
                let distance = 1 << bucket | coder.raw(distance, bucket) as i32;
                if symbol % 2 == 0 { -distance } else { distance }
            }
        };
        let low = coder.raw(actual as u32, noise.min(24)) as i32;
        high.wrapping_shl(noise) | low
    }
}

impl PlainModel {
    /// Knows nothing yet.
    pub(super) fn new() -> Self {
        Self {
            local: Local::default(),
            blends: [[Blend::new([16_000, 0, 0]); 4]; 2],
            axes: [PlainAxis::new(), PlainAxis::new(), PlainAxis::new()],
        }
    }

    /// Codes the place of a new vertex.
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C, hood: &Hood<'_>, actual: [i32; 3]) -> [i32; 3] {
        self.local.look(hood, false);
        let (normal, axes) = normal_order(&self.local);
        let valence = self.local.count.clamp(4, 7) - 4;
        let off = self.features();
        let size =
            (2 * (self.local.shift + 16) + (self.local.radius >> 9 & 1)).min(SIZES as i32 - 1) as usize;
        let mut place = [0; 3];
        // What the place found so far adds to the height of the last axis.
        let mut rise = 0;
        for (slot, &a) in axes.iter().enumerate() {
            let features = off[a];
            let blend = &mut self.blends[slot / 2][valence];
            let expected = blend.predict(&features);
            let lifted = if slot < 2 { expected } else { (expected - rise).clamp(-12_000, 12_000) };
            let centre = self.local.to_grid(lifted, a);
            let spread = features[0].unsigned_abs() * 1024 / self.local.radius as u32;
            let spread = ((log2_q8(spread + 16) - 1024) >> 7).clamp(0, SPREADS as i32 - 1) as usize;
            let span_log = (11 - self.local.shift - slot as i32 / 2).clamp(1, 29) as u32;
            let residual = actual[a].wrapping_sub(centre);
            place[a] = centre.wrapping_add(self.axes[slot].code(coder, (size, spread, span_log), residual));
            let found = self.local.localise_axis(place[a], a);
            let error = (found - lifted).clamp(-self.local.radius, self.local.radius);
            blend.learn(&features, error);
            if slot < 2 && normal[axes[2]] != 0 {
                rise += (i64::from(found - expected) * normal[a] / normal[axes[2]]) as i32;
            }
        }
        place
    }

    /// By axis, how far from the middle of the ring others lie: the mean of parallelograms across ring edges, the vertex that
    /// split, and the middle of its neighbours in the ring.
    fn features(&self) -> [[i32; 3]; 3] {
        let local = &self.local;
        let n = local.count;
        let (mut sum, mut count) = ([0; 3], 0);
        for i in 0..n {
            let next = if i + 1 == n { 0 } else { i + 1 };
            if let (Some(p), Some(q), Some(r)) = (local.ring[i], local.ring[next], local.apexes[i]) {
                (0..3).for_each(|a| sum[a] += p[a] + q[a] - r[a]);
                count += 1;
            }
        }
        let kept = local.ring[0].unwrap_or_default();
        let beside = mean(local.ring[1 % n], local.ring[n - 1]);
        [0, 1, 2].map(|a| [(sum[a] * INVERSES[count]) >> 12, kept[a], beside[a]])
    }
}
