//! Bounds of each step for view criteria: a sphere, a normal cone and an error, in eight bytes.
//!
//! A step changes the surface covered by its star and its floor. Its bounds enclose both, and the bounds
//! of its descendants in the tree, each of which needs its parent \[Hop97\]. So if the bounds of a step
//! are invisible, all of its descendants are too, and a walk down the tree finds every step that a view
//! wants. Steps outside this subtree that a descendant also needs are split along with it. Nesting the
//! bounds over all dependencies would make that unnecessary, but the bounds become so wide that a view
//! shows a third more triangles. Including the normals of the full mesh below the star in the cones was
//! tried too: 2 % more triangles without a smaller screen error.
//!
//! The center of a sphere is the position of its step, which is stored anyway. For the packing of a record
//! see `part_record.rs`.

use super::Fans;
use crate::mesh::{CollapseSequence, RefinableMesh};
use crate::model::part_record::{Bounded, NO_STEP};
use crate::model::step_bounds::StepBounds;
use crate::{Cancelled, ProgressFn};

impl StepBounds {
    /// Computes the bounds of a table's steps.
    ///
    /// # Errors
    /// [`Cancelled`] if the callback cancels.
    pub(super) fn of_fans(
        fans: &Fans,
        refinable: &RefinableMesh,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, Cancelled> {
        Self::build(&mut FanSteps { fans, refinable, triangles: Vec::new() }, progress)
    }
}

/// Adapter that provides the steps of a table for bounding.
struct FanSteps<'a> {
    fans: &'a Fans,
    refinable: &'a RefinableMesh,
    triangles: Vec<[u32; 3]>,
}

impl Bounded for FanSteps<'_> {
    fn parents(&self) -> Vec<u32> {
        let mut parents = vec![NO_STEP; self.fans.step_count];
        for step in 0..parents.len() as u32 {
            self.fans.for_each_child(Some(step), |child| parents[child as usize] = step);
        }
        parents
    }

    fn center(&self, step: u32) -> [f32; 3] {
        self.refinable.mesh.positions[self.fans.center_vertex(step)]
    }

    fn changed_into(&mut self, step: u32, out: &mut Vec<[[f32; 3]; 3]>) {
        self.triangles.clear();
        self.fans.triangles_changed_by(step, &self.refinable.sequence, &mut self.triangles);
        out.extend(self.triangles.iter().map(|t| t.map(|v| self.refinable.mesh.positions[v as usize])));
    }

    fn error(&self, step: u32) -> f32 {
        self.refinable.sequence.error_at(step as usize)
    }
}

impl Fans {
    /// Returns the vertex whose position is the center of a step's sphere.
    #[inline]
    pub(super) fn center_vertex(&self, step: u32) -> usize {
        self.vertices.of_step(step as usize).start as usize
    }

    /// Appends the star that a step removes and the floor that it creates.
    fn triangles_changed_by(&self, step: u32, sequence: &CollapseSequence, out: &mut Vec<[u32; 3]>) {
        let vertices = self.vertices.of_step(step as usize);
        let mut indices = Vec::new();
        for vertex in vertices.clone() {
            for fan in self.step_entry(vertex, step) {
                fan.triangles_into(fan.mask(|_| true), &mut indices);
            }
        }
        for &star in indices.as_chunks().0 {
            let floor = star.map(|v| if vertices.contains(&v) { sequence.target(v) } else { v });
            out.extend([star, floor]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::FanScene;
    use crate::model::part_record::direction;
    use crate::view::NormalCone;

    fn terrain() -> RefinableMesh {
        let mesh = crate::mesh::shapes::terrain(24, 5);
        let options = crate::simplify::SequenceOptions::default();
        crate::simplify::build_sequence(&mesh, &options).unwrap().refinable
    }

    #[test]
    fn bounds_hold_what_their_step_changes() {
        let refinable = terrain();
        let fans = Fans::build(&refinable);
        let scene = FanScene::new(&fans, &refinable);
        let positions = &refinable.mesh.positions;
        let mut changed = Vec::new();
        for step in 0..fans.step_count as u32 {
            let part = scene.part(step);
            assert!(part.error >= refinable.sequence.error_at(step as usize));
            changed.clear();
            fans.triangles_changed_by(step, &refinable.sequence, &mut changed);
            assert!(!changed.is_empty());
            for corners in changed.iter().map(|t| t.map(|v| positions[v as usize])) {
                assert!(
                    corners.iter().all(|&p| part.sphere.contains(p)),
                    "step {step}: {corners:?} in {part:?}"
                );
                let cone = NormalCone::of_triangles([corners].into_iter());
                // A degenerate triangle has no normal.
                assert!(
                    cone == NormalCone::ALL || part.cone.contains(cone.axis),
                    "step {step}: {cone:?} in {part:?}"
                );
            }
        }
    }

    #[test]
    fn every_step_is_below_one_that_it_needs_and_within_its_bounds() {
        let refinable = terrain();
        let fans = Fans::build(&refinable);
        let scene = FanScene::new(&fans, &refinable);
        let part = |step| scene.part(step);
        let mut parents = vec![0; fans.step_count];
        fans.for_each_child(None, |child| parents[child as usize] += 1);
        for step in 0..fans.step_count as u32 {
            let whole = part(step);
            fans.for_each_child(Some(step), |child| {
                parents[child as usize] += 1;
                let inner = part(child);
                assert!(whole.sphere.with_sphere(&inner.sphere).radius <= whole.sphere.radius * 1.0001);
                let axis = |cone: NormalCone| NormalCone::around(direction(cone.axis).to_array());
                let around =
                    axis(whole.cone).with_cone(&NormalCone { axis: axis(inner.cone).axis, ..inner.cone });
                assert!(whole.cone.cos <= around.cos + 1e-4, "{whole:?} around {inner:?}");
                assert!(whole.error >= inner.error);
                let mut is_needed = false;
                fans.for_each_needed_by_split(child, |needed| is_needed |= needed == step);
                assert!(is_needed, "step {child} is below {step}");
            });
        }
        assert!(parents.iter().all(|&count| count == 1));
    }
}
