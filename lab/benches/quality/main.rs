//! Distance of simplified meshes from their originals, and the time and memory needed, compared with
//! meshoptimizer.
//!
//! `cargo bench --manifest-path lab/Cargo.toml --bench quality -- [OPTIONS] MESH...` prints Markdown tables. For each mesh
//! and each share of its triangles, meshoptimizer creates one level, and every other tool a level with at
//! most as many triangles. All levels are measured against the welded original with the same samples.
//! Attributes are ignored by all tools.
//!
//! ```text
//! --cost memoryless|accumulated|tracked|batches|hausdorff|all|hausdorff-strict|edges|triangles
//!                                             cost of our collapses (batches: as in a 12-bit stream) or
//!                                             removals (hausdorff); all: those before; or collapses of
//!                                             edges or triangles to new vertices; default memoryless;
//!                                             comma-separated
//! --placement optimal                         add our one-level simplifier with free vertex placement
//! --promises                                   instead: compare guaranteed errors with measured ones
//! --samples N                                 samples per surface; default 500000, 0 skips distances
//! --repeat N                                  timed runs, the fastest counts; default 5, 0 skips timing
//! ```

mod guarantees;
mod memory;
mod quality;
mod speed;
mod table;

use std::error::Error;
use std::io::Write;

use striata::ignore_progress;
use striata::mesh::{FragmentedMesh, IndexedMesh, RefinableMesh, Welded, weld};
use striata::simplify::{
    BatchOptions, CostFunction, HoleCriterion, PlacedCollapse, PlacedOptions, RemovalOptions, RemovalOrder,
    SequenceOptions, SimplifyError, build_welded_batches, build_welded_fragments,
    build_welded_placed_fragments_with_progress, build_welded_sequence,
};
use striata_stream::{Precision, SHAPE_STEPS, StreamOptions};

type Fallible<T> = Result<T, Box<dyn Error>>;

/// Shares of the triangles for which levels are created.
const SHARES: [f64; 4] = [0.5, 0.25, 0.1, 0.02];

/// Parsed command line.
struct Request {
    simplifiers: Vec<Simplifier>,
    has_optimal: bool,
    has_guarantees: bool,
    sample_count: usize,
    repeat_count: usize,
    paths: Vec<String>,
}

impl Request {
    fn parse(mut arguments: impl Iterator<Item = String>) -> Fallible<Self> {
        let mut request = Self {
            simplifiers: vec![Simplifier::Collapses(CostFunction::Memoryless)],
            has_optimal: false,
            has_guarantees: false,
            sample_count: 500_000,
            repeat_count: 5,
            paths: Vec::new(),
        };
        while let Some(argument) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{argument} needs a value"));
            match argument.as_str() {
                // Cargo passes this flag to every bench.
                "--bench" => {}
                "--cost" => request.simplifiers = simplifiers_of(&value()?)?,
                "--placement" => request.has_optimal = value()? == "optimal",
                "--promises" => request.has_guarantees = true,
                "--samples" => request.sample_count = value()?.parse()?,
                "--repeat" => request.repeat_count = value()?.parse()?,
                option if option.starts_with('-') => return Err(format!("unknown option {option}").into()),
                _ => request.paths.push(argument),
            }
        }
        Ok(request)
    }
}

/// One of our simplifiers that builds a whole sequence.
#[derive(Clone, Copy)]
enum Simplifier {
    /// Half-edge collapses ordered by a cost.
    Collapses(CostFunction),
    /// Memoryless collapses in batches, as in a progressive stream of 12 bits.
    Batches,
    /// Vertex removals with holes filled freely, ordered by squared distances, gaps and the largest distance.
    Removal,
    /// Vertex removals ordered by the one-sided Hausdorff distance alone.
    StrictRemoval,
    /// Edges or triangles collapsed to new vertices, as fragments.
    Placed(PlacedCollapse),
}

impl Simplifier {
    /// All that `--cost` can name.
    fn all() -> impl Iterator<Item = Self> {
        let others = [
            Self::Batches,
            Self::Removal,
            Self::StrictRemoval,
            Self::Placed(PlacedCollapse::Edge),
            Self::Placed(PlacedCollapse::Triangle),
        ];
        CostFunction::ALL.iter().map(|&cost| Self::Collapses(cost)).chain(others)
    }

    /// Whether `--cost all` includes it: steps of the orders that any model or stream is built from.
    fn is_common(self) -> bool {
        !matches!(self, Self::StrictRemoval | Self::Placed(_))
    }

    fn name(self) -> String {
        match self {
            Self::Collapses(cost) => cost.name().to_owned(),
            Self::Batches => "batches".to_owned(),
            Self::Removal => "hausdorff".to_owned(),
            Self::StrictRemoval => "hausdorff-strict".to_owned(),
            Self::Placed(PlacedCollapse::Triangle) => "triangles".to_owned(),
            Self::Placed(_) => "edges".to_owned(),
        }
    }

    /// Builds the whole sequence of a welded mesh.
    fn build(self, welded: Welded) -> Result<BuiltSequence, SimplifyError> {
        match self {
            Self::Collapses(cost) => {
                let options = SequenceOptions::default().with_cost(cost);
                let built = build_welded_sequence(welded, &options)?;
                Ok(BuiltSequence::Collapses(Box::new(built.refinable)))
            }
            Self::Batches => {
                let step =
                    StreamOptions::default().with_precision(Precision::Bits(12)).grid_step(&welded.mesh);
                let options =
                    BatchOptions::default().with_shape_step(step.ok().map(|step| SHAPE_STEPS * step));
                let built = build_welded_batches(welded, &options)?;
                Ok(BuiltSequence::Collapses(Box::new(built.built.refinable)))
            }
            Self::Removal => {
                let options = RemovalOptions::default();
                let built = build_welded_fragments(welded, &options)?;
                Ok(BuiltSequence::Fragments(Box::new(built.fragmented)))
            }
            Self::StrictRemoval => {
                let options = RemovalOptions::default()
                    .with_order(RemovalOrder::Hausdorff)
                    .with_criterion(HoleCriterion::Maximum);
                let built = build_welded_fragments(welded, &options)?;
                Ok(BuiltSequence::Fragments(Box::new(built.fragmented)))
            }
            Self::Placed(collapse) => {
                let options = PlacedOptions::default().with_collapse(collapse);
                let built =
                    build_welded_placed_fragments_with_progress(welded, &options, &mut ignore_progress)?;
                Ok(BuiltSequence::Fragments(Box::new(built.fragmented)))
            }
        }
    }
}

/// A sequence built by one of our simplifiers.
enum BuiltSequence {
    Collapses(Box<RefinableMesh>),
    Fragments(Box<FragmentedMesh>),
}

fn simplifiers_of(name: &str) -> Fallible<Vec<Simplifier>> {
    let is_chosen = |simplifier: &Simplifier| {
        name == "all" && simplifier.is_common() || name.split(',').any(|n| simplifier.name() == n)
    };
    let chosen: Vec<_> = Simplifier::all().filter(is_chosen).collect();
    if chosen.is_empty() { Err(format!("unknown cost {name}").into()) } else { Ok(chosen) }
}

/// A mesh to measure: welded positions and triangles of a file.
struct Subject {
    name: String,
    welded: Welded,
}

impl Subject {
    fn read(path: &str) -> Fallible<Self> {
        let mesh = striata_io::read(path)?;
        let welded = weld(&IndexedMesh::new(mesh.positions, mesh.triangles))?;
        let file = std::path::Path::new(path).file_name().map_or(path.into(), |name| name.to_string_lossy());
        let name = file.split('.').next().unwrap_or_default().to_owned();
        Ok(Self { name, welded })
    }

    fn mesh(&self) -> &IndexedMesh {
        &self.welded.mesh
    }

    /// Returns the triangles of one level made by meshoptimizer, which keeps original vertices as our
    /// simplifiers do.
    fn meshoptimizer(&self, share: f64) -> Fallible<Vec<u32>> {
        let mesh = self.mesh();
        let goal = (mesh.triangle_count() as f64 * share) as usize;
        let vertices =
            meshopt::VertexDataAdapter::new(bytemuck::cast_slice(&mesh.positions), size_of::<[f32; 3]>(), 0)?;
        let indices = bytemuck::cast_slice(&mesh.triangles);
        Ok(meshopt::simplify(indices, &vertices, 3 * goal, f32::MAX, meshopt::SimplifyOptions::None, None))
    }

    fn peer_level(&self, share: f64) -> Fallible<IndexedMesh> {
        let indices = self.meshoptimizer(share)?;
        let triangles: &[[u32; 3]] = bytemuck::cast_slice(&indices);
        Ok(IndexedMesh::new(self.mesh().positions.clone(), triangles.to_vec()))
    }
}

fn main() -> Fallible<()> {
    if let Some(request) = memory::ChildRequest::from_environment() {
        return request.measure();
    }
    let request = Request::parse(std::env::args().skip(1))?;
    let mut out = std::io::stdout().lock();
    if request.paths.is_empty() {
        writeln!(
            out,
            "no meshes given: cargo bench --manifest-path lab/Cargo.toml --bench quality -- path/to/bunny.ply"
        )?;
        return Ok(());
    }
    let subjects = request.paths.iter().map(|path| Subject::read(path)).collect::<Fallible<Vec<_>>>()?;
    if request.has_guarantees {
        return guarantees::report(&request, &subjects, &mut out);
    }
    if request.sample_count > 0 {
        quality::report(&request, &subjects, &mut out)?;
    }
    if request.repeat_count > 0 {
        speed::report(&request, &subjects, &mut out)?;
        memory::report(&request, &subjects, &mut out)?;
    }
    Ok(())
}
