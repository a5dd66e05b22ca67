//! Positions as whole numbers: a cubic grid over the bounds of a mesh.
//!
//! A coordinate `q` stands for `origin + q * step`, worked out in f64 and rounded to f32 once, which is the same number
//! on every machine. The grid is never finer than the floats of the mesh: where a step would be lost in rounding, it
//! becomes a power of two of which all points are multiples. So a place on the grid is told from all others, and
//! quantizing it gives its coordinates again. What is lost to the grid can be kept beside it: the
//! **correction** counts the floats between a place and the exact coordinate.
//!
//! Differs from the usual grids of coders: the step is the same along all axes, and a tolerance is kept with all
//! rounding counted in.

use striata::mesh::Bounds;

use crate::entropy::{AdaptiveNumber, Coder, Rate};

/// The most bits a coordinate may take.
pub(crate) const MAX_BITS: u32 = 24;

/// Why there is no grid as asked for.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GridError {
    /// The number of bits is none that coordinates can have.
    #[error("{bits} bits a coordinate asked for, but it must be 1 to {MAX_BITS}")]
    Bits {
        /// Bits asked for.
        bits: u32,
    },
    /// The tolerance is no length.
    #[error("a tolerance of {tolerance} asked for, but it must be above 0 and finite")]
    NoTolerance {
        /// What was asked for.
        tolerance: f64,
    },
    /// No grid is fine enough.
    #[error(
        "a tolerance of {tolerance} asked for, but the finest grid is up to {least} off: exact positions are what helps"
    )]
    Tolerance {
        /// What was asked for, mesh units.
        tolerance: f64,
        /// What can be kept, mesh units.
        least: f64,
    },
    /// A number of the grid is none that a grid has.
    #[error("the grid's {what} is {value}, which no grid has")]
    Malformed {
        /// Which number.
        what: &'static str,
        /// What stands there.
        value: f64,
    },
}

/// The points `origin + q * step` of a line, `q` from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axis {
    /// The place of 0.
    pub(crate) origin: f32,
    /// From one point to the next, above 0.
    pub(crate) step: f64,
}

impl Axis {
    /// The number nearest to a place, within 0 to `limit`; 0 for what is no number.
    pub(crate) fn quantize(self, place: f32, limit: i32) -> i32 {
        let q = ((f64::from(place) - f64::from(self.origin)) / self.step + 0.5).floor();
        // The cast takes what is no number for 0.
        (q.clamp(0.0, f64::from(limit))) as i32
    }

    /// The place of a number; always finite.
    pub(crate) fn place(self, q: i32) -> f32 {
        let place = f64::from(self.origin) + f64::from(q) * self.step;
        place.clamp(f64::from(-f32::MAX), f64::from(f32::MAX)) as f32
    }

    /// Axes over ranges of finite numbers, with one step for all, and the bits that their numbers take.
    ///
    /// The step is at least `least_step`, and as much longer as floats and `bits` need.
    pub(crate) fn over(ranges: &[(f32, f32)], least_step: f64, bits: u32) -> (Vec<Self>, u32) {
        let largest = ranges.iter().fold(0.0f32, |m, r| m.max(r.0.abs()).max(r.1.abs()));
        let unit = float_step(largest);
        let extent = ranges.iter().fold(0.0f64, |m, r| m.max(f64::from(r.1) - f64::from(r.0)));
        let limit = (1u32 << bits) - 1;
        let mut step = least_step.max(extent / f64::from(limit));
        let is_fine = step < 2.0 * unit;
        if is_fine {
            step = if step <= unit { unit } else { 2.0 * unit };
        }
        loop {
            let origin =
                |low: f32| if is_fine { (f64::from(low) / unit).floor() * unit } else { f64::from(low) };
            let axes: Vec<_> = ranges.iter().map(|r| Self { origin: origin(r.0) as f32, step }).collect();
            let most =
                axes.iter().zip(ranges).map(|(axis, r)| axis.quantize(r.1, i32::MAX)).max().unwrap_or(0);
            if most as u32 <= limit {
                return (axes, (most as u32 + 1).next_power_of_two().ilog2().max(1));
            }
            step *= 2.0;
        }
    }

    /// The axis, if its numbers are such as an axis can have.
    pub(crate) fn check(self) -> Result<Self, GridError> {
        if !self.origin.is_finite() {
            return Err(GridError::Malformed { what: "origin", value: f64::from(self.origin) });
        }
        if !(self.step.is_normal() && self.step > 0.0 && self.step <= 2.0 * f64::from(f32::MAX)) {
            return Err(GridError::Malformed { what: "step", value: self.step });
        }
        Ok(self)
    }
}

/// The distance from a float to the next larger one.
fn float_step(x: f32) -> f64 {
    f64::from(f32::from_bits((x.abs().to_bits() & 0x7F80_0000).max(0x0080_0000))) / f64::from(1u32 << 23)
}

/// The grid of a mesh's positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PositionGrid {
    /// The place of (0, 0, 0), mesh units.
    pub(crate) origin: [f32; 3],
    /// From one point to the next along every axis, mesh units.
    pub(crate) step: f64,
    /// Bits that hold every coordinate.
    pub(crate) bits: u32,
}

impl PositionGrid {
    /// A grid of so many bits over the bounds; fewer where floats have no more.
    ///
    /// # Errors
    /// [`GridError::Bits`].
    pub(crate) fn from_bits(bounds: &Bounds, bits: u32) -> Result<Self, GridError> {
        if !(1..=MAX_BITS).contains(&bits) {
            return Err(GridError::Bits { bits });
        }
        Ok(Self::over(bounds, 0.0, bits))
    }

    /// The coarsest cubic grid that no point of the bounds is farther off than the tolerance, in mesh units.
    ///
    /// # Errors
    /// [`GridError`] where there is none.
    pub(crate) fn from_tolerance(bounds: &Bounds, tolerance: f64) -> Result<Self, GridError> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(GridError::NoTolerance { tolerance });
        }
        let largest = (0..3).fold(0.0f32, |m, a| m.max(bounds.min[a].abs()).max(bounds.max[a].abs()));
        // Half a step along each axis, and half a float where the place is rounded.
        let step = 2.0 * tolerance / 3f64.sqrt() * (1.0 - 1e-12) - float_step(largest);
        let grid = Self::over(bounds, step.max(0.0), MAX_BITS);
        let least = grid.largest_distance(largest);
        if least > tolerance { Err(GridError::Tolerance { tolerance, least }) } else { Ok(grid) }
    }

    fn over(bounds: &Bounds, least_step: f64, bits: u32) -> Self {
        let ranges = [0, 1, 2].map(|a| (bounds.min[a], bounds.max[a]));
        let (axes, bits) = Axis::over(&ranges, least_step, bits);
        Self { origin: [axes[0].origin, axes[1].origin, axes[2].origin], step: axes[0].step, bits }
    }

    /// The farthest that a place may be from what it stands for.
    fn largest_distance(&self, largest_coordinate: f32) -> f64 {
        let unit = float_step(largest_coordinate);
        let rounding = if self.step <= 2.0 * unit { 0.0 } else { unit };
        3f64.sqrt() * 0.5 * (self.step + rounding)
    }

    fn axis(&self, axis: usize) -> Axis {
        Axis { origin: self.origin[axis], step: self.step }
    }

    /// The point nearest to a position within the bounds.
    pub(crate) fn quantize(&self, position: [f32; 3]) -> [i32; 3] {
        let limit = ((1u32 << self.bits) - 1) as i32;
        [0, 1, 2].map(|a| self.axis(a).quantize(position[a], limit))
    }

    /// The place of a point; always finite.
    pub(crate) fn place(&self, point: [i32; 3]) -> [f32; 3] {
        [0, 1, 2].map(|a| self.axis(a).place(point[a]))
    }

    /// Whether a point is one of the grid's.
    #[inline]
    pub(crate) fn holds(&self, point: [i32; 3]) -> bool {
        (point[0] | point[1] | point[2]) as u32 >> self.bits == 0
    }

    /// The grid, if its numbers are such as a grid can have: for what was read.
    ///
    /// # Errors
    /// [`GridError`] naming the number.
    pub(crate) fn check(self) -> Result<Self, GridError> {
        if !(1..=MAX_BITS).contains(&self.bits) {
            return Err(GridError::Bits { bits: self.bits });
        }
        (0..3).try_for_each(|a| self.axis(a).check().map(|_| ()))?;
        Ok(self)
    }
}

/// Floats as integers in the same order; every bit pattern has one, and the way back is the same.
#[inline]
pub(crate) fn ordered(x: f32) -> i32 {
    let bits = x.to_bits() as i32;
    bits ^ (((bits >> 31) as u32) >> 1) as i32
}

/// The float of an integer of [`ordered`].
#[inline]
pub(crate) fn from_ordered(x: i32) -> f32 {
    f32::from_bits((x ^ (((x >> 31) as u32) >> 1) as i32) as u32)
}

/// How many floats the exact number lies above the decoded one.
#[inline]
pub(crate) fn exact_correction(exact: f32, decoded: f32) -> i32 {
    ordered(exact).wrapping_sub(ordered(decoded))
}

/// The exact number from the decoded one and what [`exact_correction`] said.
#[inline]
pub(crate) fn corrected(decoded: f32, correction: i32) -> f32 {
    from_ordered(ordered(decoded).wrapping_add(correction))
}

/// Codes what grid points lack of exact positions.
#[derive(Clone, Debug)]
pub(crate) struct CorrectionModel {
    numbers: AdaptiveNumber,
}

impl CorrectionModel {
    /// Nothing learned.
    pub(crate) fn new() -> Self {
        Self { numbers: AdaptiveNumber::new(32, Rate::Steady) }
    }

    /// Codes the exact position of a point; a reader's `exact` is ignored.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        grid: &PositionGrid,
        point: [i32; 3],
        exact: [f32; 3],
    ) -> [f32; 3] {
        let decoded = grid.place(point);
        [0, 1, 2].map(|a| {
            // As many floats as lie within half a step: where coordinates are small there are more.
            let floats = (grid.step / float_step(decoded[a])).min(f64::from(i32::MAX)) as u32;
            let context = floats.max(1).ilog2() as usize;
            let correction = self.numbers.signed(coder, context, exact_correction(exact[a], decoded[a]));
            // Only damaged streams lead beyond the numbers.
            Some(corrected(decoded[a], correction)).filter(|x| x.is_finite()).unwrap_or(decoded[a])
        })
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;
    use crate::entropy::{RangeReader, RangeWriter};

    fn cloud(scale: f32, offset: f32, seed: u64) -> Vec<[f32; 3]> {
        let mut random = Random::new(seed);
        (0..300).map(|_| [1.0, 0.3, 0.01].map(|s| (random.between(-1.0, 1.0) * s * scale) + offset)).collect()
    }

    fn clouds() -> Vec<Vec<[f32; 3]>> {
        let mut all: Vec<_> = [1e-44, 1e-38, 1e-30, 1e-3, 1.0, 1e7, 1e30, 3.4e38]
            .into_iter()
            .flat_map(|scale| [0.0, 0.7 * scale].map(|offset| cloud(scale / 2.0, offset / 2.0, 5)))
            .collect();
        all.extend([1e3, 1e6, -1e6, -1e12].map(|offset| cloud(1.0, offset, 6)));
        all.push(vec![[3.5, -2.0, 1e9]]);
        all.push(vec![[0.0; 3]]);
        all.push(vec![[f32::MAX; 3], [-f32::MAX; 3], [0.0; 3], [1.0, f32::MAX, 0.3 * f32::MAX]]);
        all.push(vec![[0.0, 1.0, 2.0], [0.0, 1.0, 3.0], [0.0, 1.0, 2.4]]);
        all
    }

    fn off(p: [f32; 3], q: [f32; 3]) -> f64 {
        (0..3).map(|a| (f64::from(p[a]) - f64::from(q[a])).powi(2)).sum::<f64>().sqrt()
    }

    #[test]
    fn places_are_told_apart_and_within_half_a_step() {
        for (index, cloud) in clouds().iter().enumerate() {
            let bounds = Bounds::of(cloud).unwrap();
            for bits in 1..=24 {
                let grid = PositionGrid::from_bits(&bounds, bits).unwrap();
                assert_eq!(grid.check(), Ok(grid));
                assert!(grid.bits <= bits, "cloud {index}, {bits} bits: {grid:?}");
                for &p in cloud {
                    let q = grid.quantize(p);
                    assert!(q.iter().all(|&x| (0..1i64 << grid.bits).contains(&i64::from(x))));
                    let place = grid.place(q);
                    assert_eq!(grid.quantize(place), q, "cloud {index}, {bits} bits, {p:?}, {grid:?}");
                    let largest = grid.largest_distance(
                        bounds.min.iter().chain(&bounds.max).fold(0.0, |m, x| x.abs().max(m)),
                    );
                    assert!(off(place, p) <= largest * (1.0 + 1e-9), "cloud {index}: {p:?} {place:?}");
                }
            }
        }
    }

    #[test]
    fn the_step_is_the_extent_divided() {
        let bounds = Bounds { min: [0.0, -1.0, 5.0], max: [1.0, 1.0, 5.5] };
        let grid = PositionGrid::from_bits(&bounds, 12).unwrap();
        assert_eq!((grid.step, grid.bits, grid.origin), (2.0 / 4095.0, 12, bounds.min));
        assert_eq!(grid.quantize(bounds.max), [2048, 4095, 1024]);
        assert_eq!(PositionGrid::from_bits(&bounds, 0), Err(GridError::Bits { bits: 0 }));
        assert_eq!(PositionGrid::from_bits(&bounds, 25), Err(GridError::Bits { bits: 25 }));
    }

    #[test]
    fn tolerances_are_kept_and_used() {
        for cloud in clouds() {
            let bounds = Bounds::of(&cloud).unwrap();
            for share in [0.3, 1e-2, 1e-4, 1e-6] {
                let tolerance = bounds.diagonal() * share;
                match PositionGrid::from_tolerance(&bounds, tolerance) {
                    Ok(grid) => {
                        for &p in &cloud {
                            assert!(off(grid.place(grid.quantize(p)), p) <= tolerance, "{grid:?} {p:?}");
                        }
                    }
                    Err(GridError::Tolerance { least, .. }) => assert!(least > tolerance),
                    Err(GridError::NoTolerance { .. }) => assert_eq!(tolerance, 0.0),
                    Err(other) => panic!("{other}"),
                }
            }
        }
        let bounds = Bounds { min: [0.0; 3], max: [1.0; 3] };
        let grid = PositionGrid::from_tolerance(&bounds, 1e-3).unwrap();
        assert!(grid.bits == 10 && (grid.step - 1.1547e-3).abs() < 1e-6, "{grid:?}");
        assert!(PositionGrid::from_tolerance(&bounds, 1e-9).is_err());
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(PositionGrid::from_tolerance(&bounds, bad), Err(GridError::NoTolerance { .. })));
        }
    }

    #[test]
    fn bad_grids_are_refused() {
        let good = PositionGrid { origin: [0.0; 3], step: 1.0, bits: 12 };
        for bad in [
            PositionGrid { step: 0.0, ..good },
            PositionGrid { step: -1.0, ..good },
            PositionGrid { step: f64::NAN, ..good },
            PositionGrid { step: f64::INFINITY, ..good },
            PositionGrid { bits: 25, ..good },
            PositionGrid { bits: 0, ..good },
            PositionGrid { origin: [0.0, f32::NAN, 0.0], ..good },
        ] {
            assert!(bad.check().is_err(), "{bad:?}");
        }
        let wild = PositionGrid { origin: [f32::MAX; 3], step: 6e38, bits: 24 };
        assert!(wild.place([i32::MAX, i32::MIN, 5]).iter().all(|x| x.is_finite()));
    }

    #[test]
    fn corrections_give_every_float_again() {
        let mut random = Random::new(1);
        for _ in 0..2000 {
            let [a, b] = [(); 2].map(|()| f32::from_bits(random.next_u64() as u32));
            assert_eq!(corrected(a, exact_correction(b, a)).to_bits(), b.to_bits());
        }
        let rising = [f32::NEG_INFINITY, -2.0, -1e-40, -0.0, 0.0, 1e-40, 2.0, f32::INFINITY].map(ordered);
        assert!(rising.windows(2).all(|w| w[0] < w[1]));
        assert_eq!(exact_correction(0.0, -0.0), 1);
    }

    #[test]
    fn exact_positions_come_back_and_cost_what_the_grid_lacks() {
        for (index, cloud) in clouds().iter().enumerate() {
            let grid = PositionGrid::from_bits(&Bounds::of(cloud).unwrap(), 14).unwrap();
            let mut writer = RangeWriter::new();
            let mut model = CorrectionModel::new();
            for &p in cloud {
                model.code(&mut writer, &grid, grid.quantize(p), p);
            }
            let (bytes, _) = writer.finish();
            let mut reader = RangeReader::new(&bytes, true);
            let mut model = CorrectionModel::new();
            for &p in cloud {
                let read = model.code(&mut reader, &grid, grid.quantize(p), [0.0; 3]);
                assert_eq!(read.map(f32::to_bits), p.map(f32::to_bits), "cloud {index}");
            }
            // A float has 32 bits, the grid tells up to 14 of them.
            assert!(bytes.len() as f64 * 8.0 < 3.0 * 24.0 * cloud.len() as f64 + 400.0, "cloud {index}");
        }
    }
}
