//! A scene with every level of detail of each of its meshes.

use std::ops::Range;
use std::sync::{Arc, OnceLock};

use glam::{DMat4, DVec3};
use striata::mesh::IndexedMesh;
use striata::simplify::{SequenceOptions, Simplified, SimplifyError, fit_within};
use striata::{Lod, LodOptions, ProgressFn, Target, ignore_progress};
use striata_io::Scene;

use crate::error::{BuildError, SceneMismatch};
use crate::levels::{MeshWeight, SceneLevel, SceneLevels};
use crate::mesh_jobs::{MeshFailure, for_each_size};
use crate::mesh_simplifier::MeshSimplifier;

/// A scene without triangles and a [`Lod`] for each of its meshes.
///
/// Everything is immutable, and clones share their data.
///
/// # Example
/// ```
/// use striata::mesh::shapes;
/// use striata::{LodOptions, Target};
/// use striata_io::Scene;
/// use striata_scene::LodScene;
///
/// let scene = Scene::from_mesh(shapes::torus(32, 16, 1.0, 0.4))?; // or striata_io::read_scene("robot.glb")?
/// let lods = LodScene::build(&scene, &LodOptions::default())?;
/// let level = lods.level(Target::Triangles(200));
/// println!("{} triangles, error {}", level.triangle_count, level.error);
/// let coarse = lods.level_scene(&level); // striata_io::write_scene("coarse.glb", &coarse, ...)
/// assert!(coarse.triangle_count() <= 200);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct LodScene {
    shared: Arc<SharedParts>,
}

#[derive(Debug)]
struct SharedParts {
    scene: Scene,
    lods: Vec<Option<Lod>>,
    levels: OnceLock<SceneLevels>,
}

impl LodScene {
    /// Builds the levels of all meshes of a scene.
    ///
    /// Lengths in the options are in units of the scene: for each mesh, they are divided by the largest
    /// scale of its instances. `base_triangle_count` applies to each mesh; `locked_vertices` must be empty.
    ///
    /// Meshes with skins or morph targets are simplified for the poses of the scene's animations as well: see
    /// [`Deformation`](crate::Deformation). Their errors are at least the distances measured in these poses.
    /// The weight of displacements of [`AttributeWeights`](striata::simplify::AttributeWeights) applies to
    /// poses too; 0 ignores them. A scene whose skins or animations cannot be read is simplified as it
    /// stands. Guaranteed errors are guaranteed for the mesh as it is stored; in poses they are measured.
    ///
    /// # Errors
    /// [`BuildError`] if a mesh is inconsistent or an option is out of range.
    pub fn build(scene: &Scene, options: &LodOptions) -> Result<Self, BuildError> {
        Self::build_with_progress(scene, options, &mut ignore_progress)
    }

    /// Builds the levels like [`build`](Self::build) and reports progress; the callback can cancel.
    ///
    /// # Errors
    /// [`BuildError`] under the conditions of [`build`](Self::build), or if the callback cancels.
    pub fn build_with_progress(
        scene: &Scene,
        options: &LodOptions,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, BuildError> {
        let simplifier = MeshSimplifier::new(scene);
        let build = |index: usize, mesh: &IndexedMesh, progress: &mut ProgressFn<'_>| {
            simplifier.lod(index, mesh, options, progress)
        };
        let lods = simplifier.for_each_mesh(&options.sequence, build, progress)?;
        Ok(Self::of_parts(scene.without_meshes(), lods))
    }

    /// Combines a scene with levels that exist already; triangles of the scene itself are dropped.
    ///
    /// # Errors
    /// [`SceneMismatch`] if the number of levels differs from that of the scene's meshes, or if the groups
    /// of one differ from the triangle primitives of its mesh.
    pub fn from_lods(scene: Scene, lods: Vec<Option<Lod>>) -> Result<Self, SceneMismatch> {
        let expected = scene.meshes().len();
        if lods.len() != expected {
            return Err(SceneMismatch::MeshCount { found: lods.len(), expected });
        }
        for (mesh, lod) in lods.iter().enumerate() {
            let Some(lod) = lod else { continue };
            check_groups(&scene, mesh, lod.mesh().groups.len())?;
        }
        let has_triangles = scene.meshes().iter().any(Option::is_some);
        Ok(Self::of_parts(if has_triangles { scene.without_meshes() } else { scene }, lods))
    }

    pub(crate) fn of_parts(scene: Scene, lods: Vec<Option<Lod>>) -> Self {
        Self { shared: Arc::new(SharedParts { scene, lods, levels: OnceLock::new() }) }
    }

    /// The scene without triangles: its document, images, and the data of animations and skins.
    pub fn scene(&self) -> &Scene {
        &self.shared.scene
    }

    /// Levels of each mesh of the document; [`None`] for meshes without triangles.
    pub fn lods(&self) -> &[Option<Lod>] {
        &self.shared.lods
    }

    /// Levels of all meshes in one order; merged at first use.
    pub fn levels(&self) -> &SceneLevels {
        self.shared.levels.get_or_init(|| {
            SceneLevels::of_lods(self.lods(), &MeshWeight::of_scene(self.scene()), self.diagonal())
        })
    }

    /// Diagonal of the box around all instances, in units of the scene.
    fn diagonal(&self) -> f64 {
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for instance in self.scene().instances() {
            let bounds = self.lods()[instance.mesh].as_ref().and_then(|lod| lod.mesh().bounds());
            let Some(bounds) = bounds else { continue };
            let transform = DMat4::from_cols_array(&instance.transform);
            for corner in 0..8 {
                let side =
                    |axis: usize| if corner >> axis & 1 == 0 { bounds.min[axis] } else { bounds.max[axis] };
                let point = transform.transform_point3(DVec3::from_array([0, 1, 2].map(side).map(f64::from)));
                (min, max) = (min.min(point), max.max(point));
            }
        }
        let diagonal = (max - min).length();
        if diagonal.is_finite() { diagonal } else { 1.0 }
    }

    /// Number of triangles of the full scene; those of a mesh count once for each instance.
    pub fn triangle_count(&self) -> usize {
        self.levels().triangle_count()
    }

    /// Returns the level of the scene that a target selects; see [`SceneLevels::resolve`].
    pub fn level(&self, target: Target) -> SceneLevel {
        self.levels().resolve(target)
    }

    /// Returns the levels that are at least as fine as `level`, which becomes the coarsest one.
    #[must_use]
    pub fn without_levels_below(&self, level: &SceneLevel) -> Self {
        let first = |mesh: usize| level.split_counts.get(mesh).copied().unwrap_or(0);
        let lods = self.lods().iter().enumerate();
        let lods = lods.map(|(mesh, lod)| Some(lod.as_ref()?.without_levels_below(first(mesh)))).collect();
        Self::of_parts(self.scene().clone(), lods)
    }

    /// Whether the errors of all levels are guaranteed bounds rather than estimates.
    pub fn has_guaranteed_errors(&self) -> bool {
        self.lods().iter().flatten().all(Lod::has_guaranteed_errors)
    }

    /// Returns a scene with the triangles of a level, and only the vertices that they use. Split counts
    /// above the full mesh mean the full mesh.
    pub fn level_scene(&self, level: &SceneLevel) -> Scene {
        let scene = self.scene().clone().with_meshes(self.level_meshes(level));
        scene.expect("the groups of each mesh were checked, and every level has them all")
    }

    /// Returns the meshes of [`level_scene`](Self::level_scene) alone.
    pub fn level_meshes(&self, level: &SceneLevel) -> Vec<Option<IndexedMesh>> {
        let split_count = |mesh: usize| level.split_counts.get(mesh).copied().unwrap_or(usize::MAX);
        let lods = self.lods().iter().enumerate();
        let level_of = |mesh: usize, lod: &Lod| lod.level_mesh(Target::SplitCount(split_count(mesh)));
        lods.map(|(mesh, lod)| Some(level_of(mesh, lod.as_ref()?))).collect()
    }

    /// Returns the meshes of a level like [`level_meshes`](Self::level_meshes), [fitted](fit_within) to
    /// the full meshes, with the error of the level in units of the scene. Meshes with skins or morph targets stay
    /// as they are.
    ///
    /// # Errors
    /// [`BuildError`] if an option is out of range, or if the callback cancels.
    pub fn fitted_meshes(
        &self,
        level: &SceneLevel,
        fitting: &Fitting<'_>,
        progress: &mut ProgressFn<'_>,
    ) -> Result<FittedMeshes, BuildError> {
        let fit =
            |index: usize, progress: &mut ProgressFn<'_>| self.fitted_mesh(index, level, fitting, progress);
        let sizes: Vec<_> =
            self.lods().iter().map(|lod| Some(lod.as_ref()?.mesh().triangle_count())).collect();
        let made = for_each_size(&sizes, fit, progress).map_err(|MeshFailure { mesh, error }| {
            BuildError::new(mesh, self.scene().mesh_name(mesh).to_owned(), error)
        })?;
        let (mut error, mut fitted_count) = (0.0f64, 0);
        let (mut meshes, mut splits) = (Vec::with_capacity(made.len()), Vec::with_capacity(made.len()));
        for (index, fitted) in made.into_iter().enumerate() {
            let Some(FittedMesh { made, split_count, is_fitted }) = fitted.flatten() else {
                meshes.push(None);
                splits.push(level.split_counts.get(index).copied().unwrap_or(usize::MAX));
                continue;
            };
            let weight = self.levels().weight(index).unwrap_or_default();
            if weight.instance_count > 0 {
                error = error.max(made.error * weight.scale);
            }
            fitted_count += usize::from(is_fitted);
            meshes.push(Some(made.mesh));
            splits.push(split_count);
        }
        let level = SceneLevel { error, ..self.levels().with_splits(level, splits) };
        Ok(FittedMeshes { meshes, level, fitted_count })
    }

    /// Returns one mesh of a level, fitted if it is to be; [`None`] for meshes without triangles.
    fn fitted_mesh(
        &self,
        index: usize,
        level: &SceneLevel,
        fitting: &Fitting<'_>,
        progress: &mut ProgressFn<'_>,
    ) -> Result<Option<FittedMesh>, SimplifyError> {
        let Some(lod) = &self.lods()[index] else { return Ok(None) };
        let weight = self.levels().weight(index).unwrap_or_default();
        let levels = lod.sequence().levels();
        let coarsest = level.split_counts.get(index).copied().unwrap_or(usize::MAX).min(lod.step_count());
        let mut split_count = coarsest;
        let mut level_within = |limit: f64| {
            split_count = coarsest.max(levels.split_count_for_error(limit));
            let mesh = lod.level_mesh(Target::SplitCount(split_count));
            let error = f64::from(levels.error_at(split_count));
            Simplified { mesh, error, stop_reason: level.stop_reason }
        };
        let original = lod.mesh();
        let is_rigged = original.layers.iter().any(|layer| layer.semantic.is_of_poses());
        let is_fitted = !is_rigged && (fitting.selects)(original);
        let made = if is_fitted {
            let max_error = fitting.max_error / weight.scale;
            fit_within(original, level_within, fitting.options, max_error, progress)?
        } else {
            level_within(f64::INFINITY)
        };
        Ok(Some(FittedMesh { made, split_count, is_fitted }))
    }

    /// Returns the triangles of a level as index lists over the vertices of [`full_scene`](Self::full_scene): for
    /// each mesh of the document, one list for each of its triangle primitives; none for meshes without triangles.
    ///
    /// So all levels of a mesh share one vertex buffer, as engines store chains of levels: the vertices of a level are
    /// the first ones of the buffer. Split counts above the full mesh mean the full mesh.
    pub fn indices(&self, level: &SceneLevel) -> Vec<Vec<Vec<u32>>> {
        let split_count = |mesh: usize| level.split_counts.get(mesh).copied().unwrap_or(usize::MAX);
        let lists = |(mesh, lod): (usize, &Option<Lod>)| {
            let Some(lod) = lod else { return Vec::new() };
            let level = lod.level(Target::SplitCount(split_count(mesh)));
            let list =
                |range: &Range<u32>| level.indices()[range.start as usize..range.end as usize].to_vec();
            level.groups().iter().map(list).collect()
        };
        self.lods().iter().enumerate().map(lists).collect()
    }

    /// Returns the scene with all of its triangles, and the vertices of each mesh in refinement order.
    pub fn full_scene(&self) -> Scene {
        self.scene_of(|_, lod| lod.mesh().clone())
    }

    fn scene_of(&self, mesh_of: impl Fn(usize, &Lod) -> IndexedMesh) -> Scene {
        let lods = self.lods().iter().enumerate();
        let meshes = lods.map(|(mesh, lod)| Some(mesh_of(mesh, lod.as_ref()?))).collect();
        let scene = self.scene().clone().with_meshes(meshes);
        scene.expect("the groups of each mesh were checked, and every level has them all")
    }
}

/// Which meshes of a level are fitted, and how: see [`LodScene::fitted_meshes`].
pub struct Fitting<'a> {
    /// Whether the vertices of a mesh may move.
    pub selects: &'a (dyn Fn(&IndexedMesh) -> bool + Sync),
    /// Options that say which vertices must not move.
    pub options: &'a SequenceOptions,
    /// Largest measured error of a fitted mesh, in units of the scene; meshes are made finer for it.
    pub max_error: f64,
}

/// One mesh of a level.
struct FittedMesh {
    made: Simplified,
    split_count: usize,
    is_fitted: bool,
}

/// Meshes of a level whose vertices were moved: see [`LodScene::fitted_meshes`].
#[derive(Clone, Debug)]
pub struct FittedMeshes {
    /// The meshes, for [`Scene::with_meshes`].
    pub meshes: Vec<Option<IndexedMesh>>,
    /// The level with its measured error; meshes that exceeded the error limit are finer than asked for.
    pub level: SceneLevel,
    /// Number of meshes that were fitted.
    pub fitted_count: usize,
}

/// Checks that a mesh of the document has as many triangle primitives as its levels have groups; levels
/// without groups have one for all triangles.
pub(crate) fn check_groups(scene: &Scene, mesh: usize, group_count: usize) -> Result<(), SceneMismatch> {
    let found = group_count.max(1);
    let expected = scene.primitive_materials(mesh).len();
    if found == expected { Ok(()) } else { Err(SceneMismatch::GroupCount { mesh, found, expected }) }
}
