//! Quality of meshes simplified in cells, compared with the same mesh simplified as a whole.
//!
//! `cargo bench --manifest-path lab/Cargo.toml --bench cells_quality -- [--cell N] MESH...` builds a paged file of each mesh, extracts
//! levels from it, and compares them with levels of the in-core sequence that have the same number of triangles.
//! `terrain:SIDE` stands for a generated terrain. Two tables: the RMS distance from the mesh as a ratio, and how many
//! more triangles a level of the file needs for the same RMS distance.

#[path = "quality/table.rs"]
mod table;

use std::error::Error;
use std::io::Write;
use std::path::Path;

use striata::ignore_progress;
use striata::mesh::{DistanceOptions, IndexedMesh, RefinableMesh, replay, surface_distance};
use striata::simplify::build_sequence;
use striata_paged::PagedFile;
use striata_paged::build::{BuildInput, BuildOptions, BuildPaths, PagedPlan, run_all};
use table::Table;

type Fallible<T> = Result<T, Box<dyn Error>>;

/// Levels, as shares of the triangles.
const SHARES: [f64; 6] = [0.25, 0.1, 0.05, 0.02, 0.01, 0.005];
/// Factor of the triangle count of a second level, from which the dependence of the distance is found.
const MORE: f64 = 1.05;
/// Samples of a distance.
const SAMPLES: usize = 300_000;

fn main() -> Fallible<()> {
    let mut cell = BuildOptions::default().cell;
    let mut meshes = Vec::new();
    let mut arguments = std::env::args().skip(1).filter(|argument| argument != "--bench");
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--cell" => cell = arguments.next().unwrap_or_default().parse()?,
            _ => meshes.push(argument),
        }
    }
    let mut out = std::io::stdout().lock();
    if meshes.is_empty() {
        writeln!(
            out,
            "no meshes given: cargo bench --manifest-path lab/Cargo.toml --bench cells_quality -- path/to/dragon.ply"
        )?;
        return Ok(());
    }
    let head = || ["mesh".to_owned()].into_iter().chain(SHARES.map(|share| format!("{} %", share * 100.0)));
    let (mut ratios, mut counts) = (Table::new(head()), Table::new(head()));
    for name in &meshes {
        let compared = compare(name, cell)?;
        let label =
            Path::new(name).file_name().map_or(name.clone(), |name| name.to_string_lossy().into_owned());
        let row = |cell: fn(&Compared) -> f64| {
            let cells = compared.iter().map(move |compared| format!("{:.3}", cell(compared)));
            [label.clone()].into_iter().chain(cells).collect()
        };
        ratios.push(row(|compared| compared.rms_ratio));
        counts.push(row(|compared| compared.triangle_ratio));
    }
    writeln!(out, "RMS of levels of the paged file, relative to the in-core sequence.\n")?;
    ratios.print(&mut out)?;
    writeln!(out, "Triangles at the same RMS, relative to the in-core sequence.\n")?;
    counts.print(&mut out)?;
    Ok(())
}

/// Comparison of one level.
struct Compared {
    rms_ratio: f64,
    triangle_ratio: f64,
}

fn compare(name: &str, cell: usize) -> Fallible<Vec<Compared>> {
    let folder = tempfile::TempDir::new()?;
    let input = match name.strip_prefix("terrain:") {
        Some(side) => BuildInput::Terrain(side.parse()?),
        None => BuildInput::Files(vec![name.into()]),
    };
    let options = BuildOptions { cell, exact: true, ..BuildOptions::default() };
    let (output, work) = (folder.path().join("paged.striata"), folder.path().join("work"));
    let plan = PagedPlan::make(
        input,
        options,
        BuildPaths { output: &output, folder: &work },
        2,
        &mut ignore_progress,
    )?;
    run_all(&plan, 2, &mut ignore_progress)?;
    let mut file = PagedFile::open(&output.to_string_lossy())?;
    let paged = file.level_for_triangles(usize::MAX)?.refinable;
    let full = match name.strip_prefix("terrain:") {
        Some(_) => replay(&paged, paged.sequence.step_count()),
        None => striata_io::read(name)?,
    };
    let core = build_sequence(&full, &Default::default())?.refinable;
    let rms = |refinable: &RefinableMesh, count: usize| -> Fallible<f64> {
        let split_count = refinable.sequence.split_count_for_triangles(count);
        distance(&full, &replay(refinable, split_count))
    };
    let levels = SHARES.iter().map(|share| {
        let count = (full.triangle_count() as f64 * share) as usize;
        let expected = rms(&core, count)?;
        let (found, finer) = (rms(&paged, count)?, rms(&paged, (count as f64 * MORE) as usize)?);
        // Distances follow a power of the number of triangles, from one level to the next.
        let slope = (found / finer).ln() / MORE.ln();
        Ok(Compared {
            rms_ratio: found / expected,
            triangle_ratio: (found / expected).powf(1.0 / slope.max(0.1)),
        })
    });
    levels.collect()
}

fn distance(full: &IndexedMesh, level: &IndexedMesh) -> Fallible<f64> {
    Ok(surface_distance(full, level, &DistanceOptions::default().with_sample_count(SAMPLES))?.rms)
}
