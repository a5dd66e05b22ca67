//! Table rows for each stripifier: ours, meshoptimizer's, and those whose output `peers/` has written.

use std::path::{Path, PathBuf};
use std::time::Instant;

use striata::mesh::{IndexedMesh, canonical_triangles};
use striata::strip::{RESTART, fifo_cache_cost, lru_cache_cost, restart_triangles_into};
use striata_strip::{StripOptions, stripify};

use crate::table::Table;
use crate::{Fallible, RUN_COUNT, peer_strips};

/// Cache size in vertices for counting misses.
const CACHE_SIZE: usize = 16;
/// No further run starts after this many seconds.
const MAX_SECS: f64 = 3.0;

/// Our stripifiers: specification, effort, and weight of a cache miss.
const OURS: &[(&str, f64, f64)] = &[
    ("greedy", 1.0, 0.0),
    ("stripe", 1.0, 0.0),
    ("stripe:few-swaps", 1.0, 0.0),
    ("stripe:no-swaps", 1.0, 0.0),
    ("stripe:global", 1.0, 0.0),
    ("stripe:global:few-swaps", 1.0, 0.0),
    ("tunnel:5", 1.0, 0.0),
    ("tunnel:17", 1.0, 0.0),
    ("fewest", 1.0, 0.0),
    ("fewest", 8.0, 0.0),
    ("cheapest", 1.0, 0.0),
    ("cheapest", 8.0, 0.0),
    ("cheapest", 1.0, 0.05),
    ("cheapest", 1.0, 0.25),
    ("cheapest", 1.0, 0.5),
    ("cheapest", 1.0, 1.0),
    ("cheapest", 4.0, 1.0),
    ("cheapest", 1.0, 3.0),
];

/// Header of the table that [`add_rows`] fills.
pub(crate) const HEAD: [&str; 8] = [
    "mesh",
    "tool",
    "strips",
    "indices per triangle",
    "ACMR, FIFO 16",
    "ATVR, FIFO 16",
    "ACMR, LRU 16",
    "ms",
];

/// Selection of table rows.
#[derive(Default)]
pub(crate) struct Choice {
    /// Whether to omit efforts other than 1 and weights other than 0 and 1.
    pub is_quick: bool,
    /// Folder with the strips of other tools.
    pub peers: Option<PathBuf>,
}

/// Adds the rows of a mesh.
pub(crate) fn add_rows(name: &str, mesh: &IndexedMesh, choice: &Choice, table: &mut Table) -> Fallible<()> {
    let expected_mesh = ExpectedMesh { name, expected: sorted_triangles(mesh.triangles.clone()) };
    for &(spelling, effort, weight) in OURS {
        if choice.is_quick && (effort != 1.0 || (weight != 0.0 && weight != 1.0)) {
            continue;
        }
        // Stripifiers that this build does not include have no row.
        let Ok(stripifier) = spelling.parse() else { continue };
        let options = StripOptions::default()
            .with_stripifier(stripifier)
            .with_effort(effort)
            .with_cache_weight(weight)
            .with_cache_size(CACHE_SIZE);
        let (secs, strips) = best(|| stripify(mesh, &options));
        let effort = if effort == 1.0 { String::new() } else { format!(", effort {effort}") };
        let weight = if weight == 0.0 { String::new() } else { format!(", a miss weighs {weight}") };
        let tool = format!("striata, {spelling}{effort}{weight}");
        expected_mesh.add(&tool, &strips?.to_restart_indices().indices, secs, table);
    }
    let list: &[u32] = mesh.triangles.as_flattened();
    let (secs, strips) = best(|| {
        let ordered = meshopt::optimize_vertex_cache_strip(list, mesh.vertex_count());
        meshopt::stripify(&ordered, mesh.vertex_count(), RESTART)
    });
    expected_mesh.add("meshoptimizer, strip order", &strips?, secs, table);
    if let Some(folder) = &choice.peers {
        expected_mesh.add_peers(folder, table)?;
    }
    Ok(())
}

/// A mesh and the triangles that every tool has to draw.
struct ExpectedMesh<'a> {
    name: &'a str,
    expected: Vec<[u32; 3]>,
}

impl ExpectedMesh<'_> {
    fn add(&self, tool: &str, indices: &[u32], secs: f64, table: &mut Table) {
        let mut triangles = Vec::new();
        restart_triangles_into(indices, &mut triangles);
        let triangle_count = triangles.len().max(1);
        let fifo = fifo_cache_cost(indices, triangle_count, CACHE_SIZE);
        let lru = lru_cache_cost(indices, triangle_count, CACHE_SIZE);
        let strip_count = indices.split(|&i| i == RESTART).filter(|strip| !strip.is_empty()).count();
        let (missing, extra) = differences(&self.expected, &sorted_triangles(triangles));
        let note = if missing + extra == 0 {
            String::new()
        } else {
            format!(" ({missing} triangles missing, {extra} not the mesh's)")
        };
        table.push(vec![
            self.name.to_owned(),
            format!("{tool}{note}"),
            strip_count.to_string(),
            format!("{:.3}", indices.len() as f64 / triangle_count as f64),
            format!("{:.3}", fifo.acmr),
            format!("{:.3}", fifo.atvr),
            format!("{:.3}", lru.acmr),
            format!("{:.1}", secs * 1e3),
        ]);
    }

    /// Adds the files `NAME.TOOL.strips` of a folder: f64 milliseconds, u32 count, u32 indices.
    fn add_peers(&self, folder: &Path, table: &mut Table) -> Fallible<()> {
        let mut paths: Vec<_> =
            std::fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<Fallible<_>>()?;
        paths.sort();
        for path in paths {
            let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            let tool = file.strip_suffix(".strips").and_then(|stem| stem.strip_prefix(self.name));
            let Some(tool) = tool.and_then(|rest| rest.strip_prefix('.')) else { continue };
            let (ms, indices) = peer_strips::read(&path)?;
            self.add(tool, &indices, ms / 1e3, table);
        }
        Ok(())
    }
}

/// Writes a mesh in the plain format that other tools read: two counts, positions, corners, little-endian.
pub(crate) fn write_list(name: &str, mesh: &IndexedMesh, folder: &Path) -> Fallible<()> {
    let counts = [mesh.vertex_count() as u32, mesh.triangle_count() as u32];
    let mut bytes: Vec<u8> = counts.iter().flat_map(|count| count.to_le_bytes()).collect();
    bytes.extend(mesh.positions.iter().flatten().flat_map(|x| x.to_le_bytes()));
    bytes.extend(mesh.triangles.iter().flatten().flat_map(|v| v.to_le_bytes()));
    Ok(std::fs::write(folder.join(format!("{name}.triangles")), bytes)?)
}

/// Fastest of several runs in seconds, and the result of the last one.
fn best<T>(mut work: impl FnMut() -> T) -> (f64, T) {
    let begin = Instant::now();
    let (mut best_secs, mut result) = (f64::INFINITY, None);
    for _ in 0..RUN_COUNT {
        let start = Instant::now();
        result = Some(std::hint::black_box(work()));
        best_secs = best_secs.min(start.elapsed().as_secs_f64());
        if begin.elapsed().as_secs_f64() > MAX_SECS {
            break;
        }
    }
    (best_secs, result.expect("there is at least one run"))
}

fn sorted_triangles(mut triangles: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
    triangles.retain(|t| t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
    canonical_triangles(&triangles)
}

/// Numbers of missing triangles and of extra ones.
fn differences(expected: &[[u32; 3]], found: &[[u32; 3]]) -> (usize, usize) {
    let (mut e, mut f, mut common) = (0, 0, 0);
    while e < expected.len() && f < found.len() {
        match expected[e].cmp(&found[f]) {
            std::cmp::Ordering::Less => e += 1,
            std::cmp::Ordering::Greater => f += 1,
            std::cmp::Ordering::Equal => (e, f, common) = (e + 1, f + 1, common + 1),
        }
    }
    (expected.len() - common, found.len() - common)
}
