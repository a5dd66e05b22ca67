//! Location of a number in a row.

use super::header::Scalar;

/// One number of each row: its name, type and offset.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    pub name: String,
    pub scalar: Scalar,
    pub offset: usize,
    /// Whether this is a texture coordinate that counts from the top of the image already.
    pub is_flipped: bool,
}
