//! Facts about streams for reports and messages.

use serde_json::{Value, json};
use striata::file::{DecodeError, StriataFile};
use striata_stream::{Effort, Precision, StreamInfo, StreamLevels};

use crate::args::EffortArg;
use crate::output::format_count;

/// Returns a message for the user if a stream is cut off.
pub fn cut_off_text(levels: &StreamLevels<'_>, name: &str) -> Option<String> {
    let (info, decoder) = (levels.info(), levels.decoder());
    let counts = [decoder.split_count(), info.step_count];
    let lost = if decoder.lacks_triangle_data() { ", and no data of faces" } else { "" };
    let text = || truncation_text(name, [levels.read_bytes() as u64, info.stream_bytes], counts) + lost;
    levels.is_cut_off().then(text)
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
        _ => "compact",
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
            EffortArg::Compact => Self::Compact,
        }
    }
}
