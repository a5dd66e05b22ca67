//! Decodes streams chunk by chunk, until they end or enough has been read.

use std::time::Instant;

use serde_json::{Value, json};
use striata::file::{DecodeError, StriataFile};
use striata::mesh::Steps;
use striata_stream::{Effort, Precision, StreamDecoder, StreamDefect, StreamInfo};

use crate::args::EffortArg;
use crate::output::format_count;

/// The decoded part of a stream.
#[derive(Debug)]
pub struct DecodedStream {
    /// Facts about the whole stream, from its header.
    pub facts: StreamInfo,
    /// The decoder after the last byte that was read.
    pub decoder: StreamDecoder,
    /// Number of bytes that were read.
    pub read_bytes: usize,
    /// Whether the stream is cut off, and everything before the cut was read.
    pub is_cut: bool,
    /// Time spent in the decoder, seconds.
    pub decode_secs: f64,
}

impl DecodedStream {
    /// Reads chunk by chunk until the bytes end or `is_enough` returns true.
    ///
    /// # Errors
    /// If the stream is malformed, or cut off within its base mesh.
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

    /// Reads as far as some levels need; to the end if triangles have data, which are there.
    ///
    /// # Errors
    /// Under the same conditions as [`read`](Self::read).
    pub fn read_levels(
        bytes: &[u8],
        has_levels: impl Fn(&StreamDecoder) -> bool,
    ) -> Result<Self, DecodeError> {
        Self::read(bytes, |decoder| has_levels(decoder) && !decoder.lacks_triangle_data())
    }

    /// Reads all bytes.
    ///
    /// # Errors
    /// Under the same conditions as [`read`](Self::read).
    pub fn read_all(bytes: &[u8]) -> Result<Self, DecodeError> {
        Self::read(bytes, |_| false)
    }

    /// Returns the finest decoded mesh, with the steps from the base mesh to it.
    ///
    /// # Errors
    /// If there is no base mesh, or the mesh is inconsistent.
    pub fn steps(&self) -> Result<Steps, DecodeError> {
        let steps = self.decoder.steps().ok_or(StreamDefect::NoBase)?;
        steps.mesh().check()?;
        Ok(steps)
    }

    /// Returns a message for the user if the stream is cut off.
    pub fn truncation_note(&self, name: &str) -> Option<String> {
        let counts = [self.decoder.split_count(), self.facts.step_count];
        let read = [self.read_bytes as u64, self.facts.stream_bytes];
        let lost = if self.decoder.lacks_triangle_data() { ", and no data of faces" } else { "" };
        self.is_cut.then(|| truncation_text(name, read, counts) + lost)
    }
}

fn end_within(bytes: &[u8], end: Option<u64>) -> usize {
    let end = end.and_then(|end| usize::try_from(end).ok()).unwrap_or(usize::MAX);
    end.min(bytes.len())
}

fn truncation_text(name: &str, [read, whole]: [u64; 2], [split_count, step_count]: [usize; 2]) -> String {
    let [read, whole] = [read, whole].map(|bytes| format_count(usize::try_from(bytes).unwrap_or(usize::MAX)));
    let [split_count, step_count] = [format_count(split_count), format_count(step_count)];
    format!(
        "{name}: cut off after {read} of {whole} bytes: it contains {split_count} of {step_count} vertex \
         splits"
    )
}

/// Returns a message for the user if the stream of a file is cut off, whether or not the file contains
/// anything else.
///
/// # Errors
/// If the part of the stream that is present is malformed.
pub fn truncation_note(file: &StriataFile<'_>, name: &str) -> Result<Option<String>, DecodeError> {
    let Some(stream) = file.stream().filter(|_| file.is_truncated()) else { return Ok(None) };
    let stream = stream?;
    if !file.is_stream_only() {
        return Ok(Some(format!("{name}: cut off within its stream; everything else is complete")));
    }
    let whole = StreamInfo::read(stream)?.map_or(0, |facts| facts.stream_bytes);
    let counts = [file.levels()?.step_count(), file.summary().step_count];
    Ok(Some(truncation_text(name, [stream.len() as u64, whole], counts)))
}

/// Returns the facts from the header of a stream as JSON.
pub fn stream_facts_json(facts: &StreamInfo) -> Value {
    json!({
        "bytes": facts.stream_bytes,
        "head_bytes": facts.head_bytes,
        "base_bytes": facts.base_bytes,
        "chunk_count": facts.chunk_count,
        "effort": effort_name(facts.effort),
        "is_lossless": facts.is_exact,
        "grid_bits": facts.grid_bits,
        "grid_step": facts.grid_step,
        "step_count": facts.step_count,
        "has_collapses": !facts.has_fragments,
    })
}

/// Returns an effort as it is spelled on the command line.
pub fn effort_name(effort: Effort) -> &'static str {
    match effort {
        Effort::Fast => "fast",
        Effort::Small => "small",
        _ => "default",
    }
}

/// Describes the precision of a stream in words.
pub fn precision_name(precision: Precision) -> String {
    match precision {
        Precision::Bits(bits) => format!("{bits} bits per coordinate"),
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
