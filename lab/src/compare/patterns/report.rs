//! Report of the comparison of patterns, and its tables.

use serde::Serialize;

use super::extraction::{self, ExtractionRow};
use super::or_dash::or_dash;
use super::overlap_errors::{self, OverlapErrorRow};
use super::sizes::SourceRow;
use super::source::FragmentSource;
use crate::compare::papers::{KG98_FRAGMENT_BITS, KG98_OVERLAPS, KG98_SEQUENTIAL_BITS};
use striata_command::output::{format_count, format_duration};

/// The report of one mesh.
#[derive(Clone, Debug, Serialize)]
pub(in crate::compare) struct PatternsReport {
    /// Number of triangles of the welded mesh.
    pub(super) triangle_count: usize,
    pub(super) vertex_count: usize,
    pub(super) sources: Vec<SourceRow>,
    /// The source whose extraction is timed.
    pub(super) extracted_from: &'static str,
    pub(super) extraction: Vec<ExtractionRow>,
    /// Triangles within error limits, for the same source.
    pub(super) overlap_errors: Vec<OverlapErrorRow>,
}

impl PatternsReport {
    /// Sentences describing the measurements and naming what could not be built.
    pub(super) fn about(&self) -> String {
        let mut text = String::from("Fragments of");
        for (i, source) in FragmentSource::ALL.into_iter().enumerate() {
            let separator = if i == 0 { " " } else { "; " };
            text.push_str(&format!("{separator}{}: {}", source.as_str(), source.about()));
        }
        text.push_str(&format!(
            ". [KG98] counts 116 bits per fragment and 36 per overlap, which is {KG98_FRAGMENT_BITS} \
             bits with {KG98_OVERLAPS} overlaps per fragment; its form for transmission takes \
             {KG98_SEQUENTIAL_BITS}.",
        ));
        for row in &self.sources {
            if let Some(why) = row.refusal() {
                text.push_str(&format!(" The published form cannot represent {}: {why}.", row.source));
            }
        }
        text
    }
}

/// Header and rows: memory of the forms.
pub(super) fn table(report: &PatternsReport) -> Vec<Vec<String>> {
    let head = [
        "fragments of",
        "fragments",
        "made in",
        "rules",
        "overlaps each",
        "bits, paper's count",
        "ours",
        "as published",
        "for any ceiling",
        "in sequence",
        "bytes per vertex",
        "with bounds",
        "as published",
        "Multi-Triangulation",
        "its paper's count",
        "without errors / ours",
        "/ ours with bounds",
        "opened in",
    ];
    let mut table = vec![head.map(str::to_owned).to_vec()];
    table.extend(report.sources.iter().map(SourceRow::cells));
    table
}

/// Header and rows: extraction times.
pub(super) fn extraction_table(report: &PatternsReport) -> Vec<Vec<String>> {
    let mut head = vec!["error".to_owned(), "triangles".to_owned(), "fragments".to_owned()];
    for name in extraction::NAMES {
        head.extend([format!("{name}, ms"), "ns per triangle".to_owned()]);
    }
    let mut table = vec![head];
    table.extend(report.extraction.iter().map(ExtractionRow::cells));
    table
}

/// Header and rows: triangles within error limits.
pub(super) fn overlap_error_table(report: &PatternsReport) -> Vec<Vec<String>> {
    let mut table = vec![overlap_errors::HEAD.map(str::to_owned).to_vec()];
    table.extend(report.overlap_errors.iter().map(OverlapErrorRow::cells));
    table
}

impl SourceRow {
    fn cells(&self) -> Vec<String> {
        vec![
            self.source.to_owned(),
            format_count(self.fragment_count),
            format_duration(self.fragments_secs),
            format_count(self.rule_count),
            format!("{:.2}", self.overlaps_per_fragment),
            format!("{:.1}", self.paper_bits_per_fragment),
            format!("{:.1}", self.bits_per_fragment),
            or_dash(self.loop_bits_per_fragment, 1),
            or_dash(self.general_bits_per_fragment, 1),
            or_dash(self.sequential_bits_per_fragment, 1),
            format!("{:.1}", self.bytes_per_vertex),
            format!("{:.1}", self.bytes_per_vertex_with_bounds),
            or_dash(self.loop_bytes_per_vertex, 1),
            format!("{:.1}", self.multi_triangulation_bytes_per_vertex),
            format!("{:.1}", self.multi_triangulation_paper_bytes_per_vertex),
            format!("{:.2}", self.multi_triangulation_ratio),
            format!("{:.2}", self.multi_triangulation_ratio_with_bounds),
            format_duration(self.open_secs),
        ]
    }
}
