//! The first packet: the document, and a table of everything that follows.

use serde_json::Value;

use super::SceneStreamError;
use super::bytes::{Fields, put_text, put_varint};
use super::deflate::{deflate, inflate};
use super::packet::{PLAIN_VERSION, SHARING_VERSION};
use crate::copies::Copies;

/// Content of the first packet: the document, and a table of everything that follows.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SceneHead {
    /// The glTF document, without geometry and images.
    pub document: Value,
    /// Texts that the writer adds, as pairs of key and value.
    pub metadata: Vec<(String, String)>,
    /// Length of the packets after this one until every mesh can be drawn, bytes.
    pub base_bytes: u64,
    /// Length of the packets after this one until every image has a preview, bytes.
    pub preview_bytes: u64,
    /// Byte ranges of each part of the buffer; the parts together are the buffer.
    pub buffer: [Vec<ByteRange>; PART_COUNT],
    pub meshes: Vec<Option<MeshEntry>>,
    /// Mesh whose stream each mesh has; usually itself.
    pub sources: Vec<usize>,
    pub images: Vec<ImageEntry>,
}

/// Number of parts of the buffer: what is needed to draw the scene, and what animations need.
pub(super) const PART_COUNT: usize = 2;

/// A range of the buffer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ByteRange {
    pub offset: u64,
    pub length: u64,
}

/// A mesh that follows as a stream.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct MeshEntry {
    /// Length of the mesh's own stream; 0 if it has that of another mesh.
    pub bytes: u64,
    pub vertex_count: u32,
    pub triangle_count: u32,
    pub step_count: u32,
    pub group_count: u32,
    /// Error of the base mesh, mesh units.
    pub error: f32,
    /// Largest factor from mesh units to scene units; 0 if the scene does not show the mesh.
    pub scale: f64,
}

/// An image that follows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct ImageEntry {
    /// Length of the image; 0 if it is missing.
    pub bytes: u64,
    /// Length of the preview; 0 if there is none.
    pub preview_bytes: u64,
    /// Width and height, or 0 if they are unknown.
    pub size: (u32, u32),
    /// Average color, RGBA.
    pub average: [u8; 4],
    pub name: String,
    pub uri: String,
    pub mime_type: String,
}

/// Returns how many bytes may be unpacked from `packed` bytes.
fn limit_of(packed: usize) -> usize {
    packed.saturating_mul(128).max(1 << 20)
}

impl SceneHead {
    /// Returns the total length of the buffer.
    pub(super) fn buffer_bytes(&self) -> u64 {
        self.buffer.iter().flatten().map(|range| range.length).sum()
    }

    /// Meshes that have the streams of others.
    fn copies(&self) -> impl Iterator<Item = (usize, usize)> {
        self.sources.iter().copied().enumerate().filter(|(mesh, source)| mesh != source)
    }

    /// Version of the stream.
    pub(super) fn version(&self) -> u8 {
        if self.copies().next().is_none() { PLAIN_VERSION } else { SHARING_VERSION }
    }

    /// Serializes and compresses the document and the table.
    pub(super) fn to_bytes(&self) -> Vec<u8> {
        let mut out = Vec::new();
        put_text(&self.document.to_string(), &mut out);
        put_varint(self.metadata.len() as u64, &mut out);
        for text in self.metadata.iter().flat_map(|(key, value)| [key, value]) {
            put_text(text, &mut out);
        }
        put_varint(self.base_bytes, &mut out);
        put_varint(self.preview_bytes, &mut out);
        for part in &self.buffer {
            put_varint(part.len() as u64, &mut out);
            for range in part {
                put_varint(range.offset, &mut out);
                put_varint(range.length, &mut out);
            }
        }
        put_varint(self.meshes.len() as u64, &mut out);
        self.meshes.iter().for_each(|mesh| mesh.unwrap_or_default().write(&mut out));
        put_varint(self.images.len() as u64, &mut out);
        self.images.iter().for_each(|image| image.write(&mut out));
        if self.version() == SHARING_VERSION {
            put_varint(self.copies().count() as u64, &mut out);
            for (mesh, source) in self.copies() {
                put_varint(mesh as u64, &mut out);
                put_varint(source as u64, &mut out);
                out.extend(self.meshes[mesh].unwrap_or_default().scale.to_le_bytes());
            }
        }
        deflate(&out, limit_of)
    }

    /// Reads the payload of the first packet.
    pub(super) fn from_bytes(packed: &[u8], version: u8) -> Result<Self, SceneStreamError> {
        let fail = |reason: &str| SceneStreamError::Document(reason.to_owned());
        let limit = limit_of(packed.len());
        let bytes = inflate(packed, limit)
            .ok_or_else(|| fail(&format!("it cannot be unpacked to at most {limit} bytes")))?;
        let mut fields = Fields::new(&bytes);
        let json = fields.text().ok_or_else(|| fail("its text is not valid"))?;
        let document = serde_json::from_str(&json).map_err(|error| fail(&error.to_string()))?;
        let mut head =
            Self::read_table(&mut fields, document).ok_or_else(|| fail("the table ends too early"))?;
        if version == SHARING_VERSION {
            let reason = "a mesh has the stream of a mesh without one, or too many have one";
            head.read_copies(&mut fields).ok_or_else(|| fail(reason))?;
        }
        if !fields.rest().is_empty() {
            return Err(fail("bytes follow the table"));
        }
        head.check_ranges().ok_or_else(|| fail("the parts of the buffer overlap or leave gaps"))?;
        Ok(head)
    }

    fn read_table(fields: &mut Fields<'_>, document: Value) -> Option<Self> {
        let mut metadata = Vec::new();
        for _ in 0..fields.count(2)? {
            metadata.push((fields.text()?, fields.text()?));
        }
        let (base_bytes, preview_bytes) = (fields.varint()?, fields.varint()?);
        let mut buffer: [Vec<ByteRange>; PART_COUNT] = Default::default();
        for part in &mut buffer {
            for _ in 0..fields.count(2)? {
                part.push(ByteRange { offset: fields.varint()?, length: fields.varint()? });
            }
        }
        let mesh_count = fields.count(1)?;
        let meshes = (0..mesh_count).map(|_| MeshEntry::read(fields)).collect::<Option<_>>()?;
        let image_count = fields.count(9)?;
        let images = (0..image_count).map(|_| ImageEntry::read(fields)).collect::<Option<_>>()?;
        let sources = (0..mesh_count).collect();
        Some(Self { document, metadata, base_bytes, preview_bytes, buffer, meshes, sources, images })
    }

    /// Reads which meshes have the streams of others.
    fn read_copies(&mut self, fields: &mut Fields<'_>) -> Option<()> {
        let mut copies = Copies::default();
        for _ in 0..fields.count(10)? {
            let (mesh, source) = (fields.varint_u32()? as usize, fields.varint_u32()? as usize);
            let scale = f64::from_le_bytes(fields.array()?);
            let entry = (*self.meshes.get(source)?).filter(|entry| entry.bytes > 0)?;
            let slot = self.meshes.get_mut(mesh).filter(|slot| slot.is_none())?;
            *slot = Some(MeshEntry { bytes: 0, scale, ..entry });
            copies.add(entry.vertex_count as usize, entry.triangle_count as usize).then_some(())?;
            self.sources[mesh] = source;
        }
        Some(())
    }

    /// Checks that the parts are disjoint and cover the buffer.
    fn check_ranges(&self) -> Option<()> {
        let mut ranges: Vec<ByteRange> = self.buffer.iter().flatten().copied().collect();
        ranges.sort_unstable_by_key(|range| range.offset);
        let mut end = 0u64;
        for range in ranges {
            let is_next = range.offset == end && range.length > 0;
            end = end.checked_add(range.length).filter(|_| is_next)?;
        }
        Some(())
    }
}

impl MeshEntry {
    fn write(self, out: &mut Vec<u8>) {
        put_varint(self.bytes, out);
        if self.bytes == 0 {
            return;
        }
        let counts = [self.vertex_count, self.triangle_count, self.step_count, self.group_count];
        counts.into_iter().for_each(|count| put_varint(u64::from(count), out));
        out.extend(self.error.to_le_bytes());
        out.extend(self.scale.to_le_bytes());
    }

    /// Reads an entry; the inner value is [`None`] for a mesh without triangles.
    #[expect(clippy::option_option, reason = "the outer option is the end of the bytes")]
    fn read(fields: &mut Fields<'_>) -> Option<Option<Self>> {
        let bytes = fields.varint()?;
        if bytes == 0 {
            return Some(None);
        }
        let mut entry = Self { bytes, ..Self::default() };
        for count in [
            &mut entry.vertex_count,
            &mut entry.triangle_count,
            &mut entry.step_count,
            &mut entry.group_count,
        ] {
            *count = fields.varint_u32()?;
        }
        entry.error = f32::from_le_bytes(fields.array()?);
        entry.scale = f64::from_le_bytes(fields.array()?);
        Some(Some(entry))
    }
}

impl ImageEntry {
    fn write(&self, out: &mut Vec<u8>) {
        put_varint(self.bytes, out);
        put_varint(self.preview_bytes, out);
        put_varint(u64::from(self.size.0), out);
        put_varint(u64::from(self.size.1), out);
        out.extend(self.average);
        [&self.name, &self.uri, &self.mime_type].into_iter().for_each(|text| put_text(text, out));
    }

    fn read(fields: &mut Fields<'_>) -> Option<Self> {
        Some(Self {
            bytes: fields.varint()?,
            preview_bytes: fields.varint()?,
            size: (fields.varint_u32()?, fields.varint_u32()?),
            average: fields.array()?,
            name: fields.text()?,
            uri: fields.text()?,
            mime_type: fields.text()?,
        })
    }
}
