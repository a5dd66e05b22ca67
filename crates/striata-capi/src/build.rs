//! Building levels from the arrays of a caller.

use std::ffi::c_void;
use std::fmt::Display;
use std::mem::MaybeUninit;
use std::ops::ControlFlow;
use std::ptr::null;

use rayon::ThreadPoolBuilder;
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, TriangleGroup};
use striata::simplify::{BoundaryRule, SeamRule, SequenceOptions, SimplifyError, TopologyRule};
use striata::{Lod, LodOptions, Progress};

use crate::StriataLod;
use crate::facts::semantic_of;
use crate::raw::{StridedRows, slice};
use crate::status::{
    CallFailure, CallResult, STRIATA_BAD_MESH, STRIATA_CANCELED, STRIATA_INTERNAL, given, status_of,
};

/// Floats of 32 bits.
pub const STRIATA_F32: i32 = 0;
/// Bytes, of which 255 stands for 1.
pub const STRIATA_U8: i32 = 1;
/// Integers of 16 bits, of which 65,535 stands for 1.
pub const STRIATA_U16: i32 = 2;

/// The topology may change, so that every level is reached.
pub const STRIATA_TOPOLOGY_CHANGE: i32 = 0;
/// The topology may change, but each connected part keeps a triangle.
pub const STRIATA_TOPOLOGY_KEEP_PARTS: i32 = 1;
/// The topology stays.
pub const STRIATA_TOPOLOGY_KEEP: i32 = 2;

/// Most vertices of a mesh: indices have 32 bits.
const MAX_VERTICES: usize = u32::MAX as usize;

/// Most threads of a call.
const MAX_THREADS: u32 = 1024;

/// An attribute of the vertices in memory of the caller.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct StriataAttribute {
    /// `STRIATA_NORMAL`, `STRIATA_TANGENT`, `STRIATA_TEXCOORD` or `STRIATA_COLOR`.
    pub kind: i32,
    /// `STRIATA_F32`, `STRIATA_U8` or `STRIATA_U16`.
    pub number_type: i32,
    /// Numbers of a vertex, from 1 to 4: 3 for normals, 4 for tangents, 2 for texture coordinates, 3 or 4 for colors.
    pub components: u8,
    /// Number of the set of texture coordinates or colors, from 0.
    pub set: u8,
    /// Bytes from one vertex to the next; 0 if they follow each other.
    pub stride: usize,
    /// The numbers of the first vertex. They need no alignment.
    pub data: *const c_void,
}

/// Triangles and vertices in memory of the caller, which is read by the call only. Zero is a default for all fields that a
/// mesh does not need.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct StriataMeshArrays {
    /// Number of vertices.
    pub vertex_count: usize,
    /// Three coordinates of the first vertex. Set either these or `positions_f64`.
    pub positions: *const f32,
    /// Three coordinates of the first vertex in double precision, for coordinates such as those of surveys. Positions are
    /// then relative to an origin, which `striata_lod_facts` has.
    pub positions_f64: *const f64,
    /// Bytes from one position to the next; 0 if they follow each other.
    pub position_stride: usize,
    /// Number of indices, three for each triangle.
    pub index_count: usize,
    /// The vertices of the triangles, counterclockwise as seen from outside.
    pub indices: *const u32,
    /// Number of attributes.
    pub attribute_count: usize,
    /// Attributes of the vertices.
    pub attributes: *const StriataAttribute,
    /// Number of groups of triangles, such as materials or submeshes; 0 for one of all triangles.
    pub group_count: usize,
    /// Number of triangles of each group: together all triangles, in order.
    pub group_triangle_counts: *const u32,
}

impl Default for StriataMeshArrays {
    fn default() -> Self {
        Self {
            vertex_count: 0,
            positions: null(),
            positions_f64: null(),
            position_stride: 0,
            index_count: 0,
            indices: null(),
            attribute_count: 0,
            attributes: null(),
            group_count: 0,
            group_triangle_counts: null(),
        }
    }
}

/// A function that is called from time to time with the amount of work that is done, and that of the current phase. A
/// result other than 0 cancels the call. With a `thread_count`, it is called on another thread.
pub type StriataProgressFn = Option<extern "C" fn(user: *mut c_void, done: u64, total: u64) -> i32>;

/// How levels are built. Zero is the default of every field.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct StriataBuildOptions {
    /// 1 for errors that are guaranteed bounds, which makes building several times slower; 0 for estimates.
    pub guaranteed_errors: i32,
    /// 1 if vertices of the boundary stay, as borders of tiles and modular parts must.
    pub lock_boundary: i32,
    /// 1 if vertices on seams of attributes move only along the seam.
    pub keep_seams: i32,
    /// `STRIATA_TOPOLOGY_CHANGE`, `STRIATA_TOPOLOGY_KEEP_PARTS` or `STRIATA_TOPOLOGY_KEEP`.
    pub topology: i32,
    /// Triangles at which the coarsest level may stop.
    pub coarsest_triangle_count: usize,
    /// Largest error of the coarsest level, in units of the mesh; 0 for no limit.
    pub max_error: f64,
    /// Number of threads; 0 for those of the process, which rayon starts on first use.
    pub thread_count: u32,
    /// Called with the progress, or null.
    pub progress: StriataProgressFn,
    /// Passed to the progress function.
    pub user: *mut c_void,
}

impl Default for StriataBuildOptions {
    fn default() -> Self {
        Self {
            guaranteed_errors: 0,
            lock_boundary: 0,
            keep_seams: 0,
            topology: STRIATA_TOPOLOGY_CHANGE,
            coarsest_triangle_count: 0,
            max_error: 0.0,
            thread_count: 0,
            progress: None,
            user: std::ptr::null_mut(),
        }
    }
}

/// The progress function of a caller.
#[derive(Clone, Copy)]
struct CallerProgress {
    function: StriataProgressFn,
    user: *mut c_void,
}

// SAFETY: the pointer is only passed back to the function of the caller, which is documented to run on another thread if
// the caller asks for threads.
unsafe impl Send for CallerProgress {}

impl CallerProgress {
    fn report(&self, now: Progress) -> ControlFlow<()> {
        match self.function {
            Some(function) if function(self.user, now.done, now.total) != 0 => ControlFlow::Break(()),
            _ => ControlFlow::Continue(()),
        }
    }
}

/// Builds all levels of a mesh, and writes a handle to `to`, which `striata_lod_free` frees. The options may be null.
///
/// # Safety
/// The arrays have the lengths that the struct states.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_build(
    arrays: Option<&StriataMeshArrays>,
    options: Option<&StriataBuildOptions>,
    to: Option<&mut MaybeUninit<Option<Box<StriataLod>>>>,
) -> i32 {
    status_of(|| {
        let to = given("to", to)?.write(None);
        // SAFETY: the promise of the caller.
        let mesh = unsafe { mesh_of(given("arrays", arrays)?) }?;
        let options = options.copied().unwrap_or_default();
        let lod_options = options_of(&options)?;
        let progress = CallerProgress { function: options.progress, user: options.user };
        let build = move || Lod::build_with_progress(&mesh, &lod_options, &mut |now| progress.report(now));
        let built = on_threads(options.thread_count, build)?;
        *to = Some(Box::new(StriataLod { levels: built.map_err(build_failure)? }));
        Ok(())
    })
}

/// Runs work on threads of its own, or, for 0, on those of the process.
fn on_threads<T: Send>(thread_count: u32, work: impl FnOnce() -> T + Send) -> CallResult<T> {
    if thread_count == 0 {
        return Ok(work());
    }
    let refused = |problem: &dyn Display| CallFailure::argument("options.thread_count", problem);
    if thread_count > MAX_THREADS {
        return Err(refused(&format_args!("{thread_count} is more than {MAX_THREADS}")));
    }
    let pool = ThreadPoolBuilder::new().num_threads(thread_count as usize).build();
    Ok(pool.map_err(|error| refused(&error))?.install(work))
}

fn build_failure(error: SimplifyError) -> CallFailure {
    let status = match error {
        SimplifyError::Mesh(_) => STRIATA_BAD_MESH,
        SimplifyError::Cancelled(_) => STRIATA_CANCELED,
        SimplifyError::Option { .. } => return CallFailure::argument("options", error),
        _ => STRIATA_INTERNAL,
    };
    CallFailure::new(status, error)
}

/// Copies the arrays of a caller.
///
/// # Safety
/// The arrays have the lengths that the struct states.
unsafe fn mesh_of(arrays: &StriataMeshArrays) -> CallResult<IndexedMesh> {
    let count = arrays.vertex_count;
    if count > MAX_VERTICES {
        return Err(CallFailure::argument("arrays.vertex_count", format_args!("{count} is too large")));
    }
    // SAFETY: the promise of the caller.
    let indices = unsafe { slice("arrays.indices", arrays.indices, arrays.index_count) }?;
    let (triangles, rest) = indices.as_chunks::<3>();
    if !rest.is_empty() {
        let problem = format_args!("{} is no multiple of 3", arrays.index_count);
        return Err(CallFailure::argument("arrays.index_count", problem));
    }
    let mut mesh = IndexedMesh { triangles: triangles.to_vec(), ..IndexedMesh::default() };
    // SAFETY: the promise of the caller.
    unsafe { read_positions(arrays, &mut mesh) }?;
    // SAFETY: the promise of the caller.
    let attributes = unsafe { slice("arrays.attributes", arrays.attributes, arrays.attribute_count) }?;
    for (index, attribute) in attributes.iter().enumerate() {
        // SAFETY: the promise of the caller.
        let layer = unsafe { layer_of(attribute, count, &format!("arrays.attributes[{index}]")) }?;
        if mesh.layer(&layer.semantic).is_some() {
            let problem = format_args!("there are two layers {}", layer.semantic);
            return Err(CallFailure::argument("arrays.attributes", problem));
        }
        mesh.layers.push(layer);
    }
    // SAFETY: the promise of the caller.
    let counts =
        unsafe { slice("arrays.group_triangle_counts", arrays.group_triangle_counts, arrays.group_count) }?;
    mesh.groups = groups_of(counts, mesh.triangle_count())?;
    mesh.check().map_err(|error| CallFailure::new(STRIATA_BAD_MESH, format_args!("arrays: {error}")))?;
    Ok(mesh)
}

/// Copies the positions of a caller.
///
/// # Safety
/// The arrays have the lengths that the struct states.
unsafe fn read_positions(arrays: &StriataMeshArrays, mesh: &mut IndexedMesh) -> CallResult<()> {
    let StriataMeshArrays { positions, positions_f64, position_stride: stride, vertex_count: count, .. } =
        *arrays;
    if !positions.is_null() && !positions_f64.is_null() {
        return Err(CallFailure::argument("arrays", "both positions and positions_f64 are set"));
    }
    if positions_f64.is_null() {
        let rows = StridedRows { data: positions.cast(), stride, count, width: 3 };
        // SAFETY: the promise of the caller.
        let numbers = unsafe { rows.read::<f32>("arrays.positions") }?;
        mesh.positions = numbers.as_chunks().0.to_vec();
        return Ok(());
    }
    let rows = StridedRows { data: positions_f64.cast(), stride, count, width: 3 };
    // SAFETY: the promise of the caller.
    let numbers = unsafe { rows.read::<f64>("arrays.positions_f64") }?;
    check_finite("arrays.positions_f64", numbers.iter().copied(), 3)?;
    mesh.set_file_positions(numbers.as_chunks().0.to_vec());
    Ok(())
}

fn check_finite(name: &str, mut numbers: impl Iterator<Item = f64>, width: usize) -> CallResult<()> {
    match numbers.position(|number| !number.is_finite()) {
        None => Ok(()),
        Some(at) => {
            let message = format_args!("{name}: vertex {} has a number that is not finite", at / width);
            Err(CallFailure::new(STRIATA_BAD_MESH, message))
        }
    }
}

/// Copies an attribute of a caller.
///
/// # Safety
/// The memory of the attribute has `count` rows.
unsafe fn layer_of(attribute: &StriataAttribute, count: usize, name: &str) -> CallResult<AttributeLayer> {
    let StriataAttribute { kind, number_type, components, set, stride, data } = *attribute;
    let semantic = semantic_of(kind, set)?;
    let allowed = match kind {
        crate::STRIATA_NORMAL => 3..=3,
        crate::STRIATA_TANGENT => 4..=4,
        crate::STRIATA_TEXCOORD => 2..=2,
        _ => 3..=4,
    };
    if !allowed.contains(&components) {
        let problem = format_args!("{components} components do not make a {semantic}");
        return Err(CallFailure::argument(name, problem));
    }
    let width = usize::from(components);
    let rows = StridedRows { data: data.cast(), stride, count, width };
    let data = match number_type {
        // SAFETY: the promise of the caller.
        STRIATA_F32 => LayerData::F32(unsafe { rows.read(name) }?),
        // SAFETY: the promise of the caller.
        STRIATA_U8 => LayerData::U8(unsafe { rows.read(name) }?),
        // SAFETY: the promise of the caller.
        STRIATA_U16 => LayerData::U16(unsafe { rows.read(name) }?),
        _ => {
            return Err(CallFailure::argument(name, format_args!("{number_type} is no type of numbers")));
        }
    };
    if let LayerData::F32(numbers) = &data {
        check_finite(name, numbers.iter().map(|&number| number.into()), width)?;
    }
    Ok(AttributeLayer { semantic, component_count: components, normalized: number_type != STRIATA_F32, data })
}

fn groups_of(counts: &[u32], triangle_count: usize) -> CallResult<Vec<TriangleGroup>> {
    let sum: u64 = counts.iter().map(|&count| u64::from(count)).sum();
    if !counts.is_empty() && sum != triangle_count as u64 {
        let problem = format_args!("the groups have {sum} triangles, but the mesh has {triangle_count}");
        return Err(CallFailure::argument("arrays.group_triangle_counts", problem));
    }
    let mut first = 0;
    let group = |&count: &u32| {
        let group = TriangleGroup { first, count, ..TriangleGroup::default() };
        first += count;
        group
    };
    Ok(counts.iter().map(group).collect())
}

fn options_of(options: &StriataBuildOptions) -> CallResult<LodOptions> {
    let flag = |name: &str, value: i32| match value {
        0 | 1 => Ok(value == 1),
        _ => Err(CallFailure::argument(name, format_args!("{value} is neither 0 nor 1"))),
    };
    let locked = flag("options.lock_boundary", options.lock_boundary)?;
    let keeps_seams = flag("options.keep_seams", options.keep_seams)?;
    let topology = match options.topology {
        STRIATA_TOPOLOGY_CHANGE => TopologyRule::Change,
        STRIATA_TOPOLOGY_KEEP_PARTS => TopologyRule::KeepParts,
        STRIATA_TOPOLOGY_KEEP => TopologyRule::Keep,
        other => {
            return Err(CallFailure::argument(
                "options.topology",
                format_args!("{other} is no topology rule"),
            ));
        }
    };
    let mut sequence = SequenceOptions::default()
        .with_boundary(if locked { BoundaryRule::Locked } else { BoundaryRule::Kept })
        .with_seams(if keeps_seams { SeamRule::Keep } else { SeamRule::Cross })
        .with_topology(topology)
        .with_base_triangle_count(options.coarsest_triangle_count);
    if options.max_error != 0.0 {
        sequence = sequence.with_max_error(options.max_error);
    }
    sequence.check().map_err(|error| CallFailure::argument("options", error))?;
    let guaranteed = flag("options.guaranteed_errors", options.guaranteed_errors)?;
    Ok(LodOptions::default().with_sequence(sequence).with_guaranteed_errors(guaranteed))
}
