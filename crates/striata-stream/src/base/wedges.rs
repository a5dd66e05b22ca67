//! Codes the wedges and groups of the base mesh, if positions have several vertices or triangles several
//! groups.

use super::mesh::Base;
use crate::entropy::{AdaptiveNumber, Coder, Rate};
use crate::refine::source::Plan;
use crate::topology::surface::NONE;
use crate::wedges::model::WedgeModel;

impl Base {
    /// Codes how many wedges each position has, then the wedge of each corner and the group of each
    /// triangle. There are at most `vertex_count` wedges.
    pub(crate) fn code_wedges<C: Coder>(
        &mut self,
        coder: &mut C,
        model: &mut WedgeModel,
        plan: Option<&dyn Plan>,
        ((vertex_count, group_count), vertex_of_position): ((u32, u32), &[u32]),
    ) {
        let mut counts = AdaptiveNumber::new(1, Rate::Steady);
        self.first_vertex = vec![0];
        let mut end = 0;
        for &vertex in vertex_of_position {
            let extra = plan.map_or(0, |plan| plan.wedges(vertex).len()).max(1) as u32 - 1;
            let max_extra = vertex_count.saturating_sub(end + 1);
            end += 1 + counts.unsigned(coder, 0, extra).min(max_extra);
            self.first_vertex.push(end);
        }
        let mut last_wedge = vec![None; self.places.len()];
        let mut last_group = None;
        self.shown.clear();
        self.groups.clear();
        for t in 0..self.triangles.len() {
            let positions = self.triangles[t].map(|v| self.position_of(v));
            if positions.contains(&NONE) {
                self.shown.push([NONE; 3]);
                self.groups.push(0);
                continue;
            }
            let actual = plan.map_or(0, |plan| plan.group(t as u32));
            let group = model.base_group(coder, (group_count, last_group), actual);
            last_group = Some(group);
            self.groups.push(group);
            let mut shown = [0; 3];
            for (i, &position) in positions.iter().enumerate() {
                let p = position as usize;
                let wedges = self.first_vertex[p]..self.first_vertex[p + 1];
                let actual = plan.map_or(0, |plan| plan.vertex_at(4 * t as u32 + i as u32));
                shown[i] = model.base_corner(coder, (wedges, last_wedge[p]), actual);
                last_wedge[p] = Some(shown[i]);
            }
            self.shown.push(shown);
        }
    }
}
