//! Builds the graph of each strip from its index sequences at all levels.

use striata::mesh::RefinableMesh;
use striata::model::strip_history::{Piece, StripHistory};
use striata::model::{ModelError, check_strips};
use striata::strip::StripSet;

use super::{END, MtsGraph, NEW_VERTEX, RowNode, SAME_VERTEX, StripNode};

impl MtsGraph {
    /// Builds the model from strips of the full mesh, which are used unchanged. To compare it with
    /// [`Mts`](striata::model::Mts), [cut](StripSet::cut) them as that model does.
    ///
    /// # Errors
    /// [`ModelError`] if the strips do not match the mesh.
    pub fn build(refinable: &RefinableMesh, strips: &StripSet) -> Result<Self, ModelError> {
        check_strips(&refinable.mesh, strips)?;
        let sequence = &refinable.sequence;
        let step_count = sequence.step_count();
        let mut graph = Self { step_count, ..Self::default() };
        let mut builder = StripBuilder::new(refinable.mesh.vertex_count());
        for strip in strips.strips() {
            let mut history = StripHistory::new(sequence, strip);
            builder.clear();
            builder.push_level(history.pieces(), 0);
            while let Some(touch) = history.coarsen() {
                builder.push_level(history.pieces(), step_count as u32 - touch.step);
            }
            builder.write(step_count as u32, &mut graph);
            graph.check_size()?;
        }
        graph.close();
        Ok(graph)
    }

    /// Checks that columns and arcs can be indexed with 32 bits. Checking after each strip is enough: one
    /// strip adds far less than the headroom between this limit and the machine's memory.
    fn check_size(&self) -> Result<(), ModelError> {
        let limit = u64::from(u32::MAX);
        match self.rows.len().max(self.vertices.len()) as u64 {
            found if found > limit => Err(ModelError::TooMany { what: "arcs or columns", found, limit }),
            _ => Ok(()),
        }
    }

    fn close(&mut self) {
        self.first_rows.push(self.rows.len() as u32);
        self.strips.push(StripNode {
            first_begin: self.begins.len() as u32,
            first_column: self.vertices.len() as u32,
        });
    }
}

/// The index sequences of one strip and the rows built from them; reused from strip to strip.
#[derive(Debug, Default)]
struct StripBuilder {
    /// Vertices and special nodes of all sequences in a row, each including its end node.
    nodes: Vec<i32>,
    /// First level of each sequence and the offset of its nodes.
    levels: Vec<(u32, usize)>,
    /// Column of each vertex that is in `columns`.
    column_of: Vec<u32>,
    /// Vertex of each column.
    columns: Vec<u32>,
    begins: Vec<RowNode>,
    /// Row of each column, its first arc last.
    rows: Vec<Vec<RowNode>>,
    /// The nodes that the current sequence adds to each row.
    nexts: Vec<Vec<i32>>,
    /// Columns to which the current sequence adds nodes.
    visited: Vec<u32>,
}

impl StripBuilder {
    fn new(vertex_count: usize) -> Self {
        Self { column_of: vec![u32::MAX; vertex_count], ..Self::default() }
    }

    fn clear(&mut self) {
        self.nodes.clear();
        self.levels.clear();
        for &vertex in &self.columns {
            self.column_of[vertex as usize] = u32::MAX;
        }
        self.columns.clear();
        self.begins.clear();
        self.rows.clear();
    }

    /// Appends the sequence that the strip shows from `level` on.
    fn push_level(&mut self, pieces: &[Piece], level: u32) {
        self.levels.push((level, self.nodes.len()));
        for (i, piece) in pieces.iter().enumerate() {
            let mut vertices = &piece.vertices[..];
            if let Some(before) = i.checked_sub(1) {
                let is_same = pieces[before].vertices.last() == vertices.first();
                self.nodes.push(if is_same { SAME_VERTEX } else { NEW_VERTEX });
                // The shared vertex is not repeated.
                vertices = &vertices[usize::from(is_same)..];
            }
            self.nodes.extend(vertices.iter().map(|&v| v as i32));
        }
        self.nodes.push(END);
    }

    /// Builds the rows, coarsest level first, and appends the strip to the graph.
    fn write(&mut self, coarsest: u32, graph: &mut MtsGraph) {
        self.number_columns();
        let mut res = coarsest;
        let mut end = self.nodes.len();
        for i in (0..self.levels.len()).rev() {
            let (level, start) = self.levels[i];
            self.add_level(start..end, res);
            // Levels without a sequence of their own belong to the next finer sequence, which ends just
            // before this one.
            res = level.saturating_sub(1);
            end = start;
        }
        graph.strips.push(StripNode {
            first_begin: graph.begins.len() as u32,
            first_column: graph.vertices.len() as u32,
        });
        graph.begins.extend(self.begins.iter().rev());
        for (&vertex, row) in self.columns.iter().zip(&self.rows) {
            graph.vertices.push(vertex);
            graph.first_rows.push(graph.rows.len() as u32);
            graph.rows.extend(row.iter().rev());
        }
    }

    /// Numbers the vertices in the order in which they first appear, finest level first.
    fn number_columns(&mut self) {
        for node in &mut self.nodes {
            let Ok(vertex) = u32::try_from(*node) else { continue };
            let column = &mut self.column_of[vertex as usize];
            if *column == u32::MAX {
                *column = self.columns.len() as u32;
                self.columns.push(vertex);
            }
            *node = *column as i32;
        }
        self.rows.resize(self.columns.len(), Vec::new());
        if self.nexts.len() < self.columns.len() {
            self.nexts.resize(self.columns.len(), Vec::new());
        }
    }

    /// Puts the arcs of one sequence, whose coarsest level is `res`, before those of coarser levels.
    fn add_level(&mut self, nodes: std::ops::Range<usize>, res: u32) {
        self.visited.clear();
        let mut at = None;
        for i in nodes.clone() {
            let node = self.nodes[i];
            if let Some(column) = at {
                let nexts: &mut Vec<i32> = &mut self.nexts[column as usize];
                if nexts.is_empty() {
                    self.visited.push(column);
                }
                nexts.push(node);
            }
            at = u32::try_from(node).ok().or(at);
        }
        // A strip that is gone has a sequence consisting only of its end node.
        let begin = self.nodes[nodes.start];
        if begin >= 0 {
            put_first(&mut self.begins, &[begin], res);
        }
        for column in self.visited.drain(..) {
            let nexts = &mut self.nexts[column as usize];
            put_first(&mut self.rows[column as usize], nexts, res);
            nexts.clear();
        }
    }
}

/// Makes `nexts` the first arcs of a row for levels up to `res`. All existing arcs of the row reach
/// coarser levels; those that `nexts` passes in the same order are reused. Rows are stored in reverse,
/// with their first arc last.
fn put_first(row: &mut Vec<RowNode>, nexts: &[i32], res: u32) {
    let mut used = 0;
    let mut first = Vec::with_capacity(nexts.len());
    for &column in nexts {
        let old = row.len().checked_sub(used + 1).map(|i| row[i]);
        match old {
            Some(node) if node.column == column => {
                used += 1;
                first.push(node);
            }
            _ => first.push(RowNode { column, res }),
        }
    }
    row.truncate(row.len() - used);
    row.extend(first.iter().rev());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::paper_bytes::{Accounting, PaperBytes};
    use striata::model::LodModel;
    use striata::strip::RESTART;

    fn piece(vertices: &[u32]) -> Piece {
        Piece { places: Vec::new(), vertices: vertices.to_vec() }
    }

    /// Figure 2 of the paper, with the sequences of its section 3.1.1.
    fn worked_example() -> MtsGraph {
        let mut builder = StripBuilder::new(8);
        builder.push_level(&[piece(&[0, 1, 2, 3, 4, 5, 6, 7])], 0);
        builder.push_level(&[piece(&[1, 2, 3, 4, 5, 6, 7])], 1);
        builder.push_level(&[piece(&[1, 2, 3, 4, 3, 5, 6, 7])], 2);
        builder.push_level(&[piece(&[1, 2, 4]), piece(&[4, 6, 7])], 3);
        builder.push_level(&[piece(&[1, 2, 6])], 4);
        let mut graph = MtsGraph { step_count: 4, ..MtsGraph::default() };
        builder.write(4, &mut graph);
        graph.close();
        graph
    }

    #[test]
    fn worked_example_has_the_sequences_of_the_paper() {
        let mut builder = StripBuilder::new(8);
        builder.push_level(&[piece(&[1, 2, 4]), piece(&[4, 6, 7])], 3);
        builder.push_level(&[piece(&[1, 2, 4]), piece(&[5, 6, 7])], 4);
        assert_eq!(builder.nodes, [1, 2, 4, -1, 6, 7, -3, 1, 2, 4, -2, 5, 6, 7, -3]);
    }

    #[test]
    fn worked_example_has_the_graph_of_the_paper() {
        let graph = worked_example();
        let pairs = |nodes: &[RowNode]| nodes.iter().map(|n| (n.column, n.res)).collect::<Vec<_>>();
        assert_eq!(graph.vertices, [0, 1, 2, 3, 4, 5, 6, 7]);
        // Vertex 0 begins the strip at level 0 only; at all others vertex 1 does.
        assert_eq!(pairs(&graph.begins), [(0, 0), (1, 4)]);
        let rows: Vec<_> =
            graph.first_rows.windows(2).map(|w| pairs(&graph.rows[w[0] as usize..w[1] as usize])).collect();
        let expected: [&[(i32, u32)]; 8] = [
            &[(1, 0)],
            &[(2, 4)],
            &[(3, 2), (4, 3), (6, 4)],
            // "and the other to the adjacency list of vertex 3 (colIndex = 5, res = 2)".
            &[(4, 2), (5, 2)],
            // "one to the adjacency list of vertex 4 (colIndex = 3, res = 2)"; at level 3 vertex 4 ends a
            // strip.
            &[(5, 1), (3, 2), (-1, 3), (6, 3)],
            &[(6, 2)],
            &[(7, 3), (-3, 4)],
            &[(-3, 3)],
        ];
        assert_eq!(rows, expected);
    }

    #[test]
    fn worked_example_is_recovered_at_every_level() {
        let graph = worked_example();
        let mut state = graph.new_state();
        let expected: [&[u32]; 5] = [
            &[0, 1, 2, 3, 4, 5, 6, 7],
            &[1, 2, 3, 4, 5, 6, 7],
            &[1, 2, 3, 4, 3, 5, 6, 7],
            &[1, 2, 4, RESTART, 4, 6, 7],
            &[1, 2, 6],
        ];
        for (level, expected) in expected.into_iter().enumerate() {
            graph.move_to(&mut state, 4 - level);
            assert_eq!(state.indices(), expected, "level {level}");
        }
        // 8 columns, 15 arcs, 2 beginnings, 1 strip.
        assert_eq!(graph.rows.len(), 15);
        assert_eq!(graph.paper_bytes(Accounting::Words), 12 * 8 + 8 * 17 + 8);
        assert_eq!(graph.paper_bytes(Accounting::ShortIntegers), 10 * 8 + 6 * 17 + 8);
    }

    #[test]
    fn arc_that_reappears_is_stored_twice_and_found() {
        // 0 goes to 1, then to 2, then to 1 again.
        let mut builder = StripBuilder::new(4);
        let sequences: [&[u32]; 4] = [&[0, 1, 2, 3], &[0, 2, 1, 3], &[0, 1, 3], &[]];
        for (level, sequence) in sequences.iter().enumerate() {
            let pieces = if sequence.is_empty() { vec![] } else { vec![piece(sequence)] };
            builder.push_level(&pieces, level as u32);
        }
        let mut graph = MtsGraph { step_count: 3, ..MtsGraph::default() };
        builder.write(3, &mut graph);
        graph.close();
        let mut state = graph.new_state();
        for (level, sequence) in sequences.iter().enumerate() {
            graph.move_to(&mut state, 3 - level);
            assert_eq!(state.indices(), *sequence);
        }
    }
}
