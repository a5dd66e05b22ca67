//! Owner of the decoder of a streamed mesh: the mesh's own model, or that of a scene.

use striata_stream::StreamDecoder;

use crate::Failure;
use crate::scene_parts::SharedScene;

/// The decoder of one mesh.
#[derive(Debug)]
pub(crate) enum StreamSource {
    /// A stream of this mesh alone.
    Own(Box<StreamDecoder>),
    /// A mesh of a scene, by its index.
    InScene(SharedScene, usize),
}

impl Default for StreamSource {
    fn default() -> Self {
        Self::Own(Box::default())
    }
}

impl StreamSource {
    /// The mesh's own decoder.
    ///
    /// # Errors
    /// If the mesh belongs to a scene.
    pub(crate) fn own(&mut self) -> Result<&mut StreamDecoder, Failure> {
        match self {
            Self::Own(decoder) => Ok(decoder),
            Self::InScene(..) => Err(Failure::unsupported("a mesh of a scene accepts no bytes of its own")),
        }
    }

    /// Reads from the decoder.
    pub(crate) fn read<R>(&self, read: impl FnOnce(&StreamDecoder) -> R) -> R {
        match self {
            Self::Own(decoder) => read(decoder),
            Self::InScene(scene, mesh) => {
                let scene = scene.borrow();
                match scene.decoder.mesh(*mesh) {
                    Some(decoder) => read(decoder),
                    None => read(&StreamDecoder::new()),
                }
            }
        }
    }

    /// Takes the triangles of a mesh of a scene that have changed since the last call.
    pub(crate) fn take_changed_triangles(&self) -> Option<Vec<u32>> {
        match self {
            Self::Own(_) => None,
            Self::InScene(scene, mesh) => scene.borrow_mut().changed.get_mut(*mesh).map(std::mem::take),
        }
    }
}
