//! Reversible rearrangements of numbers that make them easier to compress.

/// How the bytes of a segment are rearranged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Filter {
    /// Not at all.
    None,
    /// Bytes at the same place of all elements are adjacent.
    Planes,
    /// Differences of 32-bit integers to the element before, then planes.
    Differences,
    /// Floats that are multiples of 2 to the power of `-exponent`: differences of the multiples to the
    /// element before, with the sign in the lowest bit, then planes.
    Multiples { exponent: i8 },
}

impl Filter {
    /// Returns the code of the filter, with a parameter.
    pub(super) fn code(self) -> [u8; 2] {
        match self {
            Self::None => [0, 0],
            Self::Planes => [1, 0],
            Self::Differences => [2, 0],
            Self::Multiples { exponent } => [3, exponent as u8],
        }
    }

    /// Returns the filter for a code and the stride of a segment, if both are valid.
    pub(super) fn from_code(code: [u8; 2], stride: usize) -> Option<Self> {
        let filter = match code {
            [0, 0] => Self::None,
            [1, 0] => Self::Planes,
            [2, 0] => Self::Differences,
            [3, exponent] => Self::Multiples { exponent: exponent as i8 },
            _ => return None,
        };
        let is_of_words = matches!(filter, Self::Differences | Self::Multiples { .. });
        (stride > 0 && (!is_of_words || stride.is_multiple_of(4))).then_some(filter)
    }
}

/// Range of exponents of [`Filter::Multiples`].
const EXPONENTS: std::ops::RangeInclusive<i8> = -64..=64;

/// Returns the smallest exponent for which all floats are multiples, below 2^24, of its power of two.
pub(super) fn common_exponent(bytes: &[u8]) -> Option<i8> {
    let words = bytes.as_chunks::<4>().0.iter().map(|word| f32::from_le_bytes(*word));
    let mut exponent = *EXPONENTS.start();
    for number in words {
        while !is_multiple(number, exponent) {
            exponent += 1;
            EXPONENTS.contains(&exponent).then_some(())?;
        }
    }
    // Larger numbers may have passed before the exponent rose.
    let mut words = bytes.as_chunks::<4>().0.iter();
    words.all(|word| is_multiple(f32::from_le_bytes(*word), exponent)).then_some(exponent)
}

fn is_multiple(number: f32, exponent: i8) -> bool {
    from_multiple(multiple(number, exponent), exponent).to_bits() == number.to_bits()
}

fn multiple(number: f32, exponent: i8) -> i32 {
    let multiple = f64::from(number) * power_of_two(exponent);
    if multiple.abs() < f64::from(1 << 24) { multiple as i32 } else { 0 }
}

fn from_multiple(multiple: i32, exponent: i8) -> f32 {
    (f64::from(multiple) / power_of_two(exponent)) as f32
}

/// Returns 2 to the power of a number.
fn power_of_two(exponent: i8) -> f64 {
    f64::from_bits((1023 + i64::from(exponent)) as u64 * (1 << 52))
}

/// Puts the sign into the lowest bit.
fn folded(number: i32) -> u32 {
    ((number << 1) ^ (number >> 31)) as u32
}

fn unfolded(number: u32) -> i32 {
    (number >> 1) as i32 ^ -((number & 1) as i32)
}

/// Rearranges the bytes of elements that are `stride` bytes long.
pub(super) fn apply(bytes: &[u8], stride: usize, filter: Filter) -> Vec<u8> {
    match filter {
        Filter::None => bytes.to_vec(),
        Filter::Planes => planes(bytes, stride),
        Filter::Differences => {
            let (words, rest) = bytes.as_chunks::<4>();
            let lanes = stride / 4;
            let word = |at: usize| u32::from_le_bytes(words[at]);
            let before = |at: usize| at.checked_sub(lanes).map_or(0, word);
            let differences = (0..words.len()).flat_map(|at| word(at).wrapping_sub(before(at)).to_le_bytes());
            planes(&differences.chain(rest.iter().copied()).collect::<Vec<u8>>(), stride)
        }
        Filter::Multiples { exponent } => {
            let (words, rest) = bytes.as_chunks::<4>();
            let lanes = stride / 4;
            let value = |at: usize| multiple(f32::from_le_bytes(words[at]), exponent);
            let before = |at: usize| at.checked_sub(lanes).map_or(0, value);
            let differences =
                (0..words.len()).flat_map(|at| folded(value(at).wrapping_sub(before(at))).to_le_bytes());
            planes(&differences.chain(rest.iter().copied()).collect::<Vec<u8>>(), stride)
        }
    }
}

/// Undoes [`apply`].
pub(super) fn undo(bytes: &[u8], stride: usize, filter: Filter) -> Vec<u8> {
    match filter {
        Filter::None => bytes.to_vec(),
        Filter::Planes => from_planes(bytes, stride),
        Filter::Differences => {
            let mut bytes = from_planes(bytes, stride);
            let lanes = stride / 4;
            let (words, _) = bytes.as_chunks_mut::<4>();
            for at in lanes..words.len() {
                let sum = u32::from_le_bytes(words[at]).wrapping_add(u32::from_le_bytes(words[at - lanes]));
                words[at] = sum.to_le_bytes();
            }
            bytes
        }
        Filter::Multiples { exponent } => {
            let mut bytes = from_planes(bytes, stride);
            let mut before = vec![0i32; (stride / 4).min(bytes.len() / 4)];
            let lanes = before.len().max(1);
            for (at, word) in bytes.as_chunks_mut::<4>().0.iter_mut().enumerate() {
                let value = before[at % lanes].wrapping_add(unfolded(u32::from_le_bytes(*word)));
                before[at % lanes] = value;
                *word = from_multiple(value, exponent).to_le_bytes();
            }
            bytes
        }
    }
}

fn planes(bytes: &[u8], stride: usize) -> Vec<u8> {
    (0..stride.min(bytes.len())).flat_map(|lane| bytes.iter().skip(lane).step_by(stride)).copied().collect()
}

fn from_planes(bytes: &[u8], stride: usize) -> Vec<u8> {
    let mut out = vec![0; bytes.len()];
    let mut source = bytes.iter();
    for lane in 0..stride.min(bytes.len()) {
        out.iter_mut().skip(lane).step_by(stride).zip(source.by_ref()).for_each(|(slot, &byte)| *slot = byte);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn filters_are_inverted_at_any_length() {
        for length in [0usize, 1, 3, 4, 7, 16, 33, 100] {
            let bytes: Vec<u8> = (0..length).map(|i| (i * i * 7) as u8).collect();
            for stride in [1, 2, 4, 12, 16, 200] {
                let filters = [Filter::None, Filter::Planes, Filter::Differences];
                for filter in filters {
                    if Filter::from_code(filter.code(), stride).is_none() {
                        continue;
                    }
                    let there = apply(&bytes, stride, filter);
                    assert_eq!(there.len(), bytes.len());
                    assert_eq!(undo(&there, stride, filter), bytes, "{length} {stride} {filter:?}");
                }
            }
        }
    }
    #[test]
    fn multiples_of_powers_of_two_are_exact() {
        let floats: Vec<f32> = (0..100).map(|i| (i * i % 37) as f32 / 256.0 - 3.0).collect();
        let bytes: Vec<u8> = floats.iter().flat_map(|x| x.to_le_bytes()).collect();
        let exponent = common_exponent(&bytes).unwrap();
        assert_eq!(exponent, 8);
        for stride in [4, 12, 16, 4000] {
            let filter = Filter::Multiples { exponent };
            assert_eq!(undo(&apply(&bytes, stride, filter), stride, filter), bytes);
        }
        for odd in [f32::NAN, f32::INFINITY, -0.0, 1e30, 1e-30, std::f32::consts::PI * 1e8] {
            let bytes: Vec<u8> = floats.iter().chain([&odd]).flat_map(|x| x.to_le_bytes()).collect();
            assert_eq!(common_exponent(&bytes), None, "{odd}");
        }
    }
}
