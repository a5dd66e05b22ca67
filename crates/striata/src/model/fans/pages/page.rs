//! One page: what belongs to some of the steps.
//!
//! Layout, little endian: the page and the number of steps; for each step its number, the position of its first
//! vertex, and its bounds in eight bytes; for each vertex of these steps, the end of its entry; the number of far
//! targets, and pairs of a step and a far target; the entries, as in the table.

use bytemuck::{must_cast, pod_read_unaligned};

use super::FanDirectory;
use crate::model::ModelError;
use crate::model::fans::table::{Entry, FanView};
use crate::model::fans::validate::check_arcs;
use crate::model::part_record::PartRecord;
use crate::view::Part;

/// Padding after the entries, so that four bytes can be read wherever a number begins.
const PADDING: usize = 4;

/// Number of bytes of a step: its number, position and bounds.
const STEP_BYTES: usize = 4 + 12 + 8;

/// A page in memory.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Page {
    /// The steps, ascending.
    pub(super) steps: Vec<u32>,
    pub(super) centers: Vec<[f32; 3]>,
    pub(super) records: Vec<PartRecord>,
    /// The first of each step's vertices in `ends`.
    pub(super) firsts: Vec<u32>,
    /// End of the entry of each vertex in `entries`.
    pub(super) ends: Vec<u32>,
    /// Pairs of a step and a step outside its ring that it needs, ascending.
    pub(super) far: Vec<[u32; 2]>,
    /// Entries of all vertices, one after the other, and padding.
    pub(super) entries: Vec<u8>,
}

impl Page {
    /// Returns the index of a step of the page.
    #[inline]
    pub(super) fn slot(&self, step: u32) -> usize {
        self.steps.partition_point(|&other| other < step)
    }

    /// Returns the bounds of a step in a slot.
    pub(super) fn part(&self, slot: usize) -> Part {
        self.records[slot].part(self.centers[slot])
    }

    /// Returns the entry of the vertex `index` of the page.
    pub(super) fn entry(&self, index: usize, vertex: u32, own_step: u32, has_groups: bool) -> Entry<'_> {
        let start = index.checked_sub(1).map_or(0, |last| self.ends[last] as usize);
        let is_empty = start == self.ends[index] as usize;
        let bytes = if is_empty { &[][..] } else { &self.entries[start..] };
        Entry::new(bytes, vertex, own_step, has_groups)
    }

    /// Appends the entry of the next vertex.
    pub(super) fn push_entry(&mut self, bytes: &[u8]) {
        self.entries.extend_from_slice(bytes);
        self.ends.push(self.entries.len() as u32);
    }

    /// Adds padding after the last entry.
    pub(super) fn close(&mut self) {
        self.entries.extend_from_slice(&[0; PADDING]);
    }

    /// Number of bytes in memory.
    pub(super) fn bytes(&self) -> usize {
        4 * (self.steps.len() + self.firsts.len() + self.ends.len())
            + size_of_val(&self.centers[..])
            + size_of_val(&self.records[..])
            + size_of_val(&self.far[..])
            + self.entries.len()
    }

    /// Encodes the page.
    pub(super) fn to_bytes(&self, index: u32) -> Vec<u8> {
        let mut out = Vec::with_capacity(self.bytes());
        let mut write = |number: u32| out.extend_from_slice(&number.to_le_bytes());
        write(index);
        write(self.steps.len() as u32);
        for (slot, &step) in self.steps.iter().enumerate() {
            write(step);
            self.centers[slot].iter().for_each(|x| write(x.to_bits()));
            let record: [[u8; 4]; 2] = must_cast(self.records[slot]);
            record.iter().for_each(|&half| write(u32::from_le_bytes(half)));
        }
        self.ends.iter().for_each(|&end| write(end));
        write(self.far.len() as u32);
        self.far.iter().flatten().for_each(|&step| write(step));
        out.extend_from_slice(&self.entries[..self.entries.len() - PADDING]);
        out
    }

    /// Decodes and checks a page; returns it with its index.
    ///
    /// # Errors
    /// [`ModelError`] if the bytes are not a page of this directory's table.
    pub(super) fn from_bytes(bytes: &[u8], directory: &FanDirectory) -> Result<(u32, Self), ModelError> {
        let mut reader = Reader { bytes };
        let [index, count] = [reader.number("page")?, reader.number("steps of the page")?];
        let expected = directory.step_count_of(index);
        if expected != Some(count) {
            let (what, expected) = ("steps of the page", expected.unwrap_or(0) as usize);
            return Err(ModelError::Length { what, found: count as usize, expected });
        }
        let mut page = Self::default();
        for step in reader.take("steps of the page", count as usize, STEP_BYTES)?.chunks_exact(STEP_BYTES) {
            let mut reader = Reader { bytes: step };
            page.steps.push(reader.number("step")?);
            page.centers.push([(); 3].map(|()| f32::from_bits(reader.number("center").unwrap_or(0))));
            page.records.push(pod_read_unaligned(reader.bytes));
        }
        page.check_steps(index, directory)?;
        let vertex_count = page.steps.iter().map(|&step| directory.vertices.of_step(step as usize).len());
        let vertex_count = vertex_count.sum();
        page.ends = reader.numbers("ends of entries", vertex_count)?;
        let far_count = reader.number("far targets")? as usize;
        page.far = reader.numbers("far targets", far_count.saturating_mul(2))?.as_chunks().0.to_vec();
        page.entries = reader.bytes.to_vec();
        page.close();
        page.locate(directory);
        page.check(directory)?;
        Ok((index, page))
    }

    /// Finds the first vertex of each step.
    pub(super) fn locate(&mut self, directory: &FanDirectory) {
        let mut first = 0;
        let of_step = self.steps.iter().map(|&step| {
            let here = first;
            first += directory.vertices.of_step(step as usize).len() as u32;
            here
        });
        self.firsts = of_step.collect();
    }

    fn check_steps(&self, index: u32, directory: &FanDirectory) -> Result<(), ModelError> {
        let mut last = None;
        for (&step, record) in self.steps.iter().zip(&self.records) {
            let wrong = |reason| Err(ModelError::Step { step: step as usize, reason });
            if directory.page_of.get(step as usize) != Some(&index) {
                return wrong("is not in the page that has it");
            }
            if last.replace(step).is_some_and(|last| last >= step) {
                return wrong("is out of order in its page");
            }
            record.check_shape().or_else(wrong)?;
        }
        Ok(())
    }

    fn check(&self, directory: &FanDirectory) -> Result<(), ModelError> {
        let mut last = 0;
        for (place, &end) in self.ends.iter().enumerate() {
            if end < last || end as usize > self.entries.len() - PADDING {
                return Err(ModelError::Listed { what: "end of entry", place, reason: "is out of order" });
            }
            last = end;
        }
        if last as usize + PADDING != self.entries.len() {
            let (found, expected) = (self.entries.len() - PADDING, last as usize);
            return Err(ModelError::Length { what: "bytes of entries", found, expected });
        }
        for (place, &[step, target]) in self.far.iter().enumerate() {
            if target >= step || self.steps.binary_search(&step).is_err() {
                return Err(ModelError::Listed {
                    what: "far target",
                    place,
                    reason: "is not a coarser step",
                });
            }
        }
        for (slot, &step) in self.steps.iter().enumerate() {
            for (index, vertex) in
                (self.firsts[slot] as usize..).zip(directory.vertices.of_step(step as usize))
            {
                let found = self.check_entry(index, vertex, step + 1, directory);
                found.map_err(|reason| ModelError::Entry { vertex: vertex as usize, reason })?;
            }
        }
        Ok(())
    }

    fn check_entry(
        &self,
        index: usize,
        vertex: u32,
        own_step: u32,
        directory: &FanDirectory,
    ) -> Result<(), &'static str> {
        let entry_end = self.ends[index] as usize;
        let mut end = index.checked_sub(1).map_or(0, |last| self.ends[last] as usize);
        for fan in self.entry(index, vertex, own_step, directory.group_count > 1) {
            match fan.bytes_after().map(|after| self.entries.len() - after) {
                Some(fan_end) if fan_end <= entry_end => end = fan_end,
                _ => return Err("reaches into the next one"),
            }
            check_fan(&fan, directory)?;
        }
        if end == entry_end { Ok(()) } else { Err("ends before the next one begins") }
    }
}

/// Checks that a fan names vertices, steps and groups that exist.
fn check_fan(fan: &FanView<'_>, directory: &FanDirectory) -> Result<(), &'static str> {
    if fan.group as usize >= directory.group_count {
        return Err("is in a group that does not exist");
    }
    if fan.distances().any(|distance| distance == 0 || distance > fan.vertex) {
        return Err("has a node that is not older than its vertex");
    }
    check_arcs(fan)?;
    let arcs = u32::MAX >> (32 - fan.arc_count());
    let is_later = |[number, mask]: [u32; 2]| {
        let step = u64::from(number >> 1) + u64::from(fan.own_step);
        number >= 2 && step <= directory.page_of.len() as u64 && mask & !arcs == 0
    };
    if fan.permanent & !arcs == 0 && fan.pairs().all(is_later) {
        Ok(())
    } else {
        Err("has a triangle created by a step that is not later or does not exist")
    }
}

/// Reads numbers.
struct Reader<'b> {
    bytes: &'b [u8],
}

impl<'b> Reader<'b> {
    fn take(&mut self, what: &'static str, count: usize, size: usize) -> Result<&'b [u8], ModelError> {
        let found = self.bytes.len() / size;
        if found < count {
            return Err(ModelError::Length { what, found, expected: count });
        }
        let (taken, rest) = self.bytes.split_at(count * size);
        self.bytes = rest;
        Ok(taken)
    }

    fn number(&mut self, what: &'static str) -> Result<u32, ModelError> {
        Ok(u32::from_le_bytes(pod_read_unaligned(self.take(what, 1, 4)?)))
    }

    fn numbers(&mut self, what: &'static str, count: usize) -> Result<Vec<u32>, ModelError> {
        let words = self.take(what, count, 4)?.as_chunks().0;
        Ok(words.iter().map(|&word| u32::from_le_bytes(word)).collect())
    }
}
