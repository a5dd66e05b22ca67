//! Sizes and vertex data of a mesh with all of its levels.

use std::mem::MaybeUninit;

use striata::Target;
use striata::mesh::Semantic;

use crate::StriataLod;
use crate::raw::CallerBuffer;
use crate::status::{CallFailure, STRIATA_UNAVAILABLE, count_of, given, status_of};

/// Unit normals, 3 components.
pub const STRIATA_NORMAL: i32 = 1;
/// Unit tangents with handedness, 4 components.
pub const STRIATA_TANGENT: i32 = 2;
/// Texture coordinates, 2 components.
pub const STRIATA_TEXCOORD: i32 = 3;
/// Colors, 3 or 4 components.
pub const STRIATA_COLOR: i32 = 4;

/// Sizes of a mesh and of its coarsest level.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StriataFacts {
    /// Vertices at full detail. Equal vertices of the input are one, and vertices without triangles are left out.
    pub vertex_count: u32,
    /// Triangles at full detail. Those of the input with two equal corners are left out.
    pub triangle_count: u32,
    /// Steps between the coarsest level and full detail.
    pub step_count: u32,
    /// Vertices of the coarsest level.
    pub coarsest_vertex_count: u32,
    /// Triangles of the coarsest level.
    pub coarsest_triangle_count: u32,
    /// Groups of triangles, such as materials; 1 if the mesh has none.
    pub group_count: u32,
    /// 1 if errors are guaranteed bounds, 0 if they are estimates.
    pub has_guaranteed_errors: i32,
    /// 1 if `striata_lod_source_vertices` has the vertices of the input, 0 if the levels come from a file or a stream.
    pub has_source_vertices: i32,
    /// Error of the coarsest level, in units of the mesh.
    pub coarsest_error: f32,
    /// Smallest coordinates, relative to the origin; 0 for an empty mesh.
    pub min: [f32; 3],
    /// Largest coordinates, relative to the origin; 0 for an empty mesh.
    pub max: [f32; 3],
    /// Point that positions are relative to: 0 unless the coordinates are too large for single precision.
    pub origin: [f64; 3],
}

pub(crate) fn semantic_of(kind: i32, set: u8) -> Result<Semantic, CallFailure> {
    match kind {
        STRIATA_NORMAL => Ok(Semantic::Normal),
        STRIATA_TANGENT => Ok(Semantic::Tangent),
        STRIATA_TEXCOORD => Ok(Semantic::TexCoord(set)),
        STRIATA_COLOR => Ok(Semantic::Color(set)),
        _ => Err(CallFailure::argument("kind", format_args!("{kind} is no kind of attribute"))),
    }
}

/// Writes the sizes of a mesh.
#[unsafe(no_mangle)]
pub extern "C" fn striata_lod_facts(
    lod: Option<&StriataLod>,
    facts: Option<&mut MaybeUninit<StriataFacts>>,
) -> i32 {
    status_of(|| {
        let (lod, facts) = (&given("lod", lod)?.levels, given("facts", facts)?);
        let [full, coarsest] = [usize::MAX, 0].map(|splits| lod.resolve(Target::SplitCount(splits)));
        let bounds = lod.mesh().bounds();
        facts.write(StriataFacts {
            vertex_count: full.vertex_count as u32,
            triangle_count: full.triangle_count as u32,
            step_count: lod.step_count() as u32,
            coarsest_vertex_count: coarsest.vertex_count as u32,
            coarsest_triangle_count: coarsest.triangle_count as u32,
            group_count: lod.mesh().groups.len().max(1) as u32,
            has_guaranteed_errors: lod.has_guaranteed_errors().into(),
            has_source_vertices: (!lod.source_vertices().is_empty()).into(),
            coarsest_error: coarsest.error,
            min: bounds.map_or([0.0; 3], |bounds| bounds.min),
            max: bounds.map_or([0.0; 3], |bounds| bounds.max),
            origin: lod.mesh().origin,
        });
        Ok(())
    })
}

/// Writes for each vertex the vertex of the input that it came from, and returns their number. Copy vertex `to[i]` of your
/// vertex buffer to place `i` of a new one, and all levels draw from it.
///
/// # Safety
/// `to` has room for `capacity` numbers, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_source_vertices(
    lod: Option<&StriataLod>,
    to: *mut u32,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let lod = &given("lod", lod)?.levels;
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        let sources = lod.source_vertices();
        if sources.len() < lod.mesh().vertex_count() {
            let message = "lod was read from a file or a stream, which do not know the vertices of the input";
            return Err(CallFailure::new(STRIATA_UNAVAILABLE, message));
        }
        to.fill(sources.len(), || sources)
    })
}

/// Writes for each vertex the vertex that it collapses to, and returns their number. Targets have smaller numbers; the
/// vertices of the coarsest level have themselves. At a level of `n` vertices, follow the targets of a vertex until it is
/// below `n`.
///
/// # Safety
/// `to` has room for `capacity` numbers, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_targets(lod: Option<&StriataLod>, to: *mut u32, capacity: usize) -> i64 {
    count_of(|| {
        let lod = &given("lod", lod)?.levels;
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        let (count, sequence) = (lod.mesh().vertex_count(), lod.sequence());
        to.fill(count, || (0..count as u32).map(|vertex| sequence.target(vertex)).collect::<Vec<_>>())
    })
}

/// Writes the positions of all vertices, three numbers each, relative to the origin, and returns the number of numbers.
///
/// # Safety
/// `to` has room for `capacity` numbers, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_positions(
    lod: Option<&StriataLod>,
    to: *mut f32,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let positions = given("lod", lod)?.levels.positions().as_flattened();
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        to.fill(positions.len(), || positions)
    })
}

/// Writes an attribute of all vertices as floats, and returns the number of numbers, which is a multiple of the number of
/// vertices. Integers that stand for fractions become numbers from 0 to 1. `kind` is `STRIATA_NORMAL`, `STRIATA_TANGENT`,
/// `STRIATA_TEXCOORD` or `STRIATA_COLOR`; `set` is the number of the texture coordinates or colors.
///
/// # Safety
/// `to` has room for `capacity` numbers, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_attribute(
    lod: Option<&StriataLod>,
    kind: i32,
    set: u8,
    to: *mut f32,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let mesh = given("lod", lod)?.levels.mesh();
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        let semantic = semantic_of(kind, set)?;
        let layer = mesh.layer(&semantic).ok_or_else(|| {
            CallFailure::new(STRIATA_UNAVAILABLE, format_args!("the mesh has no layer {semantic}"))
        })?;
        let width = usize::from(layer.component_count);
        let numbers = || (0..mesh.vertex_count() * width).map(|at| layer.get(at / width, at % width));
        to.fill(mesh.vertex_count() * width, || numbers().collect::<Vec<_>>())
    })
}
