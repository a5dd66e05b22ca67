//! The compared models, and the interface through which all of them are measured.

use std::hint::black_box;
use std::ops::Range;
use std::time::{Duration, Instant};

use striata::mesh::{FragmentedMesh, RefinableMesh};
use striata::model::{
    DrawCounts, Fans, LodModel, LodStrips, Mts, PartBytes, Patterns, StageOptions, Topology,
};
use striata::strip::StripSet;
use striata_lab::baseline::{
    DiscreteLevels, EfficientLodStrips, HoppeProgressiveMeshes, LoopPatterns, MultiTriangulation,
    OrderedMeshes, OriginalLodStrips, ProgressiveMeshes, SkipStrips, Winding,
};
use striata_lab::{Accounting, MtsGraph, PaperBytes};
use striata_strip::{StripOptions, stripify};

use striata_command::failure::Failure;
use striata_command::failure::unknown_name;

/// The inputs that all models are built from.
#[derive(Clone, Copy, Debug)]
pub(super) struct ModelInputs<'g> {
    /// The mesh with its sequence.
    pub refinable: &'g RefinableMesh,
    /// The mesh as fragments.
    pub fragmented: &'g FragmentedMesh,
    /// Strips of the full mesh.
    pub strips: &'g StripSet,
    /// Strip options for models that stripify each level.
    pub level_strips: &'g StripOptions,
}

/// A model that can be compared.
#[derive(Debug)]
pub(super) struct Entry {
    /// Name of the model.
    pub name: &'static str,
    /// Whether it shows only some levels of the sequence.
    pub has_few_levels: bool,
    build: Build,
}

type Build = fn(ModelInputs<'_>) -> Result<Box<dyn Contender>, BuildFailure>;

/// Reason why a model was not built.
#[derive(Debug)]
pub(super) enum BuildFailure {
    /// Its published form cannot represent the mesh.
    Unsupported(String),
    /// Building failed although it should have succeeded.
    Failed(Failure),
}

impl<E: Into<Failure>> From<E> for BuildFailure {
    fn from(error: E) -> Self {
        Self::Failed(error.into())
    }
}

/// All models; chart colors follow this order.
const ENTRIES: [Entry; 16] = [
    Entry::new("lodstrips", |inputs| built(|| LodStrips::build(inputs.refinable, inputs.strips))),
    Entry::new("lodstrips-staged", |inputs| built(|| staged(inputs))),
    Entry::new("mts", |inputs| built(|| Mts::build(inputs.refinable, inputs.strips))),
    Entry::new("fans", |inputs| built(|| Ok::<_, Failure>(Fans::build_without_bounds(inputs.refinable)))),
    Entry::new("patterns", |inputs| built(|| Patterns::build_without_bounds(inputs.fragmented))),
    Entry::new("lodstrips-original", |inputs| {
        built(|| OriginalLodStrips::build(inputs.refinable, inputs.strips))
    }),
    Entry::new("lodstrips-published", |inputs| {
        built(|| EfficientLodStrips::build(inputs.refinable, inputs.strips, Winding::Kept))
    }),
    Entry::new("mts-graph", |inputs| built(|| MtsGraph::build(inputs.refinable, inputs.strips))),
    Entry::new("skip-strips", |inputs| built(|| SkipStrips::build(inputs.refinable, inputs.strips))),
    Entry::new("progressive-meshes", |inputs| {
        built(|| Ok::<_, Failure>(ProgressiveMeshes::build(inputs.refinable)))
    }),
    Entry::new("progressive-meshes-hoppe", |inputs| {
        built(|| {
            HoppeProgressiveMeshes::build(inputs.refinable)
                .map_err(|error| BuildFailure::Unsupported(error.to_string()))
        })
    }),
    Entry::new("ordered-meshes", |inputs| built(|| Ok::<_, Failure>(OrderedMeshes::build(inputs.refinable)))),
    Entry::new("loop-patterns", |inputs| {
        built(|| {
            LoopPatterns::build(inputs.fragmented)
                .map_err(|error| BuildFailure::Unsupported(error.to_string()))
        })
    }),
    Entry::new("multi-triangulation", |inputs| {
        built(|| Ok::<_, Failure>(MultiTriangulation::build(inputs.fragmented)))
    }),
    Entry::of_few_levels("discrete-5", |inputs| built(|| discrete(inputs, 5))),
    Entry::of_few_levels("discrete-10", |inputs| built(|| discrete(inputs, 10))),
];

fn staged(inputs: ModelInputs<'_>) -> Result<LodStrips<'static>, Failure> {
    let strips = |level: &_| stripify(level, inputs.level_strips).map_err(Failure::from);
    LodStrips::build_staged(inputs.refinable, inputs.strips, &StageOptions::default(), strips)
}

fn discrete(inputs: ModelInputs<'_>, level_count: usize) -> Result<DiscreteLevels, Failure> {
    let strips = |mesh: &_| stripify(mesh, inputs.level_strips);
    let model = DiscreteLevels::build(inputs.refinable, level_count, strips);
    model.map_err(|error| Failure::internal(error.to_string()))
}

impl Entry {
    const fn new(name: &'static str, build: Build) -> Self {
        Self { name, has_few_levels: false, build }
    }

    const fn of_few_levels(name: &'static str, build: Build) -> Self {
        Self { name, has_few_levels: true, build }
    }

    /// Builds the model, several times if that is fast.
    ///
    /// # Errors
    /// If the published form cannot represent the mesh, or if building fails, which would be a bug.
    pub(super) fn build(&self, inputs: ModelInputs<'_>) -> Result<Box<dyn Contender>, BuildFailure> {
        (self.build)(inputs)
    }
}

/// Names of all models.
pub(crate) fn compared_models() -> impl Iterator<Item = &'static str> {
    ENTRIES.iter().map(|entry| entry.name)
}

/// The models with these names, without duplicates and in the order of the list.
///
/// # Errors
/// If a name is unknown.
pub(super) fn entries(names: &[&str]) -> Result<Vec<&'static Entry>, Failure> {
    let known: Vec<&str> = compared_models().collect();
    if let Some(unknown) = names.iter().find(|name| !known.contains(name)) {
        return Err(unknown_name("model", unknown, &known));
    }
    static ALL: [Entry; ENTRIES.len()] = ENTRIES;
    Ok(ALL.iter().filter(|entry| names.contains(&entry.name)).collect())
}

/// A model of any type, with one instance.
pub(super) trait Contender {
    /// Seconds of the fastest build.
    fn build_secs(&self) -> f64;
    /// The current level.
    fn split_count(&self) -> usize;
    /// Moves the instance to a level.
    fn move_to(&mut self, split_count: usize);
    /// Moves one step at a time over these levels, down or up, and returns how long that took. The
    /// instance must be at the corresponding end.
    fn step_over(&mut self, levels: Range<usize>, is_down: bool) -> Duration;
    /// The current draw counts.
    fn draw_counts(&self) -> DrawCounts;
    /// The primitive topology.
    fn topology(&self) -> Topology;
    /// Appends all indices to draw.
    fn indices_into(&self, out: &mut Vec<u32>);
    /// Appends the triangles shown.
    fn triangles_into(&self, out: &mut Vec<[u32; 3]>);
    /// Bytes of the static half by part.
    fn bytes(&self) -> Vec<PartBytes>;
    /// Current bytes of the instance.
    fn state_bytes(&self) -> usize;
    /// Bytes of the static half as the papers count.
    fn paper_bytes(&self, accounting: Accounting) -> usize;
}

struct BuiltContender<M: LodModel> {
    model: M,
    state: M::State,
    build_secs: f64,
}

/// Builds a model up to [`BUILD_COUNT`] times within [`BUILD_SECS`].
fn built<M, E>(mut make: impl FnMut() -> Result<M, E>) -> Result<Box<dyn Contender>, BuildFailure>
where
    M: PaperBytes + 'static,
    E: Into<BuildFailure>,
{
    let mut timed = || {
        let started = Instant::now();
        let model = make().map_err(Into::into)?;
        Ok::<_, BuildFailure>((model, started.elapsed().as_secs_f64()))
    };
    let (mut model, mut build_secs) = timed()?;
    let mut spent = build_secs;
    for _ in 1..BUILD_COUNT {
        if spent >= BUILD_SECS {
            break;
        }
        // Drop the previous model first; memory may not suffice for two.
        drop(model);
        let (again, secs) = timed()?;
        (model, build_secs, spent) = (again, build_secs.min(secs), spent + secs);
    }
    let state = model.new_state();
    Ok(Box::new(BuiltContender { model, state, build_secs }))
}

/// Maximum number of builds per model; the fastest one is reported.
const BUILD_COUNT: usize = 3;

/// Seconds after which a model is not built again.
const BUILD_SECS: f64 = 1.0;

impl<M: PaperBytes> Contender for BuiltContender<M> {
    fn build_secs(&self) -> f64 {
        self.build_secs
    }

    fn split_count(&self) -> usize {
        self.model.split_count(&self.state)
    }

    fn move_to(&mut self, split_count: usize) {
        self.model.move_to(&mut self.state, split_count);
    }

    fn step_over(&mut self, levels: Range<usize>, is_down: bool) -> Duration {
        debug_assert_eq!(self.split_count(), if is_down { levels.end } else { levels.start });
        let started = Instant::now();
        if is_down {
            levels.rev().for_each(|split_count| self.model.move_to(&mut self.state, split_count));
        } else {
            levels.for_each(|split_count| self.model.move_to(&mut self.state, split_count + 1));
        }
        black_box(&self.state);
        started.elapsed()
    }

    fn draw_counts(&self) -> DrawCounts {
        self.model.draw_counts(&self.state)
    }

    fn topology(&self) -> Topology {
        self.model.topology()
    }

    fn indices_into(&self, out: &mut Vec<u32>) {
        self.model.indices_into(&self.state, out);
    }

    fn triangles_into(&self, out: &mut Vec<[u32; 3]>) {
        self.model.triangles_into(&self.state, out);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        self.model.bytes()
    }

    fn state_bytes(&self) -> usize {
        self.model.state_bytes(&self.state)
    }

    fn paper_bytes(&self, accounting: Accounting) -> usize {
        self.model.paper_bytes(accounting)
    }
}
