//! A frame: the draw calls of a scene in order, with the numbers that change from frame to frame.

use bytemuck::bytes_of;
use glam::DVec3;
use wgpu::{
    BindGroup, BindGroupEntry, BindingResource, Buffer, BufferBinding, BufferUsages, FilterMode, IndexFormat,
    RenderPass, RenderPipeline, SamplerDescriptor, TextureFormat, TextureView,
};

use crate::gpu::Gpu;
use crate::gpu_error::GpuError;
use crate::lit::data_texture::DataTexture;
use crate::lit::environment::Environment;
use crate::lit::environment_table::{COLUMN_COUNT, ROW_COUNT, environment_table};
use crate::lit::frame_data::{FRAME_BYTES, FrameData, MAX_LIGHT_COUNT, screen_axes};
use crate::lit::instance_data::{INSTANCE_BYTES, PosedObject};
use crate::lit::material::{AlphaMode, LitMaterial};
use crate::lit::object::{LitObject, LitPart, LitScene};
use crate::lit::painter::{LitPainter, bytes_of_halves, data_view, upload_table};
use crate::lit::pipelines::{PipelineKey, Sides};
use crate::lit::vertices::{ABSENT_ONES, ABSENT_ZEROS, LitVertices};

/// The draw calls of a scene under an environment.
///
/// Keep a frame for a window: [`update`](Self::update) only writes matrices, joints and weights, about 100
/// bytes per object and 48 per joint.
#[derive(Debug)]
pub struct LitFrame {
    environment: Environment,
    uniform: Buffer,
    bindings: BindGroup,
    instances: InstanceBuffers,
    draws: Vec<Draw>,
}

/// Numbers of all objects, and what the shader binds for them.
#[derive(Debug)]
struct InstanceBuffers {
    uniform: Buffer,
    texels: DataTexture,
    bindings: BindGroup,
    /// Bytes from one object to the next.
    stride: u64,
    capacity: usize,
}

/// A draw call with everything that it reads.
#[derive(Debug)]
struct Draw {
    pipeline: RenderPipeline,
    material: BindGroup,
    morph_targets: BindGroup,
    instance_offset: u32,
    /// Each with the byte at which it begins.
    vertices: [(Buffer, u64); 8],
    indices: Buffer,
    range: std::ops::Range<u32>,
}

impl LitFrame {
    /// Largest number of lights in a frame.
    pub const MAX_LIGHT_COUNT: usize = MAX_LIGHT_COUNT;

    /// Creates an empty frame.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`], which does not happen on real devices.
    pub fn new(gpu: &Gpu, painter: &LitPainter, environment: &Environment) -> Result<Self, GpuError> {
        let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let uniform = gpu.empty_buffer("frame", FRAME_BYTES, usage)?;
        let bytes = bytes_of_halves(environment_table(environment).as_flattened());
        let size = [COLUMN_COUNT as u32, ROW_COUNT as u32];
        let table = upload_table(gpu, TextureFormat::Rgba16Float, size, bytes);
        let bindings = frame_bindings(gpu, painter, &uniform, &table);
        let instances = InstanceBuffers::new(gpu, painter, 1, 1)?;
        Ok(Self { environment: *environment, uniform, bindings, instances, draws: Vec::new() })
    }

    /// Prepares to draw a scene; replaces what the frame showed before.
    ///
    /// # Errors
    /// [`GpuError::NoSuchMaterial`] and [`GpuError::IndexRange`] if a part uses something that does not
    /// exist, [`GpuError::TooManyLights`], and [`GpuError::TooLarge`] if all joints together exceed the
    /// device's limit.
    pub fn update(&mut self, gpu: &Gpu, painter: &LitPainter, scene: &LitScene<'_>) -> Result<(), GpuError> {
        if scene.lights.len() > MAX_LIGHT_COUNT {
            let (count, limit) = (scene.lights.len(), MAX_LIGHT_COUNT);
            return Err(GpuError::TooManyLights { count, limit });
        }
        let encodes_srgb = !painter.format().is_srgb();
        let environment = &self.environment;
        let data = FrameData::new(&scene.camera, scene.size, environment, scene.lights, encodes_srgb);
        gpu.queue.write_buffer(&self.uniform, 0, bytes_of(&data));
        let eye = DVec3::from(scene.camera.eye);
        let mut texels = Vec::new();
        let posed: Vec<PosedObject> =
            scene.objects.iter().map(|object| PosedObject::new(object, eye, &mut texels)).collect();
        self.instances.write(gpu, painter, &posed, &texels)?;
        self.draws = self.sorted_draws(gpu, painter, scene, &posed)?;
        Ok(())
    }

    /// Draws the scene: opaque and masked parts first, then blended ones from back to front.
    pub fn draw(&self, pass: &mut RenderPass<'_>) {
        pass.set_bind_group(0, &self.bindings, &[]);
        for draw in &self.draws {
            pass.set_pipeline(&draw.pipeline);
            pass.set_bind_group(1, &draw.material, &[]);
            pass.set_bind_group(2, &self.instances.bindings, &[draw.instance_offset]);
            pass.set_bind_group(3, &draw.morph_targets, &[]);
            for (slot, (buffer, start)) in (0..).zip(&draw.vertices) {
                pass.set_vertex_buffer(slot, buffer.slice(*start..));
            }
            pass.set_index_buffer(draw.indices.slice(..), IndexFormat::Uint32);
            pass.draw_indexed(draw.range.clone(), 0, 0..1);
        }
    }

    /// Number of draw calls.
    pub fn draw_count(&self) -> usize {
        self.draws.len()
    }

    fn sorted_draws(
        &self,
        gpu: &Gpu,
        painter: &LitPainter,
        scene: &LitScene<'_>,
        posed: &[PosedObject],
    ) -> Result<Vec<Draw>, GpuError> {
        let [.., back] = screen_axes(&scene.camera);
        let (mut draws, mut blended) = (Vec::new(), Vec::new());
        for (at, (object, posed)) in scene.objects.iter().zip(posed).enumerate() {
            let instance_offset = (at as u64 * self.instances.stride) as u32;
            for part in object.parts.iter().filter(|part| !part.range.is_empty()) {
                check_range(object, part)?;
                let entry = scene.materials.entry(part.material)?;
                let is_blended = entry.material.alpha_mode == AlphaMode::Blend;
                for &sides in passes(&entry.material) {
                    let key = PipelineKey {
                        attributes: object.vertices.attributes(),
                        sides,
                        is_mirrored: posed.is_mirrored,
                        is_blended,
                    };
                    let draw = Draw {
                        pipeline: painter.pipeline(gpu, key),
                        material: entry.bindings.clone(),
                        morph_targets: object.vertices.morph_bindings.clone(),
                        instance_offset,
                        vertices: vertex_buffers(object.vertices),
                        indices: object.indices.buffer().clone(),
                        range: part.range.clone(),
                    };
                    if is_blended {
                        blended.push((back.dot(posed.center), draw));
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
}

impl InstanceBuffers {
    fn new(gpu: &Gpu, painter: &LitPainter, capacity: usize, texel_count: usize) -> Result<Self, GpuError> {
        let alignment = u64::from(gpu.device.limits().min_uniform_buffer_offset_alignment.max(1));
        let stride = INSTANCE_BYTES.next_multiple_of(alignment);
        let usage = BufferUsages::UNIFORM | BufferUsages::COPY_DST;
        let uniform = gpu.empty_buffer("instances", stride * capacity.max(1) as u64, usage)?;
        let texels = DataTexture::new(gpu, "joints", texel_count as u64)?;
        let of_instance =
            BufferBinding { buffer: &uniform, offset: 0, size: std::num::NonZeroU64::new(INSTANCE_BYTES) };
        let view = data_view(&texels);
        let bindings = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("instances"),
            layout: &painter.instance_layout,
            entries: &[
                BindGroupEntry { binding: 0, resource: BindingResource::Buffer(of_instance) },
                BindGroupEntry { binding: 1, resource: BindingResource::TextureView(&view) },
            ],
        });
        Ok(Self { uniform, texels, bindings, stride, capacity: capacity.max(1) })
    }

    /// Writes all objects and their texels, with room to grow if they did not fit.
    fn write(
        &mut self,
        gpu: &Gpu,
        painter: &LitPainter,
        posed: &[PosedObject],
        texels: &[[f32; 4]],
    ) -> Result<(), GpuError> {
        if posed.len() > self.capacity || texels.len() > self.texels.capacity() {
            let room = |needed: usize, present: usize| if needed > present { needed } else { present };
            let capacity = room(posed.len(), self.capacity);
            *self = Self::new(gpu, painter, capacity, room(texels.len(), self.texels.capacity()))?;
        }
        let mut bytes = vec![0; self.stride as usize * posed.len()];
        for (slot, posed) in bytes.chunks_mut(self.stride as usize).zip(posed) {
            slot[..INSTANCE_BYTES as usize].copy_from_slice(bytes_of(&posed.data));
        }
        if !bytes.is_empty() {
            gpu.queue.write_buffer(&self.uniform, 0, &bytes);
        }
        self.texels.write(gpu, texels);
        Ok(())
    }
}

/// Sides to draw, in order: blended surfaces show what is behind them, their own back faces included.
fn passes(material: &LitMaterial) -> &'static [Sides] {
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
fn vertex_buffers(vertices: &LitVertices) -> [(Buffer, u64); 8] {
    const COLOR: usize = 5;
    std::array::from_fn(|slot| match &vertices.buffers[slot] {
        Some(buffer) => (buffer.clone(), 0),
        None => (vertices.absent.clone(), if slot == COLOR { ABSENT_ONES } else { ABSENT_ZEROS }),
    })
}

fn frame_bindings(gpu: &Gpu, painter: &LitPainter, uniform: &Buffer, table: &TextureView) -> BindGroup {
    let sampler = gpu.device.create_sampler(&SamplerDescriptor {
        label: Some("tables"),
        mag_filter: FilterMode::Linear,
        min_filter: FilterMode::Linear,
        ..Default::default()
    });
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("frame"),
        layout: &painter.frame_layout,
        entries: &[
            BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() },
            BindGroupEntry { binding: 1, resource: BindingResource::TextureView(table) },
            BindGroupEntry { binding: 2, resource: BindingResource::TextureView(&painter.reflectance) },
            BindGroupEntry { binding: 3, resource: BindingResource::Sampler(&sampler) },
        ],
    })
}
