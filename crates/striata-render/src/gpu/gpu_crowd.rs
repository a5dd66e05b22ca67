//! Many instances of several meshes, refined on the GPU for one camera without any history.
//!
//! Which steps are refined is a pure function of the camera and of each step's [`StepBox`](striata::view::StepBox), so
//! nothing is kept from frame to frame and nothing but cameras is uploaded:
//!
//! ```text
//! cameras --upload--> plan:     which instances can be seen, and how many of their steps may be refined
//!                     classify: triangles of all refined steps by the class of their weight
//!                     choose:   the least threshold that fits the triangle budget
//!                     decide:   one bit per step
//!                     place:    where the triangles of each instance go, and its draw command
//!                     expand:   triangles
//! ```
//!
//! Errors fall along the steps. So `plan` finds the first range of steps whose error would not count even if it were
//! that of the whole mesh, and all steps from there on are skipped. It lists what is left for the other passes, whose
//! dispatches are indirect.
//!
//! Cost: an instance takes one bit per step, 116 bytes for its camera, 44 bytes for its place and its draw, and 8 bytes
//! for each block of 256 fans. The
//! tables of a mesh take 24 bytes per step more than those of [`GpuFans`](crate::gpu::GpuFans). The triangles of an
//! instance come in one draw and in any order, so groups are not kept apart.

use bytemuck::{Pod, Zeroable, bytes_of, cast_slice};
use striata::view::{GridCamera, ScreenError};
use wgpu::{BindGroup, Buffer, BufferUsages, CommandEncoder, Features};

use crate::gpu::copy_back::copy_back;
use crate::gpu::crowd_meshes::{CrowdMesh, CrowdMeshes};
use crate::gpu::crowd_passes::{CrowdPasses, DECIDING_COUNT, PASS_COUNT, PassSize, THREADS};
use crate::gpu::device::Gpu;
use crate::gpu::drawing::Drawing;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::indices::COMMAND_WORDS;

/// Bytes of the counts of all classes of weights, with the base and the threshold.
const BUDGET_BYTES: u64 = 4 * (2 + 1024);

/// Words of the state of an instance.
const STATE_WORDS: usize = 6;

/// Words of the list of work before its items.
const WORK_HEADER: u64 = 8;

/// Place of the dispatches of chunks and of blocks in the list of work, bytes.
const CHUNKS: u64 = 0;
const BLOCKS: u64 = 16;

/// A mesh at a place in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrowdInstance {
    /// Index of the mesh.
    pub mesh: usize,
    /// From the mesh to the world, in column order: a rotation with a translation and a uniform scale.
    pub transform: [f64; 16],
}

/// Instances of several meshes on the GPU, refined for one camera without any history. An instance takes one bit per step.
#[derive(Debug)]
pub struct GpuCrowd {
    meshes: CrowdMeshes,
    passes: CrowdPasses,
    instances: Vec<CrowdInstance>,
    /// First word of the bits of each instance, followed by the number of words.
    first_bits: Vec<u32>,
    buffers: CrowdBuffers,
    bindings: [BindGroup; PASS_COUNT],
    uploaded_bytes: u64,
}

/// Buffers that depend on the instances.
#[derive(Debug)]
struct CrowdBuffers {
    parameters: Buffer,
    cameras: Buffer,
    bits: Buffer,
    states: Buffer,
    budget: Buffer,
    indices: Buffer,
    commands: Buffer,
    work: Buffer,
    capacity: u32,
    chunk_capacity: u32,
}

/// Sums over all instances.
#[derive(Clone, Copy, Debug, Default)]
struct CrowdSizes {
    instances: u64,
    bit_words: u64,
    /// Chunks of 64 ranges, and blocks of fans.
    chunks: u64,
    blocks: u64,
    base_triangles: u64,
}

/// A camera on the grid of an instance, laid out as in `crowd.wgsl`.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct InstanceCamera {
    camera: GridCamera,
    mesh: u32,
    first_bits: u32,
}

/// Uniform parameters of a frame, laid out as in `crowd.wgsl`.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct CrowdParameters {
    instance_count: u32,
    capacity: u32,
    triangle_limit: u32,
    passes_instance: u32,
    row: u32,
    chunk_capacity: u32,
    unused: [u32; 2],
}

impl CrowdBuffers {
    fn new(gpu: &Gpu, sizes: &CrowdSizes, triangle_capacity: u64) -> Result<Self, GpuError> {
        let (storage, read) = (BufferUsages::STORAGE, BufferUsages::COPY_SRC);
        let (write, count) = (BufferUsages::COPY_DST, sizes.instances.max(1));
        let index_count = sizes.base_triangles.max(triangle_capacity).saturating_mul(3);
        let capacity = u32::try_from(index_count).map_err(|_| {
            let (limit_bytes, adapter) = (4 * u64::from(u32::MAX), gpu.info().name.clone());
            let needed_bytes = index_count.saturating_mul(4);
            GpuError::TooLarge { what: "crowd indices", needed_bytes, limit_bytes, adapter }
        })?;
        let work_words = WORK_HEADER + 2 * (sizes.chunks + sizes.blocks + 1);
        let camera_bytes = size_of::<InstanceCamera>() as u64;
        let words = |what, count: u64, usage| gpu.empty_buffer(what, 4 * count, storage | read | usage);
        let parameters_bytes = size_of::<CrowdParameters>() as u64;
        Ok(Self {
            parameters: gpu.empty_buffer(
                "crowd parameters",
                parameters_bytes,
                BufferUsages::UNIFORM | write,
            )?,
            cameras: gpu.empty_buffer("crowd cameras", count * camera_bytes, storage | write)?,
            bits: words("crowd step bits", sizes.bit_words, BufferUsages::empty())?,
            states: words("crowd states", count * STATE_WORDS as u64, BufferUsages::empty())?,
            budget: gpu.empty_buffer("crowd budget", BUDGET_BYTES, storage | read | write)?,
            indices: words("crowd indices", u64::from(capacity), BufferUsages::INDEX)?,
            commands: words("crowd draws", count * COMMAND_WORDS as u64, BufferUsages::INDIRECT)?,
            work: words("crowd work", work_words, BufferUsages::INDIRECT | write)?,
            capacity,
            chunk_capacity: sizes.chunks as u32,
        })
    }
}

impl GpuCrowd {
    /// Uploads the tables of meshes, without instances.
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if a buffer exceeds the device's limit.
    pub fn new(gpu: &Gpu, meshes: &[CrowdMesh<'_>]) -> Result<Self, GpuError> {
        let (meshes, passes) = (CrowdMeshes::upload(gpu, meshes)?, CrowdPasses::new(gpu));
        let buffers = CrowdBuffers::new(gpu, &CrowdSizes::default(), 0)?;
        let bindings = bind(gpu, &meshes, &passes, &buffers);
        let (instances, first_bits) = (Vec::new(), vec![0]);
        Ok(Self { meshes, passes, instances, first_bits, buffers, bindings, uploaded_bytes: 0 })
    }

    /// Replaces all instances. `triangle_capacity` is the largest budget of a frame; the buffer of triangles also has
    /// room for the base meshes of all instances.
    ///
    /// # Errors
    /// [`GpuError::NoSuchMesh`], [`GpuError::TooManyInstances`], or [`GpuError::TooLarge`] if a buffer exceeds the
    /// device's limit.
    pub fn set_instances(
        &mut self,
        gpu: &Gpu,
        instances: &[CrowdInstance],
        triangle_capacity: usize,
    ) -> Result<(), GpuError> {
        let limit = gpu.device.limits().max_compute_workgroups_per_dimension.saturating_mul(THREADS);
        if instances.len() > limit as usize {
            return Err(GpuError::TooManyInstances { count: instances.len(), limit });
        }
        let mut first_bits = vec![0];
        let mut sizes = CrowdSizes { instances: instances.len() as u64, ..CrowdSizes::default() };
        for (instance, &CrowdInstance { mesh, .. }) in instances.iter().enumerate() {
            let mesh_count = self.meshes.places.len();
            let place =
                self.meshes.places.get(mesh).ok_or(GpuError::NoSuchMesh { instance, mesh, mesh_count })?;
            sizes.bit_words += u64::from(place.range_count);
            sizes.chunks += u64::from(place.range_count.div_ceil(THREADS));
            sizes.blocks += u64::from(place.block_count);
            sizes.base_triangles += u64::from(place.base_triangles);
            // If there are more, the buffer is too large.
            first_bits.push(sizes.bit_words.min(u64::from(u32::MAX)) as u32);
        }
        self.buffers = CrowdBuffers::new(gpu, &sizes, triangle_capacity as u64)?;
        self.bindings = bind(gpu, &self.meshes, &self.passes, &self.buffers);
        self.instances = instances.to_vec();
        self.first_bits = first_bits;
        Ok(())
    }

    /// Uploads the camera of a frame and its tolerance, and the most triangles to show.
    ///
    /// If all instances together need more, the tolerance grows; the base meshes of all instances that can be seen are
    /// shown even if they have more. Only the camera and the tolerance of the criterion count.
    ///
    /// # Errors
    /// [`GpuError::Placement`] if an instance cannot be placed.
    pub fn look(
        &mut self,
        gpu: &Gpu,
        criterion: &ScreenError,
        triangle_limit: usize,
    ) -> Result<(), GpuError> {
        let place = |(instance, shown): (usize, &CrowdInstance)| {
            let camera = GridCamera::new(criterion, &shown.transform, &self.meshes.grids[shown.mesh])
                .ok_or(GpuError::Placement { instance })?;
            let first_bits = self.first_bits[instance];
            Ok(InstanceCamera { camera, mesh: shown.mesh as u32, first_bits })
        };
        let cameras: Vec<InstanceCamera> =
            self.instances.iter().enumerate().map(place).collect::<Result<_, GpuError>>()?;
        let capacity = self.buffers.capacity;
        let parameters = CrowdParameters {
            instance_count: cameras.len() as u32,
            capacity,
            triangle_limit: triangle_limit.min(capacity as usize / 3) as u32,
            passes_instance: u32::from(gpu.device.features().contains(Features::INDIRECT_FIRST_INSTANCE)),
            row: gpu.device.limits().max_compute_workgroups_per_dimension,
            chunk_capacity: self.buffers.chunk_capacity,
            unused: [0; 2],
        };
        gpu.queue.write_buffer(&self.buffers.parameters, 0, bytes_of(&parameters));
        gpu.queue.write_buffer(&self.buffers.cameras, 0, cast_slice(&cameras));
        self.uploaded_bytes += (size_of_val(&cameras[..]) + size_of_val(&parameters)) as u64;
        Ok(())
    }

    /// Records the decision about all steps.
    pub fn decide(&self, encoder: &mut CommandEncoder) {
        encoder.clear_buffer(&self.buffers.budget, 0, None);
        encoder.clear_buffer(&self.buffers.work, 0, Some(4 * WORK_HEADER));
        let groups = (self.instances.len() as u32).div_ceil(THREADS);
        let chunks = PassSize::Listed { work: &self.buffers.work, offset: CHUNKS };
        let sizes = [PassSize::Groups(groups), PassSize::Groups(1), chunks, PassSize::Groups(1), chunks];
        self.passes.run(encoder, &self.bindings, 0, &sizes);
    }

    /// Records the extraction of the triangles that were decided last; draw them afterward.
    pub fn expand(&self, encoder: &mut CommandEncoder) {
        let blocks = PassSize::Listed { work: &self.buffers.work, offset: BLOCKS };
        self.passes.run(encoder, &self.bindings, DECIDING_COUNT, &[PassSize::Groups(1), blocks]);
    }

    /// The draws of all instances, one command each, over the vertices of all meshes one after the other. The
    /// instance index of a draw is the index of the instance if the device supports `INDIRECT_FIRST_INSTANCE`.
    pub fn drawing(&self) -> Drawing<'_> {
        Drawing::Extracted {
            indices: &self.buffers.indices,
            commands: &self.buffers.commands,
            command_count: self.instances.len() as u32,
        }
    }

    /// Bytes uploaded for cameras so far.
    pub fn uploaded_bytes(&self) -> u64 {
        self.uploaded_bytes
    }

    /// Size of the tables of all meshes, bytes.
    pub fn mesh_bytes(&self) -> u64 {
        self.meshes.bytes
    }

    /// Size of the bits of all instances, bytes.
    pub fn bit_bytes(&self) -> u64 {
        self.buffers.bits.size()
    }

    /// Size of all other buffers of the instances except those of the triangles, bytes.
    pub fn state_bytes(&self) -> u64 {
        let CrowdBuffers { cameras, states, commands, work, .. } = &self.buffers;
        [cameras, states, commands, work].map(Buffer::size).iter().sum()
    }

    /// Reads back the bits of all instances, one per step and set if the step is collapsed, for inspection.
    ///
    /// # Errors
    /// [`GpuError::Failed`] if the device fails, [`GpuError::TooLarge`] if the copy exceeds the device's limit.
    pub fn read_bits(&self, gpu: &Gpu) -> Result<Vec<Vec<u32>>, GpuError> {
        let (words, states) = (copy_back(gpu, &self.buffers.bits)?, copy_back(gpu, &self.buffers.states)?);
        let states = states.as_chunks::<STATE_WORDS>().0;
        let of_instance = |(at, shown): (usize, &CrowdInstance)| {
            let place = &self.meshes.places[shown.mesh];
            let [first, end] = [self.first_bits[at], self.first_bits[at + 1]].map(|word| word as usize);
            let mut bits = words[first..end].to_vec();
            // What comes after the evaluated ranges is left over from other frames.
            bits[states[at][0] as usize..].fill(u32::MAX);
            if let Some(last) = bits.last_mut().filter(|_| !place.step_count.is_multiple_of(32)) {
                *last &= (1 << (place.step_count % 32)) - 1;
            }
            bits
        };
        Ok(self.instances.iter().enumerate().map(of_instance).collect())
    }

    /// Reads back the triangles of all instances, for inspection.
    ///
    /// # Errors
    /// [`GpuError::Failed`] if the device fails, [`GpuError::TooLarge`] if the copy exceeds the device's limit.
    pub fn read_triangles(&self, gpu: &Gpu) -> Result<Vec<Vec<[u32; 3]>>, GpuError> {
        let indices = copy_back(gpu, &self.buffers.indices)?;
        let commands = copy_back(gpu, &self.buffers.commands)?;
        let commands = commands.as_chunks::<COMMAND_WORDS>().0.iter().take(self.instances.len());
        let triangles = |&[count, _, first, ..]: &[u32; COMMAND_WORDS]| {
            indices[first as usize..][..count as usize].as_chunks().0.to_vec()
        };
        Ok(commands.map(triangles).collect())
    }

    /// Reads back the number of triangles of each instance and the threshold of the weights: 0, or 1,024 more for
    /// each doubling of the tolerance.
    ///
    /// # Errors
    /// [`GpuError::Failed`] if the device fails, [`GpuError::TooLarge`] if the copy exceeds the device's limit.
    pub fn read_counts(&self, gpu: &Gpu) -> Result<CrowdCounts, GpuError> {
        let states = copy_back(gpu, &self.buffers.states)?;
        let states = states.as_chunks::<STATE_WORDS>().0.iter().take(self.instances.len());
        let budget = copy_back(gpu, &self.buffers.budget)?;
        let (triangle_counts, range_counts) = states.map(|state| (state[1], state[0])).unzip();
        Ok(CrowdCounts { triangle_counts, range_counts, threshold: budget[1] as i32 })
    }
}

/// Counts of a crowd, as decided last.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CrowdCounts {
    /// Triangles of each instance; 0 if it cannot be seen.
    pub triangle_counts: Vec<u32>,
    /// Number of ranges of 32 steps of each instance that were evaluated.
    pub range_counts: Vec<u32>,
    /// Weight up to which steps are not refined.
    pub threshold: i32,
}

/// Binds all buffers to the passes.
fn bind(
    gpu: &Gpu,
    meshes: &CrowdMeshes,
    passes: &CrowdPasses,
    buffers: &CrowdBuffers,
) -> [BindGroup; PASS_COUNT] {
    let unused = &buffers.budget;
    passes.bind(
        gpu,
        &[
            &buffers.parameters,
            &meshes.fans,
            &meshes.words,
            &meshes.blocks,
            unused,
            &buffers.bits,
            unused,
            unused,
            &buffers.indices,
            &buffers.commands,
            unused,
            &meshes.boxes,
            &meshes.range_errors,
            &meshes.places_buffer,
            &buffers.cameras,
            &buffers.bits,
            &buffers.states,
            &buffers.budget,
            &buffers.work,
            &buffers.work,
        ],
    )
}
