//! `build` with a paged output: plans, runs all tasks, and removes the work folder.

use std::path::{Path, PathBuf};
use std::time::Instant;

use serde::Serialize;
use striata_command::failure::Failure;
use striata_command::output::{Output, format_bytes, format_count, format_duration};
use striata_paged::build::{
    BuildError, BuildInput, BuildOptions, Plan, remove_work, run_all, threads_for_memory,
};

use super::input::{build_input, build_options, work_folder};
use super::{core_count, failure};
use crate::args::PagedArgs;

/// What was built.
#[derive(Serialize)]
struct Report {
    output: PathBuf,
    bytes: u64,
    triangles: u64,
    levels: u8,
    pages: u64,
    seconds: f64,
    triangles_per_second: f64,
    resumed: bool,
}

/// Builds a paged file from inputs that are one mesh.
///
/// # Errors
/// If an input cannot be read or something cannot be written; what has been completed stays for the next run.
pub(crate) fn build(
    inputs: &[PathBuf],
    (args, path): (&PagedArgs, &Path),
    output: &Output,
) -> Result<(), Failure> {
    let start = Instant::now();
    let input = build_input(inputs)?;
    let options = build_options(&args.cells, output)?;
    let folder = work_folder(path, args.work.as_deref());
    let memory_threads = args.memory.map_or(usize::MAX, |size| threads_for_memory(size.0, options.cell));
    let threads = args.threads.unwrap_or_else(core_count).clamp(1, memory_threads);
    check_output(path)?;
    if args.restart {
        remove_work(&folder).map_err(failure)?;
    }
    let mut bar = output.bar();
    let known = known_plan(&folder, (&input, &options), path)?;
    let resumed = known.is_some();
    let plan = match known {
        Some(plan) => plan,
        None => {
            Plan::make((input, options), path, &folder, (threads, &mut |p| bar.show(p))).map_err(failure)?
        }
    };
    check_space(&plan)?;
    run_all(&plan, threads, &mut |p| bar.show(p)).map_err(failure)?;
    drop(bar);
    plan.remove_work().map_err(failure)?;
    let seconds = start.elapsed().as_secs_f64();
    let triangles = plan.metadata.triangle_count;
    let report = Report {
        output: path.to_owned(),
        bytes: size_of_output(path),
        triangles,
        levels: plan.level_count(),
        pages: plan.estimate().page_count,
        seconds,
        triangles_per_second: triangles as f64 / seconds,
        resumed,
    };
    let text = format!(
        "{}: {} triangles in {} pages of {} levels, {} ({:.2} bytes per triangle)\nbuilt in {}{}\n",
        path.display(),
        format_count(triangles as usize),
        format_count(report.pages as usize),
        report.levels,
        format_bytes(report.bytes as usize),
        report.bytes as f64 / triangles as f64,
        format_duration(seconds),
        if resumed { ", going on where an earlier run ended" } else { "" },
    );
    output.summary(&report, &text)
}

/// The plan of an interrupted build of the same input with the same options.
fn known_plan(
    folder: &Path,
    (input, options): (&BuildInput, &BuildOptions),
    path: &Path,
) -> Result<Option<Plan>, Failure> {
    if !folder.join("plan.json").exists() {
        return Ok(None);
    }
    let plan = Plan::open(folder).map_err(failure)?;
    if (&plan.input, &plan.options, plan.output.as_path()) != (input, options, path) {
        return Err(failure(BuildError::OtherBuild { path: folder.to_owned() }));
    }
    Ok(Some(plan))
}

/// Checks that the folder of the output exists, before hours of work.
fn check_output(path: &Path) -> Result<(), Failure> {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
            Err(Failure::user(format!("{}: the folder {} does not exist", path.display(), folder.display())))
        }
        _ => Ok(()),
    }
}

/// Checks that the disk has room for the work folder and the result.
fn check_space(plan: &Plan) -> Result<(), Failure> {
    let estimate = plan.estimate();
    let needed = estimate.work_bytes + estimate.result_bytes;
    match fs4::available_space(&plan.folder) {
        Ok(available) if available < needed => {
            let path = plan.folder.clone();
            Err(failure(BuildError::DiskSpace { path, needed, available }))
        }
        // An unknown size must not stop anybody.
        _ => Ok(()),
    }
}

/// Size of the result: one file, or all files of a folder.
fn size_of_output(path: &Path) -> u64 {
    let size = |path: &Path| std::fs::metadata(path).map_or(0, |metadata| metadata.len());
    let Ok(files) = std::fs::read_dir(path) else { return size(path) };
    files.flatten().map(|file| size_of_output(&file.path())).sum()
}
