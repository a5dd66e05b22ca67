//! Table of the strip of every triangle and its index within that strip.

use striata::strip::StripLinks;

use super::trace::{StripLocations, TunnelStep};

/// Strip of every triangle, and its index within that strip.
#[derive(Debug)]
pub(crate) struct LocationTable {
    /// For each triangle: strip id, and index within the strip.
    locations: Vec<(u32, u32)>,
    /// Next unused strip id; strips get new ids when they change.
    next_strip: u32,
}

impl StripLocations for LocationTable {
    #[inline]
    fn strip(&self, triangle: u32) -> u32 {
        self.locations[triangle as usize].0
    }

    #[inline]
    fn index(&self, triangle: u32) -> u32 {
        self.locations[triangle as usize].1
    }
}

impl LocationTable {
    /// Numbers all strips, which must not contain loops.
    pub(crate) fn new(links: &StripLinks<'_>) -> Self {
        let mut table = Self { locations: vec![(u32::MAX, 0); links.triangle_count()], next_strip: 0 };
        for end in 0..links.triangle_count() as u32 {
            if links.solid_degree(end) < 2 && table.strip(end) == u32::MAX {
                table.number_strip(end, links);
            }
        }
        table
    }

    /// Renumbers the strips that a tunnel has changed, after it was applied.
    pub(crate) fn renumber(&mut self, steps: &[TunnelStep], last: Option<u32>, links: &StripLinks<'_>) {
        let first_new = self.next_strip;
        let last = last.map(|side| side / 3);
        let changed = steps.iter().flat_map(|step| [step.taken, step.end]).chain(last);
        for triangle in changed {
            if self.strip(triangle) < first_new {
                let end = links.first_solid(triangle).map_or(triangle, |side| links.end_beyond(side));
                self.number_strip(end, links);
            }
        }
    }

    /// Numbers one strip from this end.
    fn number_strip(&mut self, end: u32, links: &StripLinks<'_>) {
        let strip = self.next_strip;
        self.next_strip += 1;
        let mut index = 0;
        self.locations[end as usize] = (strip, index);
        let mut exit = links.first_solid(end);
        while let Some(side) = exit {
            let entered = links.twins()[side as usize];
            index += 1;
            self.locations[entered as usize / 3] = (strip, index);
            exit = links.other_solid(entered);
        }
    }
}
