//! Times the extraction of the coarsest surface within an error limit from the base, for several limits.
//!
//! The condition reads only the errors of fragments, so the measured time is that of the model. Timing
//! starts with a new base instance and ends when its triangles are in a buffer. Models take turns, and the
//! fastest of several rounds counts.

use std::hint::black_box;
use std::time::Instant;

use serde::Serialize;
use striata::mesh::canonical_triangles;
use striata::model::{Overlap, PatternInstance};
use striata_lab::baseline::MtQuery;

use super::or_dash::or_dash;
use super::sizes::Models;
use striata_command::failure::Failure;
use striata_command::output::format_count;

/// Number of triangles of the smallest level.
const MIN_TRIANGLES: usize = 1000;

/// Maximum number of rounds; the fastest one counts.
const ROUND_COUNT: usize = 7;

/// No further round of a size starts after this many seconds.
const SIZE_SECS: f64 = 0.3;

/// Names of the models; chart colors follow this order, in which the model that may be missing is last.
pub(super) const NAMES: [&str; 3] = ["patterns", "multi-triangulation", "loop-patterns"];

/// Extraction times at one size.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ExtractionRow {
    /// Error limit for fragments that are not inserted, in mesh units; null for the full mesh.
    error: Option<f32>,
    pub triangle_count: usize,
    fragment_count: usize,
    /// Times of the models that can be built.
    pub models: Vec<ExtractionTime>,
}

/// Extraction time of one model.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ExtractionTime {
    /// Name of the model.
    pub name: &'static str,
    secs: f64,
    /// None if there are no triangles.
    pub ns_per_triangle: Option<f64>,
}

impl ExtractionRow {
    /// The cells of the table row.
    pub(super) fn cells(&self) -> Vec<String> {
        let error = self.error.map_or_else(|| "none".to_owned(), |error| format!("{error:.3e}"));
        let mut cells = vec![error, format_count(self.triangle_count), format_count(self.fragment_count)];
        for name in NAMES {
            let time = self.models.iter().find(|time| time.name == name);
            cells.push(time.map_or_else(|| "-".to_owned(), |time| format!("{:.3}", time.secs * 1e3)));
            cells.push(or_dash(time.and_then(|time| time.ns_per_triangle), 1));
        }
        cells
    }
}

/// Extracts levels from about [`MIN_TRIANGLES`] triangles to the full mesh, doubling each time.
///
/// # Errors
/// If models extract different triangles, which would be a bug.
pub(super) fn measure(models: &Models, show: &mut dyn FnMut(f64)) -> Result<Vec<ExtractionRow>, Failure> {
    let limits = limits(models);
    let mut rows: Vec<ExtractionRow> = Vec::new();
    for (i, &limit) in limits.iter().enumerate() {
        show(i as f64 / limits.len() as f64);
        rows.push(measure_one(models, limit)?);
    }
    rows.dedup_by_key(|row| row.triangle_count);
    Ok(rows)
}

/// The error limits in descending order, with `None` at the end for the full mesh.
fn limits(models: &Models) -> Vec<Option<f32>> {
    let full = models.triangle_counts.last().copied().unwrap_or(0);
    let counts =
        std::iter::successors(Some(MIN_TRIANGLES), |count| Some(2 * count)).take_while(|&count| count < full);
    let level = |count: usize| models.triangle_counts.partition_point(|&n| n <= count).saturating_sub(1);
    let of_level = |count| models.level_errors.get(level(count)).copied().map(Some);
    let mut limits: Vec<Option<f32>> = counts.filter_map(of_level).collect();
    limits.push(None);
    limits.dedup();
    limits
}

fn measure_one(models: &Models, limit: Option<f32>) -> Result<ExtractionRow, Failure> {
    let mut buffer = Vec::new();
    let (mut best, mut expected) = ([f64::INFINITY; NAMES.len()], None);
    let began = Instant::now();
    for round in 0..ROUND_COUNT {
        for (model_index, best) in best.iter_mut().enumerate() {
            buffer.clear();
            let started = Instant::now();
            let Some(count) = extract(models, model_index, limit, &mut buffer) else { continue };
            black_box(&*buffer);
            *best = best.min(started.elapsed().as_secs_f64());
            if round == 0 {
                let found = (count, canonical_triangles(&buffer));
                if *expected.get_or_insert_with(|| found.clone()) != found {
                    let what = format!("{} and {} extract different triangles", NAMES[model_index], NAMES[0]);
                    return Err(Failure::internal(what));
                }
            }
        }
        if began.elapsed().as_secs_f64() > SIZE_SECS {
            break;
        }
    }
    let (fragment_count, triangle_count) =
        expected.map_or((0, 0), |(count, triangles)| (count, triangles.len()));
    let time = |(name, secs): (&'static str, f64)| ExtractionTime {
        name,
        secs,
        ns_per_triangle: (triangle_count > 0).then(|| secs * 1e9 / triangle_count as f64),
    };
    let timed = NAMES.into_iter().zip(best).filter(|(_, secs)| secs.is_finite());
    Ok(ExtractionRow { error: limit, triangle_count, fragment_count, models: timed.map(time).collect() })
}

/// Adapts from the base to the limit and appends the triangles. Returns the number of fragments inserted,
/// or `None` if the model could not be built.
fn extract(
    models: &Models,
    model_index: usize,
    limit: Option<f32>,
    out: &mut Vec<[u32; 3]>,
) -> Option<usize> {
    let limit = limit.unwrap_or(-1.0);
    let errors = &models.errors;
    let by_overlap = |overlap: Overlap| errors[overlap.upper as usize] > limit;
    match model_index {
        0 => {
            let mut instance = PatternInstance::base(&models.patterns);
            instance.adapt(&models.patterns, &by_overlap);
            instance.triangles_into(out);
            Some(instance.split_count())
        }
        1 => {
            let mut state = models.explicit.base_state();
            models.explicit.adapt(&mut state, |query: MtQuery| errors[query.upper as usize] > limit);
            out.extend_from_slice(state.triangles());
            Some(state.split_count())
        }
        _ => {
            let loops = models.loops.as_ref().ok()?;
            let mut state = loops.base_state();
            loops.adapt(&mut state, &by_overlap);
            out.extend_from_slice(state.triangles());
            Some(state.split_count())
        }
    }
}
