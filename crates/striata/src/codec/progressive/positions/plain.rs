//! Positions from one prediction: quick to read.
//!
//! The prediction blends the middle of the ring, what the triangles around it point to, and the vertex that split, by learned
//! weights. What is left is coded by halvings with counters alone.

use super::super::super::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Rate, log2_q8};
use super::super::hood::Hood;
use super::blend::Blend;
use super::local::Local;
use super::sight::{INVERSES, mean, normal_order};

/// Nodes of the tree that have counters.
const NODES: usize = 64;
/// Kinds of sizes, and kinds of disagreement.
const SIZES: usize = 64;
const SPREADS: usize = 128;

/// A model of positions with one prediction.
#[derive(Clone, Debug)]
pub(super) struct PlainModel {
    local: Local,
    /// Along the surface and across it, by valence.
    blends: [[Blend<3>; 4]; 2],
    axes: [PlainAxis; 3],
}

#[derive(Clone, Debug)]
struct PlainAxis {
    is_far: Vec<AdaptiveBit>,
    far: AdaptiveNumber,
    by_size: Vec<[AdaptiveBit; NODES]>,
    by_spread: Vec<[AdaptiveBit; NODES]>,
}

impl PlainAxis {
    fn new() -> Self {
        let bit = AdaptiveBit::new(Rate::Steady);
        Self {
            is_far: vec![bit; SPREADS],
            far: AdaptiveNumber::new(SIZES, Rate::Steady),
            by_size: vec![[bit; NODES]; SIZES],
            by_spread: vec![[bit; NODES]; SPREADS],
        }
    }

    /// Codes how far off the prediction is; `span_log` is what the ring's radius lets expect.
    fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        (size, spread, span_log): (usize, usize, u32),
        actual: i32,
    ) -> i32 {
        let half = 1i32 << span_log;
        if self.is_far[spread].code(coder, !(-half..half).contains(&actual)) {
            return self.far.signed(coder, size, actual);
        }
        let (by_size, by_spread) = (&mut self.by_size[size], &mut self.by_spread[spread]);
        let (mut low, mut step, mut node) = (-half, half, 1);
        loop {
            let [one, other] = [&mut by_size[node & (NODES - 1)], &mut by_spread[node & (NODES - 1)]];
            let is_up = coder.bit(actual >= low + step, (one.p_one() + other.p_one()) >> 1);
            one.update(is_up);
            other.update(is_up);
            low += if is_up { step } else { 0 };
            if step == 1 {
                return low;
            }
            step >>= 1;
            node = node << 1 | usize::from(is_up);
            if node >= NODES {
                return low + rest(coder, actual.wrapping_sub(low), step);
            }
        }
    }
}

/// The lowest bits, all values alike.
fn rest<C: Coder>(coder: &mut C, actual: i32, step: i32) -> i32 {
    let bits = step.ilog2() + 1;
    let low = bits.min(16);
    let high = coder.raw(actual as u32 >> low, bits - low);
    (high << low | coder.raw(actual as u32, low)) as i32
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
            // As in the thorough models: counters see the vertex that split, or the outside, upwards.
            let is_mirrored = if slot < 2 { features[1] < expected } else { normal[a] < 0 };
            let flip = if is_mirrored { -1 } else { 0 };
            let centre = self.local.to_grid(lifted, a).wrapping_sub(flip);
            let distance = (features[1] - expected).unsigned_abs() * 8 / self.local.radius as u32;
            let spread = features[0].unsigned_abs() * 1024 / self.local.radius as u32;
            let spread =
                ((log2_q8(spread + 16) - 1024) >> 8).clamp(0, 7) as usize * 16 + distance.min(15) as usize;
            let span_log = (11 - self.local.shift - slot as i32 / 2).clamp(1, 29) as u32;
            let residual = actual[a].wrapping_sub(centre) ^ flip;
            let coded = self.axes[slot].code(coder, (size, spread, span_log), residual);
            place[a] = centre.wrapping_add(coded ^ flip);
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
