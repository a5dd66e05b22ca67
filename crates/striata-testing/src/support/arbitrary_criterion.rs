//! A view criterion with arbitrary weights.

use striata::view::{Criterion, Part, Verdict};

/// Weighs parts by a hash, so it has none of the properties of a sensible criterion.
#[derive(Clone)]
pub struct ArbitraryCriterion(pub u32);

impl Criterion for ArbitraryCriterion {
    fn weigh(&self, part: &Part) -> Verdict {
        let bits =
            part.sphere.center.iter().fold(self.0, |all, x| all.wrapping_mul(0x9e37_79b1) ^ x.to_bits());
        Verdict::now((bits.wrapping_mul(0x85eb_ca6b) >> 16) as f32 / 25_000.0)
    }
}
