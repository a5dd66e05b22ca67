//! Streams in: decoded chunk by chunk, as far as they are there or as far as somebody needs them.

use std::time::Instant;

use serde_json::{Value, json};
use striata::file::{DecodeError, StriataFile};
use striata::mesh::RefinableMesh;
use striata_stream::{Effort, Precision, StreamDecoder, StreamDefect, StreamInfo};

use crate::args::EffortArg;
use crate::output::format_count;

/// What some bytes of a stream have told.
#[derive(Debug)]
pub struct DecodedStream {
    /// What the head says of the whole stream.
    pub facts: StreamInfo,
    /// The decoder after the last byte that was read.
    pub decoder: StreamDecoder,
    /// Bytes that were read, all that are there at most.
    pub read_bytes: usize,
    /// Whether the bytes end before the stream does, and all of them were read.
    pub is_cut: bool,
    /// Seconds in the decoder.
    pub decode_secs: f64,
}

impl DecodedStream {
    /// Reads chunk by chunk until there is no more or it is enough.
    ///
    /// # Errors
    /// Where the bytes are no sound stream, or end before its base mesh does.
    pub fn read(
        bytes: &[u8],
        mut is_enough: impl FnMut(&StreamDecoder) -> bool,
    ) -> Result<Self, DecodeError> {
        let found = bytes.len() as u64;
        let Some(facts) = StreamInfo::read(bytes)? else {
            return Err(DecodeError::FileLength { found, expected: found + 1 });
        };
        if found > facts.stream_bytes {
            return Err(DecodeError::FileLength { found, expected: facts.stream_bytes });
        }
        let mut decoder = StreamDecoder::new();
        let started = Instant::now();
        let mut read_bytes = end_within(bytes, Some(facts.base_bytes));
        decoder.push(&bytes[..read_bytes])?;
        while read_bytes < bytes.len() && !decoder.is_complete() && !is_enough(&decoder) {
            let end = end_within(bytes, decoder.bytes_for(decoder.split_count() + 1));
            let end = if end > read_bytes { end } else { bytes.len() };
            decoder.push(&bytes[read_bytes..end])?;
            read_bytes = end;
        }
        let is_cut = read_bytes == bytes.len() && !decoder.is_complete();
        if is_cut {
            decoder.finish()?;
        }
        let decode_secs = started.elapsed().as_secs_f64();
        Ok(Self { facts, decoder, read_bytes, is_cut, decode_secs })
    }

    /// All that is there.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_all(bytes: &[u8]) -> Result<Self, DecodeError> {
        Self::read(bytes, |_| false)
    }

    /// The mesh that came, with the sequence that leads to it.
    ///
    /// # Errors
    /// Where there is none, or its parts make no sense.
    pub fn refinable(&self) -> Result<RefinableMesh, DecodeError> {
        let refinable = self.decoder.refinable_mesh().ok_or(StreamDefect::NoBase)?;
        refinable.mesh.check()?;
        Ok(refinable)
    }

    /// What is to be said of a stream that is cut off.
    pub fn remark(&self, name: &str) -> Option<String> {
        let counts = [self.decoder.split_count(), self.facts.step_count];
        self.is_cut.then(|| cut_remark(name, [self.read_bytes as u64, self.facts.stream_bytes], counts))
    }
}

fn end_within(bytes: &[u8], end: Option<u64>) -> usize {
    let end = end.and_then(|end| usize::try_from(end).ok()).unwrap_or(usize::MAX);
    end.min(bytes.len())
}

fn cut_remark(name: &str, [read, whole]: [u64; 2], [split_count, step_count]: [usize; 2]) -> String {
    let [read, whole] = [read, whole].map(|bytes| format_count(usize::try_from(bytes).unwrap_or(usize::MAX)));
    let [split_count, step_count] = [format_count(split_count), format_count(step_count)];
    format!(
        "{name}: cut off after {read} of {whole} bytes: {split_count} of {step_count} vertex splits are there"
    )
}

/// What is to be said of a file whose mesh is a stream that is cut off, or that has one beside its mesh.
///
/// # Errors
/// Where what is there of the stream is unsound.
pub fn remark_on(file: &StriataFile<'_>, name: &str) -> Result<Option<String>, DecodeError> {
    let Some(stream) = file.stream().filter(|_| file.is_truncated()) else { return Ok(None) };
    let stream = stream?;
    if !file.is_stream_only() {
        return Ok(Some(format!("{name}: cut off within its stream; all else is there")));
    }
    let whole = StreamInfo::read(stream)?.map_or(0, |facts| facts.stream_bytes);
    let counts = [file.levels()?.step_count(), file.summary().step_count];
    Ok(Some(cut_remark(name, [stream.len() as u64, whole], counts)))
}

/// What the head of a stream says, for JSON.
pub fn facts_in_json(facts: &StreamInfo) -> Value {
    json!({
        "bytes": facts.stream_bytes,
        "head_bytes": facts.head_bytes,
        "base_bytes": facts.base_bytes,
        "chunk_count": facts.chunk_count,
        "version": facts.version.number(),
        "effort": effort_name(facts.effort),
        "is_lossless": facts.is_exact,
        "grid_bits": facts.grid_bits,
        "grid_step": facts.grid_step,
        "step_count": facts.step_count,
    })
}

/// An effort as the flag spells it.
pub fn effort_name(effort: Effort) -> &'static str {
    match effort {
        Effort::Fast => "fast",
        Effort::Small => "small",
        _ => "default",
    }
}

/// How exact a stream is, for people.
pub fn precision_name(precision: Precision) -> String {
    match precision {
        Precision::Bits(bits) => format!("{bits} bits a coordinate"),
        Precision::Tolerance(tolerance) => format!("positions within {tolerance}"),
        _ => "lossless".to_owned(),
    }
}

impl From<EffortArg> for Effort {
    fn from(effort: EffortArg) -> Self {
        match effort {
            EffortArg::Fast => Self::Fast,
            EffortArg::Default => Self::Default,
            EffortArg::Small => Self::Small,
        }
    }
}
