//! The level for a view, from fans.

use super::{FoundLevel, LEAST_PIXELS};
use crate::mesh::IndexedMesh;
use crate::model::{FanFront, FanInstance, FanScene, FanSource, Fans, LodModel as _};
use crate::simplify::StopReason;
use crate::view::ScreenError;

/// Returns the level of fans for a view: see [`Levels::find_for_view`](super::Levels::find_for_view). `source` is what the fans were built
/// from.
///
/// A step is refined if its bounds are inside the frustum and do not all face away, and its error exceeds the tolerance.
/// With a triangle limit, the steps with the largest errors on the screen are refined first.
pub fn fan_level<'m>(
    fans: &Fans,
    source: impl Into<FanSource<'m>>,
    criterion: &ScreenError,
    triangle_limit: Option<usize>,
) -> FoundLevel<IndexedMesh> {
    let source = source.into();
    let scene = &FanScene::new(fans, &source.mesh().positions);
    let (mut relaxation, mut stop_reason) = (1.0, StopReason::TargetReached);
    let instance = match triangle_limit {
        None => {
            let mut instance = FanInstance::full(fans);
            instance.refine(scene, criterion);
            instance
        }
        Some(limit) => {
            let criterion = criterion.clone().at_least(LEAST_PIXELS).with_model_bounds(scene.sphere());
            let mut front = FanFront::new(scene);
            relaxation = f64::from(front.update_to_budget(scene, &criterion, limit).threshold);
            if front.triangle_count() > limit {
                stop_reason = StopReason::BaseReached;
            }
            front.instance().clone()
        }
    };
    // Errors never rise from one step to the next, so the first collapsed step has the largest.
    let coarsest = (0..fans.step_count()).find(|&step| !instance.is_refined(step as u32));
    let error = coarsest.map_or(0.0, |step| source.levels().error_at(step));
    let mesh = instance.level(fans, source);
    let level = FoundLevel::of_mesh(mesh, instance.split_count(), error, stop_reason);
    FoundLevel { relaxation, ..level }
}
