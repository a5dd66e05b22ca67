//! Vertices of each position, in the order in which they are met.

const NONE: u32 = u32::MAX;

/// Vertices of positions.
#[derive(Debug, Default)]
pub(super) struct PageWedges {
    /// Last vertex of each position.
    last: Vec<u32>,
    /// Number of vertices of each position.
    counts: Vec<u32>,
    /// The vertex of the same position that was met before each vertex, or [`NONE`].
    before: Vec<u32>,
}

impl PageWedges {
    /// Number of positions.
    pub(super) fn position_count(&self) -> usize {
        self.last.len()
    }

    /// Whether every position has one vertex, and is numbered like it.
    pub(super) fn is_trivial(&self) -> bool {
        self.last.len() == self.before.len()
    }

    /// Adds a position without vertices.
    pub(super) fn add_position(&mut self) {
        self.last.push(NONE);
        self.counts.push(0);
    }

    /// Adds the next vertex, to a position.
    pub(super) fn add_vertex(&mut self, position: u32) {
        let vertex = self.before.len() as u32;
        self.before.push(std::mem::replace(&mut self.last[position as usize], vertex));
        self.counts[position as usize] += 1;
    }

    /// Number of vertices of a position.
    pub(super) fn count(&self, position: u32) -> u32 {
        self.counts[position as usize]
    }

    /// Vertices of a position, the last one first.
    pub(super) fn latest_first(&self, position: u32) -> impl Iterator<Item = u32> + '_ {
        let found = |v: u32| (v != NONE).then_some(v);
        std::iter::successors(found(self.last[position as usize]), move |&v| found(self.before[v as usize]))
    }

    /// Vertices of a position, the first one first, in a buffer.
    pub(super) fn of(&self, position: u32, buffer: &mut Vec<u32>) {
        buffer.clear();
        if self.is_trivial() {
            buffer.push(position);
            return;
        }
        buffer.extend(self.latest_first(position));
        buffer.reverse();
    }
}
