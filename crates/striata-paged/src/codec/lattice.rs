//! The coarsest lattice that contains all positions of a page.
//!
//! Samples of a raster, and the corners of many models, lie on a lattice that is much coarser than the grid of the
//! file. Coordinates are coded in its units.

use crate::bytes::{put_varint, take_varint};
use crate::{Metadata, Page};

/// Upper bound of coordinates, as multiples of the grid step or as ordered bits.
const LARGEST: i64 = 1 << 50;

/// For each axis, the first coordinate and the distance between neighboring ones, in units of the grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Lattice {
    base: [i64; 3],
    step: [i64; 3],
}

impl Lattice {
    /// The lattice of a page.
    pub(super) fn of(page: &Page, metadata: &Metadata) -> Self {
        let mut positions = page.positions.iter().map(|&p| grid_place(p, metadata));
        let base = positions.next().unwrap_or_default();
        let mut step = [0; 3];
        for place in positions {
            for axis in 0..3 {
                step[axis] = greatest_common_divisor(step[axis], (place[axis] - base[axis]).abs());
            }
        }
        Self { base, step: step.map(|step| step.max(1)) }
    }

    /// Writes the lattice.
    pub(super) fn put(&self, bytes: &mut Vec<u8>) {
        for axis in 0..3 {
            let base = self.base[axis];
            put_varint(bytes, base.unsigned_abs() << 1 | u64::from(base < 0));
            put_varint(bytes, self.step[axis] as u64);
        }
    }

    /// Reads a lattice; `None` if the bytes end early or do not describe one.
    pub(super) fn take(bytes: &mut &[u8]) -> Option<Self> {
        let mut lattice = Self { base: [0; 3], step: [1; 3] };
        for axis in 0..3 {
            let base = take_varint(bytes)?;
            let magnitude = i64::try_from(base >> 1).ok()?;
            lattice.base[axis] = if base & 1 == 0 { magnitude } else { -magnitude };
            lattice.step[axis] = i64::try_from(take_varint(bytes)?).ok()?;
        }
        let is_possible = lattice.base.iter().all(|x| x.abs() <= LARGEST)
            && lattice.step.iter().all(|&x| (1..=LARGEST).contains(&x));
        is_possible.then_some(lattice)
    }

    /// Coordinates of a position in units of the lattice.
    pub(super) fn place_of(&self, position: [f32; 3], metadata: &Metadata) -> [i64; 3] {
        let place = grid_place(position, metadata);
        std::array::from_fn(|axis| (place[axis] - self.base[axis]) / self.step[axis])
    }

    /// The position with some coordinates.
    pub(super) fn position_of(&self, place: [i64; 3], metadata: &Metadata) -> [f32; 3] {
        // Damaged bytes must not overflow.
        let place: [i64; 3] = std::array::from_fn(|axis| {
            let offset = place[axis].saturating_mul(self.step[axis]).clamp(-2 * LARGEST, 2 * LARGEST);
            (self.base[axis] + offset).clamp(-LARGEST, LARGEST)
        });
        match &metadata.grid {
            Some(grid) => grid.position_of(place),
            None => place.map(from_ordered),
        }
    }
}

/// Coordinates in units of the grid, or as ordered bits.
fn grid_place(position: [f32; 3], metadata: &Metadata) -> [i64; 3] {
    match &metadata.grid {
        Some(grid) => grid.index_of(position),
        None => position.map(ordered),
    }
}

/// The bits of a number, in the order of numbers.
pub(super) fn ordered(x: f32) -> i64 {
    let bits = i64::from(x.to_bits() & 0x7FFF_FFFF);
    if x.is_sign_negative() { -bits } else { bits }
}

/// The number with these ordered bits; 0 if it would not be finite.
pub(super) fn from_ordered(place: i64) -> f32 {
    let magnitude = f32::from_bits(place.unsigned_abs().min(0x7FFF_FFFF) as u32);
    let value = if place < 0 { -magnitude } else { magnitude };
    if value.is_finite() { value } else { 0.0 }
}

/// The bits of a double, in the order of numbers.
pub(super) fn ordered_double(x: f64) -> i64 {
    let bits = (x.to_bits() & i64::MAX as u64) as i64;
    if x.is_sign_negative() { -bits } else { bits }
}

/// The double with these ordered bits; 0 if it would not be finite.
pub(super) fn from_ordered_double(place: i64) -> f64 {
    let magnitude = f64::from_bits(place.unsigned_abs().min(i64::MAX as u64));
    let value = if place < 0 { -magnitude } else { magnitude };
    if value.is_finite() { value } else { 0.0 }
}

fn greatest_common_divisor(mut a: i64, mut b: i64) -> i64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lattices_round_trip() {
        for lattice in [
            Lattice { base: [0; 3], step: [1; 3] },
            Lattice { base: [-5, LARGEST, -LARGEST], step: [256, 1, LARGEST] },
        ] {
            let mut bytes = Vec::new();
            lattice.put(&mut bytes);
            assert_eq!(Lattice::take(&mut &bytes[..]), Some(lattice));
            assert_eq!(Lattice::take(&mut &bytes[..bytes.len() - 1]), None);
        }
        let mut bytes = Vec::new();
        Lattice { base: [0; 3], step: [0, 1, 1] }.put(&mut bytes);
        assert_eq!(Lattice::take(&mut &bytes[..]), None);
    }

    #[test]
    fn divisors_of_differences() {
        assert_eq!(greatest_common_divisor(0, 12), 12);
        assert_eq!(greatest_common_divisor(18, 12), 6);
    }
}
