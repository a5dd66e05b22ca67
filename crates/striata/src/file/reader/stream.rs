//! Files with a stream, whole or cut off.

use super::super::container::{Container, Ending};
use super::super::{DecodeError, SectionKind, StreamCodec, StreamHead, StreamMesh, Verify};
use super::StriataFile;
use crate::mesh::{IndexedMesh, RefinableMesh, replay};

impl<'a> StriataFile<'a> {
    /// Reads a file that may be cut off within its stream: header, table and all sections before it must be there.
    ///
    /// A file that is whole is read as by [`parse`](Self::parse). Of one that is cut off the last bytes of the stream are
    /// taken as they stand, since their checksum is of bytes that are missing.
    ///
    /// # Errors
    /// As [`parse`](Self::parse).
    pub fn parse_cut(bytes: &'a [u8]) -> Result<Self, DecodeError> {
        Self::of_container(Container::parse(bytes, Verify::WhenRead, Ending::Cut)?)
    }

    /// A stream alone, whole or cut off, as if it were all that a file has. Its bounds are not known before it is decoded.
    ///
    /// # Errors
    /// As [`StreamCodec::head`].
    pub fn from_stream(bytes: &'a [u8], codec: &'static dyn StreamCodec) -> Result<Self, DecodeError> {
        let StreamHead { stream_bytes, summary } = codec.head(bytes)?;
        Ok(Self::of_parts(Container::of_stream(bytes, stream_bytes), summary).with_codec(codec))
    }

    /// Decodes the mesh with a codec, if it is in a stream alone.
    pub fn with_codec(self, codec: &'static dyn StreamCodec) -> Self {
        Self { codec: Some(codec), ..self }
    }

    fn codec(&self) -> Result<&'static dyn StreamCodec, DecodeError> {
        self.codec.ok_or(DecodeError::NoStreamCodec)
    }

    /// Whether the file ends before its stream does.
    pub fn is_cut(&self) -> bool {
        self.container.is_cut()
    }

    /// The bytes of the progressive stream, if the file has one; where the file is cut off, those that are there.
    pub fn stream(&self) -> Option<Result<&'a [u8], DecodeError>> {
        self.container.find(SectionKind::STREAM).transpose()
    }

    /// Whether mesh and levels are in a stream, and nowhere else.
    pub fn is_stream_only(&self) -> bool {
        self.has(SectionKind::STREAM) && !self.has(SectionKind::POSITIONS)
    }

    /// The texts in the head of a stream that is all that the file has.
    pub(super) fn metadata_of_stream(&self) -> Result<Vec<(String, String)>, DecodeError> {
        if !self.is_stream_only() {
            return Ok(Vec::new());
        }
        self.codec()?.metadata(self.container.get(SectionKind::STREAM)?)
    }

    /// What the stream tells, where the file has nothing else.
    pub(super) fn mesh_of_stream(&self) -> Result<Option<&RefinableMesh>, DecodeError> {
        if !self.is_stream_only() {
            return Ok(None);
        }
        if let Some(refinable) = self.decoded.get() {
            return Ok(Some(refinable));
        }
        let refinable = self.decode()?;
        Ok(Some(self.decoded.get_or_init(|| refinable)))
    }

    fn decode(&self) -> Result<RefinableMesh, DecodeError> {
        let codec = self.codec()?;
        let bytes = self.container.get(SectionKind::STREAM)?;
        let StreamMesh { refinable, is_complete } = codec.decode(bytes, self.is_cut())?;
        if is_complete {
            self.expect_decoded(&refinable)?;
        }
        refinable.mesh.check()?;
        Ok(refinable)
    }

    fn expect_decoded(&self, refinable: &RefinableMesh) -> Result<(), DecodeError> {
        let RefinableMesh { mesh, sequence } = refinable;
        let summary = &self.summary;
        for (what, found, expected) in [
            ("vertices", mesh.vertex_count(), summary.vertex_count),
            ("positions", sequence.positions().position_count(), summary.position_count),
            ("triangles", mesh.triangle_count(), summary.triangle_count),
            ("groups", mesh.groups.len(), summary.group_count),
            ("steps", sequence.step_count(), summary.step_count),
        ] {
            self.expect(SectionKind::STREAM, what, found, expected)?;
        }
        Ok(())
    }
}

/// # Errors
/// Where there is no such level, or not yet.
pub(super) fn level(refinable: &RefinableMesh, split_count: usize) -> Result<IndexedMesh, DecodeError> {
    let step_count = refinable.sequence.step_count();
    if split_count > step_count {
        return Err(DecodeError::SplitCount { split_count, step_count });
    }
    Ok(replay(refinable, split_count))
}
