//! Words and numbers of text formats, read in place with the current line always known.
//!
//! One cursor serves OBJ, OFF, ASCII STL and ASCII PLY. Decimal numbers of up to 15 digits, the usual case
//! in meshes, are converted by one exact division. All others, and the rare ones for which rounding twice
//! could differ from rounding once, go through the standard library, so the result is always the nearest
//! `f32`. Cost: one pass over the bytes.

#[cfg(any(feature = "obj", feature = "stl", feature = "off"))]
use std::borrow::Cow;
use std::str::FromStr;

use crate::error::Fault;

/// Number of bytes that are examined to find out how lines end.
const EXAMINED_BYTES: usize = 1 << 12;

/// Returns a text without its byte order mark and what old systems put at its end (Ctrl-Z, zeros), with line
/// ends that [`Cursor`] knows: a carriage return alone becomes a line feed.
///
/// The text is only copied if its first lines end in carriage returns.
#[cfg(any(feature = "obj", feature = "stl", feature = "off"))]
pub(crate) fn plain(bytes: &[u8]) -> Cow<'_, [u8]> {
    let text = trimmed(bytes);
    if !has_lone_returns(text) {
        return Cow::Borrowed(text);
    }
    let mut copy = text.to_vec();
    with_line_feeds(&mut copy, false);
    Cow::Owned(copy)
}

/// Returns a text without its byte order mark, and without Ctrl-Z and zeros at its end.
#[cfg(any(feature = "ply", feature = "obj", feature = "stl", feature = "off"))]
pub(crate) fn trimmed(bytes: &[u8]) -> &[u8] {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let length = text.iter().rposition(|b| !matches!(b, 0x1a | 0)).map_or(0, |last| last + 1);
    &text[..length]
}

/// Whether a line of the text ends in a carriage return alone, as on old Macs.
#[cfg(any(feature = "obj", feature = "stl", feature = "off"))]
pub(crate) fn has_lone_returns(text: &[u8]) -> bool {
    // Texts without any carriage return at their beginning are not examined, which takes time.
    let head = &text[..text.len().min(EXAMINED_BYTES)];
    if !head.contains(&b'\r') {
        return false;
    }
    // Whole chunks without an early exit are compared sixteen bytes at a time.
    let (bytes, next) = (&text[..text.len() - 1], &text[1..]);
    let is_lone = |(&a, &b): (&u8, &u8)| (a == b'\r') & (b != b'\n') & (b != b'\r');
    let any_lone = |(a, b): (&[u8], &[u8])| a.iter().zip(b).fold(false, |any, pair| any | is_lone(pair));
    bytes.chunks(EXAMINED_BYTES).zip(next.chunks(EXAMINED_BYTES)).any(any_lone)
}

/// Replaces carriage returns by line feeds, unless one follows; `is_followed` says so for the last byte.
#[cfg(any(feature = "ply", feature = "obj", feature = "stl", feature = "off"))]
pub(crate) fn with_line_feeds(text: &mut [u8], is_followed: bool) {
    let mut next = if is_followed { b'\n' } else { 0 };
    for byte in text.iter_mut().rev() {
        let own = *byte;
        if own == b'\r' && next != b'\n' {
            *byte = b'\n';
        }
        next = own;
    }
}

/// Position in a text file, moving forward.
#[derive(Clone)]
pub(crate) struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    line: u64,
    /// Whether a backslash before the line's end joins the next line (OBJ).
    continues: bool,
    /// Whether a coordinate so far had more digits than an `f32` keeps.
    has_long_coordinates: bool,
}

impl<'a> Cursor<'a> {
    /// Creates a cursor at the start of a file.
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0, line: 1, continues: false, has_long_coordinates: false }
    }

    /// Creates a cursor in the middle of a file, at byte `at` in line `line`.
    #[cfg(feature = "ply")]
    pub(crate) fn starting_at(bytes: &'a [u8], at: usize, line: u64) -> Self {
        Self { bytes, at, line, ..Self::new(bytes) }
    }

    /// Makes a backslash at the end of a line join the next one.
    #[cfg(feature = "obj")]
    pub(crate) fn with_continuation(self) -> Self {
        Self { continues: true, ..self }
    }

    /// Whether [`coordinate`](Self::coordinate) has met a number with more digits than an `f32` keeps.
    #[cfg(any(feature = "ply", feature = "obj", feature = "stl", feature = "off"))]
    pub(crate) fn has_long_coordinates(&self) -> bool {
        self.has_long_coordinates
    }

    /// Returns the current line, counted from 1.
    pub(crate) fn line(&self) -> u64 {
        self.line
    }

    /// Returns the number of bytes not read yet.
    pub(crate) fn bytes_left(&self) -> usize {
        self.bytes.len() - self.at
    }

    /// Returns the number of bytes read so far.
    #[cfg(feature = "vtk")]
    pub(crate) fn offset(&self) -> usize {
        self.at
    }

    /// Reads bytes between the texts of a binary file; all that remain if there are fewer.
    #[cfg(feature = "vtk")]
    pub(crate) fn take_bytes(&mut self, count: usize) -> &'a [u8] {
        let start = self.at;
        self.at = start.saturating_add(count).min(self.bytes.len());
        &self.bytes[start..self.at]
    }

    /// Creates a fault at the current line.
    #[cold]
    pub(crate) fn fault(&self, reason: impl Into<String>) -> Fault {
        Fault::at_line(self.line, reason)
    }

    /// Returns the next byte without reading it.
    #[inline]
    pub(crate) fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    #[cfg(feature = "obj")]
    #[inline]
    pub(crate) fn skip_byte(&mut self) {
        self.at += 1;
    }

    /// Skips bytes that have been examined; there must be as many, without line ends.
    #[cfg(feature = "off")]
    pub(crate) fn skip_bytes(&mut self, count: usize) {
        self.at += count;
    }

    /// Skips blanks, up to the next word of the line or the line's end.
    #[inline]
    fn skip_blanks(&mut self) {
        while let Some(byte) = self.peek() {
            match byte {
                b' ' | b'\t' | b'\r' | 0x0b | 0x0c => self.at += 1,
                b'\\' if self.continues => match self.line_end_after(self.at + 1) {
                    Some(next) => {
                        self.at = next;
                        self.line += 1;
                    }
                    None => return,
                },
                _ => return,
            }
        }
    }

    /// Returns the offset after the line's end, if only blanks precede that end from `at` on.
    fn line_end_after(&self, at: usize) -> Option<usize> {
        let blanks = self.bytes[at..].iter().take_while(|b| matches!(b, b' ' | b'\t' | b'\r')).count();
        match self.bytes.get(at + blanks) {
            None => Some(self.bytes.len()),
            Some(b'\n') => Some(at + blanks + 1),
            Some(_) => None,
        }
    }

    /// Skips blanks, line ends, and comments that begin with `comment` if that is given.
    #[cfg(any(feature = "ply", feature = "stl", feature = "off", feature = "vtk"))]
    pub(crate) fn skip_lines(&mut self, comment: Option<u8>) {
        loop {
            self.skip_blanks();
            match self.peek() {
                Some(b'\n') => self.next_line(),
                Some(byte) if Some(byte) == comment => self.next_line(),
                _ => return,
            }
        }
    }

    /// Whether only blanks remain on the line; skips them.
    #[inline]
    pub(crate) fn at_line_end(&mut self) -> bool {
        self.skip_blanks();
        matches!(self.peek(), None | Some(b'\n'))
    }

    #[cfg(any(feature = "obj", feature = "stl", feature = "vtk"))]
    pub(crate) fn at_end(&self) -> bool {
        self.at >= self.bytes.len()
    }

    /// Skips the rest of the line and its end.
    #[inline]
    pub(crate) fn next_line(&mut self) {
        self.skip_blanks();
        if self.peek() != Some(b'\n') {
            self.rest_of_line();
        }
        if self.at < self.bytes.len() {
            self.at += 1;
            self.line += 1;
        }
    }

    /// Returns the rest of the line without surrounding blanks; the cursor stays before the line's end.
    pub(crate) fn rest_of_line(&mut self) -> &'a [u8] {
        self.skip_blanks();
        let start = self.at;
        loop {
            let rest = &self.bytes[self.at..];
            let length = rest.iter().position(|&b| b == b'\n').unwrap_or(rest.len());
            let joined =
                self.continues && self.at + length < self.bytes.len() && rest[..length].ends_with(b"\\");
            self.at += length;
            if !joined {
                break;
            }
            self.at += 1;
            self.line += 1;
        }
        self.bytes[start..self.at].trim_ascii()
    }

    /// Returns the next word of the line; empty at its end.
    #[inline]
    pub(crate) fn word(&mut self) -> &'a [u8] {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        self.at += length;
        &rest[..length]
    }

    /// Reads a decimal number.
    #[inline]
    pub(crate) fn number(&mut self) -> Result<TextNumber<'a>, Fault> {
        match self.short_number() {
            Some((decimal, text)) => Ok(TextNumber { decimal: Some(decimal), text }),
            None => self.unusual_number(),
        }
    }

    /// Reads a decimal number with few digits; reads nothing but blanks if it is none.
    #[inline(always)]
    fn short_number(&mut self) -> Option<(Decimal, &'a [u8])> {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let (decimal, length) = scan_decimal(rest);
        let decimal = decimal.filter(|_| rest.get(length).is_none_or(|&b| ends_number(b)))?;
        self.at += length;
        Some((decimal, &rest[..length]))
    }

    /// Reads a number that one exact operation converts; reads nothing but blanks otherwise. A coordinate is
    /// examined for more digits than an `f32` keeps.
    ///
    /// This is apart from [`number`](Self::number), because a result with a fault is returned through memory,
    /// which takes a quarter of the time of reading a text file.
    fn quick_f32<const IS_COORDINATE: bool>(&mut self) -> Option<f32> {
        let (decimal, text) = self.short_number()?;
        let Some(value) = decimal.to_f32() else {
            self.at -= text.len();
            return None;
        };
        let number = TextNumber { decimal: Some(decimal), text };
        self.has_long_coordinates |= IS_COORDINATE && number.has_more_digits_than(value);
        Some(value)
    }

    /// Reads a number that is long, or reports that it is not a number.
    #[cold]
    fn unusual_number(&mut self) -> Result<TextNumber<'a>, Fault> {
        let word = self.word();
        match parsed::<f32>(word) {
            Some(_) => Ok(TextNumber { decimal: None, text: word }),
            None => Err(self.fault(format!("expected a number, found {}", quoted(word)))),
        }
    }

    /// Reads a decimal number as the nearest `f32`.
    #[inline]
    pub(crate) fn f32(&mut self) -> Result<f32, Fault> {
        match self.quick_f32::<false>() {
            Some(value) => Ok(value),
            None => Ok(self.number()?.to_f32()),
        }
    }

    /// Reads a decimal number as the nearest `f64`.
    #[cfg(any(feature = "ply", feature = "obj", feature = "stl", feature = "off"))]
    pub(crate) fn f64(&mut self) -> Result<f64, Fault> {
        Ok(self.number()?.to_f64())
    }

    /// Reads a coordinate as the nearest `f64`, and notes whether it has more digits than an `f32` keeps.
    #[cfg(feature = "stl")]
    pub(crate) fn long_coordinate(&mut self) -> Result<f64, Fault> {
        let number = self.number()?;
        self.has_long_coordinates |= number.has_more_digits_than(number.to_f32());
        Ok(number.to_f64())
    }

    /// Reads a coordinate as the nearest `f32`, and notes whether it has more digits than that.
    #[cfg(any(feature = "ply", feature = "obj", feature = "stl", feature = "off"))]
    #[inline]
    pub(crate) fn coordinate(&mut self) -> Result<f32, Fault> {
        match self.quick_f32::<true>() {
            Some(value) => Ok(value),
            None => self.slow_coordinate(),
        }
    }

    #[cfg(any(feature = "ply", feature = "obj", feature = "stl", feature = "off"))]
    #[cold]
    fn slow_coordinate(&mut self) -> Result<f32, Fault> {
        let number = self.number()?;
        let value = number.to_f32();
        self.has_long_coordinates |= number.has_more_digits_than(value);
        Ok(value)
    }

    /// Reads an integer; accepts `3.0` as 3, because some writers produce it.
    #[inline]
    pub(crate) fn integer(&mut self) -> Result<i64, Fault> {
        match self.short_integer() {
            Some(value) => Ok(value),
            None => self.unusual_integer(),
        }
    }

    /// Reads a number that should be an integer; returns the nearest one, and what is wrong with the word if it is
    /// something else.
    #[cfg(feature = "ply")]
    pub(crate) fn nearest_integer(&mut self) -> (i64, Option<Fault>) {
        match self.short_integer() {
            Some(value) => (value, None),
            None => self.unusual_nearest(),
        }
    }

    #[cfg(feature = "ply")]
    #[cold]
    fn unusual_nearest(&mut self) -> (i64, Option<Fault>) {
        let mut before = self.clone();
        match self.unusual_integer() {
            Ok(value) => (value, None),
            Err(fault) => {
                let nearest = parsed::<f64>(before.word()).map_or(0, |x| x.round() as i64);
                self.at = before.at;
                (nearest, Some(fault))
            }
        }
    }

    /// Reads digits with a sign; reads nothing but blanks if it is something else.
    fn short_integer(&mut self) -> Option<i64> {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let negative = rest.first() == Some(&b'-');
        let signed = usize::from(negative || rest.first() == Some(&b'+'));
        let (value, length) = scan_digits(rest, signed, 0);
        let is_short = (1..=LONGEST).contains(&(length - signed));
        if !is_short || !rest.get(length).is_none_or(|&b| ends_number(b)) {
            return None;
        }
        self.at += length;
        Some(if negative { -(value as i64) } else { value as i64 })
    }

    /// Whether the word before the cursor consists of digits, so that it is a number, if a long one.
    #[cfg(feature = "obj")]
    pub(crate) fn is_after_digits(&self) -> bool {
        let word = self.bytes[..self.at].rsplit(|b| b.is_ascii_whitespace()).next().unwrap_or(&[]);
        let digits = word.strip_prefix(b"-").or(word.strip_prefix(b"+")).unwrap_or(word);
        digits.iter().all(u8::is_ascii_digit)
    }

    /// Reads an integer written as a decimal fraction, or reports that it is not an integer.
    #[cold]
    fn unusual_integer(&mut self) -> Result<i64, Fault> {
        // A slash ends the numbers of OBJ corners.
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|b| b.is_ascii_whitespace() || *b == b'/').unwrap_or(rest.len());
        self.at += length;
        let word = &rest[..length];
        let digits = word.strip_prefix(b"-").or(word.strip_prefix(b"+")).unwrap_or(word);
        if scan_digits(digits, 0, 0).1 > LONGEST {
            return Err(self.fault(format!("the whole number {} is too long", quoted(word))));
        }
        match parsed::<f64>(word).filter(|x| x.fract() == 0.0 && x.abs() < 1e15) {
            Some(x) => Ok(x as i64),
            None => Err(self.fault(format!("expected a whole number, found {}", quoted(word)))),
        }
    }
}

/// Whether a byte may follow a number: blanks, line ends, and the slash of OBJ corners.
#[inline]
fn ends_number(byte: u8) -> bool {
    byte.is_ascii_whitespace() || byte == b'/' || byte == b'\\' || byte == 0x0b
}

/// Parses a word as a number. Values that are not finite are NaN as some programs print them, and exponents may begin
/// with the `D` of Fortran.
pub(crate) fn parsed<T: FromStr>(word: &[u8]) -> Option<T> {
    let text = std::str::from_utf8(word).ok()?;
    if let Ok(number) = text.parse() {
        return Some(number);
    }
    if is_not_finite(word) {
        return "nan".parse().ok();
    }
    let (digits, exponent) = text.split_once(['d', 'D'])?;
    format!("{digits}e{exponent}").parse().ok()
}

/// Whether a word is what some program prints for a value that is not finite: `-nan(ind)`, `1.#QNAN`,
/// `-1.#INF`. It is read as NaN.
fn is_not_finite(word: &[u8]) -> bool {
    let word = word.strip_prefix(b"-").or(word.strip_prefix(b"+")).unwrap_or(word);
    let begins = |prefix: &[u8]| word.get(..prefix.len()).is_some_and(|w| w.eq_ignore_ascii_case(prefix));
    [&b"nan("[..], b"1.#", b"1,#", b"qnan", b"snan"].iter().any(|prefix| begins(prefix))
}

/// Number as text and, if it is short enough, as digits.
#[derive(Clone, Copy)]
pub(crate) struct TextNumber<'a> {
    decimal: Option<Decimal>,
    text: &'a [u8],
}

/// The value `mantissa * 10^exponent`, apart from the sign.
#[derive(Clone, Copy)]
struct Decimal {
    negative: bool,
    mantissa: u64,
    exponent: i32,
}

const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

impl Decimal {
    /// Returns the nearest `f64`, apart from the sign, if one exact operation finds it.
    #[inline]
    fn magnitude(self) -> Option<f64> {
        if self.mantissa >= 1 << 53 {
            return None;
        }
        let power = *POWERS.get(self.exponent.unsigned_abs() as usize)?;
        let mantissa = self.mantissa as f64;
        Some(if self.exponent < 0 { mantissa / power } else { mantissa * power })
    }

    /// Returns the nearest `f32` if one exact `f64` operation finds it.
    #[inline]
    fn to_f32(self) -> Option<f32> {
        let magnitude = self.magnitude()?;
        // Half-way between two `f32`: the `f64` may itself have been rounded to this value.
        const HALF: u64 = 1 << 28;
        if magnitude.to_bits() & ((1 << 29) - 1) == HALF {
            return None;
        }
        Some(if self.negative { -magnitude as f32 } else { magnitude as f32 })
    }
}

impl TextNumber<'_> {
    #[inline]
    pub(crate) fn to_f32(self) -> f32 {
        match self.decimal.and_then(Decimal::to_f32) {
            Some(value) => value,
            None => parsed(self.text).unwrap_or(f32::NAN),
        }
    }

    /// Returns the nearest `f64`.
    pub(crate) fn to_f64(self) -> f64 {
        match self.decimal.and_then(|d| Some((d, d.magnitude()?))) {
            Some((decimal, magnitude)) => {
                if decimal.negative {
                    -magnitude
                } else {
                    magnitude
                }
            }
            None => parsed(self.text).unwrap_or(f64::NAN),
        }
    }

    /// Whether the text has digits that `value`, the nearest `f32`, does not give back: printed with as many
    /// places, it would be another number. Six-digit texts of single-precision programs have none.
    #[inline]
    fn has_more_digits_than(self, value: f32) -> bool {
        // Half a unit in the last place of an f32 is less than half a unit of the last digit here.
        const SHORT: u64 = 1 << 23;
        self.decimal.is_none_or(|d| d.mantissa >= SHORT) && self.differs_from(value)
    }

    fn differs_from(self, value: f32) -> bool {
        let exact = self.to_f64();
        // The double is rounded too.
        let difference = (exact - f64::from(value)).abs() - f64::EPSILON * exact.abs();
        let power = self.decimal.filter(|d| d.exponent < 0);
        let power = power.and_then(|d| POWERS.get(d.exponent.unsigned_abs() as usize).copied());
        let power = power.or_else(|| self.power_of_last_place()).unwrap_or(POWERS[22]);
        difference.is_finite() && difference * power > 0.500_001
    }

    /// Returns the number that the last digit of a long text must be multiplied by to be an integer.
    #[cold]
    fn power_of_last_place(self) -> Option<f64> {
        let text = std::str::from_utf8(self.text).ok()?;
        let (digits, exponent) = text.split_once(['e', 'E', 'd', 'D']).unwrap_or((text, "0"));
        let places = digits.split_once('.').map_or(0, |(_, fraction)| fraction.len());
        let places = i64::try_from(places).ok()?.checked_sub(exponent.parse().ok()?)?;
        // The zeros at the end of a large integer are not digits that its writer knew.
        let zeros = if places == 0 { digits.len() - digits.trim_end_matches('0').len() } else { 0 };
        format!("1e{}", places - zeros as i64).parse().ok()
    }

    /// Returns `1 - self`, subtracted in decimal if possible, so that nothing is lost.
    #[cfg(any(feature = "ply", feature = "obj", feature = "off"))]
    pub(crate) fn one_minus_f32(self) -> f32 {
        let exact = self.decimal.filter(|d| (-15..=0).contains(&d.exponent) && d.mantissa < 1 << 53);
        if let Some(d) = exact {
            let one = 10i64.pow(d.exponent.unsigned_abs());
            let mantissa = d.mantissa as i64;
            let difference = if d.negative { one + mantissa } else { one - mantissa };
            let flipped = Decimal {
                negative: difference < 0,
                mantissa: difference.unsigned_abs(),
                exponent: d.exponent,
            };
            if let Some(value) = flipped.to_f32() {
                return value;
            }
        }
        (1.0 - parsed(self.text).unwrap_or(f64::NAN)) as f32
    }
}

/// Returns the decimal number at the start of `bytes`, or [`None`] if it is unusual or too long, and the
/// length of the text.
#[inline(always)]
fn scan_decimal(bytes: &[u8]) -> (Option<Decimal>, usize) {
    let negative = bytes.first() == Some(&b'-');
    let start = usize::from(negative || bytes.first() == Some(&b'+'));
    let (mut mantissa, mut at) = scan_digits(bytes, start, 0);
    let mut digit_count = at - start;
    let mut exponent = 0;
    if bytes.get(at) == Some(&b'.') {
        let point = at;
        (mantissa, at) = scan_digits(bytes, point + 1, mantissa);
        let places = at - point - 1;
        digit_count += places;
        exponent = -(places.min(LONGEST) as i32);
    }
    if digit_count == 0 || digit_count > LONGEST {
        return (None, at);
    }
    if matches!(bytes.get(at), Some(b'e' | b'E' | b'd' | b'D')) {
        let Some((power, length)) = scan_exponent(&bytes[at + 1..]) else { return (None, at) };
        exponent += power;
        at += 1 + length;
    }
    (Some(Decimal { negative, mantissa, exponent }), at)
}

/// Number of decimal digits that fit into 64 bits, whatever they are.
const LONGEST: usize = 18;

/// Appends the digits from `at` on to `value`; returns it with the offset of the first other byte. The value
/// means nothing if there are more than [`LONGEST`] digits, which is compared once for the whole number: a
/// comparison for each digit takes a tenth of the time of reading a text file.
#[inline]
fn scan_digits(bytes: &[u8], mut at: usize, mut value: u64) -> (u64, usize) {
    while let Some(digit) = bytes.get(at).map(|byte| byte.wrapping_sub(b'0')).filter(|&digit| digit < 10) {
        value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
        at += 1;
    }
    (value, at)
}

fn scan_exponent(bytes: &[u8]) -> Option<(i32, usize)> {
    let negative = bytes.first() == Some(&b'-');
    let signed = usize::from(negative || bytes.first() == Some(&b'+'));
    let digits = bytes[signed..].iter().take_while(|b| b.is_ascii_digit()).count();
    if digits == 0 || digits > 4 {
        return None;
    }
    let value = bytes[signed..signed + digits].iter().fold(0i32, |v, b| v * 10 + i32::from(b - b'0'));
    Some((if negative { -value } else { value }, signed + digits))
}

/// Formats a word for a message: quoted, shortened, without control bytes.
pub(crate) fn quoted(word: &[u8]) -> String {
    if word.is_empty() {
        return "the end of the line".to_owned();
    }
    let shown: String =
        String::from_utf8_lossy(&word[..word.len().min(40)]).chars().filter(|c| !c.is_control()).collect();
    if word.len() > 40 { format!("`{shown}…`") } else { format!("`{shown}`") }
}

/// Appends a number as text that reads back as the same `f32`.
#[cfg(any(feature = "ply", feature = "obj", feature = "off", feature = "threemf"))]
pub(crate) fn push_f32(out: &mut Vec<u8>, value: f32) {
    use std::io::Write as _;
    let magnitude = value.abs();
    let plain = magnitude == 0.0 || (1e-5..1e15).contains(&magnitude) || !value.is_finite();
    let written = if plain { write!(out, "{value}") } else { write!(out, "{value:e}") };
    debug_assert!(written.is_ok(), "writing to memory does not fail");
}

/// Appends a number as text that reads back as the same `f64`.
#[cfg(any(feature = "ply", feature = "obj", feature = "off"))]
pub(crate) fn push_f64(out: &mut Vec<u8>, value: f64) {
    use std::io::Write as _;
    let magnitude = value.abs();
    let plain = magnitude == 0.0 || (1e-5..1e15).contains(&magnitude) || !value.is_finite();
    let written = if plain { write!(out, "{value}") } else { write!(out, "{value:e}") };
    debug_assert!(written.is_ok(), "writing to memory does not fail");
}

/// Appends the coordinates of a vertex in the file, separated by blanks, as text that reads back as the same
/// numbers.
#[cfg(any(feature = "ply", feature = "obj", feature = "off"))]
pub(crate) fn push_coordinates(out: &mut Vec<u8>, mesh: &striata::mesh::IndexedMesh, vertex: usize) {
    for axis in 0..3 {
        if axis > 0 {
            out.push(b' ');
        }
        if !mesh.needs_doubles() {
            push_f32(out, mesh.positions[vertex][axis]);
            continue;
        }
        push_f64(out, mesh.file_position(vertex)[axis]);
    }
}

/// Appends `1 - value` as text that [`TextNumber::one_minus_f32`] reads back as `value`.
#[cfg(any(feature = "ply", feature = "obj", feature = "off"))]
pub(crate) fn push_one_minus_f32(out: &mut Vec<u8>, value: f32) {
    let text = value.to_string();
    match decimal_one_minus(&text) {
        Some(flipped) => out.extend_from_slice(flipped.as_bytes()),
        None => out.extend_from_slice((1.0 - f64::from(value)).to_string().as_bytes()),
    }
}

#[cfg(any(feature = "ply", feature = "obj", feature = "off"))]
fn decimal_one_minus(text: &str) -> Option<String> {
    let (sign, digits) = match text.strip_prefix('-') {
        Some(digits) => (-1, digits),
        None => (1, text),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    if whole.len() + fraction.len() > 36 {
        return None;
    }
    let mantissa: i128 = format!("{whole}{fraction}").parse().ok()?;
    let scale = 10i128.checked_pow(fraction.len() as u32)?;
    let flipped = scale - sign * mantissa;
    let sign = if flipped < 0 { "-" } else { "" };
    let (whole, part) = (flipped.abs() / scale, flipped.abs() % scale);
    if fraction.is_empty() {
        return Some(format!("{sign}{whole}"));
    }
    let places = fraction.len();
    let text = format!("{sign}{whole}.{part:0places$}");
    Some(text.trim_end_matches('0').trim_end_matches('.').to_owned())
}

#[cfg(test)]
mod tests;
