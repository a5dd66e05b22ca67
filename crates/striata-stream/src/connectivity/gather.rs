//! Gathers the ring of a vertex: its neighbors, their state and history, and their positions.

use super::ring::{Ring, RingSpoke, mean};
use super::split_context::SplitContext;
use super::vertex_history::VertexHistories;
use crate::refine::walk::VisitState;
use crate::topology::surface::{next, triangle_of};

impl Ring {
    /// Gathers the ring of a vertex. All accesses to scattered memory are made here, in one pass.
    pub(super) fn gather(
        &mut self,
        split_context: &SplitContext<'_>,
        history: &VertexHistories,
        vertex: u32,
        corners: &[u32],
    ) {
        let here = split_context.grid_points[vertex as usize];
        self.magnitudes = 0;
        self.spokes.clear();
        self.states = [0; 4];
        self.young = 0;
        self.free = 0;
        let mut density = 0;
        for &corner in corners {
            let vertex = split_context.surface.vertex(next(corner));
            let is_claimed = split_context.is_claimed(triangle_of(corner));
            self.free += usize::from(!is_claimed);
            let mut spoke = RingSpoke { vertex, is_claimed, ..RingSpoke::default() };
            if split_context.surface.is_virtual(vertex) {
                (spoke.is_virtual, spoke.state, spoke.age, spoke.valence) = (true, 1, 3, 9);
            } else {
                let state = split_context.walk.visit_state(vertex);
                let vertex_history = history.of(vertex);
                spoke.state = match state {
                    VisitState::Unvisited => 0,
                    VisitState::Unsplit => 1,
                    VisitState::Splits => 2,
                    VisitState::Created => 3,
                };
                spoke.age = history.age(vertex);
                spoke.valence = vertex_history.valence;
                // Vertices created in this stretch have no coordinates yet, but do not occur in its rings.
                let grid_point = split_context.grid_points.get(vertex as usize).copied().unwrap_or(here);
                spoke.step = std::array::from_fn(|a| grid_point[a].wrapping_sub(here[a]));
                self.magnitudes |= spoke.step.iter().fold(0, |m, s| m | s.unsigned_abs());
                self.states[usize::from(spoke.state & 3)] += 1;
                self.young += usize::from(spoke.age == 1);
                if matches!(state, VisitState::Unsplit | VisitState::Splits) {
                    density += i64::from(vertex_history.density);
                }
            }
            self.spokes.push(spoke);
        }
        let visited_count = self.states[1] + self.states[2];
        self.density = if visited_count == 0 { history.split_share() } else { mean(density, visited_count) };
        self.free_run = self.longest_free_run();
    }

    fn longest_free_run(&self) -> usize {
        if self.free == self.spokes.len() {
            return self.free;
        }
        let (mut longest, mut run, mut first) = (0, 0, None);
        for spoke in &self.spokes {
            if spoke.is_claimed {
                longest = longest.max(run);
                first = first.or(Some(run));
                run = 0;
            } else {
                run += 1;
            }
        }
        // The last run continues in the first one.
        longest.max(run + first.unwrap_or(0))
    }
}
