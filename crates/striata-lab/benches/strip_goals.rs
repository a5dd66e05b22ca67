//! Strips beside what the stripification paper reports, and how far a given time goes.
//!
//! `cargo bench -p striata-lab --bench strip_goals -- MESH...` prints Markdown tables for the meshes given and the sphere
//! of the papers: strips by the longest tunnel with both kinds of identities, the time to come down to the numbers of
//! strips that \[PS03\] compares, and what `fewest` and `cheapest` reach in some seconds.

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

/// The longest tunnels shown.
const LENGTHS: [u32; 9] = [1, 3, 5, 9, 13, 17, 31, 45, 60];
/// Runs that the best time is taken from, for meshes of less than so many triangles.
const RUN_COUNTS: [(usize, usize); 2] = [(200_000, 5), (usize::MAX, 1)];
/// Seconds given to the searches.
const BUDGETS: [f64; 4] = [0.3, 1.0, 5.0, 20.0];
/// Numbers of strips in tables 3 and 4 of \[PS03\]: of the bunny, and of the dragon.
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
    let mut counts = Table::new(["mesh", "strips asked", "static", "dynamic", "fewest"]);
    let mut budgets =
        Table::new(["mesh", "s", "fewest: strips", "at the very least", "cheapest: indices a triangle"]);
    for (name, mesh) in &meshes {
        add_tunnels(name, mesh, &mut tunnels)?;
        for &(of, asked) in &PAPER_COUNTS {
            if of == name {
                asked.iter().try_for_each(|&count| add_count(name, mesh, count, &mut counts))?;
            }
        }
        add_budgets(name, mesh, &mut budgets)?;
    }
    writeln!(out, "Strips by the longest tunnel, from nothing.\n")?;
    tunnels.print(&mut out)?;
    writeln!(out, "Time to come down to a number of strips: ms, by the shortest tunnels that do.\n")?;
    counts.print(&mut out)?;
    writeln!(out, "What a time reaches.\n")?;
    budgets.print(&mut out)?;
    Ok(())
}

/// Strips, and the best time of several runs in milliseconds.
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

fn add_count(name: &str, mesh: &IndexedMesh, asked: usize, table: &mut Table) -> Fallible<()> {
    let by_tunnels = |make: fn(u32) -> Stripifier| -> Fallible<String> {
        for length in LENGTHS {
            let (count, ms) = timed(mesh, make(length))?;
            if count <= asked {
                return Ok(format!("{ms:.1} (length {length}, {count} strips)"));
            }
        }
        Ok("never".to_owned())
    };
    // `fewest` has no length: its budget is doubled until it has come down far enough.
    let mut budget = 1e-3;
    let walked = loop {
        let (strips, secs) = within(mesh, Stripifier::Fewest, budget)?;
        if strips.strip_count() <= asked || budget > 100.0 {
            break format!("{:.1} ({} strips)", secs * 1e3, strips.strip_count());
        }
        budget *= 1.25;
    };
    table.push(vec![
        name.to_owned(),
        asked.to_string(),
        by_tunnels(|max_length| Stripifier::StaticTunnel { max_length })?,
        by_tunnels(|max_length| Stripifier::Tunnel { max_length })?,
        walked,
    ]);
    Ok(())
}

/// Strips made in so many seconds from the call on, and the seconds that it really took.
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
