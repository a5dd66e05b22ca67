//! Strip counts by maximum tunnel length, over several seeds: figure 8 and table 1 of \[PS03\].
//!
//! Runs with different seeds are independent, so they use all cores; only counts are reported, never times.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use serde::Serialize;
use striata::mesh::IndexedMesh;

use super::page::{Block, Section};
use super::plot::{Chart, Series};
use super::scale::Scale;
use striata_command::args::StripSearchArgs;
use striata_command::failure::Failure;
use striata_command::output::format_count;
use striata_command::strip_chain::StripPlan;

/// The tunneling stripifiers: with identities that follow each flip, and the static baseline.
const ALGORITHMS: [&str; 2] = ["tunnel", "tunnel-static"];

/// Strip counts of one stripifier at one maximum length, over all seeds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct TunnelRow {
    algorithm: &'static str,
    max_length: u32,
    seeds: usize,
    mean: f64,
    min: usize,
    max: usize,
    /// Standard deviation of the sample; 0 for one seed.
    std: f64,
}

impl TunnelRow {
    fn new(algorithm: &'static str, max_length: u32, strip_counts: &[usize]) -> Self {
        let n = strip_counts.len() as f64;
        let mean = strip_counts.iter().sum::<usize>() as f64 / n.max(1.0);
        let squares: f64 = strip_counts.iter().map(|&count| (count as f64 - mean).powi(2)).sum();
        Self {
            algorithm,
            max_length,
            seeds: strip_counts.len(),
            mean,
            min: strip_counts.iter().copied().min().unwrap_or(0),
            max: strip_counts.iter().copied().max().unwrap_or(0),
            std: (squares / (n - 1.0).max(1.0)).sqrt(),
        }
    }
}

/// Runs each tunneling stripifier from scratch, at every odd length up to `max_length`, with seeds from 0.
///
/// # Errors
/// If the mesh is inconsistent.
pub(super) fn measure(
    mesh: &IndexedMesh,
    max_length: u32,
    seeds: u32,
    show: &mut dyn FnMut(f64),
) -> Result<Vec<TunnelRow>, Failure> {
    let lengths: Vec<u32> = (1..=max_length).step_by(2).collect();
    let settings: Vec<(&'static str, u32)> =
        lengths.iter().flat_map(|&length| ALGORITHMS.map(|algorithm| (algorithm, length))).collect();
    let mut plans = Vec::new();
    for (algorithm, length) in &settings {
        let chain = format!("{algorithm}:{length}").parse().map_err(Failure::internal)?;
        plans.push(StripPlan { chain, search: StripSearchArgs::default() });
    }
    let runs: Vec<StripPlan> =
        plans.iter().flat_map(|plan| (0..seeds).map(|seed| plan.with_seed(u64::from(seed)))).collect();
    let counts = strip_counts(mesh, &runs, show)?;
    let rows = settings.iter().zip(counts.chunks(seeds.max(1) as usize));
    Ok(rows.map(|(&(algorithm, length), counts)| TunnelRow::new(algorithm, length, counts)).collect())
}

/// Number of strips of every run, on as many threads as the machine has.
fn strip_counts(
    mesh: &IndexedMesh,
    runs: &[StripPlan],
    show: &mut dyn FnMut(f64),
) -> Result<Vec<usize>, Failure> {
    let next = AtomicUsize::new(0);
    let (done, results) = mpsc::channel();
    let thread_count = thread::available_parallelism().map_or(1, |count| count.get());
    let mut counts = vec![0; runs.len()];
    thread::scope(|scope| {
        for _ in 0..thread_count {
            let (done, next) = (done.clone(), &next);
            scope.spawn(move || {
                while let Some((index, plan)) = next_run(runs, next) {
                    let count = plan.run(mesh, &mut |_| ()).map(|stripped| stripped.strips.strip_count());
                    // The receiver is gone if another run has failed.
                    if done.send((index, count)).is_err() {
                        return;
                    }
                }
            });
        }
        drop(done);
        for (finished, (index, count)) in results.into_iter().enumerate() {
            counts[index] = count?;
            show((finished + 1) as f64 / runs.len() as f64);
        }
        Ok(counts)
    })
}

fn next_run<'a>(runs: &'a [StripPlan], next: &AtomicUsize) -> Option<(usize, &'a StripPlan)> {
    let index = next.fetch_add(1, Ordering::Relaxed);
    runs.get(index).map(|plan| (index, plan))
}

/// Header and rows, one row per length.
pub(super) fn table(rows: &[TunnelRow]) -> Vec<Vec<String>> {
    let mut table = vec![vec!["longest".to_owned()]];
    for algorithm in ALGORITHMS {
        table[0].extend([algorithm.to_owned(), "range".to_owned(), "std".to_owned()]);
    }
    for of_length in rows.chunk_by(|a, b| a.max_length == b.max_length) {
        let mut cells = vec![of_length[0].max_length.to_string()];
        for row in of_length {
            let range = format!("{}–{}", format_count(row.min), format_count(row.max));
            cells.extend([tenths(row.mean), range, tenths(row.std)]);
        }
        table.push(cells);
    }
    table
}

/// Formats a number with one decimal and grouped thousands.
fn tenths(value: f64) -> String {
    let tenths = (value * 10.0).round() as usize;
    format!("{}.{}", format_count(tenths / 10), tenths % 10)
}

/// The page section with a chart and the table.
///
/// # Errors
/// If the chart cannot be drawn.
pub(super) fn section(rows: &[TunnelRow]) -> Result<Section, Failure> {
    let of = |algorithm: &'static str| rows.iter().filter(move |row| row.algorithm == algorithm);
    let lengths: Vec<f64> = of(ALGORITHMS[0]).map(|row| f64::from(row.max_length)).collect();
    let series = ALGORITHMS.map(|algorithm| Series {
        name: algorithm.to_owned(),
        points: of(algorithm).map(|row| (f64::from(row.max_length), row.mean)).collect(),
        spread: of(algorithm).map(|row| (row.min as f64, row.max as f64)).collect(),
    });
    let chart = Chart {
        x_title: "longest tunnel",
        y_title: "strips",
        x: Scale::at(&lengths),
        y: Scale::log(rows.iter().flat_map(|row| [row.min as f64, row.max as f64])),
        series: series.into(),
    };
    let seeds = rows.first().map_or(0, |row| row.seeds);
    Ok(Section {
        title: "Strips by the longest tunnel".to_owned(),
        intro: format!(
            "Tunneling from scratch with {seeds} seeds at each length: the line is the mean, the band \
             reaches from the lowest to the highest. In the table, std is the standard deviation of the \
             sample."
        ),
        blocks: vec![Block::chart(&chart, "Strips against the longest tunnel")?, Block::Table(table(rows))],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn row_has_mean_range_and_deviation() {
        let row = TunnelRow::new("tunnel", 3, &[2, 4, 4, 4, 5, 5, 7, 9]);
        assert_eq!((row.mean, row.min, row.max, row.seeds), (5.0, 2, 9, 8));
        assert!((row.std - (32f64 / 7.0).sqrt()).abs() < 1e-12);
        assert_eq!(TunnelRow::new("tunnel", 3, &[6]).std, 0.0);
        assert_eq!(tenths(1234.96), "1,235.0");
    }

    #[test]
    fn results_are_deterministic_and_longer_tunnels_leave_fewer_strips() {
        let spot = concat!(env!("CARGO_MANIFEST_DIR"), "/../../assets/spot.obj.zst");
        let mesh = striata_io::read(spot).unwrap();
        let mut shares = Vec::new();
        let rows = measure(&mesh, 6, 3, &mut |share| shares.push(share)).unwrap();
        assert_eq!(rows.iter().map(|row| row.max_length).collect::<Vec<_>>(), [1, 1, 3, 3, 5, 5]);
        assert_eq!(shares.last(), Some(&1.0));
        assert_eq!(measure(&mesh, 6, 3, &mut |_| ()).unwrap(), rows);
        let dynamic: Vec<f64> = rows.iter().step_by(2).map(|row| row.mean).collect();
        assert!(dynamic.is_sorted_by(|a, b| a > b), "{dynamic:?}");
        assert_eq!(table(&rows).len(), 4);
    }
}
