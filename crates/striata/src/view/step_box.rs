//! Bounds of a step as integers: a box, a box of normals and an error.
//!
//! Boxes grow by taking minima and maxima, so a step that encloses all steps that depend on it is no larger than
//! these need. Every test of a [`GridCamera`](super::GridCamera) is interval arithmetic over such a box, and interval
//! arithmetic on integers never gives a smaller interval for a larger box. A step therefore weighs at least as much
//! as every step that depends on it, whatever the camera, exactly and on every machine.

use glam::DVec3;

use super::fixed_log::log_up;

/// Logarithm of the smallest error that a box can store, in grid units, as an octave.
pub(super) const LEAST_OCTAVE: i32 = -48;

/// Error that is refined at any distance.
pub(super) const INFINITE_ERROR: u16 = u16::MAX;

/// Largest coordinate of a box.
const REACH: f64 = 32_766.0;

/// Integer coordinates of a model: 65,533 steps along the longest side of its bounding box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxGrid {
    pub(super) center: DVec3,
    /// Mesh units per grid unit.
    pub(super) unit: f64,
}

/// Integer bounds of a step and all steps that depend on it, laid out for a GPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct StepBox {
    /// Least and largest coordinate along each axis, in grid units.
    sides: [[i16; 2]; 3],
    /// Least and largest component of the unit normals along each axis; 127 stands for 1.
    normals: [[i8; 2]; 3],
    /// Logarithm of the error; 0 for no error.
    error: u16,
    /// Number of triangles that the step alone adds.
    pub added: i32,
}

impl BoxGrid {
    /// Creates the grid of a model with these positions.
    pub fn new(positions: &[[f32; 3]]) -> Self {
        let points = || positions.iter().map(|p| DVec3::from(p.map(f64::from))).filter(|p| p.is_finite());
        let low = points().fold(DVec3::INFINITY, DVec3::min);
        let high = points().fold(DVec3::NEG_INFINITY, DVec3::max);
        if low.x > high.x {
            return Self { center: DVec3::ZERO, unit: 1.0 };
        }
        let side = (high - low).max_element() / 2.0;
        let unit = if side > 0.0 { side * (1.0 + 1e-9) / REACH } else { 1.0 };
        Self { center: (low + high) / 2.0, unit }
    }
}

impl StepBox {
    /// Contains nothing.
    pub const EMPTY: Self =
        Self { sides: [[i16::MAX, i16::MIN]; 3], normals: [[i8::MAX, i8::MIN]; 3], error: 0, added: 0 };

    /// Contains a point, with an error in mesh units.
    #[must_use]
    pub fn with_point(mut self, grid: &BoxGrid, point: [f32; 3]) -> Self {
        let at = (DVec3::from(point.map(f64::from)) - grid.center) / grid.unit;
        for (side, at) in self.sides.iter_mut().zip(at.to_array()) {
            // The grid spans all finite positions; others cannot be drawn.
            *side = [side[0].min(at.floor() as i16), side[1].max(at.ceil() as i16)];
        }
        self
    }

    /// Adds the normal of a triangle, unless it has no area.
    #[must_use]
    pub fn with_normal_of(mut self, corners: &[[f32; 3]; 3]) -> Self {
        let [a, b, c] = corners.map(|corner| DVec3::from(corner.map(f64::from)));
        if let Some(normal) = (b - a).cross(c - a).try_normalize() {
            for (side, at) in self.normals.iter_mut().zip((normal * 127.0).to_array()) {
                let [low, high] = [(at - 1e-9).floor().max(-127.0), (at + 1e-9).ceil().min(127.0)];
                *side = [side[0].min(low as i8), side[1].max(high as i8)];
            }
        }
        self
    }

    /// Adds all normals.
    #[must_use]
    pub fn with_all_normals(self) -> Self {
        Self { normals: [[-127, 127]; 3], ..self }
    }

    /// Raises the error to at least `error` mesh units.
    #[must_use]
    pub fn with_error(self, grid: &BoxGrid, error: f32) -> Self {
        let least = -LEAST_OCTAVE * 1024;
        let error = match f64::from(error) / grid.unit {
            units if units > 0.0 => (log_up(units) + least).clamp(1, i32::from(INFINITE_ERROR)) as u16,
            _ => 0,
        };
        Self { error: self.error.max(error), ..self }
    }

    /// Sets the error to a logarithm as in [`error_log`](Self::error_log); larger ones are infinite.
    #[must_use]
    pub fn with_log(self, error: u32) -> Self {
        Self { error: error.min(u32::from(INFINITE_ERROR)) as u16, ..self }
    }

    /// Encloses another box; keeps the number of added triangles.
    #[must_use]
    pub fn with_box(mut self, other: &Self) -> Self {
        for axis in 0..3 {
            let (side, inner) = (&mut self.sides[axis], other.sides[axis]);
            *side = [side[0].min(inner[0]), side[1].max(inner[1])];
            let (side, inner) = (&mut self.normals[axis], other.normals[axis]);
            *side = [side[0].min(inner[0]), side[1].max(inner[1])];
        }
        Self { error: self.error.max(other.error), ..self }
    }

    /// Least and largest coordinate along each axis, in grid units.
    pub fn sides(&self) -> [[i16; 2]; 3] {
        self.sides
    }

    /// Least and largest component of the normals along each axis, in 1/127; [`None`] if there is no normal because
    /// no triangle has an area.
    pub fn normals(&self) -> Option<[[i8; 2]; 3]> {
        self.normals.iter().all(|[low, high]| low <= high).then_some(self.normals)
    }

    /// The error as a logarithm: 1,024 per octave, 0 for no error, 65,535 for an infinite one.
    pub fn error_log(&self) -> u16 {
        self.error
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_hold_the_points_at_the_ends_of_their_grid() {
        let points = [[1e6, -3.0, 2.0], [1e6 + 8.0, 5.0, 2.0], [f32::NAN, 0.0, 0.0]];
        let grid = BoxGrid::new(&points);
        let all = points[..2].iter().fold(StepBox::EMPTY, |all, &point| all.with_point(&grid, point));
        assert!(all.sides()[0][0] <= -32_765 && all.sides()[0][1] >= 32_765, "{all:?}");
        assert!(all.sides()[2][0] <= 0 && all.sides()[2][1] >= 0, "{all:?}");
        let dot = BoxGrid::new(&[[4.0; 3]]);
        assert_eq!(StepBox::EMPTY.with_point(&dot, [4.0; 3]).sides(), [[0, 0]; 3]);
        let flat = StepBox::EMPTY.with_normal_of(&[points[0], points[0], points[1]]);
        assert_eq!(flat.normals(), None);
        assert!(flat.with_normal_of(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]).normals().is_some());
    }

    #[test]
    fn errors_are_rounded_up_and_extremes_are_kept() {
        let grid = BoxGrid { center: DVec3::ZERO, unit: 0.5 };
        let log = |error| StepBox::EMPTY.with_error(&grid, error).error_log();
        assert_eq!([log(0.0), log(f32::NAN), log(-1.0)], [0; 3]);
        assert_eq!([log(f32::INFINITY), log(1e-38)], [u16::MAX, 1]);
        let exact = 48 * 1024 + 1024;
        assert!((exact..exact + 4).contains(&i32::from(log(1.0))), "{} for 2 units", log(1.0));
    }
}
