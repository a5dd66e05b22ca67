//! The models that are compared: one line for each, and what is asked of all of them.

use std::hint::black_box;
use std::ops::Range;
use std::time::{Duration, Instant};

use striata::mesh::{FragmentedMesh, RefinableMesh};
use striata::model::{DrawCounts, Fans, LodModel, LodStrips, Mts, PartBytes, Patterns, Topology};
use striata::strip::StripSet;
use striata_lab::baseline::{
    DiscreteLevels, LoopPatterns, MultiTriangulation, OrderedMeshes, OriginalLodStrips, ProgressiveMeshes,
    SkipStrips,
};
use striata_lab::{Accounting, MtsGraph, PaperBytes};
use striata_strip::{StripOptions, stripify};

use striata_command::failure::Failure;
use striata_command::failure::unknown_name;

/// What all models are built from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given<'g> {
    /// The mesh with its sequence.
    pub(super) refinable: &'g RefinableMesh,
    /// The same as fragments.
    pub(super) fragmented: &'g FragmentedMesh,
    /// Strips of the full mesh.
    pub(super) strips: &'g StripSet,
    /// How strips are made for models that store some of every level.
    pub(super) level_strips: &'g StripOptions,
}

/// A model that can be compared.
#[derive(Debug)]
pub(super) struct Entry {
    /// Its name.
    pub(super) name: &'static str,
    /// Whether it shows only some levels of the sequence.
    pub(super) has_few_levels: bool,
    build: Build,
}

type Build = fn(Given<'_>) -> Result<Box<dyn Contender>, Unbuilt>;

/// Why there is no model.
#[derive(Debug)]
pub(super) enum Unbuilt {
    /// Its published form cannot hold the mesh.
    Refused(String),
    /// It should have been built.
    Failed(Failure),
}

impl<E: Into<Failure>> From<E> for Unbuilt {
    fn from(error: E) -> Self {
        Self::Failed(error.into())
    }
}

/// All of them; the colors of charts follow this order.
const ENTRIES: [Entry; 13] = [
    Entry::new("lodstrips", |given| built(|| LodStrips::build(given.refinable, given.strips))),
    Entry::new("mts", |given| built(|| Mts::build(given.refinable, given.strips))),
    Entry::new("fans", |given| built(|| Ok::<_, Failure>(Fans::build_without_bounds(given.refinable)))),
    Entry::new("patterns", |given| built(|| Patterns::build_without_bounds(given.fragmented))),
    Entry::new("lodstrips-original", |given| {
        built(|| OriginalLodStrips::build(given.refinable, given.strips))
    }),
    Entry::new("mts-graph", |given| built(|| MtsGraph::build(given.refinable, given.strips))),
    Entry::new("skip-strips", |given| built(|| SkipStrips::build(given.refinable, given.strips))),
    Entry::new("progressive-meshes", |given| {
        built(|| Ok::<_, Failure>(ProgressiveMeshes::build(given.refinable)))
    }),
    Entry::new("ordered-meshes", |given| built(|| Ok::<_, Failure>(OrderedMeshes::build(given.refinable)))),
    Entry::new("loop-patterns", |given| {
        built(|| LoopPatterns::build(given.fragmented).map_err(|error| Unbuilt::Refused(error.to_string())))
    }),
    Entry::new("multi-triangulation", |given| {
        built(|| Ok::<_, Failure>(MultiTriangulation::build(given.fragmented)))
    }),
    Entry::of_few_levels("discrete-5", |given| built(|| discrete(given, 5))),
    Entry::of_few_levels("discrete-10", |given| built(|| discrete(given, 10))),
];

fn discrete(given: Given<'_>, level_count: usize) -> Result<DiscreteLevels, Failure> {
    let strips = |mesh: &_| stripify(mesh, given.level_strips);
    let model = DiscreteLevels::build(given.refinable, level_count, strips);
    model.map_err(|error| Failure::internal(error.to_string()))
}

impl Entry {
    const fn new(name: &'static str, build: Build) -> Self {
        Self { name, has_few_levels: false, build }
    }

    const fn of_few_levels(name: &'static str, build: Build) -> Self {
        Self { name, has_few_levels: true, build }
    }

    /// Builds the model, several times where that is quick.
    ///
    /// # Errors
    /// Where the published form refuses the mesh, or where it cannot be built, which is our fault.
    pub(super) fn build(&self, given: Given<'_>) -> Result<Box<dyn Contender>, Unbuilt> {
        (self.build)(given)
    }
}

/// The names of all models.
pub(crate) fn compared_models() -> impl Iterator<Item = &'static str> {
    ENTRIES.iter().map(|entry| entry.name)
}

/// The models of these names, each once and in our order.
///
/// # Errors
/// Where a name is none of ours.
pub(super) fn entries(names: &[&str]) -> Result<Vec<&'static Entry>, Failure> {
    let known: Vec<&str> = compared_models().collect();
    if let Some(unknown) = names.iter().find(|name| !known.contains(name)) {
        return Err(unknown_name("model", unknown, &known));
    }
    static ALL: [Entry; ENTRIES.len()] = ENTRIES;
    Ok(ALL.iter().filter(|entry| names.contains(&entry.name)).collect())
}

/// A model with one instance, whatever its type.
pub(super) trait Contender {
    /// The quickest of its builds, seconds.
    fn build_secs(&self) -> f64;
    /// The level that it shows.
    fn split_count(&self) -> usize;
    /// Moves it to a level.
    fn move_to(&mut self, split_count: usize);
    /// Moves it one step at a time over these levels, down or up; how long that took. It must stand at one end.
    fn step_over(&mut self, levels: Range<usize>, is_down: bool) -> Duration;
    /// What drawing it takes now.
    fn draw_counts(&self) -> DrawCounts;
    /// How it is drawn.
    fn topology(&self) -> Topology;
    /// Appends all that is drawn.
    fn indices_into(&self, out: &mut Vec<u32>);
    /// Appends the triangles that it shows.
    fn triangles_into(&self, out: &mut Vec<[u32; 3]>);
    /// Bytes of the static half by part.
    fn bytes(&self) -> Vec<PartBytes>;
    /// Bytes of the instance as it is now.
    fn state_bytes(&self) -> usize;
    /// Bytes of the static half as the papers count.
    fn paper_bytes(&self, accounting: Accounting) -> usize;
}

struct Built<M: LodModel> {
    model: M,
    state: M::State,
    build_secs: f64,
}

/// Builds a model up to [`BUILD_COUNT`] times, as long as that stays within [`BUILD_SECS`].
fn built<M, E>(mut make: impl FnMut() -> Result<M, E>) -> Result<Box<dyn Contender>, Unbuilt>
where
    M: PaperBytes + 'static,
    E: Into<Unbuilt>,
{
    let mut timed = || {
        let started = Instant::now();
        let model = make().map_err(Into::into)?;
        Ok::<_, Unbuilt>((model, started.elapsed().as_secs_f64()))
    };
    let (mut model, mut build_secs) = timed()?;
    let mut spent = build_secs;
    for _ in 1..BUILD_COUNT {
        if spent >= BUILD_SECS {
            break;
        }
        // The one before is gone first: two of them may be more than there is memory for.
        drop(model);
        let (again, secs) = timed()?;
        (model, build_secs, spent) = (again, build_secs.min(secs), spent + secs);
    }
    let state = model.new_state();
    Ok(Box::new(Built { model, state, build_secs }))
}

/// Builds of a model, at most; the quickest is told.
const BUILD_COUNT: usize = 3;

/// Seconds after which a model is not built again.
const BUILD_SECS: f64 = 1.0;

impl<M: PaperBytes> Contender for Built<M> {
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
