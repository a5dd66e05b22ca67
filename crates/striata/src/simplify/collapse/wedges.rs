//! Pairing of wedges: the vertex of the target position that replaces each vertex of the removed position.
//!
//! A collapse removes a position with all its wedges. The triangles at the collapsing edge show which
//! wedges lie on the same side of the seam. A wedge without such a partner has to **cross** the seam:
//! it goes to the wedge of the target that differs least from it. [`Wedges::pair`] rejects that,
//! [`Wedges::pair_across`] allows it.
//!
//! Both reject a **conflict**: one wedge of the removed position that faces two wedges of the target.
//! One of the two triangles at the edge would vanish in space, but keep three different vertices.

use crate::mesh::PositionIndex;

use super::star::Star;

/// Current vertices (wedges) of all triangles, and the pairing found last.
#[derive(Debug)]
pub(in crate::simplify) struct Wedges<'a> {
    positions: &'a PositionIndex,
    /// Vertices of every triangle, kept up to date by [`Self::substitute`].
    corners: Vec<[u32; 3]>,
    /// The pairing found last, as (removed wedge, target wedge).
    map: Vec<(u32, u32)>,
    /// Index of the first pair in `map` that crosses a seam.
    first_crossing: usize,
}

impl<'a> Wedges<'a> {
    pub(in crate::simplify) fn new(positions: &'a PositionIndex, corners: Vec<[u32; 3]>) -> Self {
        Self { positions, corners, map: Vec::new(), first_crossing: 0 }
    }

    /// Whether `position` has several vertices.
    #[inline]
    pub(in crate::simplify) fn is_split(&self, position: u32) -> bool {
        self.positions.wedges(position).len() > 1
    }

    /// Returns the first vertex of `position`.
    #[inline]
    pub(in crate::simplify) fn first(&self, position: u32) -> u32 {
        self.positions.first_vertex(position)
    }

    /// Returns the partner at `position` of `wedge` in the pairing found last.
    pub(in crate::simplify) fn paired(&self, wedge: u32, position: u32) -> u32 {
        let pair = self.map.iter().find(|(from, _)| *from == wedge);
        pair.map_or(self.positions.first_vertex(position), |&(_, to)| to)
    }

    /// Whether `wedge` crosses a seam in the pairing found last.
    pub(in crate::simplify) fn crosses(&self, wedge: u32) -> bool {
        self.map[self.first_crossing..].iter().any(|(from, _)| *from == wedge)
    }

    /// Stores in `star` the vertex of `v` that each of its triangles uses.
    pub(in crate::simplify) fn load_center_wedges(&self, star: &mut Star, v: u32) {
        let mut center_wedges = std::mem::take(&mut star.center_wedges);
        center_wedges.clear();
        let count = star.ring.triangle_count();
        if self.is_split(v) {
            center_wedges.extend(star.ring.triangles[..count].iter().map(|&t| self.vertex_at(t, v)));
        } else {
            center_wedges.resize(count, self.first(v));
        }
        star.center_wedges = center_wedges;
    }

    /// Pairs every wedge of `v` with the wedge of `u` for which `difference` is least. For positions
    /// without a common edge, where no triangle determines the pairing.
    pub(in crate::simplify) fn pair_nearest(&mut self, v: u32, u: u32, difference: impl Fn(u32, u32) -> f32) {
        self.map.clear();
        for from in self.positions.wedges(v) {
            self.map.push((from, self.nearest_wedge(from, u, &difference)));
        }
        self.first_crossing = self.map.len();
    }

    /// Returns the wedge of `u` that differs least from the vertex `from`; the first one in a tie.
    fn nearest_wedge(&self, from: u32, u: u32, difference: impl Fn(u32, u32) -> f32) -> u32 {
        let wedges = self.positions.wedges(u);
        let nearest = wedges.min_by(|&a, &b| difference(from, a).total_cmp(&difference(from, b)));
        nearest.unwrap_or(self.positions.first_vertex(u))
    }

    /// Returns the vertices of a triangle.
    #[inline]
    pub(in crate::simplify) fn corners(&self, triangle: u32) -> [u32; 3] {
        self.corners[triangle as usize]
    }

    /// Returns the vertices of all triangles.
    pub(in crate::simplify) fn into_corners(self) -> Vec<[u32; 3]> {
        self.corners
    }

    /// Returns the position of a vertex.
    #[inline]
    pub(in crate::simplify) fn position_of(&self, vertex: u32) -> u32 {
        self.positions.position_of(vertex)
    }

    /// Adds a triangle and returns its index.
    pub(in crate::simplify) fn push(&mut self, corners: [u32; 3]) -> u32 {
        self.corners.push(corners);
        self.corners.len() as u32 - 1
    }

    /// Returns the vertex that `triangle` uses at `position`.
    #[inline]
    pub(in crate::simplify) fn vertex_at(&self, triangle: u32, position: u32) -> u32 {
        let [a, b, c] = self.corners[triangle as usize];
        if self.positions.position_of(a) == position {
            a
        } else if self.positions.position_of(b) == position {
            b
        } else {
            c
        }
    }

    /// Pairs the wedges of `v` with those of its neighbor `star.ring.ids[k]`; returns false if some wedge
    /// has no partner on its own side of the seam.
    pub(in crate::simplify) fn pair(&mut self, star: &Star, v: u32, k: usize) -> bool {
        let u = star.ring.ids[k];
        self.map.clear();
        if !self.is_split(v) && !self.is_split(u) {
            self.map.push((self.positions.first_vertex(v), self.positions.first_vertex(u)));
            self.first_crossing = 1;
            return true;
        }
        for t in 0..star.ring.triangle_count() {
            if star.ring.triangle(t).contains(&k) {
                let triangle = star.ring.triangles[t];
                if !self.join(self.vertex_at(triangle, v), self.vertex_at(triangle, u)) {
                    return false;
                }
            }
        }
        self.first_crossing = self.map.len();
        (0..star.ring.triangle_count()).all(|t| {
            let from = self.vertex_at(star.ring.triangles[t], v);
            self.map.iter().any(|(other, _)| *other == from)
        })
    }

    /// Pairs wedges as [`Self::pair`] does, but lets wedges without a partner cross the seam to the
    /// wedge for which `difference` is least; returns false only in a conflict. The star must have been
    /// loaded by [`Self::load_center_wedges`].
    pub(in crate::simplify) fn pair_across(
        &mut self,
        star: &Star,
        v: u32,
        k: usize,
        difference: impl Fn(u32, u32) -> f32,
    ) -> bool {
        let u = star.ring.ids[k];
        self.map.clear();
        let is_split = self.is_split(u);
        if !is_split && !self.is_split(v) {
            self.map.push((self.positions.first_vertex(v), self.positions.first_vertex(u)));
            self.first_crossing = 1;
            return true;
        }
        for t in 0..star.ring.triangle_count() {
            if star.ring.triangle(t).contains(&k) {
                let to = if is_split { self.vertex_at(star.ring.triangles[t], u) } else { self.first(u) };
                if !self.join(star.center_wedges[t], to) {
                    return false;
                }
            }
        }
        self.first_crossing = self.map.len();
        for &from in &star.center_wedges {
            if self.map.iter().all(|(other, _)| *other != from) {
                let to = self.nearest_wedge(from, u, &difference);
                self.map.push((from, to));
            }
        }
        true
    }

    /// Adds a pair; returns false if its wedge is paired with another one already.
    fn join(&mut self, from: u32, to: u32) -> bool {
        match self.map.iter().find(|(other, _)| *other == from) {
            Some(&(_, found)) => found == to,
            None => {
                self.map.push((from, to));
                true
            }
        }
    }

    /// Writes the targets of all wedges of `v` by the pairing found last; `u` is the target position.
    pub(in crate::simplify) fn write_targets(&self, v: u32, u: u32, targets: &mut [u32]) {
        for wedge in self.positions.wedges(v) {
            // A wedge that no triangle uses any more shares the target of the first pair.
            let paired = self.map.iter().find(|(from, _)| *from == wedge).or(self.map.first());
            targets[wedge as usize] = paired.map_or(self.positions.first_vertex(u), |&(_, to)| to);
        }
    }

    /// Writes the first vertex of `u` as the target of every wedge of `v`.
    pub(in crate::simplify) fn write_single_target(&self, v: u32, u: u32, targets: &mut [u32]) {
        let target = self.positions.first_vertex(u);
        self.positions.wedges(v).for_each(|wedge| targets[wedge as usize] = target);
    }

    /// Replaces the wedges of `v` by their targets in the triangles around `v`.
    pub(in crate::simplify) fn substitute(&mut self, star: &Star, v: u32, targets: &[u32]) {
        let wedges = self.positions.wedges(v);
        for &t in &star.ring.triangles[..star.ring.triangle_count()] {
            for corner in &mut self.corners[t as usize] {
                if wedges.contains(corner) {
                    *corner = targets[*corner as usize];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simplify::collapse::links::Links;

    /// A fan of four around position 0, whose first two triangles use wedge 0 there and the others
    /// wedge 1. The rim has positions 1 to 4, of which the first has two wedges.
    ///
    /// ```text
    /// 2 --- 1        wedges 0 1 | 2 3 | 4 | 5 | 6
    /// | \ / |        of position 0   1   2   3   4
    /// |  0  |
    /// | / \ |
    /// 3 --- 4
    /// ```
    fn loaded(corners: &[[u32; 3]]) -> (PositionIndex, Star) {
        let positions = PositionIndex::from_first(vec![0, 2, 4, 5, 6, 7]);
        let coordinates =
            [[0., 0., 0., 0.], [1., 1., 0., 0.], [-1., 1., 0., 0.], [-1., -1., 0., 0.], [1., -1., 0., 0.]];
        let triangles: Vec<[u32; 3]> = corners.iter().map(|t| t.map(|v| positions.position_of(v))).collect();
        let mut star = Star::default();
        star.gather(&Links::new(5, &triangles, true), &coordinates, 0);
        (positions, star)
    }

    fn index_of(star: &Star, position: u32) -> usize {
        star.ring.index_of(position).expect("it is a neighbor")
    }

    #[test]
    fn wedges_without_a_partner_cross_to_the_most_similar_one() {
        let corners = [[0, 2, 4], [0, 4, 5], [1, 5, 6], [1, 6, 3]];
        let (positions, mut star) = loaded(&corners);
        let mut wedges = Wedges::new(&positions, corners.to_vec());
        wedges.load_center_wedges(&mut star, 0);
        // Along the seam to position 1, both have partners.
        let along = index_of(&star, 1);
        assert!(wedges.pair(&star, 0, along));
        assert!(wedges.pair_across(&star, 0, along, |_, _| 0.0));
        assert_eq!([0, 1].map(|w| wedges.paired(w, 1)), [2, 3]);
        assert!(!wedges.crosses(0) && !wedges.crosses(1));
        // Position 2 is on one side of the seam only.
        let across = index_of(&star, 2);
        assert!(!wedges.pair(&star, 0, across));
        assert!(wedges.pair_across(&star, 0, across, |_, _| 1.0));
        assert_eq!([0, 1].map(|w| wedges.paired(w, 2)), [4, 4]);
        assert!(!wedges.crosses(0) && wedges.crosses(1));
    }

    #[test]
    fn one_wedge_that_faces_two_is_a_conflict() {
        let corners = [[0, 2, 4], [0, 4, 5], [0, 5, 6], [0, 6, 3]];
        let (positions, mut star) = loaded(&corners);
        let mut wedges = Wedges::new(&positions, corners.to_vec());
        wedges.load_center_wedges(&mut star, 0);
        let k = index_of(&star, 1);
        assert!(!wedges.pair(&star, 0, k) && !wedges.pair_across(&star, 0, k, |_, _| 0.0));
    }
}
