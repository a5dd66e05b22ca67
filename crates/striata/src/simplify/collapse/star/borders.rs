//! Borders through a star: along which edges the center may move, and the cost of leaving the others.

use super::special::{BORDER_WEIGHT, Border, Special};
use super::{SeamBetween, Star};
use crate::simplify::collapse::links::LinkKind;

/// Triangles at the edge to a neighbor.
struct Around {
    /// The last one that ends at the neighbor.
    before: Option<usize>,
    /// The last one that begins at the neighbor.
    after: Option<usize>,
    /// Number of triangles that do either.
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
        let mut special = std::mem::take(&mut self.special);
        special.clear();
        for i in 0..self.ids.len() {
            special.extend(self.special_edge(i, seam_between));
        }
        self.charge_borders(&special);
        self.special = special;
    }

    fn charge_borders(&mut self, special: &[Special]) {
        let Some(strongest) = special.iter().map(|s| s.border).max() else { return };
        // Seams that may be crossed do not restrict the candidates.
        let binds = strongest > Border::Seam || special.iter().any(|s| s.difference_squared == f32::INFINITY);
        let mut costs = std::mem::take(&mut self.costs);
        for (i, cost) in costs.iter_mut().enumerate() {
            if binds && !special.iter().any(|s| s.neighbor as usize == i && s.border == strongest) {
                *cost = f32::INFINITY;
                continue;
            }
            let u = self.offset(i);
            let others = special.iter().filter(|s| s.neighbor as usize != i);
            let swept =
                |s: &Special| s.leave_cost(self.offset(s.neighbor as usize).cross(u).length_squared());
            *cost += others.map(swept).sum::<f32>();
            if let [end] = special {
                // The border ends here and would recede.
                *cost += end.recede_cost(u.length_squared());
            }
        }
        self.costs = costs;
    }

    /// Returns the edge to neighbor `i` if it lies on a border.
    fn special_edge(&self, i: usize, seam_between: Option<SeamBetween<'_>>) -> Option<Special> {
        let Around { before, after, count } = self.triangles_at(i);
        let (border, difference_squared) = match (before, after) {
            _ if count == 1 => (Border::Boundary, f32::INFINITY),
            (Some(t), Some(s)) if count == 2 => (Border::Seam, seam_between?(self, t, s)?),
            _ => (Border::Branch, f32::INFINITY),
        };
        Some(Special { neighbor: i as u32, border, difference_squared })
    }

    fn triangles_at(&self, i: usize) -> Around {
        if self.pairs.is_empty() {
            let n = self.ids.len();
            let is_closed = self.triangle_count == n;
            let before = if i > 0 { Some(i - 1) } else { is_closed.then_some(n - 1) };
            let after = (i < self.triangle_count).then_some(i);
            let count = usize::from(before.is_some()) + usize::from(after.is_some());
            return Around { before, after, count };
        }
        let (mut before, mut after, mut count) = (None, None, 0);
        for (t, pair) in self.pairs.iter().enumerate() {
            let [a, b] = pair.map(|x| x as usize);
            if a == i {
                after = Some(t);
                count += 1;
            }
            if b == i {
                before = Some(t);
                count += 1;
            }
        }
        Around { before, after, count }
    }
}
