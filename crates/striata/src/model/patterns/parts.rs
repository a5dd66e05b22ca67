//! Converts patterns to and from the arrays of the file format.
//!
//! Rules and sharings are stored as varints of 7 bits per byte. A stored model is validated by unpacking
//! it to fragments and building it again: if the result is the same, the model is one that a build
//! produces, and it is valid for every set of fragments.

use super::build::Extras;
use super::overlaps::{MAX_RUN, OverlapTable, Share};
use super::records::{Records, Widths};
use super::rule::{NONE, Rule};
use super::rule_table::RuleTable;
use super::{BaseFace, Patterns};
use crate::model::bits::Bits;
use crate::model::step_bounds::StepBounds;
use crate::model::{ModelError, StepVertices};

/// The stored arrays of patterns.
#[derive(Clone, Debug)]
pub(crate) struct PatternsParts<'a> {
    /// Half-edge count of the largest floor, width of an offset, and total bits of all records (low word,
    /// high word).
    pub(crate) header: [u32; 4],
    pub(crate) rules: Vec<u8>,
    pub(crate) ways: Vec<u8>,
    pub(crate) blocks: &'a [u32],
    pub(crate) records: &'a [u8],
    /// Corners, group, step above, and half-edge in its floor, for each base triangle.
    pub(crate) base: Vec<[u32; 6]>,
    /// Pairs of a step and one of its extra vertices.
    pub(crate) extras: Vec<[u32; 2]>,
}

impl Patterns {
    pub(crate) fn parts(&self) -> PatternsParts<'_> {
        let widths = self.records.widths(self.rules.len(), self.sharings.len());
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
            ways: sharings_to_bytes(&self.sharings),
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

    /// Assembles patterns from stored arrays and validates them, so that no later move can fail.
    ///
    /// # Errors
    /// [`ModelError`] naming the first mismatch.
    pub(crate) fn from_parts(
        vertices: StepVertices<'_>,
        group_count: usize,
        parts: PatternsParts<'_>,
    ) -> Result<Self, ModelError> {
        for (what, bytes) in [("bytes of rules", &parts.rules), ("bytes of sharings", &parts.ways)] {
            let (found, limit) = (bytes.len() as u64, MAX_TABLE_BYTES);
            if found > limit {
                return Err(ModelError::TooMany { what, found, limit });
            }
        }
        let step_count = vertices.step_count();
        vertices.check_firsts(step_count)?;
        let vertices = vertices.without_targets().shortened();
        let rules = rules_from_bytes(&parts.rules, group_count)?;
        let sharings = sharings_from_bytes(&parts.ways)?;
        let [half_edge_count, offset_width, low, high] = parts.header;
        let length = u64::from(low) | u64::from(high) << 32;
        let bits = usize::try_from(length).ok().and_then(|length| Bits::from_bytes(parts.records, length));
        let expected = parts.records.len().saturating_mul(8);
        let wrong = ModelError::Length { what: "bits of records", found: length as usize, expected };
        let widths =
            Widths { rule_count: rules.len(), sharing_count: sharings.len(), half_edge_count, offset_width };
        let blocks = parts.blocks.to_vec();
        let records = Records::from_parts(step_count, widths, (blocks, bits.ok_or(wrong)?), &sharings)?;
        let extras = Extras::from_pairs(&parts.extras)?;
        let base = parts.base.iter().map(|&[a, b, c, group, above, half_edge]| BaseFace {
            corners: [a, b, c],
            group,
            above,
            half_edge,
        });
        let is_unfounded = |&step: &u32| rules.rule(records.head(step).rule).floor_count() == 0;
        let floorless = (0..step_count as u32).filter(is_unfounded).collect();
        let patterns = Self {
            vertices,
            group_count,
            base: base.collect(),
            floorless,
            rules,
            sharings,
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
                reason: "differs from what a build produces",
            });
        }
        Ok(patterns)
    }

    /// Adds bounds read from their stored bytes.
    ///
    /// # Errors
    /// If the number of records differs from that of the fragments, or a record is not a valid bound.
    pub(crate) fn with_stored_bounds(self, bytes: &[u8]) -> Result<Self, ModelError> {
        let bounds = StepBounds::from_bytes(bytes, self.fragment_count(), None)?;
        Ok(Self { bounds: Some(bounds), ..self })
    }

    /// Returns the bounds to store in a file; empty if there are none.
    pub(crate) fn stored_bounds(&self) -> &[u8] {
        self.bounds.as_ref().map_or(&[], StepBounds::as_bytes)
    }

    /// Number of steps that have bounds.
    pub(crate) fn bounded_step_count(&self) -> usize {
        self.bounds.as_ref().map_or(0, StepBounds::step_count)
    }
}

impl Extras {
    /// Builds the table from pairs of a step and an extra vertex, as listed by [`Patterns::parts`].
    ///
    /// # Errors
    /// [`ModelError::Listed`] if the steps are not ascending.
    fn from_pairs(pairs: &[[u32; 2]]) -> Result<Self, ModelError> {
        let mut extras = Self { firsts: vec![0], ..Self::default() };
        for (place, &[step, vertex]) in pairs.iter().enumerate() {
            let last = extras.steps.last().copied();
            if last.is_some_and(|last| last > step) {
                return Err(ModelError::Listed { what: "extra vertex", place, reason: "is out of order" });
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

/// Size limit of a stored table of rules or sharings. Unpacked, a byte becomes less than four numbers, so
/// 32-bit indices suffice.
const MAX_TABLE_BYTES: u64 = 1 << 30;
/// Number of ceiling triangles per vertex that a file may contain in addition to those that its bits
/// account for.
const MAX_UNLINKED: u64 = 128;

impl Patterns {
    /// Rejects patterns that expand to far more triangles than their bits justify, since these could
    /// exhaust memory.
    ///
    /// # Errors
    /// [`ModelError::Dense`] with the number of triangles and the limit.
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

/// Appends a varint.
fn write_number(mut number: u32, out: &mut Vec<u8>) {
    while number >= 0x80 {
        out.push(number as u8 | 0x80);
        number >>= 7;
    }
    out.push(number as u8);
}

/// Decodes varints written by [`write_number`].
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
        Err(self.wrong("ends in the middle of a number"))
    }

    /// Reads the count of a list whose elements take at least one byte each.
    fn count(&mut self) -> Result<usize, ModelError> {
        let count = self.next()? as usize;
        if count > self.bytes.len() {
            Err(self.wrong("has a count that exceeds its bytes"))
        } else {
            Ok(count)
        }
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
        write_number(rule.own_count, &mut out);
        write_number(rule.local_count, &mut out);
        write_number(rule.ceiling.len() as u32, &mut out);
        write_number(rule.floor.len() as u32, &mut out);
        let triangles = rule.ceiling.iter().chain(&rule.floor).flatten();
        let groups = rule.ceiling_groups.iter().chain(&rule.floor_groups);
        triangles.chain(groups).for_each(|&number| write_number(number, &mut out));
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
        // Every local vertex except for own vertices must be a corner of some triangle.
        let is_bounded =
            local_count as usize <= corners().count() + own_count as usize && own_count <= local_count;
        if !is_bounded || corners().any(|&local| local >= local_count) {
            return Err(numbers.wrong("has a corner that is not one of its vertices"));
        }
        if rule.ceiling_groups.iter().chain(&rule.floor_groups).any(|&group| group as usize >= group_count) {
            return Err(numbers.wrong("has a group that does not exist"));
        }
        rules.push(rule);
        numbers.place += 1;
    }
    Ok(RuleTable::pack(rules))
}

fn sharings_to_bytes(sharings: &OverlapTable) -> Vec<u8> {
    let mut out = Vec::new();
    for sharing in 0..sharings.len() as u32 {
        write_number(sharings.count(sharing) as u32, &mut out);
        for share in sharings.shares(sharing) {
            let number = if share.link == Share::FULL { 0 } else { 1 + share.link * MAX_RUN + share.offset };
            write_number(number, &mut out);
        }
    }
    out
}

fn sharings_from_bytes(bytes: &[u8]) -> Result<OverlapTable, ModelError> {
    let mut numbers = Numbers { bytes, what: "sharing", place: 0 };
    let mut sharings = Vec::new();
    while !numbers.bytes.is_empty() {
        let count = numbers.count()?;
        let sharing: Vec<Share> = (0..count)
            .map(|_| {
                Ok(match numbers.next()?.checked_sub(1) {
                    None => Share { link: Share::FULL, offset: 0 },
                    Some(packed) => Share { link: packed / MAX_RUN, offset: packed % MAX_RUN },
                })
            })
            .collect::<Result<_, ModelError>>()?;
        // Links are numbered by first use, so there cannot be more links than triangles.
        if sharing.iter().any(|share| share.link != Share::FULL && share.link as usize >= count) {
            return Err(numbers.wrong("has more links than triangles"));
        }
        sharings.push(sharing);
        numbers.place += 1;
    }
    Ok(OverlapTable::pack(sharings))
}

/// Marks a local vertex that is not known yet.
pub(super) const UNKNOWN: u32 = NONE;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_with_many_vertices_and_no_triangles_take_no_memory() {
        let mut bytes = Vec::new();
        for _ in 0..1000 {
            [u32::MAX, u32::MAX, 0, 0].into_iter().for_each(|number| write_number(number, &mut bytes));
        }
        let rules = rules_from_bytes(&bytes, 1).unwrap();
        assert_eq!((rules.len(), rules.rule(999).extras().count()), (1000, 0));
        [u32::MAX - 1, u32::MAX, 0, 0].into_iter().for_each(|number| write_number(number, &mut bytes));
        assert!(rules_from_bytes(&bytes, 1).is_err(), "a vertex that nothing shows");
    }

    #[test]
    fn rules_and_sharings_must_refer_to_existing_elements() {
        let with_group = |group| rules_from_bytes(&[1, 3, 1, 0, 0, 1, 2, group], 2);
        assert_eq!(with_group(1).map(|rules| rules.len()), Ok(1));
        assert!(with_group(2).is_err(), "no such group");
        let with_corner = |corner| rules_from_bytes(&[1, 3, 1, 0, 0, 1, corner], 1);
        assert!(with_corner(2).is_ok() && with_corner(3).is_err(), "no such corner");
        let with_link = |link: u8| sharings_from_bytes(&[2, 0, 1 + 16 * link]);
        assert_eq!(with_link(1).map(|sharings| sharings.link_count(0)), Ok(2));
        assert!(with_link(2).is_err(), "more links than triangles");
        assert!(Extras::from_pairs(&[[4, 9], [4, 3], [6, 0]]).is_ok());
        assert!(Extras::from_pairs(&[[4, 9], [6, 0], [4, 3]]).is_err(), "out of order");
    }

    #[test]
    fn varints_must_end_within_32_bits() {
        let read = |bytes: &[u8]| Numbers { bytes, what: "rule", place: 0 }.next();
        assert_eq!(read(&[0xff, 0xff, 0xff, 0xff, 0x0f]), Ok(u32::MAX));
        assert!(read(&[0xff, 0xff, 0xff, 0xff, 0x1f]).is_err());
        assert!(read(&[0x80; 9]).is_err());
        assert!(read(&[]).is_err());
    }
}
