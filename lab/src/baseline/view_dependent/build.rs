//! Builds the hierarchy in one pass from the full mesh to the base, over a surface with adjacency.

use striata::mesh::{RefinableMesh, is_proper};

use super::error::ViewDependentError;
use super::surface::ShrinkingSurface;
use super::{LEAF, NONE, ROOT, Triangle, VertexSplit, ViewDependentMeshes, bounds};

impl ViewDependentMeshes {
    /// Builds the model from a mesh and its sequence.
    ///
    /// # Errors
    /// [`ViewDependentError`] if the mesh has a seam, or if the mesh or one of its levels is not manifold.
    ///
    /// # Panics
    /// If the mesh does not match the sequence: it refers to other vertices, or its groups do not tile it.
    pub fn build(refinable: &RefinableMesh) -> Result<Self, ViewDependentError> {
        let (sequence, mesh) = (&refinable.sequence, &refinable.mesh);
        check_representable(refinable)?;
        let step_count = sequence.step_count();
        let base_vertex_count = sequence.base_vertex_count() as u32;
        let mut surface = ShrinkingSurface::new(mesh)?;
        let mut splits = vec![VertexSplit::default(); step_count];
        let mut removed_triangles = vec![[NONE; 2]; step_count];
        // The root of each vertex's subtree, while the hierarchy grows from its leaves.
        let mut nodes = vec![LEAF; sequence.positions().vertex_count()];
        let mut is_removed = vec![false; mesh.triangle_count()];
        for step in (0..step_count).rev() {
            let vertex = base_vertex_count + step as u32;
            let target = sequence.target(vertex);
            let removed = surface
                .collapse(step, vertex, target)
                .map_err(|reason| ViewDependentError::Step { step, vertex, target, reason })?;
            removed_triangles[step] = removed.triangles;
            removed.triangles.iter().filter(|&&t| t != NONE).for_each(|&t| is_removed[t as usize] = true);
            let children = [nodes[target as usize], nodes[vertex as usize]];
            for child in children.into_iter().filter(|&child| child != LEAF) {
                splits[child as usize].parent = step as u32;
            }
            splits[step] = VertexSplit { target, parent: ROOT, children, neighbors: removed.neighbors };
            nodes[target as usize] = step as u32;
        }
        let is_in_base = |&t: &usize| !is_removed[t] && is_proper(&mesh.triangles[t]);
        let base: Vec<usize> = (0..mesh.triangle_count()).filter(is_in_base).collect();
        let indices = indices(mesh.triangle_count(), &base, &removed_triangles);
        let index_of = |t: u32| if t == NONE { NONE } else { indices[t as usize] };
        splits.iter_mut().for_each(|split| split.neighbors = split.neighbors.map(index_of));
        let base_triangle =
            |&t: &usize| Triangle { neighbors: surface.neighbors[t].map(index_of), index: indices[t] };
        nodes.truncate(base_vertex_count as usize);
        Ok(Self {
            parts: bounds::parts(refinable),
            positions: mesh.positions.clone(),
            base_corners: base.iter().map(|&t| surface.corners[t]).collect(),
            base_triangles: base.iter().map(base_triangle).collect(),
            group_count: mesh.groups.len().max(1),
            groups: groups(refinable, &indices, base.len() + 2 * step_count),
            roots: nodes,
            splits,
        })
    }
}

fn check_representable(refinable: &RefinableMesh) -> Result<(), ViewDependentError> {
    let positions = refinable.sequence.positions();
    if !positions.is_identity() {
        let has_seam = |&position: &u32| positions.wedges(position).len() != 1;
        if let Some(position) = (0..positions.position_count() as u32).find(has_seam) {
            let vertex_count = positions.wedges(position).len();
            return Err(ViewDependentError::Seam { position: position as usize, vertex_count });
        }
    }
    let triangle_count = refinable.mesh.triangle_count() + 2 * refinable.sequence.step_count();
    if triangle_count >= NONE as usize {
        return Err(ViewDependentError::TooMany { triangle_count });
    }
    Ok(())
}

/// Indices of the mesh's triangles in the model: those of the base first, then two per step, of which one
/// is unused at a border.
fn indices(triangle_count: usize, base: &[usize], removed: &[[u32; 2]]) -> Vec<u32> {
    let mut indices = vec![NONE; triangle_count];
    (0..).zip(base).for_each(|(index, &triangle)| indices[triangle] = index);
    for (index, &triangle) in (base.len() as u32..).zip(removed.as_flattened()) {
        if triangle != NONE {
            indices[triangle as usize] = index;
        }
    }
    indices
}

/// The group of each triangle by index; empty if there is only one group.
fn groups(refinable: &RefinableMesh, indices: &[u32], index_count: usize) -> Vec<u32> {
    if refinable.mesh.groups.len() <= 1 {
        return Vec::new();
    }
    let mut groups = vec![0; index_count];
    for (group_index, group) in (0..).zip(&refinable.mesh.groups) {
        for &index in indices[group.range()].iter().filter(|&&index| index != NONE) {
            groups[index as usize] = group_index;
        }
    }
    groups
}
