//! Conditions on data of overlaps: how many triangles an error limit takes if the errors of single overlaps
//! are known, instead of one error for each fragment.

use serde::Serialize;
use striata::mesh::FragmentedMesh;
use striata::model::{Condition, Overlap, PatternInstance, Patterns};
use striata::simplify::{CertifiedFaces, certify_faces_with_progress};

use striata_command::failure::Failure;
use striata_command::output::{Bar, format_count};

/// Shares of the triangles of the full mesh whose uniform levels give the error limits.
const SHARES: [f64; 4] = [0.5, 0.25, 0.1, 0.02];

/// Triangles of the coarsest surface within one error limit.
#[derive(Clone, Debug, Serialize)]
pub(super) struct OverlapErrorRow {
    /// Share of the triangles of the level whose error is the limit, percent.
    share: f64,
    /// Error limit, mesh units.
    error: f32,
    /// If each fragment has one error, that of its floor, rounded up to a byte.
    by_fragment: usize,
    /// If each overlap has an error of its own, rounded likewise.
    by_overlap: usize,
    /// Ratio of the two.
    ratio: f64,
}

impl OverlapErrorRow {
    /// The cells of the table row.
    pub(super) fn cells(&self) -> Vec<String> {
        vec![
            format!("{:.0} %", self.share),
            format!("{:.3e}", self.error),
            format_count(self.by_fragment),
            format_count(self.by_overlap),
            format!("{:.3}", self.ratio),
        ]
    }
}

/// Header of the table.
pub(super) const HEAD: [&str; 5] = ["error of level", "error", "by fragment", "by overlap", "ratio"];

/// Certifies the errors of all faces, and counts the triangles within the errors of some levels.
///
/// # Errors
/// If there are too many fragments to index.
pub(super) fn measure(mesh: &FragmentedMesh, bar: &mut Bar) -> Result<Vec<OverlapErrorRow>, Failure> {
    let certified = certify_faces_with_progress(mesh, &mut |progress| bar.show(progress));
    let CertifiedFaces { fragmented, face_errors } =
        certified.map_err(|_| Failure::internal("the certification was cancelled"))?;
    let fragments = &fragmented.fragments;
    let by_fragment = Patterns::build(&fragmented)?;
    let by_overlap = Patterns::build_with_overlap_errors(&fragmented, &face_errors)?;
    let levels = fragments.levels();
    let full = levels.triangle_count_at(levels.step_count());
    let row = |share: f64| {
        let level = levels.split_count_for_triangles((share * full as f64) as usize);
        let error = levels.errors().get(level).copied().unwrap_or(0.0);
        let [by_fragment, by_overlap] = [&by_fragment, &by_overlap]
            .map(|patterns| count(patterns, &|overlap: Overlap| overlap.error > error));
        let ratio = by_overlap as f64 / by_fragment.max(1) as f64;
        OverlapErrorRow { share: 100.0 * share, error, by_fragment, by_overlap, ratio }
    };
    Ok(SHARES.map(row).to_vec())
}

fn count(patterns: &Patterns, condition: &impl Condition) -> usize {
    let mut instance = PatternInstance::base(patterns);
    instance.adapt(patterns, condition);
    instance.triangle_count()
}
