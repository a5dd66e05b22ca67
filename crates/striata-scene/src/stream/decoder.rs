//! The reader: takes bytes as they arrive and keeps everything received so far.

use serde_json::Value;
use striata::Lod;
use striata::mesh::RefinableMesh;
use striata_io::Scene;
use striata_stream::{StreamDecoder, StreamUpdate};

use super::SceneStreamError;
use super::head::{MeshEntry, SceneHead};
use super::images::ReceivedImage;
use super::packet::{HEADER_BYTES, PacketHead, PacketHeader, PacketKind, read_header};
use super::prefix::{ReceivedDocument, check_head, prefix_document, prefix_scene};
use super::received::{Received, ReceivedMesh};

/// Parts of a scene that one call to the decoder has received or improved.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct SceneStreamUpdate {
    /// Whether the document has arrived.
    pub has_document: bool,
    /// Changes of meshes, in the order in which they arrived; a mesh may occur several times.
    pub meshes: Vec<MeshUpdate>,
    /// Images that have improved, in the order in which they arrived.
    pub images: Vec<usize>,
    /// Whether a part of the buffer has arrived: skins, or animations.
    pub has_buffer: bool,
}

impl SceneStreamUpdate {
    /// Adds a change of all meshes that have the stream of a mesh.
    fn put(&mut self, received: &Received, source: usize, change: &StreamUpdate) {
        let meshes = received.meshes_with(source);
        self.meshes.extend(meshes.map(|mesh| MeshUpdate { mesh, update: change.clone() }));
    }
}

/// A change of a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct MeshUpdate {
    /// Index of the mesh.
    pub mesh: usize,
    /// Change that the bytes of its stream have made.
    pub update: StreamUpdate,
}

/// Decodes the stream of a scene. It accepts slices of bytes as they arrive; at any time,
/// [`scene`](Self::scene) returns what has been received so far.
#[derive(Clone, Debug, Default)]
pub struct SceneStreamDecoder {
    /// Bytes that have arrived but do not form a complete packet yet.
    waiting: Vec<u8>,
    /// Number of bytes of the packets that were read, with the header of the stream.
    read: u64,
    /// The header of the stream, once it has arrived.
    header: Option<PacketHeader>,
    received: Option<Box<Received>>,
    /// Whether decoding has ended, by an error or by [`finish`](Self::finish).
    is_over: bool,
}

impl SceneStreamDecoder {
    /// Creates a decoder that has not received any bytes.
    pub fn new() -> Self {
        Self::default()
    }

    /// Accepts the next bytes of the stream and decodes all packets that are complete.
    ///
    /// # Errors
    /// [`SceneStreamError`] if the bytes are not a valid stream. Whatever was received before remains
    /// available, but the decoder accepts no more bytes.
    pub fn push(&mut self, bytes: &[u8]) -> Result<SceneStreamUpdate, SceneStreamError> {
        if self.is_over {
            return Err(SceneStreamError::Over);
        }
        let mut waiting = std::mem::take(&mut self.waiting);
        waiting.extend_from_slice(bytes);
        let (start, mut update) = (self.read, SceneStreamUpdate::default());
        let result = self.read_all(&waiting, &mut update);
        // Drained once after all packets, since draining moves the remaining bytes.
        waiting.drain(..(self.read - start) as usize);
        self.waiting = waiting;
        self.is_over = result.is_err();
        result.map(|()| update)
    }

    /// Reads the header and every complete packet.
    fn read_all(&mut self, mut bytes: &[u8], update: &mut SceneStreamUpdate) -> Result<(), SceneStreamError> {
        if self.header.is_none() {
            let Some(header) = read_header(bytes)? else { return Ok(()) };
            self.header = Some(header);
            self.read = HEADER_BYTES as u64;
            bytes = &bytes[HEADER_BYTES..];
        }
        let (total, found) = (self.stream_bytes().unwrap_or(0), self.read + bytes.len() as u64);
        while self.read < total {
            let Some(packet) = PacketHead::read(bytes, self.read)? else { break };
            let end = self.read.saturating_add(packet.whole_bytes());
            if end > total {
                return Err(self.malformed("it ends after the end of the stream"));
            }
            if packet.whole_bytes() > bytes.len() as u64 {
                break;
            }
            let (whole, rest) = bytes.split_at(packet.head_bytes + packet.length);
            packet.check(whole, self.read)?;
            self.accept(packet, &whole[packet.head_bytes..], end, update)?;
            self.read = end;
            bytes = rest;
        }
        if found > total {
            return Err(SceneStreamError::Length { found, expected: total });
        }
        match (found == total).then(|| self.first_incomplete()).flatten() {
            Some(what) => Err(self.malformed(&format!("the stream ends without all of {what}"))),
            None => Ok(()),
        }
    }

    fn not_drawable(&self) -> SceneStreamError {
        // The document follows the header.
        let document = || PacketHead::read(&self.waiting, self.read).ok().flatten();
        let header = HEADER_BYTES as u64;
        let needed = self
            .drawable_at()
            .unwrap_or_else(|| header + document().map_or(1, |packet| packet.whole_bytes()));
        let found = self.received();
        SceneStreamError::NotDrawable { found, needed: needed.max(found + 1) }
    }

    fn malformed(&self, reason: &str) -> SceneStreamError {
        SceneStreamError::Packet { offset: self.read, reason: reason.to_owned() }
    }

    /// Takes the contents of a packet, which ends at byte `end` of the stream.
    fn accept(
        &mut self,
        packet: PacketHead,
        payload: &[u8],
        end: u64,
        update: &mut SceneStreamUpdate,
    ) -> Result<(), SceneStreamError> {
        let index = packet.index as usize;
        if packet.kind == PacketKind::Document {
            if self.received.is_some() || index != 0 {
                return Err(self.malformed("a second document"));
            }
            let version = self.header.map_or(0, |header| header.version);
            let head = SceneHead::from_bytes(payload, version)?;
            check_head(&head)?;
            self.received = Some(Box::new(Received::new(head, end)));
            update.has_document = true;
            return Ok(());
        }
        let offset = self.read;
        let fail = |reason: &str| Err(SceneStreamError::Packet { offset, reason: reason.to_owned() });
        let Some(received) = &mut self.received else { return fail("it precedes the document") };
        match packet.kind {
            PacketKind::Mesh => match received.push_mesh(index, payload)? {
                Some(change) => update.put(received, index, &change),
                None => return fail("it belongs to no mesh, or continues after the end of one"),
            },
            PacketKind::Buffer => {
                received.push_part(index, payload).map_or_else(|| fail("the buffer is malformed"), Ok)?;
                update.has_buffer = true;
            }
            _ => match received.push_image(packet.kind, index, payload) {
                Some(true) => update.images.push(index),
                Some(false) => {}
                None => return fail("it belongs to no image, or continues after the end of one"),
            },
        }
        Ok(())
    }

    /// Ends a stream that was cut: takes as much as possible of the last, incomplete packet, whose checksum
    /// cannot be compared. No more bytes are accepted afterward.
    ///
    /// # Errors
    /// [`SceneStreamError`] if the document is incomplete or the remaining bytes are invalid; the scene
    /// received so far remains available.
    pub fn finish(&mut self) -> Result<SceneStreamUpdate, SceneStreamError> {
        if self.is_over {
            return Err(SceneStreamError::Over);
        }
        self.is_over = true;
        let mut update = SceneStreamUpdate::default();
        if self.received.is_none() {
            return Err(self.not_drawable());
        }
        let Some(received) = &mut self.received else { return Ok(update) };
        let waiting = std::mem::take(&mut self.waiting);
        if let Some(packet) = PacketHead::read(&waiting, self.read)?.filter(|p| p.kind == PacketKind::Mesh) {
            let (mesh, payload) = (packet.index as usize, &waiting[packet.head_bytes..]);
            if let Some(change) = received.push_mesh(mesh, payload)? {
                update.put(received, mesh, &change);
            }
        }
        // They count as received.
        self.waiting = waiting;
        for mesh in 0..received.meshes.len() {
            let slot = received.meshes[mesh].as_mut();
            let Some(slot) = slot.filter(|slot| slot.has_base() && !slot.decoder.is_complete()) else {
                continue;
            };
            let change = slot.decoder.finish().map_err(|source| SceneStreamError::Mesh { mesh, source })?;
            update.put(received, mesh, &change);
        }
        Ok(update)
    }

    /// Names the first part that is incomplete, if any is.
    fn first_incomplete(&self) -> Option<String> {
        let Some(received) = &self.received else { return Some("the document".to_owned()) };
        let is_unfinished =
            |mesh: &Option<ReceivedMesh>| mesh.as_ref().is_some_and(|m| !m.decoder.is_complete());
        if let Some(mesh) = received.meshes.iter().position(is_unfinished) {
            return Some(format!("meshes[{mesh}]"));
        }
        let mut images = received.images.iter().zip(&received.head.images);
        if let Some(image) = images.position(|(data, entry)| (data.bytes.len() as u64) < entry.bytes) {
            return Some(format!("images[{image}]"));
        }
        received.parts.iter().any(Option::is_none).then(|| "the buffer".to_owned())
    }

    /// Whether the whole stream has been received.
    pub fn is_complete(&self) -> bool {
        self.stream_bytes() == Some(self.read) && self.first_incomplete().is_none()
    }

    /// Number of bytes received so far.
    pub fn received(&self) -> u64 {
        self.read + self.waiting.len() as u64
    }

    /// Length of the whole stream, bytes; [`None`] before its first 16 bytes have arrived.
    pub fn stream_bytes(&self) -> Option<u64> {
        self.header.map(|header| header.length)
    }

    /// Length of the prefix that shows every mesh, bytes; [`None`] before the document has arrived.
    pub fn drawable_at(&self) -> Option<u64> {
        let received = self.received.as_ref()?;
        received.document_end.checked_add(received.head.base_bytes)
    }

    /// Length of the prefix that also has previews of all images, bytes; [`None`] before the document has
    /// arrived.
    pub fn textured_at(&self) -> Option<u64> {
        let received = self.received.as_ref()?;
        received.document_end.checked_add(received.head.preview_bytes)
    }

    /// Whether every mesh has its base, and everything else that drawing needs has arrived.
    pub fn is_drawable(&self) -> bool {
        self.received.as_ref().is_some_and(|received| {
            let mut meshes = received.meshes.iter().flatten();
            received.parts[0].is_some() && meshes.all(ReceivedMesh::has_base)
        })
    }

    /// Checks that every mesh has its base, and that everything else that drawing needs has arrived.
    ///
    /// # Errors
    /// [`SceneStreamError::NotDrawable`] if not.
    pub fn check_drawable(&self) -> Result<(), SceneStreamError> {
        if self.is_drawable() { Ok(()) } else { Err(self.not_drawable()) }
    }

    /// The glTF document, without the data of geometry and images; [`None`] before it has arrived.
    pub fn document(&self) -> Option<&Value> {
        self.received.as_ref().map(|received| &received.head.document)
    }

    /// Texts that the writer added, as pairs of key and value.
    pub fn metadata(&self) -> &[(String, String)] {
        self.received.as_ref().map_or(&[], |received| &received.head.metadata)
    }

    /// Number of glTF meshes, with or without triangles; 0 before the document has arrived.
    pub fn mesh_count(&self) -> usize {
        self.received.as_ref().map_or(0, |received| received.meshes.len())
    }

    /// The decoder of a mesh; [`None`] if the mesh has no triangles, or the document has not arrived.
    ///
    /// Weights of joints are as they were rounded: divide those of a vertex by their sum, as
    /// [`scene`](Self::scene) and [`refinable_meshes`](Self::refinable_meshes) do.
    pub fn mesh(&self, mesh: usize) -> Option<&StreamDecoder> {
        Some(&self.received_mesh(mesh)?.decoder)
    }

    fn received_mesh(&self, mesh: usize) -> Option<&ReceivedMesh> {
        self.received.as_ref()?.mesh(mesh)
    }

    /// Largest factor from units of a mesh to units of the scene; 0 if the scene does not show the mesh.
    pub fn mesh_scale(&self, mesh: usize) -> Option<f64> {
        Some((*self.received.as_ref()?.head.meshes.get(mesh)?)?.scale)
    }

    /// Largest error of any mesh received so far, in units of the scene; 0 once all are complete. [`None`]
    /// before the scene is drawable.
    pub fn error(&self) -> Option<f64> {
        let received = self.received.as_ref().filter(|_| self.is_drawable())?;
        let of = |(mesh, entry): (usize, &Option<MeshEntry>)| {
            let error = received.mesh(mesh)?.decoder.error().unwrap_or(0.0);
            Some(f64::from(error) * entry.as_ref()?.scale)
        };
        Some(received.head.meshes.iter().enumerate().filter_map(of).fold(0.0, f64::max))
    }

    /// Number of images; 0 before the document has arrived.
    pub fn image_count(&self) -> usize {
        self.received.as_ref().map_or(0, |received| received.images.len())
    }

    /// Returns the received part of an image; [`None`] if there is no such image, or the document has not
    /// arrived.
    pub fn image(&self, image: usize) -> Option<ReceivedImage<'_>> {
        let received = self.received.as_ref()?;
        (image < received.images.len()).then(|| received.image(image))
    }

    /// The mesh received so far of each glTF mesh, with its collapse sequence; [`None`] for meshes without
    /// triangles and those whose base has not arrived.
    pub fn refinable_meshes(&self) -> Vec<Option<RefinableMesh>> {
        (0..self.mesh_count()).map(|mesh| self.received_mesh(mesh)?.refinable_mesh()).collect()
    }

    /// All levels received so far of each glTF mesh, as [`refinable_meshes`](Self::refinable_meshes).
    pub fn lods(&self) -> Vec<Option<Lod>> {
        let Some(received) = &self.received else { return Vec::new() };
        let lod_of =
            |mesh: &Option<ReceivedMesh>| Some(Lod::from_refinable(mesh.as_ref()?.refinable_mesh()?));
        let lods: Vec<Option<Lod>> = received.meshes.iter().map(lod_of).collect();
        received.head.sources.iter().map(|&source| lods[source].clone()).collect()
    }

    /// The scene received so far: meshes at the level that has arrived, and instead of missing images their
    /// previews or single pixels of their average color. Animations appear once they have arrived.
    ///
    /// # Errors
    /// [`SceneStreamError::NotDrawable`] before the document and the skins have arrived. Meshes whose base
    /// has not arrived show nothing: see [`is_drawable`](Self::is_drawable).
    pub fn scene(&self) -> Result<Scene, SceneStreamError> {
        prefix_scene(self.received_parts()?, self.received())
    }

    /// The scene received so far, without its geometry.
    ///
    /// # Errors
    /// [`SceneStreamError::NotDrawable`] before the document and the skins have arrived.
    pub fn received_document(&self) -> Result<ReceivedDocument, SceneStreamError> {
        prefix_document(self.received_parts()?, self.received())
    }

    fn received_parts(&self) -> Result<&Received, SceneStreamError> {
        self.received.as_deref().ok_or_else(|| self.not_drawable())
    }
}
