//! Summary of all assets and shares: striata's levels compared with the better level of each other tool.

use serde::Serialize;

use super::levels::LevelRow;
use super::report::AssetsReport;

/// A measured value of a level; lower is better.
type Metric = (&'static str, fn(&LevelRow) -> Option<f64>);

/// The metrics that are summarized.
const METRICS: [Metric; 9] = [
    ("rms", |row| Some(row.rms)),
    ("max", |row| Some(row.max)),
    ("normal_mean", |row| row.normal_mean_degrees),
    ("normal_p95", |row| row.normal_p95_degrees),
    ("uv_mean", |row| row.uv_mean),
    ("uv_p95", |row| row.uv_p95),
    ("gray_rms", |row| Some(row.gray_rms)),
    ("silhouette", |row| Some((row.silhouette - 1.0).abs())),
    ("color_mean", |row| row.color_mean),
];

/// Values below this count as 0 in ratios.
const MIN_VALUE: f64 = 1e-7;

/// Other tools, by the common prefix of their variants' names.
const TOOLS: [&str; 2] = ["gltfpack", "meshoptimizer"];

/// striata compared with the better variant of one other tool, in one metric.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(in super::super) struct AssetSummary {
    /// Name of the other tool.
    pub against: &'static str,
    pub metric: &'static str,
    /// Geometric mean of striata's value over the lowest value of the tool's variants.
    pub ratio: f64,
    /// Number of levels in which striata's value is higher.
    pub worse_count: usize,
    /// Number of levels of both that reach their target and have the value.
    pub level_count: usize,
}

/// Summarizes all assets; a variant is included in the levels in which it reaches its target.
pub(in super::super) fn summarize(reports: &[&AssetsReport]) -> Vec<AssetSummary> {
    let pairs = TOOLS.into_iter().flat_map(|tool| METRICS.map(|metric| (tool, metric)));
    pairs.filter_map(|(tool, metric)| compare(reports, tool, metric)).collect()
}

/// Summarizes one metric against one tool; returns `None` if no level can be compared.
fn compare(
    reports: &[&AssetsReport],
    against: &'static str,
    (metric, value): Metric,
) -> Option<AssetSummary> {
    let (mut logs, mut worse_count, mut level_count) = (0.0, 0, 0);
    for report in reports {
        let reached = || report.levels.iter().filter(|row| row.is_reached);
        for own in reached().filter(|row| row.contender == "striata") {
            let peers =
                reached().filter(|row| row.contender.starts_with(against) && row.percent == own.percent);
            let best = peers.filter_map(value).min_by(f64::total_cmp);
            let (Some(ours), Some(theirs)) = (value(own), best) else { continue };
            let (ours, theirs) = (ours.max(MIN_VALUE), theirs.max(MIN_VALUE));
            logs += (ours / theirs).ln();
            worse_count += usize::from(ours > theirs);
            level_count += 1;
        }
    }
    let ratio = (logs / level_count.max(1) as f64).exp();
    (level_count > 0).then_some(AssetSummary { against, metric, ratio, worse_count, level_count })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(contender: &'static str, percent: f64, rms: f64, is_reached: bool) -> LevelRow {
        LevelRow {
            contender,
            percent,
            target_count: 100,
            triangle_count: 100,
            is_reached,
            rms,
            max: 0.0,
            normal_mean_degrees: None,
            normal_p95_degrees: None,
            uv_mean: None,
            uv_p95: None,
            same_side_share: 1.0,
            gray_rms: 0.0,
            silhouette: 1.0,
            color_mean: None,
            picture_db: None,
            error: None,
            error_ratio: None,
            error_limit: None,
            secs: 0.0,
        }
    }

    #[test]
    fn better_variant_that_reaches_its_target_counts() {
        let levels = vec![
            row("striata", 50.0, 0.2, true),
            row("gltfpack", 50.0, 0.1, false),
            row("gltfpack-sp", 50.0, 0.4, true),
            row("striata", 10.0, 0.4, true),
            row("gltfpack", 10.0, 0.1, true),
            row("gltfpack-sp", 10.0, 0.2, true),
            row("striata", 2.0, 0.4, true),
            row("gltfpack", 2.0, 0.1, false),
        ];
        let report = AssetsReport {
            triangle_count: 200,
            vertex_count: 100,
            has_normals: true,
            has_uvs: false,
            notes: Vec::new(),
            levels,
        };
        let found = summarize(&[&report]);
        // One level at half their RMS, one at four times it; the last one has no competitor.
        let rms = &found[0];
        assert_eq!((rms.against, rms.metric, rms.worse_count, rms.level_count), ("gltfpack", "rms", 1, 2));
        assert!((rms.ratio - 2f64.sqrt()).abs() < 1e-12);
        assert!(found.iter().all(|row| row.metric != "uv_mean" && row.against == "gltfpack"));
    }
}
