//! What the writer knows: the way down from the full mesh, seen with the reader's numbers.

use super::base::Base;
use super::cutting::Closed;
use super::refiner::Source;
use super::shown::ShownUp;
use super::surface::{Cut, NONE, Undo};

/// Where the positions of the mesh are.
pub(super) struct Points {
    /// Grid coordinates.
    pub(super) places: Vec<[i32; 3]>,
    /// Mesh units.
    pub(super) exact: Vec<[f32; 3]>,
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
    /// The step that splits each of the reader's vertices in this batch.
    step_at: Vec<u32>,
    next_triangle: u32,
    /// Wedges and groups, where the mesh has any to tell.
    shown: Option<ShownUp>,
    /// Steps in the order of the stream.
    pub(super) order: Vec<u32>,
}

/// The base of a collapsed surface as both sides number it, and what is needed to follow the steps from there.
pub(super) fn base_of<'a>(
    closed: &Closed,
    undo: &'a [Undo],
    batches: &'a [u32],
    (points, mut shown): (&'a Points, Option<ShownUp>),
) -> (Base, Truth<'a>) {
    let surface = &closed.surface;
    let virtual_count = surface.virtual_count();
    let mut is_gone = vec![false; surface.triangle_count()];
    undo.iter().flat_map(|u| u.gone).for_each(|corner| is_gone[corner as usize / 4] = true);
    let base_position_count = (points.places.len() - undo.len()) as u32;
    let mut vertices = vec![NONE; surface.vertex_count()];
    let mut base = Base { virtual_count, ..Base::default() };
    (0..virtual_count).for_each(|v| vertices[v as usize] = v);
    let mut positions = vec![NONE; virtual_count as usize];
    for (copy, &position) in closed.vertex_of_copy.iter().enumerate() {
        if position < base_position_count {
            vertices[virtual_count as usize + copy] = positions.len() as u32;
            positions.push(position);
            base.position_of_copy.push(position);
        }
    }
    let mut corners = vec![NONE; surface.triangle_count()];
    for t in (0..surface.triangle_count()).filter(|&t| !is_gone[t]) {
        corners[t] = 4 * base.triangles.len() as u32;
        if let Some(shown) = &mut shown {
            shown.push(t as u32, 0);
        }
        base.triangles.push(surface.triangle(t as u32).map(|v| vertices[v as usize]));
    }
    base.places = points.places[..base_position_count as usize].to_vec();
    let truth = Truth {
        undo,
        batches,
        points,
        batch: 0,
        base_position_count,
        fine_virtual_count: virtual_count,
        corners,
        vertices,
        step_at: vec![NONE; positions.len()],
        positions,
        next_triangle: base.triangles.len() as u32,
        shown,
        order: Vec::with_capacity(undo.len()),
    };
    (base, truth)
}

/// The corner `turn` places on in the same triangle.
fn turned(corner: u32, turn: u32) -> u32 {
    (corner & !3) | ((corner & 3) + turn) % 3
}

impl Truth<'_> {
    /// True where all steps of the batches begun so far were coded.
    pub(super) fn is_settled(&self) -> bool {
        self.order.len() == self.batches[self.batch] as usize
    }
}

impl Source for Truth<'_> {
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

    fn refine(&mut self, vertex: u32, corners: &[u32]) {
        let step = self.positions[vertex as usize] - self.base_position_count;
        if let (Some(shown), [_, patch @ .., _]) = (&mut self.shown, corners) {
            shown.refine(step, patch);
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
