//! What was measured of patterns, and its tables.

use serde::Serialize;

use super::extraction::{self, ExtractionRow};
use super::or_dash::or_dash;
use super::sizes::SourceRow;
use super::source::Source;
use crate::compare::papers::{KG98_FRAGMENT_BITS, KG98_OVERLAPS, KG98_SEQUENTIAL_BITS};
use striata_command::output::{format_count, format_duration};

/// What was measured of one mesh.
#[derive(Clone, Debug, Serialize)]
pub(in crate::compare) struct PatternsReport {
    /// Of the welded mesh.
    pub(super) triangle_count: usize,
    pub(super) vertex_count: usize,
    pub(super) sources: Vec<SourceRow>,
    /// Which source the times are of.
    pub(super) extracted_from: &'static str,
    pub(super) extraction: Vec<ExtractionRow>,
}

impl PatternsReport {
    /// What is measured, and what could not be built, in sentences.
    pub(super) fn about(&self) -> String {
        let mut text = String::from("Fragments of");
        for (i, source) in Source::ALL.into_iter().enumerate() {
            let joint = if i == 0 { " " } else { "; " };
            text.push_str(&format!("{joint}{}: {}", source.as_str(), source.about()));
        }
        text.push_str(&format!(
            ". What [KG98] counts is 116 bits a fragment and 36 an overlap: {KG98_FRAGMENT_BITS} bits where there are \
             {KG98_OVERLAPS} overlaps to a fragment; its form for transmission takes {KG98_SEQUENTIAL_BITS}.",
        ));
        for row in &self.sources {
            if let Some(why) = row.refusal() {
                text.push_str(&format!(" The published form cannot hold {}: {why}.", row.source));
            }
        }
        text
    }
}

/// Head and rows: what forms take.
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
        "in sequence",
        "bytes a vertex",
        "with bounds",
        "as published",
        "Multi-Triangulation",
        "its paper's count",
        "/ ours",
    ];
    let mut table = vec![head.map(str::to_owned).to_vec()];
    table.extend(report.sources.iter().map(SourceRow::cells));
    table
}

/// Head and rows: what extraction takes.
pub(super) fn extraction_table(report: &PatternsReport) -> Vec<Vec<String>> {
    let mut head = vec!["error".to_owned(), "triangles".to_owned(), "fragments".to_owned()];
    for name in extraction::NAMES {
        head.extend([format!("{name}, ms"), "ns a triangle".to_owned()]);
    }
    let mut table = vec![head];
    table.extend(report.extraction.iter().map(ExtractionRow::cells));
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
            or_dash(self.sequential_bits_per_fragment, 1),
            format!("{:.1}", self.bytes_per_vertex),
            format!("{:.1}", self.bytes_per_vertex_with_bounds),
            or_dash(self.loop_bytes_per_vertex, 1),
            format!("{:.1}", self.multi_triangulation_bytes_per_vertex),
            format!("{:.1}", self.multi_triangulation_paper_bytes_per_vertex),
            format!("{:.2}", self.multi_triangulation_ratio),
        ]
    }
}
