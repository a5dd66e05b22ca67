//! Converts patterns to and from the arrays of the file format.
//!
//! Rules and sharings are stored as varints of 7 bits per byte. A stored model is validated by one walk
//! over its fragments (`walk.rs`); afterward it is valid for every set of fragments.

use super::bounds::{BoundScale, PackedBounds};
use super::kinds::KindTable;
use super::overlaps::{CeilingShare, MAX_RUN, OverlapTable, OverlapTableBuilder};
use super::records::{RecordLayout, Records};
use super::rule::Rule;
use super::rule_table::RuleTable;
use super::walk::FragmentWalk;
use super::{BaseFace, Patterns};
use crate::model::bits::Bits;
use crate::model::{ModelError, StepVertices};

/// Number of numbers in the header.
pub(crate) const HEADER_LEN: usize = 10;

/// The stored arrays of patterns.
#[derive(Clone, Debug)]
pub(crate) struct PatternsParts<'a> {
    /// Number of kinds; low bits of a kind; half-edges of the largest floor; 1 if counts of links
    /// down take 4 bits, plus 2 if there are errors of overlaps; bits of all records (low word, high word); scale of
    /// errors of overlaps; scales of radii and errors of bounds; 0.
    pub header: [u32; HEADER_LEN],
    pub rules: Vec<u8>,
    pub sharings: Vec<u8>,
    pub kinds: &'a [u8],
    pub blocks: &'a [u32],
    pub records: &'a [u8],
    /// Corners, group, step above, code of the corner in its floor, and packed error, for each base
    /// triangle.
    pub base: Vec<[u32; 7]>,
    pub bounds: &'a [u8],
}

impl Patterns {
    pub(crate) fn parts(&self) -> PatternsParts<'_> {
        let (blocks, bits) = self.records.parts();
        let length = bits.len() as u64;
        let layout = self.records.layout();
        let flags = u32::from(layout.has_wide_counts) | u32::from(layout.has_errors) << 1;
        let [radius_base, error_base] = self.bounds.as_ref().map_or([0; 2], PackedBounds::bases);
        PatternsParts {
            header: [
                layout.kind_count,
                layout.short_kind_bits,
                layout.half_edge_count,
                flags,
                length as u32,
                (length >> 32) as u32,
                self.overlap_errors.map_or(0, BoundScale::base),
                radius_base,
                error_base,
                0,
            ],
            rules: rules_to_bytes(&self.rules),
            sharings: sharings_to_bytes(&self.sharings),
            kinds: self.kinds.as_bytes(),
            blocks,
            records: bits.as_bytes(),
            base: self
                .base
                .iter()
                .map(|face| {
                    let [a, b, c] = face.corners;
                    [a, b, c, face.group, face.above, face.code, face.error]
                })
                .collect(),
            bounds: self.bounds.as_ref().map_or(&[], PackedBounds::as_bytes),
        }
    }

    /// Assembles patterns with bounds from stored arrays and validates them, so that no later move can fail
    /// in any valid set: every floor receives all its triangles, these agree on its vertices and groups, no
    /// triangle is degenerate, and links down lead to the steps that create the floor.
    ///
    /// # Errors
    /// [`ModelError`] naming the first mismatch.
    pub(crate) fn from_parts(
        vertices: StepVertices<'_>,
        group_count: usize,
        triangle_count: usize,
        parts: PatternsParts<'_>,
    ) -> Result<Self, ModelError> {
        for (what, bytes) in [("bytes of rules", &parts.rules), ("bytes of sharings", &parts.sharings)] {
            let (found, limit) = (bytes.len() as u64, MAX_TABLE_BYTES);
            if found > limit {
                return Err(ModelError::TooMany { what, found, limit });
            }
        }
        let step_count = vertices.step_count();
        vertices.check_firsts(step_count)?;
        let vertices = vertices.without_targets().shortened();
        let [kind_count, short_kind_bits, half_edge_count, flags, low, high, error_base, rest @ ..] =
            parts.header;
        let [radius_base, bounds_error_base, reserved] = rest;
        if flags > 3 || reserved != 0 {
            let reason = "has flags that are not known";
            return Err(ModelError::Listed { what: "header", place: 3, reason });
        }
        let rules = rules_from_bytes(&parts.rules, group_count)?;
        let sharings = sharings_from_bytes(&parts.sharings)?;
        let kinds = KindTable::from_bytes(parts.kinds, kind_count, step_count, &rules, &sharings)?;
        let length = u64::from(low) | u64::from(high) << 32;
        let bits = usize::try_from(length).ok().and_then(|length| Bits::from_bytes(parts.records, length));
        let expected = parts.records.len().saturating_mul(8);
        let wrong = ModelError::Length { what: "bits of records", found: length as usize, expected };
        let (has_wide_counts, has_errors) = (flags & 1 != 0, flags & 2 != 0);
        let layout =
            RecordLayout { kind_count, short_kind_bits, half_edge_count, has_errors, has_wide_counts };
        let records = Records::from_parts(step_count, layout, parts.blocks.to_vec(), bits.ok_or(wrong)?)?;
        let scale = BoundScale::of_stored_errors(error_base).filter(|_| has_errors || error_base == 0);
        let reason = "exceeds the largest number";
        let scale = scale.ok_or(ModelError::Listed { what: "scale of errors", place: 0, reason })?;
        let mut patterns = Self {
            vertices,
            group_count,
            base: parts.base.iter().map(base_face).collect(),
            floorless: Vec::new(),
            rules,
            sharings,
            kinds,
            records,
            overlap_errors: has_errors.then_some(scale),
            bounds: None,
        };
        patterns.check_base_errors()?;
        let walk = FragmentWalk::new(&patterns)?;
        patterns.check_ceilings(walk.ceiling_count())?;
        let (found, expected) = (walk.full_count() as usize, triangle_count);
        if found != expected {
            return Err(ModelError::Length { what: "triangles of the full mesh", found, expected });
        }
        let floorless = walk.floorless();
        walk.check()?;
        patterns.floorless = floorless;
        let bounds = PackedBounds::from_bytes(parts.bounds, [radius_base, bounds_error_base], step_count)?;
        Ok(Self { bounds: Some(bounds), ..patterns })
    }

    /// Checks that errors of overlaps in the base exist only if the model has such errors.
    fn check_base_errors(&self) -> Result<(), ModelError> {
        let limit = if self.overlap_errors.is_some() { u32::from(u8::MAX) } else { 0 };
        match self.base.iter().position(|face| face.error > limit) {
            None => Ok(()),
            Some(place) => {
                let reason = "has an error that cannot be";
                Err(ModelError::Listed { what: "triangle of the base", place, reason })
            }
        }
    }

    /// Number of steps that have bounds.
    pub(crate) fn bounded_step_count(&self) -> usize {
        self.bounds.as_ref().map_or(0, |bounds| bounds.as_bytes().len() / 3)
    }
}

fn base_face(&[a, b, c, group, above, code, error]: &[u32; 7]) -> BaseFace {
    BaseFace { corners: [a, b, c], group, above, code, error }
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
        let counts = self.kind_counts();
        let mut found = 0;
        self.records.for_each_head(|_, head| found += u64::from(counts[head.kind as usize][0]));
        self.check_ceilings(found)
    }

    fn check_ceilings(&self, found: u64) -> Result<(), ModelError> {
        let (_, bits) = self.records.parts();
        let limit = bits.len() as u64 + MAX_UNLINKED * self.vertices.vertex_count as u64;
        if found > limit { Err(ModelError::Dense { found, limit }) } else { Ok(()) }
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
        let shares = sharings.shares(sharing);
        write_number(shares.len() as u32, &mut out);
        for share in shares {
            let number =
                if share.link == CeilingShare::FULL { 0 } else { 1 + share.link * MAX_RUN + share.offset };
            write_number(number, &mut out);
        }
    }
    out
}

fn sharings_from_bytes(bytes: &[u8]) -> Result<OverlapTable, ModelError> {
    let mut numbers = Numbers { bytes, what: "sharing", place: 0 };
    let mut sharings = OverlapTableBuilder::default();
    while !numbers.bytes.is_empty() {
        let count = numbers.count()?;
        let sharing: Vec<CeilingShare> = (0..count)
            .map(|_| {
                Ok(match numbers.next()?.checked_sub(1) {
                    None => CeilingShare { link: CeilingShare::FULL, offset: 0 },
                    Some(packed) => CeilingShare { link: packed / MAX_RUN, offset: packed % MAX_RUN },
                })
            })
            .collect::<Result<_, ModelError>>()?;
        // Links are numbered by first use, so there cannot be more links than triangles.
        if sharing.iter().any(|share| share.link != CeilingShare::FULL && share.link as usize >= count) {
            return Err(numbers.wrong("has more links than triangles"));
        }
        if !sharings.push_next(&sharing) {
            return Err(numbers.wrong("is listed twice, or after one of a larger class"));
        }
        numbers.place += 1;
    }
    Ok(sharings.into_table())
}

#[cfg(test)]
mod tests {
    use super::super::rule_table::of_rule;
    use super::*;

    #[test]
    fn rules_with_many_vertices_and_no_triangles_take_no_memory() {
        let mut bytes = Vec::new();
        for _ in 0..1000 {
            [u32::MAX, u32::MAX, 0, 0].into_iter().for_each(|number| write_number(number, &mut bytes));
        }
        let rules = rules_from_bytes(&bytes, 1).unwrap();
        let extra_count = of_rule!(rules.rule(999), rule => rule.extra_count());
        assert_eq!((rules.len(), extra_count), (1000, 0));
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
        assert_eq!(with_link(1).map(|sharings| sharings.len()), Ok(1));
        assert!(with_link(2).is_err(), "more links than triangles");
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
