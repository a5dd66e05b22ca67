//! C interface of striata.
//!
//! The header is `include/striata.h`; `include/striata.hpp` wraps it for C++17. All functions begin with `striata_`, take
//! integers instead of enumerations, and write to memory of the caller. Functions return a status, 0 or a negative number,
//! or a count, which is negative if it is a status. [`striata_last_error`] describes the last failure of the thread.
//!
//! No function panics across the border: panics become [`STRIATA_INTERNAL`]. References in the signatures are pointers in
//! C, of which null is refused. All other unsafe code is in the module `raw`, which turns pointers and lengths of the
//! caller into slices.
//!
//! # Example
//! ```
//! use std::mem::MaybeUninit;
//! use striata_capi::*;
//!
//! let positions = [[0.0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
//! let indices = [0u32, 1, 2, 2, 1, 3];
//! let arrays = StriataMeshArrays {
//!     vertex_count: 4,
//!     positions: positions.as_ptr().cast(),
//!     index_count: 6,
//!     indices: indices.as_ptr(),
//!     ..Default::default()
//! };
//! let mut lod = MaybeUninit::uninit();
//! // SAFETY: the arrays have the lengths that the struct states.
//! let status = unsafe { striata_lod_build(Some(&arrays), None, Some(&mut lod)) };
//! assert_eq!(status, STRIATA_OK);
//! // SAFETY: the call has written the handle.
//! striata_lod_free(unsafe { lod.assume_init() });
//! ```

mod build;
mod camera;
mod decoder;
mod facts;
mod file;
mod levels;
mod raw;
mod status;
mod view;

pub use build::*;
pub use camera::*;
pub use decoder::*;
pub use facts::*;
pub use file::*;
pub use levels::*;
pub use status::*;
pub use view::*;

use std::ffi::c_char;

use striata::Lod;

/// Number of the binary interface: libraries and headers with the same number fit together.
pub const STRIATA_ABI: u32 = 1;

/// Every level of detail of one mesh. Immutable: threads may share it, as long as none of them frees it.
#[derive(Debug)]
pub struct StriataLod {
    levels: Lod,
}

/// Returns the version of the library, such as "0.1.0".
#[unsafe(no_mangle)]
pub extern "C" fn striata_version() -> *const c_char {
    const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), "\0");
    VERSION.as_ptr().cast()
}

/// Returns the number of the binary interface of the library, to compare with `STRIATA_ABI` of the header.
#[unsafe(no_mangle)]
pub extern "C" fn striata_abi() -> u32 {
    STRIATA_ABI
}
