//! Strip counts compared with those of the stripification paper, and the results of time budgets.
//!
//! `cargo bench -p striata-lab --bench strip_goals -- MESH...` prints Markdown tables for the given meshes
//! and the papers' sphere: strips by maximum tunnel length with both kinds of identities, the time to
//! reach the strip counts that \[PS03\] compares, and what `fewest` and `cheapest` reach in some seconds.

#[path = "quality/table.rs"]
mod table;

use std::error::Error;
use std::io::Write;
use std::time::Instant;

use striata::mesh::{IndexedMesh, shapes, weld};
use striata::strip::StripSet;
use striata_strip::{StripOptions, Stripifier, strip_count_bound, stripify, stripify_from};
use table::Table;

type Fallible<T> = Result<T, Box<dyn Error>>;

/// Maximum tunnel lengths shown.
const LENGTHS: [u32; 9] = [1, 3, 5, 9, 13, 17, 31, 45, 60];
/// Number of runs to take the fastest of, for meshes with fewer triangles than the limit.
const RUN_COUNTS: [(usize, usize); 2] = [(200_000, 5), (usize::MAX, 1)];
/// Time budgets of the searches, in seconds.
const BUDGETS: [f64; 4] = [0.3, 1.0, 5.0, 20.0];
/// Strip counts in tables 3 and 4 of \[PS03\]: of the bunny, and of the dragon.
const PAPER_COUNTS: [(&str, [usize; 2]); 2] = [("bunny", [705, 158]), ("dragon", [17_653, 1_798])];

fn main() -> Fallible<()> {
    let paths: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let mut out = std::io::stdout().lock();
    if paths.is_empty() {
        writeln!(
            out,
            "no meshes given: cargo bench -p striata-lab --bench strip_goals -- path/to/bunny.ply"
        )?;
        return Ok(());
    }
    let mut meshes = vec![("sphere".to_owned(), shapes::paper_sphere())];
    for path in &paths {
        let mesh = striata_io::read(path)?;
        let file = std::path::Path::new(path).file_name().map_or(path.into(), |name| name.to_string_lossy());
        let name = file.split('.').next().unwrap_or_default().to_owned();
        meshes.push((name, weld(&IndexedMesh::new(mesh.positions, mesh.triangles))?.mesh));
    }
    let mut tunnels = Table::new(["mesh", "longest tunnel", "static: strips", "ms", "dynamic: strips", "ms"]);
    let mut counts = Table::new(["mesh", "target strips", "static", "dynamic", "fewest"]);
    let mut budgets =
        Table::new(["mesh", "s", "fewest: strips", "lower bound", "cheapest: indices per triangle"]);
    for (name, mesh) in &meshes {
        add_tunnels(name, mesh, &mut tunnels)?;
        for &(of, target_count) in &PAPER_COUNTS {
            if of == name {
                target_count.iter().try_for_each(|&count| add_count(name, mesh, count, &mut counts))?;
            }
        }
        add_budgets(name, mesh, &mut budgets)?;
    }
    writeln!(out, "Strips by maximum tunnel length, from scratch.\n")?;
    tunnels.print(&mut out)?;
    writeln!(out, "Time to reach a strip count, in ms, with the shortest tunnels that reach it.\n")?;
    counts.print(&mut out)?;
    writeln!(out, "Results within a time budget.\n")?;
    budgets.print(&mut out)?;
    Ok(())
}

/// Stripifies a mesh; returns the strip count and the fastest of several runs in milliseconds.
fn timed(mesh: &IndexedMesh, stripifier: Stripifier) -> Fallible<(usize, f64)> {
    let options = StripOptions::default().with_stripifier(stripifier);
    let run_count = RUN_COUNTS.iter().find(|(limit, _)| mesh.triangle_count() < *limit).map_or(1, |r| r.1);
    let mut best = (0, f64::MAX);
    for _ in 0..run_count {
        let start = Instant::now();
        let strips = stripify(mesh, &options)?;
        best = (strips.strip_count(), best.1.min(start.elapsed().as_secs_f64() * 1e3));
    }
    Ok(best)
}

fn add_tunnels(name: &str, mesh: &IndexedMesh, table: &mut Table) -> Fallible<()> {
    for max_length in LENGTHS {
        let (fixed, fixed_ms) = timed(mesh, Stripifier::StaticTunnel { max_length })?;
        let (moving, moving_ms) = timed(mesh, Stripifier::Tunnel { max_length })?;
        table.push(vec![
            name.to_owned(),
            max_length.to_string(),
            fixed.to_string(),
            format!("{fixed_ms:.1}"),
            moving.to_string(),
            format!("{moving_ms:.1}"),
        ]);
    }
    Ok(())
}

fn add_count(name: &str, mesh: &IndexedMesh, target_count: usize, table: &mut Table) -> Fallible<()> {
    let by_tunnels = |make: fn(u32) -> Stripifier| -> Fallible<String> {
        for length in LENGTHS {
            let (count, ms) = timed(mesh, make(length))?;
            if count <= target_count {
                return Ok(format!("{ms:.1} (length {length}, {count} strips)"));
            }
        }
        Ok("never".to_owned())
    };
    // `fewest` has no length: increase its budget until it reaches the count.
    let mut budget = 1e-3;
    let fewest_time = loop {
        let (strips, secs) = within(mesh, Stripifier::Fewest, budget)?;
        if strips.strip_count() <= target_count || budget > 100.0 {
            break format!("{:.1} ({} strips)", secs * 1e3, strips.strip_count());
        }
        budget *= 1.25;
    };
    table.push(vec![
        name.to_owned(),
        target_count.to_string(),
        by_tunnels(|max_length| Stripifier::StaticTunnel { max_length })?,
        by_tunnels(|max_length| Stripifier::Tunnel { max_length })?,
        fewest_time,
    ]);
    Ok(())
}

/// Stripifies within a time budget in seconds; returns the strips and the seconds actually taken.
fn within(mesh: &IndexedMesh, stripifier: Stripifier, budget: f64) -> Fallible<(StripSet, f64)> {
    let options = StripOptions::default().with_stripifier(stripifier);
    let start = Instant::now();
    let mut spent = |_| start.elapsed().as_secs_f64() / budget;
    let strips = stripify_from(mesh, &StripSet::new(), &options, &mut spent)?;
    Ok((strips, start.elapsed().as_secs_f64()))
}

fn add_budgets(name: &str, mesh: &IndexedMesh, table: &mut Table) -> Fallible<()> {
    let bound = strip_count_bound(mesh);
    for budget in BUDGETS {
        let fewest = within(mesh, Stripifier::Fewest, budget)?.0.strip_count();
        let cheapest = within(mesh, Stripifier::Cheapest, budget)?.0.cost().indices_per_triangle;
        table.push(vec![
            name.to_owned(),
            budget.to_string(),
            fewest.to_string(),
            bound.to_string(),
            format!("{cheapest:.4}"),
        ]);
    }
    Ok(())
}
