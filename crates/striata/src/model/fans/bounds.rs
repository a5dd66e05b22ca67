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

mod boxes;

pub use boxes::FanBoxes;

use glam::DVec3;

use super::{BoundScope, FanSource, Fans};
use crate::model::part_record::{Bounded, NO_STEP, PartRecord, direction};
use crate::model::step_bounds::StepBounds;
use crate::view::{NormalCone, Part, Sphere};
use crate::{Cancelled, Progress, ProgressFn};

/// Number of steps between two calls of the progress callback.
const STEPS_PER_REPORT: usize = 1 << 12;

impl StepBounds {
    /// Computes the bounds of a table's steps.
    ///
    /// # Errors
    /// [`Cancelled`] if the callback cancels.
    pub(super) fn of_fans(
        fans: &Fans,
        source: FanSource<'_>,
        scope: BoundScope,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, Cancelled> {
        let mut steps = FanSteps { fans, source, triangles: Vec::new() };
        match scope {
            BoundScope::Tree => Self::build(&mut steps, progress),
            BoundScope::Dependents => Ok(Self::of_records(bound_dependents(&mut steps, progress)?)),
        }
    }
}

/// Adapter that provides the steps of a table for bounding.
struct FanSteps<'a> {
    fans: &'a Fans,
    source: FanSource<'a>,
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
        self.source.mesh().positions[self.fans.center_vertex(step)]
    }

    fn changed_into(&mut self, step: u32, out: &mut Vec<[[f32; 3]; 3]>) {
        self.triangles.clear();
        self.source.triangles_changed_by(self.fans, step, &mut self.triangles);
        let positions = &self.source.mesh().positions;
        out.extend(self.triangles.iter().map(|t| t.map(|v| positions[v as usize])));
    }

    fn error(&self, step: u32) -> f32 {
        self.source.step_error(step as usize)
    }
}

/// Computes records that enclose, for each step, what it changes and the records of all steps that need it.
///
/// # Errors
/// [`Cancelled`] if the callback cancels.
fn bound_dependents(
    steps: &mut FanSteps<'_>,
    progress: &mut ProgressFn<'_>,
) -> Result<Vec<PartRecord>, Cancelled> {
    let step_count = steps.fans.step_count;
    let dependents = Dependents::of(steps.fans);
    let mut records = vec![PartRecord::default(); step_count];
    let mut changed = Vec::new();
    for step in (0..step_count as u32).rev() {
        if (step as usize).is_multiple_of(STEPS_PER_REPORT) {
            let (done, total) = ((step_count - step as usize) as u64, step_count as u64);
            Progress { phase: "bounds", done, total }.report(progress)?;
        }
        // Steps that need this one are finer, so their bounds are known by now.
        let above = dependents.of_step(step).iter();
        let parts: Vec<Part> =
            above.map(|&other| records[other as usize].part(steps.center(other))).collect();
        changed.clear();
        steps.changed_into(step, &mut changed);
        let own = NormalCone::of_triangles(changed.iter().copied());
        let normals = parts.iter().map(|part| direction(part.cone.axis)).sum::<DVec3>();
        let mut cone = NormalCone::around((direction(own.axis) + normals).to_array()).with_cone(&own);
        let mut sphere = Sphere::point(steps.center(step));
        sphere = changed.iter().flatten().fold(sphere, |sphere, &corner| sphere.with_point(corner));
        let mut error = steps.error(step);
        for part in &parts {
            sphere = sphere.with_sphere(&part.sphere);
            cone = cone.with_cone(&part.cone);
            error = error.max(part.error);
        }
        records[step as usize] = PartRecord::holding(sphere.radius, &cone, error);
    }
    Ok(records)
}

/// The steps that need each step, in flat lists.
struct Dependents {
    firsts: Vec<u32>,
    steps: Vec<u32>,
}

impl Dependents {
    fn of(fans: &Fans) -> Self {
        let mut pairs = Vec::new();
        for step in 0..fans.step_count as u32 {
            fans.for_each_needed_by_split(step, |needed| pairs.push([needed, step]));
        }
        pairs.sort_unstable();
        pairs.dedup();
        let mut firsts = vec![0; fans.step_count + 1];
        pairs.iter().for_each(|pair| firsts[pair[0] as usize + 1] += 1);
        for step in 1..firsts.len() {
            firsts[step] += firsts[step - 1];
        }
        Self { firsts, steps: pairs.iter().map(|pair| pair[1]).collect() }
    }

    fn of_step(&self, step: u32) -> &[u32] {
        &self.steps[self.firsts[step as usize] as usize..self.firsts[step as usize + 1] as usize]
    }
}

impl FanSource<'_> {
    /// Appends the star that a step removes and the floor that it creates.
    fn triangles_changed_by(self, fans: &Fans, step: u32, out: &mut Vec<[u32; 3]>) {
        let sequence = match self {
            Self::Collapses(refinable) => &refinable.sequence,
            Self::Fragments(fragmented) => {
                let fragments = &fragmented.fragments;
                let faces = fragments.ceiling(step).chain(fragments.floor(step).iter().copied());
                return out.extend(faces.map(|face| fragments.faces()[face as usize].corners));
            }
        };
        let vertices = fans.vertices.of_step(step as usize);
        let mut indices = Vec::new();
        for vertex in vertices.clone() {
            for fan in fans.step_entry(vertex, step) {
                fan.triangles_into(fan.mask(|_| true), &mut indices);
            }
        }
        for &star in indices.as_chunks().0 {
            let floor = star.map(|v| if vertices.contains(&v) { sequence.target(v) } else { v });
            out.extend([star, floor]);
        }
    }
}

impl Fans {
    /// Returns the vertex whose position is the center of a step's sphere.
    #[inline]
    pub(super) fn center_vertex(&self, step: u32) -> usize {
        self.vertices.of_step(step as usize).start as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::FanScene;

    fn terrain() -> crate::mesh::RefinableMesh {
        let mesh = crate::mesh::shapes::terrain(24, 5);
        let options = crate::simplify::SequenceOptions::default();
        crate::simplify::build_sequence(&mesh, &options).unwrap().refinable
    }

    #[test]
    fn bounds_hold_what_their_step_changes() {
        let refinable = terrain();
        let fans = Fans::build(&refinable);
        let scene = FanScene::new(&fans, &refinable.mesh.positions);
        let positions = &refinable.mesh.positions;
        let mut changed = Vec::new();
        for step in 0..fans.step_count as u32 {
            let part = scene.part(step);
            assert!(part.error >= refinable.sequence.error_at(step as usize));
            changed.clear();
            FanSource::from(&refinable).triangles_changed_by(&fans, step, &mut changed);
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
        let scene = FanScene::new(&fans, &refinable.mesh.positions);
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
