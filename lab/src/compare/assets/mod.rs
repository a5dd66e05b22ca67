//! Compares levels of real assets with those of other simplifiers: distances, normals, texture
//! coordinates, pictures with and without materials, and silhouettes.
//!
//! All contenders get the same welded mesh with the attributes that all of them can weight: normals, one set
//! of texture coordinates, one set of colors. Every level is measured with the same samples and cameras.

mod attribute_distance;
mod contender;
#[cfg(feature = "peers")]
mod error_limits;
mod gallery;
#[cfg(feature = "peers")]
mod gltfpack;
mod levels;
#[cfg(feature = "peers")]
mod meshoptimizer;
mod report;
mod subject;
mod summary;
mod tables;

use std::time::Instant;

use striata::mesh::{IndexedMesh, replay};
use striata::simplify::{
    Placement, SequenceOptions, Simplified, StopReason, build_sequence_with_progress, fit_level,
};

use self::contender::{Level, Request, Simplify};
use self::levels::measure_level;
pub(super) use self::report::AssetsReport;
use self::subject::ComparedAsset;
pub(super) use self::summary::{AssetSummary, summarize};
pub(super) use self::tables::{section, summary_part, summary_text, to_text};
use crate::args::{AssetArgs, AssetContender};
use striata_command::failure::Failure;
use striata_command::output::Bar;

/// Simplifies the mesh with every contender to every share of its triangles, and measures the levels.
///
/// # Errors
/// If the mesh has no triangles or is inconsistent, or temporary files cannot be written.
pub(super) fn measure(
    mesh: &IndexedMesh,
    args: &AssetArgs,
    bar: &mut Bar,
    say: &dyn Fn(&str),
) -> Result<AssetsReport, Failure> {
    let subject = ComparedAsset::new(mesh)?;
    let mut notes = Vec::new();
    let mut contenders: Vec<(AssetContender, Simplify<'_>)> = Vec::new();
    for &contender in &args.contenders {
        say(contender.as_str());
        match prepare(contender, &subject, bar)? {
            Ok(simplify) => contenders.push((contender, simplify)),
            Err(note) if notes.contains(&note) => {}
            Err(note) => notes.push(note),
        }
    }
    let mut levels = Vec::new();
    for &percent in &args.shares {
        let request = Request::new(percent, subject.mesh.triangle_count());
        for (contender, simplify) in &contenders {
            say(&format!("{percent} %, {}", contender.as_str()));
            match simplify(&request) {
                Ok(level) => levels.push(measure_level(&subject, &request, contender.as_str(), level)?),
                Err(why) => notes.push(format!("{} at {percent} %: {why}", contender.as_str())),
            }
        }
    }
    notes.iter().for_each(|note| say(note));
    Ok(AssetsReport {
        triangle_count: subject.mesh.triangle_count(),
        vertex_count: subject.mesh.vertex_count(),
        has_normals: subject.has_normals(),
        has_uvs: subject.has_uvs(),
        notes,
        levels,
    })
}

/// Prepares a contender; the inner error is the reason why it cannot take part.
fn prepare<'a>(
    contender: AssetContender,
    subject: &'a ComparedAsset,
    bar: &mut Bar,
) -> Result<Result<Simplify<'a>, String>, Failure> {
    match contender {
        AssetContender::Striata => Ok(Ok(striata(subject, Placement::Optimal, bar)?)),
        AssetContender::StriataSubset => Ok(Ok(striata(subject, Placement::Subset, bar)?)),
        #[cfg(feature = "peers")]
        AssetContender::Meshoptimizer => Ok(Ok(meshoptimizer::prepare(&subject.mesh, false))),
        #[cfg(feature = "peers")]
        AssetContender::MeshoptimizerPermissive => Ok(Ok(meshoptimizer::prepare(&subject.mesh, true))),
        #[cfg(feature = "peers")]
        AssetContender::Gltfpack => gltfpack::prepare(subject, false),
        #[cfg(feature = "peers")]
        AssetContender::GltfpackSp => gltfpack::prepare(subject, true),
        #[cfg(not(feature = "peers"))]
        _ => {
            Ok(Err("other tools are left out: this command was built without the feature `peers`".to_owned()))
        }
    }
}

/// Takes levels from one sequence with default options; the time of each is that of the whole sequence, and of
/// fitting the level if vertices may move.
fn striata<'a>(
    subject: &'a ComparedAsset,
    placement: Placement,
    bar: &mut Bar,
) -> Result<Simplify<'a>, Failure> {
    let started = Instant::now();
    let options = SequenceOptions::default().with_base_colors(subject.base_colors.clone());
    let built = build_sequence_with_progress(&subject.mesh, &options, &mut |progress| bar.show(progress))?;
    let secs = started.elapsed().as_secs_f64();
    Ok(Box::new(move |request| {
        let sequence = &built.refinable.sequence;
        let split_count = sequence.split_count_for_triangles(request.target_count);
        let started = Instant::now();
        let mut level = Simplified {
            mesh: replay(&built.refinable, split_count),
            error: f64::from(sequence.error_at(split_count)),
            stop_reason: StopReason::TargetReached,
        };
        if placement == Placement::Optimal {
            level = fit_level(&subject.mesh, level, &options).map_err(|error| error.to_string())?;
        }
        let secs = secs + started.elapsed().as_secs_f64();
        Ok(Level { mesh: level.mesh, secs, error: Some(level.error), error_limit: None })
    }))
}
