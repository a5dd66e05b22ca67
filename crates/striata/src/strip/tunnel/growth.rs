//! The first tunnels, those of one link: strips grow at their ends before any search begins.
//!
//! Taking such tunnels at random leaves many triangles with no free neighbour, and only longer tunnels can mend that.
//! So a strip begins where fewest neighbours are free and goes on to the neighbour that has fewest left,
//! the rule of SGI's `tomesh` \[ESV96, 2\]; among equals chance decides. Linear in time.

use crate::mesh::{NO_TWIN, Random};
use crate::strip::links::{StripLinks, next};

/// Takes tunnels of length one until there is none.
pub(crate) fn join_ends(ends: &[u32], links: &mut StripLinks<'_>, random: &mut Random) {
    let mut growth = Growth::new(ends, links);
    let mut waiting: [Vec<u32>; 4] = Default::default();
    for &end in ends {
        waiting[growth.free_count(end, links)].push(end);
    }
    // The end that is most in danger of being left alone comes first; moved entries are found again lower down.
    while let Some(end) = waiting.iter_mut().find_map(Vec::pop) {
        if links.solid_degree(end) == 2 {
            continue;
        }
        let mut tip = end;
        while let Some(side) = growth.best_side(tip, links, random) {
            let taken = links.twins()[side as usize] / 3;
            growth.join(side, links);
            for triangle in [tip, taken] {
                for k in 3 * triangle..3 * triangle + 3 {
                    let twin = links.twins()[k as usize];
                    if twin != NO_TWIN && links.solid_degree(twin / 3) < 2 {
                        waiting[growth.free_count(twin / 3, links)].push(twin / 3);
                    }
                }
            }
            tip = taken;
        }
    }
}

/// Strips that know their ends.
struct Growth {
    /// For the end of a strip, its other end.
    other_end: Vec<u32>,
}

impl Growth {
    fn new(ends: &[u32], links: &StripLinks<'_>) -> Self {
        let mut other_end: Vec<u32> = (0..links.triangle_count() as u32).collect();
        for &end in ends {
            if let Some(side) = links.first_solid(end) {
                other_end[end as usize] = links.end_beyond(side);
            }
        }
        Self { other_end }
    }

    /// Whether the link across a side of an end is a tunnel of length one.
    fn is_tunnel(&self, side: u32, links: &StripLinks<'_>) -> bool {
        let twin = links.twins()[side as usize];
        twin != NO_TWIN && links.solid_degree(twin / 3) < 2 && self.other_end[side as usize / 3] != twin / 3
    }

    fn free_count(&self, end: u32, links: &StripLinks<'_>) -> usize {
        (3 * end..3 * end + 3).filter(|&side| self.is_tunnel(side, links)).count()
    }

    /// The tunnel from an end to the triangle with fewest ways on.
    fn best_side(&self, end: u32, links: &StripLinks<'_>, random: &mut Random) -> Option<u32> {
        if links.solid_degree(end) == 2 {
            return None;
        }
        let mut best: Option<(usize, u32)> = None;
        let mut side = 3 * end + random.below(3);
        for _ in 0..3 {
            if self.is_tunnel(side, links) {
                let count = self.free_count(links.twins()[side as usize] / 3, links);
                if best.is_none_or(|(least, _)| count < least) {
                    best = Some((count, side));
                }
            }
            side = next(side);
        }
        best.map(|(_, side)| side)
    }

    fn join(&mut self, side: u32, links: &mut StripLinks<'_>) {
        let ends = [side / 3, links.twins()[side as usize] / 3];
        let outer = ends.map(|end| self.other_end[end as usize]);
        links.join(side);
        self.other_end[outer[0] as usize] = outer[1];
        self.other_end[outer[1] as usize] = outer[0];
    }
}
