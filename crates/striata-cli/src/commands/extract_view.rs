//! `extract --eye`: the level of a view, as fine as the screen asks for and where it does.
//!
//! The fans are built from the sequence of the file; a step is undone where its bounds can be seen, are not all turned away,
//! and its error takes more pixels than allowed.

use std::time::Instant;

use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::model::{FanBounds, FanInstance, FanScene, Fans, LodModel};
use striata::view::{Camera, ScreenError};

/// A level of a view.
pub(crate) struct ViewLevel {
    /// Its mesh.
    pub(crate) mesh: IndexedMesh,
    /// Steps that were undone.
    pub(crate) split_count: usize,
    /// The largest error of a step that is still taken, mesh units.
    pub(crate) error: f32,
    /// Seconds from the base to the level, without building the table.
    pub(crate) seek_secs: f64,
}

/// The coarsest level that shows no error of more pixels than allowed.
pub(crate) fn level_of_view(refinable: &RefinableMesh, camera: Camera, pixels: f64) -> ViewLevel {
    let fans = Fans::build(refinable);
    let bounds = FanBounds::build(&fans, refinable);
    let started = Instant::now();
    let mut instance = FanInstance::full(&fans);
    let criterion = ScreenError::new(camera, pixels as f32);
    instance.refine(&FanScene::new(&fans, &bounds, refinable), &criterion);
    let seek_secs = started.elapsed().as_secs_f64();
    // Errors fall with the steps, so the first that is taken has the largest.
    let coarsest = (0..fans.step_count()).find(|&step| instance.is_taken(step as u32));
    ViewLevel {
        mesh: instance.level(&fans, refinable),
        split_count: fans.step_count() - instance.taken_count(),
        error: coarsest.map_or(0.0, |step| refinable.sequence.error_at(step)),
        seek_secs,
    }
}
