//! Replays the steps of a cell to find the key and the error of each one, and the triangles that are left.

use super::rounding::{next_key, round_error, round_key};
use super::union::{BORDER, CellUnion};
use super::{CellMesh, History};
use crate::simplify::collapse::refinement_order::CollapseRecord;

/// End of a list of triangles.
const NONE: u32 = u32::MAX;

/// The state of a cell's triangles while its steps are replayed.
pub(super) struct CellTrace<'a> {
    union: &'a CellUnion,
    /// Current corners of every welded triangle, as vertices.
    pub corners: Vec<[u32; 3]>,
    pub is_alive: Vec<bool>,
    histories: Vec<History>,
    /// Largest error of each triangle's part of the cell's input, mesh units.
    input_errors: Vec<f32>,
    /// Largest error of each position's part of the input, mesh units, from the steps that it waits for.
    input_waits: Vec<f32>,
    /// Steps that each position waits for although they left no triangle at it.
    pub waits: Vec<History>,
    /// First corner (3 * triangle + index) in the list of each position.
    head: Vec<u32>,
    tail: Vec<u32>,
    /// Next corner in the same list.
    next: Vec<u32>,
    /// Key and error of each step.
    pub steps: Vec<History>,
    scratch: TraceScratch,
}

#[derive(Default)]
struct TraceScratch {
    star: Vec<u32>,
    /// Positions that keep a changed triangle, and positions that lose one.
    kept: Vec<u32>,
    lost: Vec<u32>,
}

/// The cost of a step, and the errors that it makes.
struct StepErrors {
    /// Cost of the collapse.
    pub cost: f32,
    /// Distance by which the step moves the surface, mesh units.
    pub own: f64,
    /// Largest distance of the surface in the cell from the cell's input.
    pub measured: f64,
}

impl<'a> CellTrace<'a> {
    pub(super) fn new(union: &'a CellUnion, inside: &CellMesh) -> Self {
        let position_count = union.welded.positions.position_count();
        let triangles = &union.welded.mesh.triangles;
        let history = |&t: &u32| {
            if t == BORDER { None } else { inside.histories.get(t as usize).copied() }.unwrap_or_default()
        };
        let histories: Vec<History> = union.inside_of.iter().map(history).collect();
        let mut trace = Self {
            union,
            corners: triangles.clone(),
            is_alive: vec![true; triangles.len()],
            input_errors: histories.iter().map(|history| history.error).collect(),
            histories,
            input_waits: vec![0.0; position_count],
            waits: vec![History::default(); position_count],
            head: vec![NONE; position_count],
            tail: vec![NONE; position_count],
            next: vec![NONE; 3 * triangles.len()],
            steps: Vec::new(),
            scratch: TraceScratch::default(),
        };
        for &(p, history) in &union.waits {
            trace.waits[p as usize] = trace.waits[p as usize].join(history);
            trace.input_waits[p as usize] = trace.input_waits[p as usize].max(history.error);
        }
        for (corner, &v) in (0..).zip(triangles.as_flattened()) {
            trace.link(union.welded.positions.position_of(v), corner);
        }
        trace
    }

    fn link(&mut self, p: u32, corner: u32) {
        match self.tail[p as usize] {
            NONE => self.head[p as usize] = corner,
            last => self.next[last as usize] = corner,
        }
        self.tail[p as usize] = corner;
    }

    /// Whether the error of each step is at most `limit`. A step that is depends only on steps that are, too.
    pub(super) fn within(&self, limit: f64) -> Vec<bool> {
        self.steps.iter().map(|step| f64::from(step.error) <= limit).collect()
    }

    /// Replays all steps. Targets are vertices of the union at positions within the cell.
    pub(super) fn run(&mut self, record: &CollapseRecord, targets: &[u32], scale: f64) {
        let CollapseRecord { removed, costs, errors, removed_triangle_counts: counts, .. } = record;
        for (i, (&v, cost)) in removed.iter().zip(costs).enumerate() {
            // A position that lost its last triangle by the step before has moved no surface itself.
            let own = if counts[i] == 0 { 0.0 } else { f64::from(cost.distance_squared).sqrt() * scale };
            self.step(v, targets, StepErrors { cost: cost.cost, own, measured: f64::from(errors[i]) });
        }
    }

    /// Removes position `v`; the step has this cost and moves the surface by `own` mesh units. Nowhere in the cell
    /// is the surface then farther than `measured` from the cell's input.
    ///
    /// The error is the lesser of two estimates, neither of which falls from one step to those that depend on it. One
    /// adds up the steps below this one, as if their errors were independent, and is too large where they cancel out.
    /// The other takes the largest distance in the whole cell, and is too large where that is somewhere else.
    fn step(&mut self, v: u32, targets: &[u32], StepErrors { cost, own, measured }: StepErrors) {
        let positions = &self.union.welded.positions;
        let mut scratch = std::mem::take(&mut self.scratch);
        scratch.star.clear();
        let mut corner = self.head[v as usize];
        while corner != NONE {
            if self.is_alive[corner as usize / 3] {
                scratch.star.push(corner);
            }
            corner = self.next[corner as usize];
        }
        let before = std::mem::take(&mut self.waits[v as usize]);
        let star = || scratch.star.iter().map(|&c| c as usize / 3);
        let history = star().map(|t| self.histories[t]).fold(before, History::join);
        let input_error = star().map(|t| self.input_errors[t]).fold(self.input_waits[v as usize], f32::max);
        // Also larger than 0, which means that there is no step.
        let key = round_key(cost).max(next_key(history.key));
        let sum = |own: f64, below: f32| own * own + f64::from(below).powi(2);
        let error = sum(own, history.error).min(sum(measured, input_error));
        let error = round_error(error.sqrt() as f32).max(history.error);
        let step = History { key, error };
        self.steps.push(step);
        let u = positions.position_of(targets[positions.first_vertex(v) as usize]);
        scratch.kept.clear();
        scratch.lost.clear();
        scratch.lost.push(u);
        for &c in &scratch.star {
            let t = c as usize / 3;
            self.corners[t][c as usize % 3] = targets[self.corners[t][c as usize % 3] as usize];
            let at = self.corners[t].map(|w| positions.position_of(w));
            if at.iter().filter(|&&p| p == u).count() > 1 {
                self.is_alive[t] = false;
                scratch.lost.extend(at);
            } else {
                self.histories[t] = step;
                self.input_errors[t] = input_error;
                scratch.kept.extend(at);
            }
        }
        // The next links of corners are read above, so they may change only now.
        for &c in &scratch.star {
            if self.is_alive[c as usize / 3] {
                self.next[c as usize] = NONE;
                self.link(u, c);
            }
        }
        for &p in scratch.lost.iter().filter(|p| !scratch.kept.contains(p)) {
            self.waits[p as usize] = self.waits[p as usize].join(step);
            self.input_waits[p as usize] = self.input_waits[p as usize].max(input_error);
        }
        self.scratch = scratch;
    }

    /// History of a welded triangle.
    pub(super) fn history(&self, triangle: usize) -> History {
        self.histories[triangle]
    }
}
