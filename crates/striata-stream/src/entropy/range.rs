//! The binary range coder.
//!
//! A message is a number in an interval that shrinks with each decision, by the probability of what was decided
//! \[Mar79\]. The interval is kept in 64 bits and moved on by 32 as soon as it fits, so both sides touch bytes once
//! in 32 bits of message, and 16-bit probabilities lose nothing to rounding. Carries run back through the bytes
//! written: there are few, and short ones.
//!
//! The end costs at most a byte over the message: the number is chosen with as many zero bytes at its end as its
//! interval allows, and these are not written. So a reader must be told whether its bytes are all there are. Where they
//! are, zeros follow; where they are cut off, it says so at the first decision that the missing bytes might have turned.

use super::coder::{Coder, PART_COUNT, Part, QuickShares, Shares};
use super::logistic::log2_q16;
use super::quick_symbol::symbol_at;

/// Below this width the interval moves on.
const NARROW: u64 = 1 << 32;

/// Writes decisions to bytes.
#[derive(Clone, Debug)]
pub(crate) struct RangeWriter {
    bytes: Vec<u8>,
    low: u64,
    range: u64,
    part: Part,
    /// Where the part began, in 1/65536 bits.
    part_began: u64,
    /// What each part took, in 1/65536 bits.
    spent: [u64; PART_COUNT],
}

impl RangeWriter {
    /// An empty message.
    pub(crate) fn new() -> Self {
        Self {
            bytes: Vec::new(),
            low: 0,
            range: u64::MAX,
            part: Part::Base,
            part_began: 0,
            spent: [0; PART_COUNT],
        }
    }

    /// The bytes of the message without the zeros at its end, and how many bits each [`Part`] took, in the order
    /// of their declaration.
    pub(crate) fn finish(mut self) -> (Vec<u8>, [f64; PART_COUNT]) {
        self.part(Part::Base);
        for kept_bits in (0..=64).step_by(8) {
            let free = u64::MAX.checked_shr(kept_bits).unwrap_or(0);
            let (padded, carry) = self.low.overflowing_add(free);
            let number = padded & !free;
            // Behind a carry the difference wraps to what it would be with a 65th bit.
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
        (self.bytes, self.spent.map(|spent| spent as f64 / 65536.0))
    }

    /// How long the message is, in bits, to 1/65536.
    fn position(&self) -> u64 {
        let width = u64::from(log2_q16(self.range));
        ((self.bytes.len() as u64 * 8 + 64) << 16) - width
    }

    /// Adds one to the number that the bytes are.
    fn carry(&mut self) {
        for byte in self.bytes.iter_mut().rev() {
            *byte = byte.wrapping_add(1);
            if *byte != 0 {
                return;
            }
        }
        debug_assert!(false, "a carry ran out of the message");
    }

    fn raise(&mut self, by: u64) {
        let (low, carry) = self.low.overflowing_add(by);
        self.low = low;
        if carry {
            self.carry();
        }
    }

    fn move_on(&mut self) {
        if self.range < NARROW {
            self.bytes.extend_from_slice(&((self.low >> 32) as u32).to_be_bytes());
            self.low <<= 32;
            self.range <<= 32;
        }
    }

    /// Goes on with a share of the interval: from where to where it reaches, in units; no end means that of the interval.
    #[inline]
    fn narrow(&mut self, unit: u64, (begin, end): (u64, Option<u64>)) {
        let low = unit * begin;
        let high = end.map_or(self.range, |end| unit * end);
        self.raise(low);
        self.range = high - low;
        self.move_on();
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
            self.raise(bound);
            self.range -= bound;
        }
        self.move_on();
        bit
    }

    #[inline]
    fn raw(&mut self, value: u32, bits: u32) -> u32 {
        debug_assert!(bits <= 24, "{bits} raw bits at once");
        let value = value & ((1 << bits) - 1);
        self.range >>= bits;
        self.raise(self.range * u64::from(value));
        self.move_on();
        value
    }

    #[inline]
    fn symbol(&mut self, meant: usize, begins: &Shares) -> usize {
        let end = begins.get(meant + 1).map(|&end| end as u64);
        self.narrow(self.range >> 16, (begins[meant] as u64, end));
        meant
    }

    #[inline]
    fn quick_symbol(&mut self, meant: usize, begins: &QuickShares) -> usize {
        let end = begins.get(meant + 1).map(|&end| end as u64);
        self.narrow(self.range >> 15, (begins[meant] as u64, end));
        meant
    }

    fn overran(&self) -> bool {
        false
    }

    fn part(&mut self, part: Part) {
        let now = self.position();
        self.spent[self.part as usize] += now.saturating_sub(self.part_began);
        self.part_began = now;
        self.part = part;
    }
}

/// Reads decisions from bytes.
#[derive(Clone, Debug)]
pub(crate) struct RangeReader<'a> {
    /// What was not taken in yet.
    bytes: &'a [u8],
    /// Where the message lies in the interval.
    value: u64,
    range: u64,
    /// How much higher `value` might be by bytes that are not there.
    doubt: u64,
    is_complete: bool,
    overran: bool,
}

impl<'a> RangeReader<'a> {
    /// Reads what [`RangeWriter::finish`] returned, or with `is_complete` false the first bytes of it.
    ///
    /// A complete message never overruns: zeros follow it for as long as decisions are asked for, so a caller bounds
    /// how many it asks for by something else.
    pub(crate) fn new(bytes: &'a [u8], is_complete: bool) -> Self {
        let mut reader = Self { bytes, value: 0, range: u64::MAX, doubt: 0, is_complete, overran: false };
        reader.take_word();
        reader.take_word();
        reader
    }

    #[inline]
    fn take_word(&mut self) {
        let word = if let Some((word, rest)) = self.bytes.split_first_chunk::<4>() {
            self.bytes = rest;
            u32::from_be_bytes(*word)
        } else {
            self.take_last()
        };
        self.value = self.value << 32 | u64::from(word);
    }

    #[cold]
    fn take_last(&mut self) -> u32 {
        let mut word = [0; 4];
        let count = self.bytes.len();
        word[..count].copy_from_slice(self.bytes);
        self.bytes = &[];
        if !self.is_complete {
            let missing = u32::MAX.checked_shr(count as u32 * 8).unwrap_or(0);
            self.doubt = if self.doubt >> 32 == 0 { self.doubt << 32 | u64::from(missing) } else { u64::MAX };
        }
        u32::from_be_bytes(word)
    }

    /// Whether the bytes that are not there leave it open on which side of `bound` the message lies.
    #[cold]
    fn look_out(&mut self, bound: u64) {
        self.overran |= self.value < bound && self.value.saturating_add(self.doubt) >= bound;
    }

    #[inline]
    fn move_on(&mut self) {
        if self.range < NARROW {
            self.range <<= 32;
            self.take_word();
        }
    }

    /// Goes on with a share of the interval: from where to where it reaches, in units; no end means that of the interval.
    #[inline]
    fn narrow(&mut self, unit: u64, (begin, end): (u64, Option<u64>)) {
        let low = unit * begin;
        let high = end.map_or(self.range, |end| unit * end);
        if self.doubt != 0 {
            self.look_out(high);
        }
        self.value = self.value.saturating_sub(low);
        self.range = high - low;
        self.move_on();
    }
}

impl Coder for RangeReader<'_> {
    const READS: bool = true;

    #[inline]
    fn bit(&mut self, _: bool, p_one: u32) -> bool {
        debug_assert!((1..65536).contains(&p_one), "probability {p_one} of 65536");
        let bound = (self.range >> 16) * u64::from(p_one);
        if self.doubt != 0 {
            self.look_out(bound);
        }
        let bit = self.value < bound;
        if bit {
            self.range = bound;
        } else {
            self.value -= bound;
            self.range -= bound;
        }
        self.move_on();
        bit
    }

    #[inline]
    fn raw(&mut self, _: u32, bits: u32) -> u32 {
        debug_assert!(bits <= 24, "{bits} raw bits at once");
        self.range >>= bits;
        // Rounding leaves a little above the last number: only bytes that no writer wrote lie there.
        let value = (self.value / self.range).min((1 << bits) - 1);
        if self.doubt != 0 {
            self.look_out((value + 1) * self.range);
        }
        self.value = (self.value - value * self.range).min(self.range - 1);
        self.move_on();
        value as u32
    }

    #[inline]
    fn symbol(&mut self, _: usize, begins: &Shares) -> usize {
        let unit = self.range >> 16;
        // What rounding leaves above belongs to the last symbol.
        let place = (self.value / unit).min(65_535) as i32;
        let above = begins.iter().map(|&begin| i32::from(begin <= place)).sum::<i32>() as usize;
        let symbol = above.saturating_sub(1);
        let end = begins.get(symbol + 1).map(|&end| end as u64);
        self.narrow(unit, (begins[symbol] as u64, end));
        symbol
    }

    #[inline]
    fn quick_symbol(&mut self, _: usize, begins: &QuickShares) -> usize {
        let unit = self.range >> 15;
        // What rounding leaves above belongs to the last symbol.
        let symbol = symbol_at(begins, (self.value / unit).min(32_767) as i16);
        let end = begins.get(symbol + 1).map(|&end| end as u64);
        self.narrow(unit, (begins[symbol & 15] as u64, end));
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

    /// Decisions with their probabilities, every 16th of them raw bits.
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

    /// Reads what `code` wrote; stops at an overrun.
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
    fn what_was_written_is_read() {
        for seed in 0..40 {
            for is_extreme in [false, true] {
                let message = message(seed, 1 << (seed % 13), is_extreme);
                let (bytes, values) = write(&message);
                assert_eq!(read(&mut RangeReader::new(&bytes, true), &message), values, "seed {seed}");
            }
        }
    }

    #[test]
    fn decisions_against_all_odds_are_read() {
        for p_one in [1, 65535] {
            let unlikely = u32::from(p_one == 1);
            let message: Vec<_> = (0..5000).map(|at| (unlikely ^ u32::from(at % 97 == 0), p_one)).collect();
            let (bytes, values) = write(&message);
            assert_eq!(read(&mut RangeReader::new(&bytes, true), &message), values);
        }
    }

    #[test]
    fn a_cut_message_is_read_to_where_it_is_certain() {
        let message = message(5, 400, false);
        let (bytes, values) = write(&message);
        let mut last = 0;
        for length in 0..=bytes.len() {
            let certain = read(&mut RangeReader::new(&bytes[..length], false), &message);
            assert_eq!(certain, values[..certain.len()], "{length} bytes");
            assert!(certain.len() >= last, "more bytes, fewer decisions");
            last = certain.len();
            // What is called uncertain depends on the bytes that are missing: some other end changes it.
            if certain.len() < values.len() {
                let ends = [0u8, 255].map(|end| {
                    let mut other = bytes[..length].to_vec();
                    other.resize(bytes.len() + 8, end);
                    read(&mut RangeReader::new(&other, true), &message)[certain.len()]
                });
                assert_ne!(ends[0], ends[1], "{length} bytes");
            }
        }
        assert!(last + 40 > values.len(), "only {last} of {} are certain at the end", values.len());
    }

    #[test]
    fn a_message_is_hardly_longer_than_its_information() {
        let message = message(9, 200_000, false);
        let information = |&(value, p_one): &(u32, u32)| match p_one {
            0 => f64::from(value % 25),
            _ => -(f64::from(if value != 0 { p_one } else { 65536 - p_one }) / 65536.0).log2(),
        };
        let expected: f64 = message.iter().map(information).sum();
        let mut writer = RangeWriter::new();
        writer.part(Part::Positions);
        code(&mut writer, &message);
        let (bytes, spent) = writer.finish();
        let bits = bytes.len() as f64 * 8.0;
        assert!(bits < expected * 1.0001 + 8.0, "{bits} bits for {expected}");
        assert!(
            (spent[Part::Positions as usize] - expected).abs() < expected * 1e-4,
            "{spent:?} for {expected}"
        );
    }

    #[test]
    fn nothing_takes_no_bytes_and_zeros_are_dropped() {
        assert!(write(&[]).0.is_empty());
        let likely: Vec<_> = (0..100).map(|_| (1, 65535)).collect();
        assert!(write(&likely).0.len() <= 1);
    }

    #[test]
    fn any_bytes_are_read_without_harm() {
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
    fn a_fixed_message_has_fixed_bytes() {
        let (bytes, _) = write(&message(1, 1000, false));
        assert_eq!((bytes.len(), crc32fast::hash(&bytes)), (184, 3_424_878_432));
    }
}
