//! External sort of triangles by their keys.
//!
//! Runs that fit into memory are sorted there and written one after another; reading merges them. The
//! file takes 24 bytes per triangle. Memory is about 15 MB up to a billion triangles, and 4 kB more for
//! every 250,000 triangles beyond that.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::fs::File;
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};

/// Triangle to be sorted: its position along the curve, its index in the input file, and its corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct SortRecord {
    pub key: u64,
    pub index: u32,
    pub corners: [u32; 3],
}

const RECORD_BYTES: usize = 24;
/// Number of records in a run: 6 MiB.
const RUN_RECORDS: usize = 1 << 18;
/// Total size of the read buffers, in bytes, unless that makes them too small.
const BUFFER_BYTES: usize = 1 << 23;
const MIN_BUFFER_BYTES: usize = 170 * RECORD_BYTES;

impl SortRecord {
    fn to_bytes(self) -> [u8; RECORD_BYTES] {
        let mut bytes = [0; RECORD_BYTES];
        bytes[..8].copy_from_slice(&self.key.to_le_bytes());
        let [a, b, c] = self.corners;
        for (word, to) in [self.index, a, b, c].into_iter().zip(bytes[8..].chunks_exact_mut(4)) {
            to.copy_from_slice(&word.to_le_bytes());
        }
        bytes
    }

    fn from_bytes(bytes: &[u8; RECORD_BYTES]) -> Self {
        let word = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
        let key = u64::from(word(0)) | u64::from(word(4)) << 32;
        Self { key, index: word(8), corners: [word(12), word(16), word(20)] }
    }
}

/// Collects records in any order.
#[derive(Debug)]
pub(super) struct Sorter {
    run: Vec<SortRecord>,
    file: BufWriter<File>,
    /// End of each run, in records.
    ends: Vec<u64>,
}

impl Sorter {
    /// Creates a sorter that uses an empty file.
    pub(super) fn new(file: File) -> Self {
        Self { run: Vec::new(), file: BufWriter::with_capacity(1 << 16, file), ends: Vec::new() }
    }

    /// Adds a record.
    pub(super) fn push(&mut self, record: SortRecord) -> io::Result<()> {
        self.run.push(record);
        if self.run.len() == RUN_RECORDS { self.end_run() } else { Ok(()) }
    }

    fn end_run(&mut self) -> io::Result<()> {
        self.run.sort_unstable();
        for record in &self.run {
            self.file.write_all(&record.to_bytes())?;
        }
        self.ends.push(self.ends.last().unwrap_or(&0) + self.run.len() as u64);
        self.run.clear();
        Ok(())
    }

    /// Sorts the records and returns a reader of them in ascending order.
    pub(super) fn merged(mut self) -> io::Result<SortedRecords> {
        self.end_run()?;
        self.run = Vec::new();
        let file = self.file.into_inner().map_err(io::IntoInnerError::into_error)?;
        let buffer_bytes = (BUFFER_BYTES / self.ends.len()).max(MIN_BUFFER_BYTES);
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        let runs =
            starts.zip(&self.ends).map(|(next, &end)| SortedRun { next, end, buffer: Vec::new(), at: 0 });
        let mut merged = SortedRecords {
            file,
            runs: runs.collect(),
            heads: BinaryHeap::new(),
            buffer_records: buffer_bytes / RECORD_BYTES,
        };
        for run in 0..merged.runs.len() {
            merged.push_head(run)?;
        }
        Ok(merged)
    }
}

/// Reads the sorted records back, in ascending order of key and index.
#[derive(Debug)]
pub(super) struct SortedRecords {
    file: File,
    runs: Vec<SortedRun>,
    heads: BinaryHeap<Reverse<(SortRecord, usize)>>,
    buffer_records: usize,
}

/// Rest of a run: records in memory from `at` on, and in the file from `next` to `end`.
#[derive(Debug)]
struct SortedRun {
    next: u64,
    end: u64,
    buffer: Vec<u8>,
    at: usize,
}

impl SortedRecords {
    /// Returns the next record, or [`None`] after the last.
    pub(super) fn next(&mut self) -> io::Result<Option<SortRecord>> {
        let Some(Reverse((record, run))) = self.heads.pop() else { return Ok(None) };
        self.push_head(run)?;
        Ok(Some(record))
    }

    /// Moves the next record of a run to the heap, and refills the run's buffer if it is empty.
    fn push_head(&mut self, index: usize) -> io::Result<()> {
        let run = &mut self.runs[index];
        if run.at == run.buffer.len() {
            let count = (run.end - run.next).min(self.buffer_records as u64);
            run.buffer.resize(count as usize * RECORD_BYTES, 0);
            self.file.seek(SeekFrom::Start(run.next * RECORD_BYTES as u64))?;
            self.file.read_exact(&mut run.buffer)?;
            (run.next, run.at) = (run.next + count, 0);
        }
        if let Some(bytes) = run.buffer[run.at..].first_chunk() {
            self.heads.push(Reverse((SortRecord::from_bytes(bytes), index)));
            run.at += RECORD_BYTES;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_runs_come_out_in_order() {
        let mut sorter = Sorter::new(tempfile::tempfile().unwrap());
        let count = 2 * RUN_RECORDS as u32 + 1000;
        let record = |index: u32| SortRecord {
            key: u64::from(index.wrapping_mul(0x9E37_79B9) >> 8),
            index,
            corners: [index, index + 1, index ^ 1],
        };
        (0..count).for_each(|index| sorter.push(record(index)).unwrap());
        let mut merged = sorter.merged().unwrap();
        let (mut last, mut found) = (None, 0);
        while let Some(next) = merged.next().unwrap() {
            assert!(last < Some((next.key, next.index)));
            assert_eq!(next, record(next.index));
            last = Some((next.key, next.index));
            found += 1;
        }
        assert_eq!(found, count);
    }

    #[test]
    fn an_empty_input_is_sorted() {
        assert_eq!(Sorter::new(tempfile::tempfile().unwrap()).merged().unwrap().next().unwrap(), None);
    }
}
