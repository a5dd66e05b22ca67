//! Discrete levels of detail: a few levels of the sequence, each stored with its own strips.
//!
//! This is what engines do without a continuous model. The triangle counts fall geometrically from the
//! full mesh to a sixteenth of it: five levels halve each time, ten take nine smaller steps to the same
//! end. Each level is stripified separately, so it draws as well as its mesh allows. The state of an
//! instance is its level.
//!
//! Differs: classic levels have separate vertex buffers. Here all levels share the one in refinement order
//! and use its first part; [`PaperBytes::paper_bytes`] counts the classic form.
//!
//! Cost: changing the level is free; a level takes about 5 bytes per triangle. Building stripifies about
//! as many triangles as 2 (five levels) or 4 (ten levels) full meshes have.

use striata::mesh::{CollapseSequence, IndexedMesh, MeshError, RefinableMesh, replay};
use striata::model::{DrawCounts, LodModel, PartBytes, Topology, join_strips};
use striata::strip::{RESTART, StripIndices, StripSet};

use crate::paper_bytes::{Accounting, PaperBytes};

/// Ratio of triangle counts between the finest and the coarsest level, if the mesh has levels that coarse.
const FINEST_TO_COARSEST: f64 = 16.0;

/// Error of building discrete levels.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DiscreteLevelsError {
    /// The requested level count is 0.
    #[error("0 levels were requested, at least 1 is needed")]
    NoLevels,
    /// The mesh is inconsistent.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// The static half of the model: levels as triangle strips, level 0 being the full mesh; see the
/// [module](self).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DiscreteLevels {
    step_count: usize,
    /// Finest first, at least one.
    levels: Vec<DiscreteLevel>,
}

/// One level of the set.
#[derive(Clone, Debug, PartialEq, Eq)]
struct DiscreteLevel {
    split_count: usize,
    vertex_count: usize,
    strip_count: usize,
    /// Restart indices separate all strips, including those of different groups.
    strips: StripIndices,
}

impl DiscreteLevel {
    fn new(mesh: &IndexedMesh, split_count: usize, strips: &StripSet) -> Self {
        let mut out = StripIndices::default();
        let mut strip_count = 0;
        for group in 0..strips.group_count() {
            if out.indices.last().is_some_and(|&index| index != RESTART) {
                out.indices.push(RESTART);
            }
            let first = out.indices.len();
            join_strips(strips.group_strips(group).map(|strip| strips.strip(strip)), &mut out.indices);
            out.group_ranges.push(first as u32..out.indices.len() as u32);
            strip_count +=
                strips.group_strips(group).filter(|&strip| !strips.strip(strip).is_empty()).count();
        }
        out.indices.pop_if(|&mut index| index == RESTART);
        Self { split_count, vertex_count: mesh.vertex_count(), strip_count, strips: out }
    }

    fn index_bytes(&self) -> usize {
        4 * self.strips.indices.len()
    }
}

/// State of one instance: the level that it shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DiscreteLevelsState {
    level: usize,
}

impl DiscreteLevelsState {
    /// The level; 0 is the finest.
    pub fn level(&self) -> usize {
        self.level
    }
}

impl DiscreteLevels {
    /// Stores at most `level_count` levels, each as the strips that `stripify` makes of it.
    ///
    /// Level `k` is the most detailed that has at most `triangle_count / 16^(k / (level_count - 1))`
    /// triangles, rounded. Equal levels, which small meshes and early base meshes lead to, are stored once.
    ///
    /// # Errors
    /// [`DiscreteLevelsError`] if `level_count` is 0 or the mesh is inconsistent.
    ///
    /// # Panics
    /// If the sequence belongs to another mesh.
    pub fn build(
        refinable: &RefinableMesh,
        level_count: usize,
        mut stripify: impl FnMut(&IndexedMesh) -> Result<StripSet, MeshError>,
    ) -> Result<Self, DiscreteLevelsError> {
        refinable.mesh.check()?;
        let mut levels = Vec::new();
        for split_count in split_counts(&refinable.sequence, level_count)? {
            let mesh = replay(refinable, split_count);
            levels.push(DiscreteLevel::new(&mesh, split_count, &stripify(&mesh)?));
        }
        Ok(Self { step_count: refinable.sequence.step_count(), levels })
    }

    /// Number of levels stored.
    pub fn level_count(&self) -> usize {
        self.levels.len()
    }

    /// The split counts of the levels, finest first.
    pub fn split_counts(&self) -> impl Iterator<Item = usize> {
        self.levels.iter().map(|level| level.split_count)
    }

    /// Strips of an instance's level: an index buffer with [`RESTART`] between strips, and the range of
    /// each group (material).
    ///
    /// # Panics
    /// If the state belongs to a model with more levels.
    pub fn strips(&self, state: &DiscreteLevelsState) -> &StripIndices {
        &self.levels[state.level].strips
    }
}

/// Split counts of the levels to store, finest first, without repetitions.
fn split_counts(sequence: &CollapseSequence, level_count: usize) -> Result<Vec<usize>, DiscreteLevelsError> {
    if level_count == 0 {
        return Err(DiscreteLevelsError::NoLevels);
    }
    let step_count = sequence.step_count();
    let ratio_count = level_count.min(step_count + 1) - 1;
    let ratio = root(FINEST_TO_COARSEST, ratio_count);
    let full = sequence.triangle_count_at(step_count);
    let mut out = vec![step_count];
    let mut allowed = full as f64;
    for _ in 0..ratio_count {
        allowed /= ratio;
        // Adding half a triangle absorbs the rounding of the ratio. A level without triangles would be
        // useless.
        let split_count = sequence.split_count_for_triangles(((allowed + 0.5) as usize).max(1));
        if out.last().is_some_and(|&finer| split_count < finer) {
            out.push(split_count);
        }
    }
    Ok(out)
}

/// The `degree`-th root of `value`, at least 1. Bisection gives the same result on every machine; the
/// platform's `powf` does not.
fn root(value: f64, degree: usize) -> f64 {
    let (mut low, mut high) = (1.0, value);
    for _ in 0..64 {
        let middle = (low + high) / 2.0;
        let mut power = 1.0;
        for _ in 0..degree {
            power *= middle;
            if power > value {
                break;
            }
        }
        if power > value { high = middle } else { low = middle }
    }
    (low + high) / 2.0
}

impl LodModel for DiscreteLevels {
    type State = DiscreteLevelsState;

    fn step_count(&self) -> usize {
        self.step_count
    }

    fn new_state(&self) -> DiscreteLevelsState {
        DiscreteLevelsState { level: 0 }
    }

    fn split_count(&self, state: &DiscreteLevelsState) -> usize {
        self.levels[state.level].split_count
    }

    fn move_to(&self, state: &mut DiscreteLevelsState, split_count: usize) {
        assert!(split_count <= self.step_count, "split count {split_count} of {}", self.step_count);
        assert!(state.level < self.levels.len(), "the state belongs to another model");
        let finer = self.levels.partition_point(|level| level.split_count > split_count);
        state.level = finer.min(self.levels.len() - 1);
    }

    fn topology(&self) -> Topology {
        Topology::Strips
    }

    fn draw_counts(&self, state: &DiscreteLevelsState) -> DrawCounts {
        let level = &self.levels[state.level];
        DrawCounts { strip_count: level.strip_count, index_count: level.strips.indices.len() }
    }

    fn indices_into(&self, state: &DiscreteLevelsState, out: &mut Vec<u32>) {
        out.extend_from_slice(&self.strips(state).indices);
    }

    fn bytes(&self) -> Vec<PartBytes> {
        let table = |level: &DiscreteLevel| size_of_val(level) + size_of_val(&level.strips.group_ranges[..]);
        vec![
            PartBytes { name: "strips", bytes: self.levels.iter().map(DiscreteLevel::index_bytes).sum() },
            PartBytes { name: "levels", bytes: self.levels.iter().map(table).sum() },
        ]
    }

    fn state_bytes(&self, _: &DiscreteLevelsState) -> usize {
        size_of::<DiscreteLevelsState>()
    }
}

impl PaperBytes for DiscreteLevels {
    /// The strips of all levels, and the positions of all but the finest, since each classic level stores
    /// its own.
    fn paper_bytes(&self, accounting: Accounting) -> usize {
        let own_vertices: usize = self.levels.iter().skip(1).map(|level| level.vertex_count).sum();
        let index_count = self.levels.iter().map(|level| level.strips.indices.len()).sum();
        accounting.bytes(0, index_count) + 12 * own_vertices
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn root_inverts_powers() {
        assert_eq!(root(16.0, 0), 16.0);
        assert!((root(16.0, 1) - 16.0).abs() < 1e-12);
        assert!((root(16.0, 4) - 2.0).abs() < 1e-12);
        assert!((root(16.0, 9) - 1.360_790_000_174_377).abs() < 1e-12);
    }
}
