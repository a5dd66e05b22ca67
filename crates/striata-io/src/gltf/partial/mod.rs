//! Parts of documents that do not fit into memory: shapes without data, some elements of an accessor, some
//! triangles of a primitive.

mod range;
mod shapes;
mod triangle_runs;

pub(crate) use triangle_runs::{TriangleCount, TriangleRuns};
