//! Triangles that a renderer shows frame after frame: a level of the whole scene, or detail for a camera.
//!
//! A scene that stands still shows the same indices; a frame only replaces the lists that differ. Vertices
//! stay where they are, and poses do not matter to indices, except that detail follows the instances.
//!
//! For a camera, an instance whose mesh is neither deformed nor stretched has a [`View`] of its own, refined
//! vertex by vertex in the space of its mesh. All other instances of a mesh share one level: the coarsest one
//! whose error is allowed in every place where it is shown.

mod budget;

use std::ops::Range;

use striata::mesh::Semantic;
use striata::view::{ScreenError, Sphere};
use striata::{Level, Lod, Target, View};
use striata_io::SceneInstance;

use crate::drawn::DrawnInstance;
use crate::place::{self, PlacedSphere, sphere_around};
use crate::{LodScene, SceneLevel};

/// Most instances with views of their own: each needs memory for its state and its indices.
const MAX_VIEWS: usize = 256;

/// The triangles that each instance of a scene shows.
///
/// Memory: the indices of each mesh, and for each instance that follows a camera by itself a [`View`].
#[derive(Clone, Debug)]
pub struct SceneView {
    lods: LodScene,
    meshes: Vec<Option<UniformMesh>>,
    instances: Vec<InstanceView>,
    /// Factor of the tolerance that the last triangle limit needed.
    factor: f32,
}

/// A level of a mesh, which several instances can show.
#[derive(Clone, Debug)]
struct UniformMesh {
    level: Level,
    revision: u64,
    /// Sphere around the mesh.
    sphere: Sphere,
    /// Whether morph targets move its vertices.
    is_morphed: bool,
}

/// How an instance shows its mesh.
#[derive(Clone, Debug)]
struct InstanceView {
    mesh: usize,
    is_hidden: bool,
    /// Factor by which its errors count more.
    importance: f64,
    /// Whether it may have a view of its own.
    may_refine: bool,
    /// Whether it shows its own view rather than the level of the mesh.
    is_refined: bool,
    view: Option<Box<View>>,
    revision: u64,
}

/// Indices that an instance shows.
#[derive(Clone, Copy, Debug)]
pub struct ShownIndices<'a> {
    /// Number of the list of indices: instances with the same number share it. Less than the sum of the
    /// numbers of meshes and instances.
    pub list: usize,
    /// Changes whenever the list does.
    pub revision: u64,
    /// Vertex indices into the full mesh, three per triangle.
    pub indices: &'a [u32],
    /// Range of the indices of each primitive.
    pub groups: &'a [Range<u32>],
}

impl LodScene {
    /// Returns the triangles of the scene for a renderer; at first, each instance shows its base mesh.
    pub fn view(&self) -> SceneView {
        SceneView::new(self.clone())
    }
}

impl SceneView {
    fn new(lods: LodScene) -> Self {
        let meshes = lods.lods().iter().map(|lod| Some(UniformMesh::new(lod.as_ref()?))).collect();
        let mut free = MAX_VIEWS;
        let instances = lods.scene().instances().iter().map(|instance| {
            let is_rigid = instance.skin.is_none();
            let may_refine = is_rigid && free > 0;
            free -= usize::from(may_refine);
            InstanceView {
                mesh: instance.mesh,
                is_hidden: false,
                importance: instance.importance,
                may_refine,
                is_refined: false,
                view: None,
                revision: 0,
            }
        });
        let mut view = Self { meshes, instances: instances.collect(), lods: lods.clone(), factor: 1.0 };
        for instance in &mut view.instances {
            instance.may_refine &= view.meshes[instance.mesh].as_ref().is_some_and(|mesh| !mesh.is_morphed);
        }
        view
    }

    /// Hides or shows an instance; hidden ones count in no number, and keep the triangles that they have.
    /// Instances that do not exist are ignored.
    pub fn set_hidden(&mut self, instance: usize, is_hidden: bool) {
        if let Some(instance) = self.instances.get_mut(instance) {
            instance.is_hidden = is_hidden;
        }
    }

    /// Sets how much the errors of an instance count, 1e-6 to 1e6: 2 allows it half of the pixels that others may err
    /// by. At first it is [`SceneInstance::importance`]. Instances that do not exist, and values that are not positive
    /// numbers, are ignored.
    pub fn set_importance(&mut self, instance: usize, importance: f64) {
        if let (Some(instance), Some(importance)) =
            (self.instances.get_mut(instance), SceneInstance::usable_importance(importance))
        {
            instance.importance = importance;
        }
    }

    /// Whether an instance is hidden.
    pub fn is_hidden(&self, instance: usize) -> bool {
        self.instances.get(instance).is_some_and(|instance| instance.is_hidden)
    }

    /// Shows a level of the whole scene. Cost: linear in the triangles of the meshes whose level changes.
    pub fn show_level(&mut self, level: &SceneLevel) {
        for (mesh, split_count) in self.meshes.iter_mut().zip(&level.split_counts) {
            if let Some(mesh) = mesh {
                mesh.move_to(*split_count);
            }
        }
        self.instances.iter_mut().for_each(|instance| instance.is_refined = false);
    }

    /// Refines what the camera sees until no error covers more pixels than the criterion allows. `drawn` says
    /// where the instances are, in the order of the scene; missing ones show what they did.
    pub fn update(&mut self, error: &ScreenError, drawn: &[DrawnInstance]) {
        self.refine(error, drawn);
        self.factor = 1.0;
    }

    fn refine(&mut self, error: &ScreenError, drawn: &[DrawnInstance]) {
        let mut places: Vec<Vec<PlacedSphere>> = vec![Vec::new(); self.meshes.len()];
        for (instance, drawn) in self.instances.iter_mut().zip(drawn) {
            if instance.is_hidden {
                continue;
            }
            let (Some(mesh), Some(lod)) = (&self.meshes[instance.mesh], &self.lods.lods()[instance.mesh])
            else {
                continue;
            };
            let inside = if instance.may_refine { error.in_object(&drawn.world) } else { None };
            instance.is_refined = inside.is_some();
            match inside {
                Some(inside) => instance.refine(lod, inside),
                None => {
                    let of_instance = PlacedSphere::of(drawn, &mesh.sphere).into_iter();
                    let important = of_instance.map(|place| place.with_importance(instance.importance));
                    places[instance.mesh].extend(important);
                }
            }
        }
        let lods = self.lods.lods();
        for ((mesh, lod), places) in self.meshes.iter_mut().zip(lods).zip(places) {
            if let (Some(mesh), Some(lod), false) = (mesh, lod, places.is_empty()) {
                mesh.move_to(place::split_count(lod, &places, error));
            }
        }
    }

    /// Number of triangles of the instances that are not hidden.
    pub fn triangle_count(&self) -> usize {
        let shown = (0..self.instances.len()).filter(|&instance| !self.is_hidden(instance));
        shown.map(|instance| self.shown(instance).map_or(0, |shown| shown.indices.len() / 3)).sum()
    }

    /// Returns the indices that an instance shows; [`None`] if it does not exist, or its mesh has no triangles.
    pub fn shown(&self, instance: usize) -> Option<ShownIndices<'_>> {
        let state = self.instances.get(instance)?;
        let mesh = self.meshes[state.mesh].as_ref()?;
        Some(match &state.view {
            Some(view) if state.is_refined => ShownIndices {
                list: self.meshes.len() + instance,
                revision: state.revision,
                indices: view.indices(),
                groups: view.groups(),
            },
            _ => ShownIndices {
                list: state.mesh,
                revision: mesh.revision,
                indices: mesh.level.indices(),
                groups: mesh.level.groups(),
            },
        })
    }
}

impl UniformMesh {
    fn new(lod: &Lod) -> Self {
        let sphere = sphere_around(lod.mesh());
        let is_morph = |semantic: &Semantic| matches!(semantic, Semantic::MorphPosition(_));
        let is_morphed = lod.mesh().layers.iter().any(|layer| is_morph(&layer.semantic));
        Self { level: lod.level(Target::SplitCount(0)), revision: 0, sphere, is_morphed }
    }

    fn move_to(&mut self, split_count: usize) {
        if self.level.split_count() != split_count {
            self.level.move_to(Target::SplitCount(split_count));
            self.revision += 1;
        }
    }
}

impl InstanceView {
    fn refine(&mut self, lod: &Lod, error: ScreenError) {
        let view = self.view.get_or_insert_with(|| Box::new(lod.view()));
        let update = view.update_by(error.relaxed((1.0 / self.importance) as f32));
        if update.split_count + update.collapse_count > 0 {
            self.revision += 1;
        }
    }
}
