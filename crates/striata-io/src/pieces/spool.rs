//! Temporary files that are written once and then mapped into memory.

use std::fs::File;
use std::io::{self, BufWriter, Seek as _, SeekFrom, Write as _};

use striata::mesh::origin_of;

use super::PieceOptions;
use super::scratch::{Mapped, scratch_error, scratch_file};
use crate::ReadError;

/// Temporary file under construction. The first failure is kept until the file is finished, so that parsers
/// only have their own errors.
pub(crate) struct Spool {
    out: BufWriter<File>,
    failure: Option<io::Error>,
}

impl Spool {
    pub(crate) fn new(options: &PieceOptions) -> Result<Self, ReadError> {
        let out = BufWriter::with_capacity(1 << 20, scratch_file(options)?);
        Ok(Self { out, failure: None })
    }

    /// Appends bytes.
    pub(crate) fn write(&mut self, bytes: &[u8]) {
        if self.failure.is_none() {
            self.failure = self.out.write_all(bytes).err();
        }
    }

    /// Replaces bytes that have been written.
    pub(crate) fn replace(&mut self, at: u64, bytes: &[u8]) {
        let out = &mut self.out;
        let done = out.seek(SeekFrom::Start(at)).and_then(|_| out.write_all(bytes));
        let done = done.and_then(|()| out.seek(SeekFrom::End(0)));
        if let Err(failure) = done {
            self.failure.get_or_insert(failure);
        }
    }

    /// Maps the file into memory.
    pub(crate) fn finish(self, options: &PieceOptions) -> Result<Mapped, ReadError> {
        Mapped::new(self.finish_file(options)?).map_err(|source| scratch_error(options, source))
    }

    /// Completes the file.
    pub(crate) fn finish_file(self, options: &PieceOptions) -> Result<File, ReadError> {
        let done = match self.failure {
            Some(failure) => Err(failure),
            None => self.out.into_inner().map_err(io::IntoInnerError::into_error),
        };
        done.map_err(|source| scratch_error(options, source))
    }
}

/// Chooses an origin from rows that begin with positions in single precision: it need not be exact, only near
/// them.
pub(super) fn origin_near(rows: &[u8], row_bytes: usize) -> [f64; 3] {
    let count = rows.len() / row_bytes.max(1);
    let sample = rows.chunks_exact(row_bytes.max(1)).step_by(count.div_ceil(1 << 16).max(1));
    let number = |bytes: &[u8]| f64::from(f32::from_ne_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]));
    let sample: Vec<[f64; 3]> = sample.map(|row| [0, 4, 8].map(|at| number(&row[at..]))).collect();
    origin_of(&sample)
}
