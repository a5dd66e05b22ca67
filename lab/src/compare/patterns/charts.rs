//! Page sections of patterns: charts and tables of their memory and extraction time.

use super::super::bars::{BarChart, Bars};
use super::super::page::{PageBlock, PageSection};
use super::super::papers::KG98_BYTES_PER_VERTEX;
use super::super::plot::{Chart, PlotSeries};
use super::super::scale::Scale;
use super::extraction::{ExtractionRow, NAMES};
use super::report::{PatternsReport, extraction_table, table};
use super::sizes::SourceRow;
use striata_command::failure::Failure;

/// The page sections of a patterns report.
///
/// # Errors
/// If a chart cannot be drawn.
pub(in super::super) fn sections(report: &PatternsReport) -> Result<Vec<PageSection>, Failure> {
    let [patterns, explicit] = KG98_BYTES_PER_VERTEX;
    let space = PageSection {
        title: "Patterns".to_owned(),
        intro: format!(
            "{} Ours, the published form and the Multi-Triangulation are measured in memory, including \
             the base and the rules; bytes per vertex without positions. The paper reports {patterns} \
             bytes per vertex, and {explicit} for the Multi-Triangulation.",
            report.about(),
        ),
        blocks: vec![
            PageBlock::bars(&bits_chart(report), "Bits per fragment in each form")?,
            PageBlock::bars(&bytes_chart(report), "Bytes per vertex of each model")?,
            PageBlock::WideTable(table(report)),
        ],
    };
    let time = PageSection {
        title: "Extraction of patterns".to_owned(),
        intro: format!(
            "Time from a new base instance to the coarsest surface within an error limit, including \
             writing its triangles into a buffer; fragments of {}. If time is linear in the triangles \
             extracted, a line is flat. Times are the fastest of several rounds, in which the models \
             take turns; all extract the same triangles.",
            report.extracted_from
        ),
        blocks: vec![
            PageBlock::chart(&time_chart(report), "Time per triangle by triangles extracted")?,
            PageBlock::WideTable(extraction_table(report)),
        ],
    };
    Ok(vec![space, time])
}

fn bar_chart(
    report: &PatternsReport,
    title: &'static str,
    kinds: Vec<&'static str>,
    values: fn(&SourceRow) -> Vec<Option<f64>>,
) -> BarChart {
    let bars = |row: &SourceRow| Bars {
        name: row.source.to_owned(),
        values: values(row).into_iter().flatten().collect(),
    };
    BarChart { title, kinds, bars: report.sources.iter().map(bars).collect() }
}

// Values that may be missing come last, so that the others keep their colors.

fn bits_chart(report: &PatternsReport) -> BarChart {
    let kinds = vec!["ours", "paper's count", "as published", "in sequence"];
    bar_chart(report, "bits per fragment", kinds, |row| {
        vec![
            Some(row.bits_per_fragment),
            Some(row.paper_bits_per_fragment),
            row.loop_bits_per_fragment,
            row.sequential_bits_per_fragment,
        ]
    })
}

fn bytes_chart(report: &PatternsReport) -> BarChart {
    let kinds = vec!["ours", "Multi-Triangulation", "as published"];
    bar_chart(report, "bytes per vertex, without positions", kinds, |row| {
        vec![
            Some(row.bytes_per_vertex),
            Some(row.multi_triangulation_bytes_per_vertex),
            row.loop_bytes_per_vertex,
        ]
    })
}

fn time_chart(report: &PatternsReport) -> Chart {
    let point = |row: &ExtractionRow, name: &str| {
        let time = row.models.iter().find(|time| time.name == name)?;
        Some((row.triangle_count as f64, time.ns_per_triangle?))
    };
    let series: Vec<PlotSeries> = NAMES
        .into_iter()
        .map(|name| PlotSeries {
            name: name.to_owned(),
            points: report.extraction.iter().filter_map(|row| point(row, name)).collect(),
            spread: Vec::new(),
        })
        .collect();
    let all = || series.iter().flat_map(|series| series.points.iter().copied());
    Chart {
        x_title: "triangles extracted",
        y_title: "ns per triangle",
        x: Scale::log(all().map(|point| point.0)),
        y: Scale::linear(all().map(|point| point.1).chain([0.0])),
        series,
    }
}
