//! A stream as a source of levels, which is decoded no farther than they need.

use striata::file::{DecodeError, metadata_has_guaranteed_errors};
use striata::levels::{FoundLevel, Levels, LevelsFacts, fan_level};
use striata::mesh::{Bounds, IndexedMesh, Steps, steps_for_detail};
use striata::model::Fans;
use striata::simplify::{StopReason, Target};
use striata::view::ScreenError;

use crate::format::error::StreamDefect;
use crate::format::info::StreamInfo;
use crate::reader::decode::StreamDecoder;

/// A whole stream, or its beginning, as a source of levels.
///
/// Levels are those of the whole stream: a target that lies beyond the end of the bytes gives the finest level that they
/// contain, with [`StopReason::InputEnded`]. Data of triangles are at the end of a stream, so it is decoded to there if
/// it has some.
#[derive(Clone, Debug)]
pub struct StreamLevels<'s> {
    bytes: &'s [u8],
    info: StreamInfo,
    decoder: StreamDecoder,
    read_bytes: usize,
    /// Whether the decoder has got all that it can get out of a stream that is cut off.
    is_finished: bool,
    /// The decoded mesh with its steps; [`None`] after more has been decoded.
    steps: Option<Steps>,
    has_guaranteed_errors: bool,
}

impl<'s> StreamLevels<'s> {
    /// Reads the header, and decodes the base mesh.
    ///
    /// # Errors
    /// [`DecodeError`] if the stream is malformed, cut off within its base mesh, or followed by other bytes.
    pub fn new(bytes: &'s [u8]) -> Result<Self, DecodeError> {
        let (info, found) = (StreamInfo::with_base(bytes)?, bytes.len() as u64);
        if found > info.stream_bytes {
            return Err(DecodeError::FileLength { found, expected: info.stream_bytes });
        }
        let mut decoder = StreamDecoder::new();
        let read_bytes = end_within(bytes, Some(info.base_bytes));
        decoder.push(&bytes[..read_bytes])?;
        let has_guaranteed_errors = metadata_has_guaranteed_errors(&info.metadata);
        Ok(Self { bytes, info, decoder, read_bytes, is_finished: false, steps: None, has_guaranteed_errors })
    }

    /// Decodes all that there is of a stream.
    ///
    /// # Errors
    /// See [`new`](Self::new).
    pub fn decoded(bytes: &'s [u8]) -> Result<Self, DecodeError> {
        let mut levels = Self::new(bytes)?;
        levels.decode_all()?;
        Ok(levels)
    }

    /// Sets whether errors are guaranteed, if the metadata of a file say it instead of those of the stream.
    #[must_use]
    pub fn with_guaranteed_errors(self, has_guaranteed_errors: bool) -> Self {
        Self { has_guaranteed_errors, ..self }
    }

    /// Facts about the whole stream, from its header.
    pub fn info(&self) -> &StreamInfo {
        &self.info
    }

    /// The decoder after the last byte that was read.
    pub fn decoder(&self) -> &StreamDecoder {
        &self.decoder
    }

    /// Number of bytes that have been read.
    pub fn read_bytes(&self) -> usize {
        self.read_bytes
    }

    /// Whether the stream is cut off, and everything before the cut has been read.
    pub fn is_cut_off(&self) -> bool {
        self.read_bytes == self.bytes.len() && !self.decoder.is_complete()
    }

    /// Decodes chunk by chunk until the bytes end or `is_enough` returns true.
    ///
    /// # Errors
    /// [`DecodeError`] if the stream is malformed, or cut off within its base mesh.
    pub fn decode_until(
        &mut self,
        mut is_enough: impl FnMut(&StreamDecoder) -> bool,
    ) -> Result<(), DecodeError> {
        while self.read_bytes < self.bytes.len() && !self.decoder.is_complete() && !is_enough(&self.decoder) {
            let end = end_within(self.bytes, self.decoder.bytes_for(self.decoder.split_count() + 1));
            let end = if end > self.read_bytes { end } else { self.bytes.len() };
            self.decoder.push(&self.bytes[self.read_bytes..end])?;
            (self.read_bytes, self.steps) = (end, None);
        }
        if self.is_cut_off() && !self.is_finished {
            self.decoder.finish()?;
            (self.is_finished, self.steps) = (true, None);
        }
        Ok(())
    }

    /// Decodes everything.
    ///
    /// # Errors
    /// See [`decode_until`](Self::decode_until).
    pub fn decode_all(&mut self) -> Result<(), DecodeError> {
        self.decode_until(|_| false)
    }

    /// Returns the finest mesh that has been decoded, with its steps.
    ///
    /// # Errors
    /// [`DecodeError`] if the mesh is inconsistent.
    pub fn steps(&mut self) -> Result<&Steps, DecodeError> {
        let steps = match self.steps.take() {
            Some(steps) => steps,
            None => {
                let steps = self.decoder.steps().ok_or(StreamDefect::NoBase)?;
                steps.mesh().check()?;
                steps
            }
        };
        Ok(self.steps.insert(steps))
    }

    /// Takes the finest mesh that has been decoded, with its steps.
    ///
    /// # Errors
    /// See [`steps`](Self::steps).
    pub fn into_steps(mut self) -> Result<Steps, DecodeError> {
        self.steps()?;
        Ok(self.steps.expect("steps that have just been made"))
    }

    /// Expresses a share of the steps by their number in the whole stream, whatever has been received.
    fn in_whole_stream(&self, target: Target) -> Target {
        match target {
            Target::Detail(detail @ 0.0..=1.0) => {
                Target::SplitCount(steps_for_detail(detail, self.info.step_count))
            }
            target => target,
        }
    }

    /// Returns the number of steps of the level closest to the target, and why it is no closer.
    fn resolved(&mut self, target: Target) -> Result<(usize, StopReason), DecodeError> {
        let is_whole = self.decoder.is_complete();
        let remaining = self.decoder.error().unwrap_or_default();
        let levels = self.steps()?.levels();
        if let (false, Target::Error(error)) = (is_whole, target)
            && f64::from(remaining) > error
        {
            // The table takes the finest received mesh for the full mesh, with an error of 0.
            return Ok((levels.step_count(), StopReason::InputEnded));
        }
        Ok(match target.resolve_in(levels) {
            (split_count, StopReason::FullMesh) if !is_whole => (split_count, StopReason::InputEnded),
            resolved => resolved,
        })
    }
}

/// Whether the decoder has reached the target or a finer level.
fn has_level(decoder: &StreamDecoder, target: Target) -> bool {
    match target {
        Target::Triangles(count) => decoder.triangle_count() > count,
        Target::Vertices(count) => decoder.positions().len() > count,
        Target::SplitCount(count) => decoder.split_count() >= count,
        Target::Error(error) => decoder.error().is_some_and(|e| f64::from(e) <= error),
        // Below the base.
        Target::Detail(detail) => detail < 0.0,
        _ => false,
    }
}

fn end_within(bytes: &[u8], end: Option<u64>) -> usize {
    let end = end.and_then(|end| usize::try_from(end).ok()).unwrap_or(usize::MAX);
    end.min(bytes.len())
}

impl Levels for StreamLevels<'_> {
    type Shape = IndexedMesh;
    type Error = DecodeError;

    fn facts(&self) -> LevelsFacts {
        LevelsFacts {
            vertex_count: self.info.vertex_count,
            triangle_count: self.info.triangle_count,
            step_count: self.info.step_count,
            has_guaranteed_errors: self.has_guaranteed_errors,
            origin: self.info.origin,
        }
    }

    /// Decodes a copy of the stream, so that levels need no more of it than before.
    fn bounds(&mut self) -> Result<Option<Bounds>, DecodeError> {
        let mut all = self.clone();
        all.decode_all()?;
        Ok(Bounds::of(all.decoder.positions()))
    }

    fn prepare(&mut self, targets: &[Target]) -> Result<(), DecodeError> {
        let targets: Vec<Target> = targets.iter().map(|&target| self.in_whole_stream(target)).collect();
        let are_there = |decoder: &StreamDecoder| targets.iter().all(|&target| has_level(decoder, target));
        self.decode_until(|decoder| are_there(decoder) && !decoder.lacks_triangle_data())
    }

    fn find(&mut self, target: Target) -> Result<FoundLevel<IndexedMesh>, DecodeError> {
        self.prepare(&[target])?;
        let (split_count, stop_reason) = self.resolved(self.in_whole_stream(target))?;
        let error = self.decoder.error_at(split_count).unwrap_or_default();
        let is_full = self.decoder.is_complete() && split_count == self.info.step_count;
        let steps = self.steps()?;
        let mesh = match is_full {
            // All that was encoded.
            true => steps.mesh().clone(),
            false => steps.level(split_count).without_unused_vertices(),
        };
        Ok(FoundLevel::of_mesh(mesh, split_count, error, stop_reason))
    }

    fn find_for_view(
        &mut self,
        criterion: &ScreenError,
        triangle_limit: Option<usize>,
    ) -> Result<FoundLevel<IndexedMesh>, DecodeError> {
        self.decode_all()?;
        let remaining = self.decoder.error().map(f64::from);
        let steps = self.steps()?;
        let level = fan_level(&Fans::build(steps), steps, criterion, triangle_limit);
        Ok(FoundLevel { error: level.error.into_iter().chain(remaining).reduce(f64::max), ..level })
    }
}
