//! LodStrips of different strips at every level: indices, cache misses and time.
//!
//! `cargo bench --manifest-path lab/Cargo.toml --bench lod_strips_levels -- [--quick] [--peers DIR] MESH...` prints three Markdown
//! tables: indices per triangle (restarts included), vertices that a cache of 16 misses per triangle, and bytes
//! with the time of a step and of a frame on the linear walk of \[RCRG06\]. Bytes are counted as in the papers, with
//! 24 for the position and the normal of a vertex and 4 per index. `--quick` takes only the strips that `striata
//! build` makes, in one stage and in several. `--peers DIR` adds the strips that NvTriStrip wrote to this folder;
//! see `benches/peers`.

#[path = "strips_table/peer_strips.rs"]
mod peer_strips;
#[path = "quality/table.rs"]
mod table;

use std::collections::HashMap;
use std::error::Error;
use std::hint::black_box;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use striata::mesh::{IndexedMesh, RefinableMesh, replay, weld};
use striata::model::{LodModel, LodStrips, StageOptions};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::{StripSet, fifo_cache_cost};
use striata_strip::{StripOptions, StripeSwaps, Stripifier, stripify};
use table::Table;

type Fallible<T> = Result<T, Box<dyn Error>>;

/// Percentages of the triangles at which levels are shown.
const LEVEL_PERCENTS: [usize; 5] = [100, 50, 25, 10, 2];
/// Cache size in vertices.
const CACHE_SIZE: usize = 16;
/// Indices that a miss weighs in strips for a cache.
const CACHE_WEIGHT: f64 = 0.5;
/// Frames of the walk from the full mesh to the base.
const FRAME_COUNT: usize = 200;
/// Number of runs to take the fastest of.
const RUN_COUNT: usize = 21;
/// Levels with fewer triangles are left out of the worst level: a handful needs more in any case.
const FEW_TRIANGLES: usize = 100;

/// Stripifiers compared with the one that `striata build` uses.
const OTHERS: [Stripifier; 4] = [
    Stripifier::Greedy,
    Stripifier::Stripe { has_patches: false, swaps: StripeSwaps::Free },
    Stripifier::Tunnel { max_length: 17 },
    Stripifier::Fewest,
];

fn main() -> Fallible<()> {
    let (mut peers, mut is_quick, mut meshes) = (None, false, Vec::new());
    let mut words = std::env::args().skip(1).filter(|word| word != "--bench");
    while let Some(word) = words.next() {
        match word.as_str() {
            "--peers" => peers = Some(PathBuf::from(words.next().ok_or("--peers needs a folder")?)),
            "--quick" => is_quick = true,
            _ => meshes.push(PathBuf::from(word)),
        }
    }
    let mut out = std::io::stdout().lock();
    if meshes.is_empty() {
        writeln!(
            out,
            "no meshes given: cargo bench --manifest-path lab/Cargo.toml --bench lod_strips_levels -- path/to/bunny.ply"
        )?;
        return Ok(());
    }
    let mut tables = Tables::new();
    for path in &meshes {
        let subject = Subject::read(path)?;
        tables.add_builds(&subject)?;
        if !is_quick {
            tables.add_others(&subject, peers.as_deref())?;
        }
    }
    writeln!(out, "Indices per triangle.\n")?;
    tables.indices.print(&mut out)?;
    writeln!(out, "Misses per triangle, first in, first out, {CACHE_SIZE} vertices.\n")?;
    tables.misses.print(&mut out)?;
    writeln!(out, "Sizes, and times: the best of {RUN_COUNT} runs.\n")?;
    tables.times.print(&mut out)?;
    Ok(())
}

struct Tables {
    indices: Table,
    misses: Table,
    times: Table,
}

/// A mesh with its sequence, and its name in the tables.
struct Subject {
    name: String,
    refinable: RefinableMesh,
}

/// Number of triangles, indices and cache misses of a level.
#[derive(Clone, Copy)]
struct LevelCost {
    triangle_count: usize,
    index_count: usize,
    miss_count: usize,
}

fn options(stripifier: Stripifier, counts_misses: bool) -> StripOptions {
    StripOptions::default()
        .with_stripifier(stripifier)
        .with_cache_weight(if counts_misses { CACHE_WEIGHT } else { 0.0 })
        .with_cache_size(CACHE_SIZE)
}

fn label(options: &StripOptions) -> String {
    let StripOptions { stripifier, cache_weight, .. } = options;
    let weight = if *cache_weight > 0.0 { format!(", a miss weighs {cache_weight}") } else { String::new() };
    format!("{stripifier}{weight}")
}

impl Tables {
    fn new() -> Self {
        let per_level = |what: &str, more: &[&'static str]| {
            let levels = LEVEL_PERCENTS.map(|percent| format!("{what}{percent} %"));
            let head = ["mesh", "strips"].map(str::to_owned).into_iter().chain(levels);
            Table::new(head.chain(more.iter().map(|&cell| cell.to_owned())).collect::<Vec<_>>())
        };
        Self {
            indices: per_level("", &["all levels", "worst"]),
            misses: per_level("misses at ", &["misses at all levels"]),
            times: Table::new([
                "mesh",
                "strips",
                "stages",
                "plain bytes",
                "model bytes",
                "ratio",
                "instance",
                "build ms",
                "ns per step",
                "ms per frame",
            ]),
        }
    }

    /// Adds the strips that `striata build` makes: in one stage, in several, and from scratch for each level.
    fn add_builds(&mut self, subject: &Subject) -> Fallible<()> {
        let options = options(Stripifier::Cheapest, false);
        self.add_one_stage(subject, &options)?;
        self.add_stages(subject, &options)?;
        self.add_from_scratch(subject, &options);
        Ok(())
    }

    /// Adds other strips.
    fn add_others(&mut self, subject: &Subject, peers: Option<&Path>) -> Fallible<()> {
        for stripifier in OTHERS {
            self.add_one_stage(subject, &options(stripifier, false))?;
        }
        if let Some(strips) = peers.map(|folder| subject.nvtristrip(folder)).transpose()?.flatten() {
            let build = || Ok(LodStrips::build(&subject.refinable, &strips)?);
            self.add_model(subject, "NvTriStrip", &strips, build)?;
        }
        let for_cache = options(Stripifier::Cheapest, true);
        self.add_one_stage(subject, &for_cache)?;
        self.add_stages(subject, &for_cache)?;
        self.add_from_scratch(subject, &for_cache);
        Ok(())
    }

    fn add_one_stage(&mut self, subject: &Subject, options: &StripOptions) -> Fallible<()> {
        let strips = stripify(&subject.refinable.mesh, options)?;
        let build = || Ok(LodStrips::build(&subject.refinable, &strips)?);
        self.add_model(subject, &label(options), &strips, build)
    }

    fn add_stages(&mut self, subject: &Subject, options: &StripOptions) -> Fallible<()> {
        let strips = stripify(&subject.refinable.mesh, options)?;
        let new_strips = |level: &_| stripify(level, options).map_err(Box::<dyn Error>::from);
        let stages = StageOptions::default();
        let build = || LodStrips::build_staged(&subject.refinable, &strips, &stages, new_strips);
        self.add_model(subject, &format!("stages of {}", label(options)), &strips, build)
    }

    fn add_model(
        &mut self,
        subject: &Subject,
        label: &str,
        strips: &StripSet,
        build: impl FnOnce() -> Fallible<LodStrips<'static>>,
    ) -> Fallible<()> {
        let Subject { name, refinable } = subject;
        let started = Instant::now();
        let model = build()?;
        let build_secs = started.elapsed().as_secs_f64();
        let mut state = model.new_state();
        let mut indices = Vec::new();
        let mut cost_at = |split_count: usize| {
            model.move_to(&mut state, split_count);
            indices.clear();
            model.indices_into(&state, &mut indices);
            level_cost(refinable, split_count, &indices)
        };
        let worst = subject.worst_level(&model);
        let all = subject.over_all_levels(&mut cost_at);
        self.add_levels(
            subject,
            label,
            LastCells { indices: [format!("{:.3}", all[0]), worst], misses: format!("{:.3}", all[1]) },
            &mut cost_at,
        );
        let (stage_count, plain) = (model.stage_split_counts().count(), subject.plain_bytes(strips));
        let bytes =
            24 * refinable.mesh.vertex_count() + model.bytes().iter().map(|part| part.bytes).sum::<usize>();
        self.times.push(vec![
            name.clone(),
            label.to_owned(),
            stage_count.to_string(),
            plain.to_string(),
            bytes.to_string(),
            format!("{:.3}", bytes as f64 / plain as f64),
            model.state_bytes(&model.new_state()).to_string(),
            format!("{:.1}", 1e3 * build_secs),
            format!("{:.1}", 1e9 * sweep_secs(&model)),
            format!("{:.4}", 1e3 * frame_secs(&model)),
        ]);
        Ok(())
    }

    fn add_from_scratch(&mut self, subject: &Subject, options: &StripOptions) {
        let label = format!("{}, from scratch for the level", label(options));
        let mut cost_at = |split_count: usize| {
            let strips = stripify(&replay(&subject.refinable, split_count), options);
            let indices = strips.map_or_else(|_| Vec::new(), |strips| strips.to_restart_indices().indices);
            level_cost(&subject.refinable, split_count, &indices)
        };
        let none = || "–".to_owned();
        let last = LastCells { indices: [none(), none()], misses: none() };
        self.add_levels(subject, &label, last, &mut cost_at);
    }

    /// Adds a row for indices and one for misses, with the given last cells.
    fn add_levels(
        &mut self,
        subject: &Subject,
        label: &str,
        last: LastCells,
        cost_at: &mut dyn FnMut(usize) -> LevelCost,
    ) {
        let Subject { name, refinable } = subject;
        let [mut indices, mut misses] = [(); 2].map(|()| vec![name.clone(), label.to_owned()]);
        for percent in LEVEL_PERCENTS {
            let triangle_count = refinable.mesh.triangle_count() * percent / 100;
            let cost = cost_at(refinable.sequence.split_count_for_triangles(triangle_count));
            let ratio = |count: usize| format!("{:.2}", count as f64 / cost.triangle_count.max(1) as f64);
            indices.push(ratio(cost.index_count));
            misses.push(ratio(cost.miss_count));
        }
        indices.extend(last.indices);
        misses.push(last.misses);
        self.indices.push(indices);
        self.misses.push(misses);
    }
}

/// The last cells of the rows of a model.
struct LastCells {
    indices: [String; 2],
    misses: String,
}

impl Subject {
    fn read(path: &Path) -> Fallible<Self> {
        let mesh = striata_io::read(path)?;
        let mesh = weld(&IndexedMesh::new(mesh.positions, mesh.triangles))?.mesh;
        let file = path.file_name().map_or_else(|| path.to_string_lossy(), |name| name.to_string_lossy());
        let name = file.split('.').next().unwrap_or_default().to_owned();
        let refinable = build_sequence(&mesh, &SequenceOptions::default())?.refinable;
        Ok(Self { name, refinable })
    }

    /// Positions and normals of 24 bytes, and 4 bytes per index.
    fn plain_bytes(&self, strips: &StripSet) -> usize {
        24 * self.refinable.mesh.vertex_count() + 4 * strips.to_restart_indices().indices.len()
    }

    /// Indices and misses per triangle over all levels, sampled at every hundredth.
    fn over_all_levels(&self, cost_at: &mut dyn FnMut(usize) -> LevelCost) -> [f64; 2] {
        let (mut triangles, mut indices, mut misses) = (0, 0, 0);
        for hundredth in (0..=100).rev() {
            let cost = cost_at(self.refinable.sequence.step_count() * hundredth / 100);
            triangles += cost.triangle_count;
            indices += cost.index_count;
            misses += cost.miss_count;
        }
        [indices, misses].map(|count: usize| count as f64 / triangles.max(1) as f64)
    }

    /// Most indices per triangle of any level that is not tiny, and the number of its triangles.
    fn worst_level(&self, model: &LodStrips<'_>) -> String {
        let sequence = &self.refinable.sequence;
        let mut state = model.new_state();
        let mut worst = (0.0, 0);
        // Counting walks over all strips, so not every level of a large mesh is counted.
        let stride = (sequence.step_count() / 30_000).max(1);
        for split_count in (0..=sequence.step_count()).rev().step_by(stride) {
            let triangle_count = sequence.triangle_count_at(split_count);
            if triangle_count < FEW_TRIANGLES {
                break;
            }
            model.move_to(&mut state, split_count);
            let ratio = model.draw_counts(&state).index_count as f64 / triangle_count as f64;
            if ratio > worst.0 {
                worst = (ratio, triangle_count);
            }
        }
        format!("{:.2} at {}", worst.0, worst.1)
    }

    /// The strips that NvTriStrip made of the mesh, with the vertices of the sequence; `None` if there are none.
    fn nvtristrip(&self, folder: &Path) -> Fallible<Option<StripSet>> {
        let path = folder.join(format!("{}.nvtristrip.strips", self.name));
        if !path.exists() {
            return Ok(None);
        }
        let (_, mut indices) = peer_strips::read(&path)?;
        let positions =
            peer_strips::read_positions(&path.with_file_name(format!("{}.triangles", self.name)))?;
        // The sequence has sorted the vertices, all of which have different positions.
        let bits = |position: &[f32; 3]| position.map(f32::to_bits);
        let places: HashMap<_, u32> = self.refinable.mesh.positions.iter().map(bits).zip(0..).collect();
        for index in &mut indices {
            // Restarts are not vertices.
            if let Some(position) = positions.get(*index as usize) {
                *index = *places.get(&bits(position)).ok_or("the strips are those of another mesh")?;
            }
        }
        Ok(Some(peer_strips::of_mesh(&indices, &self.refinable.mesh)))
    }
}

fn level_cost(refinable: &RefinableMesh, split_count: usize, indices: &[u32]) -> LevelCost {
    let triangle_count = refinable.sequence.triangle_count_at(split_count);
    let cache = fifo_cache_cost(indices, triangle_count, CACHE_SIZE);
    LevelCost { triangle_count, index_count: indices.len(), miss_count: cache.miss_count }
}

/// Fastest of several runs, in seconds.
fn best(mut work: impl FnMut()) -> f64 {
    let mut run = || {
        let started = Instant::now();
        work();
        started.elapsed().as_secs_f64()
    };
    (0..RUN_COUNT).map(|_| run()).fold(f64::INFINITY, f64::min)
}

/// Mean time of a step, down to the base and back.
fn sweep_secs(model: &LodStrips<'_>) -> f64 {
    let (mut state, step_count) = (model.new_state(), model.step_count());
    let secs = best(|| {
        model.move_to(&mut state, 0);
        model.move_to(&mut state, step_count);
    });
    secs / (2 * step_count).max(1) as f64
}

/// Mean time of a frame of the linear walk, down to the base and back: the move, and writing all indices.
fn frame_secs(model: &LodStrips<'_>) -> f64 {
    let (mut state, step_count) = (model.new_state(), model.step_count());
    let mut indices = Vec::new();
    let secs = best(|| {
        for frame in (0..FRAME_COUNT).rev().chain(1..=FRAME_COUNT) {
            model.move_to(&mut state, step_count * frame / FRAME_COUNT);
            indices.clear();
            model.indices_into(&state, &mut indices);
            black_box(&indices);
        }
    });
    secs / (2 * FRAME_COUNT) as f64
}
