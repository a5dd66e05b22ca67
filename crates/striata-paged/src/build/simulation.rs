//! Simulation of a plan: how long its tasks take on a number of workers, and how much they write.
//!
//! Each task of the plan runs in simulated time on the first free worker, after all tasks of earlier stages. Its cost
//! follows from the number of triangles that it reads. A given share of the attempts fails and is repeated.

use serde::{Deserialize, Serialize};
use striata::mesh::Random;

use super::{BYTES_PER_COMPONENT, BuildTask, PagedPlan, RESULT_BYTES_PER_TRIANGLE, TaskKind};

/// Seconds of one core that tasks take, measured on a terrain; see docs/results/scale.md.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TaskCosts {
    /// Per triangle that is sorted.
    pub sort: f64,
    /// Per triangle that a cell simplifies.
    pub simplify: f64,
    /// Per triangle of a cell whose page is encoded.
    pub encode: f64,
    /// Per byte of the result that is written.
    pub write: f64,
    /// Per task: starting it, and reading the tables of earlier results.
    pub task: f64,
}

impl Default for TaskCosts {
    fn default() -> Self {
        Self { sort: 0.07e-6, simplify: 0.95e-6, encode: 0.25e-6, write: 2e-9, task: 0.05 }
    }
}

/// Workers, costs and failures of a simulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SimulationOptions {
    /// Number of workers, each with one core; at least 1.
    pub workers: usize,
    /// Seconds of one core that tasks take.
    pub costs: TaskCosts,
    /// Share of the attempts that fail after a random part of their time, 0 to 0.9; default 0.
    pub failing_share: f64,
    /// Seed of these failures; default 1.
    pub seed: u64,
}

impl SimulationOptions {
    /// This many workers without failures.
    pub fn new(workers: usize) -> Self {
        Self { workers: workers.max(1), costs: TaskCosts::default(), failing_share: 0.0, seed: 1 }
    }
}

/// Time and load of one stage.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SimulatedStage {
    /// Name of the stage.
    pub name: String,
    /// Seconds from its first task to its last.
    pub seconds: f64,
    /// Share of the workers' time in which they have a task.
    pub busy_share: f64,
}

/// Time and bytes that a simulated build takes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Simulation {
    /// Number of workers.
    pub workers: usize,
    /// Seconds from the first task to the last.
    pub seconds: f64,
    /// Seconds of all workers with a task.
    pub core_seconds: f64,
    /// Number of tasks that were started, with those that failed.
    pub attempts: usize,
    /// Bytes of the work folder at the end, when it is largest.
    pub work_bytes: u64,
    /// Bytes of the result.
    pub result_bytes: u64,
    /// The stages in order.
    pub stages: Vec<SimulatedStage>,
}

impl PagedPlan {
    /// Runs all tasks in simulated time.
    pub fn simulate(&self, options: &SimulationOptions) -> Simulation {
        let workers = options.workers.max(1);
        let failing_share = options.failing_share.clamp(0.0, 0.9);
        let mut random = Random::new(options.seed);
        let mut draw = || random.next_u64() as f64 / u64::MAX as f64;
        let mut result = Simulation {
            workers,
            seconds: 0.0,
            core_seconds: 0.0,
            attempts: 0,
            work_bytes: 0,
            result_bytes: self.estimate().result_bytes,
            stages: Vec::new(),
        };
        for stage in self.stages() {
            let begin = result.seconds;
            // The time at which each worker is free; no task begins before all earlier stages are done.
            let mut free = vec![begin; workers];
            let busy_before = result.core_seconds;
            for number in stage.tasks() {
                let task = &self.tasks[number];
                let cost = self.seconds_of(task, &options.costs);
                loop {
                    let worker = (0..workers).fold(0, |best, w| if free[w] < free[best] { w } else { best });
                    result.attempts += 1;
                    let has_failed = draw() < failing_share;
                    let spent = if has_failed { cost * draw() } else { cost };
                    free[worker] += spent;
                    result.core_seconds += spent;
                    if !has_failed {
                        break;
                    }
                }
                result.work_bytes += self.bytes_of(task);
            }
            result.seconds = free.into_iter().fold(begin, f64::max);
            let seconds = result.seconds - begin;
            let busy_share = (result.core_seconds - busy_before) / (seconds * workers as f64).max(1e-12);
            result.stages.push(SimulatedStage { name: stage.name, seconds, busy_share });
        }
        result
    }

    /// Triangles that a task reads.
    fn triangles_of(&self, task: &BuildTask) -> f64 {
        let triangles = self.metadata.triangle_count as f64;
        let of_level = |level: u8| {
            let cells = self.metadata.cell_counts.get(level as usize).copied().unwrap_or(1);
            triangles * 0.25f64.powi(level.into()) * task.count as f64 / f64::from(cells.max(1))
        };
        match task.kind {
            TaskKind::Sort => {
                let pieces: u64 =
                    self.tasks.iter().map(|t| if t.kind == TaskKind::Sort { t.count } else { 0 }).sum();
                triangles * task.count as f64 / pieces.max(1) as f64
            }
            TaskKind::Level(level) | TaskKind::Encode(level) => of_level(level),
            TaskKind::Finish => triangles,
        }
    }

    fn seconds_of(&self, task: &BuildTask, costs: &TaskCosts) -> f64 {
        let triangles = self.triangles_of(task);
        costs.task
            + match task.kind {
                TaskKind::Sort => costs.sort * triangles,
                TaskKind::Level(_) => costs.simplify * triangles,
                TaskKind::Encode(_) => costs.encode * triangles,
                TaskKind::Finish => costs.write * self.estimate().result_bytes as f64,
            }
    }

    /// Bytes that a task leaves in the work folder.
    fn bytes_of(&self, task: &BuildTask) -> u64 {
        let components: u64 = self.metadata.layers.iter().map(|l| u64::from(l.component_count)).sum();
        let per_triangle = match task.kind {
            TaskKind::Sort => 13.0 + 0.25 * (BYTES_PER_COMPONENT * components) as f64,
            TaskKind::Level(_) => 28.5 + 0.5 * (BYTES_PER_COMPONENT * components) as f64,
            TaskKind::Encode(_) => (RESULT_BYTES_PER_TRIANGLE + components) as f64 * 0.75,
            TaskKind::Finish => 0.0,
        };
        (per_triangle * self.triangles_of(task)) as u64
    }
}
