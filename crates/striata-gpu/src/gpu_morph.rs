//! Geomorphs in the vertex shader: vertices on their way from one level to another.
//!
//! For each vertex the GPU knows where it comes from and how far it is, 8 bytes. Only what changes is sent: the list of those
//! that move once for a [`Geomorph`] between two levels, and then one number a frame; each frame's list for [`FanMorphs`], which follow
//! a view. The shader blends positions, normals and colors; where a target moves itself, it goes on to that one's target,
//! so chains stay together as they do on the processor.
//!
//! Cost: 8 bytes a vertex, 12 bytes sent for each vertex that begins to move, moves by itself or comes to rest.

use bytemuck::cast_slice;
use striata::mesh::CollapseSequence;
use striata::model::{FanMorphs, Geomorph};
use wgpu::{BindGroup, Buffer, BufferUsages, ComputePipeline, RenderPass};

use crate::drawing::Drawing;
use crate::gpu::Gpu;
use crate::gpu_error::GpuError;
use crate::painter::{Painter, Scene, bind};
use crate::vertices::GpuVertices;

/// As far as the blend, and as far as the blend is from its end; see `morphing.wgsl`.
const APPEARS: f32 = 2.0;
const VANISHES: f32 = 3.0;

/// Threads of a workgroup of `scatter.wgsl`.
const SCATTERED: u32 = 64;

/// Where the vertices of a mesh are on their way; drawn by [`Painter::draw_morphing`].
#[derive(Debug)]
pub struct GpuMorph {
    places: Buffer,
    blend: Buffer,
    bindings: BindGroup,
    scatter: ComputePipeline,
    /// The list of those that move, and room for how many.
    moves: Option<(Buffer, BindGroup, usize)>,
    /// Vertices that are not at rest on the GPU, rising.
    moved: Vec<u32>,
    uploaded_bytes: u64,
}

/// A vertex and its place, as `scatter.wgsl` reads it.
type Move = [u32; 3];

impl GpuMorph {
    /// All vertices at rest.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`].
    pub fn new(gpu: &Gpu, painter: &Painter, vertices: &GpuVertices) -> Result<Self, GpuError> {
        let at_rest: Vec<[u32; 2]> = (0..vertices.vertex_count().max(1) as u32).map(|v| rest(v).1).collect();
        let places = gpu.buffer_of("places", cast_slice(&at_rest), BufferUsages::STORAGE)?;
        let blend = gpu.buffer_of("blend", &[0; 16], BufferUsages::UNIFORM)?;
        let buffers = [&vertices.positions, &vertices.normals, &vertices.colors, &places, &blend];
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
        Ok(Self { places, blend, bindings, scatter, moves: None, moved: Vec::new(), uploaded_bytes: 0 })
    }

    /// Begins the way from one level to another, at a blend of 0; whatever moved before is at rest.
    ///
    /// # Panics
    /// If the morph is another mesh's.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`].
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

    /// How far the way between two levels is: 0 shows the first, 1 the second.
    pub fn set_blend(&mut self, gpu: &Gpu, blend: f32) {
        // What is no number blends nothing.
        let blend = if blend > 0.0 { blend.min(1.0) } else { 0.0 };
        gpu.queue.write_buffer(&self.blend, 0, &blend.to_ne_bytes());
        self.uploaded_bytes += 4;
    }

    /// Shows where vertices are that follow a view, after each [`advance`](FanMorphs::advance).
    ///
    /// # Panics
    /// If the sequence is another mesh's.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`].
    pub fn follow(
        &mut self,
        gpu: &Gpu,
        morphs: &FanMorphs,
        sequence: &CollapseSequence,
    ) -> Result<(), GpuError> {
        let moving = morphs.moving(sequence);
        self.replace(gpu, moving.map(|m| [m.vertex, m.target, m.factor.to_bits()]).collect())
    }

    /// Bytes sent so far, beside the vertices at rest at first.
    pub fn uploaded_bytes(&self) -> u64 {
        self.uploaded_bytes
    }

    /// Makes these, by rising vertices, the only ones that move.
    fn replace(&mut self, gpu: &Gpu, mut moves: Vec<Move>) -> Result<(), GpuError> {
        let moved: Vec<u32> = moves.iter().map(|&[vertex, ..]| vertex).collect();
        let rested = self.moved.iter().filter(|vertex| moved.binary_search(vertex).is_err());
        moves.extend(rested.map(|&vertex| {
            let (vertex, [target, factor]) = rest(vertex);
            [vertex, target, factor]
        }));
        if !moves.is_empty() {
            self.send(gpu, &moves)?;
        }
        self.moved = moved;
        Ok(())
    }

    fn send(&mut self, gpu: &Gpu, moves: &[Move]) -> Result<(), GpuError> {
        let largest = moves.iter().map(|&[vertex, ..]| vertex).max();
        let vertex_count = self.places.size() / 8;
        assert!(largest.is_none_or(|v| u64::from(v) < vertex_count), "the morph is another mesh's");
        let (buffer, bindings) = match &mut self.moves {
            Some((buffer, bindings, room)) if *room >= moves.len() => (&*buffer, &*bindings),
            slot => {
                let room = moves.len() + moves.len() / 2;
                let usage = BufferUsages::STORAGE | BufferUsages::COPY_DST;
                let buffer = gpu.empty_buffer("moves", 4 + 12 * room as u64, usage)?;
                let bindings = bind(gpu, &self.scatter.get_bind_group_layout(0), &[&buffer, &self.places]);
                let (buffer, bindings, _) = slot.insert((buffer, bindings, room));
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
        let workgroups = (moves.len() as u32).div_ceil(SCATTERED);
        let row = workgroups.min(gpu.device.limits().max_compute_workgroups_per_dimension);
        pass.dispatch_workgroups(row, workgroups.div_ceil(row), 1);
        drop(pass);
        // At once: the list may be written again before anything is drawn.
        gpu.queue.submit([encoder.finish()]);
        Ok(())
    }
}

impl Painter {
    /// Draws vertices by indices, each where a morph has it.
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

/// A vertex at its own place.
fn rest(vertex: u32) -> (u32, [u32; 2]) {
    (vertex, [vertex, 1f32.to_bits()])
}
