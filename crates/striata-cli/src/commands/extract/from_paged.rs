//! `extract` from a paged file: reads the pages that the levels need, and no others.

use std::time::Instant;

use striata::mesh::replay;
use striata::model::ModelKind;
use striata::view::DetailBox;
use striata_paged::{PagedFile, ViewCut};

use super::fan_view::{MIN_PIXELS, ViewLevel};
use super::level_output::{no_level, primitives_of, view_output_path};
use super::report::{ExtractedList, LevelMesh, PagesRead, Report, report_levels};
use crate::args::ExtractArgs;
use crate::commands::paged::{camera_of, failure_of};
use crate::strip_lists::without_unused_vertices;
use striata_command::args::{AxisAlignedBox, Point};
use striata_command::failure::Failure;
use striata_command::level::{FullMesh, level_requests};
use striata_command::output::Output;
use striata_command::save::{LevelFiles, write_mesh};

/// Extracts levels of a paged file.
///
/// # Errors
/// If the file is damaged, or an output cannot be written.
pub(super) fn run(args: &ExtractArgs, started: Instant, output: &Output) -> Result<(), Failure> {
    if let Some(name) = &args.model {
        return Err(Failure::user(format!("--model {name}: paged files have no models"))
            .with_hint("remove --model; levels, views and boxes are made from the pages"));
    }
    let mut file = PagedFile::open(&args.input.to_string_lossy()).map_err(failure_of)?;
    if let Some(eye) = args.eye.eye {
        return run_view(args, eye, &mut file, started, output);
    }
    if let Some(corners) = args.detail_box {
        return run_box(args, corners, &mut file, started, output);
    }
    let metadata = file.metadata();
    let full = FullMesh {
        diagonal: metadata.diagonal(),
        vertex_count: metadata.vertex_count as usize,
        triangle_count: metadata.triangle_count as usize,
    };
    let requests = level_requests(&args.level, &args.levels, full, &args.output.output)?;
    let targets = requests.iter().map(|request| request.target.ok_or_else(no_level));
    let targets = targets.collect::<Result<Vec<_>, _>>()?;
    let assembled = file.levels_for(&targets).map_err(failure_of)?;
    let sequence = &assembled.refinable.sequence;
    let mut files = LevelFiles::new(&args.output.format, args.levels.levels.is_some(), output);
    let mut reports = Vec::new();
    for (request, target) in requests.iter().zip(targets) {
        let (split_count, stop_reason) = target.resolve(sequence);
        let level = replay(&assembled.refinable, split_count);
        let corners = level.triangles.as_flattened().iter();
        let shown: Vec<u32> = corners.map(|&v| assembled.page_of_vertex[v as usize]).collect();
        let pages = pages_read(&file, &shown, sequence.step_count());
        let level = without_unused_vertices(level, None).0;
        let shown = LevelMesh { mesh: &level, split_count, stop_reason };
        let secs = started.elapsed().as_secs_f64();
        let report = Report::of_level(ModelKind::Fans, request, shown, [secs, secs])
            .with_error(sequence.error_at(split_count).max(file.unread_error()));
        let report = Report { pages: Some(pages), ..report };
        report.written.check_strict(args.strict)?;
        files.write(&level, primitives_of(args.form, &level, None)?, &request.path)?;
        reports.push(report);
    }
    files.commit()?;
    let common = ExtractedList { step_count: sequence.step_count(), secs: started.elapsed().as_secs_f64() };
    report_levels(reports, args.levels.levels.is_some(), common, output)
}

fn run_view(
    args: &ExtractArgs,
    eye: Point,
    file: &mut PagedFile,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let metadata = file.metadata();
    let triangle_limit = args.level.triangle_count();
    let triangle_limit = triangle_limit.map(|count| count.of_triangles(metadata.triangle_count as usize));
    let (view, camera) = camera_of(&args.view, eye, metadata)?;
    let criterion = view.criterion(camera, MIN_PIXELS);
    let found = file.level_for_view(&criterion, triangle_limit).map_err(failure_of)?;
    let pages = pages_read(file, &found.cut.page_of_vertex, found.cut.step_count);
    let level = ViewLevel::of_pages(found, args.view.pixels());
    finish(args, (level, triangle_limit), (pages, started), output)
}

fn run_box(
    args: &ExtractArgs,
    corners: AxisAlignedBox,
    file: &mut PagedFile,
    started: Instant,
    output: &Output,
) -> Result<(), Failure> {
    let diagonal = file.metadata().diagonal();
    let error_outside = args.level.error.map_or(f32::INFINITY, |error| error.in_units(diagonal) as f32);
    let [min, max] = corners.relative_to(file.metadata().origin);
    let criterion = DetailBox { min, max, error_outside };
    let cut = file.level_for(&criterion).map_err(failure_of)?;
    let pages = pages_read(file, &cut.page_of_vertex, cut.step_count);
    let level = ViewLevel::of_pages(ViewCut { cut, relaxation: 1.0, is_within_limit: true }, 0.0);
    finish(args, (level, None), (pages, started), output)
}

/// Writes the level for a view or a box, and reports it.
fn finish(
    args: &ExtractArgs,
    (level, triangle_limit): (ViewLevel, Option<usize>),
    (pages, started): (PagesRead, Instant),
    output: &Output,
) -> Result<(), Failure> {
    let report = Report::of_view_or_box(ModelKind::Fans, args, &level, triangle_limit, started)?;
    let primitives = primitives_of(args.form, &level.mesh, None)?;
    write_mesh(&level.mesh, primitives, &view_output_path(args)?, &args.output.format, output)?;
    let pixels = args.eye.eye.is_some().then_some(level.pixels);
    let report = Report { pages: Some(pages), pixels, ..report };
    output.summary(&report, &report.to_text(pages.step_count))
}

/// Returns the numbers of pages that were read, and that the vertices of a level come from.
fn pages_read(file: &PagedFile, page_of_vertex: &[u32], step_count: usize) -> PagesRead {
    let mut is_shown = vec![false; file.reader().page_count() as usize];
    for &page in page_of_vertex {
        is_shown[page as usize] = true;
    }
    let statistics = file.statistics();
    PagesRead {
        page_count: file.reader().page_count(),
        read: statistics.page_count,
        shown: is_shown.into_iter().filter(|&is_shown| is_shown).count(),
        bytes: statistics.byte_count,
        step_count,
    }
}
