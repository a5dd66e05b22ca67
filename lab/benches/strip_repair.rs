//! Strips under level of detail: with substituted indices, repaired, or computed from scratch.
//!
//! `cargo bench --manifest-path lab/Cargo.toml --bench strip_repair -- MESH...` prints Markdown tables; attributes are
//! ignored. Strips of the full mesh follow it to the base and back. The last table measures the time per
//! step on terrains of growing size; times are CPU times of the thread.

#[path = "quality/table.rs"]
mod table;

use std::error::Error;
use std::hint::black_box;
use std::io::Write;
use std::time::Instant;

use striata::mesh::{IndexedMesh, RefinableMesh, replay, shapes};
use striata::model::{LodModel, LodStrips, StripModel};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::{StripSet, restart_triangles_into};
use striata_lab::cpu_secs;
use striata_strip::{
    LiveStrips, RepairGoal, RepairOptions, RepairReport, StripOptions, Stripifier, stripify,
};
use table::Table;

type Fallible<T> = Result<T, Box<dyn Error>>;

/// Percentages of the triangles at which levels are compared.
const PERCENTS: [usize; 5] = [100, 50, 25, 10, 2];
/// Number of runs to take the fastest of.
const RUN_COUNT: usize = 3;
/// Sides of the terrains used for timing: 10 thousand, 100 thousand and a million triangles.
const TERRAIN_SIDES: [u32; 3] = [71, 224, 708];

fn main() -> Fallible<()> {
    let paths: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let mut out = std::io::stdout().lock();
    let mut head = vec!["mesh".to_owned(), "strips".to_owned()];
    head.extend(PERCENTS.map(|percent| format!("{percent} %")));
    head.extend(PERCENTS.iter().rev().skip(1).map(|percent| format!("back at {percent} %")));
    let mut levels = Table::new(head);
    let mut times = Table::new(TIMES_HEAD);
    for path in &paths {
        let mesh = striata_io::read(path)?;
        let refinable = refinable(&IndexedMesh::new(mesh.positions, mesh.triangles))?;
        let file = std::path::Path::new(path).file_name().map_or(path.into(), |name| name.to_string_lossy());
        let name = file.split('.').next().unwrap_or_default().to_owned();
        add_levels(&name, &refinable, &mut levels)?;
        add_times(&name, &refinable, &mut times)?;
    }
    for side in TERRAIN_SIDES {
        add_times("terrain", &refinable(&shapes::terrain(side, 1))?, &mut times)?;
    }
    writeln!(out, "Indices per triangle including restarts, and strip counts in parentheses.\n")?;
    levels.print(&mut out)?;
    writeln!(out, "One sweep from the full mesh to the base and back, against new strips for one level.\n")?;
    times.print(&mut out)?;
    Ok(())
}

fn refinable(mesh: &IndexedMesh) -> Fallible<RefinableMesh> {
    Ok(build_sequence(mesh, &SequenceOptions::default())?.refinable)
}

/// The repair variants: name and options.
fn repairs() -> Vec<(&'static str, RepairOptions)> {
    let goal = |goal| RepairOptions::default().with_goal(goal);
    let fast = RepairOptions::default().with_tunnel_length(5).with_search_limit(8).with_reach(0);
    vec![
        ("carried over, no search", RepairOptions::default().with_tunnel_length(0)),
        ("repaired, quick", fast),
        ("repaired, fewest indices", goal(RepairGoal::FewestIndices)),
        ("repaired, fewest strips", goal(RepairGoal::FewestStrips)),
    ]
}

fn cell(strips: &StripSet) -> String {
    let cost = strips.cost();
    format!("{:.3} ({})", cost.indices_per_triangle, cost.strip_count)
}

fn add_levels(name: &str, refinable: &RefinableMesh, table: &mut Table) -> Fallible<()> {
    let full = refinable.mesh.triangle_count();
    let down = PERCENTS.map(|percent| refinable.sequence.split_count_for_triangles(full * percent / 100));
    let way: Vec<usize> = down.into_iter().chain(down.into_iter().rev().skip(1)).collect();
    let mut add = |tool: &str, cells: Vec<String>| {
        table.push([name.to_owned(), tool.to_owned()].into_iter().chain(cells).collect());
    };
    let strips = stripify(&refinable.mesh, &StripOptions::default())?;
    let model = LodStrips::build(refinable, &strips)?;
    let mut state = model.new_state();
    let mut cells = Vec::new();
    for &split_count in &way {
        model.move_to(&mut state, split_count);
        cells.push(substituted(&model, &state));
    }
    add("LodStrips", cells);
    for (tool, options) in repairs() {
        let mut live = LiveStrips::new(refinable, down[0], &strips, &options)?;
        let mut cells = Vec::new();
        for (i, &split_count) in way.iter().enumerate() {
            if i == PERCENTS.len() {
                live.move_to(0);
            }
            live.move_to(split_count);
            cells.push(cell(&live.to_strip_set()));
        }
        add(tool, cells);
    }
    for stripifier in ["greedy", "tunnel:17", "cheapest"] {
        let Ok(stripifier) = stripifier.parse::<Stripifier>() else { continue };
        let options = StripOptions::default().with_stripifier(stripifier);
        let from_scratch =
            |&s: &usize| Ok::<_, Box<dyn Error>>(cell(&stripify(&replay(refinable, s), &options)?));
        let mut cells = down.iter().map(from_scratch).collect::<Result<Vec<_>, _>>()?;
        // Strips computed from scratch do not depend on the path.
        cells.extend_from_within(..PERCENTS.len() - 1);
        cells[PERCENTS.len()..].reverse();
        add(&format!("from scratch, {stripifier}"), cells);
    }
    Ok(())
}

/// Indices per triangle and strip count of LodStrips at a level.
fn substituted(model: &LodStrips<'_>, state: &<LodStrips<'_> as LodModel>::State) -> String {
    let (mut strip_count, mut index_count, mut triangles) = (0, 0, Vec::new());
    for strip in 0..model.strip_count() {
        let indices = model.strip(state, strip);
        strip_count += usize::from(!indices.is_empty());
        index_count += indices.len();
        restart_triangles_into(indices, &mut triangles);
    }
    let with_restarts = (index_count + strip_count).saturating_sub(1);
    format!("{:.3} ({strip_count})", with_restarts as f64 / triangles.len().max(1) as f64)
}

const TIMES_HEAD: [&str; 9] = [
    "mesh",
    "triangles",
    "repair",
    "µs per collapse",
    "µs per split",
    "tunnels per step",
    "touched per step",
    "bytes per triangle",
    "from scratch, greedy, ms",
];

fn add_times(name: &str, refinable: &RefinableMesh, table: &mut Table) -> Fallible<()> {
    let step_count = refinable.sequence.step_count();
    let (from_scratch_secs, strips) = best(|| stripify(&refinable.mesh, &StripOptions::default()));
    let strips = strips?;
    for (tool, options) in repairs() {
        let full = LiveStrips::new(refinable, step_count, &strips, &options)?;
        let (down_secs, (down, base)) = best_move(&full, 0);
        let (up_secs, (up, live)) = best_move(&base, step_count);
        let per_step = |secs: f64| format!("{:.2}", secs * 1e6 / step_count.max(1) as f64);
        let share = |count: usize| format!("{:.2}", count as f64 / (2 * step_count).max(1) as f64);
        table.push(vec![
            name.to_owned(),
            refinable.mesh.triangle_count().to_string(),
            tool.to_owned(),
            per_step(down_secs),
            per_step(up_secs),
            share(down.tunnel_count + up.tunnel_count),
            share(down.touched_count + up.touched_count),
            format!("{:.0}", live.bytes() as f64 / refinable.mesh.triangle_count() as f64),
            format!("{:.1}", from_scratch_secs * 1e3),
        ]);
    }
    Ok(())
}

/// Fastest of several moves from one state, with the report and the resulting state of that move.
fn best_move<'a>(from: &LiveStrips<'a>, split_count: usize) -> (f64, (RepairReport, LiveStrips<'a>)) {
    let run = || {
        let mut live = from.clone();
        let start = cpu_secs();
        let report = live.move_to(split_count);
        (cpu_secs() - start, (report, live))
    };
    (1..RUN_COUNT).fold(run(), |best, _| {
        let next = run();
        if next.0 < best.0 { next } else { best }
    })
}

/// Wall-clock time of the fastest of several runs, and its result; too short for the system's CPU accounting.
fn best<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let mut run = || {
        let start = Instant::now();
        let result = black_box(work());
        (start.elapsed().as_secs_f64(), result)
    };
    let first = run();
    (1..RUN_COUNT).fold(first, |best, _| {
        let next = run();
        if next.0 < best.0 { next } else { best }
    })
}
