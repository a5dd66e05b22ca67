//! Pairs of a rule and a sharing that occur, numbered by frequency.

use std::collections::HashMap;

use super::overlaps::OverlapTable;
use super::rule_table::RuleTable;
use crate::model::ModelError;
use crate::model::bits::{Bits, MAX_WIDTH, width_of};

/// All pairs of a rule and a sharing that occur in a model; each pair is the kind of some fragments.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::model) struct KindTable {
    count: u32,
    rule_bits: u32,
    sharing_bits: u32,
    bits: Bits,
}

impl KindTable {
    /// Numbers the kinds of all steps by frequency, equally frequent ones by first use. Returns the table
    /// and the kind of each step.
    ///
    /// # Errors
    /// [`ModelError::TooMany`] if a kind needs more bits than a field can have.
    pub(super) fn of_steps(
        steps: &[(u32, u32)],
        rules: &RuleTable,
        sharings: &OverlapTable,
    ) -> Result<(Self, Vec<u32>), ModelError> {
        let mut found: HashMap<(u32, u32), u32> = HashMap::new();
        let mut kinds: Vec<((u32, u32), usize)> = Vec::new();
        let mut of_steps: Vec<u32> = Vec::with_capacity(steps.len());
        for &pair in steps {
            let kind = *found.entry(pair).or_insert_with(|| {
                kinds.push((pair, 0));
                kinds.len() as u32 - 1
            });
            kinds[kind as usize].1 += 1;
            of_steps.push(kind);
        }
        let mut order: Vec<u32> = (0..kinds.len() as u32).collect();
        order.sort_by_key(|&kind| std::cmp::Reverse(kinds[kind as usize].1));
        let mut numbers = vec![0; kinds.len()];
        let mut table = Self::empty(kinds.len() as u32, rules, sharings)?;
        for (number, &kind) in (0..).zip(&order) {
            numbers[kind as usize] = number;
            let (rule, sharing) = kinds[kind as usize].0;
            table.bits.push(u64::from(rule), table.rule_bits);
            table.bits.push(u64::from(sharing), table.sharing_bits);
        }
        of_steps.iter_mut().for_each(|kind| *kind = numbers[*kind as usize]);
        Ok((table, of_steps))
    }

    fn empty(count: u32, rules: &RuleTable, sharings: &OverlapTable) -> Result<Self, ModelError> {
        let [rule_bits, sharing_bits] = [rules.len(), sharings.len()].map(|count| width_of(count as u64));
        let (found, limit) = (u64::from(rule_bits + sharing_bits), u64::from(MAX_WIDTH));
        if found > limit {
            return Err(ModelError::TooMany { what: "bits of a kind", found, limit });
        }
        Ok(Self { count, rule_bits, sharing_bits, bits: Bits::default() })
    }

    /// Number of kinds.
    pub(super) fn len(&self) -> u32 {
        self.count
    }

    /// Returns the rule and the sharing of a kind.
    #[inline]
    pub(super) fn get(&self, kind: u32) -> (u32, u32) {
        let width = self.rule_bits + self.sharing_bits;
        let pair = self.bits.get(kind as usize * width as usize, width);
        ((pair & ((1 << self.rule_bits) - 1)) as u32, (pair >> self.rule_bits) as u32)
    }

    pub(super) fn as_bytes(&self) -> &[u8] {
        self.bits.as_bytes()
    }

    pub(super) fn bytes(&self) -> usize {
        self.bits.bytes()
    }

    /// Reads a stored table of at most `step_count` kinds, checking that every rule and sharing exists and
    /// that they belong together.
    ///
    /// # Errors
    /// [`ModelError`] naming the first mismatch.
    pub(super) fn from_bytes(
        bytes: &[u8],
        count: u32,
        step_count: usize,
        rules: &RuleTable,
        sharings: &OverlapTable,
    ) -> Result<Self, ModelError> {
        if count as usize > step_count {
            let (found, limit) = (u64::from(count), step_count as u64);
            return Err(ModelError::TooMany { what: "kinds", found, limit });
        }
        let table = Self::empty(count, rules, sharings)?;
        let width = table.rule_bits + table.sharing_bits;
        let length = (width as usize).saturating_mul(count as usize);
        let Some(bits) = Bits::from_bytes(bytes, length) else {
            let (found, expected) = (bytes.len(), length.div_ceil(8));
            return Err(ModelError::Length { what: "bytes of kinds", found, expected });
        };
        let table = Self { bits, ..table };
        for kind in 0..count {
            let (rule, sharing) = table.get(kind);
            let wrong = |reason| ModelError::Listed { what: "kind", place: kind as usize, reason };
            if rule as usize >= rules.len() || sharing as usize >= sharings.len() {
                return Err(wrong("has a rule or a sharing that does not exist"));
            }
            if sharings.count(sharing) != rules.rule(rule).ceiling_count() {
                return Err(wrong("shares a different number of triangles than its rule has"));
            }
        }
        Ok(table)
    }
}
