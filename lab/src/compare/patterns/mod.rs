//! Compares patterns with their alternatives: memory of fragments from several sources in each form, and
//! the time to extract a level by a condition on errors.
//!
//! The paper, \[KG98\], accepts any simplifier. Therefore fragments come from collapses in quadric order,
//! from vertices removed by Hausdorff distance, with holes filled freely or as collapses would, and from
//! edges and triangles collapsed to new vertices.

mod charts;
mod extraction;
mod or_dash;
mod overlap_errors;
mod report;
mod sizes;
mod source;

use striata::mesh::{IndexedMesh, RefinableMesh};

pub(super) use self::charts::sections;
pub(super) use self::report::PatternsReport;
use self::report::{extraction_table, overlap_error_table, table};
use self::sizes::{Models, SourceRow};
use self::source::FragmentSource;
use striata_command::failure::Failure;
use striata_command::output::Bar;

/// Builds the fragments in all forms, and times the extraction.
///
/// # Errors
/// If the mesh is inconsistent, or models extract different triangles, which would be a bug.
pub(super) fn measure(
    mesh: &IndexedMesh,
    refinable: &RefinableMesh,
    sequence_secs: f64,
    bar: &mut Bar,
    say: &dyn Fn(&str),
) -> Result<PatternsReport, Failure> {
    let mut sources = Vec::new();
    let (mut extracted_from, mut extraction, mut overlap_errors) = ("", Vec::new(), Vec::new());
    for source in FragmentSource::ALL {
        say(&format!("fragments, {}", source.as_str()));
        let started = std::time::Instant::now();
        let fragmented = source.fragments(mesh, refinable, bar)?;
        let before = if source == FragmentSource::Quadric { sequence_secs } else { 0.0 };
        let fragments_secs = before + started.elapsed().as_secs_f64();
        say(&format!("patterns, {}", source.as_str()));
        let models = Models::build(&fragmented)?;
        sources.push(SourceRow::new(source, &models, fragments_secs));
        if source == FragmentSource::Removal {
            say("extraction");
            extraction = extraction::measure(&models, &mut |share| bar.share("timing", share))?;
            extracted_from = source.as_str();
            say("errors of overlaps");
            overlap_errors = overlap_errors::measure(&fragmented, bar)?;
        }
    }
    Ok(PatternsReport {
        triangle_count: refinable.mesh.triangle_count(),
        vertex_count: refinable.mesh.vertex_count(),
        sources,
        extracted_from,
        extraction,
        overlap_errors,
    })
}

/// The tables, with explanations of their columns.
pub(super) fn to_text(report: &PatternsReport, text_of: impl Fn(Vec<Vec<String>>) -> String) -> String {
    format!(
        "Patterns. {}\n{}\nExtraction from the base by a condition on errors, fragments of {}\n{}\n\
         Triangles within an error limit, with one error for each fragment and for each overlap\n{}",
        report.about(),
        text_of(table(report)),
        report.extracted_from,
        text_of(extraction_table(report)),
        text_of(overlap_error_table(report)),
    )
}
