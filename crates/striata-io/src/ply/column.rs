//! Where a number lies in a row.

use super::header::Scalar;

/// One number of a row.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    pub name: String,
    pub scalar: Scalar,
    pub offset: usize,
}
