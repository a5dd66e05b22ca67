//! The mesh built so far: the triangles of a level and the collapse sequence that leads to it.
//!
//! If each position has exactly one vertex, the triangle list follows from the surface. It is then
//! updated once for many splits ([`GrowingMesh::catch_up`]), because updating it after each split would incur
//! a cache miss for every triangle of a patch.

use std::ops::Range;

use crate::base::mesh::Base;
use crate::general::step::CodedStep;
use crate::topology::surface::{NONE, Surface, next, previous, triangle_of};
use crate::wedges::split::SplitWedges;

/// Triangles and steps, which grow with each split. Vertices are numbered in stream order: the base
/// first, then step by step.
#[derive(Clone, Debug, Default)]
pub(crate) struct GrowingMesh {
    /// Positions of the vertices, in mesh units.
    pub positions: Vec<[f32; 3]>,
    /// Corners of each triangle of the level, in coding order, as of the last [`catch_up`](Self::catch_up).
    pub triangles: Vec<[u32; 3]>,
    /// Group of each triangle, if there are several groups.
    pub groups: Vec<u32>,
    /// Number of groups in the mesh.
    pub group_count: u32,
    /// The vertex that each vertex beyond the base collapses to.
    pub targets: Vec<u32>,
    /// Number of triangles that each step adds.
    pub added: Vec<u8>,
    /// Triangles whose corners the latest steps changed, possibly with repetitions.
    pub changed: Vec<u32>,
    /// First vertex of each position, followed by the vertex count.
    pub first_vertex: Vec<u32>,
    /// Number of triangles of general steps in excess of two per step.
    excess_triangles: usize,
    /// Position of each vertex of the surface; [`NONE`] for virtual vertices.
    position_of: Vec<u32>,
    /// Number of surface triangles whose vertices are completely coded, and how many of them are in the list.
    complete_triangles: u32,
    listed_triangles: u32,
    /// Number of the level's triangles that are not in the list yet.
    unlisted_count: usize,
    /// Surface triangles whose corners in the list are outdated.
    outdated: Vec<u32>,
}

impl GrowingMesh {
    /// Starts with a base mesh: its non-virtual triangles in surface order, with their groups and the
    /// vertices that their corners refer to.
    pub(crate) fn of_base(base: &Base, surface: &mut Surface, group_count: u32) -> Self {
        let virtual_vertices = std::iter::repeat_n(NONE, base.virtual_count as usize);
        let mut growth = Self {
            group_count,
            first_vertex: base.first_vertex.clone(),
            position_of: virtual_vertices.chain(base.position_of_copy.iter().copied()).collect(),
            complete_triangles: base.corner_vertices.len() as u32,
            listed_triangles: base.corner_vertices.len() as u32,
            ..Self::default()
        };
        for (t, (&shown, &group)) in base.corner_vertices.iter().zip(&base.groups).enumerate() {
            if shown[0] == NONE {
                surface.set_label(t as u32, NONE);
            } else {
                growth.push(surface, t as u32, shown, group);
            }
        }
        growth
    }

    /// Reserves memory for a number of steps that add one vertex each.
    pub(crate) fn reserve(&mut self, steps: usize) {
        self.positions.reserve(steps);
        self.triangles.reserve(2 * steps);
        self.targets.reserve(steps);
        self.added.reserve(steps);
        self.first_vertex.reserve(steps);
        self.position_of.reserve(steps);
    }

    /// Number of vertices so far.
    pub(crate) fn vertex_count(&self) -> u32 {
        self.first_vertex.last().copied().unwrap_or(0)
    }

    /// Number of vertices in excess of one per position, plus triangles in excess of two per general
    /// step. A reader limits their sum by the number of bytes.
    pub(crate) fn excess_count(&self) -> usize {
        self.vertex_count() as usize - (self.first_vertex.len() - 1) + self.excess_triangles
    }

    /// Returns the vertices at the position of a vertex of the surface.
    #[inline]
    pub(crate) fn wedges(&self, surface_vertex: u32) -> Range<u32> {
        let position = self.position_of[surface_vertex as usize] as usize;
        self.first_vertex[position]..self.first_vertex[position + 1]
    }

    /// Returns the vertex that a corner refers to, or `None` if its triangle is virtual or not complete yet.
    #[inline]
    pub(crate) fn shown(&self, surface: &Surface, corner: u32) -> Option<u32> {
        let label = surface.label(triangle_of(corner));
        (label != NONE).then(|| self.triangles[label as usize][(corner & 3) as usize])
    }

    /// Returns the group of a triangle, or `None` if it is virtual or not complete yet.
    pub(crate) fn group(&self, surface: &Surface, triangle: u32) -> Option<u32> {
        let label = surface.label(triangle);
        (label != NONE).then(|| self.groups.get(label as usize).copied().unwrap_or(0))
    }

    /// Returns the position of a surface vertex that is not virtual.
    pub(crate) fn position_of(&self, surface_vertex: u32) -> u32 {
        self.position_of[surface_vertex as usize]
    }

    /// Returns the position of each vertex of the mesh.
    pub(crate) fn positions_of_vertices(&self) -> Vec<u32> {
        let wedges = self.first_vertex.windows(2).zip(0..);
        wedges.flat_map(|(w, position)| std::iter::repeat_n(position, (w[1] - w[0]) as usize)).collect()
    }

    /// Adapts to a rebuilt surface with `virtual_count` virtual vertices, followed by vertices at
    /// `positions`, and with `triangle_count` triangles.
    pub(crate) fn renumber(&mut self, virtual_count: usize, positions: &[u32], triangle_count: usize) {
        self.complete_triangles = triangle_count as u32;
        self.listed_triangles = self.complete_triangles;
        self.position_of =
            std::iter::repeat_n(NONE, virtual_count).chain(positions.iter().copied()).collect();
    }

    /// Adds the position of a general step. The surface does not contain it until it is rebuilt.
    pub(crate) fn add_general(&mut self, position: [f32; 3], step: &CodedStep) {
        let first = self.vertex_count();
        self.targets.extend_from_slice(&step.targets);
        self.begin_position(step.targets.len() as u32, position);
        for (&corner, &wedge) in step.fan.iter().zip(&step.wedges) {
            self.triangles[corner as usize / 3][corner as usize % 3] = first + wedge;
            self.changed.push(corner / 3);
        }
        let wedges = &step.wedges[step.fan.len()..];
        for (at, triangle) in step.new_triangles.iter().enumerate() {
            let [split, third] = step.others[at];
            self.triangles.push(triangle.ordered([first + wedges[at], split, third]));
            if self.group_count > 1 {
                self.groups.push(step.groups[at]);
            }
        }
        self.excess_triangles += step.new_triangles.len().saturating_sub(2);
        self.added.push(step.new_triangles.len() as u8);
    }

    /// Appends a triangle to the list and labels the surface triangle with its index.
    fn push(&mut self, surface: &mut Surface, triangle: u32, shown: [u32; 3], group: u32) {
        surface.set_label(triangle, self.triangles.len() as u32);
        self.triangles.push(shown);
        if self.group_count > 1 {
            self.groups.push(group);
        }
    }

    /// Adds a position with one vertex, in a mesh in which all positions have one. `corners` are the
    /// corners around it, starting with the one in A and ending with the one in B. The triangle list does
    /// not change before the next [`catch_up`](Self::catch_up).
    pub(crate) fn add(&mut self, surface: &Surface, corners: &[u32], position: [f32; 3]) {
        let last = corners.len() - 1;
        self.targets.push(self.vertex_of(surface.vertex(next(corners[0]))));
        self.begin_position(1, position);
        let patch = corners[1..last].iter().map(|&corner| triangle_of(corner));
        self.outdated.extend(patch.filter(|&triangle| triangle < self.listed_triangles));
        // A is (new, kept, r0), B is (new, rk, kept).
        let ends = [previous(corners[0]), next(corners[last])];
        let added = ends.map(|end| u8::from(!surface.is_virtual(surface.vertex(end))));
        self.added.push(added[0] + added[1]);
        self.complete_triangles += 2;
        self.unlisted_count += usize::from(added[0] + added[1]);
    }

    /// Brings the list of triangles up to date after [`add`](Self::add).
    pub(crate) fn catch_up(&mut self, surface: &mut Surface) {
        let mut outdated = std::mem::take(&mut self.outdated);
        outdated.sort_unstable();
        outdated.dedup();
        for triangle in outdated.drain(..) {
            let label = surface.label(triangle);
            if label != NONE {
                self.triangles[label as usize] = self.shown_now(surface, triangle);
                self.changed.push(label);
            }
        }
        self.outdated = outdated;
        for triangle in self.listed_triangles..self.complete_triangles {
            if surface.triangle(triangle).iter().all(|&v| !surface.is_virtual(v)) {
                let shown = self.shown_now(surface, triangle);
                self.push(surface, triangle, shown, 0);
            }
        }
        self.listed_triangles = self.complete_triangles;
        self.unlisted_count = 0;
    }

    /// Returns the current vertices of a triangle. A new vertex that is not complete yet is replaced by
    /// the one it was split off.
    fn shown_now(&self, surface: &Surface, triangle: u32) -> [u32; 3] {
        surface.triangle(triangle).map(|vertex| match self.position_of.get(vertex as usize) {
            Some(&position) => position,
            None => self.vertex_of(surface.vertex(next(surface.corner_of(vertex)))),
        })
    }

    /// Number of triangles in the level.
    pub(crate) fn triangle_count(&self) -> usize {
        self.triangles.len() + self.unlisted_count
    }

    /// Returns the vertex of a position in a mesh in which all positions have one: both have the same index.
    fn vertex_of(&self, surface_vertex: u32) -> u32 {
        self.position_of[surface_vertex as usize]
    }

    /// Appends a position with a number of vertices.
    fn begin_position(&mut self, vertex_count: u32, position: [f32; 3]) {
        let first = self.vertex_count();
        self.position_of.push(self.first_vertex.len() as u32 - 1);
        self.first_vertex.push(first + vertex_count);
        self.positions.extend(std::iter::repeat_n(position, vertex_count as usize));
    }

    /// Updates the vertex that a corner refers to in the triangle list.
    fn change(&mut self, surface: &Surface, corner: u32, vertex: u32) {
        let label = surface.label(triangle_of(corner));
        if label != NONE {
            self.triangles[label as usize][(corner & 3) as usize] = vertex;
            self.changed.push(label);
        }
    }

    /// Adds a position together with the vertices that the corners around it refer to.
    pub(crate) fn add_wedges(
        &mut self,
        surface: &mut Surface,
        corners: &[u32],
        position: [f32; 3],
        split_wedges: &SplitWedges,
    ) {
        let first = self.vertex_count();
        self.targets.extend_from_slice(&split_wedges.targets);
        self.begin_position(split_wedges.targets.len() as u32, position);
        let last = corners.len() - 1;
        for (&corner, &wedge) in corners[1..last].iter().zip(&split_wedges.wedges[1..last]) {
            if wedge != NONE {
                self.change(surface, corner, first + wedge);
            }
        }
        let mut added = 0;
        for (side, at) in [0, last].into_iter().enumerate() {
            if split_wedges.wedges[at] == NONE {
                continue;
            }
            // Starting at the corner of the new position: A is (new, kept, end), B is (new, end, kept).
            let (new, kept, end) =
                (first + split_wedges.wedges[at], split_wedges.kept[side], split_wedges.ends[side]);
            let mut shown = if side == 0 { [new, kept, end] } else { [new, end, kept] };
            shown.rotate_right((corners[at] & 3) as usize);
            self.push(surface, triangle_of(corners[at]), shown, split_wedges.groups[side]);
            added += 1;
        }
        self.added.push(added);
    }
}
