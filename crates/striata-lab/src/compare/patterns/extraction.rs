//! How long it takes to come from the base to the coarsest surface of no more than an error, by how large that is.
//!
//! The condition looks at errors of fragments alone, so what is timed is the model. Each time begins with a new instance of the base and
//! ends when its triangles are in a buffer; models take turns, and of several rounds the quickest counts.

use std::hint::black_box;
use std::time::Instant;

use serde::Serialize;
use striata::mesh::canonical_triangles;
use striata::model::{Overlap, PatternInstance};
use striata_lab::baseline::MtQuestion;

use super::or_dash::or_dash;
use super::sizes::Models;
use striata_command::failure::Failure;
use striata_command::output::format_count;

/// Triangles of the smallest level.
const FEWEST: usize = 1000;

/// Rounds of which the quickest counts, where time allows.
const ROUND_COUNT: usize = 7;

/// Seconds after which no further round of a size begins.
const SIZE_SECS: f64 = 0.3;

/// The models; the colors of charts follow this order, in which the one that may be missing is last.
pub(super) const NAMES: [&str; 3] = ["patterns", "multi-triangulation", "loop-patterns"];

/// One size of what is extracted.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ExtractionRow {
    /// That no fragment which is left out may exceed, mesh units; null where all are wanted.
    error: Option<f32>,
    pub(super) triangle_count: usize,
    fragment_count: usize,
    /// Of those that can be built.
    pub(super) models: Vec<ExtractionTime>,
}

/// How long one model took.
#[derive(Clone, Debug, Serialize)]
pub(super) struct ExtractionTime {
    /// Which.
    pub(super) name: &'static str,
    secs: f64,
    /// None where there is no triangle.
    pub(super) ns_per_triangle: Option<f64>,
}

impl ExtractionRow {
    /// As a row of a table.
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

/// Extracts levels from about [`FEWEST`] triangles to all, each twice as large as the one before.
///
/// # Errors
/// Where models show different things, which is our fault.
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

/// Errors that are allowed, falling; none at last, for the full mesh.
fn limits(models: &Models) -> Vec<Option<f32>> {
    let full = models.triangle_counts.last().copied().unwrap_or(0);
    let counts =
        std::iter::successors(Some(FEWEST), |count| Some(2 * count)).take_while(|&count| count < full);
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
        for (which, best) in best.iter_mut().enumerate() {
            buffer.clear();
            let started = Instant::now();
            let Some(count) = extract(models, which, limit, &mut buffer) else { continue };
            black_box(&*buffer);
            *best = best.min(started.elapsed().as_secs_f64());
            if round == 0 {
                let found = (count, canonical_triangles(&buffer));
                if *expected.get_or_insert_with(|| found.clone()) != found {
                    let what = format!("{} extracts other triangles than {}", NAMES[which], NAMES[0]);
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

/// Goes from the base to what the limit asks for and appends its triangles; how many fragments that took. None where the model
/// could not be built.
fn extract(models: &Models, which: usize, limit: Option<f32>, out: &mut Vec<[u32; 3]>) -> Option<usize> {
    let limit = limit.unwrap_or(-1.0);
    let errors = &models.errors;
    let by_overlap = |overlap: Overlap| errors[overlap.upper as usize] > limit;
    match which {
        0 => {
            let mut instance = PatternInstance::base(&models.patterns);
            instance.adapt(&models.patterns, &by_overlap);
            instance.triangles_into(out);
            Some(instance.split_count())
        }
        1 => {
            let mut state = models.explicit.base_state();
            models.explicit.adapt(&mut state, |question: MtQuestion| errors[question.upper as usize] > limit);
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
