//! A triangle list in which triangles keep their places, so that little has to be uploaded.

use std::ops::Range;

/// Place of a triangle that has none yet.
const NONE: u32 = u32::MAX;

/// Changed triangles with fewer others between them are one range: an upload of its own costs more than those.
const MAX_GAP: u32 = 8;

/// If more than one in this many places is free, all triangles get new places.
const MIN_PLACES_PER_FREE: usize = 4;

/// The triangles of a [`View`](super::View), each at the same place from frame to frame.
///
/// The view itself lists its triangles one after another, so that a triangle that appears moves all those after it. Here
/// new triangles take the places of those that have gone. A place that is free has a triangle without area, which draws
/// nothing; if a quarter of the places are free, all triangles get new ones.
///
/// Cost: an update walks all triangles once. Memory: 28 bytes per triangle.
///
/// # Example
/// ```
/// # use striata::{Lod, LodOptions, mesh::shapes, view::Camera, lod::PlacedTriangles};
/// # let lod = Lod::build(&shapes::icosphere(3, 1.0), &LodOptions::default())?;
/// # let camera = Camera::new([0.0, 0.0, 3.0], [0.0; 3], [0.0, 1.0, 0.0], 0.577, [1920, 1080])?;
/// let (mut view, mut placed) = (lod.view(), PlacedTriangles::default());
/// view.update(&camera, 1.0);
/// placed.follow(view.triangles());
/// for range in placed.changes() {
///     upload(range.start, &placed.triangles()[range]);
/// }
/// placed.clear_changes();
/// # fn upload(_: usize, _: &[[u32; 3]]) {}
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct PlacedTriangles {
    /// Triangles of the last update, in the order of the view.
    listed: Vec<[u32; 3]>,
    /// Place of each of them.
    places: Vec<u32>,
    placed: Vec<[u32; 3]>,
    free: Vec<u32>,
    /// Places that have changed, in any order.
    changed: Vec<u32>,
    /// Whether all places have changed.
    is_all_changed: bool,
    /// Scratch for new places.
    next_places: Vec<u32>,
}

impl PlacedTriangles {
    /// Updates the places to the triangles that a view shows, or to those of one of its groups.
    pub fn follow(&mut self, triangles: &[[u32; 3]]) {
        let first_free = self.free.len();
        self.match_places(triangles);
        for (place, triangle) in
            self.next_places.iter_mut().zip(triangles).filter(|(place, _)| **place == NONE)
        {
            *place = self.free.pop().unwrap_or(self.placed.len() as u32);
            match self.placed.get_mut(*place as usize) {
                Some(placed) => *placed = *triangle,
                None => self.placed.push(*triangle),
            }
            self.changed.push(*place);
        }
        let emptied = &self.free[first_free.min(self.free.len())..];
        for &place in emptied {
            self.placed[place as usize] = [0; 3];
        }
        self.changed.extend_from_slice(emptied);
        std::mem::swap(&mut self.places, &mut self.next_places);
        self.listed.clear();
        self.listed.extend_from_slice(triangles);
        if MIN_PLACES_PER_FREE * self.free.len() > self.placed.len() {
            self.place_all();
        }
        if self.changed.len() > self.placed.len() {
            self.is_all_changed = true;
            self.changed.clear();
        }
    }

    /// Finds the places of the triangles that stay, and frees those of the others.
    ///
    /// Views list the triangles of each vertex together, with that vertex first, and most vertices in order.
    fn match_places(&mut self, triangles: &[[u32; 3]]) {
        self.next_places.clear();
        let (mut old, mut new) = (0, 0);
        while new < triangles.len() {
            match self.listed.get(old) {
                Some(before) if *before == triangles[new] => {
                    self.next_places.push(self.places[old]);
                    (old, new) = (old + 1, new + 1);
                }
                Some(before) if before[0] <= triangles[new][0] => {
                    self.free.push(self.places[old]);
                    old += 1;
                }
                _ => {
                    self.next_places.push(NONE);
                    new += 1;
                }
            }
        }
        self.free.extend_from_slice(&self.places[old..]);
    }

    /// Gives all triangles new places, one after another.
    fn place_all(&mut self) {
        self.placed.clear();
        self.placed.extend_from_slice(&self.listed);
        self.places.clear();
        self.places.extend(0..self.listed.len() as u32);
        self.free.clear();
        self.changed.clear();
        self.is_all_changed = true;
    }

    /// Triangles at their places; those without area are free places.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.placed
    }

    /// Vertex indices of [`triangles`](Self::triangles), three per triangle.
    pub fn indices(&self) -> &[u32] {
        self.placed.as_flattened()
    }

    /// Ranges of [`triangles`](Self::triangles) that have changed since [`clear_changes`](Self::clear_changes), in order.
    pub fn changes(&self) -> Vec<Range<usize>> {
        if self.is_all_changed {
            return std::iter::once(0..self.placed.len()).filter(|range| !range.is_empty()).collect();
        }
        let mut sorted = self.changed.clone();
        sorted.sort_unstable();
        sorted.dedup();
        let near = sorted.chunk_by(|a, b| b - a <= MAX_GAP);
        near.map(|places| places[0] as usize..places[places.len() - 1] as usize + 1).collect()
    }

    /// Forgets the changes, once they have been uploaded.
    pub fn clear_changes(&mut self) {
        self.changed.clear();
        self.is_all_changed = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Random, canonical_triangles, shapes};
    use crate::view::Camera;
    use crate::{Lod, LodOptions};

    /// Follows a list, and checks that the changes are enough; returns the number of triangles to upload.
    fn follow(placed: &mut PlacedTriangles, uploaded: &mut Vec<[u32; 3]>, triangles: &[[u32; 3]]) -> usize {
        placed.follow(triangles);
        uploaded.resize(placed.triangles().len(), [7; 3]);
        let changes = placed.changes();
        for range in changes.clone() {
            uploaded[range.clone()].copy_from_slice(&placed.triangles()[range]);
        }
        placed.clear_changes();
        assert_eq!(uploaded, placed.triangles());
        let shown: Vec<_> = uploaded.iter().copied().filter(|[a, b, _]| a != b).collect();
        assert_eq!(canonical_triangles(&shown), canonical_triangles(triangles));
        assert!(3 * placed.triangles().len() <= 4 * triangles.len());
        changes.iter().map(Range::len).sum()
    }

    #[test]
    fn few_places_change_from_frame_to_frame() {
        let lod = Lod::build(&shapes::terrain(80, 3), &LodOptions::default()).unwrap();
        let (mut view, mut placed, mut uploaded) = (lod.view(), PlacedTriangles::default(), Vec::new());
        let (mut total, mut sent) = (0, 0);
        for frame in 0..60 {
            let eye = [0.05 * frame as f32, 40.0, 12.0];
            let camera = Camera::new(eye, [40.0, 41.0, 0.0], [0.0, 0.0, 1.0], 0.577, [800, 600]).unwrap();
            view.update(&camera, 6.0);
            let changed = follow(&mut placed, &mut uploaded, view.triangles());
            if frame > 0 {
                (total, sent) = (total + view.triangle_count(), sent + changed);
            }
        }
        assert!(total > 10_000 && 5 * sent < total, "{sent} of {total}");
        view.update_to_budget(
            &Camera::new([0.0, 0.0, 900.0], [0.0; 3], [0.0, 1.0, 0.0], 0.577, [800, 600]).unwrap(),
            1.0,
            10,
        );
        follow(&mut placed, &mut uploaded, view.triangles());
    }

    #[test]
    fn any_lists_can_follow_each_other() {
        let mut random = Random::new(3);
        let (mut placed, mut uploaded) = (PlacedTriangles::default(), Vec::new());
        for _ in 0..300 {
            let count = random.below(40);
            let list: Vec<[u32; 3]> = (0..count)
                .map(|_| {
                    let first = random.below(9);
                    [first, first + 1 + random.below(3), 20]
                })
                .collect();
            follow(&mut placed, &mut uploaded, &list);
            assert_eq!(follow(&mut placed, &mut uploaded, &list), 0, "nothing has changed");
        }
    }
}
