//! The sort task: reads pieces, rounds them, and sends their triangles to the cells of the first level.

use std::collections::BTreeMap;

use striata::simplify::cells::{Cell, CellMesh, Partition, route};
use striata_io::pieces::{Piece, PieceSource};

use super::PagedBuildError;
use super::part_file::PartWriter;
use super::plan::{BuildTask, PagedPlan};
use super::wire::WireWriter;
use crate::{Metadata, PageId};

/// Runs a task of the first stage.
pub(super) fn run(
    plan: &PagedPlan,
    task: &BuildTask,
    source: &dyn PieceSource,
) -> Result<(), PagedBuildError> {
    let (mut mesh, mut merging) = (CellMesh::default(), Merging::default());
    for index in task.first..task.first + task.count {
        let mut piece = source.read_piece(index)?;
        if plan.options.weld_distance.is_some() {
            piece.positions.iter_mut().for_each(|position| *position = plan.weld().get(*position));
        }
        mesh.append(&rounded(piece, &plan.metadata, &mut merging));
    }
    merging.check(plan)?;
    let mut writer = PartWriter::create(&plan.triangles_path(task))?;
    write_cells(&mut writer, &send(plan.partition()?, 0, mesh), &plan.metadata.empty_mesh())?;
    writer.finish()
}

/// Vertices that rounding merges.
#[derive(Default)]
struct Merging {
    /// Number of different positions before.
    total: u64,
    merged: u64,
}

impl Merging {
    /// Counts the vertices of a piece that rounding merged. Positions are only compared if a triangle became
    /// degenerate, because the comparison is slow.
    fn add(&mut self, before: &[[f32; 3]], mesh: &CellMesh) {
        let is_flat = |positions: &[[f32; 3]], t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| positions[v as usize]);
            a == b || b == c || c == a
        };
        let shrank = |t: &[u32; 3]| is_flat(&mesh.positions, t) && !is_flat(before, t);
        if !mesh.triangles.iter().any(shrank) {
            self.total += before.len() as u64;
            return;
        }
        let total = distinct(before);
        self.total += total;
        self.merged += total.saturating_sub(distinct(&mesh.positions));
    }

    /// Refuses to merge more than one vertex in a thousand, unless the options allow it.
    fn check(&self, plan: &PagedPlan) -> Result<(), PagedBuildError> {
        let is_wanted = plan.options.allow_merging;
        let Some(grid) = plan.metadata.grid.filter(|_| !is_wanted && self.merged * 1000 > self.total) else {
            return Ok(());
        };
        let (input, step) = (plan.metadata.source.clone(), grid.step.into_iter().fold(f64::MAX, f64::min));
        Err(PagedBuildError::Merging { input, step, merged: self.merged, total: self.total })
    }
}

/// Number of different positions.
fn distinct(positions: &[[f32; 3]]) -> u64 {
    let key = |p: &[f32; 3]| p.map(|x| (x + 0.0).to_bits());
    let mut keys: Vec<[u32; 3]> = positions.iter().map(key).collect();
    keys.sort_unstable();
    keys.dedup();
    keys.len() as u64
}

/// Rounds a piece as the metadata say, and drops triangles that are degenerate afterwards.
fn rounded(piece: Piece, metadata: &Metadata, merging: &mut Merging) -> CellMesh {
    let mut mesh = CellMesh {
        positions: piece.positions,
        layers: piece.layers,
        triangles: piece.triangles,
        groups: piece.groups,
        triangle_layers: piece.triangle_layers,
        ..CellMesh::default()
    };
    let before = if metadata.grid.is_some() { mesh.positions.clone() } else { Vec::new() };
    for position in &mut mesh.positions {
        // Adding zero turns -0 into 0.
        *position = metadata.grid.as_ref().map_or(*position, |grid| grid.snap(*position)).map(|x| x + 0.0);
    }
    if metadata.grid.is_some() {
        merging.add(&before, &mesh);
    }
    metadata.add_material_layer(&mut mesh);
    for (layer, kind) in mesh.layers.iter_mut().zip(&metadata.layers) {
        kind.round(layer);
    }
    let is_proper = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|v| mesh.positions[v as usize]);
        a != b && b != c && c != a
    };
    let proper: Vec<u32> = (0..).zip(&mesh.triangles).filter(|(_, t)| is_proper(t)).map(|(t, _)| t).collect();
    mesh.select(&proper, &[]).0
}

/// Sends triangles to the cells of a level. Triangles at the borders of cells are also sent to the next level, and
/// so on; triangles that no level changes belong to the base.
pub(super) fn send(partition: &Partition, level: u8, mesh: CellMesh) -> BTreeMap<PageId, Cell> {
    let mut cells = BTreeMap::new();
    let mut mesh = mesh;
    for (k, cells_of_level) in partition.levels().iter().enumerate().skip(level as usize) {
        let routed = route(cells_of_level, &mesh);
        let named = routed.cells.into_iter().map(|(cell, part)| (PageId { level: k as u8, cell }, part));
        cells.extend(named);
        mesh = routed.onward;
    }
    if !mesh.positions.is_empty() {
        let id = PageId { level: partition.levels().len() as u8, cell: 0 };
        cells.insert(id, Cell { inside: mesh, ..Cell::default() });
    }
    cells
}

/// Writes the triangles that each cell receives.
pub(super) fn write_cells(
    writer: &mut PartWriter,
    cells: &BTreeMap<PageId, Cell>,
    like: &CellMesh,
) -> Result<(), PagedBuildError> {
    for (&id, cell) in cells {
        let mut bytes = WireWriter::new(like);
        bytes.cell(cell);
        writer.write(id, &bytes.bytes)?;
    }
    Ok(())
}
