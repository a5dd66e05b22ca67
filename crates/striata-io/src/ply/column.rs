//! Location of a number in a row.

use super::header::Scalar;

/// One number of each row: its name, type and offset.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    pub name: String,
    pub scalar: Scalar,
    pub offset: usize,
}
