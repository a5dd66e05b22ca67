//! What the writer knows: the way down from the full mesh, seen with the reader's numbers.

use std::ops::Range;

use striata::mesh::RefinableMesh;

use crate::base::coder::BaseOrder;
use crate::base::mesh::Base;
use crate::general::step::{Born, CodedStep, KnownBorn, KnownStep};
use crate::layers::layer_neighborhood::LayerValues;
use crate::refine::source::{CodingObserver, Plan, Source};
use crate::topology::surface::{Cut, NONE, Surface, Undo, triangle_of};
use crate::writer::descent::{Descent, Stage};
use crate::writer::general_order::GeneralOrder;
use crate::writer::surface_stage::SurfaceStage;

/// Where the positions of the mesh are, and what its vertices have beside.
pub(crate) struct Points {
    /// Grid coordinates.
    pub(crate) places: Vec<[i32; 3]>,
    /// Mesh units.
    pub(crate) exact: Vec<[f32; 3]>,
    /// Integers of all vertices, layer by layer.
    pub(crate) layers: Vec<LayerValues>,
}

/// A triangle of the reader: which of the mesh it is, and the corner there that the mesh's first corner is here.
#[derive(Clone, Copy, Debug)]
struct Turned {
    /// None for virtual ones.
    triangle: u32,
    turn: u8,
}

impl Turned {
    const VIRTUAL: Self = Self { triangle: NONE, turn: 0 };

    /// The corner of the mesh's triangle that a corner is here.
    fn slot(self, corner: u32) -> usize {
        (corner as usize + 3 - usize::from(self.turn)) % 3
    }

    /// The corner here that a corner of the mesh's triangle is.
    fn corner(self, slot: u32) -> u32 {
        (slot + u32::from(self.turn)) % 3
    }
}

/// The steps of a sequence in the numbering of a reader.
pub(crate) struct Truth<'a> {
    descent: &'a Descent,
    /// The stage that is under way; of a general one, what is left of it and the step that is told.
    stage: usize,
    general_order: GeneralOrder,
    told: u32,
    /// Split counts at which batches begin, closed by the number of steps.
    batches: &'a [u32],
    batch: usize,
    points: &'a Points,
    refinable: &'a RefinableMesh,
    /// For each triangle of the stage's surface, the reader's corner for its first one.
    corners: Vec<u32>,
    /// The reader's vertex for each of the stage's surface.
    vertices: Vec<u32>,
    /// Position of each of the reader's vertices.
    positions: Vec<u32>,
    /// The step that splits each of the reader's vertices in this batch.
    step_at: Vec<u32>,
    next_triangle: u32,
    /// The reader's triangles: those of its surface, and those of its mesh.
    surface_triangles: Vec<Turned>,
    mesh_triangles: Vec<Turned>,
    /// The number among the latter of each triangle of the mesh.
    number_of: Vec<u32>,
    /// What the corners of each triangle of the mesh show at present.
    shown: Vec<[u32; 3]>,
    group_of: Vec<u32>,
    has_wedges: bool,
    /// Vertices and triangles of the first stage's surface that are in the base, as the writer numbers them.
    base_vertices: Vec<u32>,
    base_triangles: Vec<u32>,
    /// The reader's number of each position, and the position of each of the reader's.
    number_of_position: Vec<u32>,
    /// The vertex of the stream for each of the mesh, where they are named.
    vertex_of: Vec<u32>,
    /// The vertex of the mesh for each of the stream, where they are named.
    pub(crate) source_vertex: Vec<u32>,
    /// Positions of the base in the order of the stream.
    pub(crate) base_positions: Vec<u32>,
    /// Steps in the order of the stream.
    pub(crate) order: Vec<u32>,
}

/// The base as the writer numbers it, and what is needed to follow the steps from there.
pub(crate) fn base_of<'a>(
    descent: &'a Descent,
    batches: &'a [u32],
    points: &'a Points,
    refinable: &'a RefinableMesh,
) -> (Base, Truth<'a>) {
    let base_position_count = refinable.sequence.base_position_count() as u32;
    let position_count = points.places.len();
    let mut truth = Truth {
        descent,
        stage: 0,
        general_order: GeneralOrder::default(),
        told: 0,
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
        number_of: vec![NONE; refinable.mesh.triangle_count()],
        shown: descent.shown.clone(),
        group_of: groups_of_triangles(refinable),
        has_wedges: !refinable.sequence.positions().is_identity() || refinable.mesh.groups.len() > 1,
        base_vertices: Vec::new(),
        base_triangles: Vec::new(),
        number_of_position: vec![NONE; position_count],
        vertex_of: vec![NONE; refinable.mesh.vertex_count()],
        source_vertex: Vec::with_capacity(refinable.mesh.vertex_count()),
        base_positions: Vec::new(),
        order: Vec::with_capacity(refinable.sequence.step_count()),
    };
    let Some(Stage::Surface(stage)) = descent.stages.first() else { return (Base::default(), truth) };
    let surface = &stage.surface;
    let virtual_count = surface.virtual_count();
    let is_base = |copy: &u32| stage.position_of_copy[*copy as usize] < base_position_count;
    let copies: Vec<u32> = (0..stage.position_of_copy.len() as u32).filter(is_base).collect();
    let vertices = (0..virtual_count).chain(copies.iter().map(|copy| virtual_count + copy));
    truth.base_vertices = vertices.collect();
    truth.vertices = vec![NONE; surface.vertex_count()];
    (0..).zip(&truth.base_vertices).for_each(|(new, &fine)| truth.vertices[fine as usize] = new);
    truth.corners = vec![NONE; surface.triangle_count()];
    let (base_triangles, opposite) = base_triangles(surface, &stage.undo);
    truth.base_triangles = base_triangles;
    let corners_of = |t: &u32| surface.triangle(*t).map(|v| truth.vertices[v as usize]);
    let base = Base {
        virtual_count,
        position_of_copy: copies.iter().map(|&copy| stage.position_of_copy[copy as usize]).collect(),
        triangles: truth.base_triangles.iter().map(corners_of).collect(),
        opposite,
        places: points.places[..base_position_count as usize].to_vec(),
        ..Base::default()
    };
    (base, truth)
}

/// The triangles that no step takes away, and the corner across each of their edges, three a triangle.
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

/// The group of each triangle of a mesh.
fn groups_of_triangles(refinable: &RefinableMesh) -> Vec<u32> {
    let groups = refinable.mesh.groups_or_whole();
    let of_group =
        |(g, group): (u32, &striata::mesh::TriangleGroup)| std::iter::repeat_n(g, group.count as usize);
    (0..).zip(groups.iter()).flat_map(of_group).collect()
}

/// The corner `turn` places on in the same triangle.
fn turned(corner: u32, turn: u32) -> u32 {
    (corner & !3) | (((corner & 3) + turn) % 3)
}

impl<'a> Truth<'a> {
    /// True where all steps of the batches begun so far were coded.
    pub(crate) fn is_settled(&self) -> bool {
        self.order.len() == self.batches[self.batch] as usize
    }

    fn surface_stage(&self) -> Option<&'a SurfaceStage> {
        match self.descent.stages.get(self.stage) {
            Some(Stage::Surface(stage)) => Some(stage),
            _ => None,
        }
    }

    /// A triangle of the stage's surface comes next in the reader's, its first corner being `turn` there.
    fn push_triangle(&mut self, fine: u32, turn: u32) {
        self.corners[fine as usize] = 4 * self.next_triangle + turn;
        self.next_triangle += 1;
        let mesh_corner = self.surface_stage().and_then(|stage| stage.mesh_corner(4 * fine));
        let turned =
            mesh_corner.map_or(Turned::VIRTUAL, |(triangle, _)| Turned { triangle, turn: turn as u8 });
        self.surface_triangles.push(turned);
        if turned.triangle != NONE {
            self.push_mesh_triangle(turned);
        }
    }

    fn push_mesh_triangle(&mut self, turned: Turned) {
        self.number_of[turned.triangle as usize] = self.mesh_triangles.len() as u32;
        self.mesh_triangles.push(turned);
    }

    fn push_position(&mut self, position: u32) {
        let base = self.refinable.sequence.base_position_count();
        self.number_of_position[position as usize] = (base + self.order.len()) as u32;
    }

    /// The vertex of the stream that a vertex of the mesh is.
    fn stream_vertex(&self, vertex: u32) -> u32 {
        if self.has_wedges {
            return self.vertex_of.get(vertex as usize).copied().unwrap_or(NONE);
        }
        self.number_of_position.get(vertex as usize).copied().unwrap_or(NONE)
    }

    fn position_of(&self, vertex: u32) -> u32 {
        self.refinable.sequence.positions().position_of(vertex)
    }

    /// The mesh's triangles that a general step brings.
    fn known_born(&self, triangle: u32, [position, target]: [u32; 2]) -> KnownBorn {
        let vertices = self.shown[triangle as usize];
        let positions = vertices.map(|v| self.position_of(v));
        let at = |wanted: u32| positions.iter().position(|&p| p == wanted).unwrap_or(0);
        let (own, split) = (at(position), at(target));
        let third = 3 - own - split;
        let number = self.number_of_position[positions[third] as usize];
        KnownBorn {
            born: Born { third: number, is_forward: split == (own + 1) % 3 },
            own: vertices[own],
            others: [split, third].map(|at| self.stream_vertex(vertices[at])),
            group: self.group_of[triangle as usize],
        }
    }

    /// Finds what the stage's surface is called in a surface that was built anew.
    fn rename(&mut self, stage: &SurfaceStage, surface: &Surface) {
        self.corners = vec![NONE; stage.surface.triangle_count()];
        self.vertices = vec![NONE; stage.surface.vertex_count()];
        self.positions = vec![NONE; surface.vertex_count()];
        self.step_at = vec![NONE; surface.vertex_count()];
        self.next_triangle = surface.triangle_count() as u32;
        self.surface_triangles.clone_from(&self.mesh_triangles);
        self.surface_triangles.resize(surface.triangle_count(), Turned::VIRTUAL);
        for (fine, &triangle) in (0..).zip(&stage.triangles) {
            let number = self.number_of[triangle as usize];
            if number != NONE {
                let turn = u32::from(self.mesh_triangles[number as usize].turn);
                self.corners[fine as usize] = 4 * number + turn;
            }
        }
        let real_count = stage.triangles.len() as u32;
        for fine in
            (0..real_count).filter(|&fine| self.number_of[stage.triangles[fine as usize] as usize] != NONE)
        {
            for corner in 4 * fine..4 * fine + 3 {
                let here = turned(self.corners[fine as usize], corner & 3);
                let vertex = surface.vertex(here);
                self.vertices[stage.surface.vertex(corner) as usize] = vertex;
                let copy = stage.surface.vertex(corner) - stage.surface.virtual_count();
                self.positions[vertex as usize] = stage.position_of_copy[copy as usize];
                let (across, across_here) = (stage.surface.opposite(corner), surface.opposite(here));
                if triangle_of(across) >= real_count {
                    let turn = (across_here & 3) + 3 - (across & 3);
                    self.corners[triangle_of(across) as usize] = turned(across_here & !3, turn);
                    self.vertices[stage.surface.vertex(across) as usize] = surface.vertex(across_here);
                }
            }
        }
    }
}

impl Source for Truth<'_> {
    #[inline]
    fn plan(&self) -> Option<&dyn Plan> {
        Some(self)
    }

    #[inline]
    fn follower(&mut self) -> Option<&mut dyn CodingObserver> {
        Some(self)
    }
}

impl Plan for Truth<'_> {
    fn cut(&self, vertex: u32) -> Option<Cut> {
        let step = self.step_at[vertex as usize];
        let stage = self.surface_stage()?;
        let cut = stage.undo.get(step.checked_sub(stage.first_step)? as usize)?.cut;
        let first = turned(self.corners[cut.first as usize / 4], cut.first & 3);
        Some(Cut { first, length: cut.length })
    }

    fn place(&self, vertex: u32) -> [i32; 3] {
        self.points.places[self.positions[vertex as usize] as usize]
    }

    fn exact(&self, vertex: u32) -> [f32; 3] {
        self.points.exact[self.positions[vertex as usize] as usize]
    }

    fn wedges(&self, vertex: u32) -> Range<u32> {
        self.refinable.sequence.positions().wedges(self.positions[vertex as usize])
    }

    fn wedge(&self, corner: u32) -> u32 {
        let turned = self.surface_triangles[triangle_of(corner) as usize];
        let shown = self.shown.get(turned.triangle as usize);
        shown.map_or(NONE, |shown| shown[turned.slot(corner & 3)])
    }

    fn vertex_at(&self, corner: u32) -> u32 {
        self.vertex_of.get(self.wedge(corner) as usize).copied().unwrap_or(NONE)
    }

    fn target(&self, wedge: u32) -> u32 {
        self.vertex_of[self.refinable.sequence.target(wedge) as usize]
    }

    fn group(&self, triangle: u32) -> u32 {
        let turned = self.surface_triangles[triangle as usize];
        self.group_of.get(turned.triangle as usize).copied().unwrap_or(NONE)
    }

    fn layers(&self) -> &[LayerValues] {
        &self.points.layers
    }

    fn general_count(&self) -> u32 {
        match self.descent.stages.get(self.stage) {
            Some(Stage::General(stage)) => stage.steps.len() as u32,
            _ => 0,
        }
    }
}

impl CodingObserver for Truth<'_> {
    fn order_base(&mut self, base: &Base, order: &BaseOrder) {
        for (new, &old) in order.vertices.iter().enumerate() {
            let fine = self.base_vertices[old as usize];
            self.vertices[fine as usize] = new as u32;
            let copy = (new as u32).checked_sub(base.virtual_count);
            let position = copy.map(|copy| order.positions[base.position_of_copy[copy as usize] as usize]);
            self.positions.push(position.unwrap_or(NONE));
            self.step_at.push(NONE);
        }
        (0..).zip(&order.positions).for_each(|(new, &p)| self.number_of_position[p as usize] = new);
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
        if let Some(Stage::General(stage)) = self.descent.stages.get(self.stage + 1)
            && stage.begins(batch.start)
        {
            self.stage += 1;
            let number = |position: u32| self.number_of_position[position as usize];
            self.general_order = GeneralOrder::new(stage, self.shown.len(), number);
        }
        let Some(stage) = self.surface_stage() else { return };
        for step in batch {
            let undo = &stage.undo[(step - stage.first_step) as usize];
            self.step_at[self.vertices[undo.kept as usize] as usize] = step;
        }
    }

    fn born(&mut self, vertex: u32, kept: u32) {
        let step = std::mem::replace(&mut self.step_at[kept as usize], NONE);
        let Some(stage) = self.surface_stage() else { return };
        let position = self.refinable.sequence.base_position_count() as u32 + step;
        let undo = &stage.undo[(step - stage.first_step) as usize];
        let fine = stage.surface.vertex(undo.removed_corners[0]);
        self.vertices[fine as usize] = vertex;
        self.positions.push(position);
        self.step_at.push(NONE);
        self.push_position(position);
        for removed_corners in undo.removed_corners {
            // The new vertex has the first corner of both new triangles.
            self.push_triangle(removed_corners / 4, (3 - (removed_corners & 3)) % 3);
        }
        self.order.push(step);
    }

    fn refine(&mut self, vertex: u32, corners: &[u32]) {
        let step = self.positions[vertex as usize] - self.refinable.sequence.base_position_count() as u32;
        let (Some(stage), [_, patch @ .., _]) = (self.surface_stage(), corners) else { return };
        for (&corner, &shown) in patch.iter().zip(stage.patch((step - stage.first_step) as usize)) {
            let turned = self.surface_triangles[triangle_of(corner) as usize];
            if turned.triangle != NONE {
                self.shown[turned.triangle as usize][turned.slot(corner & 3)] = shown;
            }
        }
    }

    fn general_step(&mut self) -> KnownStep {
        let Some(Stage::General(stage)) = self.descent.stages.get(self.stage) else {
            return KnownStep::default();
        };
        self.told = self.general_order.next().unwrap_or(0);
        let undo = stage.undo(self.told as usize);
        let base = self.refinable.sequence.base_position_count() as u32;
        let position = base + stage.steps[self.told as usize];
        for &(corner, shown) in stage.moved(undo) {
            self.shown[corner as usize / 3][corner as usize % 3] = shown;
        }
        let known_moved = |&(corner, shown): &(u32, u32)| {
            let number = self.number_of[corner as usize / 3];
            let turned = self.mesh_triangles[number as usize];
            (3 * number + turned.corner(corner % 3), shown)
        };
        let mut moved: Vec<(u32, u32)> = stage.moved(undo).iter().map(known_moved).collect();
        moved.sort_unstable();
        let wedges = self.refinable.sequence.positions().wedges(position);
        KnownStep {
            split: self.number_of_position[undo.target as usize],
            moved,
            born: stage
                .removed_corners(undo)
                .iter()
                .map(|&t| self.known_born(t, [position, undo.target]))
                .collect(),
            targets: wedges.clone().map(|w| self.stream_vertex(self.refinable.sequence.target(w))).collect(),
            wedges,
            place: self.points.places[position as usize],
            exact: self.points.exact[position as usize],
        }
    }

    fn born_general(&mut self, step: &CodedStep) {
        let Some(Stage::General(stage)) = self.descent.stages.get(self.stage) else { return };
        let undo = stage.undo(self.told as usize);
        let index = stage.steps[self.told as usize];
        let position = self.refinable.sequence.base_position_count() as u32 + index;
        for &known in &step.known {
            let triangle = stage.removed(undo)[known];
            let own = self.shown[triangle as usize].map(|v| self.position_of(v) == position);
            let slot = own.iter().position(|&is_own| is_own).unwrap_or(0);
            // The new position has the first corner.
            self.push_mesh_triangle(Turned { triangle, turn: ((3 - slot) % 3) as u8 });
        }
        self.push_position(position);
        self.order.push(index);
    }

    fn rebuilt(&mut self, surface: &Surface) {
        self.stage += 1;
        if let Some(stage) = self.surface_stage() {
            self.rename(stage, surface);
        }
    }
}
