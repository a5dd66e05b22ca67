//! Building the hierarchy: one pass from the full mesh to the base over a surface that knows its neighbors.

use striata::mesh::{RefinableMesh, is_proper};

use super::error::ViewDependentError;
use super::surface::Surface;
use super::{LEAF, NONE, ROOT, Triangle, VertexSplit, ViewDependentMeshes, bounds};

impl ViewDependentMeshes {
    /// Builds the model from a mesh and its sequence.
    ///
    /// # Errors
    /// [`ViewDependentError`] where the mesh has a seam, or the mesh or one of its levels is not manifold.
    ///
    /// # Panics
    /// If the mesh is not the sequence's: it names other vertices, or its groups do not tile it.
    pub fn build(refinable: &RefinableMesh) -> Result<Self, ViewDependentError> {
        let (sequence, mesh) = (&refinable.sequence, &refinable.mesh);
        check_numbers(refinable)?;
        let step_count = sequence.step_count();
        let base_vertex_count = sequence.base_vertex_count() as u32;
        let mut surface = Surface::new(mesh)?;
        let mut splits = vec![VertexSplit::default(); step_count];
        let mut taken_triangles = vec![[NONE; 2]; step_count];
        // The node at which each vertex stands as the hierarchy grows from its leaves.
        let mut nodes = vec![LEAF; sequence.positions().vertex_count()];
        let mut is_taken = vec![false; mesh.triangle_count()];
        for step in (0..step_count).rev() {
            let vertex = base_vertex_count + step as u32;
            let target = sequence.target(vertex);
            let taken = surface
                .collapse(step, vertex, target)
                .map_err(|reason| ViewDependentError::Step { step, vertex, target, reason })?;
            taken_triangles[step] = taken.triangles;
            taken.triangles.iter().filter(|&&t| t != NONE).for_each(|&t| is_taken[t as usize] = true);
            let children = [nodes[target as usize], nodes[vertex as usize]];
            for child in children.into_iter().filter(|&child| child != LEAF) {
                splits[child as usize].parent = step as u32;
            }
            splits[step] = VertexSplit { target, parent: ROOT, children, beside: taken.beside };
            nodes[target as usize] = step as u32;
        }
        let is_of_base = |&t: &usize| !is_taken[t] && is_proper(&mesh.triangles[t]);
        let base: Vec<usize> = (0..mesh.triangle_count()).filter(is_of_base).collect();
        let numbers = numbers(mesh.triangle_count(), &base, &taken_triangles);
        let number_of = |t: u32| if t == NONE { NONE } else { numbers[t as usize] };
        splits.iter_mut().for_each(|split| split.beside = split.beside.map(number_of));
        let base_triangle =
            |&t: &usize| Triangle { beside: surface.beside[t].map(number_of), number: numbers[t] };
        nodes.truncate(base_vertex_count as usize);
        Ok(Self {
            parts: bounds::parts(refinable),
            base_corners: base.iter().map(|&t| surface.corners[t]).collect(),
            base_triangles: base.iter().map(base_triangle).collect(),
            group_count: mesh.groups.len().max(1),
            groups: groups(refinable, &numbers, base.len() + 2 * step_count),
            roots: nodes,
            splits,
        })
    }
}

fn check_numbers(refinable: &RefinableMesh) -> Result<(), ViewDependentError> {
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

/// Numbers of the triangles of the mesh: those of the base first, then two for each step, of which a border leaves one
/// unused.
fn numbers(triangle_count: usize, base: &[usize], taken: &[[u32; 2]]) -> Vec<u32> {
    let mut numbers = vec![NONE; triangle_count];
    (0..).zip(base).for_each(|(number, &triangle)| numbers[triangle] = number);
    for (number, &triangle) in (base.len() as u32..).zip(taken.as_flattened()) {
        if triangle != NONE {
            numbers[triangle as usize] = number;
        }
    }
    numbers
}

/// The group of each triangle by its number; empty where there is one group.
fn groups(refinable: &RefinableMesh, numbers: &[u32], number_count: usize) -> Vec<u32> {
    if refinable.mesh.groups.len() <= 1 {
        return Vec::new();
    }
    let mut groups = vec![0; number_count];
    for (index, group) in (0..).zip(&refinable.mesh.groups) {
        for &number in numbers[group.range()].iter().filter(|&&number| number != NONE) {
            groups[number as usize] = index;
        }
    }
    groups
}
