//! Draws surfaces with materials on a GPU.

use std::sync::Arc;

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};
use striata_gpu::{
    AlphaMode as GpuAlphaMode, Canvas as GpuCanvas, Environment, Gpu, GpuError, GpuIndices, LitCamera,
    LitFrame, LitImage, LitLight, LitLightKind, LitMaterial, LitMaterials, LitObject, LitPainter, LitPart,
    LitScene, LitVertices, TextureFilter, TextureSampler, TextureUse as GpuTextureUse, TextureWrap,
};
use striata_scene::drawn::{AlphaMode, Light, LightKind, Material, TextureUse, Wrap};

use super::Camera;
use super::camera::{dot as dot64, sub as sub64, to_f64};
use super::scene_look::SceneLook;
use super::shot::{LineTriangles, Shot};

/// What pictures with materials share: the shader, and the materials of the last look.
#[derive(Debug)]
pub(super) struct LookPainter {
    painter: LitPainter,
    /// Materials with the number of their look; the last one is for lines.
    materials: Option<(u64, LitMaterials)>,
}

/// A shot with materials on the GPU.
pub(super) struct UploadedLook {
    pub(super) frame: LitFrame,
}

impl LookPainter {
    pub(super) fn new(gpu: &Gpu, samples: u32) -> Self {
        Self { painter: LitPainter::new(gpu, GpuCanvas::FORMAT, samples), materials: None }
    }

    /// Uploads a shot, whose materials stay for the next one with the same look.
    ///
    /// # Errors
    /// If the GPU runs out of memory.
    pub(super) fn upload(
        &mut self,
        gpu: &Gpu,
        shot: &Shot<'_>,
        (look, camera, size): (&SceneLook, &Camera, [u32; 2]),
    ) -> Result<UploadedLook, GpuError> {
        if self.materials.as_ref().is_none_or(|(id, _)| *id != look.id()) {
            self.materials = Some((look.id(), upload_materials(gpu, &self.painter, look)?));
        }
        let Some((_, materials)) = &self.materials else {
            return Err(GpuError::Failed("no materials were uploaded".to_owned()));
        };
        let painter = &self.painter;
        let surface = surface_of(shot);
        let vertices = LitVertices::upload(gpu, painter, &surface)?;
        let (triangles, parts) = parts_of(shot, look, camera);
        let indices = GpuIndices::upload(gpu, triangles.as_flattened())?;
        let mut objects = vec![LitObject::new(&vertices, &indices, &parts)];
        let lines = LineTriangles::new(&shot.lines, camera, 0);
        let line_mesh = line_mesh(&lines);
        let line_vertices = LitVertices::upload(gpu, painter, &line_mesh)?;
        let line_indices = GpuIndices::upload(gpu, line_mesh.triangles.as_flattened())?;
        let range = 0..3 * line_mesh.triangles.len() as u32;
        let line_parts = [LitPart { range, material: Some(look.materials.len()) }];
        if !line_mesh.triangles.is_empty() {
            objects.push(LitObject::new(&line_vertices, &line_indices, &line_parts));
        }
        let lights: Vec<LitLight> = look.lights.iter().take(LitFrame::MAX_LIGHT_COUNT).map(light).collect();
        let [eye, look_at, up] = [camera.eye, camera.look_at, camera.up].map(to_f64);
        let camera = LitCamera { eye, look_at, up, fov: f64::from(camera.fov) };
        let scene = LitScene { camera, size, lights: &lights, materials, objects: &objects };
        let mut frame = LitFrame::new(gpu, painter, &Environment::studio())?;
        frame.update(gpu, painter, &scene)?;
        Ok(UploadedLook { frame })
    }
}

fn upload_materials(gpu: &Gpu, painter: &LitPainter, look: &SceneLook) -> Result<LitMaterials, GpuError> {
    let unused = || LitImage { width: 1, height: 1, rgba: Arc::from([255; 4]) };
    let images: Vec<LitImage> = look
        .images
        .iter()
        .map(|image| {
            image.as_ref().map_or_else(unused, |image| LitImage {
                width: image.width,
                height: image.height,
                rgba: Arc::clone(&image.rgba),
            })
        })
        .collect();
    let lines = LitMaterial { is_unlit: true, is_double_sided: true, ..LitMaterial::default() };
    let materials: Vec<LitMaterial> = look.materials.iter().map(material).chain([lines]).collect();
    LitMaterials::upload(gpu, painter, &materials, &images)
}

/// Returns the vertices of a shot with the attributes that its style needs.
fn surface_of<'a>(shot: &Shot<'a>) -> std::borrow::Cow<'a, IndexedMesh> {
    let mesh = shot.vertices;
    if !shot.is_flat || mesh.layer(&Semantic::Normal).is_none() {
        return std::borrow::Cow::Borrowed(mesh);
    }
    let layers = mesh.layers.iter().filter(|layer| layer.semantic != Semantic::Normal);
    std::borrow::Cow::Owned(IndexedMesh {
        layers: layers.cloned().collect(),
        ..IndexedMesh::new(mesh.positions.clone(), Vec::new())
    })
}

/// Returns the triangles with a part for each run of one material; transparent ones come last, from back to
/// front.
fn parts_of(shot: &Shot<'_>, look: &SceneLook, camera: &Camera) -> (Vec<[u32; 3]>, Vec<LitPart>) {
    let is_blended = |material: Option<u32>| {
        let material = material.and_then(|material| look.materials.get(material as usize));
        material.is_some_and(|material| material.alpha_mode == AlphaMode::Blend)
    };
    let (mut opaque, mut blended) = (Vec::new(), Vec::new());
    for group in shot.vertices.groups_or_whole() {
        let list = if is_blended(group.material) { &mut blended } else { &mut opaque };
        let triangles = shot.triangles.get(group.range()).unwrap_or_default();
        list.extend(triangles.iter().map(|&triangle| (group.material, triangle)));
    }
    let [_, _, back] = camera.axes();
    let eye = to_f64(camera.eye);
    let distance = |&(_, triangle): &(Option<u32>, [u32; 3])| {
        let depth = |v: u32| -dot64(sub64(to_f64(shot.vertices.positions[v as usize]), eye), back);
        // Like the rasterizer, which adds inverse depths.
        triangle.map(|v| 1.0 / depth(v).max(1e-30)).iter().sum::<f64>()
    };
    blended.sort_by_cached_key(|entry| ordered(distance(entry)));
    let mut triangles = Vec::with_capacity(opaque.len() + blended.len());
    let mut parts = Vec::new();
    for run in opaque.chunk_by(|a, b| a.0 == b.0).chain(blended.chunk_by(|a, b| a.0 == b.0)) {
        let start = 3 * triangles.len() as u32;
        triangles.extend(run.iter().map(|(_, triangle)| *triangle));
        let material = run[0].0.map(|material| material as usize).filter(|&m| m < look.materials.len());
        parts.push(LitPart { range: start..3 * triangles.len() as u32, material });
    }
    (triangles, parts)
}

/// A positive number as an integer in the same order.
fn ordered(number: f64) -> u64 {
    number.max(0.0).to_bits()
}

/// Returns lines as a mesh with a color for each vertex.
fn line_mesh(lines: &LineTriangles) -> IndexedMesh {
    let mut mesh = IndexedMesh::new(lines.positions.clone(), lines.triangles.clone());
    let mut colors = vec![[1.0; 4]; lines.positions.len()];
    for (triangle, color) in lines.triangles.iter().zip(&lines.colors) {
        triangle.iter().for_each(|&v| colors[v as usize] = color.map(|byte| f32::from(byte) / 255.0));
    }
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Color(0), 4, colors.into_flattened()));
    mesh
}

fn material(material: &Material) -> LitMaterial {
    let texture = |texture: &Option<TextureUse>| texture.as_ref().map(texture_use);
    LitMaterial {
        name: material.name.clone(),
        base_color: material.base_color,
        base_color_texture: texture(&material.base_color_texture),
        metallic: material.metallic,
        roughness: material.roughness,
        metallic_roughness_texture: texture(&material.metallic_roughness_texture),
        normal_texture: texture(&material.normal_texture),
        normal_scale: material.normal_scale,
        occlusion_texture: texture(&material.occlusion_texture),
        occlusion_strength: material.occlusion_strength,
        emissive: material.emissive,
        emissive_texture: texture(&material.emissive_texture),
        alpha_mode: match material.alpha_mode {
            AlphaMode::Opaque => GpuAlphaMode::Opaque,
            AlphaMode::Mask(cutoff) => GpuAlphaMode::Mask { cutoff },
            AlphaMode::Blend => GpuAlphaMode::Blend,
        },
        is_double_sided: material.is_double_sided,
        is_unlit: material.is_unlit,
    }
}

fn texture_use(texture: &TextureUse) -> GpuTextureUse {
    let wrap = |wrap| match wrap {
        Wrap::Repeat => TextureWrap::Repeat,
        Wrap::MirroredRepeat => TextureWrap::Mirror,
        Wrap::ClampToEdge => TextureWrap::Clamp,
    };
    let sampler = TextureSampler {
        wrap: texture.sampler.wrap.map(wrap),
        mag_filter: if texture.sampler.is_smooth { TextureFilter::Linear } else { TextureFilter::Nearest },
        min_filter: TextureFilter::Linear,
        mip_filter: texture.sampler.has_mip_maps.then_some(TextureFilter::Linear),
    };
    GpuTextureUse { image: texture.image, sampler, uv_set: texture.uv_set, uv_transform: texture.transform.0 }
}

fn light(light: &Light) -> LitLight {
    let kind = match light.kind {
        LightKind::Directional => LitLightKind::Directional,
        LightKind::Point => LitLightKind::Point,
        LightKind::Spot { inner_cos, outer_cos } => {
            LitLightKind::Spot { inner_angle: inner_cos.acos(), outer_angle: outer_cos.acos() }
        }
    };
    LitLight {
        kind,
        color: light.color,
        position: to_f64(light.position),
        direction: light.direction,
        range: light.range,
    }
}
