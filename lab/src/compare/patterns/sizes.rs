//! Memory of fragments in each form.

use std::time::Instant;

use serde::Serialize;
use striata::file::{FileModel, StriataFile, WriteOptions, write_fragments};
use striata::mesh::FragmentedMesh;
use striata::model::{LodModel, Patterns};
use striata_lab::baseline::{GeneralPatterns, LoopPatterns, MultiTriangulation, SequentialPatterns};
use striata_lab::{Accounting, PaperBytes};

use super::source::FragmentSource;
use striata_command::failure::Failure;

/// All forms of the same fragments.
pub(super) struct Models {
    /// Our patterns.
    pub patterns: Patterns,
    build_secs: f64,
    /// Bytes of the bounds that view-dependent refinement needs, and of an error for each overlap.
    bounds_bytes: usize,
    overlap_error_bytes: usize,
    /// Size of a `.striata` file with the patterns alone, and the fastest time to open it, seconds.
    file_bytes: usize,
    open_secs: f64,
    /// The published form, or why it cannot be built.
    pub loops: Result<LoopPatterns, String>,
    loop_build_secs: f64,
    /// The published form with rules for any ceiling, or why it cannot be built.
    general: Result<GeneralPatterns, String>,
    sequential: Option<SequentialPatterns>,
    /// The explicit model.
    pub explicit: MultiTriangulation,
    explicit_build_secs: f64,
    /// Error of each fragment's floor.
    pub errors: Vec<f32>,
    /// For each level, the largest error of the fragments it omits.
    pub level_errors: Vec<f32>,
    /// Number of triangles of each level.
    pub triangle_counts: Vec<usize>,
    vertex_count: usize,
}

impl Models {
    /// Builds all forms that can be built.
    ///
    /// # Errors
    /// If there are too many fragments to index.
    pub(super) fn build(mesh: &FragmentedMesh) -> Result<Self, Failure> {
        let (patterns, build_secs) = timed(|| Patterns::build_without_bounds(mesh));
        let patterns = patterns?;
        let bounded = Patterns::build(mesh)?;
        let bounds_bytes = bytes_of(&bounded) - bytes_of(&patterns);
        // The size does not depend on the errors.
        let face_errors = vec![0.0; mesh.fragments.faces().len()];
        let with_errors = bytes_of(&Patterns::build_with_overlap_errors(mesh, &face_errors)?);
        let (file_bytes, open_secs) = opened(mesh, &bounded)?;
        let (loops, loop_build_secs) = timed(|| LoopPatterns::build(mesh));
        let (explicit, explicit_build_secs) = timed(|| MultiTriangulation::build(mesh));
        let levels = mesh.fragments.levels();
        let step_count = levels.step_count();
        Ok(Self {
            patterns,
            build_secs,
            bounds_bytes,
            overlap_error_bytes: with_errors.saturating_sub(bytes_of(&bounded)),
            file_bytes,
            open_secs,
            loops: loops.map_err(|error| error.to_string()),
            loop_build_secs,
            general: GeneralPatterns::build(mesh).map_err(|error| error.to_string()),
            sequential: SequentialPatterns::encode(mesh).ok(),
            explicit,
            explicit_build_secs,
            errors: (0..step_count as u32).map(|step| mesh.fragments.floor_error(step)).collect(),
            level_errors: levels.errors().to_vec(),
            triangle_counts: (0..=step_count).map(|at| levels.triangle_count_at(at)).collect(),
            vertex_count: mesh.mesh.vertex_count(),
        })
    }
}

/// Number of times that a file is opened; the fastest one counts.
const OPEN_COUNT: usize = 3;

/// Writes a file with patterns only, and opens it with all checks. Returns its size and the time.
fn opened(mesh: &FragmentedMesh, patterns: &Patterns) -> Result<(usize, f64), Failure> {
    let mut bytes = Vec::new();
    write_fragments(mesh, &[FileModel::Patterns(patterns)], &WriteOptions::default(), &mut bytes)?;
    let mut fastest = f64::INFINITY;
    for _ in 0..OPEN_COUNT {
        let (found, secs) = timed(|| StriataFile::parse(&bytes)?.patterns().transpose());
        let found = found.map_err(|error| Failure::internal(error.to_string()))?;
        if found.as_ref() != Some(patterns) {
            return Err(Failure::internal("a file does not contain the patterns that were written"));
        }
        fastest = fastest.min(secs);
    }
    Ok((bytes.len(), fastest))
}

fn timed<T>(build: impl FnOnce() -> T) -> (T, f64) {
    let started = Instant::now();
    let built = build();
    (built, started.elapsed().as_secs_f64())
}

/// The fragments of one source and their memory. Bytes are those of the static data without positions;
/// bits per fragment include the base and the tables of rules.
#[derive(Clone, Debug, Serialize)]
pub(super) struct SourceRow {
    /// Name of the source.
    pub source: &'static str,
    /// Number of fragments.
    pub fragment_count: usize,
    /// Seconds to build the fragments.
    pub fragments_secs: f64,
    /// Number of kinds of fragments.
    pub rule_count: usize,
    /// Number of kinds of fragments in the published form; null if it cannot represent them.
    loop_rule_count: Option<usize>,
    /// Number of pairs of overlapping fragments.
    overlap_count: usize,
    pub overlaps_per_fragment: f64,
    /// Bits as the paper counts, with the actual number of overlaps.
    pub paper_bits_per_fragment: f64,
    pub bits_per_fragment: f64,
    /// In the published form; null if it cannot represent them.
    pub loop_bits_per_fragment: Option<f64>,
    /// In the form for transmission, fragments only; null if it cannot represent them.
    pub sequential_bits_per_fragment: Option<f64>,
    /// Size of the form for transmission, including the base and the rules.
    sequential_bytes: Option<usize>,
    bytes: usize,
    pub bytes_per_vertex: f64,
    /// Including the bounds that view-dependent refinement needs.
    pub bytes_per_vertex_with_bounds: f64,
    /// Including the bounds and an error for each overlap.
    bytes_per_vertex_with_overlap_errors: f64,
    /// Size of a `.striata` file with the patterns alone.
    file_bytes: usize,
    /// Fastest time to open that file, with all checks.
    pub open_secs: f64,
    loop_bytes: Option<usize>,
    pub loop_bytes_per_vertex: Option<f64>,
    /// Number of rules of the published form for any ceiling; null if it cannot represent the fragments.
    general_rule_count: Option<usize>,
    /// Bits in that form.
    pub general_bits_per_fragment: Option<f64>,
    general_bytes_per_vertex: Option<f64>,
    /// Why that form cannot represent the fragments; null if it can.
    cannot_be_general: Option<String>,
    multi_triangulation_bytes: usize,
    pub multi_triangulation_bytes_per_vertex: f64,
    /// Bytes as its paper counts.
    pub multi_triangulation_paper_bytes_per_vertex: f64,
    /// The explicit model without the errors of its fragments, as ours without bounds.
    pub multi_triangulation_bytes_per_vertex_without_errors: f64,
    /// Ratio of the explicit model's memory to ours, without errors and bounds.
    pub multi_triangulation_ratio: f64,
    /// Ratio of the explicit model's memory with errors to ours with bounds, which contain errors.
    pub multi_triangulation_ratio_with_bounds: f64,
    /// Ratio of the bytes that the paper counts for both: the explicit model to the published form.
    published_ratio: f64,
    build_secs: f64,
    loop_build_secs: Option<f64>,
    multi_triangulation_build_secs: f64,
    /// Why the published form cannot represent the fragments; null if it can.
    cannot_be_published: Option<String>,
}

impl SourceRow {
    /// Computes the sizes of a source's models.
    pub(super) fn new(source: FragmentSource, models: &Models, fragments_secs: f64) -> Self {
        let Models { patterns, explicit, vertex_count, .. } = models;
        let fragment_count = patterns.fragment_count();
        let per_fragment = |count: usize| count as f64 / fragment_count.max(1) as f64;
        let per_vertex = |bytes: usize| bytes as f64 / (*vertex_count).max(1) as f64;
        let (bytes, explicit_bytes) = (bytes_of(patterns), bytes_of(explicit));
        let bare_explicit_bytes = explicit_bytes - errors_of(explicit);
        let ratio = |explicit: usize, ours: usize| explicit as f64 / ours.max(1) as f64;
        let with_bounds = bytes + models.bounds_bytes;
        let paper_bytes = [explicit.paper_bytes(Accounting::Words), patterns.paper_bytes(Accounting::Words)];
        let loops = models.loops.as_ref().ok();
        let loop_bytes = loops.map(bytes_of);
        let general = models.general.as_ref().ok();
        let general_bytes = general.map(bytes_of);
        let overlap_count = patterns.overlap_count();
        Self {
            source: source.as_str(),
            fragment_count,
            fragments_secs,
            rule_count: patterns.rule_count(),
            loop_rule_count: loops.map(LoopPatterns::rule_count),
            overlap_count,
            overlaps_per_fragment: per_fragment(overlap_count),
            paper_bits_per_fragment: per_fragment(8 * paper_bytes[1]),
            bits_per_fragment: per_fragment(8 * bytes),
            loop_bits_per_fragment: loop_bytes.map(|bytes| per_fragment(8 * bytes)),
            sequential_bits_per_fragment: models.sequential.as_ref().map(|s| per_fragment(s.fragment_bits())),
            sequential_bytes: models.sequential.as_ref().map(|s| s.as_bytes().len()),
            bytes,
            bytes_per_vertex: per_vertex(bytes),
            bytes_per_vertex_with_bounds: per_vertex(with_bounds),
            bytes_per_vertex_with_overlap_errors: per_vertex(with_bounds + models.overlap_error_bytes),
            file_bytes: models.file_bytes,
            open_secs: models.open_secs,
            loop_bytes,
            loop_bytes_per_vertex: loop_bytes.map(per_vertex),
            general_rule_count: general.map(GeneralPatterns::rule_count),
            general_bits_per_fragment: general_bytes.map(|bytes| per_fragment(8 * bytes)),
            general_bytes_per_vertex: general_bytes.map(per_vertex),
            cannot_be_general: models.general.as_ref().err().cloned(),
            multi_triangulation_bytes: explicit_bytes,
            multi_triangulation_bytes_per_vertex: per_vertex(explicit_bytes),
            multi_triangulation_paper_bytes_per_vertex: per_vertex(paper_bytes[0]),
            multi_triangulation_bytes_per_vertex_without_errors: per_vertex(bare_explicit_bytes),
            multi_triangulation_ratio: ratio(bare_explicit_bytes, bytes),
            multi_triangulation_ratio_with_bounds: ratio(explicit_bytes, with_bounds),
            published_ratio: ratio(paper_bytes[0], paper_bytes[1]),
            build_secs: models.build_secs,
            loop_build_secs: loops.map(|_| models.loop_build_secs),
            multi_triangulation_build_secs: models.explicit_build_secs,
            cannot_be_published: models.loops.as_ref().err().cloned(),
        }
    }

    /// Why the published form cannot represent the fragments.
    pub(super) fn refusal(&self) -> Option<&str> {
        self.cannot_be_published.as_deref()
    }
}

/// Bytes of the errors that an explicit model stores.
fn errors_of(model: &MultiTriangulation) -> usize {
    model.bytes().iter().filter(|part| part.name == "errors").map(|part| part.bytes).sum()
}

fn bytes_of(model: &impl LodModel) -> usize {
    model.bytes().iter().map(|part| part.bytes).sum()
}
