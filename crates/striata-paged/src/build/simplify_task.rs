//! The task of a level: simplifies cells, and sends the remaining triangles to the cells of the next level.

use std::collections::BTreeMap;

use striata::mesh::AttributeLayer;
use striata::simplify::cells::{Cell, CellMesh, CellSteps, simplify_cell};

use super::part_file::{PartIndex, PartWriter};
use super::plan::{BuildTask, PagedPlan};
use super::sort_task::{send, write_cells};
use super::wire::{PendingPage, WireReader, WireWriter};
use super::{BuildInput, PagedBuildError};
use crate::{Import, Page, PageId};

/// Runs a task of a level; `parts` has the triangles of all earlier stages.
pub(super) fn run(
    plan: &PagedPlan,
    task: &BuildTask,
    level: u8,
    parts: &PartIndex,
) -> Result<(), PagedBuildError> {
    let partition = plan.partition()?;
    let is_last = level + 1 == plan.level_count();
    let is_terrain = matches!(plan.input, BuildInput::Terrain(_)) || plan.metadata.georeference.is_some();
    let options = plan.options.cell_options(&plan.metadata, is_terrain, is_last);
    let like = plan.metadata.empty_mesh();
    let mut left = CellMesh::default();
    let mut writer = PartWriter::create(&plan.steps_path(level, task.first))?;
    for cell in task.first..task.first + task.count {
        let id = PageId { level, cell: cell as u32 };
        let cell = read_cell(parts, id, &like)?;
        let simplified =
            simplify_cell(&cell, &options).map_err(|source| PagedBuildError::Simplify { id, source })?;
        left.append(&simplified.survivors);
        if !simplified.steps.keys.is_empty() {
            let mut bytes = WireWriter::new(&like);
            bytes.steps(&pending_page(id, simplified.steps));
            writer.write(id, &bytes.bytes)?;
        }
    }
    writer.finish()?;
    let mut writer = PartWriter::create(&plan.triangles_path(task))?;
    write_cells(&mut writer, &send(partition, level + 1, left), &like)?;
    writer.finish()
}

/// Reads everything that was sent to a cell.
fn read_cell(parts: &PartIndex, id: PageId, like: &CellMesh) -> Result<Cell, PagedBuildError> {
    let mut whole = Cell::default();
    for (part, segment) in parts.find(id) {
        let bytes = part.read(segment)?;
        let cell = WireReader::new(&bytes, like).cell().map_err(|error| part.named(error))?;
        whole.inside.append(&cell.inside);
        whole.border.append(&cell.border);
        whole.is_within.extend(cell.is_within);
    }
    Ok(whole)
}

/// A page of steps, in the order in which it will be stored.
fn pending_page(id: PageId, steps: CellSteps) -> PendingPage {
    let owned = steps.targets.len();
    let order: Vec<u32> = (0..owned as u32).collect();
    let mut page = Page {
        id,
        positions: steps.positions[..owned].to_vec(),
        layers: steps.layers.iter().map(|layer| layer.gather(&order)).collect(),
        first: steps.first,
        targets: steps.targets,
        keys: steps.keys,
        errors: steps.errors,
        imports: (0..(steps.positions.len() - owned) as u32)
            .map(|vertex| Import { page: 0, vertex })
            .collect(),
        triangles: steps.triangles,
        groups: steps.groups,
        triangle_layers: steps.triangle_layers,
    };
    page.normalize();
    let others: Vec<u32> = page.imports.iter().map(|import| import.vertex + owned as u32).collect();
    PendingPage {
        page,
        others: others.iter().map(|&v| steps.positions[v as usize]).collect(),
        other_layers: steps.layers.iter().map(|layer| layer.gather(&others)).collect(),
    }
}

/// The base page: the triangles that remain after all levels.
pub(super) fn base_page(plan: &PagedPlan, parts: &PartIndex) -> Result<PendingPage, PagedBuildError> {
    let id = PageId { level: plan.level_count(), cell: 0 };
    let like = plan.metadata.empty_mesh();
    let mut mesh = read_cell(parts, id, &like)?.inside;
    if mesh.triangles.is_empty() {
        // Nothing was sent to the base.
        mesh.triangle_layers.clone_from(&like.triangle_layers);
    }
    let value = |v: u32| {
        let layer_bytes = |layer: &AttributeLayer| {
            let n = layer.vertex_bytes();
            layer.data.as_bytes()[v as usize * n..][..n].to_vec()
        };
        let bits = mesh.positions[v as usize].map(f32::to_bits);
        (bits, mesh.layers.iter().flat_map(layer_bytes).collect::<Vec<u8>>())
    };
    let mut by_value: BTreeMap<_, Vec<u32>> = BTreeMap::new();
    for v in 0..mesh.positions.len() as u32 {
        by_value.entry(value(v)).or_default().push(v);
    }
    let mut number = vec![0; mesh.positions.len()];
    let (mut order, mut first, mut last) = (Vec::new(), Vec::new(), None);
    for ((position, _), vertices) in by_value {
        if last != Some(position) {
            first.push(order.len() as u32);
            last = Some(position);
        }
        vertices.iter().for_each(|&v| number[v as usize] = order.len() as u32);
        order.push(vertices[0]);
    }
    first.push(order.len() as u32);
    let mut page = Page {
        id,
        positions: order.iter().map(|&v| mesh.positions[v as usize]).collect(),
        layers: mesh.layers.iter().map(|layer| layer.gather(&order)).collect(),
        first,
        targets: Vec::new(),
        keys: Vec::new(),
        errors: Vec::new(),
        imports: Vec::new(),
        triangles: mesh.triangles.iter().map(|t| t.map(|v| number[v as usize])).collect(),
        groups: mesh.groups,
        triangle_layers: mesh.triangle_layers,
    };
    page.normalize();
    Ok(PendingPage { page, others: Vec::new(), other_layers: like.layers })
}
