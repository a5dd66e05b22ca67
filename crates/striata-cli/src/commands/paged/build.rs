//! `build` with a paged output: plans, runs all tasks, and removes the work folder.

use std::path::{Path, PathBuf};

use serde::Serialize;
use striata::simplify::{StopReason, Target};
use striata_command::args::{Count, Length};
use striata_command::clock::Phases;
use striata_command::failure::Failure;
use striata_command::level::{CoarseningLimit, ReachedLevel, shortfall};
use striata_command::output::{Output, format_bytes, format_count, format_duration};
use striata_command::save::check_folder;
use striata_command::sequence::StepKind;
use striata_paged::build::{
    BuildInput, BuildOptions, BuildPaths, Limit, PagedBuildError, PagedPlan, WorkLock, is_address,
    remove_work, run_all, threads_for_memory,
};

use super::input::{build_input, build_options, scratch_bytes, work_folder};
use super::{failure, failure_of};
use crate::args::{BaseArgs, BuildArgs, ByteSize, PageBuildArgs};
use crate::commands::build::timings_text;
use striata_paged::PagedFile;

/// Phases whose times are reported.
const PHASES: [&str; 3] = ["plan", "tasks", "finish"];

/// Report of a build: the file, its counts, and the time that it took.
#[derive(Serialize)]
struct PagedBuildReport {
    output: PathBuf,
    bytes: u64,
    triangles: u64,
    base_triangles: u64,
    /// Why the base mesh has more triangles than `--base`; null if it does not.
    shortfall: Option<String>,
    levels: u8,
    pages: u64,
    triangles_per_second: f64,
    #[serde(flatten)]
    phases: Phases,
    resumed: bool,
    /// The place of a terrain on the Earth.
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<serde_json::Value>,
}

/// Builds a paged file from inputs that are one mesh.
///
/// # Errors
/// If an input cannot be read or something cannot be written; what has been completed stays for the next run.
pub(crate) fn build(
    inputs: &[PathBuf],
    build: &BuildArgs,
    path: &Path,
    output: &Output,
) -> Result<(), Failure> {
    let mut phases = Phases::new(&PHASES);
    phases.enter("plan");
    let input = build_input(inputs)?;
    let args = &build.paged;
    let options = sequenced(build_options(&args.cells, output)?, build);
    let folder = work_folder(path, args.work.as_deref());
    let threads = thread_count(args.memory, options.cell);
    // Hours of work lie ahead.
    check_folder(path)?;
    check_input_space(&input, &folder)?;
    let mut lock = WorkLock::claim(&folder).map_err(failure)?;
    if args.restart {
        remove_work(&folder).map_err(failure)?;
        lock = WorkLock::claim(&folder).map_err(failure)?;
    }
    let mut bar = output.bar();
    let known = known_plan(&folder, &input, &options, path)?;
    let resumed = known.is_some();
    let plan = match known {
        Some(plan) => plan,
        None => {
            let made = PagedPlan::make(
                input,
                options,
                BuildPaths { output: path, folder: &folder },
                threads,
                &mut |p| bar.show(p),
            );
            if made.is_err() {
                // The error itself is more important.
                let _ = remove_work(&folder);
            }
            made.map_err(failure)?
        }
    };
    say_remarks(&plan, output)?;
    check_space(&plan)?;
    phases.enter("tasks");
    let run = run_all(&plan, threads, &mut |p| bar.show(p));
    if matches!(run, Err(PagedBuildError::Merging { .. } | PagedBuildError::Base { .. })) {
        // The plan cannot be completed.
        plan.remove_work().map_err(failure)?;
    }
    run.map_err(failure)?;
    drop(bar);
    phases.enter("finish");
    let base_triangles = plan.base_triangle_count().map_err(failure)?;
    plan.remove_work().map_err(failure)?;
    drop(lock);
    phases.leave();
    let seconds = phases.total_secs();
    let triangles = plan.metadata.triangle_count;
    let report = PagedBuildReport {
        output: path.to_owned(),
        bytes: if is_address(path) { size_at_address(path)? } else { size_of_output(path) },
        triangles,
        base_triangles,
        shortfall: shortfall_of(build, triangles, base_triangles),
        levels: plan.level_count(),
        pages: plan.estimate().page_count,
        triangles_per_second: triangles as f64 / seconds,
        phases,
        resumed,
        georeference: plan.metadata.georeference.clone(),
    };
    let shortfall = report.shortfall.as_ref().map(|why| format!("--base was not reached: {why}\n"));
    let text = format!(
        "{}: {} triangles in {} pages of {} levels, {} ({:.2} bytes per triangle)\nbuilt in {}{}\n{}",
        path.display(),
        format_count(triangles as usize),
        format_count(report.pages as usize),
        report.levels,
        format_bytes(report.bytes as usize),
        report.bytes as f64 / triangles as f64,
        format_duration(seconds),
        if resumed { ", going on where an earlier run ended" } else { "" },
        shortfall.unwrap_or_default(),
    );
    output.summary(&report, &(text + &timings_text(build, &report.phases)))
}

/// Builds a paged file that another verb reads, next to which its work folder is.
///
/// # Errors
/// If an input cannot be read or something cannot be written.
pub(crate) fn build_pages(
    inputs: &[PathBuf],
    args: &PageBuildArgs,
    path: &Path,
    output: &Output,
) -> Result<(), Failure> {
    let input = build_input(inputs)?;
    let options = build_options(&args.cells, output)?;
    let folder = work_folder(path, None);
    let threads = thread_count(args.memory, options.cell);
    check_input_space(&input, &folder)?;
    let mut bar = output.bar();
    let paths = BuildPaths { output: path, folder: &folder };
    let plan = PagedPlan::make(input, options, paths, threads, &mut |p| bar.show(p)).map_err(failure)?;
    say_remarks(&plan, output)?;
    check_space(&plan)?;
    run_all(&plan, threads, &mut |p| bar.show(p)).map_err(failure)?;
    plan.remove_work().map_err(failure)
}

/// Says what is remarkable about the input of a plan. Removes the plan if warnings count as errors.
///
/// # Errors
/// A warning that counts as an error.
pub(super) fn say_remarks(plan: &PagedPlan, output: &Output) -> Result<(), Failure> {
    if let Err(refused) = output.warn(&plan.warnings) {
        plan.remove_work().map_err(failure)?;
        return Err(refused);
    }
    plan.notes.iter().for_each(|note| output.say(&format!("note: {note}")));
    Ok(())
}

/// Number of threads that run tasks.
fn thread_count(memory: Option<ByteSize>, cell: usize) -> usize {
    let most = memory.map_or(usize::MAX, |size| threads_for_memory(size.0, cell));
    rayon::current_num_threads().clamp(1, most)
}

/// The options of the cells, with what the user said about the base mesh and the order of collapses.
fn sequenced(options: BuildOptions, build: &BuildArgs) -> BuildOptions {
    let sequence = &build.sequence;
    let weights = sequence.weights.weights();
    BuildOptions {
        normal_weight: weights.normal,
        texcoord_weight: weights.texcoord,
        color_weight: weights.color,
        keep_parts: sequence.keep_parts,
        lock_boundary: sequence.lock_boundary,
        lock_groups: sequence.lock_groups,
        keep_seams: sequence.keep_seams,
        height_field: sequence.keep_height_field.then_some(true),
        ..limited(options, &build.limits)
    }
}

/// The options with limits of the base mesh.
pub(super) fn limited(options: BuildOptions, limits: &BaseArgs) -> BuildOptions {
    BuildOptions {
        base: limits.base.map(|base| match base {
            Count::Number(count) => Limit::Absolute(count as f64),
            Count::Share(share) => Limit::Share(share),
        }),
        max_error: limits.max_error.map(|error| match error {
            Length::Absolute(length) => Limit::Absolute(length),
            Length::OfDiagonal(share) => Limit::Share(share),
        }),
        strict: limits.strict,
        ..options
    }
}

/// Explains why the base mesh has more triangles than requested, if it does.
fn shortfall_of(build: &BuildArgs, triangles: u64, base_triangles: u64) -> Option<String> {
    let base = build.limits.base?.of_triangles(triangles as usize);
    let reached = ReachedLevel {
        vertex_count: 0,
        triangle_count: base_triangles as usize,
        stop_reason: if build.limits.max_error.is_some() {
            StopReason::ErrorLimit
        } else {
            StopReason::BaseReached
        },
    };
    let why = CoarseningLimit::Simplification(build.sequence.describe_limit(StepKind::Single));
    shortfall(Target::Triangles(base), reached, &why)
}

/// The plan of an interrupted build of the same input with the same options.
fn known_plan(
    folder: &Path,
    input: &BuildInput,
    options: &BuildOptions,
    path: &Path,
) -> Result<Option<PagedPlan>, Failure> {
    if !folder.join("plan.json").exists() {
        return Ok(None);
    }
    let plan = PagedPlan::open(folder).map_err(failure)?;
    if (&plan.input, &plan.options, plan.output.as_path()) != (input, options, path) {
        return Err(failure(PagedBuildError::OtherBuild { path: folder.to_owned() }));
    }
    plan.check_inputs().map_err(failure)?;
    Ok(Some(plan))
}

/// Checks that the disks have room for what is missing of the work folder and for the result.
fn check_space(plan: &PagedPlan) -> Result<(), Failure> {
    let estimate = plan.estimate();
    let missing = estimate.work_bytes.saturating_sub(size_of_output(&plan.folder));
    let output = plan.output.parent().filter(|folder| !folder.as_os_str().is_empty());
    let output = output.unwrap_or(Path::new(".")).to_owned();
    if is_address(&plan.output) {
        return check_disk(&plan.folder, missing);
    }
    if is_same_disk(&plan.folder, &output) {
        return check_disk(&plan.folder, missing + estimate.result_bytes);
    }
    check_disk(&plan.folder, missing)?;
    check_disk(&output, estimate.result_bytes)
}

/// Checks that a number of bytes is free.
fn check_disk(folder: &Path, needed: u64) -> Result<(), Failure> {
    match fs4::available_space(folder) {
        Ok(available) if available < needed => {
            Err(failure(PagedBuildError::DiskSpace { path: folder.to_owned(), needed, available }))
        }
        // An unknown size must not stop anybody.
        _ => Ok(()),
    }
}

/// Whether two folders share their free space; if nothing is known, they do.
fn is_same_disk(one: &Path, other: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let device = |path: &Path| std::fs::metadata(path).ok().map(|metadata| metadata.dev());
        device(one) == device(other)
    }
    #[cfg(not(unix))]
    {
        let _ = (one, other);
        true
    }
}

/// Checks that there is room for the temporary copies of text and compressed inputs, before they are read.
fn check_input_space(input: &BuildInput, folder: &Path) -> Result<(), Failure> {
    let BuildInput::Files(paths) = input else { return Ok(()) };
    let needed = paths.iter().map(|path| scratch_bytes(path)).sum();
    let folder = folder.ancestors().find(|folder| folder.is_dir()).unwrap_or(Path::new("."));
    check_disk(folder, needed)
}

/// Size of all pages at an address.
fn size_at_address(path: &Path) -> Result<u64, Failure> {
    let mut file = PagedFile::open(&path.to_string_lossy()).map_err(failure_of)?;
    file.select(|_| true).map_err(failure_of)?;
    Ok(file.reader().entries().map(|(_, entry)| u64::from(entry.byte_count)).sum())
}

/// Size of the result: one file, or all files of a folder.
fn size_of_output(path: &Path) -> u64 {
    let size = |path: &Path| std::fs::metadata(path).map_or(0, |metadata| metadata.len());
    let Ok(files) = std::fs::read_dir(path) else { return size(path) };
    files.flatten().map(|file| size_of_output(&file.path())).sum()
}
