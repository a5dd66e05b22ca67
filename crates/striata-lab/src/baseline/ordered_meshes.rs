//! Multiresolution ordered meshes: all triangles that there ever are, in the order in which refinement makes them \[RCHQ98\].
//!
//! A split takes triangles away and makes others, so a triangle that is not of the base has a split that makes it, and one that is
//! not of the full mesh has a split that takes it away. The triangles of a level are thus among a first part of the list, and
//! are there if the split that takes them away lies ahead. Nothing is kept between levels: whatever level is asked
//! for is read off the list, and an instance is its number.
//!
//! ```text
//! triangles made by     base  | step 0 | step 1 | step 2 | ...
//! taken away by step     0 1 - | 1 2 -  | 2 2 5  | 7 7 -  | ...
//! split count 2          . . x | . x x  | x x x  |          x are shown
//! ```
//!
//! Differs: \[RCHQ98\] is told here from its abstract and from \[Cor01\]; what the collapse of a vertex moves it stores as new
//! triangles, and so do we. The list of each group stands for itself.
//!
//! Cost: a step makes about six triangles, so the list is three times as long as that of the full mesh and three
//! triangles are read for one that is shown. Moving costs nothing.

use std::ops::Range;

use striata::mesh::{RefinableMesh, is_proper};
use striata::model::{DrawCounts, LodModel, PartBytes, Topology};

use crate::paper_bytes::{Accounting, PaperBytes};

/// Ends a chain of triangles.
const END: u32 = u32::MAX;

/// No split takes the triangle away.
const NEVER: u32 = u32::MAX;

/// Triangles that are sorted out before they are handed over.
const BLOCK_LEN: usize = 256;

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OrderedMeshes {
    step_count: usize,
    triangles: Vec<OrderedTriangle>,
    /// First triangle of each group, closed by the number of triangles.
    group_offsets: Vec<u32>,
    /// For each group the steps that make triangles of it, rising, and their first triangle.
    makers: Vec<[u32; 2]>,
    /// First of each group's makers, closed by their number.
    maker_offsets: Vec<u32>,
}

/// A triangle, and the step whose split takes it away.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct OrderedTriangle {
    corners: [u32; 3],
    taken_by: u32,
}

/// An instance: nothing but its level.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OrderedMeshesState {
    split_count: usize,
}

impl OrderedMeshes {
    /// Builds the model from a mesh and its sequence.
    ///
    /// # Panics
    /// If the mesh is not the sequence's: it names vertices that the sequence does not have.
    pub fn build(refinable: &RefinableMesh) -> Self {
        let mut builder = Builder::new(refinable);
        for step in (0..refinable.sequence.step_count()).rev() {
            builder.collapse(step);
        }
        builder.finish()
    }

    /// Triangles of all levels together.
    pub fn stored_triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Groups of triangles.
    pub fn group_count(&self) -> usize {
        self.group_offsets.len() - 1
    }

    /// Appends the triangles of one group at the level of an instance, three indices each.
    ///
    /// # Panics
    /// If there is no such group.
    pub fn group_indices_into(&self, state: &OrderedMeshesState, group: usize, out: &mut Vec<u32>) {
        let mut block = [0; 3 * BLOCK_LEN];
        for triangles in self.made(state.split_count, group).chunks(BLOCK_LEN) {
            let mut filled = 0;
            // Every triangle is written, and those that are not shown are written over: which are is hard to foresee.
            for triangle in triangles {
                block[filled..filled + 3].copy_from_slice(&triangle.corners);
                filled += if triangle.is_shown(state.split_count) { 3 } else { 0 };
            }
            out.extend_from_slice(&block[..filled]);
        }
    }

    /// The triangles of a group that are made by a level's splits.
    fn made(&self, split_count: usize, group: usize) -> &[OrderedTriangle] {
        let range =
            |offsets: &[u32]| -> Range<usize> { offsets[group] as usize..offsets[group + 1] as usize };
        let makers = &self.makers[range(&self.maker_offsets)];
        let triangles = range(&self.group_offsets);
        let next = makers.partition_point(|&[step, _]| (step as usize) < split_count);
        let end = makers.get(next).map_or(triangles.end, |&[_, first]| first as usize);
        &self.triangles[triangles.start..end]
    }
}

impl OrderedTriangle {
    #[inline]
    fn is_shown(&self, split_count: usize) -> bool {
        self.taken_by as usize >= split_count
    }
}

impl LodModel for OrderedMeshes {
    type State = OrderedMeshesState;

    fn step_count(&self) -> usize {
        self.step_count
    }

    fn new_state(&self) -> OrderedMeshesState {
        OrderedMeshesState { split_count: self.step_count }
    }

    fn split_count(&self, state: &OrderedMeshesState) -> usize {
        state.split_count
    }

    fn move_to(&self, state: &mut OrderedMeshesState, split_count: usize) {
        assert!(split_count <= self.step_count, "split count {split_count} of {}", self.step_count);
        state.split_count = split_count;
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &OrderedMeshesState) -> DrawCounts {
        let shown =
            |group| self.made(state.split_count, group).iter().filter(|t| t.is_shown(state.split_count));
        let triangle_count: usize = (0..self.group_count()).map(|group| shown(group).count()).sum();
        DrawCounts { strip_count: 0, index_count: 3 * triangle_count }
    }

    fn indices_into(&self, state: &OrderedMeshesState, out: &mut Vec<u32>) {
        (0..self.group_count()).for_each(|group| self.group_indices_into(state, group, out));
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        let offsets = 4 * (self.group_offsets.len() + self.maker_offsets.len());
        vec![
            part("triangles", 12 * self.triangles.len()),
            part("taken by", 4 * self.triangles.len()),
            part("makers", size_of_val(&self.makers[..]) + offsets),
        ]
    }

    fn state_bytes(&self, _: &OrderedMeshesState) -> usize {
        size_of::<OrderedMeshesState>()
    }
}

impl PaperBytes for OrderedMeshes {
    /// Three vertices of each triangle and the step that takes it away, all long; for each step its first triangle, and
    /// how many it makes.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        accounting.bytes(self.step_count, 4 * self.triangles.len() + self.step_count)
    }
}

/// A triangle on the way to the list.
struct Found {
    group: u32,
    /// 0 for the base, else the step that makes it and one.
    made_at: u32,
    triangle: OrderedTriangle,
}

struct Builder<'r> {
    refinable: &'r RefinableMesh,
    /// All triangles that there ever are, as they come from the full mesh down.
    found: Vec<Found>,
    is_gone: Vec<bool>,
    /// The next triangle in the chains of its three corners.
    next: Vec<[u32; 3]>,
    /// First triangle of each vertex, triangles that are gone among them.
    chains: Vec<u32>,
}

impl<'r> Builder<'r> {
    fn new(refinable: &'r RefinableMesh) -> Self {
        let mut builder = Self {
            refinable,
            found: Vec::with_capacity(3 * refinable.mesh.triangle_count()),
            is_gone: Vec::new(),
            next: Vec::new(),
            chains: vec![END; refinable.sequence.positions().vertex_count()],
        };
        for (group, range) in (0..).zip(refinable.mesh.groups_or_whole().iter().map(|group| group.range())) {
            for &corners in refinable.mesh.triangles[range].iter().filter(|t| is_proper(t)) {
                builder.add(group, OrderedTriangle { corners, taken_by: NEVER });
            }
        }
        builder
    }

    fn add(&mut self, group: u32, triangle: OrderedTriangle) {
        let number = self.found.len() as u32;
        let chains = &mut self.chains;
        self.next.push(triangle.corners.map(|v| std::mem::replace(&mut chains[v as usize], number)));
        self.found.push(Found { group, made_at: 0, triangle });
        self.is_gone.push(false);
    }

    /// Takes the triangles of a step's vertices away and puts what is left of them in their place.
    fn collapse(&mut self, step: usize) {
        let sequence = &self.refinable.sequence;
        let vertices = sequence.step_vertices(step);
        for vertex in vertices.clone() {
            let mut at = self.chains[vertex as usize];
            while at != END {
                let Found { group, triangle, .. } = self.found[at as usize];
                if !std::mem::replace(&mut self.is_gone[at as usize], true) {
                    self.found[at as usize].made_at = step as u32 + 1;
                    let left =
                        triangle.corners.map(|v| if vertices.contains(&v) { sequence.target(v) } else { v });
                    if is_proper(&left) {
                        self.add(group, OrderedTriangle { corners: left, taken_by: step as u32 });
                    }
                }
                let corner = triangle.corners.iter().position(|&v| v == vertex).unwrap_or(0);
                at = self.next[at as usize][corner];
            }
        }
    }

    fn finish(mut self) -> OrderedMeshes {
        let group_count = self.refinable.mesh.groups.len().max(1) as u32;
        // What the sort leaves as it was stands as the full mesh has it.
        self.found.sort_by_key(|found| (found.group, found.made_at));
        let mut model = OrderedMeshes {
            step_count: self.refinable.sequence.step_count(),
            triangles: self.found.iter().map(|found| found.triangle).collect(),
            group_offsets: Vec::with_capacity(group_count as usize + 1),
            makers: Vec::new(),
            maker_offsets: Vec::with_capacity(group_count as usize + 1),
        };
        let mut first = 0;
        for group in 0..group_count {
            model.group_offsets.push(first as u32);
            model.maker_offsets.push(model.makers.len() as u32);
            let count = self.found[first..].partition_point(|found| found.group == group);
            let mut at = first;
            for of_step in self.found[first..first + count].chunk_by(|a, b| a.made_at == b.made_at) {
                if let Some(step) = of_step[0].made_at.checked_sub(1) {
                    model.makers.push([step, at as u32]);
                }
                at += of_step.len();
            }
            first += count;
        }
        model.group_offsets.push(first as u32);
        model.maker_offsets.push(model.makers.len() as u32);
        model
    }
}
