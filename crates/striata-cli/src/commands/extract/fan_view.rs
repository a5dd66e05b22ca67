//! `extract --eye` with fans: the level for a view, refined as the screen requires.
//!
//! A step is refined if its bounds are inside the frustum and do not all face away, and its error exceeds the
//! pixel tolerance. With a triangle limit, the steps with the largest screen errors are refined first.

use std::time::Instant;

use striata::mesh::IndexedMesh;
use striata::model::{FanFront, FanInstance, FanScene, Fans, LodModel};
use striata::simplify::StopReason;
use striata::view::Camera;

use striata::mesh::Steps;
use striata_command::args::ViewArgs;
use striata_paged::ViewCut;

/// Smallest pixel tolerance used with a triangle limit, so that weights stay finite.
pub(crate) const MIN_PIXELS: f64 = 1e-6;

/// A level for a view or a box.
pub(crate) struct ViewLevel {
    /// The mesh of the level.
    pub mesh: IndexedMesh,
    /// Number of refined steps, that is, of positions in addition to those of the base mesh.
    pub split_count: usize,
    /// Largest error of a collapsed step, mesh units.
    pub error: f32,
    /// The pixel tolerance.
    pub pixels: f64,
    /// Whether the triangle limit was respected.
    pub stop_reason: StopReason,
    /// Time to adapt the model to the level, without building it, seconds.
    pub seek_secs: f64,
}

impl ViewLevel {
    /// The level of a paged file for a view with this pixel tolerance.
    pub(crate) fn of_pages(found: ViewCut, pixels: f64) -> Self {
        let ViewCut { cut, relaxation, is_within_limit } = found;
        let stop_reason = if is_within_limit { StopReason::TargetReached } else { StopReason::BaseReached };
        Self {
            mesh: cut.mesh,
            split_count: cut.refined_count,
            error: cut.error,
            pixels: pixels * f64::from(relaxation),
            stop_reason,
            seek_secs: 0.0,
        }
    }
}

/// Returns the coarsest level within the pixel tolerance or, with a triangle limit, the best-looking level
/// within it.
pub(crate) fn level_of_view(
    fans: &Fans,
    steps: &Steps,
    view: &ViewArgs,
    camera: Camera,
    triangle_limit: Option<usize>,
) -> ViewLevel {
    let scene = &FanScene::new(fans, &steps.mesh().positions);
    let started = Instant::now();
    let (mut pixels, mut stop_reason) = (view.pixels(), StopReason::TargetReached);
    let instance = match triangle_limit {
        None => {
            let mut instance = FanInstance::full(fans);
            instance.refine(scene, &view.criterion(camera, 0.0));
            instance
        }
        Some(limit) => {
            let criterion = view.criterion(camera, MIN_PIXELS).with_model_bounds(scene.sphere());
            let mut front = FanFront::new(scene);
            let update = front.update_to_budget(scene, &criterion, limit);
            pixels = f64::from(criterion.pixels()) * f64::from(update.threshold);
            if front.triangle_count() > limit {
                stop_reason = StopReason::BaseReached;
            }
            front.instance().clone()
        }
    };
    let seek_secs = started.elapsed().as_secs_f64();
    // Errors never rise from one step to the next, so the first collapsed step has the largest.
    let coarsest = (0..fans.step_count()).find(|&step| !instance.is_refined(step as u32));
    ViewLevel {
        mesh: instance.level(fans, steps),
        split_count: instance.split_count(),
        error: coarsest.map_or(0.0, |step| steps.levels().error_at(step)),
        pixels,
        stop_reason,
        seek_secs,
    }
}
