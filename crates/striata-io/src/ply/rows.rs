//! Sources of the numbers of a PLY body: words of a text, or bytes of either order.

use crate::error::Fault;
use crate::report::{WarningKind, Warnings};
use crate::text::{Cursor, TextNumber};

use super::header::{Element, Header, Scalar};

/// Reader of the numbers of a body, one after another.
pub(crate) trait Rows<'a> {
    /// Reads a number that must be an integer: an index or a list's length.
    fn integer(&mut self, scalar: Scalar) -> Result<i64, Fault>;
    /// Reads a number of any type.
    fn float(&mut self, scalar: Scalar) -> Result<f32, Fault>;
    /// Reads a number of any type, and returns 1 minus it.
    fn one_minus(&mut self, scalar: Scalar) -> Result<f32, Fault> {
        Ok(1.0 - self.float(scalar)?)
    }
    /// Whether the numbers are text, which [`one_minus`](Self::one_minus) subtracts in decimal.
    fn is_text(&self) -> bool {
        false
    }
    /// Appends a number of any type to `out`, as the little-endian bytes of that type.
    fn copy(&mut self, scalar: Scalar, out: &mut Vec<u8>) -> Result<(), Fault>;
    /// Appends a number like [`copy`](Self::copy), as a texture coordinate with the other origin.
    fn copy_flipped(&mut self, scalar: Scalar, out: &mut Vec<u8>) -> Result<(), Fault> {
        match scalar {
            Scalar::F32 => out.extend_from_slice(&self.one_minus(scalar)?.to_le_bytes()),
            Scalar::F64 => {
                let start = out.len();
                self.copy(scalar, out)?;
                if let Some(bytes) = out[start..].first_chunk_mut::<8>() {
                    *bytes = (1.0 - f64::from_le_bytes(*bytes)).to_le_bytes();
                }
            }
            Scalar::U8 | Scalar::U16 => {
                let start = out.len();
                self.copy(scalar, out)?;
                // The largest number minus this one.
                out[start..].iter_mut().for_each(|byte| *byte = !*byte);
            }
            // Plain integers are pixels or something else.
            _ => self.copy(scalar, out)?,
        }
        Ok(())
    }
    /// Appends a coordinate like [`copy`](Self::copy), and notes whether it has more digits than its type.
    fn copy_coordinate(&mut self, scalar: Scalar, out: &mut Vec<u8>) -> Result<(), Fault> {
        self.copy(scalar, out)
    }
    /// Skips `count` numbers.
    fn skip(&mut self, scalar: Scalar, count: usize) -> Result<(), Fault>;
    /// Returns the smallest number of bytes that one row of the element takes in this source.
    fn least_row_bytes(&self, element: &Element) -> usize;
    fn bytes_left(&self) -> usize;
    fn fault(&self, reason: String) -> Fault;
    /// Returns the next `length` bytes of the file, if [`copy`](Self::copy) would return the same bytes.
    fn little_endian_bytes(&mut self, _length: usize) -> Option<&'a [u8]> {
        None
    }
    /// Returns the rest of the file, under the same condition.
    fn little_endian_rest(&self) -> Option<&'a [u8]> {
        None
    }
    /// Marks the current position for later messages.
    fn mark(&self) -> u64;
    /// Creates a fault at a position marked earlier.
    fn fault_at(mark: u64, reason: String) -> Fault
    where
        Self: Sized;
}

/// Words of a text file. Those that are no numbers, or do not fit their type, cost no more than their value, unless
/// they are indices.
pub(crate) struct AsciiRows<'a> {
    pub cursor: Cursor<'a>,
    /// Words that could not be read as they are.
    pub warnings: Warnings,
}

impl<'a> AsciiRows<'a> {
    pub(crate) fn new(bytes: &'a [u8], header: &Header, file: &str) -> Self {
        let cursor = Cursor::starting_at(bytes, header.body_at, header.body_line);
        Self { cursor, warnings: Warnings::of_file(file) }
    }

    /// Goes to the next word of the file.
    fn next_word(&mut self) -> Result<(), Fault> {
        self.cursor.skip_lines(None);
        match self.cursor.bytes_left() {
            0 => Err(self.cursor.fault("the file ends within an element")),
            _ => Ok(()),
        }
    }

    /// Returns a number that was read; NaN with a warning if it is none.
    fn number<T: From<f32>>(&mut self, read: Result<T, Fault>) -> T {
        read.unwrap_or_else(|fault| {
            self.warnings.count_fault(WarningKind::WORDS, fault);
            T::from(f32::NAN)
        })
    }

    /// Reads an integer of a type; the nearest one with a warning if the word is another number.
    fn integer_of(&mut self, scalar: Scalar) -> i64 {
        let (value, fault) = self.cursor.nearest_integer();
        if let Some(fault) = fault {
            let kind = WarningKind("value that is no whole number", "values that are no whole numbers");
            self.warnings.count_fault(kind, fault);
        }
        let nearest = nearest(scalar, value);
        if nearest != value {
            let reason = format!("{value} does not fit into a {}; it becomes {nearest}", scalar.name());
            let kind = WarningKind("value out of range", "values out of range");
            self.warnings.count_fault(kind, self.cursor.fault(reason));
        }
        nearest
    }
}

impl<'a> Rows<'a> for AsciiRows<'a> {
    fn integer(&mut self, _scalar: Scalar) -> Result<i64, Fault> {
        self.cursor.skip_lines(None);
        self.cursor.integer()
    }

    fn float(&mut self, _scalar: Scalar) -> Result<f32, Fault> {
        self.next_word()?;
        let read = self.cursor.f32();
        Ok(self.number(read))
    }

    fn one_minus(&mut self, _scalar: Scalar) -> Result<f32, Fault> {
        self.next_word()?;
        let read = self.cursor.number().map(TextNumber::one_minus_f32);
        Ok(self.number(read))
    }

    fn is_text(&self) -> bool {
        true
    }

    fn copy(&mut self, scalar: Scalar, out: &mut Vec<u8>) -> Result<(), Fault> {
        self.next_word()?;
        match scalar {
            Scalar::F32 => {
                let read = self.cursor.f32();
                out.extend_from_slice(&self.number(read).to_le_bytes());
            }
            Scalar::F64 => {
                let read = self.cursor.f64();
                out.extend_from_slice(&self.number(read).to_le_bytes());
            }
            // Two's complement: the low bytes represent the number in every narrower type.
            _ => out.extend_from_slice(&self.integer_of(scalar).to_le_bytes()[..scalar.bytes()]),
        }
        Ok(())
    }

    fn copy_coordinate(&mut self, scalar: Scalar, out: &mut Vec<u8>) -> Result<(), Fault> {
        if scalar != Scalar::F32 {
            return self.copy(scalar, out);
        }
        self.next_word()?;
        let read = self.cursor.coordinate();
        out.extend_from_slice(&self.number(read).to_le_bytes());
        Ok(())
    }

    fn skip(&mut self, _scalar: Scalar, count: usize) -> Result<(), Fault> {
        for _ in 0..count {
            self.next_word()?;
            self.cursor.word();
        }
        Ok(())
    }

    fn least_row_bytes(&self, element: &Element) -> usize {
        // A digit and a blank for each number.
        element.properties.len() * 2
    }

    fn bytes_left(&self) -> usize {
        // The last number of a file needs no blank after it.
        self.cursor.bytes_left() + 1
    }

    fn fault(&self, reason: String) -> Fault {
        self.cursor.fault(reason)
    }

    fn mark(&self) -> u64 {
        self.cursor.line()
    }

    fn fault_at(mark: u64, reason: String) -> Fault {
        Fault::at_line(mark, reason)
    }
}

/// Returns the nearest value of a type.
fn nearest(scalar: Scalar, value: i64) -> i64 {
    match scalar {
        Scalar::I8 => value.clamp(i8::MIN.into(), i8::MAX.into()),
        Scalar::U8 => value.clamp(0, u8::MAX.into()),
        Scalar::I16 => value.clamp(i16::MIN.into(), i16::MAX.into()),
        Scalar::U16 => value.clamp(0, u16::MAX.into()),
        Scalar::I32 => value.clamp(i32::MIN.into(), i32::MAX.into()),
        Scalar::U32 => value.clamp(0, u32::MAX.into()),
        Scalar::F32 | Scalar::F64 => value,
    }
}

/// Bytes of the file; `BIG` selects big-endian.
pub(crate) struct BinaryRows<'a, const BIG: bool> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a, const BIG: bool> BinaryRows<'a, BIG> {
    pub(crate) fn new(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at }
    }

    /// Returns the offset of the next byte.
    #[cfg(all(feature = "pieces", not(target_family = "wasm")))]
    pub(crate) fn at(&self) -> usize {
        self.at
    }

    #[inline]
    fn take(&mut self, length: usize) -> Result<&'a [u8], Fault> {
        match self.bytes[self.at..].get(..length) {
            Some(taken) => {
                self.at += length;
                Ok(taken)
            }
            None => {
                let reason = format!("{length} bytes expected, {} left", self.bytes.len() - self.at);
                Err(Fault::at_byte(self.at, reason))
            }
        }
    }
}

impl<'a, const BIG: bool> Rows<'a> for BinaryRows<'a, BIG> {
    #[inline]
    fn integer(&mut self, scalar: Scalar) -> Result<i64, Fault> {
        Ok(integer_from_bytes(self.take(scalar.bytes())?, scalar, BIG))
    }

    #[inline]
    fn float(&mut self, scalar: Scalar) -> Result<f32, Fault> {
        let taken = self.take(scalar.bytes())?;
        Ok(match scalar {
            Scalar::F32 => f32::from_bits(word_of(taken, BIG) as u32),
            Scalar::F64 => f64::from_bits(word_of(taken, BIG)) as f32,
            _ => integer_from_bytes(taken, scalar, BIG) as f32,
        })
    }

    #[inline]
    fn copy(&mut self, scalar: Scalar, out: &mut Vec<u8>) -> Result<(), Fault> {
        let taken = self.take(scalar.bytes())?;
        if BIG {
            out.extend(taken.iter().rev())
        } else {
            out.extend_from_slice(taken)
        }
        Ok(())
    }

    fn skip(&mut self, scalar: Scalar, count: usize) -> Result<(), Fault> {
        match count.checked_mul(scalar.bytes()) {
            Some(length) => self.take(length).map(|_| ()),
            None => Err(self.fault(format!("a list of {count} numbers"))),
        }
    }

    fn least_row_bytes(&self, element: &Element) -> usize {
        element.least_row_bytes()
    }

    fn bytes_left(&self) -> usize {
        self.bytes.len() - self.at
    }

    fn fault(&self, reason: String) -> Fault {
        Fault::at_byte(self.at, reason)
    }

    fn little_endian_bytes(&mut self, length: usize) -> Option<&'a [u8]> {
        if BIG { None } else { self.take(length).ok() }
    }

    fn little_endian_rest(&self) -> Option<&'a [u8]> {
        (!BIG).then(|| &self.bytes[self.at..])
    }

    fn mark(&self) -> u64 {
        self.at as u64
    }

    fn fault_at(mark: u64, reason: String) -> Fault {
        Fault::at_byte(mark as usize, reason)
    }
}

/// Returns up to eight bytes as the low bytes of a word.
#[inline]
fn word_of(taken: &[u8], is_big: bool) -> u64 {
    let mut word = [0u8; 8];
    for (i, &byte) in taken.iter().enumerate() {
        word[if is_big { taken.len() - 1 - i } else { i }] = byte;
    }
    u64::from_le_bytes(word)
}

/// Converts bytes to a number that must be an integer.
#[inline]
pub(crate) fn integer_from_bytes(taken: &[u8], scalar: Scalar, is_big: bool) -> i64 {
    let value = word_of(taken, is_big);
    match scalar {
        Scalar::I8 => i64::from(value as i8),
        Scalar::I16 => i64::from(value as i16),
        Scalar::I32 => i64::from(value as i32),
        Scalar::U8 | Scalar::U16 | Scalar::U32 => value as i64,
        // Some files store indices as floats; fractions become an index that does not exist.
        Scalar::F32 => whole(f64::from(f32::from_bits(value as u32))),
        Scalar::F64 => whole(f64::from_bits(value)),
    }
}

fn whole(value: f64) -> i64 {
    if value.fract() == 0.0 { value as i64 } else { i64::MIN }
}
