//! Numbers for strips: their count, indices, cache misses, and time.
//!
//! `cargo bench --manifest-path lab/Cargo.toml --bench strips_table -- MESH...` prints a Markdown table. Attributes are
//! ignored. meshoptimizer's strips are built from the triangle order it recommends, in the same run.
//!
//! `--quick` omits most efforts and weights. `--peers DIR` adds the strips that other tools wrote to this
//! folder, and `--write-lists DIR` writes the input of these tools: `benches/peers/run.sh` does both.
//! `--strips-only` is accepted and changes nothing: `lod_strips_levels` has the figures of models.

#[path = "strips_table/peer_strips.rs"]
#[expect(dead_code, reason = "only `lod_strips_levels` builds models from the strips of other tools")]
mod peer_strips;
#[path = "strips_table/stripifier_rows.rs"]
mod stripifier_rows;
#[path = "quality/table.rs"]
mod table;

use std::error::Error;
use std::io::Write;
use std::path::PathBuf;

use striata::mesh::{IndexedMesh, weld};
use table::Table;

type Fallible<T> = Result<T, Box<dyn Error>>;

/// Number of runs to take the fastest of.
const RUN_COUNT: usize = 7;

/// Parsed command line.
#[derive(Default)]
struct Arguments {
    meshes: Vec<PathBuf>,
    choice: stripifier_rows::Choice,
    lists: Option<PathBuf>,
}

impl Arguments {
    fn parse(mut words: impl Iterator<Item = String>) -> Fallible<Self> {
        let mut found = Self::default();
        while let Some(word) = words.next() {
            let mut folder = || words.next().map(PathBuf::from).ok_or(format!("{word} needs a folder"));
            match word.as_str() {
                "--bench" | "--strips-only" => {}
                "--peers" => found.choice.peers = Some(folder()?),
                "--quick" => found.choice.is_quick = true,
                "--write-lists" => found.lists = Some(folder()?),
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
            "no meshes given: cargo bench --manifest-path lab/Cargo.toml --bench strips_table -- path/to/bunny.ply"
        )?;
        return Ok(());
    }
    let mut strips = Table::new(stripifier_rows::HEAD);
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
    }
    if arguments.lists.is_some() {
        return Ok(());
    }
    writeln!(out, "Strips of the full mesh; indices with restarts.\n")?;
    strips.print(&mut out)?;
    Ok(())
}
