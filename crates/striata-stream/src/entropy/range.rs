//! The range coder: [`RangeWriter`] and [`RangeReader`].
//!
//! A message is a number in an interval that shrinks with each decision, in proportion to the probability
//! of the outcome \[Mar79\]. The interval is kept in 64 bits and shifted by 32 as soon as it fits, so both
//! sides touch bytes only once per 32 bits of message, and 16-bit probabilities lose nothing measurable to
//! rounding. Carries propagate back through the written bytes; they are rare and short.
//!
//! Termination costs at most a byte: the final number is chosen with as many trailing zero bytes as its
//! interval allows, and these are not written. A reader therefore has to know whether its bytes are
//! complete. If they are, zeros follow. If they are truncated, it reports an overrun at the first decision
//! that the missing bytes could change.

use super::coder::{Coder, PART_COUNT, Part, Shares};
use super::logistic::log2_q16;
use super::symbol::symbol_at;

/// The interval is shifted as soon as its width is below this.
const MIN_RANGE: u64 = 1 << 32;

/// Writes decisions to bytes.
#[derive(Clone, Debug)]
pub struct RangeWriter {
    bytes: Vec<u8>,
    low: u64,
    range: u64,
    part: Part,
    /// Message length at which the current part began, in 1/65536 bits.
    part_begin: u64,
    /// Number of bits spent on each part, in 1/65536 bits.
    spent_bits: [u64; PART_COUNT],
}

impl RangeWriter {
    /// Creates an empty message.
    pub fn new() -> Self {
        Self {
            bytes: Vec::new(),
            low: 0,
            range: u64::MAX,
            part: Part::Base,
            part_begin: 0,
            spent_bits: [0; PART_COUNT],
        }
    }

    /// Returns the bytes of the message without trailing zeros, and the number of bits spent on each
    /// [`Part`], in the order of their declaration.
    pub fn finish(mut self) -> (Vec<u8>, [f64; PART_COUNT]) {
        self.part(Part::Base);
        for kept_bits in (0..=64).step_by(8) {
            let free = u64::MAX.checked_shr(kept_bits).unwrap_or(0);
            let (padded, carry) = self.low.overflowing_add(free);
            let number = padded & !free;
            // After a carry, the difference wraps around to the value that it would have with a 65th bit.
            if number.wrapping_sub(self.low) < self.range {
                if carry {
                    self.carry();
                }
                self.bytes.extend_from_slice(&number.to_be_bytes());
                break;
            }
        }
        while self.bytes.last() == Some(&0) {
            self.bytes.pop();
        }
        (self.bytes, self.spent_bits.map(|spent_bits| spent_bits as f64 / 65536.0))
    }

    /// Returns the length of the message so far, in 1/65536 bits.
    fn length_q16(&self) -> u64 {
        let width = u64::from(log2_q16(self.range));
        ((self.bytes.len() as u64 * 8 + 64) << 16) - width
    }

    /// Adds one to the number formed by the bytes.
    fn carry(&mut self) {
        for byte in self.bytes.iter_mut().rev() {
            *byte = byte.wrapping_add(1);
            if *byte != 0 {
                return;
            }
        }
        debug_assert!(false, "a carry ran out of the message");
    }

    fn add_to_low(&mut self, by: u64) {
        let (low, carry) = self.low.overflowing_add(by);
        self.low = low;
        if carry {
            self.carry();
        }
    }

    fn renormalize(&mut self) {
        if self.range < MIN_RANGE {
            self.bytes.extend_from_slice(&((self.low >> 32) as u32).to_be_bytes());
            self.low <<= 32;
            self.range <<= 32;
        }
    }

    /// Narrows the interval to the share from `begin` to `end`, in units; `None` stands for the end of the
    /// interval.
    #[inline]
    fn narrow(&mut self, unit: u64, begin: u64, end: Option<u64>) {
        let low = unit * begin;
        let high = end.map_or(self.range, |end| unit * end);
        self.add_to_low(low);
        self.range = high - low;
        self.renormalize();
    }
}

impl Coder for RangeWriter {
    const READS: bool = false;

    #[inline]
    fn bit(&mut self, bit: bool, p_one: u32) -> bool {
        debug_assert!((1..65536).contains(&p_one), "probability {p_one} of 65536");
        let bound = (self.range >> 16) * u64::from(p_one);
        if bit {
            self.range = bound;
        } else {
            self.add_to_low(bound);
            self.range -= bound;
        }
        self.renormalize();
        bit
    }

    #[inline]
    fn raw(&mut self, value: u32, bits: u32) -> u32 {
        debug_assert!(bits <= 24, "{bits} raw bits at once");
        let value = value & ((1 << bits) - 1);
        self.range >>= bits;
        self.add_to_low(self.range * u64::from(value));
        self.renormalize();
        value
    }

    #[inline]
    fn symbol(&mut self, actual: usize, begins: &Shares) -> usize {
        let end = begins.get(actual + 1).map(|&end| end as u64);
        self.narrow(self.range >> 15, begins[actual] as u64, end);
        actual
    }

    fn overran(&self) -> bool {
        false
    }

    fn part(&mut self, part: Part) {
        let now = self.length_q16();
        self.spent_bits[self.part as usize] += now.saturating_sub(self.part_begin);
        self.part_begin = now;
        self.part = part;
    }
}

impl Default for RangeWriter {
    fn default() -> Self {
        Self::new()
    }
}

/// Reads decisions from bytes.
#[derive(Clone, Debug)]
pub struct RangeReader<'a> {
    /// Bytes not yet read.
    bytes: &'a [u8],
    /// Offset of the message from the lower end of the interval.
    value: u64,
    range: u64,
    /// How much larger `value` could be, depending on bytes that are missing.
    uncertainty: u64,
    is_complete: bool,
    overran: bool,
}

impl<'a> RangeReader<'a> {
    /// Reads a message returned by [`RangeWriter::finish`], or a prefix of it if `is_complete` is false.
    ///
    /// A complete message never overruns, since zeros follow it forever: the caller has to bound the number
    /// of decisions by other means.
    pub fn new(bytes: &'a [u8], is_complete: bool) -> Self {
        let mut reader =
            Self { bytes, value: 0, range: u64::MAX, uncertainty: 0, is_complete, overran: false };
        reader.read_word();
        reader.read_word();
        reader
    }

    #[inline]
    fn read_word(&mut self) {
        let word = if let Some((word, rest)) = self.bytes.split_first_chunk::<4>() {
            self.bytes = rest;
            u32::from_be_bytes(*word)
        } else {
            self.read_last_word()
        };
        self.value = self.value << 32 | u64::from(word);
    }

    #[cold]
    fn read_last_word(&mut self) -> u32 {
        let mut word = [0; 4];
        let count = self.bytes.len();
        word[..count].copy_from_slice(self.bytes);
        self.bytes = &[];
        if !self.is_complete {
            let missing = u32::MAX.checked_shr(count as u32 * 8).unwrap_or(0);
            self.uncertainty = if self.uncertainty >> 32 == 0 {
                self.uncertainty << 32 | u64::from(missing)
            } else {
                u64::MAX
            };
        }
        u32::from_be_bytes(word)
    }

    /// Notes an overrun if the missing bytes could change on which side of `bound` the message lies.
    #[cold]
    fn check_certainty(&mut self, bound: u64) {
        self.overran |= self.value < bound && self.value.saturating_add(self.uncertainty) >= bound;
    }

    #[inline]
    fn renormalize(&mut self) {
        if self.range < MIN_RANGE {
            self.range <<= 32;
            self.read_word();
        }
    }

    /// Narrows the interval to the share from `begin` to `end`, in units; `None` stands for the end of the
    /// interval.
    #[inline]
    fn narrow(&mut self, unit: u64, begin: u64, end: Option<u64>) {
        let low = unit * begin;
        let high = end.map_or(self.range, |end| unit * end);
        if self.uncertainty != 0 {
            self.check_certainty(high);
        }
        self.value = self.value.saturating_sub(low);
        self.range = high - low;
        self.renormalize();
    }
}

impl Coder for RangeReader<'_> {
    const READS: bool = true;

    #[inline]
    fn bit(&mut self, _: bool, p_one: u32) -> bool {
        debug_assert!((1..65536).contains(&p_one), "probability {p_one} of 65536");
        let bound = (self.range >> 16) * u64::from(p_one);
        if self.uncertainty != 0 {
            self.check_certainty(bound);
        }
        let bit = self.value < bound;
        if bit {
            self.range = bound;
        } else {
            self.value -= bound;
            self.range -= bound;
        }
        self.renormalize();
        bit
    }

    #[inline]
    fn raw(&mut self, _: u32, bits: u32) -> u32 {
        debug_assert!(bits <= 24, "{bits} raw bits at once");
        self.range >>= bits;
        // Rounding leaves a small remainder above the last number, which no writer uses.
        let value = (self.value / self.range).min((1 << bits) - 1);
        if self.uncertainty != 0 {
            self.check_certainty((value + 1) * self.range);
        }
        self.value = (self.value - value * self.range).min(self.range - 1);
        self.renormalize();
        value as u32
    }

    #[inline]
    fn symbol(&mut self, _: usize, begins: &Shares) -> usize {
        let unit = self.range >> 15;
        // The remainder that rounding leaves at the top belongs to the last symbol.
        let symbol = symbol_at(begins, (self.value / unit).min(32_767) as i16);
        let end = begins.get(symbol + 1).map(|&end| end as u64);
        self.narrow(unit, begins[symbol & 15] as u64, end);
        symbol
    }

    fn overran(&self) -> bool {
        self.overran
    }

    fn part(&mut self, _: Part) {}
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;

    /// Random decisions with their probabilities; every 16th entry is a group of raw bits.
    fn message(seed: u64, count: usize, is_extreme: bool) -> Vec<(u32, u32)> {
        let mut random = Random::new(seed);
        let mut decide = |p_one: u32| (u32::from(random.below(65536) < p_one), p_one);
        let mut chooser = Random::new(seed + 1);
        let extremes = [1, 2, 65534, 65535];
        (0..count)
            .map(|at| match at % 16 {
                15 => (chooser.below(1 << 24), 0),
                _ if is_extreme => decide(extremes[chooser.below(4) as usize]),
                _ => decide(1 + chooser.below(65535)),
            })
            .collect()
    }

    fn code(writer: &mut RangeWriter, message: &[(u32, u32)]) -> Vec<u32> {
        let code_one = |&(value, p_one): &(u32, u32)| match p_one {
            0 => writer.raw(value, value % 25),
            _ => u32::from(writer.bit(value != 0, p_one)),
        };
        message.iter().map(code_one).collect()
    }

    /// Reads what `code` wrote, up to the first overrun.
    fn read(reader: &mut RangeReader, message: &[(u32, u32)]) -> Vec<u32> {
        let mut values = Vec::new();
        for &(value, p_one) in message {
            values.push(match p_one {
                0 => reader.raw(0, value % 25),
                _ => u32::from(reader.bit(false, p_one)),
            });
            if reader.overran() {
                values.pop();
                return values;
            }
        }
        values
    }

    fn write(message: &[(u32, u32)]) -> (Vec<u8>, Vec<u32>) {
        let mut writer = RangeWriter::new();
        let values = code(&mut writer, message);
        (writer.finish().0, values)
    }

    #[test]
    fn messages_round_trip() {
        for seed in 0..40 {
            for is_extreme in [false, true] {
                let message = message(seed, 1 << (seed % 13), is_extreme);
                let (bytes, values) = write(&message);
                assert_eq!(read(&mut RangeReader::new(&bytes, true), &message), values, "seed {seed}");
            }
        }
    }

    #[test]
    fn unlikely_decisions_round_trip() {
        for p_one in [1, 65535] {
            let unlikely = u32::from(p_one == 1);
            let message: Vec<_> = (0..5000).map(|at| (unlikely ^ u32::from(at % 97 == 0), p_one)).collect();
            let (bytes, values) = write(&message);
            assert_eq!(read(&mut RangeReader::new(&bytes, true), &message), values);
        }
    }

    #[test]
    fn truncated_messages_are_read_up_to_the_last_certain_decision() {
        let message = message(5, 400, false);
        let (bytes, values) = write(&message);
        let mut last = 0;
        for length in 0..=bytes.len() {
            let decoded = read(&mut RangeReader::new(&bytes[..length], false), &message);
            assert_eq!(decoded, values[..decoded.len()], "{length} bytes");
            assert!(decoded.len() >= last, "more bytes, fewer decisions");
            last = decoded.len();
            // Whether a decision is certain depends on the missing bytes, so two different ends have to
            // change it.
            if decoded.len() < values.len() {
                let ends = [0u8, 255].map(|end| {
                    let mut other = bytes[..length].to_vec();
                    other.resize(bytes.len() + 8, end);
                    read(&mut RangeReader::new(&other, true), &message)[decoded.len()]
                });
                assert_ne!(ends[0], ends[1], "{length} bytes");
            }
        }
        assert!(last + 40 > values.len(), "only {last} of {} are certain at the end", values.len());
    }

    #[test]
    fn messages_are_hardly_longer_than_their_information() {
        let message = message(9, 200_000, false);
        let information = |&(value, p_one): &(u32, u32)| match p_one {
            0 => f64::from(value % 25),
            _ => -(f64::from(if value != 0 { p_one } else { 65536 - p_one }) / 65536.0).log2(),
        };
        let expected: f64 = message.iter().map(information).sum();
        let mut writer = RangeWriter::new();
        writer.part(Part::Positions);
        code(&mut writer, &message);
        let (bytes, spent_bits) = writer.finish();
        let bits = bytes.len() as f64 * 8.0;
        assert!(bits < expected * 1.0001 + 8.0, "{bits} bits for {expected}");
        assert!(
            (spent_bits[Part::Positions as usize] - expected).abs() < expected * 1e-4,
            "{spent_bits:?} for {expected}"
        );
    }

    #[test]
    fn empty_messages_are_empty_and_trailing_zeros_are_dropped() {
        assert!(write(&[]).0.is_empty());
        let likely: Vec<_> = (0..100).map(|_| (1, 65535)).collect();
        assert!(write(&likely).0.len() <= 1);
    }

    #[test]
    fn arbitrary_bytes_are_read_without_panicking() {
        let mut random = Random::new(3);
        for _ in 0..200 {
            let bytes: Vec<u8> = (0..random.below(40)).map(|_| (random.next_u64() | 0xE0) as u8).collect();
            let all = [vec![255; 60], bytes];
            for bytes in &all {
                for is_complete in [false, true] {
                    let mut reader = RangeReader::new(bytes, is_complete);
                    for at in 0..300 {
                        reader.bit(false, 1 + at * 200);
                        assert!(reader.raw(0, at % 25) < 1 << (at % 25));
                    }
                    assert_eq!(reader.overran(), !is_complete);
                }
            }
        }
    }

    #[test]
    fn encoded_bytes_are_stable() {
        let (bytes, _) = write(&message(1, 1000, false));
        assert_eq!((bytes.len(), crc32fast::hash(&bytes)), (184, 3_424_878_432));
    }
}
