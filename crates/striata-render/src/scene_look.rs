//! The materials of a scene with their images, ready to be drawn.

use std::collections::{HashMap, HashSet};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use serde_json::Value;
use striata::mesh::{Appearance, IndexedMesh, Semantic, TriangleGroup};
use striata_io::Scene;
use striata_scene::drawn::{AlphaMode, ImageLimits, Light, Material, decode_images, materials};
use striata_scene::textures::RgbaImage;

use crate::cpu::Texture;
use crate::material_images::{UsedImage, material_images};
use crate::mips::ImageMeaning;

/// Most threads that decode images or draw: more would need more memory than time they save.
const MAX_THREADS: usize = 8;

/// Materials, images and lights of a scene.
#[derive(Debug)]
pub struct SceneLook {
    /// Distinguishes looks, so that a GPU keeps the images of the last one.
    #[cfg(feature = "gpu")]
    id: u64,
    pub(crate) materials: Vec<Material>,
    /// Images in the order of the scene; [`None`] for those that no material uses.
    pub(crate) images: Vec<Option<RgbaImage>>,
    pub(crate) lights: Vec<Light>,
    /// Images with mip maps for each meaning; made by the rasterizer when it needs them.
    textures: OnceLock<HashMap<(usize, ImageMeaning), Texture>>,
    warnings: Vec<String>,
}

impl SceneLook {
    /// Whether a scene says how it looks: a shown primitive has a material or vertex colors.
    pub fn is_described(scene: &Scene) -> bool {
        scene.instances().iter().any(|instance| {
            let mesh = scene.meshes()[instance.mesh].as_ref();
            let has_colors = mesh.is_some_and(|mesh| mesh.layer(&Semantic::Color(0)).is_some());
            has_colors || scene.primitive_materials(instance.mesh).iter().any(Option::is_some)
        })
    }

    /// Reads the materials that the instances of a scene use, and decodes their images.
    pub fn of(scene: &Scene, limits: &ImageLimits) -> Self {
        let mut materials = materials(scene);
        let used = used_materials(scene, materials.len());
        // Unused materials stay in the list, so that indices stay valid, but need no images.
        for (material, _) in materials.iter_mut().zip(&used).filter(|(_, is_used)| !**is_used) {
            *material = Material::default();
        }
        let decoded =
            decode_images(scene, &mut materials, limits, |count, decode| in_parallel(count, decode));
        Self { warnings: decoded.warnings, ..Self::new(materials, decoded.images) }
    }

    /// Creates a look of materials whose images exist.
    pub fn new(materials: Vec<Material>, images: Vec<Option<RgbaImage>>) -> Self {
        Self {
            #[cfg(feature = "gpu")]
            id: next_id(),
            materials,
            images,
            lights: Vec::new(),
            textures: OnceLock::new(),
            warnings: Vec::new(),
        }
    }

    /// Whether something shines through a material.
    pub fn is_transparent(&self) -> bool {
        self.materials.iter().any(|material| material.alpha_mode == AlphaMode::Blend)
    }

    /// Number that no other look has.
    #[cfg(feature = "gpu")]
    pub(crate) fn id(&self) -> u64 {
        self.id
    }

    /// Reads the materials of a mesh from a format without scenes, which are visible from both sides, because
    /// such formats do not say otherwise. [`None`] if the mesh has no materials, or only their names.
    pub fn of_mesh(mesh: &IndexedMesh, limits: &ImageLimits) -> Option<Self> {
        if !has_materials(mesh) {
            return None;
        }
        let groups = mesh.groups_or_whole();
        let scene = Scene::from_mesh(with_one_triangle_each(&groups, &mesh.appearance)).ok()?;
        let mut look = Self::of(&scene, limits);
        look.materials.iter_mut().for_each(|material| material.is_double_sided = true);
        Some(look)
    }

    /// Sets the lights of the document; the light of the studio is always there.
    #[must_use]
    pub fn with_lights(self, lights: Vec<Light>) -> Self {
        Self { lights, ..self }
    }

    /// Images that could not be decoded, with the reasons.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Returns an image of a material with its mip maps.
    pub(crate) fn texture(&self, (used, meaning): UsedImage<'_>) -> Option<&Texture> {
        self.textures.get_or_init(|| self.make_textures()).get(&(used.image, meaning))
    }

    fn make_textures(&self) -> HashMap<(usize, ImageMeaning), Texture> {
        let images = self.materials.iter().flat_map(material_images).flatten();
        let needed: HashSet<_> = images.map(|(used, meaning)| (used.image, meaning)).collect();
        let needed = Vec::from_iter(needed);
        let textures = in_parallel(needed.len(), &|at| {
            let (image, meaning) = needed[at];
            Some((needed[at], Texture::new(self.images[image].as_ref()?, meaning)))
        });
        textures.into_iter().flatten().collect()
    }
}

/// Whether a group of a mesh has a material that says more than its name.
fn has_materials(mesh: &IndexedMesh) -> bool {
    let materials = &mesh.appearance.materials;
    let is_described = |group: &TriangleGroup| {
        let material = group.material.and_then(|material| materials.get(material as usize));
        let described = material.and_then(|material| serde_json::from_str::<Value>(&material.gltf_json).ok());
        described.is_some_and(|described| {
            described.as_object().is_some_and(|members| members.keys().any(|key| key != "name"))
        })
    };
    mesh.groups_or_whole().iter().any(is_described)
}

#[cfg(feature = "gpu")]
fn next_id() -> u64 {
    static NEXT: std::sync::atomic::AtomicU64 = std::sync::atomic::AtomicU64::new(0);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

/// Returns a mesh with a triangle for each group, which has all materials and images in use.
fn with_one_triangle_each(groups: &[TriangleGroup], appearance: &Appearance) -> IndexedMesh {
    let groups = groups.iter().zip(0..);
    let groups = groups.map(|(group, first)| TriangleGroup { first, count: 1, ..group.clone() });
    let groups: Vec<TriangleGroup> = groups.collect();
    let triangles = vec![[0, 1, 2]; groups.len()];
    IndexedMesh {
        groups,
        appearance: appearance.clone(),
        ..IndexedMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], triangles)
    }
}

/// Whether each material is used by a primitive that the scene shows.
fn used_materials(scene: &Scene, count: usize) -> Vec<bool> {
    let mut is_used = vec![false; count];
    let mut is_seen = vec![false; scene.meshes().len()];
    for instance in scene.instances() {
        if std::mem::replace(&mut is_seen[instance.mesh], true) {
            continue;
        }
        for material in scene.primitive_materials(instance.mesh).into_iter().flatten() {
            if let Some(is_used) = is_used.get_mut(material) {
                *is_used = true;
            }
        }
    }
    is_used
}

/// Calls a function for each index on several threads, and returns the results in order.
pub(crate) fn in_parallel<T: Send>(count: usize, work: &(dyn Fn(usize) -> T + Sync)) -> Vec<T> {
    let available = std::thread::available_parallelism().map_or(1, usize::from);
    let thread_count = available.min(MAX_THREADS).min(count);
    if thread_count <= 1 {
        return (0..count).map(work).collect();
    }
    let next = AtomicUsize::new(0);
    let worker = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                return done;
            }
            done.push((index, work(index)));
        }
    };
    let mut results = std::thread::scope(|scope| {
        let threads: Vec<_> = (1..thread_count).map(|_| scope.spawn(worker)).collect();
        let mut results = worker();
        for thread in threads {
            match thread.join() {
                Ok(done) => results.extend(done),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
        results
    });
    results.sort_by_key(|(index, _)| *index);
    results.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parallel_results_are_in_order() {
        let squares = in_parallel(1000, &|index| index * index);
        assert!(squares.iter().enumerate().all(|(index, &square)| square == index * index));
        assert_eq!(in_parallel(0, &|index| index), Vec::<usize>::new());
    }
}
