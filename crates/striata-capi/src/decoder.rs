//! Streams: bytes as they arrive, and the mesh so far.

use std::mem::MaybeUninit;

use striata::Lod;
use striata_stream::StreamDecoder;

use crate::StriataLod;
use crate::raw::{CallerBuffer, slice};
use crate::status::{
    CallFailure, STRIATA_BAD_BYTES, STRIATA_INCOMPLETE, STRIATA_UNAVAILABLE, count_of, given, status_of,
};

/// A stream of which bytes arrive. One thread at a time may use it.
#[derive(Debug, Default)]
pub struct StriataDecoder {
    stream: StreamDecoder,
}

/// Sizes of a stream, and of the mesh that has arrived.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StriataStreamState {
    /// Vertices that have arrived.
    pub vertex_count: u32,
    /// Triangles of the level that has arrived.
    pub triangle_count: u32,
    /// Vertices of the whole stream; 0 until its head has arrived.
    pub full_vertex_count: u32,
    /// Triangles of the whole stream; 0 until its head has arrived.
    pub full_triangle_count: u32,
    /// Bytes of the whole stream; 0 until its head has arrived.
    pub byte_count: u64,
    /// Largest distance of the full mesh from the level that has arrived, in units of the mesh.
    pub error: f32,
    /// 1 if the whole stream has arrived.
    pub is_complete: i32,
    /// Point that positions are relative to.
    pub origin: [f64; 3],
}

/// Creates a decoder without bytes, and writes a handle to `to`, which `striata_decoder_free` frees.
#[unsafe(no_mangle)]
pub extern "C" fn striata_decoder_new(to: Option<&mut MaybeUninit<Option<Box<StriataDecoder>>>>) -> i32 {
    status_of(|| {
        given("to", to)?.write(Some(Box::default()));
        Ok(())
    })
}

/// Decodes the next bytes of a stream (`.stri`), as many as have arrived. After a failure, the decoder accepts no more bytes,
/// but keeps the mesh so far.
///
/// # Safety
/// There are `byte_count` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_decoder_push(
    decoder: Option<&mut StriataDecoder>,
    bytes: *const u8,
    byte_count: usize,
) -> i32 {
    status_of(|| {
        let stream = &mut given("decoder", decoder)?.stream;
        // SAFETY: the promise of the caller.
        let bytes = unsafe { slice("bytes", bytes, byte_count) }?;
        let pushed = stream.push_with_progress(bytes, &mut striata::ignore_progress);
        pushed.map_err(|error| CallFailure::new(STRIATA_BAD_BYTES, format_args!("bytes: {error}")))?;
        Ok(())
    })
}

/// Writes the sizes of a stream.
#[unsafe(no_mangle)]
pub extern "C" fn striata_decoder_state(
    decoder: Option<&StriataDecoder>,
    state: Option<&mut MaybeUninit<StriataStreamState>>,
) -> i32 {
    status_of(|| {
        let (stream, state) = (&given("decoder", decoder)?.stream, given("state", state)?);
        let info = stream.info().unwrap_or_default();
        state.write(StriataStreamState {
            vertex_count: stream.positions().len() as u32,
            triangle_count: stream.triangle_count() as u32,
            full_vertex_count: info.vertex_count as u32,
            full_triangle_count: info.triangle_count as u32,
            byte_count: info.stream_bytes,
            error: stream.error().unwrap_or_default(),
            is_complete: stream.is_complete().into(),
            origin: info.origin,
        });
        Ok(())
    })
}

/// Writes the positions of the vertices that have arrived, three numbers each, and returns the number of numbers. Vertices
/// keep their places, so that only those from `first_vertex` on need to be copied.
///
/// # Safety
/// `to` has room for `capacity` numbers, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_decoder_positions(
    decoder: Option<&StriataDecoder>,
    first_vertex: usize,
    to: *mut f32,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let positions = given("decoder", decoder)?.stream.positions();
        let Some(positions) = positions.get(first_vertex..) else {
            let problem = format_args!("{first_vertex} is more than the {} vertices", positions.len());
            return Err(CallFailure::argument("first_vertex", problem));
        };
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        to.fill(3 * positions.len(), || positions.as_flattened())
    })
}

/// Writes the indices of the level that has arrived, three for each triangle, and returns their number.
///
/// # Safety
/// `to` has room for `capacity` indices, or is null.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_decoder_indices(
    decoder: Option<&StriataDecoder>,
    to: *mut u32,
    capacity: usize,
) -> i64 {
    count_of(|| {
        let stream = &given("decoder", decoder)?.stream;
        // SAFETY: the promise of the caller.
        let to = unsafe { CallerBuffer::new(to, capacity) }?;
        to.fill(3 * stream.triangle_count(), || stream.triangles().as_flattened())
    })
}

/// Makes all levels of the mesh that has arrived, and writes a handle to `to`, which `striata_lod_free` frees. Its vertices
/// are those of the decoder.
#[unsafe(no_mangle)]
pub extern "C" fn striata_decoder_lod(
    decoder: Option<&StriataDecoder>,
    to: Option<&mut MaybeUninit<Option<Box<StriataLod>>>>,
) -> i32 {
    status_of(|| {
        let to = given("to", to)?.write(None);
        let stream = &given("decoder", decoder)?.stream;
        if stream.has_fragments() {
            let message = "the stream has fragments instead of collapses, of which no levels are made";
            return Err(CallFailure::new(STRIATA_UNAVAILABLE, message));
        }
        let Some(refinable) = stream.refinable_mesh() else {
            return Err(CallFailure::new(STRIATA_INCOMPLETE, "the coarsest level has not arrived yet"));
        };
        *to = Some(Box::new(StriataLod { levels: Lod::from_refinable(refinable) }));
        Ok(())
    })
}

/// Frees a decoder. Null is allowed.
#[unsafe(no_mangle)]
pub extern "C" fn striata_decoder_free(decoder: Option<Box<StriataDecoder>>) {
    // A panic has no meaning for the caller: the handle is gone.
    let _ = status_of(|| {
        drop(decoder);
        Ok(())
    });
}
