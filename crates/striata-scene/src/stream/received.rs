//! Parts of a scene that the reader has received: meshes, images, and the buffer.

use striata::mesh::RefinableMesh;
use striata_stream::{DecodeError, StreamDecoder, StreamInfo, StreamUpdate};

use super::SceneStreamError;
use super::buffer::unpack;
use super::head::{MeshEntry, PART_COUNT, SceneHead};
use super::images::{ImageState, ReceivedImage};
use super::packet::PacketKind;
use super::weights::normalize_weights;

/// Everything that has been received after the document.
#[derive(Clone, Debug)]
pub(super) struct Received {
    pub head: SceneHead,
    /// Length of the stream until the end of the document.
    pub document_end: u64,
    /// The streams of meshes; [`None`] for meshes that have that of another one.
    pub meshes: Vec<Option<ReceivedMesh>>,
    pub images: Vec<ImageData>,
    pub parts: [Option<Vec<u8>>; PART_COUNT],
}

/// The stream of a mesh as far as it has been received, with its decoder.
#[derive(Clone, Debug, Default)]
pub(super) struct ReceivedMesh {
    pub entry: MeshEntry,
    pub decoder: StreamDecoder,
    /// Bytes of the mesh's stream that have been received.
    bytes: u64,
    /// Whether the header of the mesh's stream agrees with the table.
    is_checked: bool,
}

/// Bytes that have been received of an image and of its preview.
#[derive(Clone, Debug, Default)]
pub(super) struct ImageData {
    pub preview: Vec<u8>,
    /// The first bytes of the image.
    pub bytes: Vec<u8>,
}

impl Received {
    pub(super) fn new(head: SceneHead, document_end: u64) -> Self {
        let mesh = |entry: &Option<MeshEntry>| {
            let entry = (*entry).filter(|entry| entry.bytes > 0)?;
            Some(ReceivedMesh { entry, ..ReceivedMesh::default() })
        };
        Self {
            meshes: head.meshes.iter().map(mesh).collect(),
            images: vec![ImageData::default(); head.images.len()],
            parts: Default::default(),
            head,
            document_end,
        }
    }

    /// Returns the stream of a mesh as far as it has been received, which may be that of another mesh.
    pub(super) fn mesh(&self, mesh: usize) -> Option<&ReceivedMesh> {
        self.meshes[*self.head.sources.get(mesh)?].as_ref()
    }

    /// Meshes that have a stream.
    pub(super) fn meshes_with(&self, source: usize) -> impl Iterator<Item = usize> {
        (0..self.meshes.len()).filter(move |&mesh| self.head.sources[mesh] == source)
    }

    /// Continues the stream of a mesh; [`None`] if there is no such mesh or its stream has ended.
    pub(super) fn push_mesh(
        &mut self,
        mesh: usize,
        payload: &[u8],
    ) -> Result<Option<StreamUpdate>, SceneStreamError> {
        let Some(Some(slot)) = self.meshes.get_mut(mesh) else { return Ok(None) };
        slot.bytes += payload.len() as u64;
        if slot.bytes > slot.entry.bytes {
            return Ok(None);
        }
        let update = slot.decoder.push(payload).map_err(|source| SceneStreamError::Mesh { mesh, source })?;
        if !slot.is_checked
            && let Some(info) = slot.decoder.info()
        {
            slot.check(&info).map_err(|source| SceneStreamError::Mesh { mesh, source })?;
        }
        Ok(Some(update))
    }

    /// Takes a part of the buffer; [`None`] if it is malformed or not expected.
    pub(super) fn push_part(&mut self, part: usize, payload: &[u8]) -> Option<()> {
        let slot = self.parts.get_mut(part).filter(|slot| slot.is_none())?;
        let length = self.head.buffer[part].iter().map(|range| range.length).sum();
        *slot = Some(unpack(payload, length)?);
        Some(())
    }

    /// Takes a preview or the next bytes of an image, and returns whether the image has improved; [`None`] if
    /// it is not expected.
    pub(super) fn push_image(&mut self, kind: PacketKind, image: usize, payload: &[u8]) -> Option<bool> {
        let entry = self.head.images.get(image)?;
        let data = self.images.get_mut(image)?;
        if kind == PacketKind::Preview {
            let is_expected = data.preview.is_empty() && payload.len() as u64 == entry.preview_bytes;
            is_expected.then(|| data.preview = payload.to_vec())?;
            return Some(data.bytes.len() as u64 != entry.bytes);
        }
        let length = data.bytes.len() as u64 + payload.len() as u64;
        (length <= entry.bytes).then(|| data.bytes.extend_from_slice(payload))?;
        Some(length == entry.bytes)
    }

    pub(super) fn image(&self, image: usize) -> ReceivedImage<'_> {
        let (entry, data) = (&self.head.images[image], &self.images[image]);
        let (state, bytes) = if entry.bytes == 0 {
            (ImageState::Missing, &[][..])
        } else if data.bytes.len() as u64 == entry.bytes {
            (ImageState::Full, &data.bytes[..])
        } else if data.preview.is_empty() {
            (ImageState::Placeholder, &[][..])
        } else {
            (ImageState::Preview, &data.preview[..])
        };
        ReceivedImage { state, bytes, average: entry.average }
    }
}

impl ReceivedMesh {
    /// Whether the base has been decoded.
    pub(super) fn has_base(&self) -> bool {
        !self.decoder.first_vertices().is_empty()
    }

    /// The mesh received so far with its collapse sequence; [`None`] before its base has arrived.
    pub(super) fn refinable_mesh(&self) -> Option<RefinableMesh> {
        let mut refinable = self.decoder.refinable_mesh()?;
        if !self.decoder.info().is_some_and(|info| info.is_exact) {
            normalize_weights(&mut refinable.mesh);
        }
        Some(refinable)
    }

    /// Compares the header of the mesh's stream with the table.
    fn check(&mut self, info: &StreamInfo) -> Result<(), DecodeError> {
        let entry = self.entry;
        let found = [info.vertex_count, info.triangle_count, info.step_count, info.group_count];
        let expected = [entry.vertex_count, entry.triangle_count, entry.step_count, entry.group_count];
        if found != expected.map(|count| count as usize) {
            let reason = "the counts differ from those of the scene's table";
            return Err(DecodeError::Malformed { offset: 16, reason });
        }
        if info.stream_bytes != entry.bytes {
            return Err(DecodeError::FileLength { found: info.stream_bytes, expected: entry.bytes });
        }
        if info.has_fragments {
            let reason = "the steps of a mesh of a scene must be vertex splits";
            return Err(DecodeError::Malformed { offset: 16, reason });
        }
        self.is_checked = true;
        Ok(())
    }
}
