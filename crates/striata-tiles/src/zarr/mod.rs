//! Zarr v3: a mesh in refinement order as flat arrays, of which every level of detail reads the first rows.
//!
//! ```text
//!  positions, vertices/*   rows of all vertices: a level with n vertices has the first n
//!  targets                 the vertex that each vertex collapses to
//!  levels/0/triangles      triangles of the full mesh; levels/1, 2, ...: of the first 1/4, 1/16, ... of the vertices
//! ```
//!
//! A level is made from the triangles of the next finer level that is stored: corners move to their targets until they
//! are among the first n vertices. So a level reads at most a few times as many numbers as it shows.

mod array;

use std::collections::BTreeSet;
use std::io::{self, Write as _};
use std::path::Path;

use serde::Serialize;
use serde_json::{Value, json};
use striata::mesh::{AttributeLayer, CollapseSequence, LayerData, RefinableMesh, replay};
use striata::{Progress, ProgressFn};

use crate::error::TilesError;
use crate::sink::{FolderSink, GENERATOR, check_folder};
use array::ZarrArray;

/// Version of the layout.
const VERSION: u32 = 1;
/// Quotient of the numbers of vertices of levels that are stored.
const QUOTIENT: usize = 4;

/// Numbers of a mesh in a Zarr store, and remarks on it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ZarrReport {
    /// Number of vertices.
    pub vertices: u64,
    /// Number of levels, one for each collapse and the full mesh.
    pub level_count: u64,
    /// Levels whose triangles are stored, finest first.
    pub levels: Vec<ZarrLevel>,
    /// Paths of all arrays.
    pub arrays: Vec<String>,
    /// Remarks on data of the mesh that the store does not contain.
    pub left_out: Vec<String>,
}

/// A level whose triangles are stored.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ZarrLevel {
    /// Path of its group.
    pub path: String,
    /// Number of vertices.
    pub vertices: u64,
    /// Number of triangles.
    pub triangles: u64,
    /// Largest distance of the full mesh from the level, in mesh units.
    pub error: f32,
}

/// A group while it is written.
struct ArrayStore {
    sink: FolderSink,
    arrays: Vec<String>,
}

/// Writes a folder with a Zarr v3 group. `is_guaranteed` says whether errors are bounds; they are estimates if not.
///
/// # Errors
/// [`TilesError`]; a folder that was there is then unchanged.
pub fn write_zarr(
    refinable: &RefinableMesh,
    is_guaranteed: bool,
    output: &Path,
    progress: &mut ProgressFn<'_>,
) -> Result<ZarrReport, TilesError> {
    check_folder(output)?;
    if refinable.mesh.triangles.is_empty() {
        return Err(TilesError::Empty { name: output.display().to_string() });
    }
    let failed = |source| TilesError::Io { path: output.to_owned(), source };
    let mut store = ArrayStore { sink: FolderSink::new(output)?, arrays: Vec::new() };
    store.put_vertices(refinable).map_err(failed)?;
    let sequence = &refinable.sequence;
    let splits = stored_splits(sequence);
    let (mut levels, mut rows) = (Vec::new(), Vec::new());
    for (number, &split_count) in splits.iter().enumerate() {
        let (level, groups) = store.put_level(refinable, number, split_count).map_err(failed)?;
        let ZarrLevel { path, vertices, triangles, error } = &level;
        rows.push(json!({
            "path": path, "vertices": vertices, "triangles": triangles, "error": error, "groups": groups,
        }));
        levels.push(level);
        Progress { phase: "level", done: number as u64 + 1, total: splits.len() as u64 }.report(progress)?;
    }
    let described = json!({
        "generator": GENERATOR,
        "version": VERSION,
        "origin": if refinable.mesh.exact_positions.is_empty() { refinable.mesh.origin } else { [0.0; 3] },
        "guaranteed_errors": is_guaranteed,
        "levels": rows,
        "georeference": serde_json::from_str::<Value>(&refinable.mesh.appearance.georeference).ok(),
    });
    store.put_group("", json!({ "striata": described })).map_err(failed)?;
    store.sink.finish(output).map_err(failed)?;
    Ok(ZarrReport {
        vertices: refinable.mesh.positions.len() as u64,
        level_count: sequence.step_count() as u64 + 1,
        levels,
        arrays: store.arrays,
        left_out: left_out(refinable),
    })
}

/// The full mesh, levels with a quarter of the vertices each, and the base mesh.
fn stored_splits(sequence: &CollapseSequence) -> Vec<usize> {
    let mut splits = vec![sequence.step_count()];
    let mut limit = sequence.vertex_count_at(sequence.step_count());
    while splits.last() > Some(&0) {
        limit /= QUOTIENT;
        splits.push(sequence.split_count_for_vertices(limit));
    }
    splits.dedup();
    splits
}

impl ArrayStore {
    fn put_group(&mut self, path: &str, attributes: Value) -> io::Result<()> {
        let node = json!({ "zarr_format": 3, "node_type": "group", "attributes": attributes });
        let name = if path.is_empty() { "zarr.json".to_owned() } else { format!("{path}/zarr.json") };
        self.sink.open(&name)?.write_all(node.to_string().as_bytes())
    }

    fn put(&mut self, path: &str, array: &ZarrArray) -> io::Result<()> {
        array.put(&mut self.sink, path)?;
        self.arrays.push(path.to_owned());
        Ok(())
    }

    /// Writes everything but triangles.
    fn put_vertices(&mut self, refinable: &RefinableMesh) -> io::Result<()> {
        let RefinableMesh { mesh, sequence } = refinable;
        let positions = match mesh.exact_positions.is_empty() {
            true => LayerData::F32(mesh.positions.as_flattened().to_vec()),
            false => LayerData::F64(mesh.exact_positions.as_flattened().to_vec()),
        };
        self.put("positions", &ZarrArray::rows(positions, 3))?;
        let targets = (0..mesh.positions.len() as u32).map(|v| sequence.target(v)).collect();
        self.put("targets", &ZarrArray::list(LayerData::U32(targets)))?;
        let levels = || 0..=sequence.step_count();
        let errors = levels().map(|level| sequence.error_at(level)).collect();
        self.put("errors", &ZarrArray::list(LayerData::F32(errors)))?;
        let counts = levels().map(|level| sequence.vertex_count_at(level) as u32).collect();
        self.put("vertex_counts", &ZarrArray::list(LayerData::U32(counts)))?;
        let counts = levels().map(|level| sequence.triangle_count_at(level) as u32).collect();
        self.put("triangle_counts", &ZarrArray::list(LayerData::U32(counts)))?;
        self.put_group("vertices", json!({}))?;
        self.put_layers("vertices", &mesh.layers)?;
        self.put_group("levels", json!({}))
    }

    /// Writes the triangles of a level and their data. Also returns what describes its groups.
    fn put_level(
        &mut self,
        refinable: &RefinableMesh,
        number: usize,
        split_count: usize,
    ) -> io::Result<(ZarrLevel, Vec<Value>)> {
        let level = replay(refinable, split_count);
        let path = format!("levels/{number}");
        self.put_group(&path, json!({}))?;
        let triangles = LayerData::U32(level.triangles.as_flattened().to_vec());
        self.put(&format!("{path}/triangles"), &ZarrArray::rows(triangles, 3))?;
        self.put_group(&format!("{path}/faces"), json!({}))?;
        self.put_layers(&format!("{path}/faces"), &level.triangle_layers)?;
        let described = |group: &striata::mesh::TriangleGroup| json!({ "name": group.name, "first": group.first, "count": group.count });
        let groups = level.groups.iter().map(described).collect();
        let (vertices, triangles) = (level.positions.len() as u64, level.triangles.len() as u64);
        let error = refinable.sequence.error_at(split_count);
        Ok((ZarrLevel { path, vertices, triangles, error }, groups))
    }

    /// Writes attributes by name.
    fn put_layers(&mut self, group: &str, layers: &[AttributeLayer]) -> io::Result<()> {
        let mut taken = BTreeSet::new();
        for layer in layers {
            let name = layer.semantic.to_string();
            let mut path = node_name(&name);
            while !taken.insert(path.to_ascii_lowercase()) {
                path.push('_');
            }
            let attributes = json!({ "name": name, "normalized": layer.normalized });
            let rows = ZarrArray::rows(layer.data.clone(), layer.component_count.into());
            self.put(&format!("{group}/{path}"), &rows.with_attributes(attributes))?;
        }
        Ok(())
    }
}

/// A name that file systems and readers take; attributes have the true one.
fn node_name(name: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    let name: String = name.chars().take(100).map(|c| if is_plain(c) { c } else { '_' }).collect();
    if name.starts_with("__") || name.is_empty() { format!("x{name}") } else { name }
}

/// Remarks on data of a mesh that have no place in the store.
fn left_out(refinable: &RefinableMesh) -> Vec<String> {
    let appearance = &refinable.mesh.appearance;
    let mut names = Vec::new();
    if !appearance.materials.is_empty() {
        names.push("the materials");
    }
    if !appearance.images.is_empty() {
        names.push("the images of textures");
    }
    names.into_iter().map(|name| format!("left out: {name}; Zarr stores are arrays")).collect()
}
