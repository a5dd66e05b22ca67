//! The writer's data, in the numbering of a reader: implements the source of the refinement loop.

use std::ops::Range;

use striata::mesh::RefinableMesh;

use crate::base::coder::BaseOrder;
use crate::base::mesh::Base;
use crate::general::step::{CodedStep, NewTriangle, ReferenceStep, ReferenceTriangle};
use crate::layers::layer_neighborhood::LayerValues;
use crate::refine::source::{CodingObserver, EncoderInput, StreamSide};
use crate::topology::surface::{Cut, NONE, Surface, Undo, triangle_of};
use crate::writer::descent::{BatchRun, Descent};
use crate::writer::general_order::GeneralOrder;
use crate::writer::surface_stage::SurfaceStage;

/// Positions and attributes of the mesh to encode.
pub(crate) struct VertexData {
    /// Grid coordinates of each position.
    pub coords: Vec<[i32; 3]>,
    /// Exact coordinates of each position, in mesh units.
    pub exact: Vec<[f32; 3]>,
    /// Integers of all vertices, layer by layer.
    pub layers: Vec<LayerValues>,
}

/// A triangle of the reader, as a rotated triangle of the mesh.
#[derive(Clone, Copy, Debug)]
struct RotatedTriangle {
    /// Index of the mesh's triangle; [`NONE`] for virtual triangles.
    /// Corner of the reader's triangle that is the first corner of the mesh's triangle.
    triangle: u32,
    turn: u8,
}

impl RotatedTriangle {
    /// A virtual triangle.
    const VIRTUAL: Self = Self { triangle: NONE, turn: 0 };

    /// Returns the mesh's corner for a corner of the reader's triangle.
    fn slot(self, corner: u32) -> usize {
        (corner as usize + 3 - usize::from(self.turn)) % 3
    }

    /// Returns the reader's corner for a corner of the mesh's triangle.
    fn corner(self, slot: u32) -> u32 {
        (slot + u32::from(self.turn)) % 3
    }
}

/// The mesh and the steps to encode, in the numbering of a reader.
pub(crate) struct ReferenceMesh<'a> {
    descent: &'a Descent,
    /// The current stage; if it is a general one, the order of its remaining steps and the current step.
    stage: usize,
    general_order: GeneralOrder,
    current_step: u32,
    /// Split counts at which batches begin, followed by the number of steps.
    batches: &'a [u32],
    /// Number of batches begun so far.
    batch: usize,
    points: &'a VertexData,
    refinable: &'a RefinableMesh,
    /// For each triangle of the stage's surface, the reader's corner that is its first one.
    corners: Vec<u32>,
    /// The reader's vertex for each vertex of the stage's surface.
    vertices: Vec<u32>,
    /// Position of each of the reader's vertices.
    positions: Vec<u32>,
    /// For each of the reader's vertices, the step that splits it in this batch.
    step_at: Vec<u32>,
    /// Index of the next triangle of the reader's surface.
    next_triangle: u32,
    /// The triangles of the reader's surface, and those of its mesh.
    surface_triangles: Vec<RotatedTriangle>,
    mesh_triangles: Vec<RotatedTriangle>,
    /// For each triangle of the mesh, its index in `mesh_triangles`.
    index_of: Vec<u32>,
    /// Current vertices of the corners of each triangle of the mesh.
    shown: Vec<[u32; 3]>,
    /// Group of each triangle of the mesh.
    group_of: Vec<u32>,
    has_wedges: bool,
    /// Vertices and triangles of the first stage's surface that belong to the base, in the writer's order.
    base_vertices: Vec<u32>,
    base_triangles: Vec<u32>,
    /// The reader's index of each position.
    index_of_position: Vec<u32>,
    /// The stream's vertex for each vertex of the mesh, if it already has one.
    vertex_of: Vec<u32>,
    /// The mesh's vertex for each vertex of the stream so far.
    pub source_vertex: Vec<u32>,
    /// Positions of the base, in stream order.
    pub base_positions: Vec<u32>,
    /// Steps, in stream order.
    pub order: Vec<u32>,
}

/// Returns the base in the writer's order, and the data for encoding the steps above it.
pub(crate) fn base_of<'a>(
    descent: &'a Descent,
    batches: &'a [u32],
    points: &'a VertexData,
    refinable: &'a RefinableMesh,
) -> (Base, ReferenceMesh<'a>) {
    let base_position_count = refinable.sequence.base_position_count() as u32;
    let position_count = points.coords.len();
    let mut reference = ReferenceMesh {
        descent,
        stage: 0,
        general_order: GeneralOrder::default(),
        current_step: 0,
        batches,
        batch: 0,
        points,
        refinable,
        corners: Vec::new(),
        vertices: Vec::new(),
        positions: Vec::new(),
        step_at: Vec::new(),
        next_triangle: 0,
        surface_triangles: Vec::new(),
        mesh_triangles: Vec::new(),
        index_of: vec![NONE; refinable.mesh.triangle_count()],
        shown: descent.shown.clone(),
        group_of: groups_of_triangles(refinable),
        has_wedges: !refinable.sequence.positions().is_identity() || refinable.mesh.groups.len() > 1,
        base_vertices: Vec::new(),
        base_triangles: Vec::new(),
        index_of_position: vec![NONE; position_count],
        vertex_of: vec![NONE; refinable.mesh.vertex_count()],
        source_vertex: Vec::with_capacity(refinable.mesh.vertex_count()),
        base_positions: Vec::new(),
        order: Vec::with_capacity(refinable.sequence.step_count()),
    };
    let Some(BatchRun::Surface(stage)) = descent.stages.first() else { return (Base::default(), reference) };
    let surface = &stage.surface;
    let virtual_count = surface.virtual_count();
    let is_base = |copy: &u32| stage.position_of_copy[*copy as usize] < base_position_count;
    let copies: Vec<u32> = (0..stage.position_of_copy.len() as u32).filter(is_base).collect();
    let vertices = (0..virtual_count).chain(copies.iter().map(|copy| virtual_count + copy));
    reference.base_vertices = vertices.collect();
    reference.vertices = vec![NONE; surface.vertex_count()];
    (0..).zip(&reference.base_vertices).for_each(|(new, &fine)| reference.vertices[fine as usize] = new);
    reference.corners = vec![NONE; surface.triangle_count()];
    let (base_triangles, opposite) = base_triangles(surface, &stage.undo);
    reference.base_triangles = base_triangles;
    let corners_of = |t: &u32| surface.triangle(*t).map(|v| reference.vertices[v as usize]);
    let base = Base {
        virtual_count,
        position_of_copy: copies.iter().map(|&copy| stage.position_of_copy[copy as usize]).collect(),
        triangles: reference.base_triangles.iter().map(corners_of).collect(),
        opposite,
        grid_points: points.coords[..base_position_count as usize].to_vec(),
        ..Base::default()
    };
    (base, reference)
}

/// Returns the triangles that no step removes, and for each of them the corners across its three edges.
fn base_triangles(surface: &Surface, undo: &[Undo]) -> (Vec<u32>, Vec<u32>) {
    let mut number = vec![0; surface.triangle_count()];
    undo.iter().flat_map(|u| u.removed_corners).for_each(|corner| number[corner as usize / 4] = NONE);
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

/// Returns the group of each triangle of a mesh.
fn groups_of_triangles(refinable: &RefinableMesh) -> Vec<u32> {
    let groups = refinable.mesh.groups_or_whole();
    let of_group =
        |(g, group): (u32, &striata::mesh::TriangleGroup)| std::iter::repeat_n(g, group.count as usize);
    (0..).zip(groups.iter()).flat_map(of_group).collect()
}

/// Returns the corner `turn` positions further in the same triangle.
fn rotated(corner: u32, turn: u32) -> u32 {
    (corner & !3) | (((corner & 3) + turn) % 3)
}

impl<'a> ReferenceMesh<'a> {
    /// Whether all steps of the batches begun so far have been coded.
    pub(crate) fn is_batch_done(&self) -> bool {
        self.order.len() == self.batches[self.batch] as usize
    }

    /// Returns the current stage if it is a surface stage.
    fn surface_stage(&self) -> Option<&'a SurfaceStage> {
        match self.descent.stages.get(self.stage) {
            Some(BatchRun::Surface(stage)) => Some(stage),
            _ => None,
        }
    }

    /// Records that a triangle of the stage's surface is the next one of the reader's, in which its first
    /// corner is `turn`.
    fn push_triangle(&mut self, fine: u32, turn: u32) {
        self.corners[fine as usize] = 4 * self.next_triangle + turn;
        self.next_triangle += 1;
        let mesh_corner = self.surface_stage().and_then(|stage| stage.mesh_corner(4 * fine));
        let rotated = mesh_corner
            .map_or(RotatedTriangle::VIRTUAL, |(triangle, _)| RotatedTriangle { triangle, turn: turn as u8 });
        self.surface_triangles.push(rotated);
        if rotated.triangle != NONE {
            self.push_mesh_triangle(rotated);
        }
    }

    /// Appends a triangle to the reader's mesh.
    fn push_mesh_triangle(&mut self, rotated: RotatedTriangle) {
        self.index_of[rotated.triangle as usize] = self.mesh_triangles.len() as u32;
        self.mesh_triangles.push(rotated);
    }

    /// Gives a position the next index of the reader.
    fn push_position(&mut self, position: u32) {
        let base = self.refinable.sequence.base_position_count();
        self.index_of_position[position as usize] = (base + self.order.len()) as u32;
    }

    /// Returns the stream's vertex for a vertex of the mesh.
    fn stream_vertex(&self, vertex: u32) -> u32 {
        if self.has_wedges {
            return self.vertex_of.get(vertex as usize).copied().unwrap_or(NONE);
        }
        self.index_of_position.get(vertex as usize).copied().unwrap_or(NONE)
    }

    /// Returns the position of a vertex of the mesh.
    fn position_of(&self, vertex: u32) -> u32 {
        self.refinable.sequence.positions().position_of(vertex)
    }

    /// Returns the data for a triangle that a general step adds.
    fn reference_triangle(&self, triangle: u32, [position, target]: [u32; 2]) -> ReferenceTriangle {
        let vertices = self.shown[triangle as usize];
        let positions = vertices.map(|v| self.position_of(v));
        let at = |wanted: u32| positions.iter().position(|&p| p == wanted).unwrap_or(0);
        let (own, split) = (at(position), at(target));
        let third = 3 - own - split;
        let number = self.index_of_position[positions[third] as usize];
        ReferenceTriangle {
            triangle: NewTriangle { third: number, is_forward: split == (own + 1) % 3 },
            wedge: vertices[own],
            others: [split, third].map(|at| self.stream_vertex(vertices[at])),
            group: self.group_of[triangle as usize],
        }
    }

    /// Maps the stage's surface to a surface that the reader has rebuilt.
    fn map_surface(&mut self, stage: &SurfaceStage, surface: &Surface) {
        self.corners = vec![NONE; stage.surface.triangle_count()];
        self.vertices = vec![NONE; stage.surface.vertex_count()];
        self.positions = vec![NONE; surface.vertex_count()];
        self.step_at = vec![NONE; surface.vertex_count()];
        self.next_triangle = surface.triangle_count() as u32;
        self.surface_triangles.clone_from(&self.mesh_triangles);
        self.surface_triangles.resize(surface.triangle_count(), RotatedTriangle::VIRTUAL);
        for (fine, &triangle) in (0..).zip(&stage.triangles) {
            let number = self.index_of[triangle as usize];
            if number != NONE {
                let turn = u32::from(self.mesh_triangles[number as usize].turn);
                self.corners[fine as usize] = 4 * number + turn;
            }
        }
        let real_count = stage.triangles.len() as u32;
        for fine in
            (0..real_count).filter(|&fine| self.index_of[stage.triangles[fine as usize] as usize] != NONE)
        {
            for corner in 4 * fine..4 * fine + 3 {
                let here = rotated(self.corners[fine as usize], corner & 3);
                let vertex = surface.vertex(here);
                self.vertices[stage.surface.vertex(corner) as usize] = vertex;
                let copy = stage.surface.vertex(corner) - stage.surface.virtual_count();
                self.positions[vertex as usize] = stage.position_of_copy[copy as usize];
                let (across, across_here) = (stage.surface.opposite(corner), surface.opposite(here));
                if triangle_of(across) >= real_count {
                    let turn = (across_here & 3) + 3 - (across & 3);
                    self.corners[triangle_of(across) as usize] = rotated(across_here & !3, turn);
                    self.vertices[stage.surface.vertex(across) as usize] = surface.vertex(across_here);
                }
            }
        }
    }
}

impl StreamSide for ReferenceMesh<'_> {
    #[inline]
    fn input(&self) -> Option<&dyn EncoderInput> {
        Some(self)
    }

    #[inline]
    fn observer(&mut self) -> Option<&mut dyn CodingObserver> {
        Some(self)
    }
}

impl EncoderInput for ReferenceMesh<'_> {
    fn cut(&self, vertex: u32) -> Option<Cut> {
        let step = self.step_at[vertex as usize];
        let stage = self.surface_stage()?;
        let cut = stage.undo.get(step.checked_sub(stage.first_step)? as usize)?.cut;
        let first = rotated(self.corners[cut.first as usize / 4], cut.first & 3);
        Some(Cut { first, length: cut.length })
    }

    fn coords(&self, vertex: u32) -> [i32; 3] {
        self.points.coords[self.positions[vertex as usize] as usize]
    }

    fn exact(&self, vertex: u32) -> [f32; 3] {
        self.points.exact[self.positions[vertex as usize] as usize]
    }

    fn wedges(&self, vertex: u32) -> Range<u32> {
        self.refinable.sequence.positions().wedges(self.positions[vertex as usize])
    }

    fn wedge(&self, corner: u32) -> u32 {
        let rotated = self.surface_triangles[triangle_of(corner) as usize];
        let shown = self.shown.get(rotated.triangle as usize);
        shown.map_or(NONE, |shown| shown[rotated.slot(corner & 3)])
    }

    fn vertex_at(&self, corner: u32) -> u32 {
        self.vertex_of.get(self.wedge(corner) as usize).copied().unwrap_or(NONE)
    }

    fn target(&self, wedge: u32) -> u32 {
        self.vertex_of[self.refinable.sequence.target(wedge) as usize]
    }

    fn group(&self, triangle: u32) -> u32 {
        let rotated = self.surface_triangles[triangle as usize];
        self.group_of.get(rotated.triangle as usize).copied().unwrap_or(NONE)
    }

    fn layers(&self) -> &[LayerValues] {
        &self.points.layers
    }

    fn general_count(&self) -> u32 {
        match self.descent.stages.get(self.stage) {
            Some(BatchRun::General(stage)) => stage.steps.len() as u32,
            _ => 0,
        }
    }
}

impl CodingObserver for ReferenceMesh<'_> {
    fn order_base(&mut self, base: &Base, order: &BaseOrder) {
        for (new, &old) in order.vertices.iter().enumerate() {
            let fine = self.base_vertices[old as usize];
            self.vertices[fine as usize] = new as u32;
            let copy = (new as u32).checked_sub(base.virtual_count);
            let position = copy.map(|copy| order.positions[base.position_of_copy[copy as usize] as usize]);
            self.positions.push(position.unwrap_or(NONE));
            self.step_at.push(NONE);
        }
        (0..).zip(&order.positions).for_each(|(new, &p)| self.index_of_position[p as usize] = new);
        for &old in &order.corners {
            let fine = self.base_triangles[old as usize / 3];
            self.push_triangle(fine, (3 - old % 3) % 3);
        }
        self.base_positions.clone_from(&order.positions);
    }

    fn name_base(&mut self, vertex: u32) {
        let wedges: Vec<u32> = self.wedges(vertex).collect();
        self.name(&wedges);
    }

    fn name(&mut self, wedges: &[u32]) {
        for &wedge in wedges {
            self.vertex_of[wedge as usize] = self.source_vertex.len() as u32;
            self.source_vertex.push(wedge);
        }
    }

    fn begin_batch(&mut self) {
        self.batch += 1;
        let batch = self.batches[self.batch - 1]..self.batches[self.batch];
        if let Some(BatchRun::General(stage)) = self.descent.stages.get(self.stage + 1)
            && stage.begins(batch.start)
        {
            self.stage += 1;
            let number = |position: u32| self.index_of_position[position as usize];
            self.general_order = GeneralOrder::new(stage, self.shown.len(), number);
        }
        let Some(stage) = self.surface_stage() else { return };
        for step in batch {
            let undo = &stage.undo[(step - stage.first_step) as usize];
            self.step_at[self.vertices[undo.kept as usize] as usize] = step;
        }
    }

    fn split_applied(&mut self, vertex: u32, kept: u32) {
        let step = std::mem::replace(&mut self.step_at[kept as usize], NONE);
        let Some(stage) = self.surface_stage() else { return };
        let position = self.refinable.sequence.base_position_count() as u32 + step;
        let undo = &stage.undo[(step - stage.first_step) as usize];
        let fine = stage.surface.vertex(undo.removed_corners[0]);
        self.vertices[fine as usize] = vertex;
        self.positions.push(position);
        self.step_at.push(NONE);
        self.push_position(position);
        for corner in undo.removed_corners {
            // The new vertex is at the first corner of both new triangles.
            self.push_triangle(corner / 4, (3 - (corner & 3)) % 3);
        }
        self.order.push(step);
    }

    fn refine(&mut self, vertex: u32, corners: &[u32]) {
        let step = self.positions[vertex as usize] - self.refinable.sequence.base_position_count() as u32;
        let (Some(stage), [_, patch @ .., _]) = (self.surface_stage(), corners) else { return };
        for (&corner, &shown) in patch.iter().zip(stage.patch((step - stage.first_step) as usize)) {
            let rotated = self.surface_triangles[triangle_of(corner) as usize];
            if rotated.triangle != NONE {
                self.shown[rotated.triangle as usize][rotated.slot(corner & 3)] = shown;
            }
        }
    }

    fn general_step(&mut self) -> ReferenceStep {
        let Some(BatchRun::General(stage)) = self.descent.stages.get(self.stage) else {
            return ReferenceStep::default();
        };
        self.current_step = self.general_order.next().unwrap_or(0);
        let undo = stage.undo(self.current_step as usize);
        let base = self.refinable.sequence.base_position_count() as u32;
        let position = base + stage.steps[self.current_step as usize];
        for &(corner, shown) in stage.moved(undo) {
            self.shown[corner as usize / 3][corner as usize % 3] = shown;
        }
        let known_moved = |&(corner, shown): &(u32, u32)| {
            let number = self.index_of[corner as usize / 3];
            let rotated = self.mesh_triangles[number as usize];
            (3 * number + rotated.corner(corner % 3), shown)
        };
        let mut moved: Vec<(u32, u32)> = stage.moved(undo).iter().map(known_moved).collect();
        moved.sort_unstable();
        let wedges = self.refinable.sequence.positions().wedges(position);
        ReferenceStep {
            split: self.index_of_position[undo.target as usize],
            moved,
            new_triangles: stage
                .removed(undo)
                .iter()
                .map(|&t| self.reference_triangle(t, [position, undo.target]))
                .collect(),
            targets: wedges.clone().map(|w| self.stream_vertex(self.refinable.sequence.target(w))).collect(),
            wedges,
            grid_point: self.points.coords[position as usize],
            exact: self.points.exact[position as usize],
        }
    }

    fn general_step_applied(&mut self, step: &CodedStep) {
        let Some(BatchRun::General(stage)) = self.descent.stages.get(self.stage) else { return };
        let undo = stage.undo(self.current_step as usize);
        let index = stage.steps[self.current_step as usize];
        let position = self.refinable.sequence.base_position_count() as u32 + index;
        for &index_in_step in &step.reference_triangles {
            let triangle = stage.removed(undo)[index_in_step];
            let own = self.shown[triangle as usize].map(|v| self.position_of(v) == position);
            let slot = own.iter().position(|&is_own| is_own).unwrap_or(0);
            // The new position is at the first corner.
            self.push_mesh_triangle(RotatedTriangle { triangle, turn: ((3 - slot) % 3) as u8 });
        }
        self.push_position(position);
        self.order.push(index);
    }

    fn surface_rebuilt(&mut self, surface: &Surface) {
        self.stage += 1;
        if let Some(stage) = self.surface_stage() {
            self.map_surface(stage, surface);
        }
    }
}
