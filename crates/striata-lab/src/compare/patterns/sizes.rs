//! What fragments take in each form.

use std::time::Instant;

use serde::Serialize;
use striata::mesh::FragmentedMesh;
use striata::model::{LodModel, Patterns};
use striata_lab::baseline::{LoopPatterns, MultiTriangulation, SequentialPatterns};
use striata_lab::{Accounting, PaperBytes};

use super::source::Source;
use striata_command::failure::Failure;

/// All forms of the same fragments.
pub(super) struct Models {
    /// Ours.
    pub(super) patterns: Patterns,
    build_secs: f64,
    /// Bytes of the bounds that views ask for.
    bounds_bytes: usize,
    /// As published, or why not.
    pub(super) loops: Result<LoopPatterns, String>,
    loop_build_secs: f64,
    sequential: Option<SequentialPatterns>,
    /// The explicit model.
    pub(super) explicit: MultiTriangulation,
    explicit_build_secs: f64,
    /// The error of each fragment's floor.
    pub(super) errors: Vec<f32>,
    /// The largest error of what each level leaves out.
    pub(super) level_errors: Vec<f32>,
    /// Triangles of each level.
    pub(super) triangle_counts: Vec<usize>,
    vertex_count: usize,
}

impl Models {
    /// Builds all that can be built.
    ///
    /// # Errors
    /// Where the fragments are too many to be numbered.
    pub(super) fn build(mesh: &FragmentedMesh) -> Result<Self, Failure> {
        let (patterns, build_secs) = timed(|| Patterns::build_without_bounds(mesh));
        let patterns = patterns?;
        let bounds_bytes = bytes_of(&Patterns::build(mesh)?) - bytes_of(&patterns);
        let (loops, loop_build_secs) = timed(|| LoopPatterns::build(mesh));
        let (explicit, explicit_build_secs) = timed(|| MultiTriangulation::build(mesh));
        let levels = mesh.fragments.levels();
        let step_count = levels.step_count();
        Ok(Self {
            patterns,
            build_secs,
            bounds_bytes,
            loops: loops.map_err(|error| error.to_string()),
            loop_build_secs,
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

fn timed<T>(build: impl FnOnce() -> T) -> (T, f64) {
    let started = Instant::now();
    let built = build();
    (built, started.elapsed().as_secs_f64())
}

/// Fragments of one source, and what they take. Bytes are those of what is built once, without positions; bits a fragment those of the
/// same, the base and the tables of rules counted.
#[derive(Clone, Debug, Serialize)]
pub(super) struct SourceRow {
    /// Where they come from.
    pub(super) source: &'static str,
    /// How many there are.
    pub(super) fragment_count: usize,
    /// Seconds that making them took.
    pub(super) fragments_secs: f64,
    /// Kinds of fragments.
    pub(super) rule_count: usize,
    /// Kinds of fragments, as the published form tells them apart; null where it cannot hold them.
    loop_rule_count: Option<usize>,
    /// Pairs of fragments that overlap.
    overlap_count: usize,
    pub(super) overlaps_per_fragment: f64,
    /// As the paper counts, with as many overlaps as there are.
    pub(super) paper_bits_per_fragment: f64,
    pub(super) bits_per_fragment: f64,
    /// As published; null where that cannot hold them.
    pub(super) loop_bits_per_fragment: Option<f64>,
    /// In the form for transmission, fragments alone; null where that cannot hold them.
    pub(super) sequential_bits_per_fragment: Option<f64>,
    /// The same with the base and the rules.
    sequential_bytes: Option<usize>,
    bytes: usize,
    pub(super) bytes_per_vertex: f64,
    /// With the bounds that views ask for.
    pub(super) bytes_per_vertex_with_bounds: f64,
    loop_bytes: Option<usize>,
    pub(super) loop_bytes_per_vertex: Option<f64>,
    multi_triangulation_bytes: usize,
    pub(super) multi_triangulation_bytes_per_vertex: f64,
    /// As its paper counts.
    pub(super) multi_triangulation_paper_bytes_per_vertex: f64,
    /// How many times ours the explicit model takes.
    pub(super) multi_triangulation_ratio: f64,
    build_secs: f64,
    loop_build_secs: Option<f64>,
    multi_triangulation_build_secs: f64,
    /// Why the published form cannot hold them; null where it can.
    cannot_be_published: Option<String>,
}

impl SourceRow {
    /// What models of a source take.
    pub(super) fn new(source: Source, models: &Models, fragments_secs: f64) -> Self {
        let Models { patterns, explicit, vertex_count, .. } = models;
        let fragment_count = patterns.fragment_count();
        let per_fragment = |count: usize| count as f64 / fragment_count.max(1) as f64;
        let per_vertex = |bytes: usize| bytes as f64 / (*vertex_count).max(1) as f64;
        let (bytes, explicit_bytes) = (bytes_of(patterns), bytes_of(explicit));
        let loops = models.loops.as_ref().ok();
        let loop_bytes = loops.map(bytes_of);
        let overlap_count = patterns.overlap_count();
        Self {
            source: source.as_str(),
            fragment_count,
            fragments_secs,
            rule_count: patterns.rule_count(),
            loop_rule_count: loops.map(LoopPatterns::rule_count),
            overlap_count,
            overlaps_per_fragment: per_fragment(overlap_count),
            paper_bits_per_fragment: per_fragment(8 * patterns.paper_bytes(Accounting::Words)),
            bits_per_fragment: per_fragment(8 * bytes),
            loop_bits_per_fragment: loop_bytes.map(|bytes| per_fragment(8 * bytes)),
            sequential_bits_per_fragment: models.sequential.as_ref().map(|s| per_fragment(s.fragment_bits())),
            sequential_bytes: models.sequential.as_ref().map(|s| s.as_bytes().len()),
            bytes,
            bytes_per_vertex: per_vertex(bytes),
            bytes_per_vertex_with_bounds: per_vertex(bytes + models.bounds_bytes),
            loop_bytes,
            loop_bytes_per_vertex: loop_bytes.map(per_vertex),
            multi_triangulation_bytes: explicit_bytes,
            multi_triangulation_bytes_per_vertex: per_vertex(explicit_bytes),
            multi_triangulation_paper_bytes_per_vertex: per_vertex(explicit.paper_bytes(Accounting::Words)),
            multi_triangulation_ratio: explicit_bytes as f64 / bytes.max(1) as f64,
            build_secs: models.build_secs,
            loop_build_secs: loops.map(|_| models.loop_build_secs),
            multi_triangulation_build_secs: models.explicit_build_secs,
            cannot_be_published: models.loops.as_ref().err().cloned(),
        }
    }

    /// Why the published form cannot hold them.
    pub(super) fn refusal(&self) -> Option<&str> {
        self.cannot_be_published.as_deref()
    }
}

fn bytes_of(model: &impl LodModel) -> usize {
    model.bytes().iter().map(|part| part.bytes).sum()
}
