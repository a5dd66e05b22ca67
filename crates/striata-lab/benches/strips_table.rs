//! Numbers for strips and LodStrips: indices, bytes, and time per step.
//!
//! `cargo bench -p striata-lab --bench strips_table -- MESH...` prints Markdown tables. Attributes are
//! ignored; bytes are counted as in the LodStrips papers, with 12 bytes each for the position and normal
//! of a vertex and 4 bytes per index. meshoptimizer's strips are built from the triangle order it
//! recommends, in the same run.
//!
//! `--strips-only` omits the models, `--quick` omits most efforts and weights. `--peers DIR` adds the
//! strips that other tools wrote to this folder, and `--write-lists DIR` writes the input of these tools:
//! `benches/peers/run.sh` does both.

#[path = "strips_table/stripifier_rows.rs"]
mod stripifier_rows;
#[path = "quality/table.rs"]
mod table;

use std::error::Error;
use std::hint::black_box;
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use striata::mesh::{IndexedMesh, RefinableMesh, replay, weld};
use striata::model::{LodModel, LodStrips, StripModel};
use striata::simplify::{SequenceOptions, build_sequence};
use striata_strip::{StripOptions, Stripifier, stripify};
use table::Table;

type Fallible<T> = Result<T, Box<dyn Error>>;

/// Bytes of a position and a normal.
const VERTEX_BYTES: usize = 24;
/// The stripifier that `striata build` uses.
const BUILD_STRIPIFIER: Stripifier = Stripifier::Cheapest;
/// Stripifiers compared as the starting point of LodStrips.
const LEVEL_STRIPIFIERS: [Stripifier; 4] =
    [Stripifier::Greedy, Stripifier::Tunnel { max_length: 17 }, Stripifier::Fewest, Stripifier::Cheapest];
/// Percentages of the triangles at which levels are shown.
const LEVEL_PERCENTS: [usize; 5] = [100, 50, 25, 10, 2];
/// Number of runs to take the fastest of.
const RUN_COUNT: usize = 7;

/// Parsed command line.
#[derive(Default)]
struct Arguments {
    meshes: Vec<PathBuf>,
    choice: stripifier_rows::Choice,
    lists: Option<PathBuf>,
    is_strips_only: bool,
}

impl Arguments {
    fn parse(mut words: impl Iterator<Item = String>) -> Fallible<Self> {
        let mut found = Self::default();
        while let Some(word) = words.next() {
            let mut folder = || words.next().map(PathBuf::from).ok_or(format!("{word} needs a folder"));
            match word.as_str() {
                "--bench" => {}
                "--peers" => (found.choice.peers, found.is_strips_only) = (Some(folder()?), true),
                "--quick" => found.choice.is_quick = true,
                "--write-lists" => found.lists = Some(folder()?),
                "--strips-only" => found.is_strips_only = true,
                _ => found.meshes.push(word.into()),
            }
        }
        Ok(found)
    }
}

fn main() -> Fallible<()> {
    let arguments = Arguments::parse(std::env::args().skip(1))?;
    let mut out = std::io::stdout().lock();
    if arguments.meshes.is_empty() {
        writeln!(
            out,
            "no meshes given: cargo bench -p striata-lab --bench strips_table -- path/to/bunny.ply"
        )?;
        return Ok(());
    }
    let mut strips = Table::new(stripifier_rows::HEAD);
    let mut models = Table::new([
        "mesh",
        "vertices",
        "plain bytes",
        "model bytes",
        "ratio",
        "records",
        "targets",
        "instance",
        "build ms",
        "sweep ns per step",
    ]);
    let mut levels = Table::new(["mesh", "strips", "100 %", "50 %", "25 %", "10 %", "2 %", "all levels"]);
    for path in &arguments.meshes {
        let mesh = striata_io::read(path)?;
        let mesh = weld(&IndexedMesh::new(mesh.positions, mesh.triangles))?.mesh;
        let file = path.file_name().map_or_else(|| path.to_string_lossy(), |name| name.to_string_lossy());
        let name = file.split('.').next().unwrap_or_default().to_owned();
        if let Some(folder) = &arguments.lists {
            stripifier_rows::write_list(&name, &mesh, folder)?;
            continue;
        }
        stripifier_rows::add_rows(&name, &mesh, &arguments.choice, &mut strips)?;
        if !arguments.is_strips_only {
            let refinable = build_sequence(&mesh, &SequenceOptions::default())?.refinable;
            add_model(&name, &refinable, &mut models)?;
            add_levels(&name, &refinable, &mut levels)?;
        }
    }
    if arguments.lists.is_some() {
        return Ok(());
    }
    writeln!(out, "Strips of the full mesh; indices with restarts.\n")?;
    strips.print(&mut out)?;
    if arguments.is_strips_only {
        return Ok(());
    }
    writeln!(out, "LodStrips: down to the base and back, best of {RUN_COUNT} sweeps.\n")?;
    models.print(&mut out)?;
    writeln!(
        out,
        "Indices per triangle including restarts, of LodStrips at a level and of new strips for it.\n"
    )?;
    levels.print(&mut out)?;
    Ok(())
}

/// Fastest of several runs in seconds, and the result of the last one.
fn best<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let mut run = || {
        let start = Instant::now();
        let result = black_box(work());
        (start.elapsed().as_secs_f64(), result)
    };
    let mut best = run();
    for _ in 1..RUN_COUNT {
        let (secs, result) = run();
        best = (best.0.min(secs), result);
    }
    best
}

fn add_model(name: &str, refinable: &RefinableMesh, table: &mut Table) -> Fallible<()> {
    let options = StripOptions::default().with_stripifier(BUILD_STRIPIFIER);
    let strips = stripify(&refinable.mesh, &options)?;
    let (build_secs, model) = best(|| LodStrips::build(refinable, &strips));
    let model = model?;
    let mut state = model.new_state();
    let step_count = model.step_count();
    let (sweep_secs, ()) = best(|| {
        model.move_to(&mut state, 0);
        model.move_to(&mut state, step_count);
    });
    let vertex_bytes = VERTEX_BYTES * refinable.mesh.vertex_count();
    let plain = vertex_bytes + 4 * strips.to_restart_indices().indices.len();
    let parts = model.bytes();
    let part = |name: &str| parts.iter().filter(|p| p.name.starts_with(name)).map(|p| p.bytes).sum::<usize>();
    let total = vertex_bytes + parts.iter().map(|p| p.bytes).sum::<usize>();
    table.push(vec![
        name.to_owned(),
        refinable.mesh.vertex_count().to_string(),
        plain.to_string(),
        total.to_string(),
        format!("{:.3}", total as f64 / plain as f64),
        part("record").to_string(),
        part("targets").to_string(),
        state.bytes().to_string(),
        format!("{:.1}", build_secs * 1e3),
        format!("{:.1}", sweep_secs * 1e9 / (2 * step_count).max(1) as f64),
    ]);
    Ok(())
}

fn add_levels(name: &str, refinable: &RefinableMesh, table: &mut Table) -> Fallible<()> {
    for stripifier in LEVEL_STRIPIFIERS {
        let options = StripOptions::default().with_stripifier(stripifier);
        let model = LodStrips::build(refinable, &stripify(&refinable.mesh, &options)?)?;
        let mut state = model.new_state();
        let mut index_count_at = |split_count: usize| {
            model.move_to(&mut state, split_count);
            let live =
                (0..model.strip_count()).map(|strip| model.strip(&state, strip).len()).filter(|&n| n > 0);
            // Each strip is followed by a restart or the end of the buffer.
            live.map(|n| n + 1).sum::<usize>()
        };
        let what = format!("LodStrips of {stripifier}");
        let mut row = levels_row(name, &what, refinable, &mut index_count_at);
        row.push(format!("{:.3}", over_all_levels(refinable, &mut index_count_at)));
        table.push(row);
    }
    let options = StripOptions::default().with_stripifier(BUILD_STRIPIFIER);
    let mut from_scratch = |split_count: usize| {
        let strips = stripify(&replay(refinable, split_count), &options);
        strips.map_or(0, |strips| strips.to_restart_indices().indices.len())
    };
    let what = format!("{BUILD_STRIPIFIER}, from scratch for the level");
    let mut row = levels_row(name, &what, refinable, &mut from_scratch);
    row.push("–".to_owned());
    table.push(row);
    Ok(())
}

/// Indices per triangle at several percentages of the triangles.
fn levels_row(
    name: &str,
    what: &str,
    refinable: &RefinableMesh,
    index_count_at: &mut dyn FnMut(usize) -> usize,
) -> Vec<String> {
    let sequence = &refinable.sequence;
    let full = refinable.mesh.triangle_count();
    let mut row = vec![name.to_owned(), what.to_owned()];
    for percent in LEVEL_PERCENTS {
        let split_count = sequence.split_count_for_triangles(full * percent / 100);
        let triangle_count = sequence.triangle_count_at(split_count).max(1);
        row.push(format!("{:.2}", index_count_at(split_count) as f64 / triangle_count as f64));
    }
    row
}

/// Indices per triangle over all levels, sampled at every hundredth.
fn over_all_levels(refinable: &RefinableMesh, index_count_at: &mut dyn FnMut(usize) -> usize) -> f64 {
    let (mut indices, mut triangles) = (0, 0);
    for hundredth in (0..=100).rev() {
        let split_count = refinable.sequence.step_count() * hundredth / 100;
        indices += index_count_at(split_count);
        triangles += refinable.sequence.triangle_count_at(split_count);
    }
    indices as f64 / triangles.max(1) as f64
}
