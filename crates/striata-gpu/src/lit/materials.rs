//! Materials on the GPU: their textures, and what the shader binds for each.

use std::collections::BTreeMap;

use bytemuck::{Pod, Zeroable, bytes_of};
use wgpu::{BindGroup, BindGroupEntry, BindingResource, BufferUsages};

use crate::gpu::Gpu;
use crate::gpu_error::GpuError;
use crate::lit::image::LitImage;
use crate::lit::material::{AlphaMode, LitMaterial};
use crate::lit::mips::ImageMeaning;
use crate::lit::painter::LitPainter;
use crate::lit::texture_use::{TextureSampler, TextureUse};
use crate::lit::textures::{create_sampler, upload_image};

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
    pub material: LitMaterial,
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
        painter: &LitPainter,
        materials: &[LitMaterial],
        images: &[LitImage],
    ) -> Result<Self, GpuError> {
        let white = LitImage { width: 1, height: 1, rgba: [255; 4].into() };
        let white = upload_image(gpu, &white, ImageMeaning::Linear);
        let plain = create_sampler(gpu, TextureSampler::default());
        let (mut textures, mut samplers) = (BTreeMap::new(), BTreeMap::new());
        let mut entries = Vec::with_capacity(materials.len() + 1);
        for material in materials.iter().chain([&LitMaterial::default()]) {
            let (mut of_views, mut of_samplers) =
                ([&white; 5].map(Clone::clone), [&plain; 5].map(Clone::clone));
            for (slot, used) in material.textures().into_iter().enumerate() {
                let Some(used) = used else { continue };
                let image_count = images.len();
                let image = images.get(used.image).ok_or_else(|| GpuError::NoSuchImage {
                    material: material.name.clone(),
                    image: used.image,
                    image_count,
                })?;
                image.check(used.image)?;
                let meaning = meaning_of(material, slot);
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
            let bound: Vec<BindGroupEntry<'_>> = (0..)
                .zip(resources)
                .map(|(binding, resource)| BindGroupEntry { binding, resource })
                .collect();
            let bindings = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("material"),
                layout: &painter.material_layout,
                entries: &bound,
            });
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

/// Returns the meaning of the texture in a slot of [`LitMaterial::textures`].
fn meaning_of(material: &LitMaterial, slot: usize) -> ImageMeaning {
    let cutoff = match material.alpha_mode {
        AlphaMode::Mask { cutoff } => {
            let of_image = 255.0 * cutoff / material.base_color[3];
            (of_image > 0.5 && of_image < 255.5).then(|| of_image.ceil().clamp(1.0, 255.0) as u8)
        }
        _ => None,
    };
    match slot {
        0 => ImageMeaning::Color { cutoff },
        2 => ImageMeaning::Normal,
        4 => ImageMeaning::Color { cutoff: None },
        _ => ImageMeaning::Linear,
    }
}

impl MaterialData {
    fn of(material: &LitMaterial) -> Self {
        let (mode, cutoff) = match material.alpha_mode {
            AlphaMode::Opaque => (1, 0.0),
            AlphaMode::Mask { cutoff } => (2, cutoff),
            AlphaMode::Blend => (3, 0.0),
        };
        let ([red, green, blue], textures) = (material.emissive, material.textures());
        let use_data = |used: Option<&TextureUse>| {
            let Some(used) = used else { return [[0.0; 4]; 2] };
            let [[a, b, c], [d, e, f]] = used.uv_transform;
            [[a, b, c, f32::from(used.uv_set.min(1))], [d, e, f, 0.0]]
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
