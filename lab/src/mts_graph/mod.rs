//! MTS as published \[BRR02\]: each strip with all its levels is a graph of its vertices.
//!
//! Each vertex that a strip ever shows is a column. The row of a column lists its possible successors,
//! each with the coarsest level (`res`) at which it is the successor. Recovery starts at the first
//! beginning whose `res` reaches the level, then goes from column to column, always following the next arc
//! of the row whose `res` reaches the level. Each column keeps how far its row has been read, because a
//! strip may pass a vertex several times.
//!
//! ```text
//! begins     0 (res 0), 1 (res 4)
//! column 2   3 (res 2), 4 (res 3), 6 (res 4)         levels 0..=2 go to 3, level 3 to 4, level 4 to 6
//! column 4   5 (res 1), 3 (res 2), -1 (res 3), 6 (res 3)
//! ```
//!
//! Only the coarse end of an arc's range of levels is stored, so the order of a row has to ensure that the
//! first arc that reaches a level is the right one. Rows are therefore built from the coarsest level to
//! the finest: the arcs of each level are put first, and those of coarser levels keep their order among
//! and behind them.
//!
//! Levels count as in the paper, 0 the finest. Differs: arrays instead of pointers.
//! [`Mts`](striata::model::Mts) implements the same idea without the data that is stored twice here.
//!
//! Cost: a move recovers every strip, in time linear in the indices shown.

mod build;

use striata::model::{DrawCounts, LodModel, PartBytes, Topology};
use striata::strip::RESTART;

use crate::paper_bytes::{Accounting, PaperBytes};

/// Special node: the strip ends, and the next one begins with the same vertex.
const SAME_VERTEX: i32 = -1;
/// Special node: the strip ends, and the next one begins with the column that follows in the row.
const NEW_VERTEX: i32 = -2;
/// Special node: the strip ends, and no other follows.
const END: i32 = -3;

/// An arc of a row, or a beginning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct RowNode {
    /// A column of the same strip, or one of the special nodes.
    column: i32,
    /// The coarsest level at which the arc applies.
    res: u32,
}

impl RowNode {
    fn arc(&self) -> MtsArc {
        let node = match self.column {
            SAME_VERTEX => MtsNode::SameVertex,
            NEW_VERTEX => MtsNode::NewVertex,
            END => MtsNode::End,
            column => MtsNode::Column(column as usize),
        };
        MtsArc { node, res: self.res }
    }
}

/// Offsets of one strip's beginnings and columns; the list has one more entry at its end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct StripNode {
    first_begin: u32,
    first_column: u32,
}

/// The static half of the model; see the [module](self).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct MtsGraph {
    step_count: usize,
    strips: Vec<StripNode>,
    begins: Vec<RowNode>,
    /// Vertex of each column.
    vertices: Vec<u32>,
    /// First arc of each column, followed by the total number of arcs.
    first_rows: Vec<u32>,
    rows: Vec<RowNode>,
}

/// Destination of an arc of the graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MtsNode {
    /// A column of the same strip.
    Column(usize),
    /// The next strip, which begins with the same vertex.
    SameVertex,
    /// The next strip, which begins with the column that follows in the row.
    NewVertex,
    /// The end of the last strip.
    End,
}

/// An arc of the graph, or a beginning of a strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MtsArc {
    /// Destination of the arc.
    pub node: MtsNode,
    /// The coarsest level at which the arc applies; 0 is the finest.
    pub res: u32,
}

/// State of one instance: its level and the strips it shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MtsGraphState {
    split_count: usize,
    /// Read position in the row of each column.
    current: Vec<u32>,
    indices: Vec<u32>,
    strip_count: usize,
}

impl MtsGraph {
    /// Number of strips, including those that vanish at coarse levels.
    pub fn strip_count(&self) -> usize {
        self.strips.len().saturating_sub(1)
    }

    /// Returns the beginnings of a strip, from fine to coarse.
    ///
    /// # Panics
    /// If there is no such strip.
    pub fn begins(&self, strip: usize) -> impl Iterator<Item = MtsArc> + '_ {
        let [head, end] = [self.strips[strip], self.strips[strip + 1]];
        self.begins[head.first_begin as usize..end.first_begin as usize].iter().map(RowNode::arc)
    }

    /// Returns the columns of a strip: each vertex with its row of arcs.
    ///
    /// # Panics
    /// If there is no such strip.
    pub fn columns(&self, strip: usize) -> impl Iterator<Item = (u32, Vec<MtsArc>)> + '_ {
        let [head, end] = [self.strips[strip], self.strips[strip + 1]];
        (head.first_column as usize..end.first_column as usize).map(|column| {
            let row = self.first_rows[column] as usize..self.first_rows[column + 1] as usize;
            (self.vertices[column], self.rows[row].iter().map(RowNode::arc).collect())
        })
    }

    /// Returns the indices of one strip at a level, 0 the finest, with restarts between its pieces.
    ///
    /// # Panics
    /// If there is no such strip.
    pub fn strip_at(&self, strip: usize, level: u32) -> Vec<u32> {
        let mut indices = Vec::new();
        self.recover_strip(strip, level, &mut vec![0; self.vertices.len()], &mut indices);
        indices
    }

    /// Appends one strip at a level (listing 2 of the paper) and returns the number of pieces it has
    /// there. `current` covers all columns and is zero for those of this strip.
    fn recover_strip(&self, strip: usize, level: u32, current: &mut [u32], out: &mut Vec<u32>) -> usize {
        let [head, end] = [self.strips[strip], self.strips[strip + 1]];
        let begins = &self.begins[head.first_begin as usize..end.first_begin as usize];
        let Some(begin) = begins.iter().find(|begin| begin.res >= level) else {
            // The strip is gone at this level.
            return 0;
        };
        let mut next_of = |column: usize| {
            let row = &self.rows[self.first_rows[column] as usize..self.first_rows[column + 1] as usize];
            let read = &mut current[column];
            while row[*read as usize].res < level {
                *read += 1;
            }
            *read += 1;
            row[*read as usize - 1].column
        };
        let first_column = head.first_column as usize;
        let mut strip_count = 1;
        let mut column = first_column + begin.column as usize;
        loop {
            out.push(self.vertices[column]);
            match next_of(column) {
                END => return strip_count,
                SAME_VERTEX => {
                    out.push(RESTART);
                    out.push(self.vertices[column]);
                    strip_count += 1;
                    column = first_column + next_of(column) as usize;
                }
                NEW_VERTEX => {
                    out.push(RESTART);
                    strip_count += 1;
                    column = first_column + next_of(column) as usize;
                }
                next => column = first_column + next as usize,
            }
        }
    }
}

impl MtsGraphState {
    /// Indices to draw: strips with restarts between them.
    pub fn indices(&self) -> &[u32] {
        &self.indices
    }
}

impl LodModel for MtsGraph {
    type State = MtsGraphState;

    fn step_count(&self) -> usize {
        self.step_count
    }

    fn new_state(&self) -> MtsGraphState {
        let current = vec![0; self.vertices.len()];
        let mut state =
            MtsGraphState { split_count: self.step_count, current, indices: Vec::new(), strip_count: 0 };
        self.move_to(&mut state, self.step_count);
        state
    }

    fn split_count(&self, state: &MtsGraphState) -> usize {
        state.split_count
    }

    /// Recovers every strip, regardless of the previous level: the published model has no coherence.
    fn move_to(&self, state: &mut MtsGraphState, split_count: usize) {
        assert!(split_count <= self.step_count, "split count {split_count} of {}", self.step_count);
        assert_eq!(state.current.len(), self.vertices.len(), "the state belongs to another model");
        state.split_count = split_count;
        state.current.fill(0);
        state.indices.clear();
        state.strip_count = 0;
        let level = (self.step_count - split_count) as u32;
        for strip in 0..self.strip_count() {
            let length = state.indices.len();
            if length > 0 {
                state.indices.push(RESTART);
            }
            let count = self.recover_strip(strip, level, &mut state.current, &mut state.indices);
            state.strip_count += count;
            if count == 0 {
                state.indices.truncate(length);
            }
        }
    }

    fn topology(&self) -> Topology {
        Topology::Strips
    }

    fn draw_counts(&self, state: &MtsGraphState) -> DrawCounts {
        DrawCounts { strip_count: state.strip_count, index_count: state.indices.len() }
    }

    fn indices_into(&self, state: &MtsGraphState, out: &mut Vec<u32>) {
        out.extend_from_slice(&state.indices);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let part = |name, bytes| PartBytes { name, bytes };
        vec![
            part("strips", size_of_val(&self.strips[..])),
            part("beginnings", size_of_val(&self.begins[..])),
            part("columns", 4 * (self.vertices.len() + self.first_rows.len())),
            part("rows", size_of_val(&self.rows[..])),
        ]
    }

    fn state_bytes(&self, state: &MtsGraphState) -> usize {
        4 * (state.current.len() + state.indices.capacity())
    }
}

impl PaperBytes for MtsGraph {
    /// Listing 1 of the paper: a long vertex, an integer and a pointer per column; an integer and a long
    /// `res` per arc or beginning; two pointers per strip.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let (columns, arcs) = (self.vertices.len(), self.rows.len() + self.begins.len());
        accounting.bytes(columns + arcs, 2 * columns + arcs + 2 * self.strip_count())
    }
}
