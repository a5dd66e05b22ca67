//! `plan`: reads the input once and writes the tasks of its build.

use std::path::PathBuf;

use serde::Serialize;
use striata_command::failure::Failure;
use striata_command::output::{Output, Table, format_bytes, format_count};
use striata_paged::build::{Plan, Stage};

use super::input::{build_input, build_options, work_folder};
use super::{core_count, failure};
use crate::args::PlanArgs;

/// Triangles that one core builds per second, measured on terrains; see docs/results/scale.md.
const TRIANGLES_PER_SECOND: f64 = 500_000.0;

#[derive(Serialize)]
struct Report {
    plan: PathBuf,
    triangles: u64,
    tasks: usize,
    stages: Vec<Stage>,
    pages: u64,
    work_bytes: u64,
    result_bytes: u64,
    core_seconds: f64,
}

/// Plans a build.
///
/// # Errors
/// If an input cannot be read or the plan cannot be written.
pub(crate) fn plan(args: &PlanArgs, output: &Output) -> Result<(), Failure> {
    let input = build_input(&args.inputs)?;
    let options = build_options(&args.cells, output)?;
    let folder = work_folder(&args.output, args.work.as_deref());
    let threads = args.threads.unwrap_or_else(core_count);
    let mut bar = output.bar();
    let plan = Plan::make((input, options), &args.output, &folder, (threads, &mut |p| bar.show(p)));
    let plan = plan.map_err(failure)?;
    drop(bar);
    let estimate = plan.estimate();
    let report = Report {
        plan: folder.join("plan.json"),
        triangles: plan.metadata.triangle_count,
        tasks: plan.tasks.len(),
        stages: plan.stages(),
        pages: estimate.page_count,
        work_bytes: estimate.work_bytes,
        result_bytes: estimate.result_bytes,
        core_seconds: plan.metadata.triangle_count as f64 / TRIANGLES_PER_SECOND,
    };
    output.summary(&report, &text(&report))
}

fn text(report: &Report) -> String {
    let mut table = Table::with_head(&["stage", "tasks", "first task"]);
    for stage in &report.stages {
        table.row(vec![stage.name.clone(), stage.task_count.to_string(), stage.first_task.to_string()]);
    }
    format!(
        "{}: {} triangles, {} tasks\n\n{}\nwork folder about {}, result about {}, at most {} pages\n\
        about {:.0} core seconds\n",
        report.plan.display(),
        format_count(report.triangles as usize),
        report.tasks,
        table.to_text(),
        format_bytes(report.work_bytes as usize),
        format_bytes(report.result_bytes as usize),
        format_count(report.pages as usize),
        report.core_seconds,
    )
}
