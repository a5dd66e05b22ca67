//! Borders through a star: along which edges the center may move, and the cost of leaving the others.

use super::border_edge::{BORDER_WEIGHT, BorderEdge, BorderKind};
use super::ring::EdgeSides;
use super::{SeamBetween, Star};
use crate::simplify::collapse::links::LinkKind;

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
            let last = self.ring.ids.len() - 1;
            let swept = BORDER_WEIGHT * self.offset(0).cross(self.offset(last)).length_squared();
            let (first_cost, last_cost) = (self.costs[0] + swept, self.costs[last] + swept);
            self.costs.fill(f32::INFINITY);
            (self.costs[0], self.costs[last]) = (first_cost, last_cost);
            return;
        }
        let mut border_edges = std::mem::take(&mut self.border_edges);
        border_edges.clear();
        for i in 0..self.ring.ids.len() {
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
    fn border_edge(&self, i: usize, seam_between: Option<SeamBetween<'_>>) -> Option<BorderEdge> {
        let (kind, difference_squared) = match self.ring.sides(i) {
            EdgeSides::Boundary => (BorderKind::Boundary, f32::INFINITY),
            EdgeSides::Branch => (BorderKind::Branch, f32::INFINITY),
            EdgeSides::Inner(sides) => {
                let seam = |[t, s]: [usize; 2]| seam_between?(self, t, s);
                (BorderKind::Seam, sides.into_iter().flatten().filter_map(seam).reduce(f32::max)?)
            }
        };
        Some(BorderEdge { neighbor: i as u32, kind, difference_squared })
    }
}
