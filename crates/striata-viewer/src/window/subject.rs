//! Subject of the window: one mesh with its models, or a scene.

use std::sync::Arc;

use striata::mesh::Bounds;
use striata::view::Sphere;

use super::mesh_subject::MeshSubject;
use super::scene::SceneSubject;

/// Origin of a subject.
#[derive(Clone, Debug, Default)]
pub(super) struct Origin {
    /// File name.
    pub name: String,
    /// Kind of file, in one word.
    pub kind: &'static str,
    /// File size in bytes; none for generated shapes.
    pub file_bytes: Option<usize>,
    /// Whether the file contains a scene: nodes, materials or animations.
    pub has_scene: bool,
}

/// An opened file. Clones share their data.
#[derive(Clone, Debug)]
pub(super) enum Subject {
    /// One mesh, in any model.
    Mesh(Arc<MeshSubject>),
    /// A scene with its materials.
    Scene(Arc<SceneSubject>),
}

impl Subject {
    /// The mesh, if the subject is one mesh.
    pub(super) fn mesh(&self) -> Option<&Arc<MeshSubject>> {
        match self {
            Self::Mesh(mesh) => Some(mesh),
            Self::Scene(_) => None,
        }
    }

    /// The scene, if the subject is a scene.
    pub(super) fn scene(&self) -> Option<&Arc<SceneSubject>> {
        match self {
            Self::Mesh(_) => None,
            Self::Scene(scene) => Some(scene),
        }
    }

    /// Origin of the subject: the name, kind and size of its file.
    pub(super) fn origin(&self) -> &Origin {
        match self {
            Self::Mesh(mesh) => &mesh.origin,
            Self::Scene(scene) => &scene.origin,
        }
    }

    /// Number of triangles at full detail; those of a scene count once for each instance.
    pub(super) fn triangle_count(&self) -> usize {
        match self {
            Self::Mesh(mesh) => mesh.steps.mesh().triangle_count(),
            Self::Scene(scene) => scene.lods.triangle_count(),
        }
    }

    /// Number of triangles of the coarsest level.
    pub(super) fn base_triangle_count(&self) -> usize {
        match self {
            Self::Mesh(mesh) => mesh.steps.levels().triangle_count_at(0),
            Self::Scene(scene) => scene.lods.levels().base_triangle_count(),
        }
    }

    /// Whether a mesh has collapses, which all models except patterns and the list need.
    pub(super) fn has_collapses(&self) -> bool {
        self.mesh().is_none_or(|mesh| mesh.has_collapses())
    }

    /// Whether the subject is a terrain, whose up is z.
    pub(super) fn is_terrain(&self) -> bool {
        self.mesh().is_some_and(|mesh| !mesh.steps.mesh().appearance.georeference.is_empty())
    }

    /// Box around everything in its first pose.
    pub(super) fn bounds(&self) -> Bounds {
        match self {
            Self::Mesh(mesh) => mesh.bounds,
            Self::Scene(scene) => scene.bounds,
        }
    }

    /// Sphere around everything in its first pose.
    pub(super) fn sphere(&self) -> Sphere {
        match self {
            Self::Mesh(mesh) => mesh.sphere,
            Self::Scene(scene) => {
                let Bounds { min, max } = scene.bounds;
                let center = std::array::from_fn(|k| f32::midpoint(min[k], max[k]));
                Sphere { center, radius: (scene.bounds.diagonal() / 2.0) as f32 }
            }
        }
    }
}
