//! A frame: the draw calls of a scene in order.

use bytemuck::{Pod, Zeroable, bytes_of};
use glam::DVec3;
use striata_scene::drawn::{AlphaMode, Material};
use wgpu::{
    BindGroup, BindGroupEntry, BindingResource, Buffer, BufferUsages, FilterMode, IndexFormat, RenderPass,
    RenderPipeline, SamplerDescriptor, TextureFormat,
};

use crate::environment::Environment;
use crate::environment_table::{COLUMN_COUNT, EnvironmentTable, ROW_COUNT};
use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::lit::frame_data::{FrameData, MAX_LIGHT_COUNT};
use crate::gpu::lit::object::{LitObject, LitPart, LitScene};
use crate::gpu::lit::painter::{LitPainter, bytes_of_halves, upload_table};
use crate::gpu::lit::pipeline_key::{PipelineKey, Sides};
use crate::gpu::lit::vertices::{ABSENT_ONES, ABSENT_ZEROS, BUFFER_COUNT, LitVertices};

/// The draw calls of a scene under an environment.
#[derive(Debug)]
pub struct LitFrame {
    bindings: BindGroup,
    draws: Vec<Draw>,
}

/// Uniform data of an object, laid out as in `vertex.wgsl`.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct ObjectData {
    /// Position of the mesh's origin relative to the eye.
    offset: [f32; 4],
    /// Whether the mesh has normals and tangents.
    flags: [u32; 4],
}

/// A draw call with everything that it reads.
#[derive(Debug)]
struct Draw {
    pipeline: RenderPipeline,
    material: BindGroup,
    object: BindGroup,
    /// Each with the byte at which it begins.
    vertices: [(Buffer, u64); BUFFER_COUNT],
    indices: Buffer,
    range: std::ops::Range<u32>,
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
        painter: &LitPainter,
        environment: &Environment,
        scene: &LitScene<'_>,
    ) -> Result<Self, GpuError> {
        if scene.lights.len() > MAX_LIGHT_COUNT {
            let (count, limit) = (scene.lights.len(), MAX_LIGHT_COUNT);
            return Err(GpuError::TooManyLights { count, limit });
        }
        let data = FrameData::new(scene.camera, scene.size, environment, scene.lights);
        let bindings = frame_bindings(gpu, painter, environment, bytes_of(&data))?;
        Ok(Self { bindings, draws: sorted_draws(gpu, painter, scene)? })
    }

    /// Draws the scene: opaque and masked parts first, then blended ones from back to front.
    pub fn draw(&self, pass: &mut RenderPass<'_>) {
        pass.set_bind_group(0, &self.bindings, &[]);
        for draw in &self.draws {
            pass.set_pipeline(&draw.pipeline);
            pass.set_bind_group(1, &draw.material, &[]);
            pass.set_bind_group(2, &draw.object, &[]);
            for (slot, (buffer, start)) in (0..).zip(&draw.vertices) {
                pass.set_vertex_buffer(slot, buffer.slice(*start..));
            }
            pass.set_index_buffer(draw.indices.slice(..), IndexFormat::Uint32);
            pass.draw_indexed(draw.range.clone(), 0, 0..1);
        }
    }
}

fn sorted_draws(gpu: &Gpu, painter: &LitPainter, scene: &LitScene<'_>) -> Result<Vec<Draw>, GpuError> {
    let [.., back] = scene.camera.axes();
    let (mut draws, mut blended) = (Vec::new(), Vec::new());
    for object in scene.objects {
        let center = DVec3::from(object.vertices.origin.map(f64::from)) - scene.camera.eye_64();
        let bindings = object_bindings(gpu, painter, object, center)?;
        for part in object.parts.iter().filter(|part| !part.range.is_empty()) {
            check_range(object, part)?;
            let entry = scene.materials.entry(part.material)?;
            let is_blended = entry.material.alpha_mode == AlphaMode::Blend;
            for &sides in passes(&entry.material) {
                let key = PipelineKey { attributes: object.vertices.attributes(), sides, is_blended };
                let draw = Draw {
                    pipeline: painter.pipeline(gpu, key),
                    material: entry.bindings.clone(),
                    object: bindings.clone(),
                    vertices: vertex_buffers(object.vertices),
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

/// Sides to draw, in order: blended surfaces show what is behind them, their own back faces included.
fn passes(material: &Material) -> &'static [Sides] {
    match (material.is_double_sided, material.alpha_mode) {
        (false, _) => &[Sides::Front],
        (true, AlphaMode::Blend) => &[Sides::Back, Sides::Front],
        (true, _) => &[Sides::Both],
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

/// The buffers of all attributes; absent ones read constants.
fn vertex_buffers(vertices: &LitVertices) -> [(Buffer, u64); BUFFER_COUNT] {
    const COLOR: usize = 5;
    std::array::from_fn(|slot| match &vertices.buffers[slot] {
        Some(buffer) => (buffer.clone(), 0),
        None => (vertices.absent.clone(), if slot == COLOR { ABSENT_ONES } else { ABSENT_ZEROS }),
    })
}

fn object_bindings(
    gpu: &Gpu,
    painter: &LitPainter,
    object: &LitObject<'_>,
    center: DVec3,
) -> Result<BindGroup, GpuError> {
    let [x, y, z] = center.as_vec3().to_array();
    let [has_normals, has_tangents] = object.vertices.has_normals_and_tangents().map(u32::from);
    let data = ObjectData { offset: [x, y, z, 0.0], flags: [has_normals, has_tangents, 0, 0] };
    let uniform = gpu.buffer_of("object", bytes_of(&data), BufferUsages::UNIFORM)?;
    Ok(gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("object"),
        layout: &painter.object_layout,
        entries: &[BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() }],
    }))
}

fn frame_bindings(
    gpu: &Gpu,
    painter: &LitPainter,
    environment: &Environment,
    data: &[u8],
) -> Result<BindGroup, GpuError> {
    let uniform = gpu.buffer_of("frame", data, BufferUsages::UNIFORM)?;
    let bytes = bytes_of_halves(EnvironmentTable::new(environment).entries.as_flattened());
    let size = [COLUMN_COUNT as u32, ROW_COUNT as u32];
    let table = upload_table(gpu, TextureFormat::Rgba16Float, size, bytes);
    let sampler = gpu.device.create_sampler(&SamplerDescriptor {
        label: Some("tables"),
        mag_filter: FilterMode::Linear,
        min_filter: FilterMode::Linear,
        ..Default::default()
    });
    Ok(gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("frame"),
        layout: &painter.frame_layout,
        entries: &[
            BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() },
            BindGroupEntry { binding: 1, resource: BindingResource::TextureView(&table) },
            BindGroupEntry { binding: 2, resource: BindingResource::TextureView(&painter.reflectance) },
            BindGroupEntry { binding: 3, resource: BindingResource::Sampler(&sampler) },
        ],
    }))
}
