//! Materials on the GPU: their textures, and what the shader binds for each.

use std::collections::HashMap;

use bytemuck::{Pod, Zeroable, bytes_of};
use striata_scene::drawn::{AlphaMode, Material, Sampler};
use striata_scene::textures::RgbaImage;
use wgpu::{BindGroup, BindingResource, BufferUsages};

use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::lit::textures::{create_sampler, upload_image};
use crate::gpu::painter::Painter;
use crate::gpu::pipelines::bind;
use crate::material_images::{UsedImage, material_images};
use crate::mips::ImageMeaning;

/// Materials of a scene with their textures, uploaded once for all pictures.
///
/// An image that is used in two ways, for example as a color and as numbers, becomes two textures. A texture
/// takes 5.3 bytes per pixel.
#[derive(Debug)]
pub struct LitMaterials {
    /// The materials, then the default one for triangles that have none.
    pub(crate) entries: Vec<MaterialEntry>,
}

/// A material and what is bound for it.
#[derive(Debug)]
pub(crate) struct MaterialEntry {
    pub material: Material,
    pub bindings: BindGroup,
}

/// Uniform data of a material, laid out as in `material.wgsl`.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct MaterialData {
    base_color: [f32; 4],
    emissive: [f32; 4],
    factors: [f32; 4],
    flags: [u32; 4],
    uses: [[[f32; 4]; 2]; 5],
}

impl LitMaterials {
    /// Uploads materials and the images that they use.
    ///
    /// Images larger than the device allows are drawn from their first mip level that fits.
    ///
    /// # Errors
    /// [`GpuError::NoSuchImage`] if a material uses an image that does not exist, [`GpuError::ImageSize`] if
    /// an image is empty or has too few or too many bytes.
    pub fn upload(
        gpu: &Gpu,
        painter: &Painter,
        materials: &[Material],
        images: &[Option<RgbaImage>],
    ) -> Result<Self, GpuError> {
        let white = RgbaImage { width: 1, height: 1, rgba: [255; 4].into() };
        let white = upload_image(gpu, &white, ImageMeaning::Linear);
        let plain = create_sampler(gpu, Sampler::default());
        let (mut textures, mut samplers) = (HashMap::new(), HashMap::new());
        let mut entries = Vec::with_capacity(materials.len() + 1);
        for material in materials.iter().chain([&Material::default()]) {
            let (mut of_views, mut of_samplers) =
                ([&white; 5].map(Clone::clone), [&plain; 5].map(Clone::clone));
            for (slot, used) in images_of(material).into_iter().enumerate() {
                let Some((used, meaning)) = used else { continue };
                let image_count = images.len();
                let image = images.get(used.image).and_then(Option::as_ref).ok_or_else(|| {
                    GpuError::NoSuchImage { material: material.name.clone(), image: used.image, image_count }
                })?;
                check(image, used.image)?;
                let texture = textures.entry((used.image, meaning));
                of_views[slot] = texture.or_insert_with(|| upload_image(gpu, image, meaning)).clone();
                let sampler = samplers.entry(used.sampler);
                of_samplers[slot] = sampler.or_insert_with(|| create_sampler(gpu, used.sampler)).clone();
            }
            let data = MaterialData::of(material);
            let buffer = gpu.buffer_of("material", bytes_of(&data), BufferUsages::UNIFORM)?;
            let views = of_views.each_ref().map(BindingResource::TextureView);
            let samplers = of_samplers.each_ref().map(BindingResource::Sampler);
            let resources = [buffer.as_entire_binding()].into_iter().chain(views).chain(samplers);
            let bindings = bind(gpu, &painter.lit(gpu).material_layout, resources);
            entries.push(MaterialEntry { material: material.clone(), bindings });
        }
        Ok(Self { entries })
    }

    /// The entry of a material, or that of the default material for [`None`].
    pub(crate) fn entry(&self, material: Option<usize>) -> Result<&MaterialEntry, GpuError> {
        let material_count = self.entries.len() - 1;
        match material {
            Some(material) if material >= material_count => {
                Err(GpuError::NoSuchMaterial { material, material_count })
            }
            material => Ok(&self.entries[material.unwrap_or(material_count)]),
        }
    }
}

/// Returns the images in the order in which the shader binds them; those with a third or later set of texture
/// coordinates are left out.
fn images_of(material: &Material) -> [Option<UsedImage<'_>>; 5] {
    material_images(material).map(|image| image.filter(|(used, _)| used.uv_set < 2))
}

/// Checks the size of an image, and that there are as many bytes as pixels need.
fn check(image: &RgbaImage, index: usize) -> Result<(), GpuError> {
    let expected_bytes = 4 * u128::from(image.width) * u128::from(image.height);
    if expected_bytes == 0 || image.rgba.len() as u128 != expected_bytes {
        let (width, height, found_bytes) = (image.width, image.height, image.rgba.len());
        return Err(GpuError::ImageSize { image: index, width, height, found_bytes });
    }
    Ok(())
}

impl MaterialData {
    fn of(material: &Material) -> Self {
        let (mode, cutoff) = match material.alpha_mode {
            AlphaMode::Opaque => (1, 0.0),
            AlphaMode::Mask(cutoff) => (2, cutoff),
            AlphaMode::Blend => (3, 0.0),
        };
        let ([red, green, blue], textures) = (material.emissive, images_of(material));
        let use_data = |used: Option<UsedImage<'_>>| {
            let Some((used, _)) = used else { return [[0.0; 4]; 2] };
            let [[a, b, c], [d, e, f]] = used.transform.0;
            [[a, b, c, f32::from(used.uv_set)], [d, e, f, 0.0]]
        };
        Self {
            base_color: material.base_color,
            emissive: [red, green, blue, material.occlusion_strength],
            factors: [material.metallic, material.roughness, material.normal_scale, cutoff],
            flags: [
                mode,
                u32::from(material.is_double_sided),
                u32::from(material.is_unlit),
                (0..5).filter(|&slot| textures[slot].is_some()).map(|slot| 1 << slot).sum(),
            ],
            uses: textures.map(use_data),
        }
    }
}
