//! A scene that was read: its levels, poses and appearance, ready to be uploaded.

use striata::mesh::{Bounds, Semantic};
use striata_command::failure::Failure;
use striata_gpu::{LitImage, LitMaterial, Look};
use striata_scene::drawn::{ImageLimits, decode_images, materials};
use striata_scene::{LodScene, Pose, Poser};

use super::tree::{TreeRow, printable, tree_rows};
use crate::lit::{lit_image, lit_material};
use crate::picture::in_parallel;
use crate::window::subject::Origin;

/// Memory for all decoded images, bytes.
const IMAGE_BYTES: u64 = 1 << 29;

/// A scene with its levels.
#[derive(Debug)]
pub(in crate::window) struct SceneSubject {
    pub origin: Origin,
    pub lods: LodScene,
    pub poser: Poser,
    /// Materials of the document, and stone if the scene does not say how it looks.
    pub materials: Vec<LitMaterial>,
    pub images: Vec<LitImage>,
    /// Names and average colors, linear light, of the materials of the document.
    pub swatches: Vec<(String, [f32; 3])>,
    /// Material of each primitive of each mesh.
    pub primitive_materials: Vec<Vec<Option<usize>>>,
    pub rows: Vec<TreeRow>,
    /// Box around everything without animation.
    pub bounds: Bounds,
}

impl SceneSubject {
    /// Prepares a scene; returns it with warnings about images.
    ///
    /// # Errors
    /// If its animations or skins are malformed.
    pub(in crate::window) fn new(
        origin: Origin,
        lods: LodScene,
        is_double_sided: bool,
    ) -> Result<(Self, Vec<String>), Failure> {
        let scene = lods.scene();
        let poser = Poser::new(scene).map_err(|error| Failure::user(format!("{}: {error}", origin.name)))?;
        let mut read = materials(scene);
        let limits = ImageLimits::default().with_total_bytes(IMAGE_BYTES);
        let decoded = decode_images(scene, &mut read, &limits, |count, decode| in_parallel(count, decode));
        read.iter_mut().for_each(|material| material.is_double_sided |= is_double_sided);
        let images: Vec<LitImage> = decoded.images.iter().map(|image| lit_image(image.as_ref())).collect();
        let mut materials: Vec<LitMaterial> = read.iter().map(lit_material).collect();
        let meshes = 0..scene.meshes().len();
        let mut primitive_materials: Vec<Vec<Option<usize>>> =
            meshes.map(|mesh| known(scene.primitive_materials(mesh), materials.len())).collect();
        let swatches = materials.iter().enumerate().map(|(index, material)| {
            let name = printable(&material.name);
            let name = if name.is_empty() { format!("material {index}") } else { name };
            (name, average_color(material, &images))
        });
        let swatches = swatches.collect();
        if !has_look(&lods, &primitive_materials) {
            primitive_materials.iter_mut().flatten().for_each(|slot| *slot = Some(materials.len()));
            materials.push(stone());
        }
        let bounds = bounds_of(&lods, &poser, &poser.rest_pose(), 0..scene.instances().len());
        let bounds = bounds.unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] });
        let rows = tree_rows(scene);
        let subject =
            Self { origin, poser, materials, images, swatches, primitive_materials, rows, bounds, lods };
        Ok((subject, decoded.warnings))
    }

    /// Whether the document has materials.
    pub(in crate::window) fn has_materials(&self) -> bool {
        !self.swatches.is_empty()
    }

    /// Returns the average color of a material, linear light as bytes; opacity 0 stands for stone.
    pub(super) fn plain_color(&self, material: Option<usize>) -> [u8; 4] {
        let known = |material: usize| Some(self.swatches.get(material)?.1);
        match material.and_then(known) {
            Some(color) => {
                let [red, green, blue] = color.map(|x| (255.0 * x).round() as u8);
                [red, green, blue, 255]
            }
            None => [255, 255, 255, 0],
        }
    }

    /// Number of triangles of an instance at full detail.
    pub(super) fn full_triangles_of(&self, instance: usize) -> usize {
        let mesh = self.lods.scene().instances().get(instance).map(|instance| instance.mesh);
        let lod = mesh.and_then(|mesh| self.lods.lods()[mesh].as_ref());
        lod.map_or(0, |lod| lod.mesh().triangle_count())
    }

    /// Returns the box around some instances in a pose; [`None`] if they have no vertices.
    pub(super) fn bounds_in(&self, pose: &Pose, instances: impl Iterator<Item = usize>) -> Option<Bounds> {
        bounds_of(&self.lods, &self.poser, pose, instances)
    }
}

fn bounds_of(
    lods: &LodScene,
    poser: &Poser,
    pose: &Pose,
    instances: impl Iterator<Item = usize>,
) -> Option<Bounds> {
    let mut bounds: Option<Bounds> = None;
    for instance in instances.filter_map(|index| lods.scene().instances().get(index)) {
        let Some(lod) = &lods.lods()[instance.mesh] else { continue };
        let positions = poser.positions(pose, instance, lod.mesh());
        for position in positions.into_iter().filter(|position| position.iter().all(|x| x.is_finite())) {
            let all = bounds.get_or_insert(Bounds { min: position, max: position });
            for (axis, x) in position.into_iter().enumerate() {
                (all.min[axis], all.max[axis]) = (all.min[axis].min(x), all.max[axis].max(x));
            }
        }
    }
    bounds
}

/// Replaces references to materials that do not exist by none.
fn known(materials: Vec<Option<usize>>, count: usize) -> Vec<Option<usize>> {
    materials.into_iter().map(|material| material.filter(|&material| material < count)).collect()
}

/// Whether the scene says how it looks: a shown primitive has a material or vertex colors.
fn has_look(lods: &LodScene, primitive_materials: &[Vec<Option<usize>>]) -> bool {
    lods.scene().instances().iter().any(|instance| {
        let lod = lods.lods()[instance.mesh].as_ref();
        let has_colors = lod.is_some_and(|lod| lod.mesh().layer(&Semantic::Color(0)).is_some());
        has_colors || primitive_materials[instance.mesh].iter().any(Option::is_some)
    })
}

/// Returns the average color of a material, linear light: what it emits if it reflects nothing.
fn average_color(material: &LitMaterial, images: &[LitImage]) -> [f32; 3] {
    let texture = material.base_color_texture.as_ref().and_then(|texture| images.get(texture.image));
    let texture = texture.map_or([1.0; 3], average);
    let [red, green, blue, _] = material.base_color;
    let factor = if [red, green, blue] == [0.0; 3] { material.emissive } else { [red, green, blue] };
    [0, 1, 2].map(|k| (factor[k] * texture[k]).clamp(0.0, 1.0))
}

/// Returns the average color of an image, linear light, from some of its pixels.
fn average(image: &LitImage) -> [f32; 3] {
    const SAMPLES: usize = 4096;
    let pixels = image.rgba.as_chunks::<4>().0;
    let step = (pixels.len() / SAMPLES).max(1);
    let (mut sum, mut count) = ([0.0f32; 3], 0.0f32);
    for &[red, green, blue, alpha] in pixels.iter().step_by(step) {
        let opacity = f32::from(alpha) / 255.0;
        count += opacity;
        for (sum, channel) in sum.iter_mut().zip([red, green, blue]) {
            // Close enough to the transfer function of sRGB for a swatch.
            *sum += opacity * (f32::from(channel) / 255.0).powf(2.2);
        }
    }
    if count > 0.0 { sum.map(|sum| sum / count) } else { [1.0; 3] }
}

/// The material of scenes that do not say how they look.
fn stone() -> LitMaterial {
    let [red, green, blue] = Look::default().base;
    LitMaterial {
        name: "stone".to_owned(),
        base_color: [red, green, blue, 1.0],
        metallic: 0.0,
        roughness: 0.8,
        is_double_sided: true,
        ..LitMaterial::default()
    }
}
