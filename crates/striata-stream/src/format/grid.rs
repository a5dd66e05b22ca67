//! The position grid: quantization of positions to integers on a cubic grid over the bounds of a mesh.
//!
//! Coordinate `q` stands for `origin + q * step`, evaluated in f64 and rounded to f32 once, which gives the
//! same float on every machine. The grid is never finer than the floats of the mesh: if a step would be
//! lost in rounding, it is replaced by a power of two that divides all points. Distinct grid points
//! therefore have distinct positions, and quantizing the position of a grid point returns that point. For
//! lossless positions, a **correction** is stored in addition: the number of floats between the grid
//! point's position and the exact coordinate.
//!
//! Differs from the usual grids of coders: the step is the same along all axes, and a tolerance is
//! guaranteed with all rounding included.

use striata::mesh::Bounds;

use crate::entropy::{AdaptiveNumber, Coder, Rate};

/// Maximum number of bits per coordinate.
pub(crate) const MAX_BITS: u32 = 24;

/// Why a position grid cannot be made or is invalid.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GridError {
    /// The number of bits per coordinate is out of range.
    #[error("{bits} bits per coordinate requested, but the range is 1 to {MAX_BITS}")]
    Bits {
        /// The requested number of bits.
        bits: u32,
    },
    /// The tolerance is not a positive finite length.
    #[error("a tolerance of {tolerance} requested, but it must be positive and finite")]
    NoTolerance {
        /// The requested tolerance, mesh units.
        tolerance: f64,
    },
    /// Even the finest grid exceeds the tolerance.
    #[error(
        "a tolerance of {tolerance} requested, but even the finest grid is off by up to {min_tolerance}; \
         use exact positions instead"
    )]
    Tolerance {
        /// The requested tolerance, mesh units.
        tolerance: f64,
        /// The smallest tolerance that can be guaranteed, mesh units.
        min_tolerance: f64,
    },
    /// A lattice has too many points within the mesh, or is finer than floats are.
    #[error("a step of {step} requested, but a mesh of this size needs one of at least {least_step}")]
    Step {
        /// The requested step, mesh units.
        step: f64,
        /// The smallest step that is possible, mesh units.
        least_step: f64,
    },
    /// A parameter of the grid is out of range.
    #[error("the grid's {what} is {value}, which is out of range")]
    Malformed {
        /// Name of the parameter.
        what: &'static str,
        /// Its value.
        value: f64,
    },
}

/// A one-dimensional grid: the points `origin + q * step` for `q >= 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axis {
    /// Position of `q == 0`.
    pub origin: f32,
    /// Distance between neighboring points, above 0.
    pub step: f64,
}

impl Axis {
    /// Returns the grid coordinate nearest to a position, clamped to `0..=limit`; 0 for NaN.
    pub(crate) fn quantize(self, position: f32, limit: i32) -> i32 {
        let q = ((f64::from(position) - f64::from(self.origin)) / self.step + 0.5).floor();
        // The cast maps NaN to 0.
        (q.clamp(0.0, f64::from(limit))) as i32
    }

    /// Returns the position of a grid coordinate; always finite.
    pub(crate) fn position(self, q: i32) -> f32 {
        let position = f64::from(self.origin) + f64::from(q) * self.step;
        position.clamp(f64::from(-f32::MAX), f64::from(f32::MAX)) as f32
    }

    /// Makes axes over ranges of finite numbers, all with the same step, and the number of bits that
    /// coordinates need.
    ///
    /// The step is at least `least_step`; it is made longer if float precision or `bits` requires it.
    pub(crate) fn over(ranges: &[(f32, f32)], least_step: f64, bits: u32) -> (Vec<Self>, u32) {
        let largest = ranges.iter().fold(0.0f32, |m, r| m.max(r.0.abs()).max(r.1.abs()));
        let unit = float_step(largest);
        let extent = ranges.iter().fold(0.0f64, |m, r| m.max(f64::from(r.1) - f64::from(r.0)));
        let limit = (1u32 << bits) - 1;
        let mut step = least_step.max(extent / f64::from(limit));
        let is_float_limited = step < 2.0 * unit;
        if is_float_limited {
            step = if step <= unit { unit } else { 2.0 * unit };
        }
        loop {
            let origin = |low: f32| {
                if is_float_limited { (f64::from(low) / unit).floor() * unit } else { f64::from(low) }
            };
            let axes: Vec<_> = ranges.iter().map(|r| Self { origin: origin(r.0) as f32, step }).collect();
            let max =
                axes.iter().zip(ranges).map(|(axis, r)| axis.quantize(r.1, i32::MAX)).max().unwrap_or(0);
            if max as u32 <= limit {
                return (axes, (max as u32 + 1).next_power_of_two().ilog2().max(1));
            }
            step *= 2.0;
        }
    }

    /// Makes axes like [`over`](Self::over), but so that zero is a grid point and decodes exactly. The step is
    /// a power of two, at most twice as fine as needed. `None` if a range lies on one side of zero, or if there
    /// is no such grid.
    pub(crate) fn through_zero(ranges: &[(f32, f32)], bits: u32) -> Option<(Vec<Self>, u32)> {
        let extent = ranges.iter().fold(0.0f64, |m, r| m.max(f64::from(r.1) - f64::from(r.0)));
        let longest_step = extent / f64::from((1u32 << bits) - 1);
        let step = power_of_two(longest_step);
        if ranges.iter().any(|r| r.0 > 0.0 || r.1 < 0.0) || step < f64::from(f32::MIN_POSITIVE) {
            return None;
        }
        let below_zero = |low: f32| (f64::from(low) / step).round() * step;
        let axes: Vec<_> =
            ranges.iter().map(|r| Self { origin: below_zero(r.0) as f32 + 0.0, step }).collect();
        let max = axes.iter().zip(ranges).map(|(axis, r)| axis.quantize(r.1, i32::MAX)).max()?;
        let bits = (max as u32 + 1).next_power_of_two().ilog2().max(1);
        (bits <= MAX_BITS).then_some((axes, bits))
    }

    /// Returns the axis if its origin and step are valid.
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

/// Returns the largest power of two up to a positive number.
fn power_of_two(number: f64) -> f64 {
    // Clears the mantissa.
    f64::from_bits(number.to_bits() & 0x7FF0_0000_0000_0000)
}

/// Returns the distance from `|x|` to the next larger float.
fn float_step(x: f32) -> f64 {
    f64::from(f32::from_bits((x.abs().to_bits() & 0x7F80_0000).max(0x0080_0000))) / f64::from(1u32 << 23)
}

/// The grid of a mesh's positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PositionGrid {
    /// Position of grid point (0, 0, 0), mesh units.
    pub origin: [f32; 3],
    /// Distance between neighboring points along each axis, mesh units.
    pub step: f64,
    /// Number of bits of a coordinate.
    pub bits: u32,
}

impl PositionGrid {
    /// Makes a grid with `bits` bits per coordinate over the bounds, or fewer if floats have no higher
    /// precision there.
    ///
    /// # Errors
    /// [`GridError::Bits`] if `bits` is out of range.
    pub(crate) fn from_bits(bounds: &Bounds, bits: u32) -> Result<Self, GridError> {
        if !(1..=MAX_BITS).contains(&bits) {
            return Err(GridError::Bits { bits });
        }
        Ok(Self::over(bounds, 0.0, bits))
    }

    /// Makes the coarsest cubic grid on which no point of the bounds moves by more than the tolerance, in
    /// mesh units.
    ///
    /// # Errors
    /// [`GridError`] if the tolerance is invalid or no grid is fine enough.
    pub(crate) fn from_tolerance(bounds: &Bounds, tolerance: f64) -> Result<Self, GridError> {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(GridError::NoTolerance { tolerance });
        }
        let largest = (0..3).fold(0.0f32, |m, a| m.max(bounds.min[a].abs()).max(bounds.max[a].abs()));
        // Quantizing moves a position by up to half a step per axis, and rounding it to floats by up to half
        // the distance between two floats.
        let step = 2.0 * tolerance / 3f64.sqrt() * (1.0 - 1e-12) - float_step(largest);
        let grid = Self::over(bounds, step.max(0.0), MAX_BITS);
        let min_tolerance = grid.largest_distance(largest);
        if min_tolerance > tolerance {
            Err(GridError::Tolerance { tolerance, min_tolerance })
        } else {
            Ok(grid)
        }
    }

    /// Makes a grid of points that are multiples of a power of two, the next one below a length in mesh units,
    /// after they have been moved by an offset.
    ///
    /// # Errors
    /// [`GridError::Step`] if the step is too small for the mesh.
    pub(crate) fn on_lattice(bounds: &Bounds, step: f64, offset: [f64; 3]) -> Result<Self, GridError> {
        let least_step = Self::over(bounds, 0.0, MAX_BITS).step * 2.0;
        let wanted = step;
        let step = power_of_two(step);
        if !(step >= least_step && step.is_normal()) {
            return Err(GridError::Step { step: wanted, least_step });
        }
        let origin = [0, 1, 2].map(|a| {
            let low = f64::from(bounds.min[a]) + offset[a];
            ((low / step).floor() * step - offset[a]) as f32
        });
        let grid = Self { origin, step, bits: MAX_BITS };
        let last = grid.quantize(bounds.max).into_iter().max().unwrap_or(0);
        Ok(Self { bits: (last as u32 + 1).next_power_of_two().ilog2().max(1), ..grid })
    }

    fn over(bounds: &Bounds, least_step: f64, bits: u32) -> Self {
        let ranges = [0, 1, 2].map(|a| (bounds.min[a], bounds.max[a]));
        let (axes, bits) = Axis::over(&ranges, least_step, bits);
        Self { origin: [axes[0].origin, axes[1].origin, axes[2].origin], step: axes[0].step, bits }
    }

    /// Returns an upper bound of the distance from a point to its quantized position.
    fn largest_distance(&self, largest_coordinate: f32) -> f64 {
        let unit = float_step(largest_coordinate);
        let rounding = if self.step <= 2.0 * unit { 0.0 } else { unit };
        3f64.sqrt() * 0.5 * (self.step + rounding)
    }

    fn axis(&self, axis: usize) -> Axis {
        Axis { origin: self.origin[axis], step: self.step }
    }

    /// Returns the grid point nearest to a position within the bounds.
    pub(crate) fn quantize(&self, position: [f32; 3]) -> [i32; 3] {
        let limit = ((1u32 << self.bits) - 1) as i32;
        [0, 1, 2].map(|a| self.axis(a).quantize(position[a], limit))
    }

    /// Returns the position of a grid point; always finite.
    pub(crate) fn position(&self, point: [i32; 3]) -> [f32; 3] {
        [0, 1, 2].map(|a| self.axis(a).position(point[a]))
    }

    /// Whether a point lies on the grid.
    #[inline]
    pub(crate) fn contains(&self, point: [i32; 3]) -> bool {
        (point[0] | point[1] | point[2]) as u32 >> self.bits == 0
    }

    /// Returns the grid if its parameters are valid: for grids read from a stream.
    ///
    /// # Errors
    /// [`GridError`] that names the invalid parameter.
    pub(crate) fn check(self) -> Result<Self, GridError> {
        if !(1..=MAX_BITS).contains(&self.bits) {
            return Err(GridError::Bits { bits: self.bits });
        }
        (0..3).try_for_each(|a| self.axis(a).check().map(|_| ()))?;
        Ok(self)
    }
}

/// Maps a float to an integer such that the order is preserved; a bijection on bit patterns.
#[inline]
pub(crate) fn float_to_ordered(x: f32) -> i32 {
    let bits = x.to_bits() as i32;
    bits ^ (((bits >> 31) as u32) >> 1) as i32
}

/// Maps an integer from [`float_to_ordered`] back to its float.
#[inline]
pub(crate) fn ordered_to_float(x: i32) -> f32 {
    f32::from_bits((x ^ (((x >> 31) as u32) >> 1) as i32) as u32)
}

/// Returns the number of floats between the decoded and the exact coordinate; positive if the exact one is
/// larger.
#[inline]
fn exact_correction(exact: f32, decoded: f32) -> i32 {
    float_to_ordered(exact).wrapping_sub(float_to_ordered(decoded))
}

/// Returns the exact coordinate, given the decoded one and the result of [`exact_correction`].
#[inline]
pub(crate) fn corrected(decoded: f32, correction: i32) -> f32 {
    ordered_to_float(float_to_ordered(decoded).wrapping_add(correction))
}

/// Codes the corrections from grid points to exact positions.
#[derive(Clone, Debug)]
pub(crate) struct CorrectionModel {
    numbers: AdaptiveNumber,
}

impl CorrectionModel {
    /// Creates an untrained model.
    pub(crate) fn new() -> Self {
        Self { numbers: AdaptiveNumber::new(32, Rate::Steady) }
    }

    /// Codes the exact position of a grid point; a reader's `exact` is ignored.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        grid: &PositionGrid,
        point: [i32; 3],
        exact: [f32; 3],
    ) -> [f32; 3] {
        let decoded = grid.position(point);
        [0, 1, 2].map(|a| {
            // The context is the number of floats within a step, which is larger for small coordinates.
            let floats = (grid.step / float_step(decoded[a])).min(f64::from(i32::MAX)) as u32;
            let context = floats.max(1).ilog2() as usize;
            let correction = self.numbers.signed(coder, context, exact_correction(exact[a], decoded[a]));
            // Only damaged streams contain corrections beyond the finite floats.
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

    fn distance(p: [f32; 3], q: [f32; 3]) -> f64 {
        (0..3).map(|a| (f64::from(p[a]) - f64::from(q[a])).powi(2)).sum::<f64>().sqrt()
    }

    #[test]
    fn grid_points_have_distinct_positions_within_half_a_step() {
        for (index, cloud) in clouds().iter().enumerate() {
            let bounds = Bounds::of(cloud).unwrap();
            for bits in 1..=24 {
                let grid = PositionGrid::from_bits(&bounds, bits).unwrap();
                assert_eq!(grid.check(), Ok(grid));
                assert!(grid.bits <= bits, "cloud {index}, {bits} bits: {grid:?}");
                for &p in cloud {
                    let q = grid.quantize(p);
                    assert!(q.iter().all(|&x| (0..1i64 << grid.bits).contains(&i64::from(x))));
                    let position = grid.position(q);
                    assert_eq!(grid.quantize(position), q, "cloud {index}, {bits} bits, {p:?}, {grid:?}");
                    let largest = grid.largest_distance(
                        bounds.min.iter().chain(&bounds.max).fold(0.0, |m, x| x.abs().max(m)),
                    );
                    assert!(
                        distance(position, p) <= largest * (1.0 + 1e-9),
                        "cloud {index}: {p:?} {position:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_step_divides_the_largest_extent() {
        let bounds = Bounds { min: [0.0, -1.0, 5.0], max: [1.0, 1.0, 5.5] };
        let grid = PositionGrid::from_bits(&bounds, 12).unwrap();
        assert_eq!((grid.step, grid.bits, grid.origin), (2.0 / 4095.0, 12, bounds.min));
        assert_eq!(grid.quantize(bounds.max), [2048, 4095, 1024]);
        assert_eq!(PositionGrid::from_bits(&bounds, 0), Err(GridError::Bits { bits: 0 }));
        assert_eq!(PositionGrid::from_bits(&bounds, 25), Err(GridError::Bits { bits: 25 }));
    }

    #[test]
    fn tolerances_are_guaranteed_and_used_up() {
        for cloud in clouds() {
            let bounds = Bounds::of(&cloud).unwrap();
            for share in [0.3, 1e-2, 1e-4, 1e-6] {
                let tolerance = bounds.diagonal() * share;
                match PositionGrid::from_tolerance(&bounds, tolerance) {
                    Ok(grid) => {
                        for &p in &cloud {
                            assert!(
                                distance(grid.position(grid.quantize(p)), p) <= tolerance,
                                "{grid:?} {p:?}"
                            );
                        }
                    }
                    Err(GridError::Tolerance { min_tolerance, .. }) => assert!(min_tolerance > tolerance),
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
    fn invalid_grids_are_rejected() {
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
        let extreme = PositionGrid { origin: [f32::MAX; 3], step: 6e38, bits: 24 };
        assert!(extreme.position([i32::MAX, i32::MIN, 5]).iter().all(|x| x.is_finite()));
    }

    #[test]
    fn corrections_restore_every_float() {
        let mut random = Random::new(1);
        for _ in 0..2000 {
            let [a, b] = [(); 2].map(|()| f32::from_bits(random.next_u64() as u32));
            assert_eq!(corrected(a, exact_correction(b, a)).to_bits(), b.to_bits());
        }
        let rising =
            [f32::NEG_INFINITY, -2.0, -1e-40, -0.0, 0.0, 1e-40, 2.0, f32::INFINITY].map(float_to_ordered);
        assert!(rising.windows(2).all(|w| w[0] < w[1]));
        assert_eq!(exact_correction(0.0, -0.0), 1);
    }

    #[test]
    fn exact_positions_round_trip_and_cost_only_the_missing_bits() {
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
            // A float has 32 bits; the grid already gives up to 14 of them.
            assert!(bytes.len() as f64 * 8.0 < 3.0 * 24.0 * cloud.len() as f64 + 400.0, "cloud {index}");
        }
    }
}
