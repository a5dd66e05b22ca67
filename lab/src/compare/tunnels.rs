//! Strip counts by maximum tunnel length, over several seeds: figure 8 and table 1 of \[PS03\].
//!
//! Runs with different seeds are independent, so they use all cores. Times are those that each run's thread
//! spent on a processor.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

use serde::Serialize;
use striata::mesh::IndexedMesh;
use striata_lab::stripifiers::Tunneling;
use striata_lab::{Spread, cpu_secs};

use super::page::{PageBlock, PageSection};
use super::plot::{Chart, PlotSeries};
use super::scale::Scale;
use striata_command::failure::Failure;
use striata_command::output::format_count;

/// Strip counts of one kind of tunneling at one maximum length, over all seeds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct TunnelRow {
    search: &'static str,
    max_length: u32,
    seeds: usize,
    mean: f64,
    min: usize,
    max: usize,
    /// Standard deviation of the sample; 0 for one seed.
    std: f64,
    /// Mean CPU time of a run.
    secs: f64,
    /// Standard deviation of the CPU time.
    secs_std: f64,
}

/// Strip count and CPU time of one run.
#[derive(Clone, Copy, Debug, Default)]
struct RunResult {
    strip_count: usize,
    secs: f64,
}

impl TunnelRow {
    fn new(search: Tunneling, max_length: u32, runs: &[RunResult]) -> Self {
        let counts: Vec<f64> = runs.iter().map(|run| run.strip_count as f64).collect();
        let secs: Vec<f64> = runs.iter().map(|run| run.secs).collect();
        let (counts, secs) = (Spread::of(&counts), Spread::of(&secs));
        Self {
            search: search.as_str(),
            max_length,
            seeds: runs.len(),
            mean: counts.mean,
            min: counts.min as usize,
            max: counts.max as usize,
            std: counts.std,
            secs: secs.mean,
            secs_std: secs.std,
        }
    }
}

/// Runs each kind of tunneling from scratch, at every length, with seeds from 0.
///
/// # Errors
/// If the mesh is inconsistent.
pub(super) fn measure(
    mesh: &IndexedMesh,
    searches: &[Tunneling],
    lengths: &[u32],
    seeds: u32,
    show: &mut dyn FnMut(f64),
) -> Result<Vec<TunnelRow>, Failure> {
    let settings: Vec<(Tunneling, u32)> =
        lengths.iter().flat_map(|&length| searches.iter().map(move |&search| (search, length))).collect();
    let runs: Vec<(Tunneling, u32, u64)> = settings
        .iter()
        .flat_map(|&(search, length)| (0..u64::from(seeds)).map(move |seed| (search, length, seed)))
        .collect();
    let results = results_of(mesh, &runs, show)?;
    let rows = settings.iter().zip(results.chunks(seeds.max(1) as usize));
    Ok(rows.map(|(&(search, length), results)| TunnelRow::new(search, length, results)).collect())
}

/// Makes all runs, on as many threads as the machine has.
fn results_of(
    mesh: &IndexedMesh,
    runs: &[(Tunneling, u32, u64)],
    show: &mut dyn FnMut(f64),
) -> Result<Vec<RunResult>, Failure> {
    let next = AtomicUsize::new(0);
    let (done, results) = mpsc::channel();
    let thread_count = thread::available_parallelism().map_or(1, |count| count.get());
    let mut all = vec![RunResult::default(); runs.len()];
    thread::scope(|scope| {
        for _ in 0..thread_count {
            let (done, next) = (done.clone(), &next);
            scope.spawn(move || {
                while let Some((index, &(search, length, seed))) = next_run(runs, next) {
                    let started = cpu_secs();
                    let result = search
                        .strip_count(mesh, length, seed)
                        .map(|strip_count| RunResult { strip_count, secs: cpu_secs() - started });
                    // The receiver is gone if another run has failed.
                    if done.send((index, result)).is_err() {
                        return;
                    }
                }
            });
        }
        drop(done);
        for (finished, (index, result)) in results.into_iter().enumerate() {
            all[index] = result?;
            show((finished + 1) as f64 / runs.len() as f64);
        }
        Ok(all)
    })
}

fn next_run<'a, T>(runs: &'a [T], next: &AtomicUsize) -> Option<(usize, &'a T)> {
    let index = next.fetch_add(1, Ordering::Relaxed);
    runs.get(index).map(|run| (index, run))
}

/// Header and rows, one row per length.
pub(super) fn table(rows: &[TunnelRow]) -> Vec<Vec<String>> {
    let mut table = vec![vec!["longest".to_owned()]];
    for of_length in rows.chunk_by(|a, b| a.max_length == b.max_length) {
        if table.len() == 1 {
            for row in of_length {
                table[0].extend([row.search.to_owned(), "range".to_owned(), "s".to_owned()]);
            }
        }
        let mut cells = vec![of_length[0].max_length.to_string()];
        for row in of_length {
            let range = format!("{}–{}", format_count(row.min), format_count(row.max));
            let mean = format!("{} ± {}", tenths(row.mean), tenths(row.std));
            cells.extend([mean, range, format!("{:.3} ± {:.3}", row.secs, row.secs_std)]);
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
pub(super) fn section(rows: &[TunnelRow]) -> Result<PageSection, Failure> {
    let mut names: Vec<&'static str> = Vec::new();
    rows.iter().for_each(|row| {
        if !names.contains(&row.search) {
            names.push(row.search);
        }
    });
    let of = |search: &'static str| rows.iter().filter(move |row| row.search == search);
    let lengths: Vec<f64> =
        names.first().map_or_else(Vec::new, |&name| of(name).map(|row| f64::from(row.max_length)).collect());
    let series = names.iter().map(|&name| PlotSeries {
        name: name.to_owned(),
        points: of(name).map(|row| (f64::from(row.max_length), row.mean)).collect(),
        spread: of(name).map(|row| (row.min as f64, row.max as f64)).collect(),
    });
    let chart = Chart {
        x_title: "longest tunnel",
        y_title: "strips",
        x: Scale::at(&lengths),
        y: Scale::log(rows.iter().flat_map(|row| [row.min as f64, row.max as f64])),
        series: series.collect(),
    };
    let seeds = rows.first().map_or(0, |row| row.seeds);
    Ok(PageSection {
        title: "Strips by the longest tunnel".to_owned(),
        intro: format!(
            "Tunneling from scratch with {seeds} seeds at each length: the line is the mean, the band \
             reaches from the lowest to the highest. The table has the mean, the standard deviation of the \
             sample, the range, and the CPU seconds of a run. {}",
            Tunneling::LEGEND
        ),
        blocks: vec![
            PageBlock::chart(&chart, "Strips against the longest tunnel")?,
            PageBlock::Table(table(rows)),
        ],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_one_decimal() {
        assert_eq!([1234.96, 0.04].map(tenths), ["1,235.0", "0.0"]);
    }

    #[test]
    fn results_are_deterministic_and_longer_tunnels_leave_fewer_strips() {
        let spot = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/spot.obj.zst");
        let mesh = striata_io::read(spot).unwrap();
        let mut shares = Vec::new();
        let mut counts = || {
            let rows =
                measure(&mesh, &Tunneling::ALL, &[1, 3, 5], 3, &mut |share| shares.push(share)).unwrap();
            rows.iter().map(|row| (row.search, row.max_length, row.min, row.max)).collect::<Vec<_>>()
        };
        let rows = counts();
        assert_eq!(counts(), rows);
        assert_eq!(shares.last(), Some(&1.0));
        let lengths = [1, 3, 5].map(|length| [length; Tunneling::ALL.len()]).concat();
        assert_eq!(rows.iter().map(|row| row.1).collect::<Vec<_>>(), lengths);
        for search in Tunneling::ALL {
            let of = rows.iter().filter(|row| row.0 == search.as_str()).map(|row| row.3);
            assert!(of.clone().is_sorted_by(|a, b| a > b), "{search:?}: {:?}", of.collect::<Vec<_>>());
        }
        let at_most = |search: Tunneling, length| {
            rows.iter().find(|row| (row.0, row.1) == (search.as_str(), length)).unwrap().3
        };
        assert!(at_most(Tunneling::Tunnel, 5) < at_most(Tunneling::Grown, 5));
        assert!(at_most(Tunneling::Grown, 5) < at_most(Tunneling::Published, 5));
    }
}
