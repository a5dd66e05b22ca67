//! Levels uploaded before the walk begins: nothing is computed or uploaded while they are drawn.

use std::ops::Range;

use striata::model::{LodModel, LodStrips, StripModel, Topology};
use striata_lab::baseline::{DiscreteLevels, ProgressiveMeshes};
use striata_render::gpu::{Drawing, Gpu, GpuIndices};
use striata_strip::stripify;

use super::super::bench_scene::BenchScene;
use super::way::Way;
use striata_command::failure::Failure;

/// Maximum bytes of indices; on longer walks some levels are drawn with the next finer one.
const MAX_BYTES: usize = 256 << 20;

/// Number of levels of the discrete set.
const DISCRETE_COUNT: usize = 5;

/// Several levels, one after the other in one index buffer.
pub(super) struct Resident {
    indices: GpuIndices,
    topology: Topology,
    /// Coarsest first.
    levels: Vec<ResidentLevel>,
    /// Whether a level that is not stored is drawn with the next coarser one instead of the next finer one.
    rounds_down: bool,
    drawn: usize,
}

struct ResidentLevel {
    split_count: usize,
    groups: Vec<Range<u32>>,
}

/// Levels collected for upload.
#[derive(Default)]
struct LevelBuffer {
    indices: Vec<u32>,
    levels: Vec<ResidentLevel>,
}

impl LevelBuffer {
    fn push(&mut self, split_count: usize, fill: impl FnOnce(&mut Vec<u32>)) {
        let first = self.indices.len() as u32;
        fill(&mut self.indices);
        let group = first..self.indices.len() as u32;
        self.levels.push(ResidentLevel { split_count, groups: vec![group] });
    }
}

impl Resident {
    /// Stores the levels of a walk as triangle lists.
    pub(super) fn lists(bench: &BenchScene<'_>, levels: &[usize]) -> Result<Self, Failure> {
        let model = ProgressiveMeshes::build(&bench.refinable);
        Self::of_model(bench, &model, levels)
    }

    /// Stores the levels of a walk as strips.
    pub(super) fn strips(bench: &BenchScene<'_>, levels: &[usize]) -> Result<Self, Failure> {
        let model = LodStrips::build(&bench.refinable, &bench.strips)?;
        debug_assert!(model.strip_count() > 0, "a mesh with triangles has strips");
        Self::of_model(bench, &model, levels)
    }

    /// Stores a few discrete levels, each stripified separately.
    pub(super) fn discrete(bench: &BenchScene<'_>) -> Result<Self, Failure> {
        let model = DiscreteLevels::build(&bench.refinable, DISCRETE_COUNT, |mesh| {
            stripify(mesh, &bench.level_strips)
        })
        .map_err(|error| Failure::internal(error.to_string()))?;
        let levels: Vec<usize> = model.split_counts().collect();
        Ok(Self { rounds_down: true, ..Self::of_model(bench, &model, &levels)? })
    }

    fn of_model(bench: &BenchScene<'_>, model: &impl LodModel, levels: &[usize]) -> Result<Self, Failure> {
        let mut levels = levels.to_vec();
        levels.sort_unstable_by(|a, b| b.cmp(a));
        levels.dedup();
        let mut state = model.new_state();
        let full_bytes = 4 * model.draw_counts(&state).index_count.max(1);
        let stride = (levels.len() * full_bytes).div_ceil(MAX_BYTES).max(1);
        let mut buffer = LevelBuffer::default();
        for &split_count in levels.iter().step_by(stride) {
            model.move_to(&mut state, split_count);
            buffer.push(split_count, |out| model.indices_into(&state, out));
        }
        buffer.levels.reverse();
        let indices = GpuIndices::upload(bench.gpu, &buffer.indices)?;
        let drawn = buffer.levels.len() - 1;
        Ok(Self { indices, topology: model.topology(), levels: buffer.levels, rounds_down: false, drawn })
    }
}

impl Way for Resident {
    fn move_to(&mut self, split_count: usize) {
        let last = self.levels.len() - 1;
        self.drawn = if self.rounds_down {
            self.levels.partition_point(|level| level.split_count <= split_count).saturating_sub(1)
        } else {
            self.levels.partition_point(|level| level.split_count < split_count).min(last)
        };
    }

    fn send(&mut self, _: &Gpu) -> Result<(), Failure> {
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
