//! Renumbers the mesh in refinement order and builds the sequence from the recorded collapses.

use crate::mesh::{CollapseSequence, PositionIndex, RefinableMesh, SequenceError, SequenceParts, Welded};

/// Cost that orders a step of a cell, and the distance that the step adds to the error.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::simplify) struct StepCost {
    /// Cost at which the step left the queue, scaled units.
    pub cost: f32,
    /// Distance of the surface before the step from the one after it, scaled units, squared.
    pub distance_squared: f32,
}

/// Everything recorded during the collapses, in the numbering of the welded mesh and in order of removal.
#[derive(Debug, Default)]
pub(in crate::simplify) struct CollapseRecord {
    /// Removed positions.
    pub removed: Vec<u32>,
    /// Error of the mesh after each removal, mesh units, never decreasing.
    pub errors: Vec<f32>,
    /// Number of triangles that each removal removes.
    pub removed_triangle_counts: Vec<u8>,
    /// Cost of each removal; empty unless the mesh is a cell.
    pub costs: Vec<StepCost>,
    /// Target vertex of every vertex of a removed position; other entries are unused.
    pub targets: Vec<u32>,
}

impl CollapseRecord {
    /// Drops the steps of a cell that are not kept.
    pub(in crate::simplify) fn retain(&mut self, is_kept: &[bool]) {
        fn retain<T>(rows: &mut Vec<T>, is_kept: &[bool]) {
            let mut is_kept = is_kept.iter();
            rows.retain(|_| is_kept.next().is_some_and(|&is_kept| is_kept));
        }
        retain(&mut self.removed, is_kept);
        retain(&mut self.errors, is_kept);
        retain(&mut self.removed_triangle_counts, is_kept);
        retain(&mut self.costs, is_kept);
    }
}

/// Numbering of a welded mesh's vertices for a given order of removed positions.
pub(in crate::simplify) struct RefinementOrder {
    pub base_position_count: usize,
    /// First new vertex of every position in refinement order, followed by the vertex count.
    pub first: Vec<u32>,
    /// Old index of each new vertex.
    pub vertex_order: Vec<u32>,
    /// New index of each old vertex.
    pub new_index: Vec<u32>,
}

impl RefinementOrder {
    pub(in crate::simplify) fn new(old: &PositionIndex, removed: &[u32]) -> Self {
        let position_count = old.position_count();
        let mut is_removed = vec![false; position_count];
        for &p in removed {
            is_removed[p as usize] = true;
        }
        let base = (0..position_count as u32).filter(|&p| !is_removed[p as usize]);
        let mut vertex_order = Vec::with_capacity(old.vertex_count());
        let mut first = Vec::with_capacity(position_count + 1);
        for p in base.chain(removed.iter().rev().copied()) {
            first.push(vertex_order.len() as u32);
            vertex_order.extend(old.wedges(p));
        }
        first.push(vertex_order.len() as u32);
        let mut new_index = vec![0u32; vertex_order.len()];
        for (new, &v) in vertex_order.iter().enumerate() {
            new_index[v as usize] = new as u32;
        }
        Self { base_position_count: position_count - removed.len(), first, vertex_order, new_index }
    }
}

/// Renumbers the mesh so that every level uses a prefix of its vertices; also returns the source of
/// each vertex.
pub(in crate::simplify) fn build_refinable(
    welded: Welded,
    record: CollapseRecord,
) -> Result<(RefinableMesh, Vec<u32>), SequenceError> {
    let order = RefinementOrder::new(&welded.positions, &record.removed);
    let RefinementOrder { base_position_count, first, vertex_order, new_index } = order;
    let base_vertex_count = first[base_position_count] as usize;
    let target = |&v: &u32| new_index[record.targets[v as usize] as usize];
    let targets = vertex_order[base_vertex_count..].iter().map(target).collect();
    let source_vertex = vertex_order.iter().map(|&v| welded.source_vertex[v as usize]).collect();
    let mesh = welded.mesh.gather(&vertex_order, &new_index);
    let sequence = CollapseSequence::from_parts(SequenceParts {
        positions: PositionIndex::from_first(first),
        base_position_count,
        targets,
        errors: record.errors.into_iter().rev().collect(),
        removed_triangle_counts: record.removed_triangle_counts.into_iter().rev().collect(),
        triangle_count: mesh.triangle_count(),
    })?;
    Ok((RefinableMesh { mesh, sequence }, source_vertex))
}
