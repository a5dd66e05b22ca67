//! Where in a `.striata` file its stream lies, told by the file's first bytes, so that a page fetches only that.

use striata::file::FileHead;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::Failure;

/// As much as is asked for first.
const FIRST_BYTES: usize = 4096;

/// What the first bytes of a file tell of the place of its stream.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StreamPlace {
    /// First bytes of the file that it may take to know; more than were given: ask again with so many.
    pub needed: f64,
    /// Where the stream begins, bytes from the file's beginning.
    pub offset: f64,
    /// Its bytes; 0 if the file has no stream.
    pub length: f64,
}

#[wasm_bindgen]
impl StreamPlace {
    /// Looks for the stream of a `.striata` file.
    ///
    /// # Errors
    /// Where the bytes begin no `.striata` file, or its head is damaged.
    pub fn find(head: &[u8]) -> Result<Self, Failure> {
        let Some(read) = FileHead::read(head)? else {
            let needed = FIRST_BYTES.max(2 * head.len()) as f64;
            return Ok(Self { needed, offset: 0.0, length: 0.0 });
        };
        let (offset, length) = read.stream().map_or((0, 0), |section| (section.offset, section.bytes));
        Ok(Self { needed: head.len() as f64, offset: offset as f64, length: length as f64 })
    }
}
