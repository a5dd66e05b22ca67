//! Locates the stream in a `.striata` file from the file's first bytes, so that a page can fetch only the
//! stream.

use striata::file::{DecodeError, FileHead};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::Failure;

/// Number of bytes to request first.
const FIRST_BYTES: usize = 4096;

/// Location of the stream in a `.striata` file, as far as the first bytes of the file determine it.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StreamPlace {
    /// Number of leading bytes needed to locate the stream. If this is more than were passed, call again
    /// with this many.
    pub needed: f64,
    /// Offset of the stream from the beginning of the file, bytes.
    pub offset: f64,
    /// Length of the stream in bytes; 0 if the file has none.
    pub length: f64,
}

#[wasm_bindgen]
impl StreamPlace {
    /// Locates the stream of a `.striata` file. A file of a scene has none.
    ///
    /// # Errors
    /// If the bytes do not begin a `.striata` file, or its header is damaged.
    pub fn find(head: &[u8]) -> Result<Self, Failure> {
        let whole = head.len() as f64;
        let read = match FileHead::read(head) {
            Err(DecodeError::Scene) => return Ok(Self { needed: whole, offset: 0.0, length: 0.0 }),
            read => read?,
        };
        let Some(read) = read else {
            let needed = FIRST_BYTES.max(2 * head.len()) as f64;
            return Ok(Self { needed, offset: 0.0, length: 0.0 });
        };
        let (offset, length) = read.stream().map_or((0, 0), |section| (section.offset, section.bytes));
        Ok(Self { needed: whole, offset: offset as f64, length: length as f64 })
    }
}
