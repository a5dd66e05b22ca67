//! A triangle list that is kept from frame to frame, of which only what changes is written again.
//!
//! The list is the same as the one that [`FanInstance::emit_into`] writes: the triangles of each active vertex, in
//! order. It is divided into blocks of a few steps. A step that changes affects its own triangles and those of its
//! floor, which are stored with a few vertices around it; only the blocks of these are written again. Everything
//! else is moved to its new place, most of it in long runs.
//!
//! ```text
//! old   | run of unchanged blocks | block | run | block |  run   |
//! new   | run of unchanged blocks | block.. | run | bl |  run   |
//! ```
//!
//! Cost: besides the indices, an instance keeps one bit per step, and four bytes per block of 8 steps. A frame
//! scans one 64-bit word per 64 steps, writes the blocks that change, and moves the rest.

use std::ops::Range;

use super::emit::{GroupOutputs, IndexSink, Span, write_triangles};
use super::{FanInstance, Fans};
use crate::model::step_bits::StepBits;

/// Number of steps or base vertices of a block, if there is one group.
const BLOCK: u32 = 8;

/// If more than one in this many blocks changes, all blocks are written again.
const MIN_BLOCKS_PER_CHANGE: usize = 2;

/// Scratch memory is kept only if it takes at most the size of the indices divided by this.
const MAX_SCRATCH_SHARE: usize = 4;

/// All triangles that an instance shows, sorted by group.
#[derive(Clone, Debug)]
pub struct FanTriangles {
    shown: FanInstance,
    indices: Vec<u32>,
    group_ranges: Vec<Range<u32>>,
    blocks: TableBlocks,
    /// For each group, the first index of each block; then the number of indices.
    starts: Vec<u32>,
    changed: StepBits,
    /// Scratch for the triangles of changed blocks, by group.
    sinks: Vec<IndexSink>,
    /// Scratch for what moves.
    pieces: Vec<ChangedBlock>,
    moves: Vec<RunMove>,
}

/// The division of a table into blocks: those of base vertices, then those of steps.
#[derive(Clone, Copy, Debug)]
struct TableBlocks {
    /// Steps or base vertices of a block.
    size: u32,
    base_vertex_count: u32,
    base_count: u32,
    step_count: u32,
    count: u32,
    group_count: usize,
}

/// A changed block of a group, and its new indices.
#[derive(Clone, Copy, Debug)]
struct ChangedBlock {
    /// Place of the block in `starts`.
    at: u32,
    /// Its new indices in the sink of the group.
    source: u32,
    len: u32,
}

/// A run of indices that moves.
#[derive(Clone, Copy, Debug)]
struct RunMove {
    from: u32,
    to: u32,
    len: u32,
}

impl TableBlocks {
    fn of(fans: &Fans) -> Self {
        // Larger blocks with more groups, so that the memory for all groups together stays the same.
        let size = BLOCK * (fans.group_count as u32).next_power_of_two();
        let (base_vertex_count, step_count) = (fans.vertices.base_vertex_count, fans.step_count as u32);
        let base_count = base_vertex_count.div_ceil(size);
        let count = base_count + step_count.div_ceil(size);
        Self { size, base_vertex_count, base_count, step_count, count, group_count: fans.group_count }
    }

    /// Returns the block of a vertex.
    #[inline]
    fn of_vertex(&self, fans: &Fans, vertex: u32) -> u32 {
        if vertex < self.base_vertex_count {
            vertex / self.size
        } else {
            self.of_step(fans.quick().step_of(vertex, self.base_vertex_count))
        }
    }

    #[inline]
    fn of_step(&self, step: u32) -> u32 {
        self.base_count + step / self.size
    }

    /// Returns the base vertices and steps of some blocks.
    fn span(&self, blocks: Range<u32>) -> Span {
        let base = |block: u32| (block.min(self.base_count) * self.size).min(self.base_vertex_count);
        let step = |block: u32| (block.saturating_sub(self.base_count) * self.size).min(self.step_count);
        Span { base: base(blocks.start)..base(blocks.end), steps: step(blocks.start)..step(blocks.end) }
    }
}

impl FanTriangles {
    /// Creates the list of an instance's triangles.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn new(fans: &Fans, instance: &FanInstance) -> Self {
        instance.check_table(fans);
        let blocks = TableBlocks::of(fans);
        let mut triangles = Self {
            shown: instance.clone(),
            indices: Vec::new(),
            group_ranges: vec![0..0; blocks.group_count],
            blocks,
            starts: vec![0; blocks.count as usize * blocks.group_count + 1],
            changed: StepBits::none(blocks.count as usize),
            sinks: vec![IndexSink::default(); blocks.group_count],
            pieces: Vec::new(),
            moves: Vec::new(),
        };
        triangles.write_all(fans);
        triangles.find_groups();
        triangles
    }

    /// Returns all indices, three per triangle, sorted by group: those that
    /// [`FanInstance::emit_into`] writes.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }

    /// Returns the range of [`indices`](Self::indices) of each group; a mesh without groups has one range.
    pub fn group_ranges(&self) -> &[Range<u32>] {
        &self.group_ranges
    }

    /// Returns the triangles of a group.
    ///
    /// # Panics
    /// If the group does not exist.
    pub fn triangles(&self, group: usize) -> &[[u32; 3]] {
        let Range { start, end } = self.group_ranges[group];
        self.indices[start as usize..end as usize].as_chunks().0
    }

    /// Returns the instance whose triangles the list contains.
    pub fn shown(&self) -> &FanInstance {
        &self.shown
    }

    /// Number of bytes owned, without the indices themselves.
    pub fn bytes(&self) -> usize {
        self.shown.bytes()
            + size_of_val(&self.starts[..])
            + self.changed.bytes()
            + self.sinks.iter().map(IndexSink::bytes).sum::<usize>()
            + size_of::<ChangedBlock>() * self.pieces.capacity()
            + size_of::<RunMove>() * self.moves.capacity()
    }

    /// Updates the list to another instance; returns the number of steps that differ.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn follow(&mut self, fans: &Fans, instance: &FanInstance) -> usize {
        instance.check_table(fans);
        self.shown.check_table(fans);
        let mut count = 0;
        for at in 0..instance.words().len() {
            let mut steps = self.shown.words()[at] ^ instance.words()[at];
            while steps != 0 {
                let step = 64 * at as u32 + steps.trailing_zeros();
                steps &= steps - 1;
                count += 1;
                self.mark(fans, step);
            }
        }
        if count > 0 {
            self.shown.clone_from(instance);
            if MIN_BLOCKS_PER_CHANGE * self.changed.count() > self.blocks.count as usize {
                self.write_all(fans);
            } else {
                self.write_changed(fans);
            }
            self.changed.set_range(0..0);
            self.release_scratch();
            self.find_groups();
        }
        count
    }

    fn find_groups(&mut self) {
        let count = self.blocks.count as usize;
        for (group, range) in self.group_ranges.iter_mut().enumerate() {
            *range = self.starts[group * count]..self.starts[(group + 1) * count];
        }
    }

    /// Releases the memory that only a large change has needed.
    fn release_scratch(&mut self) {
        let limit = self.indices.len() / MAX_SCRATCH_SHARE;
        if self.sinks.iter().map(IndexSink::bytes).sum::<usize>() > 4 * limit {
            self.sinks.iter_mut().for_each(|sink| *sink = IndexSink::default());
        }
    }

    /// Marks the blocks of all vertices whose triangles change with a step.
    fn mark(&mut self, fans: &Fans, step: u32) {
        let Self { blocks, changed, .. } = self;
        changed.insert(blocks.of_step(step));
        let first = fans.vertices.of_step(step as usize).start;
        fans.quick().for_each_floor_owner(step, first, |owner| changed.insert(blocks.of_vertex(fans, owner)));
    }

    /// Writes all blocks.
    fn write_all(&mut self, fans: &Fans) {
        let count = self.blocks.count as usize;
        // The first group is written to its place.
        self.sinks[0] = IndexSink::new(std::mem::take(&mut self.indices), 0);
        self.sinks[1..].iter_mut().for_each(IndexSink::restart);
        for block in 0..count {
            for (group, sink) in self.sinks.iter().enumerate() {
                self.starts[group * count + block] = sink.len() as u32;
            }
            let span = self.blocks.span(block as u32..block as u32 + 1);
            write_triangles(fans, &self.shown, span, &mut GroupOutputs::new(&mut self.sinks));
        }
        self.indices = std::mem::take(&mut self.sinks[0]).into_indices();
        for group in 1..self.sinks.len() {
            let first = self.indices.len() as u32;
            self.starts[group * count..][..count].iter_mut().for_each(|start| *start += first);
            self.indices.extend_from_slice(self.sinks[group].indices());
        }
        self.starts[self.sinks.len() * count] = self.indices.len() as u32;
    }

    /// Writes the changed blocks, and moves everything between them.
    fn write_changed(&mut self, fans: &Fans) {
        self.find_pieces(fans);
        let total = self.place_pieces();
        self.indices.resize(self.indices.len().max(total as usize), 0);
        let (indices, moves) = (&mut self.indices, &self.moves);
        let mut apply = |run: &RunMove| {
            let RunMove { from, to, len } = *run;
            indices.copy_within(from as usize..(from + len) as usize, to as usize);
        };
        // Runs that move toward the start cannot overwrite a run before them that moves toward the end, and the
        // other way round.
        moves.iter().filter(|run| run.to < run.from).for_each(&mut apply);
        moves.iter().rev().filter(|run| run.to > run.from).for_each(&mut apply);
        self.indices.truncate(total as usize);
        let count = self.blocks.count;
        for &ChangedBlock { at, source, len } in &self.pieces {
            let new = &self.sinks[(at / count) as usize].indices()[source as usize..(source + len) as usize];
            self.indices[self.starts[at as usize] as usize..][..len as usize].copy_from_slice(new);
        }
    }

    /// Writes the changed blocks to the sinks and lists them, group by group.
    fn find_pieces(&mut self, fans: &Fans) {
        let count = self.blocks.count;
        self.sinks.iter_mut().for_each(IndexSink::restart);
        self.pieces.clear();
        let mut next = 0;
        while let Some(block) = self.changed.first_from(next) {
            next = block + 1;
            let firsts = self.pieces.len();
            for (at, sink) in (block..).step_by(count as usize).zip(&self.sinks) {
                self.pieces.push(ChangedBlock { at, source: sink.len() as u32, len: 0 });
            }
            let span = self.blocks.span(block..next);
            write_triangles(fans, &self.shown, span, &mut GroupOutputs::new(&mut self.sinks));
            for (piece, sink) in self.pieces[firsts..].iter_mut().zip(&self.sinks) {
                piece.len = sink.len() as u32 - piece.source;
            }
        }
        if self.sinks.len() > 1 {
            self.pieces.sort_unstable_by_key(|piece| piece.at);
        }
    }

    /// Finds the new places of all blocks and lists the runs that move. Returns the new number of indices.
    fn place_pieces(&mut self) -> u32 {
        self.moves.clear();
        let (mut from, mut to, mut at) = (0, 0, 0);
        let end = self.starts.len() - 1;
        let pieces = self.pieces.iter().map(|piece| (piece.at as usize, piece.len));
        for (piece, new_len) in pieces.chain([(end, 0)]) {
            // Up to the start of this piece, everything moves as far.
            let (old_start, old_end) = (self.starts[piece], self.starts[(piece + 1).min(end)]);
            let run = RunMove { from, to, len: old_start - from };
            if run.len > 0 && run.from != run.to {
                self.moves.push(run);
            }
            let shift = to.wrapping_sub(from);
            self.starts[at..=piece].iter_mut().for_each(|start| *start = start.wrapping_add(shift));
            (from, to, at) = (old_end, to + run.len + new_len, piece + 1);
        }
        to
    }
}
