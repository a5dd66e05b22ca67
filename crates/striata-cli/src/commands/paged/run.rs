//! `run`: runs one task of a plan, or all that are open.

use std::time::Instant;

use serde::Serialize;
use striata_command::failure::Failure;
use striata_command::output::{Output, format_duration};
use striata_paged::build::{PagedPlan, run_all, run_task};

use super::failure;
use crate::args::RunArgs;

#[derive(Serialize)]
struct TaskReport {
    task: Option<usize>,
    seconds: f64,
    finished: bool,
}

/// Runs tasks of a plan.
///
/// # Errors
/// If a task fails; what others have completed stays.
pub(crate) fn run(args: &RunArgs, output: &Output) -> Result<(), Failure> {
    let start = Instant::now();
    let plan = PagedPlan::open(&args.plan).map_err(failure)?;
    match args.task {
        Some(task) => run_task(&plan, task).map_err(failure)?,
        None => {
            let mut bar = output.bar();
            run_all(&plan, rayon::current_num_threads(), &mut |p| bar.show(p)).map_err(failure)?;
        }
    }
    let report =
        TaskReport { task: args.task, seconds: start.elapsed().as_secs_f64(), finished: plan.is_finished() };
    let what = args.task.map_or("all tasks".to_owned(), |task| format!("task {task}"));
    let text = format!("{what} done in {}\n", format_duration(report.seconds));
    output.summary(&report, &text)
}
