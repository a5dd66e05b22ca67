//! What the writer knows: the way down from the full mesh, seen with the reader's numbers.

use std::ops::Range;

use super::base::Base;
use super::base_coder::BaseOrder;
use super::cutting::Closed;
use super::layer_hood::LayerValues;
use super::refiner::Source;
use super::shown::ShownUp;
use super::surface::{Cut, NONE, Surface, Undo};
use crate::mesh::RefinableMesh;

/// Where the positions of the mesh are, and what its vertices have beside.
pub(super) struct Points {
    /// Grid coordinates.
    pub(super) places: Vec<[i32; 3]>,
    /// Mesh units.
    pub(super) exact: Vec<[f32; 3]>,
    /// Integers of all vertices, layer by layer.
    pub(super) layers: Vec<LayerValues>,
}

/// The steps of a sequence in the numbering of a surface under refinement.
pub(super) struct Truth<'a> {
    undo: &'a [Undo],
    /// Split counts at which batches begin, closed by the number of steps.
    batches: &'a [u32],
    points: &'a Points,
    batch: usize,
    base_position_count: u32,
    fine_virtual_count: u32,
    /// For each triangle of the full surface, the reader's corner for its first one.
    corners: Vec<u32>,
    /// The reader's vertex for each of the full surface.
    vertices: Vec<u32>,
    /// Position of each of the reader's vertices.
    positions: Vec<u32>,
    /// Vertices and triangles of the full surface that are in the base, as the writer numbers them.
    base_vertices: Vec<u32>,
    base_triangles: Vec<u32>,
    /// The step that splits each of the reader's vertices in this batch.
    step_at: Vec<u32>,
    next_triangle: u32,
    /// Wedges and groups, where the mesh has any to tell.
    shown: Option<ShownUp>,
    refinable: &'a RefinableMesh,
    /// The vertex of the stream for each of the mesh, where they are named.
    vertex_of: Vec<u32>,
    /// The vertex of the mesh for each of the stream, where they are named.
    pub(super) source_vertex: Vec<u32>,
    /// Positions of the base in the order of the stream.
    pub(super) base_positions: Vec<u32>,
    /// Steps in the order of the stream.
    pub(super) order: Vec<u32>,
}

/// The base of a collapsed surface as the writer numbers it, and what is needed to follow the steps from there.
pub(super) fn base_of<'a>(
    closed: &Closed,
    undo: &'a [Undo],
    batches: &'a [u32],
    (points, shown): (&'a Points, Option<ShownUp>),
    refinable: &'a RefinableMesh,
) -> (Base, Truth<'a>) {
    let surface = &closed.surface;
    let virtual_count = surface.virtual_count();
    let base_position_count = (points.places.len() - undo.len()) as u32;
    let is_base = |copy: &u32| closed.vertex_of_copy[*copy as usize] < base_position_count;
    let copies: Vec<u32> = (0..closed.vertex_of_copy.len() as u32).filter(is_base).collect();
    let base_vertices: Vec<u32> =
        (0..virtual_count).chain(copies.iter().map(|copy| virtual_count + copy)).collect();
    let mut vertices = vec![NONE; surface.vertex_count()];
    (0..).zip(&base_vertices).for_each(|(new, &fine)| vertices[fine as usize] = new);
    let (base_triangles, opposite) = base_triangles(surface, undo);
    let base = Base {
        virtual_count,
        position_of_copy: copies.iter().map(|&copy| closed.vertex_of_copy[copy as usize]).collect(),
        triangles: base_triangles
            .iter()
            .map(|&t| surface.triangle(t).map(|v| vertices[v as usize]))
            .collect(),
        opposite,
        places: points.places[..base_position_count as usize].to_vec(),
        ..Base::default()
    };
    let truth = Truth {
        undo,
        batches,
        points,
        batch: 0,
        base_position_count,
        fine_virtual_count: virtual_count,
        corners: vec![NONE; surface.triangle_count()],
        vertices,
        positions: Vec::new(),
        base_vertices,
        base_triangles,
        step_at: Vec::new(),
        next_triangle: 0,
        shown,
        refinable,
        vertex_of: vec![NONE; refinable.mesh.vertex_count()],
        source_vertex: Vec::with_capacity(refinable.mesh.vertex_count()),
        base_positions: Vec::new(),
        order: Vec::with_capacity(undo.len()),
    };
    (base, truth)
}

/// The triangles that no step takes away, and the corner across each of their edges, three a triangle.
fn base_triangles(surface: &Surface, undo: &[Undo]) -> (Vec<u32>, Vec<u32>) {
    let mut number = vec![0; surface.triangle_count()];
    undo.iter().flat_map(|u| u.gone).for_each(|corner| number[corner as usize / 4] = NONE);
    let mut triangles = Vec::new();
    for (t, number) in number.iter_mut().enumerate().filter(|(_, number)| **number != NONE) {
        *number = triangles.len() as u32;
        triangles.push(t as u32);
    }
    let across = |corner: u32| {
        let other = surface.opposite(corner);
        3 * number[other as usize / 4] + (other & 3)
    };
    let opposite = triangles.iter().flat_map(|&t| [4 * t, 4 * t + 1, 4 * t + 2].map(across)).collect();
    (triangles, opposite)
}

/// The corner `turn` places on in the same triangle.
fn turned(corner: u32, turn: u32) -> u32 {
    (corner & !3) | (((corner & 3) + turn) % 3)
}

impl Truth<'_> {
    /// True where all steps of the batches begun so far were coded.
    pub(super) fn is_settled(&self) -> bool {
        self.order.len() == self.batches[self.batch] as usize
    }
}

impl Source for Truth<'_> {
    fn order_base(&mut self, base: &Base, order: &BaseOrder) {
        for (new, &old) in order.vertices.iter().enumerate() {
            let fine = self.base_vertices[old as usize];
            self.vertices[fine as usize] = new as u32;
            let copy = (new as u32).checked_sub(base.virtual_count);
            let position = copy.map(|copy| order.positions[base.position_of_copy[copy as usize] as usize]);
            self.positions.push(position.unwrap_or(NONE));
            self.step_at.push(NONE);
        }
        for (new, &old) in order.corners.iter().enumerate() {
            let (fine, turn) = (self.base_triangles[old as usize / 3], (3 - old % 3) % 3);
            self.corners[fine as usize] = 4 * new as u32 + turn;
            if let Some(shown) = &mut self.shown {
                shown.push(fine, turn);
            }
        }
        self.next_triangle = order.corners.len() as u32;
        self.base_positions.clone_from(&order.positions);
    }

    fn begin_batch(&mut self) {
        for step in self.batches[self.batch]..self.batches[self.batch + 1] {
            let kept = self.vertices[self.undo[step as usize].kept as usize];
            self.step_at[kept as usize] = step;
        }
        self.batch += 1;
    }

    fn cut(&self, vertex: u32) -> Option<Cut> {
        let step = self.step_at[vertex as usize];
        let cut = self.undo.get(step as usize)?.cut;
        let first = turned(self.corners[cut.first as usize / 4], cut.first & 3);
        Some(Cut { first, length: cut.length })
    }

    fn born(&mut self, vertex: u32, kept: u32) {
        let step = std::mem::replace(&mut self.step_at[kept as usize], NONE);
        let position = self.base_position_count + step;
        self.vertices[(self.fine_virtual_count + position) as usize] = vertex;
        self.positions.push(position);
        self.step_at.push(NONE);
        for gone in self.undo[step as usize].gone {
            // The new vertex has the first corner of both new triangles.
            let turn = (3 - (gone & 3)) % 3;
            self.corners[gone as usize / 4] = 4 * self.next_triangle + turn;
            if let Some(shown) = &mut self.shown {
                shown.push(gone / 4, turn);
            }
            self.next_triangle += 1;
        }
        self.order.push(step);
    }

    fn layers(&self) -> &[LayerValues] {
        &self.points.layers
    }

    fn refine(&mut self, vertex: u32, corners: &[u32]) {
        let step = self.positions[vertex as usize] - self.base_position_count;
        if let (Some(shown), [_, patch @ .., _]) = (&mut self.shown, corners) {
            shown.refine(step, patch);
        }
    }

    fn vertex_at(&self, corner: u32) -> u32 {
        self.vertex_of.get(self.wedge(corner) as usize).copied().unwrap_or(NONE)
    }

    fn wedges(&self, vertex: u32) -> Range<u32> {
        self.refinable.sequence.positions().wedges(self.positions[vertex as usize])
    }

    fn target(&self, wedge: u32) -> u32 {
        self.vertex_of[self.refinable.sequence.target(wedge) as usize]
    }

    fn name(&mut self, wedges: impl IntoIterator<Item = u32>) {
        for wedge in wedges {
            self.vertex_of[wedge as usize] = self.source_vertex.len() as u32;
            self.source_vertex.push(wedge);
        }
    }

    fn wedge(&self, corner: u32) -> u32 {
        self.shown.as_ref().map_or(NONE, |shown| shown.wedge(corner))
    }

    fn group(&self, triangle: u32) -> u32 {
        self.shown.as_ref().map_or(0, |shown| shown.group(triangle))
    }

    fn place(&self, vertex: u32) -> [i32; 3] {
        self.points.places[self.positions[vertex as usize] as usize]
    }

    fn exact(&self, vertex: u32) -> [f32; 3] {
        self.points.exact[self.positions[vertex as usize] as usize]
    }
}
