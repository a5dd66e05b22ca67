//! Distribution of a target over all meshes of a scene by one priority.
//!
//! Each mesh has its own sequence of levels. From the full scene, the mesh whose next step adds the least squared
//! error for each triangle that it saves is always coarsened next (`curve`), as if the scene were one mesh. Where only
//! the sizes and errors of levels are known, it is the mesh whose next coarser level has the least error. A limit of the
//! error selects the coarsest level of each mesh within it. Equal priorities are ordered by the index of the mesh.
//!
//! The merged order is stored as one mesh index per step, with the state of all meshes at the start of each
//! block of steps, so that any position of the order is found without walking through all of it. Cost: a
//! replay of all sequences and a merge with a heap, O(steps log meshes), once; a target then takes a search over
//! blocks and one block.
//! Memory: about 20 bytes per step.

use std::collections::BTreeMap;

mod curve;
mod mesh_levels;
mod source;
mod weight;

use striata::mesh::{LevelTable, steps_for_detail};
use striata::simplify::StopReason;
use striata::{Lod, Target};
use striata_io::SceneInstance;

pub(crate) use curve::step_errors;
use mesh_levels::{LevelCounts, MeshLevels, first_meshes, merged_order};
pub use weight::MeshWeight;

use crate::mesh_jobs;

/// Fewest steps of a block; a block has at least as many steps as there are meshes, so that the states at
/// the starts of blocks need no more memory than the steps.
const MIN_BLOCK_STEPS: usize = 1024;

/// One level of detail of a scene: a level for each mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneLevel {
    /// Vertex splits of each mesh above its base; 0 for entries without triangles.
    pub split_counts: Vec<usize>,
    /// Number of triangles; those of a mesh count once for each instance.
    pub triangle_count: usize,
    /// Number of vertices; those of a mesh count once.
    pub vertex_count: usize,
    /// Largest error of all meshes, in units of the scene.
    pub error: f64,
    /// Whether the level meets the target, and if not, why.
    pub stop_reason: StopReason,
}

/// Levels of all meshes of a scene, in one order of coarsening.
#[derive(Clone, Debug)]
pub struct SceneLevels {
    meshes: Vec<Option<MeshLevels>>,
    /// The first mesh with the same levels and the same scale.
    first_of: Vec<usize>,
    /// Mesh that each step of coarsening concerns, beginning with the full scene.
    order: Vec<u32>,
    blocks: Vec<StepBlock>,
    /// Split count of each mesh at the start of each block, block by block.
    block_splits: Vec<u32>,
    full: LevelCounts,
    base: LevelCounts,
}

/// Consecutive steps of the order.
#[derive(Clone, Copy, Debug)]
struct StepBlock {
    /// Counts before its first step.
    start: LevelCounts,
    /// Fewest triangles after any of its steps.
    least_triangles: usize,
}

impl SceneLevels {
    /// Merges the levels of all meshes by their errors; [`None`] for entries without triangles.
    ///
    /// Weights that are missing at the end of the list are [`MeshWeight::default`]. A scale or importance that is
    /// not a positive number counts as 1.
    pub fn new(meshes: &[Option<&LevelTable>], weights: &[MeshWeight]) -> Self {
        Self::merged(meshes, weights, |_, _| Vec::new())
    }

    /// Merges the levels of all meshes so that the summed squared error is least, attributes included, like in
    /// [`new`](Self::new) otherwise. `diagonal` is that of the scene, against which attributes are weighed.
    pub fn of_lods(lods: &[Option<Lod>], weights: &[MeshWeight], diagonal: f64) -> Self {
        let levels: Vec<_> = lods.iter().map(|lod| Some(lod.as_ref()?.sequence().levels())).collect();
        if levels.iter().flatten().count() <= 1 {
            // Any priority that rises gives the order of a single mesh.
            return Self::new(&levels, weights);
        }
        Self::merged(&levels, weights, |mesh, scale| {
            let Some(lod) = &lods[mesh] else { return Vec::new() };
            let errors = step_errors(lod.mesh(), lod.sequence(), diagonal / scale);
            let count = |step: usize| lod.sequence().triangle_count_at(lod.step_count() - step);
            let prices = curve::prices(&errors, count);
            // Squared lengths times areas, in units of the scene.
            prices.into_iter().map(|price| price * scale.powi(4)).collect()
        })
    }

    /// `prices_of` returns the keys of the steps of a mesh, given its scale; errors are the keys if there are none.
    fn merged(
        meshes: &[Option<&LevelTable>],
        weights: &[MeshWeight],
        prices_of: impl Fn(usize, f64) -> Vec<f64> + Sync,
    ) -> Self {
        let weight_of = |mesh: usize| {
            let weight = weights.get(mesh).copied().unwrap_or_default();
            let is_scale = weight.scale > 0.0 && weight.scale.is_finite();
            let importance = SceneInstance::usable_importance(weight.importance).unwrap_or(1.0);
            MeshWeight { scale: if is_scale { weight.scale } else { 1.0 }, importance, ..weight }
        };
        let with_weight = |(mesh, levels): (usize, &LevelTable)| MeshLevels {
            levels: levels.clone(),
            weight: weight_of(mesh),
        };
        let meshes: Vec<Option<MeshLevels>> =
            meshes.iter().enumerate().map(|(mesh, levels)| Some(with_weight((mesh, (*levels)?)))).collect();
        let first_of = first_meshes(&meshes);
        let prices: Vec<Vec<f64>> = mesh_jobs::map(meshes.len(), |number| match &meshes[number] {
            Some(mesh) if first_of[number] == number => prices_of(number, mesh.weight.scale),
            _ => Vec::new(),
        });
        let order = merged_order(&meshes, |mesh, number, split_count| {
            let prices = &prices[first_of[number]];
            let step = mesh.levels.step_count() - 1 - split_count;
            let importance = mesh.weight.importance;
            // Prices are squares of errors.
            let price = prices.get(step).map(|price| price * importance * importance);
            price.unwrap_or_else(|| mesh.error_at(split_count) * importance)
        });
        drop(prices);
        let mut levels = Self {
            first_of,
            full: LevelCounts::default(),
            base: LevelCounts::default(),
            meshes,
            order,
            blocks: Vec::new(),
            block_splits: Vec::new(),
        };
        levels.full = levels.counts_of(&levels.full_splits());
        levels.base = levels.counts_of(&vec![0; levels.meshes.len()]);
        levels.index_blocks();
        levels
    }

    /// Number of steps of all meshes.
    pub fn step_count(&self) -> usize {
        self.order.len()
    }

    /// Number of triangles of the full scene; those of a mesh count once for each instance.
    pub fn triangle_count(&self) -> usize {
        self.full.triangles
    }

    /// Number of vertices of the full scene; those of a mesh count once.
    pub fn vertex_count(&self) -> usize {
        self.full.vertices
    }

    /// Number of triangles of the base scene; those of a mesh count once for each instance.
    pub fn base_triangle_count(&self) -> usize {
        self.base.triangles
    }

    /// Error of the base scene, in units of the scene.
    pub fn base_error(&self) -> f64 {
        self.error_of(&vec![0; self.meshes.len()])
    }

    /// Weight of a mesh; [`None`] for an entry without triangles.
    pub fn weight(&self, mesh: usize) -> Option<MeshWeight> {
        Some(self.meshes.get(mesh)?.as_ref()?.weight)
    }

    /// Returns the level of the scene that a target selects, and how well that level meets it.
    ///
    /// Triangles count once for each instance, vertices once for each mesh; errors are in units of the
    /// scene; detail is a share of the steps of all meshes. This is the most detailed level that does not
    /// exceed the target; for [`Target::Error`], it is the coarsest level within the error. A target that
    /// is out of range selects the base or the full scene.
    pub fn resolve(&self, target: Target) -> SceneLevel {
        let step_count = self.step_count();
        let (splits, is_above_full, is_below_base) = match target {
            Target::Triangles(n) => {
                (self.splits_for_triangles(n), n > self.full.triangles, n < self.base.triangles)
            }
            Target::Vertices(n) => {
                (self.splits_for_vertices(n), n > self.full.vertices, n < self.base.vertices)
            }
            Target::Error(error) => {
                let is_below_base = step_count > 0 && error > self.base_error();
                (self.splits_for_error(error), error < 0.0, is_below_base)
            }
            Target::Detail(detail) => {
                let split_count = steps_for_detail(detail, step_count);
                (self.splits_after(step_count - split_count), detail > 1.0, detail < 0.0)
            }
            Target::SplitCount(n) => {
                (self.splits_after(step_count - n.min(step_count)), n > step_count, false)
            }
            _ => (self.full_splits(), false, false),
        };
        let stop_reason = if is_above_full {
            StopReason::FullMesh
        } else if is_below_base {
            StopReason::BaseReached
        } else {
            StopReason::TargetReached
        };
        let splits = match target {
            Target::Triangles(_) => self.with_equal_twins(splits, |counts| counts.triangles),
            Target::Vertices(_) => self.with_equal_twins(splits, |counts| counts.vertices),
            _ => splits,
        };
        SceneLevel { stop_reason, ..self.level_of(splits) }
    }

    /// Makes meshes with the same levels alike, so that they can share their triangles: each gets an equal share of
    /// what they have together.
    fn with_equal_twins(&self, mut splits: Vec<usize>, count: fn(LevelCounts) -> usize) -> Vec<usize> {
        let mut twins: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (mesh, &first) in self.first_of.iter().enumerate() {
            twins.entry(first).or_default().push(mesh);
        }
        for members in twins.into_values().filter(|members| members.len() > 1) {
            let of = |member: usize, split_count: usize| {
                self.meshes[member].as_ref().map_or(0, |mesh| count(mesh.counts_at(split_count)))
            };
            let together: usize = members.iter().map(|&member| of(member, splits[member])).sum();
            // Twins that are shown equally often count alike.
            let mut alike: BTreeMap<usize, (usize, usize)> = BTreeMap::new();
            for &member in &members {
                let shown = self.weight(member).map_or(0, |weight| weight.instance_count);
                alike.entry(shown).or_insert((member, 0)).1 += 1;
            }
            let shown = |split_count: usize| {
                alike.values().map(|&(member, number)| number * of(member, split_count)).sum::<usize>()
            };
            let least = members.iter().map(|&member| splits[member]).min().unwrap_or(0);
            let most = members.iter().map(|&member| splits[member]).max().unwrap_or(0);
            let fitting = (least..=most).rev().find(|&split_count| shown(split_count) <= together);
            if let Some(fitting) = fitting {
                members.iter().for_each(|&member| splits[member] = fitting);
            }
        }
        splits
    }

    /// Returns the level in which each mesh has the given split count. Counts above the full mesh are
    /// reduced to it, and missing ones mean the full mesh.
    pub fn level_of(&self, mut split_counts: Vec<usize>) -> SceneLevel {
        split_counts.resize(self.meshes.len(), usize::MAX);
        for (split_count, mesh) in split_counts.iter_mut().zip(&self.meshes) {
            *split_count = (*split_count).min(mesh.as_ref().map_or(0, |mesh| mesh.levels.step_count()));
        }
        let LevelCounts { triangles, vertices } = self.counts_of(&split_counts);
        SceneLevel {
            error: self.error_of(&split_counts),
            split_counts,
            triangle_count: triangles,
            vertex_count: vertices,
            stop_reason: StopReason::TargetReached,
        }
    }

    fn full_splits(&self) -> Vec<usize> {
        self.meshes.iter().map(|mesh| mesh.as_ref().map_or(0, |mesh| mesh.levels.step_count())).collect()
    }

    fn counts_of(&self, splits: &[usize]) -> LevelCounts {
        let counts =
            self.meshes.iter().zip(splits).filter_map(|(mesh, &s)| Some(mesh.as_ref()?.counts_at(s)));
        counts.fold(LevelCounts::default(), LevelCounts::plus)
    }

    /// Returns a level with other split counts and their numbers of triangles and vertices.
    pub(crate) fn with_splits(&self, level: &SceneLevel, splits: Vec<usize>) -> SceneLevel {
        let counts = self.counts_of(&splits);
        SceneLevel {
            split_counts: splits,
            triangle_count: counts.triangles,
            vertex_count: counts.vertices,
            ..level.clone()
        }
    }

    fn error_of(&self, splits: &[usize]) -> f64 {
        let shown = self.meshes.iter().zip(splits).filter_map(|(mesh, &s)| Some((mesh.as_ref()?, s)));
        let shown = shown.filter(|(mesh, _)| mesh.weight.instance_count > 0);
        let errors = shown.map(|(mesh, split_count)| mesh.error_at(split_count));
        errors.fold(0.0, f64::max)
    }

    fn splits_for_error(&self, error: f64) -> Vec<usize> {
        self.meshes.iter().map(|mesh| mesh.as_ref().map_or(0, |m| m.split_count_for_error(error))).collect()
    }

    fn splits_for_triangles(&self, limit: usize) -> Vec<usize> {
        if self.full.triangles <= limit {
            return self.full_splits();
        }
        // Counts need not fall with every step, so that a search by halves could miss the first level.
        let block = self.blocks.iter().position(|block| block.least_triangles <= limit);
        self.walk(block.unwrap_or(self.blocks.len()), |counts| counts.triangles <= limit)
    }

    fn splits_for_vertices(&self, limit: usize) -> Vec<usize> {
        if self.full.vertices <= limit {
            return self.full_splits();
        }
        let after = self.blocks.partition_point(|block| block.start.vertices > limit);
        self.walk(after.saturating_sub(1), |counts| counts.vertices <= limit)
    }

    /// Split counts after the first `count` steps of coarsening.
    fn splits_after(&self, count: usize) -> Vec<usize> {
        let block = count / self.block_steps();
        let mut left = count % self.block_steps();
        if left == 0 {
            return self.splits_at_block(block);
        }
        self.walk(block, |_| {
            left -= 1;
            left == 0
        })
    }

    /// Takes steps from the start of a block until `is_enough` returns true for the counts after a step.
    fn walk(&self, block: usize, mut is_enough: impl FnMut(LevelCounts) -> bool) -> Vec<usize> {
        let mut splits = self.splits_at_block(block);
        let Some(&StepBlock { start: mut counts, .. }) = self.blocks.get(block) else { return splits };
        for &mesh in &self.order[block * self.block_steps()..] {
            counts = self.step(mesh, &mut splits, counts);
            if is_enough(counts) {
                break;
            }
        }
        splits
    }

    /// Coarsens one mesh by one step, and returns the counts of the scene after it.
    fn step(&self, mesh: u32, splits: &mut [usize], counts: LevelCounts) -> LevelCounts {
        let Some(levels) = &self.meshes[mesh as usize] else { return counts };
        let split_count = &mut splits[mesh as usize];
        let before = levels.counts_at(*split_count);
        *split_count -= 1;
        counts.minus(before).plus(levels.counts_at(*split_count))
    }

    fn block_steps(&self) -> usize {
        self.meshes.len().max(MIN_BLOCK_STEPS)
    }

    /// Split counts at the start of a block; those of the base scene behind the last block.
    fn splits_at_block(&self, block: usize) -> Vec<usize> {
        let first = block * self.meshes.len();
        match self.block_splits.get(first..first + self.meshes.len()) {
            Some(splits) => splits.iter().map(|&split_count| split_count as usize).collect(),
            None => vec![0; self.meshes.len()],
        }
    }

    fn index_blocks(&mut self) {
        let (mut splits, mut counts) = (self.full_splits(), self.full);
        let (mut blocks, mut block_splits) = (Vec::new(), Vec::new());
        for steps in self.order.chunks(self.block_steps()) {
            block_splits.extend(splits.iter().map(|&split_count| split_count as u32));
            let start = counts;
            let mut least_triangles = usize::MAX;
            for &mesh in steps {
                counts = self.step(mesh, &mut splits, counts);
                least_triangles = least_triangles.min(counts.triangles);
            }
            blocks.push(StepBlock { start, least_triangles });
        }
        (self.blocks, self.block_splits) = (blocks, block_splits);
    }
}
