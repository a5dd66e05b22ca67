//! `plan`: reads the input once and writes the tasks of its build.

use std::path::PathBuf;

use serde::Serialize;
use striata_command::failure::Failure;
use striata_command::output::{Output, Table, format_bytes, format_count, format_duration};
use striata_paged::build::{BuildPaths, BuildStage, PagedPlan, Simulation, SimulationOptions};

use super::build::{limited, say_remarks};
use super::failure;
use super::input::{build_input, build_options, work_folder};
use crate::args::PlanArgs;

/// Largest number of workers that is simulated.
const MAX_WORKERS: usize = 100_000;

#[derive(Serialize)]
struct PlanReport {
    plan: PathBuf,
    triangles: u64,
    tasks: usize,
    stages: Vec<BuildStage>,
    pages: u64,
    work_bytes: u64,
    result_bytes: u64,
    simulations: Vec<Simulation>,
    /// The place of a terrain on the Earth.
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<serde_json::Value>,
}

/// Plans a build.
///
/// # Errors
/// If an input cannot be read or the plan cannot be written.
pub(crate) fn plan(args: &PlanArgs, output: &Output) -> Result<(), Failure> {
    let input = build_input(&args.inputs)?;
    let options = limited(build_options(&args.cells, output)?, &args.limits);
    let folder = work_folder(&args.output, args.work.as_deref());
    if let Some(wrong) = args.workers.iter().find(|n| !(1..=MAX_WORKERS).contains(*n)) {
        return Err(Failure::usage(format!("--workers has {wrong}, but must be 1 to {MAX_WORKERS}")));
    }
    let mut bar = output.bar();
    let plan = PagedPlan::make(
        input,
        options,
        BuildPaths { output: &args.output, folder: &folder },
        rayon::current_num_threads(),
        &mut |p| bar.show(p),
    );
    let plan = plan.map_err(failure)?;
    drop(bar);
    say_remarks(&plan, output)?;
    let estimate = plan.estimate();
    let report = PlanReport {
        plan: folder.join("plan.json"),
        triangles: plan.metadata.triangle_count,
        tasks: plan.tasks.len(),
        stages: plan.stages(),
        pages: estimate.page_count,
        work_bytes: estimate.work_bytes,
        result_bytes: estimate.result_bytes,
        simulations: args.workers.iter().map(|&n| plan.simulate(&SimulationOptions::new(n))).collect(),
        georeference: plan.metadata.georeference.clone(),
    };
    output.summary(&report, &text(&report))
}

fn text(report: &PlanReport) -> String {
    let mut table = Table::with_head(&["stage", "tasks", "first task"]);
    for stage in &report.stages {
        table.row(vec![stage.name.clone(), stage.task_count.to_string(), stage.first_task.to_string()]);
    }
    let mut times = Table::with_head(&["workers", "time", "core time", "workers busy"]);
    for simulation in &report.simulations {
        let busy = simulation.core_seconds / (simulation.seconds * simulation.workers as f64);
        times.row(vec![
            format_count(simulation.workers),
            format_duration(simulation.seconds),
            format_duration(simulation.core_seconds),
            format!("{:.0} %", 100.0 * busy),
        ]);
    }
    format!(
        "{}: {} triangles, {} tasks\n\n{}\nwork folder about {}, result about {}, at most {} pages\n\n\
        simulated:\n{}",
        report.plan.display(),
        format_count(report.triangles as usize),
        report.tasks,
        table.to_text(),
        format_bytes(report.work_bytes as usize),
        format_bytes(report.result_bytes as usize),
        format_count(report.pages as usize),
        times.to_text(),
    )
}
