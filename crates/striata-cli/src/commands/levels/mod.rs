//! Levels of any input: found, written and reported in one way.
//!
//! A verb opens a [`LevelSource`] and calls [`write_levels`], [`write_view`] or [`write_box`]. Sources are files, streams,
//! pages ([`sources`]), scenes ([`scenes`]), and meshes that are simplified for the purpose ([`simplified`]).

mod report;
mod scenes;
mod simplified;
mod sources;

pub(super) use self::report::{HowMade, LevelsReport, decoded_text, extracted_text, simplified_text};
pub(super) use self::scenes::{ScenePlacement, SceneSource, chain_format};
pub(super) use self::simplified::SimplifiedMesh;
pub(super) use self::sources::{FileSource, PagedSource, StreamSource};

use std::path::{Path, PathBuf};
use std::time::Instant;

use striata::levels::{FoundLevel, LEAST_PIXELS, Levels};
use striata::mesh::Bounds;
use striata::simplify::Target;
use striata::view::{Camera, DetailBox};

use self::report::{LevelDetails, LevelReport};
use striata_command::args::{
    AxisAlignedBox, FormatArgs, Length, LevelArgs, LevelsArgs, OutputArgs, Point, ViewArgs,
};
use striata_command::failure::Failure;
use striata_command::level::{
    CoarseningLimit, FullMesh, LevelRequest, ReachedLevel, WrittenLevel, check_paths, large_error_warning,
};
use striata_command::output::Output;
use striata_command::save::{LevelFiles, check_place, format_of};

/// A source of levels that the command can write and report.
pub(super) trait LevelSource {
    /// The levels.
    type Source: Levels;

    /// The levels.
    fn levels(&mut self) -> &mut Self::Source;

    /// Says in which file the levels could not be made, and what to do.
    fn failure(&self, error: <Self::Source as Levels>::Error) -> Failure;

    /// Returns why no coarser level exists.
    fn limit(&self) -> CoarseningLimit {
        CoarseningLimit::File
    }

    /// Writes the last level that was found.
    ///
    /// # Errors
    /// If the format of the output cannot represent it, or writing fails.
    fn write(
        &mut self,
        found: &FoundLevel<<Self::Source as Levels>::Shape>,
        files: &mut LevelFiles<'_>,
        path: &Path,
    ) -> Result<(), Failure>;

    /// Adds what only this kind of source reports of the last level that was found.
    fn describe(&mut self, found: &FoundLevel<<Self::Source as Levels>::Shape>, details: &mut LevelDetails);

    /// Writes what belongs to all levels together, and prints notes on the source.
    ///
    /// # Errors
    /// If an output cannot be written.
    fn finish(&mut self, _output: &Output) -> Result<(), Failure> {
        Ok(())
    }
}

/// Levels that were asked for, and how they are written and reported.
pub(super) struct LevelJob<'a> {
    /// The levels in the order of the user, and their files.
    pub requests: Vec<LevelRequest>,
    /// Whether the user asked for a list, even if of one level.
    pub is_list: bool,
    /// The target if none was given.
    pub default_target: Target,
    pub is_strict: bool,
    pub format: &'a FormatArgs,
    /// Error limit of a level without a target.
    pub max_error: Option<Length>,
    /// When the verb began.
    pub started: Instant,
}

/// Returns the sizes that percentages of a target refer to.
///
/// # Errors
/// If the source is damaged.
pub(super) fn full_of<S: LevelSource>(source: &mut S, level: &LevelArgs) -> Result<FullMesh, Failure> {
    let diagonal = match level.error {
        Some(Length::OfDiagonal(_)) => {
            let bounds = source.levels().bounds();
            bounds.map_err(|error| source.failure(error))?.map_or(0.0, |bounds| bounds.diagonal())
        }
        _ => 0.0,
    };
    let facts = source.levels().facts();
    Ok(FullMesh { diagonal, vertex_count: facts.vertex_count, triangle_count: facts.triangle_count })
}

/// Finds and writes levels of uniform detail, and returns the report.
///
/// # Errors
/// If the source is damaged, a level misses its target and must not, or an output cannot be written.
pub(super) fn write_levels<S: LevelSource>(
    source: &mut S,
    job: &LevelJob<'_>,
    output: &Output,
) -> Result<LevelsReport, Failure> {
    let targets: Vec<Target> =
        job.requests.iter().map(|request| request.target.unwrap_or(job.default_target)).collect();
    let preparing = Instant::now();
    source.levels().prepare(&targets).map_err(|error| source.failure(error))?;
    let prepare_secs = preparing.elapsed().as_secs_f64();
    let facts = source.levels().facts();
    let mut files = LevelFiles::new(job.format, job.is_list, output);
    let mut reports = Vec::new();
    for (request, target) in job.requests.iter().zip(targets) {
        let seeking = Instant::now();
        let found = source.levels().find(target).map_err(|error| source.failure(error))?;
        let mut details = LevelDetails {
            split_count: Some(found.split_count),
            step_count: Some(facts.step_count),
            prepare_secs,
            seek_secs: prepare_secs + seeking.elapsed().as_secs_f64(),
            ..LevelDetails::default()
        };
        source.describe(&found, &mut details);
        let mut written = written_level(source, request, &found);
        written.check_strict(job.is_strict)?;
        let limit = match request.target {
            Some(Target::Error(error)) => Some(Length::Absolute(error)),
            Some(_) => None,
            None => job.max_error,
        };
        written.warning = coarseness_warning(source, limit, found.triangle_count)?;
        written.warning.iter().for_each(|warning| output.say(&format!("warning: {warning}")));
        source.write(&found, &mut files, &request.path)?;
        let secs = job.started.elapsed().as_secs_f64();
        reports.push(LevelReport {
            written,
            error_is_guaranteed: facts.has_guaranteed_errors,
            details,
            secs,
        });
    }
    files.commit()?;
    source.finish(output)?;
    LevelsReport::new(reports, job.is_list, job.started.elapsed().as_secs_f64())
}

/// Returns what all verbs report of a level.
fn written_level<S: LevelSource>(
    source: &S,
    request: &LevelRequest,
    found: &FoundLevel<<S::Source as Levels>::Shape>,
) -> WrittenLevel {
    let &FoundLevel { vertex_count, triangle_count, stop_reason, error, .. } = found;
    let reached = ReachedLevel { vertex_count, triangle_count, stop_reason };
    WrittenLevel { error, ..WrittenLevel::new(request, reached, &source.limit()) }.with_short_error()
}

/// Warns if an error limit is so large that it leaves almost nothing: the user may have meant another unit.
///
/// # Errors
/// If the source is damaged.
fn coarseness_warning<S: LevelSource>(
    source: &mut S,
    limit: Option<Length>,
    triangle_count: usize,
) -> Result<Option<String>, Failure> {
    let full_count = source.levels().facts().triangle_count;
    let Some(limit) = limit.filter(|_| triangle_count.saturating_mul(100) < full_count) else {
        return Ok(None);
    };
    let bounds = source.levels().bounds().map_err(|error| source.failure(error))?;
    let diagonal = bounds.map_or(0.0, |bounds| bounds.diagonal());
    Ok(large_error_warning(limit.in_units(diagonal) / diagonal, triangle_count, full_count))
}

/// A level of varying detail that was asked for.
pub(super) struct VaryingJob<'a> {
    pub level: &'a LevelArgs,
    pub levels: &'a LevelsArgs,
    pub output: &'a OutputArgs,
    pub is_strict: bool,
    /// When the verb began.
    pub started: Instant,
}

impl VaryingJob<'_> {
    /// Returns the largest number of triangles, if it is limited.
    fn triangle_limit(&self, full_count: usize) -> Option<usize> {
        self.level.triangle_count().map(|count| count.of_triangles(full_count))
    }

    /// Returns the only output.
    ///
    /// # Errors
    /// If the path has a placeholder for a level and there is no level to fill it.
    fn path(&self) -> Result<PathBuf, Failure> {
        let paths = check_paths(self.level, self.levels, self.output.path())?;
        paths.into_iter().next().ok_or_else(|| Failure::internal("no level was given"))
    }
}

/// Returns the camera of a view of something with these bounds and this origin; it looks at the middle by default.
///
/// # Errors
/// If the flags of the view do not define a camera.
pub(super) fn camera(
    view: &ViewArgs,
    eye: Point,
    origin: [f64; 3],
    bounds: Option<Bounds>,
) -> Result<Camera, Failure> {
    let center = bounds.map_or([0.0; 3], |b| [0, 1, 2].map(|axis| f32::midpoint(b.min[axis], b.max[axis])));
    let camera = view.relative_to(origin).camera(eye.relative_to(origin), center);
    camera.map_err(|error| Failure::user(error.to_string()).with_hint("change --eye, --look-at or --up"))
}

/// Finds and writes the level for a view from a point, and returns the report.
///
/// # Errors
/// If the camera is degenerate, the source is damaged, or the output cannot be written.
pub(super) fn write_view<S: LevelSource>(
    source: &mut S,
    job: &VaryingJob<'_>,
    eye: Point,
    view: &ViewArgs,
    output: &Output,
) -> Result<LevelsReport, Failure> {
    let bounds = source.levels().bounds().map_err(|error| source.failure(error))?;
    let facts = source.levels().facts();
    let camera = camera(view, eye, facts.origin, bounds)?;
    let view = view.relative_to(facts.origin);
    let limit = job.triangle_limit(facts.triangle_count);
    let seeking = Instant::now();
    let found = source.levels().find_for_view(&view.criterion(camera), limit);
    let found = found.map_err(|error| source.failure(error))?;
    let details = LevelDetails {
        pixels: Some(pixels_of(&view, limit, found.relaxation)),
        seek_secs: seeking.elapsed().as_secs_f64(),
        ..LevelDetails::default()
    };
    write_varying(source, job, &found, details, output)
}

/// Returns the tolerance of a view after it was relaxed to respect a triangle limit.
pub(super) fn pixels_of(view: &ViewArgs, triangle_limit: Option<usize>, relaxation: f64) -> f64 {
    let least = if triangle_limit.is_some() { f64::from(LEAST_PIXELS) } else { 0.0 };
    view.pixels().max(least) * relaxation
}

/// Finds and writes the level with full detail in a box, and returns the report.
///
/// # Errors
/// If the source has no such levels or is damaged, or the output cannot be written.
pub(super) fn write_box<S: LevelSource>(
    source: &mut S,
    job: &VaryingJob<'_>,
    corners: AxisAlignedBox,
    output: &Output,
) -> Result<LevelsReport, Failure> {
    let full = full_of(source, job.level)?;
    let limit = job.triangle_limit(full.triangle_count);
    let [min, max] = corners.relative_to(source.levels().facts().origin);
    let error_outside = job.level.error.map_or(f32::INFINITY, |error| error.in_units(full.diagonal) as f32);
    let seeking = Instant::now();
    let found = source.levels().find_for_box(&DetailBox { min, max, error_outside }, limit);
    let found = found.map_err(|error| source.failure(error))?;
    let found = found.ok_or_else(|| Failure::internal("this input has no levels for boxes"))?;
    let details = LevelDetails { seek_secs: seeking.elapsed().as_secs_f64(), ..LevelDetails::default() };
    write_varying(source, job, &found, details, output)
}

fn write_varying<S: LevelSource>(
    source: &mut S,
    job: &VaryingJob<'_>,
    found: &FoundLevel<<S::Source as Levels>::Shape>,
    mut details: LevelDetails,
    output: &Output,
) -> Result<LevelsReport, Failure> {
    let facts = source.levels().facts();
    let limit = job.triangle_limit(facts.triangle_count);
    let request = LevelRequest { name: None, target: limit.map(Target::Triangles), path: job.path()? };
    details.is_varying = true;
    (details.split_count, details.step_count) = (Some(found.split_count), Some(facts.step_count));
    source.describe(found, &mut details);
    let written = written_level(source, &request, found);
    written.check_strict(job.is_strict)?;
    let mut files = LevelFiles::new(&job.output.format, false, output);
    source.write(found, &mut files, &request.path)?;
    files.commit()?;
    source.finish(output)?;
    let error_is_guaranteed = details.has_guaranteed_views && facts.has_guaranteed_errors;
    let secs = job.started.elapsed().as_secs_f64();
    LevelsReport::new(vec![LevelReport { written, error_is_guaranteed, details, secs }], false, secs)
}

/// Checks output names before the work begins.
///
/// # Errors
/// If a name or its format does not suit the levels.
pub(super) fn check_outputs(
    level: &LevelArgs,
    levels: &LevelsArgs,
    output: &OutputArgs,
) -> Result<(), Failure> {
    let (output, format) = (output.path(), &output.format);
    if levels.lod_chain && levels.levels.is_none() {
        return Err(Failure::usage("--lod-chain was given without --levels")
            .with_hint("name the coarser levels: --levels 50%,10% --lod-chain"));
    }
    if levels.lod_chain && output.to_string_lossy().contains("{}") {
        let message = format!("{}: --lod-chain writes all levels to one file", output.display());
        return Err(Failure::usage(message).with_hint("remove {} from the name"));
    }
    for path in check_paths(level, levels, output)? {
        format_of(&path, format)?;
        check_place(&path)?;
    }
    if levels.lod_chain {
        chain_format(output, format)?;
    }
    Ok(())
}
