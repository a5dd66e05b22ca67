//! The parts of a streamed scene that the models of its meshes share.

use std::cell::RefCell;
use std::rc::Rc;

use striata_scene::stream::SceneStreamDecoder;

/// Decoder and changed triangles that the models of the meshes read.
#[derive(Debug, Default)]
pub(crate) struct StreamedSceneParts {
    pub decoder: SceneStreamDecoder,
    /// Triangles of each mesh that have changed, with duplicates.
    pub changed: Vec<Vec<u32>>,
}

/// Parts of a scene, shared by the models of its meshes.
pub(crate) type SharedScene = Rc<RefCell<StreamedSceneParts>>;
