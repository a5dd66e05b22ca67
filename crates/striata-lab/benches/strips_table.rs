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

#[path = "strips_table/peer_strips.rs"]
#[expect(dead_code, reason = "only `lod_strips_levels` builds models from the strips of other tools")]
mod peer_strips;
#[path = "strips_table/stripifier_rows.rs"]
mod stripifier_rows;
#[path = "quality/table.rs"]
mod table;

use std::error::Error;
use std::hint::black_box;
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use striata::mesh::{IndexedMesh, RefinableMesh, weld};
use striata::model::{LodModel, LodStrips};
use striata::simplify::{SequenceOptions, build_sequence};
use striata_strip::{StripOptions, Stripifier, stripify};
use table::Table;

type Fallible<T> = Result<T, Box<dyn Error>>;

/// Bytes of a position and a normal.
const VERTEX_BYTES: usize = 24;
/// The stripifier that `striata build` uses.
const BUILD_STRIPIFIER: Stripifier = Stripifier::Cheapest;
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
