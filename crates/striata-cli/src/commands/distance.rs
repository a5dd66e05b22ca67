//! `distance`: how far two surfaces are from each other, both ways.

use serde::Serialize;
use striata::mesh::{DistanceOptions, OneSided, surface_distance};

use crate::args::DistanceArgs;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{Output, Table};

#[derive(Serialize)]
struct Report {
    max: f64,
    rms: f64,
    mean: f64,
    a_to_b: Way,
    b_to_a: Way,
    diagonal: f64,
    sample_count: usize,
}

#[derive(Serialize)]
struct Way {
    max: f64,
    rms: f64,
    mean: f64,
}

impl From<OneSided> for Way {
    fn from(way: OneSided) -> Self {
        Self { max: way.max, rms: way.rms, mean: way.mean }
    }
}

/// Measures and reports.
///
/// # Errors
/// Where a mesh cannot be read, or has no surface to measure.
pub(crate) fn run(args: &DistanceArgs, output: &Output) -> Result<(), Failure> {
    let mut bar = output.bar();
    bar.phase("read");
    let a = Input::open(&args.a)?.mesh()?;
    let b = Input::open(&args.b)?.mesh()?;
    let mut options = DistanceOptions::default();
    if let Some(samples) = args.samples {
        options = options.with_sample_count(samples);
    }
    if let Some(seed) = args.seed {
        options = options.with_seed(seed);
    }
    bar.phase("distance");
    let distance = surface_distance(&a, &b, &options)?;
    drop(bar);
    let report = Report {
        max: distance.max,
        rms: distance.rms,
        mean: distance.mean,
        a_to_b: distance.a_to_b.into(),
        b_to_a: distance.b_to_a.into(),
        diagonal: distance.diagonal,
        sample_count: distance.sample_count,
    };
    output.data(&report, &report.to_text())
}

impl Report {
    fn to_text(&self) -> String {
        let mut table = Table::with_head(&["", "max", "rms", "mean", "rms / diagonal"]);
        let both = Way { max: self.max, rms: self.rms, mean: self.mean };
        for (name, way) in [("a to b", &self.a_to_b), ("b to a", &self.b_to_a), ("both", &both)] {
            let share = if self.diagonal > 0.0 { way.rms / self.diagonal } else { 0.0 };
            table.row(vec![
                name.to_owned(),
                format!("{:.6}", way.max),
                format!("{:.6}", way.rms),
                format!("{:.6}", way.mean),
                format!("{:.5} %", 100.0 * share),
            ]);
        }
        format!("{}{} samples; diagonal {:.6}\n", table.to_text(), self.sample_count, self.diagonal)
    }
}
