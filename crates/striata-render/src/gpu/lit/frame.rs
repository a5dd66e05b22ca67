//! A frame: the objects, lights and camera that it shows, and its draw calls in order.

use std::ops::Range;

use bytemuck::bytes_of;
use glam::DVec3;
use striata_scene::drawn::{AlphaMode, Light, Material};
use wgpu::{
    BindGroup, BindingResource, Buffer, BufferUsages, Face, FilterMode, IndexFormat, RenderPass,
    RenderPipeline, SamplerDescriptor, TextureFormat,
};

use crate::camera::{Camera, to_f64};
use crate::environment::Environment;
use crate::environment_table::{COLUMN_COUNT, EnvironmentTable, ROW_COUNT};
use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::indices::GpuIndices;
use crate::gpu::lit::frame_data::{FrameData, MAX_LIGHT_COUNT};
use crate::gpu::lit::materials::LitMaterials;
use crate::gpu::lit::program::{LitProgram, PipelineKey};
use crate::gpu::lit::textures::upload_table;
use crate::gpu::painter::Painter;
use crate::gpu::pipelines::bind;
use crate::gpu::vertices::{BUFFER_COUNT, GpuVertices};

/// Triangles that share a material.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LitPart {
    /// Range of the indices, three per triangle.
    pub range: Range<u32>,
    /// Material; [`None`] is glTF's default material.
    pub material: Option<usize>,
}

/// A mesh at some level.
#[derive(Clone, Copy, Debug)]
pub struct LitObject<'a> {
    /// The vertices of all levels.
    pub vertices: &'a GpuVertices,
    /// The indices of a level.
    pub indices: &'a GpuIndices,
    /// The parts of the level.
    pub parts: &'a [LitPart],
}

/// Everything that a frame shows.
#[derive(Clone, Copy, Debug)]
pub struct LitScene<'a> {
    /// The camera.
    pub camera: &'a Camera,
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
    /// Lights besides the environment.
    pub lights: &'a [Light],
    /// The materials.
    pub materials: &'a LitMaterials,
    /// The objects.
    pub objects: &'a [LitObject<'a>],
}

/// The draw calls of a scene under an environment.
#[derive(Debug)]
pub struct LitFrame {
    bindings: BindGroup,
    draws: Vec<Draw>,
}

/// A draw call with everything that it reads.
#[derive(Debug)]
struct Draw {
    pipeline: RenderPipeline,
    material: BindGroup,
    object: BindGroup,
    vertices: [Buffer; BUFFER_COUNT],
    indices: Buffer,
    range: Range<u32>,
}

impl LitFrame {
    /// Largest number of lights in a frame.
    pub const MAX_LIGHT_COUNT: usize = MAX_LIGHT_COUNT;

    /// Prepares to draw a scene.
    ///
    /// # Errors
    /// [`GpuError::NoSuchMaterial`] and [`GpuError::IndexRange`] if a part uses something that does not
    /// exist, and [`GpuError::TooManyLights`].
    pub fn new(
        gpu: &Gpu,
        painter: &Painter,
        environment: &Environment,
        scene: &LitScene<'_>,
    ) -> Result<Self, GpuError> {
        if scene.lights.len() > MAX_LIGHT_COUNT {
            let (count, limit) = (scene.lights.len(), MAX_LIGHT_COUNT);
            return Err(GpuError::TooManyLights { count, limit });
        }
        let near = scene.objects.iter().map(|object| object.vertices.near_plane(scene.camera));
        let near = near.fold(1e30, f64::min);
        let data = FrameData::new(scene.camera, scene.size, near, environment, scene.lights);
        let program = painter.lit(gpu);
        let bindings = frame_bindings(gpu, program, environment, bytes_of(&data))?;
        Ok(Self { bindings, draws: sorted_draws(gpu, program, scene)? })
    }

    /// Draws the scene: opaque and masked parts first, then blended ones from back to front.
    pub fn draw(&self, pass: &mut RenderPass<'_>) {
        pass.set_bind_group(0, &self.bindings, &[]);
        for draw in &self.draws {
            pass.set_pipeline(&draw.pipeline);
            pass.set_bind_group(1, &draw.material, &[]);
            pass.set_bind_group(2, &draw.object, &[]);
            for (slot, buffer) in (0..).zip(&draw.vertices) {
                pass.set_vertex_buffer(slot, buffer.slice(..));
            }
            pass.set_index_buffer(draw.indices.slice(..), IndexFormat::Uint32);
            pass.draw_indexed(draw.range.clone(), 0, 0..1);
        }
    }
}

fn sorted_draws(gpu: &Gpu, program: &LitProgram, scene: &LitScene<'_>) -> Result<Vec<Draw>, GpuError> {
    let [.., back] = scene.camera.axes();
    let (mut draws, mut blended) = (Vec::new(), Vec::new());
    for object in scene.objects {
        let center = to_f64(object.vertices.origin()) - scene.camera.eye_64();
        let bindings = object_bindings(gpu, program, center)?;
        for part in object.parts.iter().filter(|part| !part.range.is_empty()) {
            check_range(object, part)?;
            let entry = scene.materials.entry(part.material)?;
            let is_blended = entry.material.alpha_mode == AlphaMode::Blend;
            for &culled in passes(&entry.material) {
                let key = PipelineKey { present: object.vertices.present(), culled, is_blended };
                let draw = Draw {
                    pipeline: program.pipeline(gpu, key),
                    material: entry.bindings.clone(),
                    object: bindings.clone(),
                    vertices: std::array::from_fn(|slot| object.vertices.buffer(slot).clone()),
                    indices: object.indices.buffer().clone(),
                    range: part.range.clone(),
                };
                if is_blended {
                    blended.push((back.dot(center), draw));
                } else {
                    draws.push(draw);
                }
            }
        }
    }
    // The axis points toward the eye: far objects have the smallest coordinates on it. Equally far ones
    // keep their order.
    blended.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    draws.extend(blended.into_iter().map(|(_, draw)| draw));
    Ok(draws)
}

/// Sides to leave out in each pass: blended surfaces show what is behind them, their own back faces included.
fn passes(material: &Material) -> &'static [Option<Face>] {
    match (material.is_double_sided, material.alpha_mode) {
        (false, _) => &[Some(Face::Back)],
        (true, AlphaMode::Blend) => &[Some(Face::Front), Some(Face::Back)],
        (true, _) => &[None],
    }
}

fn check_range(object: &LitObject<'_>, part: &LitPart) -> Result<(), GpuError> {
    let index_count = object.indices.capacity();
    if part.range.end as usize > index_count {
        let (start, end) = (part.range.start, part.range.end);
        return Err(GpuError::IndexRange { start, end, index_count });
    }
    Ok(())
}

/// The position of an object's origin relative to the eye, for `vertex.wgsl`.
fn object_bindings(gpu: &Gpu, program: &LitProgram, center: DVec3) -> Result<BindGroup, GpuError> {
    let offset = center.as_vec3().extend(0.0).to_array();
    let uniform = gpu.buffer_of("object", bytes_of(&offset), BufferUsages::UNIFORM)?;
    Ok(bind(gpu, &program.object_layout, [uniform.as_entire_binding()]))
}

fn frame_bindings(
    gpu: &Gpu,
    program: &LitProgram,
    environment: &Environment,
    data: &[u8],
) -> Result<BindGroup, GpuError> {
    let uniform = gpu.buffer_of("frame", data, BufferUsages::UNIFORM)?;
    let entries = EnvironmentTable::new(environment).entries;
    let size = [COLUMN_COUNT as u32, ROW_COUNT as u32];
    let table = upload_table(gpu, TextureFormat::Rgba16Float, size, entries.as_flattened());
    let sampler = gpu.device.create_sampler(&SamplerDescriptor {
        label: Some("tables"),
        mag_filter: FilterMode::Linear,
        min_filter: FilterMode::Linear,
        ..Default::default()
    });
    let resources = [
        uniform.as_entire_binding(),
        BindingResource::TextureView(&table),
        BindingResource::TextureView(&program.reflectance),
        BindingResource::Sampler(&sampler),
    ];
    Ok(bind(gpu, &program.frame_layout, resources))
}
