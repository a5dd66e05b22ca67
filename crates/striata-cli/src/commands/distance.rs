//! `distance`: measures the distance between two surfaces in both directions.

use serde::Serialize;
use serde_json::Value;
use striata::mesh::{DistanceError, DistanceOptions, OneSidedDistance, surface_distance};

use super::paged::open_input;
use crate::args::DistanceArgs;
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_command::output::{Output, Table, format_length};
use striata_command::save::georeference_of;

#[derive(Serialize)]
struct DistanceReport {
    max: f64,
    rms: f64,
    mean: f64,
    a_to_b: OneSidedReport,
    b_to_a: OneSidedReport,
    diagonal: f64,
    sample_count: usize,
    /// Place on the Earth of the first mesh; of the second if the first has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    georeference: Option<Value>,
}

#[derive(Serialize)]
struct OneSidedReport {
    max: f64,
    rms: f64,
    mean: f64,
}

impl From<OneSidedDistance> for OneSidedReport {
    fn from(way: OneSidedDistance) -> Self {
        Self { max: way.max, rms: way.rms, mean: way.mean }
    }
}

/// Measures the distance and prints it.
///
/// # Errors
/// If a mesh cannot be read, or has no triangles.
pub(crate) fn run(args: &DistanceArgs, output: &Output) -> Result<(), Failure> {
    let mut bar = output.bar();
    bar.phase("read");
    let inputs = [open_input(&args.a, usize::MAX)?, open_input(&args.b, usize::MAX)?];
    let (a, b) = (inputs[0].mesh(output)?, inputs[1].mesh(output)?);
    let of = |which| if which == "first" { &inputs[0] } else { &inputs[1] };
    let mut options = DistanceOptions::default();
    if let Some(samples) = args.samples {
        options = options.with_sample_count(samples);
    }
    if let Some(seed) = args.seed {
        options = options.with_seed(seed);
    }
    bar.phase("distance");
    let distance = surface_distance(&a, &b, &options).map_err(|error| match error {
        DistanceError::Mesh { which, source } => Failure::from(source).in_file(&of(which).name),
        DistanceError::Empty { which } => no_surface(of(which)),
        error => Failure::user(error.to_string()),
    })?;
    drop(bar);
    let report = DistanceReport {
        max: distance.max,
        rms: distance.rms,
        mean: distance.mean,
        a_to_b: distance.a_to_b.into(),
        b_to_a: distance.b_to_a.into(),
        diagonal: distance.diagonal,
        sample_count: distance.sample_count,
        georeference: georeference_of(&a).or_else(|| georeference_of(&b)),
    };
    output.data(&report, &report.to_text())
}

fn no_surface(input: &Input) -> Failure {
    Failure::user(format!("{}: the mesh has no triangles to measure a distance to", input.name))
        .with_hint("`striata info` shows what the file contains")
}

impl DistanceReport {
    fn to_text(&self) -> String {
        let mut table = Table::with_head(&["", "max", "rms", "mean", "rms / diagonal"]);
        let both = OneSidedReport { max: self.max, rms: self.rms, mean: self.mean };
        for (name, way) in [("a to b", &self.a_to_b), ("b to a", &self.b_to_a), ("both", &both)] {
            let share = if self.diagonal > 0.0 { way.rms / self.diagonal } else { 0.0 };
            table.row(vec![
                name.to_owned(),
                format_length(way.max),
                format_length(way.rms),
                format_length(way.mean),
                format!("{:.5} %", 100.0 * share),
            ]);
        }
        format!(
            "{}{} samples; diagonal {}\n",
            table.to_text(),
            self.sample_count,
            format_length(self.diagonal)
        )
    }
}
