//! Decoder: arbitrary bytes yield either levels of a valid surface or an error.

use striata::mesh::{Face, Fragment, FragmentSequence, PositionIndex};
use striata::model::Bits;

use super::{
    ANCHOR_BITS, FRAGMENT_BITS, LONG_NEIGHBOR, LONG_NEIGHBOR_BITS, LONG_RULE, LONG_RULE_BITS, NEIGHBOR_BITS,
    OPENS_TWICE, OrderedNeighbors, RULE_BITS, SequentialPatternsError,
};
use crate::baseline::loop_patterns::{LoopRegion, LoopRule, LoopRuleTable, LoopSurface};

/// Decodes one fragment after another and keeps the level that they lead to.
#[derive(Debug)]
pub struct SequentialDecoder {
    base: Vec<[u32; 3]>,
    base_vertex_count: usize,
    step_count: usize,
    /// Number of fragments decoded.
    step: usize,
    rules: LoopRuleTable,
    bits: Bits,
    at: usize,
    surface: LoopSurface,
    neighbors: OrderedNeighbors,
    region: LoopRegion,
    sorted: Vec<u32>,
}

impl SequentialDecoder {
    /// Reads the base and the rules.
    ///
    /// # Errors
    /// [`SequentialPatternsError`] if they are invalid or the data is too short for the counts in its header.
    pub fn new(bytes: &[u8]) -> Result<Self, SequentialPatternsError> {
        let mut rest = bytes;
        let mut count = || -> Result<u64, SequentialPatternsError> {
            let head = rest.split_off(..4).ok_or(short("the counts", 16, bytes.len()))?;
            Ok(u64::from(u32::from_le_bytes(head.try_into().unwrap_or_default())))
        };
        let [vertices, triangles, steps, rules] = [count()?, count()?, count()?, count()?];
        check_bytes("the triangles of the base", 12 * triangles, rest)?;
        check_count("vertices of the base", vertices, 3 * triangles)?;
        check_count("rules", rules, 1 << LONG_RULE_BITS)?;
        let (base, mut rest) = rest.split_at(12 * triangles as usize);
        let word = |bytes: &[u8; 4]| u32::from_le_bytes(*bytes);
        let words: Vec<u32> = base.as_chunks().0.iter().map(word).collect();
        let base = words.as_chunks().0.to_vec();
        let surface = LoopSurface::new(&base, vertices as usize)
            .map_err(|(triangle, reason)| SequentialPatternsError::Base { triangle, reason })?;
        let rules = read_rules(rules as usize, &mut rest)?;
        check_bytes("the fragments", (steps * FRAGMENT_BITS as u64).div_ceil(8), rest)?;
        check_count("vertices", vertices + steps, u64::from(u32::MAX))?;
        let bits = Bits::from_bytes(rest, 8 * rest.len()).unwrap_or_default();
        Ok(Self {
            base,
            base_vertex_count: vertices as usize,
            step_count: steps as usize,
            step: 0,
            rules,
            bits,
            at: 0,
            surface,
            neighbors: OrderedNeighbors::default(),
            region: LoopRegion::default(),
            sorted: Vec::new(),
        })
    }

    /// Triangles of the base.
    pub fn base(&self) -> &[[u32; 3]] {
        &self.base
    }

    /// Total number of fragments.
    pub fn step_count(&self) -> usize {
        self.step_count
    }

    /// The triangles of the current level, unordered.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.surface.corners()
    }

    /// Decodes the next fragment; returns `None` after the last one.
    ///
    /// # Errors
    /// [`SequentialPatternsError`] with the step, if the fragment does not fit the previous level or the
    /// data ends.
    pub fn next_fragment(&mut self) -> Result<Option<Fragment>, SequentialPatternsError> {
        if self.step == self.step_count {
            return self.check_end().map(|()| None);
        }
        let step = self.step;
        let fragment = self.read().map_err(|reason| SequentialPatternsError::Step { step, reason })?;
        self.step += 1;
        Ok(Some(fragment))
    }

    /// Decodes all remaining fragments.
    ///
    /// # Errors
    /// See [`next_fragment`](Self::next_fragment).
    ///
    /// # Panics
    /// If a fragment has been decoded before.
    pub fn into_sequence(mut self) -> Result<FragmentSequence, SequentialPatternsError> {
        assert_eq!(self.step, 0, "fragments have been read already");
        let mut fragments = Vec::with_capacity(self.step_count);
        while let Some(fragment) = self.next_fragment()? {
            fragments.push(fragment);
        }
        let positions = PositionIndex::identity(self.base_vertex_count + self.step_count);
        let base = self.base.iter().map(face).collect();
        Ok(FragmentSequence::from_fragments(positions, base, fragments.into_iter())?)
    }

    fn check_end(&self) -> Result<(), SequentialPatternsError> {
        let bits = self.bits.len() - self.at;
        if bits >= 8 || self.bits.get(self.at, bits as u32) != 0 {
            return Err(SequentialPatternsError::Trailing { bits });
        }
        Ok(())
    }

    fn read(&mut self) -> Result<Fragment, &'static str> {
        let rule = self.read_value(LONG_RULE, [RULE_BITS, LONG_RULE_BITS])? as usize;
        let anchor = self.read_bits(ANCHOR_BITS)? as usize;
        let rank = self.read_value(LONG_NEIGHBOR, [NEIGHBOR_BITS, LONG_NEIGHBOR_BITS])? as usize;
        let vertex = self.base_vertex_count + self.step;
        if rule >= self.rules.len() {
            return Err("has an unknown rule");
        }
        if anchor >= vertex {
            return Err("has an anchor out of range");
        }
        self.neighbors.find(&self.surface, anchor as u32);
        if rank >= self.neighbors.count() {
            return Err("counts more neighbors than its anchor has");
        }
        let index = self.neighbors.index(rank);
        let rules = std::mem::take(&mut self.rules);
        let fragment = self.apply(rules.get(rule), anchor as u32, index);
        self.rules = rules;
        fragment
    }

    /// Applies the fragment with the given rule, whose second anchor is the neighbor at `index`.
    fn apply(&mut self, rule: LoopRule, anchor: u32, index: usize) -> Result<Fragment, &'static str> {
        if rule.apexes.is_empty() {
            let side = index.checked_sub(1).map(|before| self.neighbors.star[before]);
            let (on, _) =
                side.filter(|_| self.neighbors.side(index).is_none()).ok_or("is attached to no border")?;
            self.region.attach([anchor, self.neighbors.vertex(&self.surface, index)], on);
        } else {
            let side = self.neighbors.side(index).ok_or("has no triangle at its anchors")?;
            if !self.surface.find_floor(rule, side, &mut self.region) || !self.is_simple() {
                return Err("has a floor that does not match its anchors");
            }
            if rule.is_open && !self.surface.is_openable(&self.region, &mut self.neighbors.star) {
                return Err(OPENS_TWICE);
            }
        }
        let vertex = (self.base_vertex_count + self.step) as u32;
        let floor = self.surface.region_corners(&self.region).map(|corners| face(&corners)).collect();
        let ring = &self.region.ring;
        let ends = (0..rule.ceiling_len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]);
        let ceiling = ends.map(|[a, b]| face(&[vertex, a, b])).collect();
        self.surface.add_vertex();
        self.surface.replace_by_fan(vertex, rule, &mut self.region);
        Ok(Fragment { ceiling, floor, error: 0.0 })
    }

    /// Whether no vertex appears twice in the ring of the region.
    fn is_simple(&mut self) -> bool {
        self.sorted.clone_from(&self.region.ring);
        self.sorted.sort_unstable();
        self.sorted.windows(2).all(|pair| pair[0] != pair[1])
    }

    fn read_value(&mut self, long: u64, [width, long_width]: [u32; 2]) -> Result<u64, &'static str> {
        let value = self.read_bits(width)?;
        if value < long {
            return Ok(value);
        }
        let value = self.read_bits(long_width)?;
        if value < long { Err("has a short value in the long form") } else { Ok(value) }
    }

    fn read_bits(&mut self, width: u32) -> Result<u64, &'static str> {
        let end = self.at + width as usize;
        if end > self.bits.len() {
            return Err("is truncated");
        }
        let value = self.bits.get(self.at, width);
        self.at = end;
        Ok(value)
    }
}

fn face(corners: &[u32; 3]) -> Face {
    Face { corners: *corners, group: 0 }
}

fn short(what: &'static str, needed: u64, found: usize) -> SequentialPatternsError {
    SequentialPatternsError::Short { what, needed, found }
}

fn check_bytes(what: &'static str, needed: u64, rest: &[u8]) -> Result<(), SequentialPatternsError> {
    if needed > rest.len() as u64 { Err(short(what, needed, rest.len())) } else { Ok(()) }
}

fn check_count(what: &'static str, found: u64, limit: u64) -> Result<(), SequentialPatternsError> {
    if found > limit { Err(SequentialPatternsError::Count { what, found, limit }) } else { Ok(()) }
}

fn read_rules(count: usize, rest: &mut &[u8]) -> Result<LoopRuleTable, SequentialPatternsError> {
    check_bytes("the rules", 2 * count as u64, rest)?;
    let mut codes = Vec::with_capacity(count);
    for rule in 0..count {
        let refused = |reason| SequentialPatternsError::Rule { rule, reason };
        let &[ring_len, is_open] =
            rest.split_off(..2).and_then(|head| head.as_array()).ok_or(short("a rule", 2, 0))?;
        let apex_count =
            usize::from(ring_len).checked_sub(2).ok_or(refused("has a ring of fewer than two corners"))?;
        check_bytes("the floor of a rule", apex_count as u64, rest)?;
        let (apexes, behind) = rest.split_at(apex_count);
        *rest = behind;
        match is_open {
            0 if apex_count == 0 => return Err(refused("has a closed ring of two corners")),
            0 | 1 => {}
            _ => return Err(refused("has a ring that is neither open nor closed")),
        }
        let code = [&[is_open], apexes].concat();
        if !LoopRule::of_code(&code).is_tree() {
            return Err(refused("has a floor that does not fill its ring"));
        }
        codes.push(code);
    }
    Ok(LoopRuleTable::of(codes.iter().map(|code| &code[..])))
}
