//! Levels of a scene for a camera: detail where errors would be visible.
//!
//! A mesh that one node shows with a similarity transform is refined vertex by vertex, in its own units. The
//! triangles of other meshes, which have several instances, are deformed or are stretched, must suit every
//! place where they are shown: they get the coarsest level whose error is invisible in all of them.

use striata::mesh::{IndexedMesh, Semantic, TriangleGroup};
use striata::view::ScreenError;
use striata::{Lod, Target};
use striata_io::{Scene, SceneInstance};

use crate::lod_scene::LodScene;
use crate::place::{PlacedSphere, sphere_around, split_count};

/// Number of tolerances that are tried for a triangle limit, and the largest factor between them.
const BUDGET_ROUNDS: usize = 32;
const LARGEST_FACTOR: f32 = 1e6;

impl LodScene {
    /// Returns the scene refined until no error covers more pixels than the criterion allows, and coarse
    /// where the camera sees nothing. Camera and region are in units of the scene.
    pub fn view_scene(&self, error: &ScreenError) -> Scene {
        self.scene_with(self.viewed_meshes(error))
    }

    /// Returns the scene for the smallest tolerance, but at least that of the criterion, with which it has at
    /// most `triangle_limit` triangles, and this tolerance as a factor of the criterion's; the base scene if
    /// even that has more.
    pub fn view_scene_within(&self, error: &ScreenError, triangle_limit: usize) -> (Scene, f32) {
        let shown = self.viewed_meshes(error);
        if self.triangles_of(&shown) <= triangle_limit {
            return (self.scene_with(shown), 1.0);
        }
        let (mut low, mut high) = (0.0, LARGEST_FACTOR.ln());
        let mut best = None;
        for _ in 0..BUDGET_ROUNDS {
            let middle = f32::midpoint(low, high);
            let shown = self.viewed_meshes(&error.clone().relaxed(middle.exp()));
            if self.triangles_of(&shown) <= triangle_limit {
                (high, best) = (middle, Some(shown));
            } else {
                low = middle;
            }
        }
        match best {
            Some(shown) => (self.scene_with(shown), high.exp()),
            None => (self.level_scene(&self.level(Target::Detail(0.0))), LARGEST_FACTOR),
        }
    }

    fn viewed_meshes(&self, error: &ScreenError) -> Vec<Option<IndexedMesh>> {
        let viewed = self.lods().iter().enumerate();
        viewed.map(|(mesh, lod)| Some(self.viewed(mesh, lod.as_ref()?, error))).collect()
    }

    fn scene_with(&self, meshes: Vec<Option<IndexedMesh>>) -> Scene {
        let scene = self.scene().clone().with_meshes(meshes);
        scene.expect("the groups of each mesh were checked, and every view has them all")
    }

    fn triangles_of(&self, meshes: &[Option<IndexedMesh>]) -> usize {
        let counts = meshes.iter().enumerate().filter_map(|(mesh, shown)| {
            let count = self.levels().weight(mesh).map_or(1, |weight| weight.instance_count);
            Some(shown.as_ref()?.triangle_count() * count)
        });
        counts.sum()
    }

    /// Returns the triangles of a mesh for a view.
    fn viewed(&self, mesh: usize, lod: &Lod, error: &ScreenError) -> IndexedMesh {
        let instances: Vec<&SceneInstance> =
            self.scene().instances().iter().filter(|instance| instance.mesh == mesh).collect();
        let is_morphed =
            lod.mesh().layers.iter().any(|layer| matches!(layer.semantic, Semantic::MorphPosition(_)));
        if let [instance @ SceneInstance { skin: None, transform, .. }] = instances[..]
            && !is_morphed
            && let Some(inside) = error.in_object(transform)
        {
            return refined(lod, inside.relaxed((1.0 / instance.importance) as f32));
        }
        lod.level_mesh(Target::SplitCount(uniform_level(lod, &instances, error)))
    }
}

/// Returns a mesh refined vertex by vertex.
fn refined(lod: &Lod, error: ScreenError) -> IndexedMesh {
    let mut view = lod.view();
    view.update_by(error);
    let mut mesh = lod.mesh().clone();
    mesh.triangles = view.triangles().to_vec();
    mesh.triangle_layers.clear();
    for (group, range) in mesh.groups.iter_mut().zip(view.groups()) {
        *group = TriangleGroup {
            first: range.start / 3,
            count: (range.end - range.start) / 3,
            ..std::mem::take(group)
        };
    }
    mesh.take_nearest_triangle_layers(lod.mesh());
    mesh.without_unused_vertices()
}

/// Returns the split count of the coarsest level whose error is allowed in all instances.
fn uniform_level(lod: &Lod, instances: &[&SceneInstance], error: &ScreenError) -> usize {
    let sphere = sphere_around(lod.mesh());
    let place_of = |instance: &&SceneInstance| {
        let matrix = glam::DMat4::from_cols_array(&instance.transform);
        PlacedSphere::new(&matrix, instance.scale, &sphere).with_importance(instance.importance)
    };
    let places: Vec<PlacedSphere> = instances.iter().map(place_of).collect();
    split_count(lod, &places, error)
}
