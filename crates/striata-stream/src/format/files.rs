//! `.striata` files that contain a stream: opening them with a decoder, and storing a stream in one.

use striata::file::{
    self, EncodeError, FileModel, StoredStream, StreamCodec, StreamHead, StreamMesh, StriataFile, Summary,
    Verify,
};
use striata::ignore_progress;

use crate::format::error::DecodeError;
use crate::format::info::StreamInfo;
use crate::reader::decode::StreamDecoder;

/// Decodes the streams inside a [`StriataFile`].
#[derive(Clone, Copy, Debug)]
struct FileCodec;

/// Reads a `.striata` file like [`StriataFile::parse`] and attaches a decoder for its stream.
///
/// # Errors
/// The errors of [`StriataFile::parse`].
pub fn open(bytes: &[u8]) -> Result<StriataFile<'_>, file::DecodeError> {
    open_with(bytes, Verify::WhenRead)
}

/// Reads a `.striata` file like [`open`]; `verify` says when checksums are compared.
///
/// # Errors
/// The errors of [`StriataFile::parse_with`].
pub fn open_with(bytes: &[u8], verify: Verify) -> Result<StriataFile<'_>, file::DecodeError> {
    Ok(StriataFile::parse_with(bytes, verify)?.with_codec(&FileCodec))
}

/// Reads a file that may be truncated within its stream, like [`StriataFile::parse_truncated`], and
/// attaches a decoder.
///
/// # Errors
/// The errors of [`StriataFile::parse_truncated`].
pub fn open_truncated(bytes: &[u8]) -> Result<StriataFile<'_>, file::DecodeError> {
    Ok(StriataFile::parse_truncated(bytes)?.with_codec(&FileCodec))
}

/// Opens a bare stream, complete or truncated, as a file that contains only this stream.
///
/// Its bounds are unknown until it has been decoded.
///
/// # Errors
/// [`file::DecodeError`] if the bytes are not a valid stream, continue after its end, or end before the
/// base mesh does.
pub fn open_stream(bytes: &[u8]) -> Result<StriataFile<'_>, file::DecodeError> {
    StriataFile::from_stream(bytes, &FileCodec)
}

/// Wraps a stream as a model that can be stored in a `.striata` file.
///
/// # Errors
/// [`EncodeError::Model`] if the length differs from the one in the stream's header.
pub fn file_model(stream: &[u8]) -> Result<FileModel<'_>, EncodeError> {
    let info = StreamInfo::read(stream).ok().flatten().unwrap_or_default();
    let model = FileModel::Progressive(StoredStream {
        bytes: stream,
        vertex_count: info.vertex_count,
        triangle_count: info.triangle_count,
        step_count: info.step_count,
        group_count: info.group_count,
    });
    let (found, expected) = (stream.len(), usize::try_from(info.stream_bytes).unwrap_or(usize::MAX));
    if found != expected {
        return Err(EncodeError::Model { model: model.kind(), what: "bytes", found, expected });
    }
    Ok(model)
}

impl StreamCodec for FileCodec {
    fn head(&self, stream: &[u8]) -> Result<StreamHead, file::DecodeError> {
        Ok(read_head(stream)?)
    }

    fn metadata(&self, stream: &[u8]) -> Result<Vec<(String, String)>, file::DecodeError> {
        let info = StreamInfo::read(stream)?;
        Ok(info.map_or(Vec::new(), |info| info.metadata))
    }

    fn decode(&self, stream: &[u8], is_truncated: bool) -> Result<StreamMesh, file::DecodeError> {
        Ok(decode(stream, is_truncated)?)
    }
}

fn read_head(bytes: &[u8]) -> Result<StreamHead, DecodeError> {
    let (info, found) = (StreamInfo::with_base(bytes)?, bytes.len() as u64);
    if info.stream_bytes < found {
        return Err(DecodeError::FileLength { found, expected: info.stream_bytes });
    }
    let mut decoder = StreamDecoder::new();
    decoder.push(&bytes[..info.base_bytes as usize])?;
    let mut summary = Summary::default();
    summary.vertex_count = info.vertex_count;
    summary.position_count = info.position_count;
    summary.triangle_count = info.triangle_count;
    summary.group_count = info.group_count;
    summary.step_count = info.step_count;
    summary.base_position_count = info.position_count - info.step_count;
    summary.base_vertex_count = decoder.positions().len();
    summary.base_triangle_count = decoder.triangles().len();
    summary.error_max = info.error_max;
    Ok(StreamHead { stream_bytes: info.stream_bytes, summary, has_collapses: !decoder.has_fragments() })
}

fn decode(bytes: &[u8], is_truncated: bool) -> Result<StreamMesh, DecodeError> {
    let mut decoder = StreamDecoder::new();
    decoder.push_with_progress(bytes, &mut ignore_progress)?;
    let malformed = |reason| DecodeError::Malformed { offset: bytes.len(), reason };
    if !decoder.is_complete() {
        if !is_truncated {
            return Err(malformed("the stream is truncated"));
        }
        decoder.finish()?;
    }
    let steps = decoder.steps().ok_or_else(|| malformed("the stream has no mesh"))?;
    Ok(StreamMesh { steps, is_complete: decoder.is_complete() })
}
