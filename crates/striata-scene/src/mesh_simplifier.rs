//! Simplification of the meshes of a scene: the one path of levels, files and streams.

use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::sync::OnceLock;

use serde_json::Value;
use striata::clusters::{ClusterDag, ClusterOptions};
use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::simplify::{
    BaseColor, BatchOptions, BuiltBatches, SequenceOptions, SimplifyError, build_batches_with_progress,
    build_sequence_with_progress, certify_collapses_in_any_state_with_progress,
};
use striata::{Lod, LodOptions, Progress, ProgressFn};
use striata_io::Scene;

use crate::deformation::{Deformation, ScenePoses, with_errors};
use crate::error::BuildError;
use crate::levels::MeshWeight;
use crate::mesh_jobs::{MeshFailure, for_each_distinct};

/// Simplifies meshes with options in units of the scene, for the poses of the scene.
#[derive(Debug)]
pub(crate) struct MeshSimplifier<'s> {
    scene: &'s Scene,
    weights: Vec<MeshWeight>,
    /// Absent if skins or animations cannot be read.
    poses: Option<ScenePoses>,
    /// Base colors of the document's materials, decoded when the first mesh needs them.
    base_colors: OnceLock<Vec<Option<BaseColor>>>,
}

impl<'s> MeshSimplifier<'s> {
    pub(crate) fn new(scene: &'s Scene) -> Self {
        let (weights, poses) = (MeshWeight::of_scene(scene), ScenePoses::new(scene).ok());
        Self { scene, weights, poses, base_colors: OnceLock::new() }
    }

    /// Whether two meshes of the scene have the same levels.
    pub(crate) fn is_simplified_alike(&self, meshes: [usize; 2], options: &SequenceOptions) -> bool {
        let [a, b] = meshes.map(|index| self.scene.meshes()[index].as_ref());
        if a.is_none() || a != b {
            return false;
        }
        let [first, second] = meshes.map(|index| self.options(index, options).ok());
        let is_still = |index: usize| {
            let mesh = self.scene.meshes()[index].as_ref();
            mesh.is_some_and(|mesh| self.deformation(index, mesh, options).is_none())
        };
        first.is_some() && first == second && meshes.into_iter().all(is_still)
    }

    /// Calls a function for each mesh of the scene; equal meshes, such as one ball in many colors, share a result.
    ///
    /// # Errors
    /// [`BuildError`] with the first mesh for which the function fails.
    pub(crate) fn for_each_mesh<T: Clone + Send>(
        &self,
        options: &SequenceOptions,
        build: impl Fn(usize, &IndexedMesh, &mut ProgressFn<'_>) -> Result<T, SimplifyError> + Sync,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Vec<Option<T>>, BuildError> {
        let is_alike = |meshes| self.is_simplified_alike(meshes, options);
        for_each_distinct(self.scene.meshes(), is_alike, build, progress).map_err(
            |MeshFailure { mesh, error }| BuildError::new(mesh, self.scene.mesh_name(mesh).to_owned(), error),
        )
    }

    /// Builds the clusters of a mesh of the scene, which has this index.
    ///
    /// # Errors
    /// [`SimplifyError`] if the mesh is inconsistent, an option is out of range, or the callback cancels.
    pub(crate) fn clusters(
        &self,
        index: usize,
        mesh: &IndexedMesh,
        options: &ClusterOptions,
        progress: &mut ProgressFn<'_>,
    ) -> Result<ClusterDag, SimplifyError> {
        let sequence = self.options(index, &options.sequence)?;
        let deformation = self.deformation(index, mesh, &sequence);
        let options = options.clone().with_sequence(sequence);
        match deformation {
            None => ClusterDag::build_with_progress(mesh, &options, progress),
            Some(deformation) => {
                ClusterDag::build_with_progress(&with_layers(mesh, &deformation), &options, progress)
            }
        }
    }

    /// Builds the levels of a mesh of the scene, which has this index.
    ///
    /// # Errors
    /// [`SimplifyError`] if the mesh is inconsistent, an option is out of range, or the callback cancels.
    pub(crate) fn lod(
        &self,
        index: usize,
        mesh: &IndexedMesh,
        options: &LodOptions,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Lod, SimplifyError> {
        let sequence = self.options(index, &options.sequence)?;
        let Some(deformation) = self.deformation(index, mesh, &sequence) else {
            return Lod::build_with_progress(mesh, &options.clone().with_sequence(sequence), progress);
        };
        let mesh = with_layers(mesh, &deformation);
        let stages = if options.has_guaranteed_errors { 3 } else { 2 };
        let mut refinable =
            build_sequence_with_progress(&mesh, &sequence, &mut stage(progress, 0, stages))?.refinable;
        drop(mesh);
        deformation.remove_layers(&mut refinable.mesh);
        if options.has_guaranteed_errors {
            refinable =
                certify_collapses_in_any_state_with_progress(&refinable, &mut stage(progress, 1, stages))?;
        }
        let refinable =
            deformation.finish_with_progress(refinable, &mut stage(progress, stages - 1, stages))?;
        let first = first_level(&refinable, &sequence);
        let refinable = if first > 0 { refinable.without_levels_below(first) } else { refinable };
        Ok(match options.has_guaranteed_errors {
            true => Lod::from_certified(refinable),
            false => Lod::from_refinable(refinable),
        })
    }

    /// Simplifies a mesh of the scene, which has this index, in batches.
    ///
    /// # Errors
    /// [`SimplifyError`] if the mesh is inconsistent, an option is out of range, or the callback cancels.
    pub(crate) fn batches(
        &self,
        index: usize,
        mesh: &IndexedMesh,
        options: &BatchOptions,
        progress: &mut ProgressFn<'_>,
    ) -> Result<BuiltBatches, SimplifyError> {
        let sequence = self.options(index, &options.sequence)?;
        let options = options.clone().with_sequence(sequence);
        let Some(deformation) = self.deformation(index, mesh, &options.sequence) else {
            return build_batches_with_progress(mesh, &options, progress);
        };
        let mut built = build_batches_with_progress(
            &with_layers(mesh, &deformation),
            &options,
            &mut stage(progress, 0, 2),
        )?;
        let refinable =
            deformation.finish_with_progress(built.built.refinable, &mut stage(progress, 1, 2))?;
        let refinable = with_errors_of_batches(refinable, &built.batches);
        let first = first_level(&refinable, &options.sequence);
        built.batches.retain(|&start| start as usize >= first);
        built.batches.iter_mut().for_each(|start| *start -= first as u32);
        built.built.refinable = if first > 0 { refinable.without_levels_below(first) } else { refinable };
        Ok(built)
    }

    /// Returns the poses to simplify a mesh for, if any and if they have a weight.
    fn deformation(
        &self,
        index: usize,
        mesh: &IndexedMesh,
        options: &SequenceOptions,
    ) -> Option<Deformation<'_>> {
        let has_weight = options.attribute_weights.displacement > 0.0;
        // A mesh or options that are refused get an error that does not depend on poses.
        let is_valid = mesh.check().is_ok() && options.check().is_ok();
        if !has_weight || !is_valid {
            return None;
        }
        Deformation::of(self.scene, self.poses.as_ref()?, index, mesh)
    }

    /// Returns the options of one mesh, with lengths in its own units and factors of its own materials.
    fn options(&self, mesh: usize, options: &SequenceOptions) -> Result<SequenceOptions, SimplifyError> {
        let mut sequence = options.clone();
        if let Some(vertex) = sequence.locked_vertices.first() {
            let (option, value) = ("locked_vertices", format!("vertex {vertex}"));
            return Err(SimplifyError::Option { option, value, expected: "empty for a scene" });
        }
        for length in [&mut sequence.max_error, &mut sequence.pair_distance].into_iter().flatten() {
            // A tiny scale must not make a valid option infinite.
            let in_mesh_units = *length / self.weights[mesh].scale;
            *length = if length.is_finite() { in_mesh_units.min(f64::MAX) } else { *length };
        }
        // The materials of a mesh are numbered from 0, in the order of the document.
        let used: BTreeSet<usize> = self.scene.primitive_materials(mesh).into_iter().flatten().collect();
        if sequence.texcoord_scales.is_empty() {
            sequence.texcoord_scales = self.texcoord_scales(&used);
        }
        if sequence.base_colors.is_empty() && sequence.attribute_weights.texcoord > 0.0 {
            sequence.base_colors = self.base_colors(&used);
        }
        Ok(sequence)
    }
}

impl MeshSimplifier<'_> {
    /// Base colors of some materials; empty if none is known.
    fn base_colors(&self, materials: &BTreeSet<usize>) -> Vec<Option<BaseColor>> {
        #[cfg(feature = "textures")]
        let all = self.base_colors.get_or_init(|| crate::drawn::base_colors(self.scene));
        #[cfg(not(feature = "textures"))]
        let all = self.base_colors.get_or_init(Vec::new);
        materials.iter().map_while(|&material| all.get(material).cloned()).collect()
    }

    /// Scales of the texture coordinates of some materials; empty if all are 1.
    fn texcoord_scales(&self, materials: &BTreeSet<usize>) -> Vec<[f32; 2]> {
        let all = self.scene.document().get("materials").and_then(Value::as_array);
        let scale = |&material: &usize| {
            all.and_then(|all| all.get(material)).map_or([1.0; 2], striata_io::texcoord_scale)
        };
        let scales: Vec<_> = materials.iter().map(scale).collect();
        if scales.iter().all(|&scale| scale == [1.0; 2]) { Vec::new() } else { scales }
    }
}

/// Returns a callback for one of several stages, each of which reports progress from its own beginning.
pub(crate) fn stage(
    progress: &mut ProgressFn<'_>,
    index: u64,
    count: u64,
) -> impl FnMut(Progress) -> ControlFlow<()> {
    move |now| {
        let done = now.done.min(now.total).saturating_add(index.saturating_mul(now.total));
        progress(Progress { phase: now.phase, done, total: now.total.saturating_mul(count) })
    }
}

fn with_layers(mesh: &IndexedMesh, deformation: &Deformation<'_>) -> IndexedMesh {
    let mut mesh = mesh.clone();
    deformation.add_layers(&mut mesh);
    mesh
}

/// Returns the coarsest level that does not exceed the error limit.
fn first_level(refinable: &RefinableMesh, options: &SequenceOptions) -> usize {
    options.max_error.map_or(0, |max_error| refinable.sequence.split_count_for_error(max_error))
}

/// Gives all levels of a batch the error of its coarse end, because steps of a batch may be reordered.
fn with_errors_of_batches(refinable: RefinableMesh, batches: &[u32]) -> RefinableMesh {
    let mut errors = refinable.sequence.errors().to_vec();
    for ends in batches.windows(2) {
        let batch = &mut errors[ends[0] as usize..ends[1] as usize];
        if let Some(&error) = batch.first() {
            batch.fill(error);
        }
    }
    with_errors(refinable, errors)
}
