//! Borders through a star: along which edges the center may move, and the cost of leaving the others.

use super::border_edge::{BORDER_WEIGHT, BorderEdge, BorderKind};
use super::{SeamBetween, Star};
use crate::simplify::collapse::links::LinkKind;

/// Triangles at the edge to a neighbor.
#[derive(Default)]
struct EdgeTriangles {
    /// The first two that end at the neighbor.
    before: [Option<usize>; 2],
    /// The first two that begin at the neighbor.
    after: [Option<usize>; 2],
    /// Number of triangles that begin or end at the neighbor.
    count: usize,
}

impl Star {
    /// Restricts the candidates to the border edges of `v` and adds the cost of leaving the old path of
    /// a border.
    ///
    /// `seam_between(star, i, j)` returns the squared difference of attributes if triangles `i` and `j`
    /// use different wedges of `v`; infinite if the seam must stay.
    pub(in crate::simplify) fn apply_borders(
        &mut self,
        kind: LinkKind,
        seam_between: Option<SeamBetween<'_>>,
    ) {
        if kind == LinkKind::Closed && seam_between.is_none() {
            return;
        }
        if kind == LinkKind::Open && seam_between.is_none() {
            let last = self.ids.len() - 1;
            let swept = BORDER_WEIGHT * self.offset(0).cross(self.offset(last)).length_squared();
            let (first_cost, last_cost) = (self.costs[0] + swept, self.costs[last] + swept);
            self.costs.fill(f32::INFINITY);
            (self.costs[0], self.costs[last]) = (first_cost, last_cost);
            return;
        }
        let mut border_edges = std::mem::take(&mut self.border_edges);
        border_edges.clear();
        for i in 0..self.ids.len() {
            border_edges.extend(self.border_edge(i, seam_between));
        }
        self.charge_borders(&border_edges);
        self.border_edges = border_edges;
    }

    fn charge_borders(&mut self, border_edges: &[BorderEdge]) {
        let Some(strongest) = border_edges.iter().map(|s| s.kind).max() else { return };
        // Seams that may be crossed do not restrict the candidates.
        let binds = strongest > BorderKind::Seam
            || border_edges.iter().any(|s| s.difference_squared == f32::INFINITY);
        let mut costs = std::mem::take(&mut self.costs);
        for (i, cost) in costs.iter_mut().enumerate() {
            if binds && !border_edges.iter().any(|s| s.neighbor as usize == i && s.kind == strongest) {
                *cost = f32::INFINITY;
                continue;
            }
            let u = self.offset(i);
            let others = border_edges.iter().filter(|s| s.neighbor as usize != i);
            let swept =
                |s: &BorderEdge| s.leave_cost(self.offset(s.neighbor as usize).cross(u).length_squared());
            *cost += others.map(swept).sum::<f32>();
            if let [end] = border_edges {
                // The border ends here and would recede.
                *cost += end.recede_cost(u.length_squared());
            }
        }
        self.costs = costs;
    }

    /// Returns the edge to neighbor `i` if it lies on a border.
    ///
    /// A sheet that is modeled from both sides has two triangles at its boundary and four at an inner edge.
    fn border_edge(&self, i: usize, seam_between: Option<SeamBetween<'_>>) -> Option<BorderEdge> {
        let EdgeTriangles { before, after, count } = self.triangles_at(i);
        let (kind, difference_squared) = match (before, after) {
            _ if count == 1 => (BorderKind::Boundary, f32::INFINITY),
            ([Some(t), None], [Some(s), None]) if self.are_opposite(t, s) => {
                (BorderKind::Boundary, f32::INFINITY)
            }
            ([Some(t), None], [Some(s), None]) => (BorderKind::Seam, seam_between?(self, t, s)?),
            ([Some(t), Some(u)], [Some(s), Some(r)]) if count == 4 && self.are_two_sided([t, u], [s, r]) => {
                // The triangle that continues a side at the edge is not the opposite copy.
                let sides = if self.are_opposite(t, s) { [(t, r), (u, s)] } else { [(t, s), (u, r)] };
                let differences = sides.map(|(t, s)| seam_between?(self, t, s));
                (BorderKind::Seam, differences.into_iter().flatten().reduce(f32::max)?)
            }
            _ => (BorderKind::Branch, f32::INFINITY),
        };
        Some(BorderEdge { neighbor: i as u32, kind, difference_squared })
    }

    /// Whether each triangle has an opposite copy, as in a sheet that is modeled from both sides.
    pub(in crate::simplify) fn is_two_sided(&self) -> bool {
        self.has_two_sides
            && !self.pairs.is_empty()
            && self.pairs.iter().all(|&[a, b]| self.pairs.contains(&[b, a]))
    }

    /// Whether two triangles are both sides of a sheet: they have the same corners in opposite order.
    fn are_opposite(&self, t: usize, s: usize) -> bool {
        let [a, b] = self.triangle(t);
        self.has_two_sides && self.triangle(s) == [b, a]
    }

    /// Whether four triangles at an edge are two different ones and their opposite copies.
    fn are_two_sided(&self, [t, u]: [usize; 2], [s, r]: [usize; 2]) -> bool {
        self.triangle(t) != self.triangle(u)
            && (self.are_opposite(t, s) && self.are_opposite(u, r)
                || self.are_opposite(t, r) && self.are_opposite(u, s))
    }

    fn triangles_at(&self, i: usize) -> EdgeTriangles {
        if self.pairs.is_empty() {
            let n = self.ids.len();
            let is_closed = self.triangle_count == n;
            let before = if i > 0 { Some(i - 1) } else { is_closed.then_some(n - 1) };
            let after = (i < self.triangle_count).then_some(i);
            let count = usize::from(before.is_some()) + usize::from(after.is_some());
            return EdgeTriangles { before: [before, None], after: [after, None], count };
        }
        let mut found = EdgeTriangles::default();
        for (t, pair) in self.pairs.iter().enumerate() {
            let [a, b] = pair.map(|x| x as usize);
            for (end, side) in [(a, &mut found.after), (b, &mut found.before)] {
                if end == i {
                    found.count += 1;
                    if let Some(place) = side.iter_mut().find(|place| place.is_none()) {
                        *place = Some(t);
                    }
                }
            }
        }
        found
    }
}
