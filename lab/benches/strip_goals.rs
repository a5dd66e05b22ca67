//! Strip counts and times compared with those of the stripification paper, and the results of time budgets.
//!
//! `cargo bench --manifest-path lab/Cargo.toml --bench strip_goals -- MESH...` prints Markdown tables for the given meshes: how
//! long SGI's `tomesh`, tunneling as published and our stripifiers take to reach the strip counts of \[PS03\],
//! mean and standard deviation over ten seeds, and what `fewest` and `cheapest` reach in some seconds.
//!
//! `--as-filed` leaves equal vertices apart; `--seeds N` changes the number of seeds; `--tunnels NAME,...` measures
//! only some kinds of tunneling, and none after `--tunnels none`.

#[path = "quality/table.rs"]
mod table;

use std::error::Error;
use std::io::Write;
use std::time::Instant;

use striata::mesh::{IndexedMesh, weld};
use striata::strip::StripSet;
use striata_lab::stripifiers::{Tunneling, join_like_tomesh, strips_of};
use striata_lab::{Spread, cpu_secs};
use striata_strip::{StripOptions, Stripifier, strip_count_bound, stripify_from};
use table::Table;

type Fallible<T> = Result<T, Box<dyn Error>>;

/// Maximum tunnel lengths that are tried, from the shortest.
const LENGTHS: [u32; 13] = [1, 3, 5, 9, 13, 17, 21, 25, 31, 45, 60, 75, 101];
/// Number of seeds.
const SEED_COUNT: u64 = 10;
/// Number of runs of stripifiers without a seed, of which the fastest counts.
const RUN_COUNT: usize = 5;
/// Time budgets of the searches, in seconds.
const BUDGETS: [f64; 4] = [0.3, 1.0, 5.0, 20.0];
/// Strip counts that \[PS03\] matched, with the algorithm that they belong to: of the bunny, and of the dragon.
const MATCHED: [(&str, [(&str, usize); 2]); 2] =
    [("bunny", [("SGI", 705), ("Stewart", 158)]), ("dragon", [("SGI", 17_653), ("Stewart", 1_798)])];

/// Parsed command line.
struct Arguments {
    paths: Vec<String>,
    is_as_filed: bool,
    seed_count: u64,
    tunnels: Vec<Tunneling>,
}

impl Arguments {
    fn parse(mut words: impl Iterator<Item = String>) -> Fallible<Self> {
        let tunnels = Tunneling::ALL.to_vec();
        let mut found = Self { paths: Vec::new(), is_as_filed: false, seed_count: SEED_COUNT, tunnels };
        while let Some(word) = words.next() {
            match word.as_str() {
                "--bench" => {}
                "--as-filed" => found.is_as_filed = true,
                "--seeds" => found.seed_count = words.next().ok_or("--seeds takes a number")?.parse()?,
                "--tunnels" => {
                    let names = words.next().ok_or("--tunnels takes names")?;
                    found.tunnels.retain(|kind| names.split(',').any(|name| name == kind.as_str()));
                }
                _ => found.paths.push(word),
            }
        }
        Ok(found)
    }
}

fn main() -> Fallible<()> {
    let arguments = Arguments::parse(std::env::args().skip(1))?;
    let mut out = std::io::stdout().lock();
    if arguments.paths.is_empty() {
        writeln!(
            out,
            "no meshes given: cargo bench --manifest-path lab/Cargo.toml --bench strip_goals -- path/to/bunny.ply"
        )?;
        return Ok(());
    }
    let mut counts =
        Table::new(["mesh", "matched", "target strips", "algorithm", "length", "strips", "CPU ms"]);
    let mut budgets =
        Table::new(["mesh", "s", "fewest: strips", "lower bound", "cheapest: indices per triangle"]);
    for path in &arguments.paths {
        let mesh = striata_io::read(path)?;
        let file = std::path::Path::new(path).file_name().map_or(path.into(), |name| name.to_string_lossy());
        let name = file.split('.').next().unwrap_or_default().to_owned();
        let mesh = IndexedMesh::new(mesh.positions, mesh.triangles);
        let mesh = if arguments.is_as_filed { mesh } else { weld(&mesh)?.mesh };
        for &(of, matched) in MATCHED.iter().filter(|(of, _)| *of == name) {
            let mut rows = Rows { table: &mut counts, mesh: &mesh, arguments: &arguments };
            matched.iter().try_for_each(|&(whose, target)| rows.add(of, whose, target))?;
        }
        if !arguments.is_as_filed {
            add_budgets(&name, &mesh, &mut budgets)?;
        }
    }
    writeln!(
        out,
        "Time to reach the strip counts that [PS03] matched: the shortest tunnels that reach them in the mean over \
         {} seeds.\n",
        arguments.seed_count
    )?;
    counts.print(&mut out)?;
    if !arguments.is_as_filed {
        writeln!(out, "Results within a time budget.\n")?;
        budgets.print(&mut out)?;
    }
    Ok(())
}

/// Rows of the table of times.
struct Rows<'a> {
    table: &'a mut Table,
    mesh: &'a IndexedMesh,
    arguments: &'a Arguments,
}

impl Rows<'_> {
    /// Adds a row for each algorithm.
    fn add(&mut self, name: &str, whose: &str, target: usize) -> Fallible<()> {
        let mut push = |algorithm: &str, length: String, strips: String, ms: String| {
            let first = [name, whose, &target.to_string(), algorithm].map(str::to_owned);
            self.table.push(first.into_iter().chain([length, strips, ms]).collect());
        };
        let (count, ms) = tomesh(self.mesh)?;
        push("tomesh", "–".to_owned(), count.to_string(), format!("{ms:.1}"));
        for &tunneling in &self.arguments.tunnels {
            match shortest(tunneling, self.mesh, target, self.arguments.seed_count)? {
                Some((length, strips, ms)) => {
                    push(tunneling.as_str(), length.to_string(), cell(strips), cell(ms));
                }
                None => push(tunneling.as_str(), "–".to_owned(), "–".to_owned(), "never".to_owned()),
            }
        }
        let (count, ms) = fewest(self.mesh, target)?;
        push("fewest", "–".to_owned(), count.to_string(), format!("{ms:.1}"));
        Ok(())
    }
}

/// Mean and standard deviation, with one decimal.
fn cell(spread: Spread) -> String {
    format!("{:.1} ± {:.1}", spread.mean, spread.std)
}

/// Strip count and milliseconds of the fastest run of `tomesh`.
fn tomesh(mesh: &IndexedMesh) -> Fallible<(usize, f64)> {
    let mut best = (0, f64::MAX);
    for _ in 0..RUN_COUNT {
        let start = cpu_secs();
        let strips = strips_of(mesh, join_like_tomesh)?;
        best = (strips.strip_count(), best.1.min((cpu_secs() - start) * 1e3));
    }
    Ok(best)
}

/// The shortest tunnels that reach a strip count in the mean; strips and milliseconds.
fn shortest(
    tunneling: Tunneling,
    mesh: &IndexedMesh,
    target: usize,
    seed_count: u64,
) -> Fallible<Option<(u32, Spread, Spread)>> {
    for length in LENGTHS {
        // One seed shows whether the others are worth trying.
        if tunneling.strip_count(mesh, length, 0)? > target + target / 8 {
            continue;
        }
        let (mut counts, mut times) = (Vec::new(), Vec::new());
        for seed in 0..seed_count {
            let start = cpu_secs();
            counts.push(tunneling.strip_count(mesh, length, seed)? as f64);
            times.push((cpu_secs() - start) * 1e3);
        }
        if Spread::of(&counts).mean <= target as f64 {
            return Ok(Some((length, Spread::of(&counts), Spread::of(&times))));
        }
    }
    Ok(None)
}

/// Strip count and milliseconds of `fewest`, which has no length: its budget grows until it reaches the count.
fn fewest(mesh: &IndexedMesh, target: usize) -> Fallible<(usize, f64)> {
    let mut budget = 1e-3;
    loop {
        let (strips, secs) = within(mesh, Stripifier::Fewest, budget)?;
        if strips.strip_count() <= target || budget > 100.0 {
            return Ok((strips.strip_count(), secs * 1e3));
        }
        budget *= 1.25;
    }
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
