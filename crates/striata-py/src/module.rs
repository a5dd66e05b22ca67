//! The module `striata._striata`.

use pyo3::prelude::*;

use crate::errors::DecodeError;
use crate::lod::LodData;
use crate::mesh::PyMeshData;
use crate::paged::PagedLodData;
use crate::plan::PlanData;
use crate::scene::{LodSceneData, PySceneData};
use crate::stream::DecoderData;
use crate::strip_level::StripLevelData;
use crate::view::ViewData;
use crate::{clusters, decode, distance, files, lod, simplify, stream, strips, tiles};

/// All classes are immutable or guarded by a mutex, so the module is safe without the global lock.
#[pymodule(gil_used = false)]
fn _striata(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("DecodeError", module.py().get_type::<DecodeError>())?;
    module.add_class::<PyMeshData>()?;
    module.add_class::<LodData>()?;
    module.add_class::<ViewData>()?;
    module.add_class::<StripLevelData>()?;
    module.add_class::<PySceneData>()?;
    module.add_class::<LodSceneData>()?;
    module.add_class::<DecoderData>()?;
    module.add_class::<PlanData>()?;
    module.add_class::<PagedLodData>()?;
    module.add_function(wrap_pyfunction!(simplify::simplify, module)?)?;
    module.add_function(wrap_pyfunction!(simplify::simplify_mesh, module)?)?;
    module.add_function(wrap_pyfunction!(lod::build, module)?)?;
    module.add_function(wrap_pyfunction!(distance::distance, module)?)?;
    module.add_function(wrap_pyfunction!(distance::vertex_distances, module)?)?;
    module.add_function(wrap_pyfunction!(strips::strip, module)?)?;
    module.add_function(wrap_pyfunction!(stream::encode_mesh, module)?)?;
    module.add_function(wrap_pyfunction!(stream::encode_scene, module)?)?;
    module.add_function(wrap_pyfunction!(files::open_file, module)?)?;
    module.add_function(wrap_pyfunction!(decode::decode, module)?)?;
    module.add_function(wrap_pyfunction!(files::write_mesh, module)?)?;
    module.add_function(wrap_pyfunction!(files::write_scene, module)?)?;
    module.add_function(wrap_pyfunction!(files::write_bytes, module)?)?;
    module.add_function(wrap_pyfunction!(files::format_of, module)?)?;
    module.add_function(wrap_pyfunction!(files::viewer_page, module)?)?;
    module.add_function(wrap_pyfunction!(tiles::write_tiles, module)?)?;
    module.add_function(wrap_pyfunction!(clusters::build_clusters, module)?)?;
    Ok(())
}
