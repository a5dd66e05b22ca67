//! Packs the table of fans into 32-bit words, as the shaders read it.
//!
//! Each fan has four header words, which all threads read coalesced, and a run of words that is read only
//! for fans that may be active. The makers of a fan are the steps that create some of its arcs:
//!
//! ```text
//! header  vertex | index of its first word | flags | 1 + its own step, 0 in the base
//! flags   bits 0..6 node count, bit 6 closed, bit 7 wide makers, bit 8 has permanent arcs,
//!         bits 9.. maker count
//! words   the nodes; the permanent arcs, if any; then per maker: (step - own) << 8 | arcs,
//!         or if wide: step, arcs
//! ```
//!
//! Makers are narrow (one word) if the fan has at most 8 arcs and they are fewer than 2^24 steps later,
//! which is true of almost every fan. The byte-coded table in [`Fans`] is half as large, but has to be read
//! sequentially by a CPU.
//!
//! Fans are sorted by group, in table order within a group. A block is up to 256 fans of one group, the
//! work of one workgroup.

use std::ops::Range;

use striata::model::Fans;
use striata::model::fans::TableFan;

/// Maximum number of fans in a block, which one workgroup processes.
pub(crate) const BLOCK: usize = 256;

const CLOSED: u32 = 1 << 6;
const WIDE: u32 = 1 << 7;
const PERMANENT: u32 = 1 << 8;
const MAKERS: u32 = 9;

/// Table of fans as words; see the [module](self) for the layout.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct FanWords {
    /// Header of each fan.
    pub fans: Vec<[u32; 4]>,
    pub words: Vec<u32>,
    /// First fan and fan count of each block.
    pub blocks: Vec<[u32; 2]>,
    /// First block of each group, followed by the block count.
    pub group_blocks: Vec<u32>,
}

impl FanWords {
    pub(crate) fn new(fans: &Fans) -> Self {
        let mut counts = vec![0u32; fans.group_count()];
        fans.table_fans().for_each(|fan| counts[fan.group() as usize] += 1);
        let mut out = Self { group_blocks: vec![0], ..Self::default() };
        let mut next_slots = Vec::with_capacity(counts.len());
        let mut first = 0;
        for &count in &counts {
            next_slots.push(first);
            out.push_blocks(first..first + count);
            first += count;
        }
        out.fans = vec![[0; 4]; first as usize];
        for fan in fans.table_fans() {
            let slot = &mut next_slots[fan.group() as usize];
            out.fans[*slot as usize] = out.push_words(&fan);
            *slot += 1;
        }
        out
    }

    /// Appends the fans and blocks of another mesh; groups are not kept apart.
    pub(crate) fn append(&mut self, other: Self) {
        let [first_fan, first_word] = [self.fans.len(), self.words.len()].map(|count| count as u32);
        self.fans.extend(other.fans.iter().map(|&[v, word, flags, own]| [v, word + first_word, flags, own]));
        self.blocks.extend(other.blocks.iter().map(|&[fan, count]| [fan + first_fan, count]));
        self.words.extend(other.words);
    }

    /// Size of all tables, bytes.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(&self.fans[..])
            + size_of_val(&self.words[..])
            + size_of_val(&self.blocks[..])
            + size_of_val(&self.group_blocks[..])
    }

    fn push_blocks(&mut self, group: Range<u32>) {
        let end = group.end;
        self.blocks.extend(group.step_by(BLOCK).map(|first| [first, (end - first).min(BLOCK as u32)]));
        self.group_blocks.push(self.blocks.len() as u32);
    }

    /// Appends the words of a fan and returns its header.
    fn push_words(&mut self, fan: &TableFan<'_>) -> [u32; 4] {
        let first = self.words.len() as u32;
        self.words.extend(fan.nodes());
        let node_count = fan.node_count() as u32;
        let own = fan.own_step().map_or(0, |step| step + 1);
        let mut flags = node_count;
        if fan.is_closed() {
            flags |= CLOSED;
        }
        if fan.permanent_arcs() != 0 {
            flags |= PERMANENT;
            self.words.push(fan.permanent_arcs());
        }
        let is_wide = fan.makers().any(|m| m.arcs > 0xff || m.step - own >= 1 << 24);
        for maker in fan.makers() {
            flags += 1 << MAKERS;
            if is_wide {
                self.words.extend([maker.step, maker.arcs]);
            } else {
                self.words.push((maker.step - own) << 8 | maker.arcs);
            }
        }
        [fan.vertex(), first, flags | if is_wide { WIDE } else { 0 }, own]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::shapes;
    use striata::simplify::build_sequence;

    #[test]
    fn every_fan_is_in_exactly_one_block_of_its_group() {
        let mesh = shapes::two_material_sphere(24, 40);
        let built = build_sequence(&mesh, &Default::default()).unwrap();
        let fans = Fans::build(&built.refinable);
        let words = FanWords::new(&fans);
        assert_eq!(words.group_blocks.len(), 3);
        let covered: Vec<u32> =
            words.blocks.iter().flat_map(|&[first, count]| first..first + count).collect();
        assert_eq!(covered, (0..words.fans.len() as u32).collect::<Vec<_>>());
        let in_first: u32 = words.blocks[..words.group_blocks[1] as usize].iter().map(|b| b[1]).sum();
        let expected = fans.table_fans().filter(|fan| fan.group() == 0).count();
        assert_eq!(in_first as usize, expected);
    }

    #[test]
    fn words_decode_to_the_table() {
        for mesh in [shapes::uv_cylinder(300, 3), shapes::icosphere(3, 1.0), shapes::terrain(12, 3)] {
            let built = build_sequence(&mesh, &Default::default()).unwrap();
            let fans = Fans::build(&built.refinable);
            let words = FanWords::new(&fans);
            assert_eq!(words.fans.len(), fans.table_fans().count());
            for (&[vertex, first, flags, own], fan) in words.fans.iter().zip(fans.table_fans()) {
                assert_eq!((vertex, own), (fan.vertex(), fan.own_step().map_or(0, |step| step + 1)));
                let mut rest = words.words[first as usize..].iter().copied();
                let nodes: Vec<u32> = rest.by_ref().take((flags & 63) as usize).collect();
                assert_eq!(nodes, fan.nodes().collect::<Vec<_>>());
                assert_eq!(flags & CLOSED != 0, fan.is_closed());
                let lasting = if flags & PERMANENT != 0 { rest.next().unwrap() } else { 0 };
                assert_eq!(lasting, fan.permanent_arcs());
                assert_eq!((flags >> MAKERS) as usize, fan.makers().count());
                for maker in fan.makers() {
                    let word = rest.next().unwrap();
                    if flags & WIDE != 0 {
                        assert_eq!([word, rest.next().unwrap()], [maker.step, maker.arcs]);
                    } else {
                        assert_eq!([(word >> 8) + own, word & 255], [maker.step, maker.arcs]);
                    }
                }
            }
        }
    }
}
