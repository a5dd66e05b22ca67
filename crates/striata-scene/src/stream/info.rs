//! Properties of a stream, read from its first packet alone.

use super::SceneStreamError;
use super::head::{ImageEntry, MeshEntry, SceneHead};
use super::packet::{HEADER_BYTES, PacketHead, PacketHeader, PacketKind, read_header};

/// Counts and sizes of a scene stream, read without decoding meshes or images.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SceneStreamInfo {
    /// Length of the whole stream, bytes.
    pub stream_bytes: u64,
    /// Length of the prefix that contains the document, bytes.
    pub document_bytes: u64,
    /// Length of the prefix that shows every mesh, bytes.
    pub drawable_at: u64,
    /// Length of the prefix that also has previews of all images, bytes.
    pub textured_at: u64,
    /// Length of the unpacked buffer of animations and skins, bytes.
    pub buffer_bytes: u64,
    /// The glTF meshes; [`None`] for meshes without triangles.
    pub meshes: Vec<Option<StreamedMesh>>,
    /// The images.
    pub images: Vec<StreamedImage>,
    /// Texts that the writer added, as pairs of key and value.
    pub metadata: Vec<(String, String)>,
}

/// A mesh of a scene stream.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StreamedMesh {
    /// Length of the mesh's own stream, bytes; 0 if it has that of another mesh.
    pub bytes: u64,
    /// Number of vertices of the full mesh.
    pub vertex_count: u32,
    /// Number of triangles of the full mesh.
    pub triangle_count: u32,
    /// Number of vertex splits from the base mesh to the full mesh.
    pub step_count: u32,
    /// Error of the base mesh, mesh units.
    pub error: f32,
    /// Largest factor from mesh units to units of the scene; 0 if the scene does not show the mesh.
    pub scale: f64,
}

/// An image of a scene stream.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct StreamedImage {
    /// Length of the image, bytes; 0 if the source did not contain it.
    pub bytes: u64,
    /// Length of the preview, bytes; 0 if there is none.
    pub preview_bytes: u64,
    /// Width and height, pixels; 0 if unknown.
    pub size: (u32, u32),
    /// Average color, RGBA.
    pub average: [u8; 4],
    /// MIME type.
    pub mime_type: String,
}

impl SceneStreamInfo {
    /// Reads the first packet of a stream; returns [`None`] if `bytes` ends within it.
    ///
    /// # Errors
    /// [`SceneStreamError`] if the bytes are not a scene stream of a known version, or the packet is damaged.
    pub fn read(bytes: &[u8]) -> Result<Option<Self>, SceneStreamError> {
        let Some(PacketHeader { version, length: stream_bytes }) = read_header(bytes)? else {
            return Ok(None);
        };
        let (offset, bytes) = (HEADER_BYTES as u64, &bytes[HEADER_BYTES..]);
        let Some(packet) = PacketHead::read(bytes, offset)? else { return Ok(None) };
        if packet.kind != PacketKind::Document {
            let reason = "the stream does not begin with a document".to_owned();
            return Err(SceneStreamError::Packet { offset, reason });
        }
        if packet.whole_bytes() > bytes.len() as u64 {
            return Ok(None);
        }
        let bytes = &bytes[..packet.head_bytes + packet.length];
        packet.check(bytes, offset)?;
        let head = SceneHead::from_bytes(&bytes[packet.head_bytes..], version)?;
        let document_bytes = offset + bytes.len() as u64;
        Ok(Some(Self {
            stream_bytes,
            document_bytes,
            drawable_at: document_bytes.saturating_add(head.base_bytes),
            textured_at: document_bytes.saturating_add(head.preview_bytes),
            buffer_bytes: head.buffer_bytes(),
            meshes: head.meshes.iter().map(|mesh| mesh.map(StreamedMesh::from)).collect(),
            images: head.images.into_iter().map(StreamedImage::from).collect(),
            metadata: head.metadata,
        }))
    }

    /// Number of triangles of all full meshes, each counted once.
    pub fn triangle_count(&self) -> u64 {
        self.meshes.iter().flatten().map(|mesh| u64::from(mesh.triangle_count)).sum()
    }
}

impl From<MeshEntry> for StreamedMesh {
    fn from(entry: MeshEntry) -> Self {
        let MeshEntry { bytes, vertex_count, triangle_count, step_count, error, scale, .. } = entry;
        Self { bytes, vertex_count, triangle_count, step_count, error, scale }
    }
}

impl From<ImageEntry> for StreamedImage {
    fn from(entry: ImageEntry) -> Self {
        let ImageEntry { bytes, preview_bytes, size, average, mime_type, .. } = entry;
        Self { bytes, preview_bytes, size, average, mime_type }
    }
}
