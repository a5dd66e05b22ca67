//! `extract --eye` for scenes.

use std::time::Instant;

use striata::simplify::{StopReason, Target};
use striata::view::Camera;
use striata_command::args::ViewArgs;
use striata_command::failure::Failure;
use striata_command::level::{CoarseningLimit, LevelRequest, ReachedLevel, WrittenLevel, check_paths};
use striata_command::output::Output;
use striata_command::save::write_scene;
use striata_command::scene::with_textures;
use striata_io::Scene;
use striata_scene::LodScene;

use super::super::levels_report::{HowMade, MadeLevel, MadeLevels, text_of};
use crate::args::ExtractArgs;

/// Smallest pixel tolerance used with a triangle limit, so that tolerances can be multiplied.
const LEAST_PIXELS: f64 = 1e-4;

/// Returns the scene for a camera, within a triangle limit if there is one, and the pixels that its least important
/// object may err by.
pub(in crate::commands) fn scene_of_view(
    lods: &LodScene,
    view: &ViewArgs,
    camera: Camera,
    limit: Option<usize>,
) -> (Scene, f64) {
    let least =
        lods.scene().instances().iter().fold(1.0, |least: f64, instance| least.min(instance.importance));
    let Some(limit) = limit else {
        return (lods.view_scene(&view.criterion(camera, 0.0)), view.pixels() / least);
    };
    let (scene, factor) = lods.view_scene_within(&view.criterion(camera, LEAST_PIXELS), limit);
    (scene, view.pixels().max(LEAST_PIXELS) * f64::from(factor) / least)
}

/// Writes the scene for a viewer at a point, and reports.
///
/// # Errors
/// If the camera is degenerate, or the output cannot be written.
pub(super) fn extract_view(
    args: &ExtractArgs,
    lods: &LodScene,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let (Some(eye), [path]) =
        (args.eye.eye, &check_paths(&args.level, &args.levels, &args.output.output)?[..])
    else {
        return Err(Failure::internal("a view has one eye and one output"));
    };
    let bounds = lods.full_scene().bounds();
    let center = bounds.map_or([0.0; 3], |b| [0, 1, 2].map(|i| f32::midpoint(b.min[i], b.max[i])));
    let camera = args.view.camera(eye, center);
    let camera = camera
        .map_err(|error| Failure::user(error.to_string()).with_hint("change --eye, --look-at or --up"))?;
    let limit = args.level.triangle_count().map(|count| count.of_triangles(lods.triangle_count()));
    let (scene, pixels) = scene_of_view(lods, &args.view, camera, limit);
    let triangle_count = scene.triangle_count();
    let vertex_count = scene.meshes().iter().flatten().map(|mesh| mesh.vertex_count()).sum();
    let is_above = limit.is_some_and(|limit| triangle_count > limit);
    let stop_reason = if is_above { StopReason::BaseReached } else { StopReason::TargetReached };
    let reached = ReachedLevel { vertex_count, triangle_count, stop_reason };
    let request = LevelRequest { name: None, target: limit.map(Target::Triangles), path: path.clone() };
    let written = WrittenLevel::new(&request, reached, &CoarseningLimit::File);
    written.check_strict(args.strict)?;
    let scene = with_textures(scene, args.textures.options().as_ref(), output)?;
    write_scene(&scene, true, path, &args.output.format, output)?;
    let level = MadeLevel { pixels: Some(pixels), ..written.into() };
    let how = HowMade {
        error_is_guaranteed: lods.has_guaranteed_errors(),
        secs: started.elapsed().as_secs_f64(),
        ..HowMade::default()
    };
    let report = MadeLevels::One { level, common: how };
    output.summary(&report, &text_of(&report, lods.triangle_count(), None))
}
