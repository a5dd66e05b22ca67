//! `caches`: vertex cache misses of the triangle lists of files, in their own order and in that of meshoptimizer.
//!
//! The cache is a first-in first-out cache of 16 vertices that is empty at the start of each primitive.

use std::path::Path;

use serde::Serialize;
use striata::strip::fifo_cache_cost;
use striata_command::failure::Failure;
use striata_command::output::{Output, Table, format_count};
use striata_io::read_scene;

use crate::args::CachesArgs;

/// Number of vertices in the cache.
const CACHE_SIZE: usize = 16;

#[derive(Serialize)]
struct CachesReport {
    files: Vec<FileReport>,
}

#[derive(Serialize)]
struct FileReport {
    name: String,
    triangle_count: usize,
    /// Misses per triangle.
    acmr_16: f64,
    /// Misses per triangle in the order of meshoptimizer's `optimizeVertexCache`; null without the feature `peers`.
    meshoptimizer_acmr_16: Option<f64>,
    /// The former divided by the latter.
    ratio: Option<f64>,
    /// Share of the vertices that are loaded before any vertex with a larger number, at their first use.
    first_use_share: f64,
}

/// Measures every file and prints the report.
///
/// # Errors
/// If a file cannot be read.
pub(crate) fn run(args: &CachesArgs, output: &Output) -> Result<(), Failure> {
    let files = args.inputs.iter().map(|path| measured(path)).collect::<Result<Vec<_>, _>>()?;
    let report = CachesReport { files };
    output.data(&report, &report.to_text())
}

fn measured(path: &Path) -> Result<FileReport, Failure> {
    let (mut triangle_count, mut used_count, mut ascending_count) = (0, 0, 0);
    let mut misses = [0; 2];
    let scene = read_scene(path)?;
    for mesh in scene.meshes().iter().flatten() {
        let mut next = 0;
        let mut is_used = vec![false; mesh.vertex_count()];
        for group in mesh.groups_or_whole() {
            let triangles = &mesh.triangles[group.range()];
            triangle_count += triangles.len();
            misses[0] += miss_count(triangles.as_flattened());
            misses[1] += other_order(triangles.as_flattened()).map_or(0, |indices| miss_count(&indices));
        }
        for &v in mesh.triangles.as_flattened() {
            if !std::mem::replace(&mut is_used[v as usize], true) {
                used_count += 1;
                ascending_count += usize::from(v >= next);
                next = next.max(v);
            }
        }
    }
    let share = |count: usize, of: usize| count as f64 / of.max(1) as f64;
    let peer = (misses[1] > 0).then_some(misses[1]);
    Ok(FileReport {
        name: path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned()),
        triangle_count,
        acmr_16: share(misses[0], triangle_count),
        meshoptimizer_acmr_16: peer.map(|peer| share(peer, triangle_count)),
        ratio: peer.map(|peer| share(misses[0], peer)),
        first_use_share: share(ascending_count, used_count),
    })
}

fn miss_count(indices: &[u32]) -> usize {
    fifo_cache_cost(indices, indices.len() / 3, CACHE_SIZE).miss_count
}

/// Returns triangles in the order of meshoptimizer, if it is built in.
#[cfg(feature = "peers")]
fn other_order(indices: &[u32]) -> Option<Vec<u32>> {
    let vertex_count = indices.iter().max().map_or(0, |&v| v as usize + 1);
    (vertex_count > 0).then(|| meshopt::optimize_vertex_cache(indices, vertex_count))
}

/// Returns triangles in the order of meshoptimizer, if it is built in.
#[cfg(not(feature = "peers"))]
fn other_order(_: &[u32]) -> Option<Vec<u32>> {
    None
}

impl CachesReport {
    fn to_text(&self) -> String {
        let head = ["file", "triangles", "ACMR, FIFO 16", "meshoptimizer", "ratio", "vertices by first use"];
        let mut table = Table::with_head(&head);
        let or_dash =
            |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| format!("{value:.3}"));
        for file in &self.files {
            table.row(vec![
                file.name.clone(),
                format_count(file.triangle_count),
                format!("{:.3}", file.acmr_16),
                or_dash(file.meshoptimizer_acmr_16),
                or_dash(file.ratio),
                format!("{:.1} %", 100.0 * file.first_use_share),
            ]);
        }
        table.to_text()
    }
}
