//! `.striata` files, and the end of a handle.

use std::ffi::c_char;
use std::fs;
use std::mem::MaybeUninit;

use striata::Lod;
use striata::file::DecodeError;

use crate::StriataLod;
use crate::raw::{slice, text};
use crate::status::{CallFailure, STRIATA_BAD_BYTES, STRIATA_IO, given, status_of};

/// Reads a `.striata` file, also one that contains a stream, and writes a handle to `to`. The path is UTF-8.
///
/// # Safety
/// `path` is a text that ends with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_open(
    path: *const c_char,
    to: Option<&mut MaybeUninit<Option<Box<StriataLod>>>>,
) -> i32 {
    status_of(|| {
        let to = given("to", to)?.write(None);
        // SAFETY: the promise of the caller.
        let path = unsafe { text("path", path) }?;
        let failed = |error| CallFailure::new(STRIATA_IO, format_args!("{path}: {error}"));
        let bytes = fs::read(path).map_err(failed)?;
        let levels = decoded(&bytes)
            .map_err(|error| CallFailure::new(STRIATA_BAD_BYTES, format_args!("{path}: {error}")))?;
        *to = Some(Box::new(StriataLod { levels }));
        Ok(())
    })
}

/// Reads the bytes of a `.striata` file like `striata_lod_open`. The bytes are not needed after the call.
///
/// # Safety
/// There are `byte_count` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_open_bytes(
    bytes: *const u8,
    byte_count: usize,
    to: Option<&mut MaybeUninit<Option<Box<StriataLod>>>>,
) -> i32 {
    status_of(|| {
        let to = given("to", to)?.write(None);
        // SAFETY: the promise of the caller.
        let bytes = unsafe { slice("bytes", bytes, byte_count) }?;
        let failed = |error| CallFailure::new(STRIATA_BAD_BYTES, format_args!("bytes: {error}"));
        *to = Some(Box::new(StriataLod { levels: decoded(bytes).map_err(failed)? }));
        Ok(())
    })
}

fn decoded(bytes: &[u8]) -> Result<Lod, DecodeError> {
    Lod::from_file(&striata_stream::open(bytes)?)
}

/// Writes a `.striata` file with all levels. It is complete or not there at all. The path is UTF-8.
///
/// # Safety
/// `path` is a text that ends with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn striata_lod_save(lod: Option<&StriataLod>, path: *const c_char) -> i32 {
    status_of(|| {
        let lod = &given("lod", lod)?.levels;
        // SAFETY: the promise of the caller.
        let path = unsafe { text("path", path) }?;
        striata_io::save(path, lod).map_err(|error| CallFailure::new(STRIATA_IO, error))
    })
}

/// Frees a mesh with its levels. Views of it stay valid. Null is allowed.
#[unsafe(no_mangle)]
pub extern "C" fn striata_lod_free(lod: Option<Box<StriataLod>>) {
    // A panic has no meaning for the caller: the handle is gone.
    let _ = status_of(|| {
        drop(lod);
        Ok(())
    });
}
