//! Multiresolution ordered meshes \[RCHQ98\]: the triangles of all levels, in the order in which
//! refinement creates them.
//!
//! A split removes triangles and creates others. A triangle that is not in the base mesh therefore has a
//! split that creates it, and one that is not in the full mesh has a split that removes it. All triangles
//! of a level lie in a first part of the list, and one of them is shown if the split that removes it has
//! not been applied. Nothing is kept between levels: any level is read directly from the list, and the
//! state of an instance is its split count.
//!
//! ```text
//! triangles created by  base  | step 0 | step 1 | step 2 | ...
//! removed by step        0 1 - | 1 2 -  | 2 2 5  | 7 7 -  | ...
//! split count 2          . . x | . x x  | x x x  |          x are shown
//! ```
//!
//! Differs: \[RCHQ98\] is known here from its abstract and from \[Cor01\]. Triangles that a collapse moves
//! are stored as new ones, as there. Each group has a separate list.
//!
//! Cost: a step creates about six triangles, so the list is three times as long as that of the full mesh,
//! and three triangles are read for each one shown. Moving costs nothing.

use std::ops::Range;

use striata::mesh::{RefinableMesh, is_proper};
use striata::model::{DrawCounts, LodModel, PartBytes, Topology};

use crate::paper_bytes::{Accounting, PaperBytes};

/// End of a chain of triangles.
const END: u32 = u32::MAX;

/// Marks a triangle that no split removes.
const NEVER: u32 = u32::MAX;

/// Number of triangles filtered before they are written out.
const BLOCK_LEN: usize = 256;

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OrderedMeshes {
    step_count: usize,
    triangles: Vec<OrderedTriangle>,
    /// First triangle of each group, followed by the number of triangles.
    group_offsets: Vec<u32>,
    /// For each group, the steps that create triangles in it, in ascending order, each with its first
    /// triangle.
    makers: Vec<[u32; 2]>,
    /// First of each group's makers, followed by their number.
    maker_offsets: Vec<u32>,
}

/// A triangle and the step whose split removes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct OrderedTriangle {
    corners: [u32; 3],
    removed_by: u32,
}

/// State of one instance: its split count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OrderedMeshesState {
    split_count: usize,
}

impl OrderedMeshes {
    /// Builds the model from a mesh and its sequence.
    ///
    /// # Panics
    /// If the mesh refers to vertices that the sequence does not have.
    pub fn build(refinable: &RefinableMesh) -> Self {
        let mut builder = OrderedMeshesBuilder::new(refinable);
        for step in (0..refinable.sequence.step_count()).rev() {
            builder.collapse(step);
        }
        builder.finish()
    }

    /// Number of triangles of all levels together.
    pub fn stored_triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// Number of groups of triangles.
    pub fn group_count(&self) -> usize {
        self.group_offsets.len() - 1
    }

    /// Appends the triangles of one group at an instance's level, three indices each.
    ///
    /// # Panics
    /// If the group does not exist.
    pub fn group_indices_into(&self, state: &OrderedMeshesState, group: usize, out: &mut Vec<u32>) {
        let mut block = [0; 3 * BLOCK_LEN];
        for triangles in self.created(state.split_count, group).chunks(BLOCK_LEN) {
            let mut filled = 0;
            // Write every triangle and overwrite those that are not shown: a branch would be hard to predict.
            for triangle in triangles {
                block[filled..filled + 3].copy_from_slice(&triangle.corners);
                filled += if triangle.is_shown(state.split_count) { 3 } else { 0 };
            }
            out.extend_from_slice(&block[..filled]);
        }
    }

    /// The triangles of a group that the splits up to a level create.
    fn created(&self, split_count: usize, group: usize) -> &[OrderedTriangle] {
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
        self.removed_by as usize >= split_count
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
            |group| self.created(state.split_count, group).iter().filter(|t| t.is_shown(state.split_count));
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
    /// Three vertices of each triangle and the step that removes it, all long; for each step its first
    /// triangle and how many it creates.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        accounting.bytes(self.step_count, 4 * self.triangles.len() + self.step_count)
    }
}

/// A triangle found while the full mesh is collapsed.
struct BuiltTriangle {
    group: u32,
    /// 0 for the base, otherwise one more than the step that creates it.
    created_at: u32,
    triangle: OrderedTriangle,
}

struct OrderedMeshesBuilder<'r> {
    refinable: &'r RefinableMesh,
    /// The triangles of all levels, in the order in which collapsing the full mesh finds them.
    found: Vec<BuiltTriangle>,
    is_removed: Vec<bool>,
    /// The next triangle in the chains of its three corners.
    next: Vec<[u32; 3]>,
    /// First triangle of each vertex's chain, which may contain removed triangles.
    chains: Vec<u32>,
}

impl<'r> OrderedMeshesBuilder<'r> {
    fn new(refinable: &'r RefinableMesh) -> Self {
        let mut builder = Self {
            refinable,
            found: Vec::with_capacity(3 * refinable.mesh.triangle_count()),
            is_removed: Vec::new(),
            next: Vec::new(),
            chains: vec![END; refinable.sequence.positions().vertex_count()],
        };
        for (group, range) in (0..).zip(refinable.mesh.groups_or_whole().iter().map(|group| group.range())) {
            for &corners in refinable.mesh.triangles[range].iter().filter(|t| is_proper(t)) {
                builder.add(group, OrderedTriangle { corners, removed_by: NEVER });
            }
        }
        builder
    }

    fn add(&mut self, group: u32, triangle: OrderedTriangle) {
        let index = self.found.len() as u32;
        let chains = &mut self.chains;
        self.next.push(triangle.corners.map(|v| std::mem::replace(&mut chains[v as usize], index)));
        self.found.push(BuiltTriangle { group, created_at: 0, triangle });
        self.is_removed.push(false);
    }

    /// Removes the triangles around a step's vertices and adds those that remain after the collapse.
    fn collapse(&mut self, step: usize) {
        let sequence = &self.refinable.sequence;
        let vertices = sequence.step_vertices(step);
        for vertex in vertices.clone() {
            let mut at = self.chains[vertex as usize];
            while at != END {
                let BuiltTriangle { group, triangle, .. } = self.found[at as usize];
                if !std::mem::replace(&mut self.is_removed[at as usize], true) {
                    self.found[at as usize].created_at = step as u32 + 1;
                    let collapsed =
                        triangle.corners.map(|v| if vertices.contains(&v) { sequence.target(v) } else { v });
                    if is_proper(&collapsed) {
                        self.add(group, OrderedTriangle { corners: collapsed, removed_by: step as u32 });
                    }
                }
                let corner = triangle.corners.iter().position(|&v| v == vertex).unwrap_or(0);
                at = self.next[at as usize][corner];
            }
        }
    }

    fn finish(mut self) -> OrderedMeshes {
        let group_count = self.refinable.mesh.groups.len().max(1) as u32;
        // The sort is stable, so triangles of equal keys stay in the order of the full mesh.
        self.found.sort_by_key(|found| (found.group, found.created_at));
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
            for of_step in self.found[first..first + count].chunk_by(|a, b| a.created_at == b.created_at) {
                if let Some(step) = of_step[0].created_at.checked_sub(1) {
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
