//! Page sections of the models: charts and tables of their memory and of their walks.

use super::bars::{BarChart, Bars};
use super::models::{Basis, ModelRow, ModelsReport, POSITION_BYTES, table, walk_table};
use super::page::{PageBlock, PageSection};
use super::plot::{Chart, PlotSeries};
use super::scale::Scale;
use super::walks;
use crate::pace::Pace;
use striata_command::failure::Failure;

/// The page sections of a models report.
///
/// # Errors
/// If a chart cannot be drawn.
pub(super) fn sections(report: &ModelsReport) -> Result<Vec<PageSection>, Failure> {
    let Basis { frames, rounds, .. } = report.basis;
    let space = PageSection {
        title: "Models".to_owned(),
        intro: format!(
            "{}.{} All models are built from the same sequence, and strip models from the same strips; \
             at every level they show the same triangles; models with few levels show the next coarser \
             one. Bytes per vertex are those of the static data without positions; the next two columns \
             add {POSITION_BYTES} bytes per vertex for positions. Papers count their own structures with \
             4 bytes per number, index or pointer, here with positions added. Plain means positions and \
             strips without levels. Instance is the additional memory of each object on the screen, in \
             bytes per vertex. Steps: from the full mesh to the base and back, one at a time. Random \
             access: the mean move between random levels. Each time is the fastest of {rounds} rounds, \
             in which the models take turns.",
            report.basis.summary(),
            report.refusals()
        ),
        blocks: vec![
            PageBlock::bars(&space_chart(report), "Bytes per vertex of each model")?,
            PageBlock::chart(&space_and_time(report), "Space against time")?,
            PageBlock::WideTable(table(report)),
        ],
    };
    let mut sections = vec![space];
    for pace in Pace::ALL {
        sections.push(PageSection {
            title: format!("{} walk", pace.title()),
            intro: format!(
                "{} There are {frames} frames from near to far and as many back; tables show means over \
                 all, charts each frame, averaged over both directions. Extraction is moving to the \
                 level; sending copies all indices to a buffer, which is the CPU work of immediate mode; \
                 fans and ordered meshes create their triangles only then. Times are the fastest of \
                 {rounds} rounds; times below 0.1 µs are within the cost of reading the clock.",
                match pace {
                    Pace::Linear => "The level falls evenly with time.",
                    Pace::Exponential =>
                        "The level changes much while the object is near, and little far away.",
                }
            ),
            blocks: walk_blocks(report, pace)?,
        });
    }
    Ok(sections)
}

fn space_chart(report: &ModelsReport) -> BarChart {
    let per_vertex = |bytes: usize| bytes as f64 / report.basis.vertex_count.max(1) as f64;
    let bars = |row: &ModelRow| Bars {
        name: row.name.to_owned(),
        values: vec![per_vertex(row.total_bytes), per_vertex(row.paper_bytes)],
    };
    let plain = per_vertex(report.basis.plain_bytes);
    BarChart {
        title: "bytes per vertex, including positions",
        kinds: vec!["as stored", "as the papers count"],
        bars: std::iter::once(Bars { name: "plain strips".to_owned(), values: vec![plain] })
            .chain(report.rows.iter().map(bars))
            .collect(),
    }
}

/// Each model as a point: memory against the frame time of the linear walk.
fn space_and_time(report: &ModelsReport) -> Chart {
    let points: Vec<(f64, f64)> = report
        .rows
        .iter()
        .map(|row| {
            let bytes = row.total_bytes as f64 / report.basis.vertex_count.max(1) as f64;
            (bytes, row.walk(Pace::Linear).extract_and_send_secs * 1e6)
        })
        .collect();
    let series = report.rows.iter().zip(&points).map(|(row, &point)| PlotSeries {
        name: row.name.to_owned(),
        points: vec![point],
        spread: Vec::new(),
    });
    Chart {
        x_title: "bytes per vertex, including positions",
        y_title: "extraction and sending, µs",
        x: Scale::linear(points.iter().map(|point| point.0).chain([0.0])),
        y: Scale::log(points.iter().map(|point| point.1)),
        series: series.collect(),
    }
}

fn walk_blocks(report: &ModelsReport, pace: Pace) -> Result<Vec<PageBlock>, Failure> {
    type Values = fn(&walks::WalkSeries) -> Vec<f64>;
    let chart = |y_title: &'static str, is_log: bool, only_strips: bool, values: Values| {
        let series: Vec<PlotSeries> = report
            .rows
            .iter()
            .map(|row| {
                let walk = &row.walk(pace).series;
                let points = walk.frame.iter().map(|&frame| frame as f64).zip(values(walk));
                // A model without points still reserves its color.
                let is_shown = row.draws_strips || !only_strips;
                PlotSeries {
                    name: row.name.to_owned(),
                    points: if is_shown { points.collect() } else { Vec::new() },
                    spread: Vec::new(),
                }
            })
            .collect();
        let all = || series.iter().flat_map(|series| series.points.iter().map(|&(_, y)| y));
        let y = if is_log { Scale::log(all()) } else { Scale::linear(all().chain([0.0])) };
        let frames = report.basis.frames as f64;
        let x = Scale::at(&[0.0, 0.25, 0.5, 0.75, 1.0].map(|share| (share * frames).round()));
        Chart { x_title: "frame, near to far", y_title, x, y, series }
    };
    let extraction = chart("extraction, µs", true, false, |s| in_micros(&s.extract_secs));
    let sending = chart("extraction and sending, µs", true, false, |s| in_micros(&s.extract_and_send_secs));
    let mut blocks = vec![
        PageBlock::chart(&extraction, "Time of extraction by frame")?,
        PageBlock::chart(&sending, "Time of extraction and sending by frame")?,
    ];
    if pace == Pace::Linear {
        let indices = chart("indices", false, false, |s| as_floats(&s.index_count));
        let strips = chart("strips", false, true, |s| as_floats(&s.strip_count));
        blocks.push(PageBlock::chart(&indices, "Indices by frame")?);
        blocks.push(PageBlock::chart(&strips, "Strips by frame")?);
    }
    blocks.push(PageBlock::WideTable(walk_table(report, pace)));
    Ok(blocks)
}

fn in_micros(secs: &[f64]) -> Vec<f64> {
    secs.iter().map(|secs| secs * 1e6).collect()
}

fn as_floats(counts: &[usize]) -> Vec<f64> {
    counts.iter().map(|&count| count as f64).collect()
}
