//! `poses`: how well levels of skinned and morphing meshes hold in the poses of their animations.
//!
//! Each mesh is simplified twice: for its poses, and in its bind pose only. Levels of both are measured at
//! times that simplification has not examined: their fractions of the duration are multiples of the golden
//! ratio. The distance is that of each vertex of the full mesh, posed, from the surface of the level in the
//! same pose.

mod measure;
mod report;

use std::time::Instant;

use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::simplify::{SequenceOptions, build_sequence_with_progress};
use striata_command::failure::Failure;
use striata_command::output::{Bar, Output};
use striata_io::{Scene, read_scene};
use striata_scene::{Deformation, ScenePoses};

use self::measure::MeasuredPose;
use self::report::{PosedLevelReport, PosedMeshReport, PosesReport, SceneReport};
use crate::args::PosesArgs;

/// Measures every scene and prints the report.
///
/// # Errors
/// If a scene cannot be read or a mesh cannot be simplified.
pub(crate) fn run(args: &PosesArgs, output: &Output) -> Result<(), Failure> {
    if let Some(share) = args.shares.iter().find(|share| !(0.0..=100.0).contains(*share)) {
        return Err(Failure::user(format!("share {share} is not between 0 and 100")));
    }
    let mut scenes = Vec::new();
    for path in &args.inputs {
        let name = path.display().to_string();
        let mut bar = output.bar();
        bar.phase("read");
        let scene = read_scene(path)?;
        let meshes = measured(&scene, args, &mut bar).map_err(|failure| failure.in_file(&name))?;
        let file_name = path.file_name().map_or(name.clone(), |name| name.to_string_lossy().into_owned());
        scenes.push(SceneReport { name: file_name, meshes });
    }
    let report = PosesReport { times: args.times, scenes };
    output.data(&report, &report.to_text())
}

fn measured(scene: &Scene, args: &PosesArgs, bar: &mut Bar) -> Result<Vec<PosedMeshReport>, Failure> {
    let started = Instant::now();
    let poses = ScenePoses::new(scene).map_err(|error| Failure::user(error.to_string()))?;
    let pose_secs = started.elapsed().as_secs_f64();
    let mut reports = Vec::new();
    for (index, mesh) in scene.meshes().iter().enumerate() {
        let Some(mesh) = mesh else { continue };
        let started = Instant::now();
        let Some(deformation) = Deformation::of(scene, &poses, index, mesh) else { continue };
        let choice_secs = pose_secs + started.elapsed().as_secs_f64();
        let (plain, plain_secs) = timed(|| build(mesh, bar))?;
        let (with_layers, build_secs) = timed(|| {
            let mut mesh = mesh.clone();
            deformation.add_layers(&mut mesh);
            build(&mesh, bar)
        })?;
        let estimated = with_layers.sequence.clone();
        bar.phase("poses");
        let (finished, finish_secs) = timed(|| Ok(deformation.finish(with_layers)))?;
        let mut levels = Vec::new();
        let posed = [&plain, &finished]
            .map(|refinable| MeasuredPose::all(scene, poses.poser(), index, &refinable.mesh, args.times));
        for &percent in &args.shares {
            let triangle_count = (mesh.triangle_count() as f64 * percent / 100.0) as usize;
            let splits =
                |refinable: &RefinableMesh| refinable.sequence.split_count_for_triangles(triangle_count);
            let (bind, held) = (splits(&plain), splits(&finished));
            let error = f64::from(finished.sequence.error_at(held));
            let distances = measure::distances(&finished, held, &posed[1]);
            levels.push(PosedLevelReport {
                percent,
                triangle_count: finished.sequence.triangle_count_at(held),
                bind: measure::distances(&plain, bind, &posed[0]),
                bind_error: f64::from(plain.sequence.error_at(bind)),
                distances,
                estimated_error: f64::from(estimated.error_at(held)),
                error,
                is_held: distances.max <= error,
            });
        }
        reports.push(PosedMeshReport {
            index,
            name: scene.mesh_name(index).to_owned(),
            triangle_count: mesh.triangle_count(),
            vertex_count: mesh.vertex_count(),
            pose_count: posed[1].len(),
            bind_secs: plain_secs,
            secs: choice_secs + build_secs + finish_secs,
            choice_secs,
            finish_secs,
            levels,
        });
    }
    Ok(reports)
}

fn build(mesh: &IndexedMesh, bar: &mut Bar) -> Result<RefinableMesh, Failure> {
    let options = SequenceOptions::default();
    Ok(build_sequence_with_progress(mesh, &options, &mut |progress| bar.show(progress))?.refinable)
}

fn timed<T>(work: impl FnOnce() -> Result<T, Failure>) -> Result<(T, f64), Failure> {
    let started = Instant::now();
    let result = work()?;
    Ok((result, started.elapsed().as_secs_f64()))
}
