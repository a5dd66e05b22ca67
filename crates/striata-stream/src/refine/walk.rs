//! The order in which both sides of a stream ask the vertices of a surface whether they split.
//!
//! | order | who comes next |
//! | --- | --- |
//! | [`WalkOrder::Near`] | breadth first: a neighbor of one that was asked |
//! | [`WalkOrder::Numbers`] | the next number |
//! | [`WalkOrder::Families`] | a vertex, then the vertex that was split off it last, then older ones, each with its own |
//!
//! Vertices made within the batch are passed over. A vertex is asked once a batch. Breadth first, its neighbors wait in a
//! queue; since a vertex's own split happens after it was asked, all that was around it before the batch is found, whatever
//! has been split elsewhere. The other two orders are lists, and nobody has to walk around a vertex that does not split.
//!
//! Vertices that were split off each other lie close together, so the order of families moves over the surface bit by bit. And
//! what a batch makes is numbered in the order of the walk, so that a walk runs through each batch's part of memory from its
//! beginning to its end. Walking by numbers does neither: vertices with consecutive numbers lie wherever a batch had
//! room for a split, which costs half as much time again where a mesh does not fit into the caches.

use crate::topology::surface::{NONE, Surface, next};

/// What has become of a vertex in the current batch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fate {
    /// Not asked yet.
    Open,
    /// Asked; it does not split.
    Stays,
    /// Asked; it splits.
    Splits,
    /// Made in this batch.
    New,
}

/// Which vertex is asked next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum WalkOrder {
    /// A neighbor of one that was asked.
    Near,
    /// The next number.
    Numbers,
    /// One that was split off the last one, or the next one that was there before.
    #[default]
    Families,
}

/// Where a batch stands.
#[derive(Clone, Debug, Default)]
pub(crate) struct Walk {
    order: WalkOrder,
    /// For each vertex: four times the batch in which it was seen last, and what became of it.
    seen: Vec<u32>,
    batch: u32,
    /// Breadth first, who is to be asked; else all vertices that are not virtual.
    queue: Vec<u32>,
    head: usize,
    /// The next vertex to begin a component with, breadth first.
    seed: u32,
    /// Vertices at the beginning of the batch.
    end: u32,
    /// The vertex that each one made in the batch was split off, in the order of the walk.
    born: Vec<u32>,
    /// The queue may hold vertices that are virtual.
    is_renumbered: bool,
}

const QUEUED: u32 = 0;
const STAYS: u32 = 1;
const SPLITS: u32 = 2;

impl Walk {
    /// No batch yet.
    pub(crate) fn new(order: WalkOrder) -> Self {
        Self { order, ..Self::default() }
    }

    /// Makes room for so many vertices in all.
    pub(crate) fn reserve(&mut self, vertex_count: usize) {
        self.queue.reserve_exact(vertex_count);
    }

    /// Begins a batch.
    pub(crate) fn begin(&mut self, surface: &Surface) {
        self.batch += 1;
        self.take_in_born();
        let last_end = std::mem::replace(&mut self.end, surface.vertex_count() as u32);
        self.seed = surface.virtual_count();
        self.head = 0;
        match self.order {
            WalkOrder::Near => self.queue.clear(),
            _ if self.batch == 1 => self.queue.extend(self.seed..self.end),
            WalkOrder::Numbers => self.queue.extend(last_end..self.end),
            WalkOrder::Families => {}
        }
        if std::mem::take(&mut self.is_renumbered) {
            self.queue.retain(|&vertex| !surface.is_virtual(vertex));
        }
    }

    /// Puts the vertices of the last batch behind those that they were split off.
    fn take_in_born(&mut self) {
        let (mut from, mut left) = (self.queue.len(), self.born.len());
        self.queue.resize(from + left, 0);
        // From behind, so that each one is moved once.
        while left > 0 && from > 0 {
            from -= 1;
            let vertex = self.queue[from];
            if self.born[left - 1] == vertex {
                self.queue[from + left] = self.end + left as u32 - 1;
                left -= 1;
            }
            self.queue[from + left] = vertex;
        }
        debug_assert_eq!(left, 0, "splits come in the order of the walk");
        self.born.clear();
    }

    /// Told when a vertex of the walk has been split; the new one has the next number.
    #[inline]
    pub(crate) fn born(&mut self, kept: u32) {
        if self.order == WalkOrder::Families {
            self.born.push(kept);
        }
    }

    /// The surface has been built anew between two batches, and its vertices have other numbers: here is the old one of each, or
    /// [`NONE`] for those that are new. These are asked last.
    ///
    /// Only for the order of families.
    pub(crate) fn renumber(&mut self, old_of_new: &[u32]) {
        debug_assert_eq!(self.order, WalkOrder::Families, "the order that outlives new numbers");
        if self.batch == 0 {
            // Nobody has been asked yet.
            return;
        }
        let old_count = self.end as usize + self.born.len();
        self.take_in_born();
        let mut new_of_old = vec![NONE; old_count];
        for (new, &old) in old_of_new.iter().enumerate() {
            if let Some(new_of_old) = new_of_old.get_mut(old as usize) {
                *new_of_old = new as u32;
            }
        }
        let mut is_new = vec![true; old_of_new.len()];
        self.queue.retain_mut(|vertex| {
            *vertex = new_of_old[*vertex as usize];
            if let Some(is_new) = is_new.get_mut(*vertex as usize) {
                *is_new = false;
            }
            *vertex != NONE
        });
        self.queue.extend((0..).zip(is_new).filter(|&(_, is_new)| is_new).map(|(vertex, _)| vertex));
        let seen = |&old: &u32| self.seen.get(old as usize).copied().unwrap_or(0);
        self.seen = old_of_new.iter().map(seen).collect();
        self.end = old_of_new.len() as u32;
        self.is_renumbered = true;
    }

    /// The number of the batch, from 1.
    pub(crate) fn batch(&self) -> u32 {
        self.batch
    }

    /// What has become of a vertex that is not virtual.
    #[inline]
    pub(crate) fn fate(&self, vertex: u32) -> Fate {
        if vertex >= self.end {
            return Fate::New;
        }
        let seen = self.seen.get(vertex as usize).copied().unwrap_or(0);
        match seen.wrapping_sub(4 * self.batch) {
            STAYS => Fate::Stays,
            SPLITS => Fate::Splits,
            _ => Fate::Open,
        }
    }

    /// All vertices that are still to be asked, in order; not breadth first. Say how many were asked by
    /// [`pass`](Self::pass).
    pub(crate) fn rest(&self) -> &[u32] {
        &self.queue[self.head..]
    }

    /// The next so many vertices have been asked. What became of them is not noted.
    pub(crate) fn pass(&mut self, count: usize) {
        self.head += count;
    }

    /// The next vertex to ask; none when all were.
    pub(crate) fn next_vertex(&mut self) -> Option<u32> {
        if let Some(&vertex) = self.queue.get(self.head) {
            self.head += 1;
            return Some(vertex);
        }
        if self.order == WalkOrder::Near { self.next_seed() } else { None }
    }

    /// The next vertex of a component of which none was asked.
    fn next_seed(&mut self) -> Option<u32> {
        self.seen.resize(self.end as usize, 0);
        while self.seed < self.end && self.seen[self.seed as usize] >= 4 * self.batch {
            self.seed += 1;
        }
        if self.seed == self.end {
            return None;
        }
        self.seen[self.seed as usize] = 4 * self.batch + QUEUED;
        self.queue.clear();
        self.head = 0;
        self.seed += 1;
        Some(self.seed - 1)
    }

    /// Notes what became of a vertex, and queues its neighbors if it is breadth first: the vertices after the corners around it.
    pub(crate) fn settle(&mut self, surface: &Surface, vertex: u32, corners: &[u32], splits: bool) {
        if self.seen.len() <= vertex as usize {
            self.seen.resize(self.end as usize, 0);
        }
        self.seen[vertex as usize] = 4 * self.batch + if splits { SPLITS } else { STAYS };
        if self.order != WalkOrder::Near {
            return;
        }
        for &corner in corners {
            let neighbor = surface.vertex(next(corner));
            if neighbor < self.end
                && !surface.is_virtual(neighbor)
                && self.seen[neighbor as usize] < 4 * self.batch
            {
                self.seen[neighbor as usize] = 4 * self.batch + QUEUED;
                self.queue.push(neighbor);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;
    use crate::topology::cutting::close;

    /// A grid, whose boundary is one virtual vertex: 0.
    fn surface() -> Surface {
        let mesh = shapes::grid(3, 2);
        close(&mesh.triangles, mesh.positions.len()).surface
    }

    fn asked(walk: &mut Walk) -> Vec<u32> {
        std::iter::from_fn(|| walk.next_vertex()).collect()
    }

    /// Splits a vertex by one triangle.
    fn split(walk: &mut Walk, surface: &mut Surface, vertex: u32) -> u32 {
        let corner = surface.corner_of(vertex);
        walk.born(vertex);
        surface.split(&[corner])
    }

    #[test]
    fn families_stay_together() {
        let mut surface = surface();
        let count = surface.vertex_count() as u32;
        let mut walk = Walk::new(WalkOrder::Families);
        walk.begin(&surface);
        assert_eq!(asked(&mut walk), (1..count).collect::<Vec<_>>());
        for vertex in [2, 5] {
            split(&mut walk, &mut surface, vertex);
        }
        walk.begin(&surface);
        let first: Vec<u32> =
            (1..=2).chain([count]).chain(3..=5).chain([count + 1]).chain(6..count).collect();
        assert_eq!(asked(&mut walk), first);
        for vertex in [1, count] {
            split(&mut walk, &mut surface, vertex);
        }
        walk.begin(&surface);
        assert_eq!(walk.rest()[..5], [1, count + 2, 2, count, count + 3]);
        walk.pass(2);
        assert_eq!(walk.next_vertex(), Some(2));
        assert_eq!(walk.rest().len(), surface.vertex_count() - 4);
    }

    #[test]
    fn every_order_asks_everyone_once() {
        for order in [WalkOrder::Near, WalkOrder::Numbers, WalkOrder::Families] {
            let mut surface = surface();
            let mut walk = Walk::new(order);
            for _ in 0..3 {
                walk.begin(&surface);
                let mut all = Vec::new();
                while let Some(vertex) = walk.next_vertex() {
                    let corners: Vec<u32> = surface.ring(vertex).collect();
                    assert_eq!(walk.fate(vertex), Fate::Open);
                    walk.settle(&surface, vertex, &corners, false);
                    assert_eq!(walk.fate(vertex), Fate::Stays);
                    all.push(vertex);
                }
                all.sort_unstable();
                assert_eq!(all, (1..surface.vertex_count() as u32).collect::<Vec<_>>());
                let new = split(&mut walk, &mut surface, 3);
                assert_eq!(walk.fate(new), Fate::New);
            }
        }
    }

    #[test]
    fn new_numbers_keep_the_order() {
        let mut surface = surface();
        let count = surface.vertex_count() as u32;
        let mut walk = Walk::new(WalkOrder::Families);
        walk.begin(&surface);
        asked(&mut walk);
        split(&mut walk, &mut surface, 2);
        // The last vertex is gone, two are new, and all others run backwards but for the virtual one.
        let backwards: Vec<u32> = [0, NONE].into_iter().chain((1..count).rev()).chain([NONE]).collect();
        walk.renumber(&backwards);
        let rest = walk.queue.clone();
        assert_eq!(rest[..3], [count, count - 1, count - 2]);
        walk.begin(&surface);
        let mut expected: Vec<u32> = (2..=count).rev().collect();
        expected.extend([1, count + 1]);
        assert_eq!(asked(&mut walk), expected);
    }
}
