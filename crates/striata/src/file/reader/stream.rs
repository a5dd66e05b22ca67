//! Files with a stream, whole or cut off.

use super::super::container::{Container, Ending};
use super::super::progressive::{StreamDecoder, StreamDefect, StreamFacts};
use super::super::{DecodeError, SectionKind, Summary, Verify};
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

    /// A stream alone, whole or cut off, as if it were all that a file has. Its bounds are not known before it is decoded.
    ///
    /// # Errors
    /// [`DecodeError`] where the bytes begin no sound stream, or end before its base mesh does.
    pub fn from_stream(bytes: &'a [u8]) -> Result<Self, DecodeError> {
        let Some(facts) = StreamFacts::read(bytes)? else {
            let found = bytes.len() as u64;
            return Err(DecodeError::FileLength { found, expected: found + 1 });
        };
        if facts.stream_bytes < bytes.len() as u64 {
            let (found, expected) = (bytes.len() as u64, facts.stream_bytes);
            return Err(DecodeError::FileLength { found, expected });
        }
        let base = usize::try_from(facts.base_bytes).ok().and_then(|length| bytes.get(..length));
        let Some(base) = base else {
            return Err(StreamDefect::NoBase.into());
        };
        let mut decoder = StreamDecoder::new();
        decoder.push(base)?;
        let summary = Summary {
            vertex_count: facts.vertex_count,
            position_count: facts.position_count,
            triangle_count: facts.triangle_count,
            group_count: facts.group_count,
            step_count: facts.step_count,
            base_position_count: facts.position_count - facts.step_count,
            base_vertex_count: decoder.positions().len(),
            base_triangle_count: decoder.triangles().len(),
            error_max: facts.error_max,
            bounds: None,
        };
        Ok(Self::of_parts(Container::of_stream(bytes, facts.stream_bytes), summary))
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
        let facts = StreamFacts::read(self.container.get(SectionKind::STREAM)?)?;
        Ok(facts.map_or(Vec::new(), |facts| facts.metadata))
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
