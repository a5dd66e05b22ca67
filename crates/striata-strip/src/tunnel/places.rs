//! The strip and place of every triangle, kept in two arrays.

use striata::strip::StripLinks;

use super::trace::{Places, Step};

/// The strip and place of every triangle.
#[derive(Debug)]
pub(crate) struct PlaceTable {
    /// Strip and place.
    places: Vec<(u32, u32)>,
    /// The next strip's number: strips are numbered anew when they change.
    next_strip: u32,
}

impl Places for PlaceTable {
    #[inline]
    fn strip(&self, triangle: u32) -> u32 {
        self.places[triangle as usize].0
    }

    #[inline]
    fn place(&self, triangle: u32) -> u32 {
        self.places[triangle as usize].1
    }
}

impl PlaceTable {
    /// Numbers all strips; no loops, please.
    pub(crate) fn new(links: &StripLinks<'_>) -> Self {
        let mut table = Self { places: vec![(u32::MAX, 0); links.triangle_count()], next_strip: 0 };
        for end in 0..links.triangle_count() as u32 {
            if links.solid_degree(end) < 2 && table.strip(end) == u32::MAX {
                table.number(end, links);
            }
        }
        table
    }

    /// Numbers the strips that a tunnel has changed, after it was complemented.
    pub(crate) fn renumber(&mut self, steps: &[Step], last: Option<u32>, links: &StripLinks<'_>) {
        let first_new = self.next_strip;
        let last = last.map(|side| side / 3);
        let changed = steps.iter().flat_map(|step| [step.taken, step.end]).chain(last);
        for triangle in changed {
            if self.strip(triangle) < first_new {
                let end = links.first_solid(triangle).map_or(triangle, |side| links.end_beyond(side));
                self.number(end, links);
            }
        }
    }

    /// Numbers one strip from this end.
    fn number(&mut self, end: u32, links: &StripLinks<'_>) {
        let strip = self.next_strip;
        self.next_strip += 1;
        let mut place = 0;
        self.places[end as usize] = (strip, place);
        let mut exit = links.first_solid(end);
        while let Some(side) = exit {
            let entered = links.twins()[side as usize];
            place += 1;
            self.places[entered as usize / 3] = (strip, place);
            exit = links.other_solid(entered);
        }
    }
}
