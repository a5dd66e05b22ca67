//! Builds of meshes larger than memory: plans, and the tasks that an executor runs.

use std::path::PathBuf;

use pyo3::prelude::*;
use striata::simplify::AttributeWeights;
use striata_paged::build::{
    BuildInput, BuildOptions, BuildPaths, Limit, PagedBuildError, PagedPlan, SimulationOptions, run_task,
};

use crate::errors::{Outcome, cancelled, decode_error, internal_error, os_error, read_error, value_error};
use crate::job;

/// Name, seconds and busy share of a stage.
type SimulatedStage = (String, f64, f64);

/// A plan on disk. It has no state of its own: every process that sees the folder may open it.
#[pyclass(frozen, module = "striata._striata")]
pub(crate) struct PlanData {
    plan: PagedPlan,
}

fn build_error(error: PagedBuildError) -> PyErr {
    match error {
        PagedBuildError::Read(error) => read_error(error),
        PagedBuildError::Io { path, source } => os_error(&source, path.display().to_string()),
        PagedBuildError::Cancelled(reason) => cancelled(reason),
        PagedBuildError::Damaged { .. } | PagedBuildError::Plan { .. } => decode_error(error),
        PagedBuildError::Simplify { .. } | PagedBuildError::NoOwner { .. } => internal_error(error),
        other => value_error(other),
    }
}

/// Paths of the result and of the work folder, as a pair.
#[derive(FromPyObject)]
pub(crate) struct PlanPaths(PathBuf, PathBuf);

/// Options of a plan, as items of a Python object.
#[derive(FromPyObject)]
pub(crate) struct PlanOptions {
    #[pyo3(item)]
    cell: usize,
    #[pyo3(item)]
    exact: bool,
    #[pyo3(item)]
    weld_distance: Option<f64>,
    #[pyo3(item)]
    allow_merging: bool,
    #[pyo3(item)]
    nodata: Option<f64>,
    #[pyo3(item)]
    z_scale: f64,
    #[pyo3(item)]
    task_size: u64,
    #[pyo3(item)]
    weights: (f32, f32, f32),
    /// Number of triangles, and whether it is a share of those of the input.
    #[pyo3(item)]
    base: Option<(f64, bool)>,
    /// Distance, and whether it is a share of the diagonal.
    #[pyo3(item)]
    max_error: Option<(f64, bool)>,
    #[pyo3(item)]
    strict: bool,
}

/// A limit of the base mesh, which must not be negative.
fn limit(name: &str, given: Option<(f64, bool)>) -> Outcome<Option<Limit>> {
    let Some((value, is_share)) = given else { return Ok(None) };
    if !(value >= 0.0 && value.is_finite()) {
        return Err(value_error(format!("{name} must be a finite number of at least 0")));
    }
    Ok(Some(if is_share { Limit::Share(value) } else { Limit::Absolute(value) }))
}

impl PlanOptions {
    fn build_options(&self) -> Outcome<BuildOptions> {
        let (normal_weight, texcoord_weight, color_weight) = self.weights;
        let weights = AttributeWeights {
            normal: normal_weight,
            texcoord: texcoord_weight,
            color: color_weight,
            ..AttributeWeights::NONE
        };
        let is_valid =
            [weights.normal, weights.texcoord, weights.color].iter().all(|w| *w >= 0.0 && w.is_finite());
        if !is_valid {
            return Err(value_error("weights must be finite numbers of at least 0"));
        }
        if !(1000..=1_000_000).contains(&self.cell) {
            return Err(value_error(format!("cell is {}, but must be 1000 to 1000000", self.cell)));
        }
        if self.weld_distance.is_some_and(|distance| !(distance > 0.0 && distance.is_finite())) {
            return Err(value_error("weld_distance must be a positive number"));
        }
        if !self.z_scale.is_finite() || self.z_scale == 0.0 {
            return Err(value_error("z_scale must be a finite number other than 0"));
        }
        let task_size = self.task_size.clamp(1, 1 << 20);
        Ok(BuildOptions {
            cell: self.cell,
            exact: self.exact,
            weld_distance: self.weld_distance,
            allow_merging: self.allow_merging,
            nodata: self.nodata,
            z_scale: self.z_scale,
            normal_weight,
            texcoord_weight,
            color_weight,
            cells_per_task: task_size,
            pieces_per_task: task_size.div_ceil(2),
            base: limit("base", self.base)?,
            max_error: limit("max_error", self.max_error)?,
            strict: self.strict,
            ..BuildOptions::default()
        })
    }
}

#[pymethods]
impl PlanData {
    /// Reads the inputs once and writes a plan.
    #[staticmethod]
    fn make(
        py: Python<'_>,
        inputs: Vec<PathBuf>,
        paths: PlanPaths,
        options: PlanOptions,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> Outcome<Self> {
        let options = options.build_options()?;
        let PlanPaths(output, folder) = paths;
        let input = match inputs.as_slice() {
            [one] => generated(one).unwrap_or_else(|| BuildInput::Files(inputs.clone())),
            _ => BuildInput::Files(inputs),
        };
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let plan = job::run(py, usize::MAX, progress, move |report| {
            let paths = BuildPaths { output: &output, folder: &folder };
            PagedPlan::make(input, options, paths, threads, report).map_err(build_error)
        })?;
        Ok(Self { plan })
    }

    /// Opens a plan by its folder or file.
    #[staticmethod]
    fn open(path: PathBuf) -> Outcome<Self> {
        Ok(Self { plan: PagedPlan::open(&path).map_err(build_error)? })
    }

    /// Name and task numbers of each stage, in order.
    fn stages(&self) -> Vec<(String, Vec<usize>)> {
        self.plan.stages().into_iter().map(|stage| (stage.name.clone(), stage.tasks().collect())).collect()
    }

    fn is_done(&self, task: usize) -> bool {
        self.plan.tasks.get(task).is_some_and(|task| self.plan.is_done(task))
    }

    fn run_task(&self, py: Python<'_>, task: usize) -> Outcome<()> {
        let plan = self.plan.clone();
        job::run(py, usize::MAX, None, move |_| run_task(&plan, task).map_err(build_error))
    }

    fn remove_work(&self) -> Outcome<()> {
        self.plan.remove_work().map_err(build_error)
    }

    /// Simulates the build; returns seconds, seconds of all workers, attempts, bytes of the work folder, and name,
    /// seconds and busy share of each stage.
    fn simulate(
        &self,
        workers: usize,
        failing_share: f64,
        seed: u64,
    ) -> (f64, f64, usize, u64, Vec<SimulatedStage>) {
        let options = SimulationOptions { failing_share, seed, ..SimulationOptions::new(workers) };
        let found = self.plan.simulate(&options);
        let stages = found.stages.into_iter().map(|stage| (stage.name, stage.seconds, stage.busy_share));
        (found.seconds, found.core_seconds, found.attempts, found.work_bytes, stages.collect())
    }

    #[getter]
    fn is_finished(&self) -> bool {
        self.plan.is_finished()
    }

    #[getter]
    fn folder(&self) -> PathBuf {
        self.plan.folder.clone()
    }

    #[getter]
    fn output(&self) -> PathBuf {
        self.plan.output.clone()
    }

    #[getter]
    fn triangle_count(&self) -> u64 {
        self.plan.metadata.triangle_count
    }

    /// Bytes of the work folder, bytes of the result, and pages, all estimated.
    #[getter]
    fn estimate(&self) -> (u64, u64, u64) {
        let estimate = self.plan.estimate();
        (estimate.work_bytes, estimate.result_bytes, estimate.page_count)
    }
}

/// A generated terrain, as the command names it.
fn generated(path: &std::path::Path) -> Option<BuildInput> {
    let side = path.to_str()?.strip_prefix("shape:terrain:")?.parse().ok()?;
    (2..=200_000).contains(&side).then_some(BuildInput::Terrain(side))
}
