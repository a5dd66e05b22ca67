//! Reading of files with a stream, complete or truncated.

use super::super::container::{Container, Ending};
use super::super::{DecodeError, SectionKind, StreamCodec, StreamHead, StreamMesh, Verify};
use super::StriataFile;
use crate::mesh::{IndexedMesh, Steps};

impl<'a> StriataFile<'a> {
    /// Reads a file that may be truncated within its stream; the header, the table and all other sections
    /// must be present.
    ///
    /// A complete file is read as by [`parse`](Self::parse). In a truncated file, the checksum of the
    /// stream cannot be verified, since it covers bytes that are missing.
    ///
    /// # Errors
    /// [`DecodeError`] under the conditions of [`parse`](Self::parse).
    pub fn parse_truncated(bytes: &'a [u8]) -> Result<Self, DecodeError> {
        Self::of_container(Container::parse(bytes, Verify::WhenRead, Ending::Cut)?)
    }

    /// Treats a bare stream, complete or truncated, as a file that contains nothing else. Its bounds are
    /// unknown until it is decoded.
    ///
    /// # Errors
    /// [`DecodeError`] under the conditions of [`StreamCodec::head`].
    pub fn from_stream(bytes: &'a [u8], codec: &'static dyn StreamCodec) -> Result<Self, DecodeError> {
        let StreamHead { stream_bytes, summary, .. } = codec.head(bytes)?;
        Ok(Self::of_parts(Container::of_stream(bytes, stream_bytes), summary).with_codec(codec))
    }

    /// Sets the codec that decodes the mesh of a file that contains only a stream.
    pub fn with_codec(self, codec: &'static dyn StreamCodec) -> Self {
        Self { codec: Some(codec), ..self }
    }

    fn codec(&self) -> Result<&'static dyn StreamCodec, DecodeError> {
        self.codec.ok_or(DecodeError::NoStreamCodec)
    }

    /// Whether the file is truncated within its stream.
    pub fn is_truncated(&self) -> bool {
        self.container.is_truncated()
    }

    /// Bytes of the progressive stream, if the file has one; if the file is truncated, those that are
    /// present.
    pub fn stream(&self) -> Option<Result<&'a [u8], DecodeError>> {
        self.container.find(SectionKind::STREAM).transpose()
    }

    /// Whether the mesh and its levels are stored only as a stream.
    pub fn is_stream_only(&self) -> bool {
        self.has(SectionKind::STREAM) && !self.has(SectionKind::POSITIONS)
    }

    /// The metadata in the head of a stream, if the file contains only a stream.
    pub(super) fn metadata_of_stream(&self) -> Result<Vec<(String, String)>, DecodeError> {
        if !self.is_stream_only() {
            return Ok(Vec::new());
        }
        self.codec()?.metadata(self.container.get(SectionKind::STREAM)?)
    }

    /// Whether the steps of the stream are collapses; true if that cannot be known.
    pub(super) fn has_collapses_in_stream(&self) -> bool {
        if let Some(steps) = self.decoded.get() {
            return steps.collapses().is_some();
        }
        let head = || self.codec()?.head(self.container.get(SectionKind::STREAM)?);
        head().map_or(true, |head| head.has_collapses)
    }

    /// The decoded mesh of the stream, if the file contains only a stream.
    pub(super) fn mesh_of_stream(&self) -> Result<Option<&Steps>, DecodeError> {
        if !self.is_stream_only() {
            return Ok(None);
        }
        if let Some(steps) = self.decoded.get() {
            return Ok(Some(steps));
        }
        let steps = self.decode()?;
        Ok(Some(self.decoded.get_or_init(|| steps)))
    }

    fn decode(&self) -> Result<Steps, DecodeError> {
        let codec = self.codec()?;
        let bytes = self.container.get(SectionKind::STREAM)?;
        let StreamMesh { steps, is_complete } = codec.decode(bytes, self.is_truncated())?;
        if is_complete {
            self.expect_decoded(&steps)?;
        }
        steps.mesh().check()?;
        Ok(steps)
    }

    fn expect_decoded(&self, steps: &Steps) -> Result<(), DecodeError> {
        let (mesh, levels) = (steps.mesh(), steps.levels());
        let summary = &self.summary;
        for (what, found, expected) in [
            ("vertices", mesh.vertex_count(), summary.vertex_count),
            ("positions", levels.positions().position_count(), summary.position_count),
            ("triangles", mesh.triangle_count(), summary.triangle_count),
            ("groups", mesh.groups.len(), summary.group_count),
            ("steps", levels.step_count(), summary.step_count),
        ] {
            self.expect(SectionKind::STREAM, what, found, expected)?;
        }
        Ok(())
    }
}

/// Extracts a level of a decoded stream.
///
/// # Errors
/// [`DecodeError::SplitCount`] if the level does not exist or has not been received yet.
pub(super) fn level(steps: &Steps, split_count: usize) -> Result<IndexedMesh, DecodeError> {
    let step_count = steps.levels().step_count();
    if split_count > step_count {
        return Err(DecodeError::SplitCount { split_count, step_count });
    }
    Ok(steps.level(split_count))
}
