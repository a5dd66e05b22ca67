//! What a stream has given so far: triangles of a level and the sequence that leads to it.
//!
//! If each position is one vertex, the list of triangles follows from the surface. It is then brought up to date once for many
//! splits ([`Growth::catch_up`]), since changing it split by split would mean waiting for memory at each triangle of a patch.

use std::ops::Range;

use crate::base::mesh::Base;
use crate::general::step::CodedStep;
use crate::topology::surface::{NONE, Surface, next, previous, triangle_of};
use crate::wedges::split::SplitWedges;

/// Triangles and steps, growing with each split. Vertices are numbered as in the mesh: base first, then step by step.
#[derive(Clone, Debug, Default)]
pub(crate) struct Growth {
    /// Where the vertices are, mesh units.
    pub(crate) positions: Vec<[f32; 3]>,
    /// Corners of each triangle of the level, in the order in which they came, as of when the list last caught up.
    pub(crate) triangles: Vec<[u32; 3]>,
    /// The group of each triangle, where there are several.
    pub(crate) groups: Vec<u32>,
    /// Groups of the mesh.
    pub(crate) group_count: u32,
    /// The vertex that each one beyond the base collapses to.
    pub(crate) targets: Vec<u32>,
    /// Triangles that each step brings.
    pub(crate) added: Vec<u8>,
    /// Triangles whose corners were changed by the last steps, with repetitions.
    pub(crate) changed: Vec<u32>,
    /// First vertex of each position, closed by the number of vertices.
    pub(crate) first_vertex: Vec<u32>,
    triangles_beyond: usize,
    /// Position of each vertex of the surface; virtual ones have none.
    position_of: Vec<u32>,
    /// Triangles of the surface that are told in full, and those of them that have come to the list.
    told_triangles: u32,
    listed_triangles: u32,
    /// Triangles of the level that have not come to the list yet.
    unlisted_count: usize,
    /// Triangles of the surface that are in the list with the corners that they had before.
    outdated: Vec<u32>,
}

impl Growth {
    /// Begins with a base: its triangles in the order of the surface but for virtual ones, with the vertices that their
    /// corners show and their groups.
    pub(crate) fn of_base(base: &Base, surface: &mut Surface, group_count: u32) -> Self {
        let virtual_vertices = std::iter::repeat_n(NONE, base.virtual_count as usize);
        let mut growth = Self {
            group_count,
            first_vertex: base.first_vertex.clone(),
            position_of: virtual_vertices.chain(base.position_of_copy.iter().copied()).collect(),
            told_triangles: base.shown.len() as u32,
            listed_triangles: base.shown.len() as u32,
            ..Self::default()
        };
        for (t, (&shown, &group)) in base.shown.iter().zip(&base.groups).enumerate() {
            if shown[0] == NONE {
                surface.set_label(t as u32, NONE);
            } else {
                growth.push(surface, t as u32, shown, group);
            }
        }
        growth
    }

    /// Makes room for so many steps of one vertex.
    pub(crate) fn reserve(&mut self, steps: usize) {
        self.positions.reserve(steps);
        self.triangles.reserve(2 * steps);
        self.targets.reserve(steps);
        self.added.reserve(steps);
        self.first_vertex.reserve(steps);
        self.position_of.reserve(steps);
    }

    /// Vertices that are there.
    pub(crate) fn vertex_count(&self) -> u32 {
        self.first_vertex.last().copied().unwrap_or(0)
    }

    /// Vertices beyond one a position, and triangles beyond two a general step: what bytes must pay for.
    pub(crate) fn beyond(&self) -> usize {
        self.vertex_count() as usize - (self.first_vertex.len() - 1) + self.triangles_beyond
    }

    /// The vertices of the position of a vertex of the surface.
    #[inline]
    pub(crate) fn wedges(&self, surface_vertex: u32) -> Range<u32> {
        let position = self.position_of[surface_vertex as usize] as usize;
        self.first_vertex[position]..self.first_vertex[position + 1]
    }

    /// The vertex that a corner shows; none in virtual triangles, and in those that are not there yet.
    #[inline]
    pub(crate) fn shown(&self, surface: &Surface, corner: u32) -> Option<u32> {
        let label = surface.label(triangle_of(corner));
        (label != NONE).then(|| self.triangles[label as usize][(corner & 3) as usize])
    }

    /// The group of a triangle; none of virtual ones, and those that are not there yet.
    pub(crate) fn group(&self, surface: &Surface, triangle: u32) -> Option<u32> {
        let label = surface.label(triangle);
        (label != NONE).then(|| self.groups.get(label as usize).copied().unwrap_or(0))
    }

    /// The position of a vertex of the surface that is not virtual.
    pub(crate) fn position_of(&self, surface_vertex: u32) -> u32 {
        self.position_of[surface_vertex as usize]
    }

    /// The position of each vertex of the mesh.
    pub(crate) fn positions_of_vertices(&self) -> Vec<u32> {
        let wedges = self.first_vertex.windows(2).zip(0..);
        wedges.flat_map(|(w, position)| std::iter::repeat_n(position, (w[1] - w[0]) as usize)).collect()
    }

    /// The surface was built anew: it has so many virtual vertices, the others are at these positions, and so many triangles.
    pub(crate) fn renumber(&mut self, virtual_count: usize, positions: &[u32], triangle_count: usize) {
        self.told_triangles = triangle_count as u32;
        self.listed_triangles = self.told_triangles;
        self.position_of =
            std::iter::repeat_n(NONE, virtual_count).chain(positions.iter().copied()).collect();
    }

    /// Adds the position of a general step; the surface does not show it before it is built anew.
    pub(crate) fn add_general(&mut self, position: [f32; 3], step: &CodedStep) {
        let first = self.vertex_count();
        self.targets.extend_from_slice(&step.targets);
        self.begin_position(step.targets.len() as u32, position);
        for (&corner, &wedge) in step.fan.iter().zip(&step.wedges) {
            self.triangles[corner as usize / 3][corner as usize % 3] = first + wedge;
            self.changed.push(corner / 3);
        }
        let wedges = &step.wedges[step.fan.len()..];
        for (at, born) in step.born.iter().enumerate() {
            let [split, third] = step.others[at];
            self.triangles.push(born.ordered([first + wedges[at], split, third]));
            if self.group_count > 1 {
                self.groups.push(step.groups[at]);
            }
        }
        self.triangles_beyond += step.born.len().saturating_sub(2);
        self.added.push(step.born.len() as u8);
    }

    fn push(&mut self, surface: &mut Surface, triangle: u32, shown: [u32; 3], group: u32) {
        surface.set_label(triangle, self.triangles.len() as u32);
        self.triangles.push(shown);
        if self.group_count > 1 {
            self.groups.push(group);
        }
    }

    /// Adds a position of one vertex, if all positions have one; `corners` are those around it, A's first and B's
    /// last. The list of triangles is as before until it [catches up](Self::catch_up).
    pub(crate) fn add(&mut self, surface: &Surface, corners: &[u32], position: [f32; 3]) {
        let last = corners.len() - 1;
        self.targets.push(self.vertex_of(surface.vertex(next(corners[0]))));
        self.begin_position(1, position);
        let patch = corners[1..last].iter().map(|&corner| triangle_of(corner));
        self.outdated.extend(patch.filter(|&triangle| triangle < self.listed_triangles));
        // A is (new, kept, r0), B (new, rk, kept).
        let ends = [previous(corners[0]), next(corners[last])];
        let added = ends.map(|end| u8::from(!surface.is_virtual(surface.vertex(end))));
        self.added.push(added[0] + added[1]);
        self.told_triangles += 2;
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
        for triangle in self.listed_triangles..self.told_triangles {
            if surface.triangle(triangle).iter().all(|&v| !surface.is_virtual(v)) {
                let shown = self.shown_now(surface, triangle);
                self.push(surface, triangle, shown, 0);
            }
        }
        self.listed_triangles = self.told_triangles;
        self.unlisted_count = 0;
    }

    /// The vertices of a triangle; what has been split off and is not told yet shows what it was split off.
    fn shown_now(&self, surface: &Surface, triangle: u32) -> [u32; 3] {
        surface.triangle(triangle).map(|vertex| match self.position_of.get(vertex as usize) {
            Some(&position) => position,
            None => self.vertex_of(surface.vertex(next(surface.corner_of(vertex)))),
        })
    }

    /// Triangles of the level.
    pub(crate) fn triangle_count(&self) -> usize {
        self.triangles.len() + self.unlisted_count
    }

    /// The vertex of a position, if all positions have one: it has the same number.
    fn vertex_of(&self, surface_vertex: u32) -> u32 {
        self.position_of[surface_vertex as usize]
    }

    fn begin_position(&mut self, vertex_count: u32, position: [f32; 3]) {
        let first = self.vertex_count();
        self.position_of.push(self.first_vertex.len() as u32 - 1);
        self.first_vertex.push(first + vertex_count);
        self.positions.extend(std::iter::repeat_n(position, vertex_count as usize));
    }

    fn change(&mut self, surface: &Surface, corner: u32, vertex: u32) {
        let label = surface.label(triangle_of(corner));
        if label != NONE {
            self.triangles[label as usize][(corner & 3) as usize] = vertex;
            self.changed.push(label);
        }
    }

    /// Adds a position with what the corners around it show.
    pub(crate) fn add_wedges(
        &mut self,
        surface: &mut Surface,
        corners: &[u32],
        position: [f32; 3],
        told: &SplitWedges,
    ) {
        let first = self.vertex_count();
        self.targets.extend_from_slice(&told.targets);
        self.begin_position(told.targets.len() as u32, position);
        let last = corners.len() - 1;
        for (&corner, &wedge) in corners[1..last].iter().zip(&told.wedges[1..last]) {
            if wedge != NONE {
                self.change(surface, corner, first + wedge);
            }
        }
        let mut added = 0;
        for (side, at) in [0, last].into_iter().enumerate() {
            if told.wedges[at] == NONE {
                continue;
            }
            // From the corner at the new position on: A is (new, kept, end), B is (new, end, kept).
            let (new, kept, end) = (first + told.wedges[at], told.kept[side], told.ends[side]);
            let mut shown = if side == 0 { [new, kept, end] } else { [new, end, kept] };
            shown.rotate_right((corners[at] & 3) as usize);
            self.push(surface, triangle_of(corners[at]), shown, told.groups[side]);
            added += 1;
        }
        self.added.push(added);
    }
}
