//! Progressive fans \[Cor01\]: every level, uniform or not, from one static table and one bit for each step.
//!
//! Each triangle of every level stands with the vertex that leaves it first, which is the one with the highest number; the
//! triangles that a vertex has when it is removed are its entry. A triangle is there while its entry's vertex is and
//! once the step that makes it has been taken, if one does. So what an instance shows is told by which steps it has taken,
//! a bit each, and each vertex can say by itself which of its triangles are there.
//!
//! ```text
//!          c                 entry of v: ring a b c d e, closed
//!       d / \ b              arcs a-b, b-c ... are the triangles v a b, v b c ...
//!       |  v  |              dependencies: always 11000, made by step 7: 00110, by step 9: 00001
//!        e---a               shown with 7 taken and 9 not: arcs 11110, the fan v; a b c d e
//! ```
//!
//! **Which sets of steps are possible.** A step can be taken once all steps are that once took a triangle from one of its
//! vertices: those that make the triangles of its entry, and some whose floor left nothing at the vertex, which are
//! listed beside (a step at a border, say). It can be undone once every position around it, and its target, is there.
//! [`FanInstance::collapse`] and [`FanInstance::split`] take along whatever is needed for that.
//!
//! Differs: \[Cor01\] simplifies by recursion, here steps wait on a stack. A ring longer than [`MAX_ARCS`] is cut into several
//! fans of one vertex; crowns are fans too, so that no arc has to be void. Positions with several wedges have an entry
//! for each, and one bit.
//!
//! Cost: a triangle a vertex is made by each step that touches it, three times as many as the full mesh has. Extraction
//! is linear in the vertices that are there, a change in the entries that it touches.

mod build;
mod crowns;
mod instance;

use std::ops::Range;

pub use instance::FanInstance;

use super::step_vertices::StepVertices;
use super::{Accounting, DrawCounts, LodModel, PartBytes, Topology};
use crate::mesh::CollapseSequence;

/// Arcs of a fan: as many as its masks have bits.
pub const MAX_ARCS: usize = 32;

/// Stands for the step that makes a triangle of the full mesh.
const ALWAYS: u32 = u32::MAX;

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fans {
    vertices: StepVertices<'static>,
    step_count: usize,
    /// Where the fans of each vertex end.
    entry_ends: Vec<u32>,
    fans: Vec<Fan>,
    group_count: usize,
    /// The group of each fan, rising for each vertex; empty where there is one group.
    fan_groups: Vec<u32>,
    /// Nodes of all rings.
    ring: Vec<u32>,
    dependencies: Vec<Dependency>,
    /// Where the further steps that each step waits for end.
    wait_ends: Vec<u32>,
    waits: Vec<u32>,
}

/// A run of triangles around a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Fan {
    ring_end: u32,
    dependency_end: u32,
}

/// Triangles of a fan that one step makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Dependency {
    creator: u32,
    /// Bit `j` for the triangle of the pivot, node `j` and the next node.
    mask: u32,
}

/// A fan as it is drawn: its nodes, and which of its arcs can be there.
#[derive(Clone, Copy, Debug)]
struct FanView<'f> {
    ring: &'f [u32],
    dependencies: &'f [Dependency],
}

impl Fans {
    fn empty(sequence: &CollapseSequence, group_count: usize) -> Self {
        Self {
            vertices: StepVertices::of_sequence(sequence).into_owned(),
            step_count: sequence.step_count(),
            entry_ends: Vec::with_capacity(sequence.positions().vertex_count()),
            fans: Vec::new(),
            group_count,
            fan_groups: Vec::new(),
            ring: Vec::new(),
            dependencies: Vec::new(),
            wait_ends: Vec::with_capacity(sequence.step_count()),
            waits: Vec::new(),
        }
    }

    /// Vertices of the full mesh.
    pub fn vertex_count(&self) -> usize {
        self.vertices.vertex_count
    }

    /// Vertices that a uniform level shows: the first so many.
    ///
    /// # Panics
    /// If `split_count` exceeds the step count.
    pub fn vertex_count_at(&self, split_count: usize) -> usize {
        self.vertices.count_at(split_count)
    }

    /// Groups of triangles.
    pub fn group_count(&self) -> usize {
        self.group_count
    }

    /// The fans of a vertex.
    fn entry(&self, vertex: usize) -> impl Iterator<Item = FanView<'_>> {
        self.entry_range(vertex).map(|fan| self.fan(fan))
    }

    fn entry_range(&self, vertex: usize) -> Range<usize> {
        let first = vertex.checked_sub(1).map_or(0, |before| self.entry_ends[before] as usize);
        first..self.entry_ends[vertex] as usize
    }

    /// The fans of a vertex that are of one group.
    fn entry_of_group(&self, vertex: usize, group: usize) -> impl Iterator<Item = FanView<'_>> {
        let range = self.entry_range(vertex);
        let range = if self.group_count == 1 {
            range
        } else {
            let groups = &self.fan_groups[range.clone()];
            let at = |group: usize| range.start + groups.partition_point(|&g| (g as usize) < group);
            at(group)..at(group + 1)
        };
        range.map(|fan| self.fan(fan))
    }

    fn fan(&self, fan: usize) -> FanView<'_> {
        let start = fan.checked_sub(1).map_or(Fan { ring_end: 0, dependency_end: 0 }, |i| self.fans[i]);
        let end = self.fans[fan];
        FanView {
            ring: &self.ring[start.ring_end as usize..end.ring_end as usize],
            dependencies: &self.dependencies[start.dependency_end as usize..end.dependency_end as usize],
        }
    }

    /// Further steps that a step waits for.
    fn waits(&self, step: usize) -> &[u32] {
        let first = step.checked_sub(1).map_or(0, |before| self.wait_ends[before] as usize);
        &self.waits[first..self.wait_ends[step] as usize]
    }

    /// Appends the triangles of one group that stand with a vertex; `is_taken` says which steps are collapsed.
    #[inline]
    fn triangles_of(&self, vertex: usize, group: usize, is_taken: impl Fn(u32) -> bool, out: &mut Vec<u32>) {
        for fan in self.entry_of_group(vertex, group) {
            fan.triangles_into(vertex as u32, fan.mask(&is_taken), out);
        }
    }
}

impl FanView<'_> {
    /// Which arcs are there.
    #[inline]
    fn mask(&self, is_taken: impl Fn(u32) -> bool) -> u32 {
        let there = |d: &Dependency| if d.creator == ALWAYS || is_taken(d.creator) { d.mask } else { 0 };
        self.dependencies.iter().fold(0, |mask, d| mask | there(d))
    }

    fn triangles_into(&self, pivot: u32, mut mask: u32, out: &mut Vec<u32>) {
        while mask != 0 {
            let at = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            out.extend([pivot, self.ring[at], self.ring[(at + 1) % self.ring.len()]]);
        }
    }
}

/// An instance at a uniform level: nothing but its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FansLevel {
    split_count: usize,
}

impl LodModel for Fans {
    type State = FansLevel;

    fn step_count(&self) -> usize {
        self.step_count
    }

    fn new_state(&self) -> FansLevel {
        FansLevel { split_count: self.step_count }
    }

    fn split_count(&self, state: &FansLevel) -> usize {
        state.split_count
    }

    fn move_to(&self, state: &mut FansLevel, split_count: usize) {
        assert!(split_count <= self.step_count, "split count {split_count} of {}", self.step_count);
        state.split_count = split_count;
    }

    fn topology(&self) -> Topology {
        Topology::Triangles
    }

    fn draw_counts(&self, state: &FansLevel) -> DrawCounts {
        let mut triangle_count = 0;
        for vertex in 0..self.vertex_count_at(state.split_count) {
            let masks = self.entry(vertex).map(|fan| fan.mask(|step| step as usize >= state.split_count));
            triangle_count += masks.map(|mask| mask.count_ones() as usize).sum::<usize>();
        }
        DrawCounts { strip_count: 0, index_count: 3 * triangle_count }
    }

    fn indices_into(&self, state: &FansLevel, out: &mut Vec<u32>) {
        for group in 0..self.group_count {
            for vertex in 0..self.vertex_count_at(state.split_count) {
                self.triangles_of(vertex, group, |step| step as usize >= state.split_count, out);
            }
        }
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        vec![
            part("targets", 4 * (self.vertices.targets.len() + self.vertices.firsts.len())),
            part("fans", 4 * (self.entry_ends.len() + self.fan_groups.len()) + size_of_val(&self.fans[..])),
            part("rings", 4 * self.ring.len()),
            part("dependencies", size_of_val(&self.dependencies[..])),
            part("waits", 4 * (self.wait_ends.len() + self.waits.len())),
        ]
    }

    fn state_bytes(&self, _: &FansLevel) -> usize {
        size_of::<FansLevel>()
    }

    /// Section 3.6.2 of \[Cor01\] without the data of criteria: a pointer and two counts a vertex, a word for each node of
    /// a ring, a word and as many bytes as its mask needs for each dependency.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let mask_bytes: usize = (0..self.fans.len())
            .map(|fan| self.fan(fan))
            .map(|fan| fan.dependencies.len() * fan.ring.len().div_ceil(8))
            .sum();
        let integers = 2 * self.vertex_count();
        let longs = self.vertex_count() + self.ring.len() + self.dependencies.len();
        accounting.bytes(integers, longs) + mask_bytes
    }
}
