//! State of one instance of skip strips, and how it moves between levels.

use super::SkipStrips;
use crate::baseline::repetitions::write_filtered;

/// State of one instance: its level and its display strips. Created by
/// [`LodModel::new_state`](striata::model::LodModel).
///
/// States are equal if they are at the same level and show the same strips.
#[derive(Clone, Debug)]
pub struct SkipStripsState {
    /// Number of steps that are split.
    pub split_count: usize,
    /// Display strips, each in a buffer as long as its strip of the full mesh.
    display: Vec<u32>,
    /// First index and current length of each buffer.
    strips: Vec<DisplayStrip>,
    /// Strips to rebuild, without duplicates; empty between moves.
    marked: Vec<u32>,
    /// The active vertex for each node of the strip being rebuilt; empty between moves.
    active: Vec<u32>,
}

#[derive(Clone, Copy, Debug)]
struct DisplayStrip {
    first: u32,
    length: u32,
    is_marked: bool,
}

impl PartialEq for SkipStripsState {
    fn eq(&self, other: &Self) -> bool {
        self.split_count == other.split_count
            && self.strips.len() == other.strips.len()
            && (0..self.strips.len()).all(|strip| self.shown(strip) == other.shown(strip))
    }
}

impl Eq for SkipStripsState {}

impl SkipStripsState {
    pub(super) fn new(model: &SkipStrips) -> Self {
        let strip_count = model.strip_count();
        let strip =
            |strip: usize| DisplayStrip { first: model.strips[strip].first_slot, length: 0, is_marked: true };
        let mut state = Self {
            split_count: model.vertices.step_count(),
            display: vec![0; model.slots.len()],
            strips: (0..strip_count).map(strip).collect(),
            marked: (0..strip_count as u32).collect(),
            active: Vec::new(),
        };
        state.rebuild_marked(model);
        state
    }

    /// Bytes owned by the instance.
    pub(super) fn bytes(&self) -> usize {
        4 * (self.display.len() + self.marked.capacity() + self.active.capacity())
            + size_of_val(&self.strips[..])
    }

    /// The current indices of a strip; empty if it has no triangle left.
    pub(super) fn shown(&self, strip: usize) -> &[u32] {
        let DisplayStrip { first, length, .. } = self.strips[strip];
        &self.display[first as usize..(first + length) as usize]
    }

    pub(super) fn move_to(&mut self, model: &SkipStrips, split_count: usize) {
        let step_count = model.vertices.step_count();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        assert!(
            self.display.len() == model.slots.len() && self.strips.len() == model.strip_count(),
            "the state belongs to another model"
        );
        let [start, end] = [self.split_count.min(split_count), self.split_count.max(split_count)]
            .map(|step| model.step_offsets[step] as usize);
        // The affected strips are stored by step, so those of all steps in between form one range.
        for &strip in &model.affected_strips[start..end] {
            if !std::mem::replace(&mut self.strips[strip as usize].is_marked, true) {
                self.marked.push(strip);
            }
        }
        self.split_count = split_count;
        self.rebuild_marked(model);
    }

    fn rebuild_marked(&mut self, model: &SkipStrips) {
        let vertex_count = model.vertices.count_at(self.split_count) as u32;
        let mut marked = std::mem::take(&mut self.marked);
        for strip in marked.drain(..) {
            self.rebuild(model, strip as usize, vertex_count);
        }
        self.marked = marked;
        self.active.clear();
    }

    /// Rebuilds a display strip: each slot climbs to its first active vertex.
    ///
    /// Climbing from every slot would walk shared chains of parents repeatedly. Since parents precede
    /// their children, one pass over the inactive nodes resolves all of them.
    fn rebuild(&mut self, model: &SkipStrips, strip: usize, vertex_count: u32) {
        let display = &mut self.strips[strip];
        display.is_marked = false;
        if (self.split_count as u64) < u64::from(model.strips[strip].drawn_from) {
            display.length = 0;
            return;
        }
        let nodes = model.nodes(strip);
        let vertices = &model.node_vertices[nodes.clone()];
        let active_count = vertices.partition_point(|&vertex| vertex < vertex_count);
        let active = &mut self.active;
        active.clear();
        active.extend_from_slice(&vertices[..active_count]);
        active.resize(vertices.len(), 0);
        for (node, &parent) in model.node_parents[nodes].iter().enumerate().skip(active_count) {
            active[node] = active[parent as usize];
        }
        let slots = model.slots(strip);
        let buffer = &mut self.display[slots.clone()];
        let active = &active[..];
        let shown = model.slots[slots].iter().map(|&node| active[node as usize]);
        display.length = write_filtered(shown, buffer) as u32;
    }
}
