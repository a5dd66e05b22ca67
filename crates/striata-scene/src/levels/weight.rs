//! How much each mesh counts in a scene.

use striata_io::Scene;

/// How much the errors and triangles of a mesh count in a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshWeight {
    /// Units of the scene per unit of the mesh: the largest scale among its instances.
    pub scale: f64,
    /// Number of times that its triangles are counted; 0 if nothing shows the mesh, whose errors then do not
    /// count either.
    pub instance_count: usize,
}

impl Default for MeshWeight {
    fn default() -> Self {
        Self { scale: 1.0, instance_count: 1 }
    }
}

impl MeshWeight {
    /// Returns the weights of all meshes, from their instances in the default scene.
    ///
    /// A mesh without an instance is coarsened together with the others, as if its scale were 1, but counts in
    /// no number; if nothing at all is shown, every mesh counts once. The scale of a mesh all of whose
    /// instances are flattened to a point is 1, because an animation may enlarge them.
    pub fn of_scene(scene: &Scene) -> Vec<Self> {
        let mut weights = vec![Self { scale: 0.0, instance_count: 0 }; scene.meshes().len()];
        for instance in scene.instances() {
            let weight = &mut weights[instance.mesh];
            weight.instance_count += 1;
            if instance.scale.is_finite() {
                weight.scale = weight.scale.max(instance.scale);
            }
        }
        let shows_nothing = scene.instances().is_empty();
        for weight in &mut weights {
            if shows_nothing {
                weight.instance_count = 1;
            }
            if weight.scale == 0.0 {
                weight.scale = 1.0;
            }
        }
        weights
    }
}
