//! Files with a stream, whole or cut off.

use super::super::container::{Container, Ending};
use super::super::progressive::StreamDecoder;
use super::super::{DecodeError, SectionKind, Verify};
use super::StriataFile;
use crate::mesh::{IndexedMesh, RefinableMesh, replay};

/// Bytes that a decoder gets at once: what waits is moved with each chunk.
const PIECE_BYTES: usize = 1 << 16;

/// What a stream tells.
#[derive(Clone, Debug)]
pub(super) struct DecodedStream {
    refinable: RefinableMesh,
}

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

    /// What the stream tells, where the file has nothing else.
    pub(super) fn mesh_of_stream(&self) -> Result<Option<&RefinableMesh>, DecodeError> {
        if !self.is_stream_only() {
            return Ok(None);
        }
        if let Some(decoded) = self.decoded.get() {
            return Ok(Some(&decoded.refinable));
        }
        let refinable = self.decode()?;
        Ok(Some(&self.decoded.get_or_init(|| DecodedStream { refinable }).refinable))
    }

    fn decode(&self) -> Result<RefinableMesh, DecodeError> {
        let bytes = self.container.get(SectionKind::STREAM)?;
        let mut decoder = StreamDecoder::new();
        for piece in bytes.chunks(PIECE_BYTES) {
            decoder.push(piece)?;
        }
        if !decoder.is_complete() {
            if !self.is_cut() {
                let (kind, offset) = (SectionKind::STREAM, bytes.len());
                return Err(DecodeError::Malformed { kind, offset, reason: "the stream goes on" });
            }
            decoder.finish()?;
        }
        let is_complete = decoder.is_complete();
        let Some(refinable) = decoder.refinable_mesh() else {
            let (kind, offset) = (SectionKind::STREAM, bytes.len());
            return Err(DecodeError::Malformed { kind, offset, reason: "the stream gives no mesh" });
        };
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
