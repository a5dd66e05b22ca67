//! Cost of stripifying block by block, compared with stripifying the whole mesh.
//!
//! `cargo bench --manifest-path lab/Cargo.toml --bench strip_blocks -- [--strips NAME] [--blocks N,N,...] MESH...` prints
//! a Markdown table; without a mesh it uses a generated terrain. Attributes are ignored; indices include
//! restarts.

#[path = "quality/table.rs"]
mod table;

use std::convert::Infallible;
use std::error::Error;
use std::io::Write;
use std::path::Path;
use std::time::Instant;

use striata::mesh::{IndexedMesh, shapes};
use striata_strip::{BlockOptions, MeshBlocks, StripOptions, stripify, stripify_blocks};
use table::Table;

type Fallible<T> = Result<T, Box<dyn Error>>;

fn main() -> Fallible<()> {
    let mut arguments = std::env::args().skip(1).filter(|argument| argument != "--bench");
    let (mut options, mut blocks, mut paths) =
        (StripOptions::default(), vec![10_000, 50_000, 200_000], Vec::new());
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().ok_or_else(|| format!("{argument} takes a value"));
        match argument.as_str() {
            "--strips" => options = options.with_stripifier(value()?.parse()?),
            "--blocks" => blocks = value()?.split(',').map(str::parse).collect::<Result<_, _>>()?,
            _ => paths.push(argument),
        }
    }
    let mut table = Table::new([
        "mesh",
        "blocks of",
        "blocks",
        "strips",
        "indices per triangle",
        "relative to whole",
        "peak window",
        "waiting",
        "carried over",
        "ms",
    ]);
    if paths.is_empty() {
        add_mesh("terrain", &shapes::terrain(700, 1), &options, &blocks, &mut table)?;
    }
    for path in &paths {
        let mesh = striata_io::read(path)?;
        let name = Path::new(path).file_stem().map_or(path.into(), |name| name.to_string_lossy());
        add_mesh(&name, &IndexedMesh::new(mesh.positions, mesh.triangles), &options, &blocks, &mut table)?;
    }
    let mut out = std::io::stdout().lock();
    writeln!(out, "Strips in blocks, `{}`; counts are triangles.\n", options.stripifier)?;
    table.print(&mut out)?;
    Ok(())
}

fn add_mesh(
    name: &str,
    mesh: &IndexedMesh,
    options: &StripOptions,
    blocks: &[usize],
    table: &mut Table,
) -> Fallible<()> {
    let start = Instant::now();
    let whole = stripify(mesh, options)?.cost();
    let whole_ms = start.elapsed().as_secs_f64() * 1e3;
    table.push(vec![
        name.to_owned(),
        "whole".to_owned(),
        "1".to_owned(),
        whole.strip_count.to_string(),
        format!("{:.4}", whole.indices_per_triangle),
        "1".to_owned(),
        mesh.triangle_count().to_string(),
        "0".to_owned(),
        "0".to_owned(),
        format!("{whole_ms:.0}"),
    ]);
    for &block_triangles in blocks.iter().filter(|&&n| n < mesh.triangle_count()) {
        let start = Instant::now();
        let report = stripify_blocks(
            &mut MeshBlocks::new(mesh, block_triangles)?,
            &BlockOptions::default().with_strip(options.clone()),
            &mut |_, _| Ok::<(), Infallible>(()),
        )?;
        let ms = start.elapsed().as_secs_f64() * 1e3;
        table.push(vec![
            name.to_owned(),
            block_triangles.to_string(),
            report.block_count.to_string(),
            report.cost.strip_count.to_string(),
            format!("{:.4}", report.cost.indices_per_triangle),
            format!("{:.4}", report.cost.index_count as f64 / whole.index_count as f64),
            report.peak_window_triangles.to_string(),
            report.peak_held_triangles.to_string(),
            report.carried_count.to_string(),
            format!("{ms:.0}"),
        ]);
    }
    Ok(())
}
