//! `extract --eye`: the level of a view, as fine as the screen asks for and where it does.
//!
//! A step is undone where its bounds can be seen, are not all turned away, and its error takes more pixels than allowed; where
//! there are to be no more than so many triangles, those with the largest errors are.

use std::time::Instant;

use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::model::{FanFront, FanInstance, FanScene, LodModel};
use striata::simplify::StopReason;
use striata::view::Camera;

use striata_command::args::ViewArgs;

/// Errors of fewer pixels than this are no smaller to a budget, so that what weighs them stays a number.
pub(crate) const LEAST_PIXELS: f64 = 1e-6;

/// A level of a view.
pub(crate) struct ViewLevel {
    /// Its mesh.
    pub(crate) mesh: IndexedMesh,
    /// Steps that were undone: positions that it has beside the base's.
    pub(crate) split_count: usize,
    /// The largest error of a step that is still taken, mesh units.
    pub(crate) error: f32,
    /// Pixels that an error may take.
    pub(crate) pixels: f64,
    /// Whether the triangles were enough for that.
    pub(crate) stop_reason: StopReason,
    /// Seconds from the base to the level, without building the table.
    pub(crate) seek_secs: f64,
}

/// The coarsest level that shows no error of more pixels than allowed, or the finest of no more than so many triangles.
pub(crate) fn level_of_view(
    scene: &FanScene<'_>,
    refinable: &RefinableMesh,
    view: &ViewArgs,
    camera: Camera,
    triangle_limit: Option<usize>,
) -> ViewLevel {
    let started = Instant::now();
    let (fans, mut pixels, mut stop_reason) = (scene.fans(), view.pixels(), StopReason::TargetReached);
    let instance = match triangle_limit {
        None => {
            let mut instance = FanInstance::full(fans);
            instance.refine(scene, &view.criterion(camera, 0.0));
            instance
        }
        Some(limit) => {
            let criterion = view.criterion(camera, LEAST_PIXELS).with_model_bounds(scene.sphere());
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
    // Errors fall with the steps, so the first that is taken has the largest.
    let coarsest = (0..fans.step_count()).find(|&step| !instance.is_refined(step as u32));
    ViewLevel {
        mesh: instance.level(fans, refinable),
        split_count: instance.split_count(),
        error: coarsest.map_or(0.0, |step| refinable.sequence.error_at(step)),
        pixels,
        stop_reason,
        seek_secs,
    }
}
