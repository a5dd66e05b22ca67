//! Codes the wedges and groups of the base mesh, if positions have several vertices or triangles several
//! groups.

use super::mesh::Base;
use crate::entropy::{AdaptiveNumber, Coder, Rate};
use crate::refine::source::EncoderInput;
use crate::topology::surface::NONE;
use crate::wedges::model::WedgeModel;

impl Base {
    /// Codes how many wedges each position has, then the wedge of each corner and the group of each
    /// triangle. There are at most `vertex_count` wedges.
    pub(crate) fn code_wedges<C: Coder>(
        &mut self,
        coder: &mut C,
        model: &mut WedgeModel,
        input: Option<&dyn EncoderInput>,
        ((vertex_count, group_count), vertex_of_position): ((u32, u32), &[u32]),
    ) {
        let mut counts = AdaptiveNumber::new(1, Rate::Steady);
        self.first_vertex = vec![0];
        let mut end = 0;
        for &vertex in vertex_of_position {
            let extra = input.map_or(0, |input| input.wedges(vertex).len()).max(1) as u32 - 1;
            let max_extra = vertex_count.saturating_sub(end + 1);
            end += 1 + counts.unsigned(coder, 0, extra).min(max_extra);
            self.first_vertex.push(end);
        }
        let mut last_wedge = vec![None; self.grid_points.len()];
        let mut last_group = None;
        self.corner_vertices.clear();
        self.groups.clear();
        for t in 0..self.triangles.len() {
            let positions = self.triangles[t].map(|v| self.position_of(v));
            if positions.contains(&NONE) {
                self.corner_vertices.push([NONE; 3]);
                self.groups.push(0);
                continue;
            }
            let actual = input.map_or(0, |input| input.group(t as u32));
            let group = model.base_group(coder, group_count, last_group, actual);
            last_group = Some(group);
            self.groups.push(group);
            let mut corner_vertices = [0; 3];
            for (i, &position) in positions.iter().enumerate() {
                let p = position as usize;
                let wedges = self.first_vertex[p]..self.first_vertex[p + 1];
                let actual = input.map_or(0, |input| input.vertex_at(4 * t as u32 + i as u32));
                corner_vertices[i] = model.base_corner(coder, wedges, last_wedge[p], actual);
                last_wedge[p] = Some(corner_vertices[i]);
            }
            self.corner_vertices.push(corner_vertices);
        }
    }
}
