//! Patterns beside what they replace: fragments of several sources, what they take in each form, and how long it takes to
//! extract a level by a condition on errors.
//!
//! The paper, \[KG98\], takes any simplifier. So the same is measured of collapses in the order of quadrics and of vertices removed by
//! Hausdorff distance, with holes filled in any way and as collapses would.

mod charts;
mod extraction;
mod sizes;

use serde::Serialize;
use striata::mesh::{FragmentedMesh, IndexedMesh, RefinableMesh};
use striata::simplify::{RemovalOptions, Retriangulation, build_fragments_with_progress};

pub(super) use self::charts::sections;
use self::extraction::ExtractionRow;
use self::sizes::{Models, SourceRow};
use super::papers::{KG98_FRAGMENT_BITS, KG98_OVERLAPS, KG98_SEQUENTIAL_BITS};
use striata_command::failure::Failure;
use striata_command::output::{Bar, grouped, lasted};

/// What was measured of one mesh.
#[derive(Clone, Debug, Serialize)]
pub(super) struct PatternsReport {
    /// Of the welded mesh.
    triangle_count: usize,
    vertex_count: usize,
    sources: Vec<SourceRow>,
    /// Which source the times are of.
    extracted_from: &'static str,
    extraction: Vec<ExtractionRow>,
}

/// Where fragments come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Source {
    /// Half-edge collapses in the order of quadrics.
    Quadric,
    /// Removed vertices, holes filled in any way.
    Removal,
    /// Removed vertices, holes filled as collapses do.
    RemovalCollapse,
}

impl Source {
    /// All; times are those of the paper's, in the middle.
    const ALL: [Self; 3] = [Self::Quadric, Self::Removal, Self::RemovalCollapse];

    const fn as_str(self) -> &'static str {
        match self {
            Self::Quadric => "quadric",
            Self::Removal => "removal",
            Self::RemovalCollapse => "removal-collapse",
        }
    }

    const fn about(self) -> &'static str {
        match self {
            Self::Quadric => "half-edge collapses in the order of quadrics",
            Self::Removal => {
                "vertices removed by summed squared distances, gaps and the largest distance, holes filled in any way"
            }
            Self::RemovalCollapse => "the same, holes filled as half-edge collapses do",
        }
    }

    /// # Errors
    /// Where the mesh does not hang together.
    fn fragments(
        self,
        mesh: &IndexedMesh,
        refinable: &RefinableMesh,
        bar: &mut Bar,
    ) -> Result<FragmentedMesh, Failure> {
        let how = match self {
            Self::Quadric => return Ok(FragmentedMesh::from_collapses(refinable)),
            Self::Removal => Retriangulation::Free,
            Self::RemovalCollapse => Retriangulation::Collapse,
        };
        let options = RemovalOptions::default().with_retriangulation(how);
        Ok(build_fragments_with_progress(mesh, &options, &mut |progress| bar.show(progress))?.fragmented)
    }
}

/// Builds the fragments and all forms of them, and times the extraction.
///
/// # Errors
/// Where the mesh does not hang together, or models show different things, which is our fault.
pub(super) fn measure(
    mesh: &IndexedMesh,
    (refinable, sequence_secs): (&RefinableMesh, f64),
    bar: &mut Bar,
    say: &dyn Fn(&str),
) -> Result<PatternsReport, Failure> {
    let mut sources = Vec::new();
    let (mut extracted_from, mut extraction) = ("", Vec::new());
    for source in Source::ALL {
        say(&format!("fragments, {}", source.as_str()));
        let started = std::time::Instant::now();
        let fragmented = source.fragments(mesh, refinable, bar)?;
        let before = if source == Source::Quadric { sequence_secs } else { 0.0 };
        let fragments_secs = before + started.elapsed().as_secs_f64();
        say(&format!("patterns, {}", source.as_str()));
        let models = Models::build(&fragmented)?;
        sources.push(SourceRow::new(source, &models, fragments_secs));
        if source == Source::Removal {
            say("extraction");
            extraction = extraction::measure(&models, &mut |share| bar.share("timing", share))?;
            extracted_from = source.as_str();
        }
    }
    Ok(PatternsReport {
        triangle_count: refinable.mesh.triangle_count(),
        vertex_count: refinable.mesh.vertex_count(),
        sources,
        extracted_from,
        extraction,
    })
}

impl PatternsReport {
    /// What is measured, and what could not be built, in sentences.
    fn about(&self) -> String {
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
fn table(report: &PatternsReport) -> Vec<Vec<String>> {
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
fn extraction_table(report: &PatternsReport) -> Vec<Vec<String>> {
    let mut head = vec!["error".to_owned(), "triangles".to_owned(), "fragments".to_owned()];
    for name in extraction::NAMES {
        head.extend([format!("{name}, ms"), "ns a triangle".to_owned()]);
    }
    let mut table = vec![head];
    table.extend(report.extraction.iter().map(ExtractionRow::cells));
    table
}

/// The tables for people, with what is to be known about them.
pub(super) fn to_text(report: &PatternsReport, text_of: impl Fn(Vec<Vec<String>>) -> String) -> String {
    format!(
        "Patterns. {}\n{}\nExtraction from the base by a condition on errors, fragments of {}\n{}",
        report.about(),
        text_of(table(report)),
        report.extracted_from,
        text_of(extraction_table(report))
    )
}

/// A number, or that there is none.
fn or_dash(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
}

impl SourceRow {
    fn cells(&self) -> Vec<String> {
        vec![
            self.source.to_owned(),
            grouped(self.fragment_count),
            lasted(self.fragments_secs),
            grouped(self.rule_count),
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
