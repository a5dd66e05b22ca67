//! Integer bounds of all steps of a table, for refinement without any history.

use std::ops::Range;

use super::super::{FanInstance, FanSource, Fans};
use crate::mesh::IndexedMesh;
use crate::view::{BoxGrid, GridCamera, StepBox};

/// Number of steps that are skipped together.
const RANGE: usize = 32;

/// For each step of a table, a [`StepBox`] that encloses what the step changes and the boxes of all steps that depend
/// on it. The steps that a camera wants are therefore a valid set by themselves, so each step can be evaluated alone,
/// in any order and on any processor.
///
/// Takes 24 bytes per step, shared by all instances; an instance is one bit per step.
#[derive(Clone, Debug, PartialEq)]
pub struct FanBoxes {
    grid: BoxGrid,
    boxes: Vec<StepBox>,
    /// The largest error of each range of 32 steps and of all steps after it.
    range_errors: Vec<u32>,
    whole: StepBox,
}

impl FanBoxes {
    /// Computes the boxes of a table; `source` is what it was built from.
    ///
    /// # Panics
    /// If the table belongs to a different mesh.
    pub fn new<'m>(fans: &Fans, source: impl Into<FanSource<'m>>) -> Self {
        let source = source.into();
        let positions = &source.mesh().positions;
        assert_eq!(fans.vertex_count(), positions.len(), "the table belongs to a different mesh");
        let grid = BoxGrid::new(positions);
        let mut boxes = vec![StepBox::EMPTY; fans.step_count];
        let mut changed = Vec::new();
        // Steps that need this one are finer, so they have been added to it by now.
        for step in (0..fans.step_count as u32).rev() {
            changed.clear();
            source.triangles_changed_by(fans, step, &mut changed);
            let mut part = boxes[step as usize].with_point(&grid, positions[fans.center_vertex(step)]);
            for corners in changed.iter().map(|triangle| triangle.map(|v| positions[v as usize])) {
                part = corners.iter().fold(part, |part, &corner| part.with_point(&grid, corner));
                part = part.with_normal_of(&corners);
            }
            part = part.with_error(&grid, source.step_error(step as usize));
            part.added = fans.added.of(step) as i32;
            boxes[step as usize] = part;
            fans.for_each_needed_by_split(step, |needed| {
                boxes[needed as usize] = boxes[needed as usize].with_box(&part);
            });
        }
        let range_errors = range_errors(&boxes);
        let whole = whole_box(&grid, source.mesh());
        Self { grid, boxes, range_errors, whole }
    }

    /// The grid of the boxes, on which cameras are placed.
    pub fn grid(&self) -> &BoxGrid {
        &self.grid
    }

    /// The boxes of all steps.
    pub fn boxes(&self) -> &[StepBox] {
        &self.boxes
    }

    /// The largest error of each range of 32 steps and all steps after it, as [`StepBox::error_log`].
    pub fn range_errors(&self) -> &[u32] {
        &self.range_errors
    }

    /// Contains the whole mesh, with any normals and the largest error of all steps. It weighs at least as much as
    /// every step.
    pub fn whole(&self) -> StepBox {
        self.whole.with_log(self.range_errors.first().copied().unwrap_or(0))
    }

    /// Returns the steps that a camera may want: none of the steps after them has a weight above the threshold.
    pub fn candidates(&self, camera: &GridCamera, threshold: i32) -> Range<usize> {
        let is_wanted = |&error: &u32| camera.weigh(&self.whole.with_log(error)) > threshold;
        let ranges = self.range_errors.partition_point(is_wanted);
        0..(RANGE * ranges).min(self.boxes.len())
    }

    /// Returns the instance whose refined steps are those with a weight above a threshold: 0 for the tolerance of the
    /// camera, 1,024 more for each doubling of the tolerance.
    pub fn instance(&self, fans: &Fans, camera: &GridCamera, threshold: i32) -> FanInstance {
        let mut instance = FanInstance::uniform(fans, 0);
        for step in self.candidates(camera, threshold) {
            if camera.weigh(&self.boxes[step]) > threshold {
                instance.collapsed.remove(step as u32);
            }
        }
        instance
    }

    /// Size in memory, bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.boxes[..]) + size_of_val(&self.range_errors[..])
    }
}

/// The largest error of each range of steps and of all steps after it.
fn range_errors(boxes: &[StepBox]) -> Vec<u32> {
    let ranges = boxes.chunks(RANGE);
    let largest = ranges.map(|range| range.iter().map(|part| u32::from(part.error_log())).max().unwrap_or(0));
    let mut errors: Vec<u32> = largest.collect();
    let mut above = 0;
    for error in errors.iter_mut().rev() {
        above = above.max(*error);
        *error = above;
    }
    errors
}

/// Contains all positions and all normals.
fn whole_box(grid: &BoxGrid, mesh: &IndexedMesh) -> StepBox {
    mesh.positions
        .iter()
        .fold(StepBox::EMPTY.with_all_normals(), |part, &position| part.with_point(grid, position))
}

impl FanInstance {
    /// Whether all steps that a refined step needs are refined, so that the instance shows a level without cracks.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn is_valid(&self, fans: &Fans) -> bool {
        self.check_table(fans);
        let mut is_valid = true;
        for step in (0..self.step_count as u32).filter(|&step| self.is_refined(step)) {
            fans.for_each_needed_by_split(step, |needed| is_valid &= self.is_refined(needed));
        }
        is_valid
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{IndexedMesh, Random, RefinableMesh, shapes};
    use crate::simplify::build_sequence;
    use crate::view::{Camera, ScreenError};

    const PLACED: [f64; 16] =
        [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

    fn refinable(mesh: &IndexedMesh) -> RefinableMesh {
        build_sequence(mesh, &Default::default()).unwrap().refinable
    }

    fn criterion(random: &mut Random, mesh: &IndexedMesh) -> ScreenError {
        let bounds = mesh.bounds().unwrap();
        let point = |random: &mut Random, spread: f32| {
            [0, 1, 2].map(|axis| {
                let [low, high] = [bounds.min[axis], bounds.max[axis]];
                let half = (high - low) / 2.0 + 1e-3;
                (low + high) / 2.0 + random.between(-spread, spread) * half
            })
        };
        loop {
            let spread = [1.5, 4.0, 30.0][random.below(3) as usize];
            let (eye, target) = (point(random, spread), point(random, 1.0));
            let tan = 0.1 + random.unit();
            if let Ok(camera) = Camera::new(eye, target, [0.3, 0.2, 0.9], tan, [1920, 1080]) {
                return ScreenError::new(camera, [0.3, 1.0, 5.0][random.below(3) as usize]);
            }
        }
    }

    #[test]
    fn the_steps_that_a_camera_wants_are_a_valid_set_at_any_threshold() {
        let mut random = Random::new(31);
        let (mut mixed, mut skipped) = (0, 0);
        let meshes = [
            shapes::terrain(30, 2),
            shapes::icosphere(4, 1.0),
            shapes::uv_cylinder(24, 9),
            shapes::moebius_strip(80),
            shapes::two_material_sphere(12, 18),
            shapes::random_soup(90, 4),
        ];
        for mesh in meshes {
            let refinable = refinable(&mesh);
            let fans = Fans::build_without_bounds(&refinable);
            let boxes = FanBoxes::new(&fans, &refinable);
            for _ in 0..60 {
                let criterion = criterion(&mut random, &mesh);
                let camera = GridCamera::new(&criterion, &PLACED, boxes.grid()).unwrap();
                for threshold in [0, 300, 2500] {
                    let instance = boxes.instance(&fans, &camera, threshold);
                    assert!(instance.is_valid(&fans), "{camera:?}");
                    let refined = instance.split_count();
                    mixed += usize::from(refined > 0 && refined < fans.step_count);
                    let all = boxes.boxes().iter().filter(|part| camera.weigh(part) > threshold).count();
                    assert_eq!(refined, all, "a skipped step is wanted");
                    skipped += usize::from(boxes.candidates(&camera, threshold).len() < fans.step_count);
                }
            }
        }
        assert!(mixed > 100 && skipped > 100, "{mixed} mixed, {skipped} skipped");
    }

    #[test]
    fn instances_with_a_missing_step_are_not_valid() {
        let refinable = refinable(&shapes::terrain(12, 2));
        let fans = Fans::build_without_bounds(&refinable);
        let mut instance = FanInstance::full(&fans);
        assert!(instance.is_valid(&fans));
        instance.collapsed.insert(0);
        assert!(!instance.is_valid(&fans));
    }
}
