//! Text tables and page sections of assets.

use super::super::page::{MeshPart, PageBlock, PageSection};
use super::super::plot::{Chart, PlotSeries};
use super::super::scale::Scale;
use super::levels::{LevelRow, SAMPLES};
use super::report::AssetsReport;
use super::summary::AssetSummary;
use striata_command::failure::Failure;
use striata_command::output::{format_count, format_duration};

/// Explanation of the table.
const READING: &str = "RMS, max: 1e-5 of the diagonal, both ways. Normals: degrees. UV: units of UV \
                       space. Gray: RMS of 255 levels over 12 pictures. Color: mean difference of 255 \
                       levels over 12 pictures with materials. dB: signal to noise of these pictures, of gray levels \
                       if there are no materials. Silhouette: covered area over the \
                       original's. A star marks levels with more triangles than requested.";

/// The table with its notes, as text.
pub(in super::super) fn to_text(
    report: &AssetsReport,
    text_of: impl Fn(Vec<Vec<String>>) -> String,
) -> String {
    let notes: String = report.notes.iter().map(|note| format!("{note}\n")).collect();
    format!(
        "Levels of {} triangles. {READING}\n{}{notes}",
        format_count(report.triangle_count),
        text_of(table(report))
    )
}

fn table(report: &AssetsReport) -> Vec<Vec<String>> {
    let head = [
        "at",
        "contender",
        "triangles",
        "RMS",
        "max",
        "normal mean",
        "normal 95 %",
        "UV mean",
        "UV 95 %",
        "gray",
        "color",
        "dB",
        "silhouette",
        "error/max",
        "time",
    ];
    let head = head.map(str::to_owned).to_vec();
    std::iter::once(head).chain(report.levels.iter().map(cells)).collect()
}

fn cells(row: &LevelRow) -> Vec<String> {
    let or_dash = |value: Option<f64>, digits: usize| {
        value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
    };
    let star = if row.is_reached { "" } else { "*" };
    vec![
        format!("{} %", row.percent),
        row.contender.to_owned(),
        format!("{}{star}", format_count(row.triangle_count)),
        format!("{:.2}", 1e5 * row.rms),
        format!("{:.0}", 1e5 * row.max),
        or_dash(row.normal_mean_degrees, 2),
        or_dash(row.normal_p95_degrees, 1),
        or_dash(row.uv_mean, 5),
        or_dash(row.uv_p95, 5),
        format!("{:.2}", row.gray_rms),
        or_dash(row.color_mean, 2),
        or_dash(row.picture_db, 1),
        format!("{:.4}", row.silhouette),
        or_dash(row.error_ratio, 2),
        format_duration(row.secs),
    ]
}

/// The page section with charts and the table.
///
/// # Errors
/// If a chart cannot be drawn.
pub(in super::super) fn section(report: &AssetsReport) -> Result<PageSection, Failure> {
    let mut blocks = vec![PageBlock::chart(
        &chart(report, "RMS distance, 1e-5 of the diagonal", |row| Some(1e5 * row.rms)),
        "RMS distance by triangles",
    )?];
    if report.levels.iter().any(|row| row.normal_mean_degrees.is_some()) {
        let chart = chart(report, "mean angle of normals, degrees", |row| row.normal_mean_degrees);
        blocks.push(PageBlock::chart(&chart, "Angle of normals by triangles")?);
    }
    if report.has_uvs {
        let chart = chart(report, "95 % of UV differences are below", |row| row.uv_p95);
        blocks.push(PageBlock::chart(&chart, "UV difference by triangles")?);
    }
    blocks.push(PageBlock::chart(
        &chart(report, "gray levels", |row| Some(row.gray_rms)),
        "Pictures by triangles",
    )?);
    if report.levels.iter().any(|row| row.color_mean.is_some()) {
        let chart = chart(report, "mean difference of colors", |row| row.color_mean);
        blocks.push(PageBlock::chart(&chart, "Pictures with materials by triangles")?);
    }
    blocks.push(PageBlock::WideTable(table(report)));
    Ok(PageSection {
        title: "Levels next to other simplifiers".to_owned(),
        intro: format!(
            "{READING} Distances are sampled at {SAMPLES} points on each surface, attributes at as many \
             points on the original, each compared with the nearest triangle on the same side. Other \
             tools get the smallest error limit with which they reach the target. The time of striata includes \
             its whole sequence, on one thread; gltfpack's includes the start of Node. {}",
            report.notes.join(" ")
        ),
        blocks,
    })
}

fn chart(report: &AssetsReport, y_title: &'static str, value: fn(&LevelRow) -> Option<f64>) -> Chart {
    // A logarithmic axis cannot show 0.
    let point = |row: &LevelRow| value(row).map(|y| (row.triangle_count as f64, y.max(1e-5)));
    let mut series: Vec<PlotSeries> = Vec::new();
    for row in &report.levels {
        let Some(point) = point(row) else { continue };
        match series.iter_mut().find(|series| series.name == row.contender) {
            Some(series) => series.points.push(point),
            None => {
                let name = row.contender.to_owned();
                series.push(PlotSeries { name, points: vec![point], spread: Vec::new() });
            }
        }
    }
    series.iter_mut().for_each(|series| series.points.sort_by(|a, b| a.0.total_cmp(&b.0)));
    let points = || series.iter().flat_map(|series| &series.points);
    Chart {
        x_title: "triangles",
        y_title,
        x: Scale::log(points().map(|point| point.0)),
        y: Scale::log(points().map(|point| point.1)),
        series,
    }
}

fn summary_table(rows: &[AssetSummary]) -> Vec<Vec<String>> {
    let head =
        ["against the better level of", "in", "striata / it, geometric mean", "striata is worse in", "of"];
    let head = head.map(str::to_owned).to_vec();
    let cells = |row: &AssetSummary| {
        vec![
            row.against.to_owned(),
            row.metric.replace('_', " "),
            format!("{:.3}", row.ratio),
            row.worse_count.to_string(),
            row.level_count.to_string(),
        ]
    };
    std::iter::once(head).chain(rows.iter().map(cells)).collect()
}

/// The summary as text.
pub(in super::super) fn summary_text(
    rows: &[AssetSummary],
    text_of: impl Fn(Vec<Vec<String>>) -> String,
) -> String {
    format!("All assets, levels that reach their target\n{}\n", text_of(summary_table(rows)))
}

/// The summary as a part of the page, or `None` if it is empty.
pub(in super::super) fn summary_part(rows: &[AssetSummary]) -> Option<MeshPart> {
    let section = PageSection {
        title: "striata next to the better variant of each tool".to_owned(),
        intro: "Levels that reach their target, over all assets and shares. Ratios below 1 are in favor of \
                striata."
            .to_owned(),
        blocks: vec![PageBlock::WideTable(summary_table(rows))],
    };
    let part = MeshPart { name: "All assets".to_owned(), summary: String::new(), sections: vec![section] };
    (!rows.is_empty()).then_some(part)
}
