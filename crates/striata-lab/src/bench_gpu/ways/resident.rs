//! Levels that are on the GPU before the walk begins: nothing is made and nothing sent while they are drawn.

use std::ops::Range;

use striata::model::{LodModel, LodStrips, StripModel, Topology};
use striata_gpu::{Drawing, Gpu, GpuIndices};
use striata_lab::baseline::{DiscreteLevels, ProgressiveMeshes};
use striata_strip::stripify;

use super::super::stage::Stage;
use super::way::Way;
use striata_command::failure::Failure;

/// Bytes of indices that are kept at most; of longer walks some levels are drawn by the next finer one.
const MOST_BYTES: usize = 256 << 20;

/// Levels of the discrete set.
const DISCRETE_COUNT: usize = 5;

/// Levels one after the other in one index buffer.
pub(super) struct Resident {
    indices: GpuIndices,
    topology: Topology,
    /// Coarse to fine.
    levels: Vec<Level>,
    /// Whether the next coarser level stands for one that is not here, or the next finer.
    rounds_down: bool,
    drawn: usize,
}

struct Level {
    split_count: usize,
    groups: Vec<Range<u32>>,
}

/// Levels on their way to the GPU.
#[derive(Default)]
struct Shelf {
    indices: Vec<u32>,
    levels: Vec<Level>,
}

impl Shelf {
    fn put(&mut self, split_count: usize, fill: impl FnOnce(&mut Vec<u32>)) {
        let first = self.indices.len() as u32;
        fill(&mut self.indices);
        let group = first..self.indices.len() as u32;
        self.levels.push(Level { split_count, groups: vec![group] });
    }
}

impl Resident {
    /// The levels of a walk as lists.
    pub(super) fn lists(stage: &Stage<'_>, levels: &[usize]) -> Result<Self, Failure> {
        let model = ProgressiveMeshes::build(&stage.refinable);
        Self::of_model(stage, &model, levels)
    }

    /// The levels of a walk as strips.
    pub(super) fn strips(stage: &Stage<'_>, levels: &[usize]) -> Result<Self, Failure> {
        let model = LodStrips::build(&stage.refinable, &stage.strips)?;
        debug_assert!(model.strip_count() > 0, "a mesh with triangles has strips");
        Self::of_model(stage, &model, levels)
    }

    /// A few levels, each with strips of its own.
    pub(super) fn discrete(stage: &Stage<'_>) -> Result<Self, Failure> {
        let model = DiscreteLevels::build(&stage.refinable, DISCRETE_COUNT, |mesh| {
            stripify(mesh, &stage.level_strips)
        })
        .map_err(|error| Failure::internal(error.to_string()))?;
        let levels: Vec<usize> = model.split_counts().collect();
        Ok(Self { rounds_down: true, ..Self::of_model(stage, &model, &levels)? })
    }

    fn of_model(stage: &Stage<'_>, model: &impl LodModel, levels: &[usize]) -> Result<Self, Failure> {
        let mut levels = levels.to_vec();
        levels.sort_unstable_by(|a, b| b.cmp(a));
        levels.dedup();
        let mut state = model.new_state();
        let full_bytes = 4 * model.draw_counts(&state).index_count.max(1);
        let stride = (levels.len() * full_bytes).div_ceil(MOST_BYTES).max(1);
        let mut shelf = Shelf::default();
        for &split_count in levels.iter().step_by(stride) {
            model.move_to(&mut state, split_count);
            shelf.put(split_count, |out| model.indices_into(&state, out));
        }
        shelf.levels.reverse();
        let indices = GpuIndices::upload(stage.gpu, &shelf.indices)?;
        let drawn = shelf.levels.len() - 1;
        Ok(Self { indices, topology: model.topology(), levels: shelf.levels, rounds_down: false, drawn })
    }
}

impl Way for Resident {
    fn move_to(&mut self, _: &Gpu, split_count: usize) -> Result<(), Failure> {
        let last = self.levels.len() - 1;
        self.drawn = if self.rounds_down {
            self.levels.partition_point(|level| level.split_count <= split_count).saturating_sub(1)
        } else {
            self.levels.partition_point(|level| level.split_count < split_count).min(last)
        };
        Ok(())
    }

    fn drawing(&self) -> Drawing<'_> {
        let (indices, groups) = (&self.indices, &self.levels[self.drawn].groups[..]);
        match self.topology {
            Topology::Triangles => Drawing::List { indices, groups },
            Topology::Strips => Drawing::Strips { indices, groups },
        }
    }

    fn index_count(&self) -> usize {
        self.levels[self.drawn].groups.iter().map(|group| group.len()).sum()
    }

    fn uploaded_bytes(&self) -> u64 {
        0
    }

    fn gpu_bytes(&self) -> usize {
        4 * self.indices.capacity()
    }
}
