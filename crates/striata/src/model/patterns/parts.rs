//! The arrays of patterns as files hold them, and back.
//!
//! Rules and ways are numbers of 7 bits a byte, the eighth saying that more follow. What comes back is unpacked to the fragments
//! that it stands for and built again: if that gives the same, it is what a build makes, and nothing it says can be
//! wrong for any set of fragments.

use super::build::Extras;
use super::overlaps::{MAX_RUN, OverlapTable, Share};
use super::records::{Records, Widths};
use super::rule::{NONE, Rule};
use super::rule_table::RuleTable;
use super::{BaseFace, Patterns};
use crate::model::bits::Bits;
use crate::model::step_bounds::StepBounds;
use crate::model::{ModelError, StepVertices};

/// Everything that a file holds of patterns.
#[derive(Clone, Debug)]
pub(crate) struct PatternsParts<'a> {
    /// Half-edges of the largest floor, bits of an offset, bits of all records (low word, high word).
    pub(crate) header: [u32; 4],
    pub(crate) rules: Vec<u8>,
    pub(crate) ways: Vec<u8>,
    pub(crate) blocks: &'a [u32],
    pub(crate) records: &'a [u8],
    /// Corners, group, fragment above, half-edge in its floor.
    pub(crate) base: Vec<[u32; 6]>,
    /// Step and vertex, for each vertex that a step names.
    pub(crate) extras: Vec<[u32; 2]>,
}

impl Patterns {
    pub(crate) fn parts(&self) -> PatternsParts<'_> {
        let widths = self.records.widths(self.rules.len(), self.ways.len());
        let (blocks, bits) = self.records.parts();
        let length = bits.len() as u64;
        let named = |i: usize| {
            let vertices =
                &self.extras.vertices[self.extras.firsts[i] as usize..self.extras.firsts[i + 1] as usize];
            vertices.iter().map(move |&vertex| [self.extras.steps[i], vertex])
        };
        PatternsParts {
            header: [widths.half_edge_count, widths.offset_width, length as u32, (length >> 32) as u32],
            rules: rules_to_bytes(&self.rules),
            ways: ways_to_bytes(&self.ways),
            blocks,
            records: bits.as_bytes(),
            base: self
                .base
                .iter()
                .map(|face| {
                    let [a, b, c] = face.corners;
                    [a, b, c, face.group, face.above, face.half_edge]
                })
                .collect(),
            extras: (0..self.extras.steps.len()).flat_map(named).collect(),
        }
    }

    /// From the arrays of a file; checked, so that no move can fail.
    ///
    /// # Errors
    /// [`ModelError`] naming what does not fit.
    pub(crate) fn from_parts(
        vertices: StepVertices<'_>,
        group_count: usize,
        parts: PatternsParts<'_>,
    ) -> Result<Self, ModelError> {
        for (what, bytes) in [("bytes of rules", &parts.rules), ("bytes of ways", &parts.ways)] {
            let (found, limit) = (bytes.len() as u64, MAX_TABLE_BYTES);
            if found > limit {
                return Err(ModelError::TooMany { what, found, limit });
            }
        }
        let step_count = vertices.step_count();
        vertices.check_firsts(step_count)?;
        let vertices = vertices.without_targets().shortened();
        let rules = rules_from_bytes(&parts.rules, group_count)?;
        let ways = ways_from_bytes(&parts.ways)?;
        let [half_edge_count, offset_width, low, high] = parts.header;
        let length = u64::from(low) | u64::from(high) << 32;
        let bits = usize::try_from(length).ok().and_then(|length| Bits::from_bytes(parts.records, length));
        let expected = parts.records.len().saturating_mul(8);
        let wrong = ModelError::Length { what: "bits of records", found: length as usize, expected };
        let widths = Widths { rule_count: rules.len(), way_count: ways.len(), half_edge_count, offset_width };
        let blocks = parts.blocks.to_vec();
        let records = Records::from_parts(step_count, widths, (blocks, bits.ok_or(wrong)?), &ways)?;
        let extras = Extras::from_pairs(&parts.extras)?;
        let base = parts.base.iter().map(|&[a, b, c, group, above, half_edge]| BaseFace {
            corners: [a, b, c],
            group,
            above,
            half_edge,
        });
        let is_unfounded = |&step: &u32| rules.rule(records.head(step).rule).floor_count() == 0;
        let unfounded = (0..step_count as u32).filter(is_unfounded).collect();
        let patterns = Self {
            vertices,
            group_count,
            base: base.collect(),
            unfounded,
            rules,
            ways,
            records,
            extras,
            bounds: None,
        };
        patterns.check_size()?;
        let fragments = patterns.unpack(vec![0.0; step_count])?;
        if Self::from_fragments(&fragments, group_count)? != patterns {
            return Err(ModelError::Listed {
                what: "pattern",
                place: 0,
                reason: "is not as it would be built",
            });
        }
        Ok(patterns)
    }

    /// The same patterns with the bounds of their fragments from their bytes.
    ///
    /// # Errors
    /// If there are more or fewer records than fragments, or one holds what no bounds are.
    pub(crate) fn with_stored_bounds(self, bytes: &[u8]) -> Result<Self, ModelError> {
        let bounds = StepBounds::from_bytes(bytes, self.fragment_count(), None)?;
        Ok(Self { bounds: Some(bounds), ..self })
    }

    /// The bounds as a file is to hold them; none of fragments alone.
    pub(crate) fn stored_bounds(&self) -> &[u8] {
        self.bounds.as_ref().map_or(&[], StepBounds::as_bytes)
    }

    /// Fragments that there are bounds of.
    pub(crate) fn bounded_step_count(&self) -> usize {
        self.bounds.as_ref().map_or(0, StepBounds::step_count)
    }
}

impl Extras {
    /// From steps and vertices that they name, as [`Patterns::parts`] lists them.
    ///
    /// # Errors
    /// [`ModelError::Listed`] where a step comes before an earlier one.
    fn from_pairs(pairs: &[[u32; 2]]) -> Result<Self, ModelError> {
        let mut extras = Self { firsts: vec![0], ..Self::default() };
        for (place, &[step, vertex]) in pairs.iter().enumerate() {
            let last = extras.steps.last().copied();
            if last.is_some_and(|last| last > step) {
                return Err(ModelError::Listed { what: "named vertex", place, reason: "is out of order" });
            }
            extras.vertices.push(vertex);
            if last == Some(step) {
                extras.firsts.pop();
            } else {
                extras.steps.push(step);
            }
            extras.firsts.push(place as u32 + 1);
        }
        Ok(extras)
    }
}

/// Bytes of a table of rules or ways: numbered in 32 bits once they are unpacked, to fewer than four numbers a byte.
const MAX_TABLE_BYTES: u64 = 1 << 30;
/// Triangles of all ceilings that a file may have for each vertex, beside those that links tell.
const MAX_UNLINKED: u64 = 128;

impl Patterns {
    /// Refuses patterns that stand for far more triangles than they have bits: those could fill any memory.
    ///
    /// # Errors
    /// [`ModelError::Dense`] telling how many there are and may be.
    pub(crate) fn check_size(&self) -> Result<(), ModelError> {
        let ceilings =
            (0..self.records.step_count as u32).map(|step| self.rules.rule(self.records.head(step).rule));
        let found: u64 = ceilings.map(|rule| rule.ceiling_count() as u64).sum();
        let (_, bits) = self.records.parts();
        let limit = bits.len() as u64 + MAX_UNLINKED * self.vertices.vertex_count as u64;
        if found > limit {
            return Err(ModelError::Dense { found, limit });
        }
        Ok(())
    }
}

fn put(mut number: u32, out: &mut Vec<u8>) {
    while number >= 0x80 {
        out.push(number as u8 | 0x80);
        number >>= 7;
    }
    out.push(number as u8);
}

/// Reads numbers as [`put`] writes them.
struct Numbers<'a> {
    bytes: &'a [u8],
    what: &'static str,
    place: usize,
}

impl Numbers<'_> {
    fn wrong(&self, reason: &'static str) -> ModelError {
        ModelError::Listed { what: self.what, place: self.place, reason }
    }

    fn next(&mut self) -> Result<u32, ModelError> {
        let mut number = 0u64;
        for shift in (0..35).step_by(7) {
            let Some((&byte, rest)) = self.bytes.split_first() else { break };
            self.bytes = rest;
            number |= u64::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return u32::try_from(number).map_err(|_| self.wrong("has a number that is too large"));
            }
        }
        Err(self.wrong("ends within a number"))
    }

    /// A count of things that take a byte each at least.
    fn count(&mut self) -> Result<usize, ModelError> {
        let count = self.next()? as usize;
        if count > self.bytes.len() { Err(self.wrong("is longer than its bytes")) } else { Ok(count) }
    }

    fn numbers(&mut self, count: usize) -> Result<Vec<u32>, ModelError> {
        (0..count).map(|_| self.next()).collect()
    }

    fn triangles(&mut self, count: usize) -> Result<Vec<[u32; 3]>, ModelError> {
        (0..count).map(|_| Ok([self.next()?, self.next()?, self.next()?])).collect()
    }
}

fn rules_to_bytes(rules: &RuleTable) -> Vec<u8> {
    let mut out = Vec::new();
    for rule in rules.iter().map(|rule| rule.to_rule()) {
        put(rule.own_count, &mut out);
        put(rule.local_count, &mut out);
        put(rule.ceiling.len() as u32, &mut out);
        put(rule.floor.len() as u32, &mut out);
        let triangles = rule.ceiling.iter().chain(&rule.floor).flatten();
        let groups = rule.ceiling_groups.iter().chain(&rule.floor_groups);
        triangles.chain(groups).for_each(|&number| put(number, &mut out));
    }
    out
}

fn rules_from_bytes(bytes: &[u8], group_count: usize) -> Result<RuleTable, ModelError> {
    let mut numbers = Numbers { bytes, what: "rule", place: 0 };
    let mut rules = Vec::new();
    while !numbers.bytes.is_empty() {
        let (own_count, local_count) = (numbers.next()?, numbers.next()?);
        let (ceiling, floor) = (numbers.count()?, numbers.count()?);
        let mut rule = Rule {
            own_count,
            local_count,
            ceiling: numbers.triangles(ceiling)?,
            floor: numbers.triangles(floor)?,
            ..Rule::default()
        };
        if group_count > 1 {
            rule.ceiling_groups = numbers.numbers(ceiling)?;
            rule.floor_groups = numbers.numbers(floor)?;
        }
        let corners = || rule.ceiling.iter().chain(&rule.floor).flatten();
        // Each local number beside those of the position's own vertices is a corner of some triangle.
        let is_bounded =
            local_count as usize <= corners().count() + own_count as usize && own_count <= local_count;
        if !is_bounded || corners().any(|&local| local >= local_count) {
            return Err(numbers.wrong("has a corner that is none of its vertices"));
        }
        if rule.ceiling_groups.iter().chain(&rule.floor_groups).any(|&group| group as usize >= group_count) {
            return Err(numbers.wrong("has a group that is not there"));
        }
        rules.push(rule);
        numbers.place += 1;
    }
    Ok(RuleTable::pack(rules))
}

fn ways_to_bytes(ways: &OverlapTable) -> Vec<u8> {
    let mut out = Vec::new();
    for way in 0..ways.len() as u32 {
        put(ways.count(way) as u32, &mut out);
        for share in ways.shares(way) {
            let number = if share.link == Share::FULL { 0 } else { 1 + share.link * MAX_RUN + share.place };
            put(number, &mut out);
        }
    }
    out
}

fn ways_from_bytes(bytes: &[u8]) -> Result<OverlapTable, ModelError> {
    let mut numbers = Numbers { bytes, what: "way", place: 0 };
    let mut ways = Vec::new();
    while !numbers.bytes.is_empty() {
        let count = numbers.count()?;
        let way: Vec<Share> = (0..count)
            .map(|_| {
                Ok(match numbers.next()?.checked_sub(1) {
                    None => Share { link: Share::FULL, place: 0 },
                    Some(packed) => Share { link: packed / MAX_RUN, place: packed % MAX_RUN },
                })
            })
            .collect::<Result<_, ModelError>>()?;
        // Links are numbered as they come, so there are no more than triangles.
        if way.iter().any(|share| share.link != Share::FULL && share.link as usize >= count) {
            return Err(numbers.wrong("has more links than triangles"));
        }
        ways.push(way);
        numbers.place += 1;
    }
    Ok(OverlapTable::pack(ways))
}

/// Stands for a local number of which no vertex is known.
pub(super) const UNKNOWN: u32 = NONE;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_of_many_vertices_and_no_triangles_take_no_memory() {
        let mut bytes = Vec::new();
        for _ in 0..1000 {
            [u32::MAX, u32::MAX, 0, 0].into_iter().for_each(|number| put(number, &mut bytes));
        }
        let rules = rules_from_bytes(&bytes, 1).unwrap();
        assert_eq!((rules.len(), rules.rule(999).extras().count()), (1000, 0));
        [u32::MAX - 1, u32::MAX, 0, 0].into_iter().for_each(|number| put(number, &mut bytes));
        assert!(rules_from_bytes(&bytes, 1).is_err(), "a vertex that nothing shows");
    }

    #[test]
    fn what_rules_and_ways_name_is_there() {
        let with_group = |group| rules_from_bytes(&[1, 3, 1, 0, 0, 1, 2, group], 2);
        assert_eq!(with_group(1).map(|rules| rules.len()), Ok(1));
        assert!(with_group(2).is_err(), "no such group");
        let with_corner = |corner| rules_from_bytes(&[1, 3, 1, 0, 0, 1, corner], 1);
        assert!(with_corner(2).is_ok() && with_corner(3).is_err(), "no such corner");
        let with_link = |link: u8| ways_from_bytes(&[2, 0, 1 + 16 * link]);
        assert_eq!(with_link(1).map(|ways| ways.link_count(0)), Ok(2));
        assert!(with_link(2).is_err(), "more links than triangles");
        assert!(Extras::from_pairs(&[[4, 9], [4, 3], [6, 0]]).is_ok());
        assert!(Extras::from_pairs(&[[4, 9], [6, 0], [4, 3]]).is_err(), "out of order");
    }

    #[test]
    fn numbers_end_within_32_bits() {
        let read = |bytes: &[u8]| Numbers { bytes, what: "rule", place: 0 }.next();
        assert_eq!(read(&[0xff, 0xff, 0xff, 0xff, 0x0f]), Ok(u32::MAX));
        assert!(read(&[0xff, 0xff, 0xff, 0xff, 0x1f]).is_err());
        assert!(read(&[0x80; 9]).is_err());
        assert!(read(&[]).is_err());
    }
}
