//! What one instance of skip strips owns, and how it moves between levels.

use super::SkipStrips;
use crate::baseline::repetitions::write_filtered;

/// An instance: its level and its display strips. Made by [`LodModel::new_state`](striata::model::LodModel).
///
/// States are equal where they stand at the same level and show the same strips.
#[derive(Clone, Debug)]
pub struct SkipStripsState {
    pub(super) split_count: usize,
    /// Display strips in slots as long as the strips of the full mesh.
    display: Vec<u32>,
    /// First index of each slot and its length now.
    strips: Vec<DisplayStrip>,
    /// Strips to be made anew, each once; empty between moves.
    marked: Vec<u32>,
    /// The vertex that each node of a strip stands for now; empty between moves.
    standing: Vec<u32>,
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
        let strip = |strip: usize| DisplayStrip {
            first: model.strips[strip].first_place,
            length: 0,
            is_marked: true,
        };
        let mut state = Self {
            split_count: model.vertices.step_count(),
            display: vec![0; model.places.len()],
            strips: (0..strip_count).map(strip).collect(),
            marked: (0..strip_count as u32).collect(),
            standing: Vec::new(),
        };
        state.make_marked(model);
        state
    }

    /// Bytes that the instance owns.
    pub(super) fn bytes(&self) -> usize {
        4 * (self.display.len() + self.marked.capacity() + self.standing.capacity())
            + size_of_val(&self.strips[..])
    }

    /// What a strip shows now; empty where it has no triangle left.
    pub(super) fn shown(&self, strip: usize) -> &[u32] {
        let DisplayStrip { first, length, .. } = self.strips[strip];
        &self.display[first as usize..(first + length) as usize]
    }

    pub(super) fn move_to(&mut self, model: &SkipStrips, split_count: usize) {
        let step_count = model.vertices.step_count();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        assert!(
            self.display.len() == model.places.len() && self.strips.len() == model.strip_count(),
            "the state belongs to another model"
        );
        let [start, end] = [self.split_count.min(split_count), self.split_count.max(split_count)]
            .map(|step| model.step_offsets[step] as usize);
        // The strips of neighboring steps are neighbors: those of all steps in between are one run.
        for &strip in &model.affected_strips[start..end] {
            if !std::mem::replace(&mut self.strips[strip as usize].is_marked, true) {
                self.marked.push(strip);
            }
        }
        self.split_count = split_count;
        self.make_marked(model);
    }

    fn make_marked(&mut self, model: &SkipStrips) {
        let vertex_count = model.vertices.count_at(self.split_count) as u32;
        let mut marked = std::mem::take(&mut self.marked);
        for strip in marked.drain(..) {
            self.make(model, strip as usize, vertex_count);
        }
        self.marked = marked;
        self.standing.clear();
    }

    /// Makes a display strip: each place climbs to the first active vertex.
    ///
    /// Places that share a chain of parents would climb it again and again. Parents stand before their children, so
    /// one pass over the inactive nodes takes each of them to its end.
    fn make(&mut self, model: &SkipStrips, strip: usize, vertex_count: u32) {
        let display = &mut self.strips[strip];
        display.is_marked = false;
        if (self.split_count as u64) < u64::from(model.strips[strip].drawn_from) {
            display.length = 0;
            return;
        }
        let nodes = model.nodes(strip);
        let vertices = &model.node_vertices[nodes.clone()];
        let active_count = vertices.partition_point(|&vertex| vertex < vertex_count);
        let standing = &mut self.standing;
        standing.clear();
        standing.extend_from_slice(&vertices[..active_count]);
        standing.resize(vertices.len(), 0);
        for (node, &parent) in model.node_parents[nodes].iter().enumerate().skip(active_count) {
            standing[node] = standing[parent as usize];
        }
        let places = model.places(strip);
        let slot = &mut self.display[places.clone()];
        let standing = &standing[..];
        let shown = model.places[places].iter().map(|&node| standing[node as usize]);
        display.length = write_filtered(shown, slot) as u32;
    }
}
