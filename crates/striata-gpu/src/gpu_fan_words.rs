//! The table of fans in words, as a shader reads it.
//!
//! A fan is four words that all threads read side by side, and a run of words that only those read whose fan may be there:
//!
//! ```text
//! fan     vertex | where its words begin | kinds | 1 + its own step, 0 in the base
//! kinds   bits 0..6 nodes, bit 6 closed, bit 7 wide makers, bit 8 some arcs last, from bit 9 on makers
//! words   the nodes; the arcs that last, if any do; of each maker: (step - own) << 8 | arcs, or step and arcs where wide
//! ```
//!
//! A fan of up to 8 arcs whose makers are fewer than 2^24 steps later has narrow makers: all of most meshes but a few. The
//! table in bytes is half as large, and made for a processor that reads one byte after the other.
//!
//! Fans stand group by group, in the order of the table; a block is up to 256 of one group, which is what a workgroup takes.

use std::ops::Range;

use striata::model::Fans;
use striata::model::fans::TableFan;

/// Fans that a workgroup takes.
pub(crate) const BLOCK: usize = 256;

const CLOSED: u32 = 1 << 6;
const WIDE: u32 = 1 << 7;
const LASTING: u32 = 1 << 8;
const MAKERS: u32 = 9;

/// The table of fans in words; see the [module](self).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct FanWords {
    /// Four words a fan.
    pub(crate) fans: Vec<[u32; 4]>,
    pub(crate) words: Vec<u32>,
    /// First fan and number of fans.
    pub(crate) blocks: Vec<[u32; 2]>,
    /// First block of each group, and one more.
    pub(crate) group_blocks: Vec<u32>,
}

impl FanWords {
    pub(crate) fn new(fans: &Fans) -> Self {
        let mut counts = vec![0u32; fans.group_count()];
        fans.table_fans().for_each(|fan| counts[fan.group() as usize] += 1);
        let mut out = Self { group_blocks: vec![0], ..Self::default() };
        let mut places = Vec::with_capacity(counts.len());
        let mut first = 0;
        for &count in &counts {
            places.push(first);
            out.push_blocks(first..first + count);
            first += count;
        }
        out.fans = vec![[0; 4]; first as usize];
        for fan in fans.table_fans() {
            let place = &mut places[fan.group() as usize];
            out.fans[*place as usize] = out.push_words(&fan);
            *place += 1;
        }
        out
    }

    /// Bytes of all.
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

    /// Appends the words of a fan; what its four words are.
    fn push_words(&mut self, fan: &TableFan<'_>) -> [u32; 4] {
        let first = self.words.len() as u32;
        self.words.extend(fan.nodes());
        let node_count = fan.node_count() as u32;
        let own = fan.own_step().map_or(0, |step| step + 1);
        let mut kinds = node_count;
        if fan.is_closed() {
            kinds |= CLOSED;
        }
        if fan.lasting_arcs() != 0 {
            kinds |= LASTING;
            self.words.push(fan.lasting_arcs());
        }
        let is_wide = fan.makers().any(|m| m.arcs > 0xff || m.step - own >= 1 << 24);
        for maker in fan.makers() {
            kinds += 1 << MAKERS;
            if is_wide {
                self.words.extend([maker.step, maker.arcs]);
            } else {
                self.words.push((maker.step - own) << 8 | maker.arcs);
            }
        }
        [fan.vertex(), first, kinds | if is_wide { WIDE } else { 0 }, own]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::shapes;
    use striata::simplify::build_sequence;

    #[test]
    fn blocks_hold_every_fan_once_and_no_group_shares_one() {
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
    fn words_say_what_the_table_says() {
        for mesh in [shapes::uv_cylinder(300, 3), shapes::icosphere(3, 1.0), shapes::terrain(12, 3)] {
            let built = build_sequence(&mesh, &Default::default()).unwrap();
            let fans = Fans::build(&built.refinable);
            let words = FanWords::new(&fans);
            assert_eq!(words.fans.len(), fans.table_fans().count());
            for (&[vertex, first, kinds, own], fan) in words.fans.iter().zip(fans.table_fans()) {
                assert_eq!((vertex, own), (fan.vertex(), fan.own_step().map_or(0, |step| step + 1)));
                let mut rest = words.words[first as usize..].iter().copied();
                let nodes: Vec<u32> = rest.by_ref().take((kinds & 63) as usize).collect();
                assert_eq!(nodes, fan.nodes().collect::<Vec<_>>());
                assert_eq!(kinds & CLOSED != 0, fan.is_closed());
                let lasting = if kinds & LASTING != 0 { rest.next().unwrap() } else { 0 };
                assert_eq!(lasting, fan.lasting_arcs());
                assert_eq!((kinds >> MAKERS) as usize, fan.makers().count());
                for maker in fan.makers() {
                    let word = rest.next().unwrap();
                    if kinds & WIDE != 0 {
                        assert_eq!([word, rest.next().unwrap()], [maker.step, maker.arcs]);
                    } else {
                        assert_eq!([(word >> 8) + own, word & 255], [maker.step, maker.arcs]);
                    }
                }
            }
        }
    }
}
