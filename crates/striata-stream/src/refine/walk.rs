//! The order in which both sides of a stream visit the vertices of a surface to decide whether they split.
//!
//! Each vertex is followed by its descendants, the latest first. It is visited once per batch; vertices created
//! within the batch are skipped.
//!
//! Vertices that were split off each other lie close together, so this order moves gradually over the
//! surface. The vertices that a batch creates are numbered in walk order, so a walk also runs through each
//! batch's memory from beginning to end. The order by index does neither: consecutive vertices lie wherever a
//! batch had room for a split, which takes half as much time again if a mesh does not fit into the caches.

use crate::topology::surface::{NONE, Surface};

/// Progress of a walk through the current batch.
#[derive(Clone, Debug, Default)]
pub(crate) struct BatchWalk {
    /// Number of the current batch, starting from 1.
    batch: u32,
    /// All vertices that are not virtual, in the order of their visits.
    queue: Vec<u32>,
    /// Position of the next vertex in the queue.
    head: usize,
    /// Number of vertices at the beginning of the batch.
    end: u32,
    /// For each vertex created in the batch, in walk order, the vertex it was split off.
    split_parents: Vec<u32>,
    /// Whether the queue may contain virtual vertices.
    is_renumbered: bool,
}

impl BatchWalk {
    /// Reserves memory for a total number of vertices.
    pub(crate) fn reserve(&mut self, vertex_count: usize) {
        self.queue.reserve_exact(vertex_count);
    }

    /// Begins a batch.
    pub(crate) fn begin(&mut self, surface: &Surface) {
        self.batch += 1;
        self.insert_created();
        self.end = surface.vertex_count() as u32;
        self.head = 0;
        if self.batch == 1 {
            self.queue.extend(surface.virtual_count()..self.end);
        }
        if std::mem::take(&mut self.is_renumbered) {
            self.queue.retain(|&vertex| !surface.is_virtual(vertex));
        }
    }

    /// Inserts the last batch's new vertices into the queue, each directly after the vertex it was split off.
    fn insert_created(&mut self) {
        let (mut from, mut left) = (self.queue.len(), self.split_parents.len());
        self.queue.resize(from + left, 0);
        // From back to front, so that each vertex moves only once.
        while left > 0 && from > 0 {
            from -= 1;
            let vertex = self.queue[from];
            if self.split_parents[left - 1] == vertex {
                self.queue[from + left] = self.end + left as u32 - 1;
                left -= 1;
            }
            self.queue[from + left] = vertex;
        }
        debug_assert_eq!(left, 0, "splits follow the order of the walk");
        self.split_parents.clear();
    }

    /// Records that a vertex of the walk was split. The new vertex has the next index.
    #[inline]
    pub(crate) fn record_split(&mut self, kept: u32) {
        self.split_parents.push(kept);
    }

    /// Adapts to a surface that was rebuilt and renumbered between two batches. `old_of_new` contains the
    /// old index of each of its vertices, or [`NONE`] for a new one. New vertices are visited last.
    pub(crate) fn renumber(&mut self, old_of_new: &[u32]) {
        if self.batch == 0 {
            // No vertex has been visited yet.
            return;
        }
        let old_count = self.end as usize + self.split_parents.len();
        self.insert_created();
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
        self.end = old_of_new.len() as u32;
        self.is_renumbered = true;
    }

    /// Number of the current batch, starting from 1.
    pub(crate) fn batch(&self) -> u32 {
        self.batch
    }

    /// Returns all vertices that remain to be visited, in order. Report how many of them were visited with
    /// [`skip`](Self::skip).
    pub(crate) fn rest(&self) -> &[u32] {
        &self.queue[self.head..]
    }

    /// Advances past a number of vertices without recording whether they split.
    pub(crate) fn skip(&mut self, count: usize) {
        self.head += count;
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;
    use crate::topology::cutting::close;

    /// A grid, whose boundary is closed by one virtual vertex, 0.
    fn surface() -> Surface {
        let mesh = shapes::grid(3, 2);
        close(&mesh.triangles, mesh.positions.len()).surface
    }

    fn visited(walk: &mut BatchWalk) -> Vec<u32> {
        let rest = walk.rest().to_vec();
        walk.skip(rest.len());
        rest
    }

    /// Splits a vertex with a patch of one triangle.
    fn split(walk: &mut BatchWalk, surface: &mut Surface, vertex: u32) -> u32 {
        let corner = surface.corner_of(vertex);
        walk.record_split(vertex);
        surface.split(&[corner])
    }

    #[test]
    fn split_off_vertices_follow_their_parents() {
        let mut surface = surface();
        let count = surface.vertex_count() as u32;
        let mut walk = BatchWalk::default();
        walk.begin(&surface);
        assert_eq!(visited(&mut walk), (1..count).collect::<Vec<_>>());
        for vertex in [2, 5] {
            split(&mut walk, &mut surface, vertex);
        }
        walk.begin(&surface);
        let first: Vec<u32> =
            (1..=2).chain([count]).chain(3..=5).chain([count + 1]).chain(6..count).collect();
        assert_eq!(visited(&mut walk), first);
        for vertex in [1, count] {
            split(&mut walk, &mut surface, vertex);
        }
        walk.begin(&surface);
        assert_eq!(walk.rest()[..5], [1, count + 2, 2, count, count + 3]);
        walk.skip(2);
        assert_eq!(walk.rest().len(), surface.vertex_count() - 3);
    }

    #[test]
    fn each_batch_visits_each_vertex_once() {
        let mut surface = surface();
        let mut walk = BatchWalk::default();
        for _ in 0..3 {
            walk.begin(&surface);
            let mut all = visited(&mut walk);
            all.sort_unstable();
            assert_eq!(all, (1..surface.vertex_count() as u32).collect::<Vec<_>>());
            split(&mut walk, &mut surface, 3);
        }
    }

    #[test]
    fn renumbering_keeps_the_order() {
        let mut surface = surface();
        let count = surface.vertex_count() as u32;
        let mut walk = BatchWalk::default();
        walk.begin(&surface);
        visited(&mut walk);
        split(&mut walk, &mut surface, 2);
        // Removes the last vertex, adds two new ones, and reverses the order of all others except the
        // virtual one.
        let backwards: Vec<u32> = [0, NONE].into_iter().chain((1..count).rev()).chain([NONE]).collect();
        walk.renumber(&backwards);
        let rest = walk.queue.clone();
        assert_eq!(rest[..3], [count, count - 1, count - 2]);
        walk.begin(&surface);
        let mut expected: Vec<u32> = (2..=count).rev().collect();
        expected.extend([1, count + 1]);
        assert_eq!(visited(&mut walk), expected);
    }
}
