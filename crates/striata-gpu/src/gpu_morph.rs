//! Geomorphs in the vertex shader: vertices slide from one level to another.
//!
//! The GPU stores for each vertex which vertex it moves from or to and how far it is, 8 bytes. Only changes
//! are uploaded: for a [`Geomorph`] between two levels, the list of moving vertices once and then one
//! number per frame; for [`FanMorphs`], which follow a view, a list per frame. The shader blends positions,
//! normals and colors. If a target is moving too, the shader follows the chain of targets, so that chains
//! stay connected exactly as they do on the CPU.
//!
//! Cost: 8 bytes per vertex, and 12 bytes uploaded for each vertex that starts moving, moves
//! independently, or comes to rest.

use bytemuck::cast_slice;
use striata::mesh::CollapseSequence;
use striata::model::{FanMorphs, Geomorph};
use wgpu::{BindGroup, Buffer, BufferUsages, ComputePipeline, RenderPass};

use crate::drawing::Drawing;
use crate::gpu::Gpu;
use crate::gpu_error::GpuError;
use crate::painter::{Painter, Scene, bind};
use crate::vertices::GpuVertices;

/// Codes stored instead of a factor: the vertex follows the blend, or one minus the blend; see
/// `morphing.wgsl`.
const APPEARS: f32 = 2.0;
const VANISHES: f32 = 3.0;

/// Workgroup size of `scatter.wgsl`.
const SCATTER_WORKGROUP_SIZE: u32 = 64;

/// Motion of the vertices of a mesh on the GPU; draw it with [`Painter::draw_morphing`].
#[derive(Debug)]
pub struct GpuMorph {
    motions: Buffer,
    blend: Buffer,
    bindings: BindGroup,
    scatter: ComputePipeline,
    /// Buffer for the uploaded list of moves, its bindings, and its capacity in moves.
    moves: Option<(Buffer, BindGroup, usize)>,
    /// Vertices that are not at rest on the GPU, ascending.
    moved: Vec<u32>,
    uploaded_bytes: u64,
}

/// Vertex, target and factor bits, as `scatter.wgsl` reads them.
type Move = [u32; 3];

impl GpuMorph {
    /// Creates a morph in which all vertices are at rest.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if a buffer exceeds the device's limit.
    pub fn new(gpu: &Gpu, painter: &Painter, vertices: &GpuVertices) -> Result<Self, GpuError> {
        let at_rest: Vec<[u32; 2]> =
            (0..vertices.vertex_count().max(1) as u32).map(|v| rest_entry(v).1).collect();
        let motions = gpu.buffer_of("vertex motions", cast_slice(&at_rest), BufferUsages::STORAGE)?;
        let blend = gpu.buffer_of("blend", &[0; 16], BufferUsages::UNIFORM)?;
        let buffers = [&vertices.positions, &vertices.normals, &vertices.colors, &motions, &blend];
        let bindings = bind(gpu, &painter.morphing_layout, &buffers);
        let module = gpu.device.create_shader_module(wgpu::include_wgsl!("shaders/scatter.wgsl"));
        let scatter = gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some("scatter"),
            layout: None,
            module: &module,
            entry_point: Some("scatter"),
            compilation_options: Default::default(),
            cache: None,
        });
        Ok(Self { motions, blend, bindings, scatter, moves: None, moved: Vec::new(), uploaded_bytes: 0 })
    }

    /// Starts a morph between two levels at blend 0; vertices of an earlier morph come to rest.
    ///
    /// # Panics
    /// If the morph belongs to another mesh.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if a buffer exceeds the device's limit.
    pub fn begin<S>(&mut self, gpu: &Gpu, morph: &Geomorph<S>) -> Result<(), GpuError> {
        let kinds = [(morph.appearing(), APPEARS), (morph.vanishing(), VANISHES)];
        let moves = kinds.into_iter().flat_map(|(vertices, kind)| {
            vertices.iter().map(move |moving| [moving.vertex, moving.target, kind.to_bits()])
        });
        let mut moves: Vec<Move> = moves.collect();
        moves.sort_unstable();
        self.set_blend(gpu, 0.0);
        self.replace(gpu, moves)
    }

    /// Sets the blend between the two levels: 0 shows the first, 1 the second.
    pub fn set_blend(&mut self, gpu: &Gpu, blend: f32) {
        // NaN counts as 0.
        let blend = if blend > 0.0 { blend.min(1.0) } else { 0.0 };
        gpu.queue.write_buffer(&self.blend, 0, &blend.to_ne_bytes());
        self.uploaded_bytes += 4;
    }

    /// Uploads the vertices that follow a view; call it after each [`advance`](FanMorphs::advance).
    ///
    /// # Panics
    /// If the sequence belongs to another mesh.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if a buffer exceeds the device's limit.
    pub fn follow(
        &mut self,
        gpu: &Gpu,
        morphs: &FanMorphs,
        sequence: &CollapseSequence,
    ) -> Result<(), GpuError> {
        let moving = morphs.moving(sequence);
        self.replace(gpu, moving.map(|m| [m.vertex, m.target, m.factor.to_bits()]).collect())
    }

    /// Bytes uploaded so far, not counting the initial rest state.
    pub fn uploaded_bytes(&self) -> u64 {
        self.uploaded_bytes
    }

    /// Makes the vertices of `moves`, ascending, the only ones that move.
    fn replace(&mut self, gpu: &Gpu, mut moves: Vec<Move>) -> Result<(), GpuError> {
        let moved: Vec<u32> = moves.iter().map(|&[vertex, ..]| vertex).collect();
        let stopped = self.moved.iter().filter(|vertex| moved.binary_search(vertex).is_err());
        moves.extend(stopped.map(|&vertex| {
            let (vertex, [target, factor]) = rest_entry(vertex);
            [vertex, target, factor]
        }));
        if !moves.is_empty() {
            self.upload(gpu, &moves)?;
        }
        self.moved = moved;
        Ok(())
    }

    fn upload(&mut self, gpu: &Gpu, moves: &[Move]) -> Result<(), GpuError> {
        let largest = moves.iter().map(|&[vertex, ..]| vertex).max();
        let vertex_count = self.motions.size() / 8;
        assert!(largest.is_none_or(|v| u64::from(v) < vertex_count), "the morph belongs to another mesh");
        let (buffer, bindings) = match &mut self.moves {
            Some((buffer, bindings, capacity)) if *capacity >= moves.len() => (&*buffer, &*bindings),
            slot => {
                let capacity = moves.len() + moves.len() / 2;
                let usage = BufferUsages::STORAGE | BufferUsages::COPY_DST;
                let buffer = gpu.empty_buffer("moves", 4 + 12 * capacity as u64, usage)?;
                let bindings = bind(gpu, &self.scatter.get_bind_group_layout(0), &[&buffer, &self.motions]);
                let (buffer, bindings, _) = slot.insert((buffer, bindings, capacity));
                (&*buffer, &*bindings)
            }
        };
        let words: Vec<u32> = [moves.len() as u32].iter().chain(moves.as_flattened()).copied().collect();
        gpu.queue.write_buffer(buffer, 0, cast_slice(&words));
        self.uploaded_bytes += 4 * words.len() as u64;
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_compute_pass(&Default::default());
        pass.set_pipeline(&self.scatter);
        pass.set_bind_group(0, bindings, &[]);
        let workgroups = (moves.len() as u32).div_ceil(SCATTER_WORKGROUP_SIZE);
        let row = workgroups.min(gpu.device.limits().max_compute_workgroups_per_dimension);
        pass.dispatch_workgroups(row, workgroups.div_ceil(row), 1);
        drop(pass);
        // Submitted immediately, because the list may be written again before anything is drawn.
        gpu.queue.submit([encoder.finish()]);
        Ok(())
    }
}

impl Painter {
    /// Draws vertices by indices, each at the position that the morph gives it.
    pub fn draw_morphing(
        &self,
        pass: &mut RenderPass<'_>,
        scene: &Scene,
        morph: &GpuMorph,
        drawing: Drawing<'_>,
    ) {
        pass.set_pipeline(&self.morphing[usize::from(drawing.is_strips())][usize::from(scene.hides_back)]);
        pass.set_bind_group(0, &scene.bindings, &[]);
        pass.set_bind_group(1, &morph.bindings, &[]);
        pass.set_index_buffer(drawing.index_buffer().slice(..), wgpu::IndexFormat::Uint32);
        drawing.issue(pass);
    }
}

/// Entry of a vertex at rest: its own target, at factor 1.
fn rest_entry(vertex: u32) -> (u32, [u32; 2]) {
    (vertex, [vertex, 1f32.to_bits()])
}
