//! Time against quality of every stripifier, including search-based ones with several time budgets.

use std::time::Instant;

use serde::Serialize;
use striata::mesh::{IndexedMesh, canonical_triangles};
use striata::strip::StripSet;
use striata_lab::stripifiers::{join_like_tomesh, strips_of};

use super::page::{PageBlock, PageSection};
use super::plot::{Chart, PlotSeries};
use super::scale::Scale;
use striata_command::args::StripSearchArgs;
use striata_command::failure::Failure;
use striata_command::output::{format_count, format_duration};
use striata_command::strip_chain::{StripChain, StripPlan, TimedStrips};
use striata_command::strip_report::StripReport;

/// Number of runs of stripifiers without a time budget; the fastest one is reported.
const RUN_COUNT: usize = 3;

/// The result of one stripifier within one budget.
#[derive(Clone, Debug, Serialize)]
pub(super) struct StripifierRow {
    #[serde(flatten)]
    report: StripReport,
    /// Time budget in seconds; none if it ran for its usual number of moves, or until it was finished.
    budget_secs: Option<f64>,
    secs: f64,
}

/// Runs every chain; search-based ones also with each budget. Other tools come last.
///
/// # Errors
/// If the mesh is inconsistent, or strips do not show the mesh.
pub(super) fn measure(
    mesh: &IndexedMesh,
    chains: &[StripChain],
    budgets: &[f64],
    show: &mut dyn FnMut(&str),
) -> Result<Vec<StripifierRow>, Failure> {
    let expected = canonical_triangles(&proper_triangles(mesh));
    let mut rows = Vec::new();
    let mut push = |name: &str, budget_secs, stripped: &TimedStrips| {
        check(name, &stripped.strips, &expected)?;
        let report = StripReport::new(name.to_owned(), mesh, stripped, 16)?;
        rows.push(StripifierRow { report, budget_secs, secs: stripped.secs });
        Ok::<(), Failure>(())
    };
    for chain in chains {
        let name = chain.to_string();
        show(&name);
        let plan = StripPlan { chain: chain.clone(), search: StripSearchArgs::default() };
        if !chain.searches() {
            push(&name, None, &fastest_run(|| Ok(plan.run(mesh, &mut |_| ())?))?)?;
            continue;
        }
        for &secs in budgets {
            let plan = plan.with_budget(secs);
            push(&name, Some(secs), &plan.run(mesh, &mut |_| ())?)?;
        }
        push(&name, None, &plan.run(mesh, &mut |_| ())?)?;
    }
    show("tomesh");
    push("tomesh", None, &fastest_run(|| tomesh(mesh))?)?;
    #[cfg(feature = "peers")]
    for (name, stripify) in super::peers::PEERS {
        show(name);
        push(name, None, &fastest_run(|| stripify(mesh))?)?;
    }
    Ok(rows)
}

/// The strips of SGI's `tomesh`.
fn tomesh(mesh: &IndexedMesh) -> Result<TimedStrips, Failure> {
    let started = Instant::now();
    let strips = strips_of(mesh, join_like_tomesh)?;
    Ok(TimedStrips { strips, secs: started.elapsed().as_secs_f64() })
}

fn fastest_run(mut run: impl FnMut() -> Result<TimedStrips, Failure>) -> Result<TimedStrips, Failure> {
    let mut best = run()?;
    for _ in 1..RUN_COUNT {
        let stripped = run()?;
        if stripped.secs < best.secs {
            best = stripped;
        }
    }
    Ok(best)
}

fn proper_triangles(mesh: &IndexedMesh) -> Vec<[u32; 3]> {
    mesh.triangles.iter().copied().filter(|&[a, b, c]| a != b && b != c && c != a).collect()
}

/// Checks that the strips show the mesh; a comparison would be worthless otherwise.
fn check(name: &str, strips: &StripSet, expected: &[[u32; 3]]) -> Result<(), Failure> {
    let mut triangles = Vec::with_capacity(expected.len());
    strips.triangles_into(&mut triangles);
    if canonical_triangles(&triangles) == expected {
        return Ok(());
    }
    Err(Failure::internal(format!("the strips of {name} do not have the triangles of the mesh")))
}

impl StripifierRow {
    fn budget(&self) -> String {
        self.budget_secs.map_or_else(|| "-".to_owned(), |secs| format!("{secs} s"))
    }
}

/// Header and rows of the table.
pub(super) fn table(rows: &[StripifierRow]) -> Vec<Vec<String>> {
    let head = [
        "stripifier",
        "budget",
        "time",
        "strips",
        "swaps",
        "indices",
        "indices per triangle",
        "ACMR, FIFO 16",
        "ATVR, FIFO 16",
    ];
    let mut table = vec![head.map(str::to_owned).to_vec()];
    for row in rows {
        let report = &row.report;
        table.push(vec![
            report.algorithm.clone(),
            row.budget(),
            format_duration(row.secs),
            format_count(report.strip_count),
            format_count(report.swap_count),
            format_count(report.index_count),
            format!("{:.4}", report.indices_per_triangle),
            format!("{:.4}", report.acmr_16),
            format!("{:.4}", report.atvr_16),
        ]);
    }
    table
}

/// The page section with two charts and the table.
///
/// # Errors
/// If a chart cannot be drawn.
pub(super) fn section(rows: &[StripifierRow]) -> Result<PageSection, Failure> {
    let indices = |row: &StripifierRow| row.report.indices_per_triangle;
    let strips = |row: &StripifierRow| row.report.strip_count as f64;
    let x = Scale::log(rows.iter().map(|row| row.secs));
    let by_indices = Chart {
        x_title: "seconds",
        y_title: "indices per triangle",
        x: x.clone(),
        y: Scale::linear(rows.iter().map(indices)),
        series: series(rows, indices),
    };
    let by_strips = Chart {
        x_title: "seconds",
        y_title: "strips",
        x,
        y: Scale::log(rows.iter().map(strips)),
        series: series(rows, strips),
    };
    Ok(PageSection {
        title: "Time against quality".to_owned(),
        intro: format!(
            "Lower and further left is better. The points of a search-based stripifier are joined by a \
             line: one for each budget, and one, without a budget in the table, for its usual number of \
             moves. Times are for one thread; other stripifiers show the fastest of {RUN_COUNT} runs. \
             Indices include swaps and restarts; misses are those of a first-in first-out cache of 16 \
             vertices, per triangle (ACMR) and per vertex (ATVR)."
        ),
        blocks: vec![
            PageBlock::chart(&by_indices, "Indices per triangle against time")?,
            PageBlock::chart(&by_strips, "Strips against time")?,
            PageBlock::WideTable(table(rows)),
        ],
    })
}

/// One series per stripifier, from the shortest to the longest time.
fn series(rows: &[StripifierRow], value_of: impl Fn(&StripifierRow) -> f64) -> Vec<PlotSeries> {
    let same = |a: &StripifierRow, b: &StripifierRow| a.report.algorithm == b.report.algorithm;
    let of_stripifier = |rows: &[StripifierRow]| {
        let mut points: Vec<(f64, f64)> = rows.iter().map(|row| (row.secs, value_of(row))).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let name = rows.first().map_or(String::new(), |row| row.report.algorithm.clone());
        PlotSeries { name, points, spread: Vec::new() }
    };
    rows.chunk_by(same).map(of_stripifier).collect()
}
