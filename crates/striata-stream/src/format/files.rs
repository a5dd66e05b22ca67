//! Files of the library with streams: reading them with a decoder, and storing a stream in them.

use striata::file::{
    self, EncodeError, FileModel, StoredStream, StreamCodec, StreamHead, StreamMesh, StriataFile, Summary,
    Verify,
};

use crate::format::error::{DecodeError, StreamDefect};
use crate::format::facts::StreamFacts;
use crate::reader::decode::StreamDecoder;

/// Bytes that a decoder gets at once: what waits is moved with each chunk.
const PIECE_BYTES: usize = 1 << 16;

/// Decodes the streams of [`StriataFile`].
#[derive(Clone, Copy, Debug)]
struct Codec;

/// Reads a `.striata` file as [`StriataFile::parse`] does, with a decoder for its stream.
///
/// # Errors
/// As [`StriataFile::parse`].
pub fn open(bytes: &[u8]) -> Result<StriataFile<'_>, file::DecodeError> {
    open_with(bytes, Verify::WhenRead)
}

/// The same, saying when checksums are compared.
///
/// # Errors
/// As [`StriataFile::parse_with`].
pub fn open_with(bytes: &[u8], verify: Verify) -> Result<StriataFile<'_>, file::DecodeError> {
    Ok(StriataFile::parse_with(bytes, verify)?.with_codec(&Codec))
}

/// Reads a file that may be cut off within its stream as [`StriataFile::parse_cut`] does, with a decoder for the stream.
///
/// # Errors
/// As [`StriataFile::parse_cut`].
pub fn open_cut(bytes: &[u8]) -> Result<StriataFile<'_>, file::DecodeError> {
    Ok(StriataFile::parse_cut(bytes)?.with_codec(&Codec))
}

/// A stream alone, whole or cut off, as if it were all that a file has. Its bounds are not known before it is decoded.
///
/// # Errors
/// [`file::DecodeError`] if the bytes begin no sound stream, go on after its end, or end before its base mesh does.
pub fn open_stream(bytes: &[u8]) -> Result<StriataFile<'_>, file::DecodeError> {
    StriataFile::from_stream(bytes, &Codec)
}

/// A stream as a model to be stored in a file.
///
/// # Errors
/// [`EncodeError::Model`] if the bytes are not as many as the head of a stream says.
pub fn file_model(stream: &[u8]) -> Result<FileModel<'_>, EncodeError> {
    let facts = StreamFacts::read(stream).ok().flatten().unwrap_or_default();
    let model = FileModel::Progressive(StoredStream {
        bytes: stream,
        vertex_count: facts.vertex_count,
        triangle_count: facts.triangle_count,
        step_count: facts.step_count,
        group_count: facts.group_count,
    });
    let (found, expected) = (stream.len(), usize::try_from(facts.stream_bytes).unwrap_or(usize::MAX));
    if found != expected {
        return Err(EncodeError::Model { model: model.kind(), what: "bytes", found, expected });
    }
    Ok(model)
}

impl StreamCodec for Codec {
    fn head(&self, stream: &[u8]) -> Result<StreamHead, file::DecodeError> {
        Ok(read_head(stream)?)
    }

    fn metadata(&self, stream: &[u8]) -> Result<Vec<(String, String)>, file::DecodeError> {
        let facts = StreamFacts::read(stream)?;
        Ok(facts.map_or(Vec::new(), |facts| facts.metadata))
    }

    fn decode(&self, stream: &[u8], is_cut: bool) -> Result<StreamMesh, file::DecodeError> {
        Ok(decode(stream, is_cut)?)
    }
}

fn read_head(bytes: &[u8]) -> Result<StreamHead, DecodeError> {
    let found = bytes.len() as u64;
    let Some(facts) = StreamFacts::read(bytes)? else {
        return Err(DecodeError::FileLength { found, expected: found + 1 });
    };
    if facts.stream_bytes < found {
        return Err(DecodeError::FileLength { found, expected: facts.stream_bytes });
    }
    let base = usize::try_from(facts.base_bytes).ok().and_then(|length| bytes.get(..length));
    let Some(base) = base else {
        return Err(StreamDefect::NoBase.into());
    };
    let mut decoder = StreamDecoder::new();
    decoder.push(base)?;
    let mut summary = Summary::default();
    summary.vertex_count = facts.vertex_count;
    summary.position_count = facts.position_count;
    summary.triangle_count = facts.triangle_count;
    summary.group_count = facts.group_count;
    summary.step_count = facts.step_count;
    summary.base_position_count = facts.position_count - facts.step_count;
    summary.base_vertex_count = decoder.positions().len();
    summary.base_triangle_count = decoder.triangles().len();
    summary.error_max = facts.error_max;
    Ok(StreamHead { stream_bytes: facts.stream_bytes, summary })
}

fn decode(bytes: &[u8], is_cut: bool) -> Result<StreamMesh, DecodeError> {
    let mut decoder = StreamDecoder::new();
    for piece in bytes.chunks(PIECE_BYTES) {
        decoder.push(piece)?;
    }
    let malformed = |reason| DecodeError::Malformed { offset: bytes.len(), reason };
    if !decoder.is_complete() {
        if !is_cut {
            return Err(malformed("the stream goes on"));
        }
        decoder.finish()?;
    }
    let refinable = decoder.refinable_mesh().ok_or_else(|| malformed("the stream gives no mesh"))?;
    Ok(StreamMesh { refinable, is_complete: decoder.is_complete() })
}
