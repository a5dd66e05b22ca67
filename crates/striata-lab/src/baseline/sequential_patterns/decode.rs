//! Reading: whatever the bytes are, what comes out are levels of a surface or an error.

use striata::mesh::{Face, Fragment, FragmentSequence, PositionIndex};
use striata::model::Bits;

use super::{
    ANCHOR_BITS, FRAGMENT_BITS, LONG_NEIGHBOR, LONG_NEIGHBOR_BITS, LONG_RULE, LONG_RULE_BITS, NEIGHBOR_BITS,
    Neighbors, OPENS_TWICE, RULE_BITS, SequentialPatternsError,
};
use crate::baseline::loop_patterns::{Found, Rule, RuleTable, Surface};

/// Reads fragments one after the other and keeps the level that they lead to.
#[derive(Debug)]
pub struct SequentialDecoder {
    base: Vec<[u32; 3]>,
    base_vertex_count: usize,
    step_count: usize,
    /// Fragments that have been read.
    step: usize,
    rules: RuleTable,
    bits: Bits,
    at: usize,
    surface: Surface,
    around: Neighbors,
    found: Found,
    sorted: Vec<u32>,
}

impl SequentialDecoder {
    /// Reads the base and the rules.
    ///
    /// # Errors
    /// [`SequentialPatternsError`] where they make no sense or the bytes are too few for what they promise.
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
        let surface = Surface::new(&base, vertices as usize)
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
            around: Neighbors::default(),
            found: Found::default(),
            sorted: Vec::new(),
        })
    }

    /// Triangles of the base.
    pub fn base(&self) -> &[[u32; 3]] {
        &self.base
    }

    /// Fragments in all.
    pub fn step_count(&self) -> usize {
        self.step_count
    }

    /// The triangles of the level that has been read, in no order.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.surface.corners()
    }

    /// Reads the next fragment; none after the last.
    ///
    /// # Errors
    /// [`SequentialPatternsError`] naming the step, where it has no place in the level before it or the bytes end.
    pub fn next_fragment(&mut self) -> Result<Option<Fragment>, SequentialPatternsError> {
        if self.step == self.step_count {
            return self.check_end().map(|()| None);
        }
        let step = self.step;
        let fragment = self.read().map_err(|reason| SequentialPatternsError::Step { step, reason })?;
        self.step += 1;
        Ok(Some(fragment))
    }

    /// Reads all fragments that are left.
    ///
    /// # Errors
    /// As [`next_fragment`](Self::next_fragment).
    ///
    /// # Panics
    /// If some have been read already.
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
        let rule = self.read_number(LONG_RULE, [RULE_BITS, LONG_RULE_BITS])? as usize;
        let anchor = self.read_bits(ANCHOR_BITS)? as usize;
        let counted = self.read_number(LONG_NEIGHBOR, [NEIGHBOR_BITS, LONG_NEIGHBOR_BITS])? as usize;
        let vertex = self.base_vertex_count + self.step;
        if rule >= self.rules.len() {
            return Err("has a rule that is not there");
        }
        if anchor >= vertex {
            return Err("has an anchor that is not there");
        }
        self.around.find(&self.surface, anchor as u32);
        if counted >= self.around.count() {
            return Err("counts more neighbors than its anchor has");
        }
        let place = self.around.place(counted);
        let rules = std::mem::take(&mut self.rules);
        let fragment = self.place(rules.get(rule), anchor as u32, place);
        self.rules = rules;
        fragment
    }

    /// Puts the fragment with a rule where its second anchor is the neighbor at a place.
    fn place(&mut self, rule: Rule, anchor: u32, place: usize) -> Result<Fragment, &'static str> {
        if rule.apexes.is_empty() {
            let side = place.checked_sub(1).map(|before| self.around.star[before]);
            let (on, _) = side.filter(|_| self.around.side(place).is_none()).ok_or("hangs on no border")?;
            self.found.hang([anchor, self.around.vertex(&self.surface, place)], on);
        } else {
            let side = self.around.side(place).ok_or("has its anchors where no triangle is")?;
            if !self.surface.find_floor(rule, side, &mut self.found) || !self.is_simple() {
                return Err("has a floor that is not where its anchors are");
            }
            if rule.is_open && !self.surface.is_openable(&self.found, &mut self.around.star) {
                return Err(OPENS_TWICE);
            }
        }
        let vertex = (self.base_vertex_count + self.step) as u32;
        let floor = self.surface.found_corners(&self.found).map(|corners| face(&corners)).collect();
        let ring = &self.found.ring;
        let ends = (0..rule.ceiling_len()).map(|i| [ring[i], ring[(i + 1) % ring.len()]]);
        let ceiling = ends.map(|[a, b]| face(&[vertex, a, b])).collect();
        self.surface.add_vertex();
        self.surface.put_fan(vertex, rule, &mut self.found);
        Ok(Fragment { ceiling, floor, error: 0.0 })
    }

    /// Whether no vertex is twice in the ring that was found.
    fn is_simple(&mut self) -> bool {
        self.sorted.clone_from(&self.found.ring);
        self.sorted.sort_unstable();
        self.sorted.windows(2).all(|pair| pair[0] != pair[1])
    }

    fn read_number(&mut self, long: u64, [width, long_width]: [u32; 2]) -> Result<u64, &'static str> {
        let number = self.read_bits(width)?;
        if number < long {
            return Ok(number);
        }
        let number = self.read_bits(long_width)?;
        if number < long { Err("has a short number in the long form") } else { Ok(number) }
    }

    fn read_bits(&mut self, width: u32) -> Result<u64, &'static str> {
        let end = self.at + width as usize;
        if end > self.bits.len() {
            return Err("is cut off by the end of the bytes");
        }
        let number = self.bits.get(self.at, width);
        self.at = end;
        Ok(number)
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

fn read_rules(count: usize, rest: &mut &[u8]) -> Result<RuleTable, SequentialPatternsError> {
    check_bytes("the rules", 2 * count as u64, rest)?;
    let mut codes = Vec::with_capacity(count);
    for rule in 0..count {
        let refused = |reason| SequentialPatternsError::Rule { rule, reason };
        let &[ring_len, is_open] =
            rest.split_off(..2).and_then(|head| head.as_array()).ok_or(short("a rule", 2, 0))?;
        let apex_count =
            usize::from(ring_len).checked_sub(2).ok_or(refused("has a ring of less than two corners"))?;
        check_bytes("the floor of a rule", apex_count as u64, rest)?;
        let (apexes, behind) = rest.split_at(apex_count);
        *rest = behind;
        match is_open {
            0 if apex_count == 0 => return Err(refused("has a closed ring of two corners")),
            0 | 1 => {}
            _ => return Err(refused("has a ring that is neither open nor closed")),
        }
        let code = [&[is_open], apexes].concat();
        if !Rule::of_code(&code).is_tree() {
            return Err(refused("has a floor that does not fill its ring"));
        }
        codes.push(code);
    }
    Ok(RuleTable::of(codes.iter().map(|code| &code[..])))
}
