//! A camera on the grid of a model: which steps it refines, decided with 32-bit integers only.
//!
//! The decision is a pure function of the camera and of a step's [`StepBox`], so it needs no history and can run for
//! all steps at once, on a GPU as well: `crowd.wgsl` of `striata-render` repeats it bit by bit.
//!
//! ```text
//! box of the step --rotate--> intervals of x, y and depth --> outside the frustum?      weight 0
//! box of normals x box of directions from the eye         --> turned away everywhere?   weight 0
//! error / least depth x stretch of the flat screen        --> weight, a logarithm; refined above 0
//! ```
//!
//! All intervals are rounded outward, so a weight never underestimates the error on the screen, and a box never
//! weighs less than a box inside it.

use super::fixed_log::{EXCESS, LACK, log_of, log_up};
use super::step_box::{INFINITE_ERROR, LEAST_OCTAVE};
use super::{BoxGrid, ScreenError, StepBox};

/// Bits after the point of a rotation.
const TURN_BITS: i32 = 13;

/// Slope of a side of the frustum, in 1/1024, from which on the side is ignored.
const STEEPEST: i32 = 1 << 14;

/// Largest distance to the eye on any axis, in grid units.
const FARTHEST: f64 = (1u64 << 50) as f64;

/// A camera and a tolerance in pixels, in integers on the grid of a model; laid out for a GPU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct GridCamera {
    /// Directions to the right, upward and forward, in 1/8192.
    turn: [[i32; 3]; 3],
    /// Least and largest position of the model's center in the view.
    low: [i32; 3],
    high: [i32; 3],
    /// Bits that are dropped from rotated coordinates.
    shift: i32,
    /// Slopes of the sides of the frustum, in 1/1024.
    half: [i32; 2],
    /// Largest squared tangent of the angle to the view axis on the screen, in 1/4096.
    stretch_limit: u32,
    /// Logarithm that turns an error over a depth into a weight.
    scale: i32,
    /// Least and largest coordinates of the eye, and the bits that are dropped from coordinates there.
    eye_low: [i32; 3],
    eye_high: [i32; 3],
    eye_shift: i32,
}

/// Least and largest value of something.
#[derive(Clone, Copy)]
struct GridInterval {
    low: i32,
    high: i32,
}

impl GridCamera {
    /// Largest weight.
    pub const MOST: i32 = (1 << 16) - 1;

    /// Moves a criterion's camera onto the grid of a model that is shown with a transform, a matrix in column order.
    /// Only the camera and its tolerance count; silhouettes, regions and the fovea are ignored.
    ///
    /// Returns [`None`] if the transform is anything but a rotation with a translation and a uniform scale, if the
    /// eye is farther than 2^34 model sizes away, or if the criterion has an orthographic camera or several cameras.
    pub fn new(criterion: &ScreenError, transform: &[f64; 16], grid: &BoxGrid) -> Option<Self> {
        if criterion.camera().is_orthographic || !criterion.others.is_empty() {
            return None;
        }
        let criterion = criterion.in_object(transform)?;
        let camera = criterion.camera();
        let eye = (camera.eye - grid.center) / grid.unit;
        if !eye.is_finite() || eye.abs().max_element() >= FARTHEST {
            return None;
        }
        let axes = [camera.right, camera.up, camera.forward];
        let one = f64::from(1 << TURN_BITS);
        let turn = axes.map(|axis| (axis * one).round().to_array().map(|x| x as i32));
        // Coordinates are doubled, so that the middle of a box is an integer.
        let center = axes.map(|axis| -2.0 * one * axis.dot(eye));
        let farthest = center.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let mut shift = 15;
        while (0.94e9 + farthest) / f64::from(shift).exp2() > 32_000.0 {
            shift += 1;
        }
        let unit = f64::from(shift).exp2();
        // The rotation is rounded by half a unit, for each of three coordinates of at most 2^16.
        let slack = 1.5 * 65_536.0 + 1.0 + farthest * 1e-12;
        let eye_shift = (0..31).find(|&bits| eye.abs().max_element() < f64::from(21 + bits).exp2())?;
        let eye_unit = f64::from(eye_shift).exp2();
        // If the screen is off-center, it is within one that is not.
        let sides = camera.sides();
        let half = sides.map(|half| (half * 1024.0).ceil().min(f64::from(STEEPEST)) as i32);
        let stretch = 4096.0 * (sides[0].powi(2) + sides[1].powi(2));
        let pixels = f64::from(criterion.pixels()).max(0.0);
        Some(Self {
            turn,
            low: center.map(|x| ((x - slack) / unit).floor() as i32),
            high: center.map(|x| ((x + slack) / unit).ceil() as i32),
            shift: shift.min(31),
            half,
            stretch_limit: (stretch.ceil() + 1.0).min(f64::from(1u32 << 31)) as u32,
            scale: log_up(camera.pixels / pixels) - 1024 * (shift - TURN_BITS - 1) + 1024 * LEAST_OCTAVE,
            eye_low: (eye / eye_unit).floor().to_array().map(|x| x as i32),
            eye_high: (eye / eye_unit).ceil().to_array().map(|x| x as i32),
            eye_shift,
        })
    }

    /// Returns the weight of a step: 1,024 times the logarithm to base 2 of its error over the allowed error, from 0
    /// to [`MOST`](Self::MOST). A step is refined if its weight is greater than a threshold of 0 or more.
    ///
    /// A box never weighs less than a box inside it whose error is not larger.
    pub fn weigh(&self, part: &StepBox) -> i32 {
        if part.error_log() == 0 {
            return 0;
        }
        let [x, y, depth] = [0, 1, 2].map(|row| self.seen(row, part));
        if depth.high <= 0
            || is_outside(x, self.half[0], depth)
            || is_outside(y, self.half[1], depth)
            || self.is_turned_away(part)
        {
            return 0;
        }
        if depth.low <= 0 || part.error_log() == INFINITE_ERROR {
            return Self::MOST;
        }
        let square = |x: i32| x.unsigned_abs() * x.unsigned_abs();
        let across = square(x.low.abs().max(x.high.abs())) + square(y.low.abs().max(y.high.abs()));
        let tangent = (across / (square(depth.low) >> 12).max(1) + 1).min(self.stretch_limit);
        let stretch = (log_of(4096 + tangent) + LACK - 12 * 1024 + 1) >> 1;
        let weight = i32::from(part.error_log()) + self.scale + stretch - (log_of(depth.low as u32) - EXCESS);
        weight.clamp(0, Self::MOST)
    }

    /// Whether any point of a box can be on the screen.
    pub fn may_see(&self, part: &StepBox) -> bool {
        let [x, y, depth] = [0, 1, 2].map(|row| self.seen(row, part));
        depth.high > 0 && !is_outside(x, self.half[0], depth) && !is_outside(y, self.half[1], depth)
    }

    /// Interval of a coordinate of a box in the view.
    fn seen(&self, row: usize, part: &StepBox) -> GridInterval {
        let (mut middle, mut reach) = (0, 0);
        for ([low, high], turn) in part.sides().into_iter().zip(self.turn[row]) {
            let [low, high] = [i32::from(low), i32::from(high)];
            middle += turn * (low + high);
            reach += turn.abs() * (high - low);
        }
        GridInterval {
            low: ((middle - reach) >> self.shift) + self.low[row],
            high: self.high[row] - (-(middle + reach) >> self.shift),
        }
    }

    /// Whether all triangles of a part show their back, or none has an area.
    fn is_turned_away(&self, part: &StepBox) -> bool {
        let Some(normals) = part.normals() else { return true };
        let mut least = 0;
        for (axis, ([low, high], normals)) in part.sides().into_iter().zip(normals).enumerate() {
            let toward = [
                (i32::from(low) >> self.eye_shift) - self.eye_high[axis],
                -(-i32::from(high) >> self.eye_shift) - self.eye_low[axis],
            ];
            let [low, high] = normals.map(i32::from);
            let products = toward.map(|toward| (toward * low).min(toward * high));
            least += products[0].min(products[1]);
        }
        least > 0
    }
}

/// Whether a part is to the left or the right of the screen, or above or below it.
fn is_outside(across: GridInterval, half: i32, depth: GridInterval) -> bool {
    let limit = half * depth.high;
    half < STEEPEST && (across.low << 10 > limit || -across.high << 10 > limit)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;
    use crate::mesh::Random;
    use crate::view::{Camera, Sphere};

    const PLACED: [f64; 16] =
        [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

    fn point(random: &mut Random, spread: f64) -> [f32; 3] {
        [(); 3].map(|()| ((random.unit() - 0.5) * spread) as f32)
    }

    fn camera(random: &mut Random) -> Camera {
        let far = [2.0, 20.0, 1e4, 1e9][random.below(4) as usize];
        let size = [1 + random.below(3000), 1 + random.below(2000)];
        let tan = 0.05 + random.unit() * 2.0;
        loop {
            let (eye, up) = (point(random, far), point(random, 1.0));
            if let Ok(camera) = Camera::new(eye, point(random, 2.0), up, tan, size) {
                return camera;
            }
        }
    }

    fn triangle(random: &mut Random) -> [[f32; 3]; 3] {
        let (middle, spread) = (point(random, 1.8), [0.2, 0.02, 0.001][random.below(3) as usize]);
        [(); 3].map(|()| {
            let offset = point(random, spread);
            [0, 1, 2].map(|axis| middle[axis] + offset[axis])
        })
    }

    fn holding(grid: &BoxGrid, corners: &[[f32; 3]; 3], error: f32) -> StepBox {
        let part = StepBox::EMPTY.with_normal_of(corners).with_error(grid, error);
        corners.iter().fold(part, |part, &corner| part.with_point(grid, corner))
    }

    fn grid() -> BoxGrid {
        BoxGrid::new(&[[-1.0; 3], [1.0; 3]])
    }

    #[test]
    fn no_box_weighs_less_than_a_box_inside_it() {
        let (mut random, grid, mut differing) = (Random::new(21), grid(), 0);
        for _ in 0..60_000 {
            let criterion = ScreenError::new(camera(&mut random), random.unit() as f32 * 4.0);
            let grid_camera = GridCamera::new(&criterion, &PLACED, &grid).unwrap();
            let [inner, other] = [(); 2].map(|()| {
                let corners = triangle(&mut random);
                holding(&grid, &corners, random.unit() as f32 * 0.02)
            });
            let outer = inner.with_box(&other);
            let [less, more] = [inner, outer].map(|part| grid_camera.weigh(&part));
            assert!(less <= more, "{less} in {more}: {inner:?} in {outer:?} from {grid_camera:?}");
            differing += usize::from(less < more);
        }
        assert!(differing > 10_000, "{differing}");
    }

    #[test]
    fn weights_are_upper_bounds_and_close_to_those_of_the_camera() {
        let (mut random, grid) = (Random::new(22), grid());
        let (mut hidden, mut seen, mut excess) = (0, 0, 0.0f64);
        for _ in 0..60_000 {
            let camera = camera(&mut random);
            let criterion = ScreenError::new(camera, 0.5);
            let grid_camera = GridCamera::new(&criterion, &PLACED, &grid).unwrap();
            let corners = triangle(&mut random);
            let error = random.unit() as f32 * 0.01;
            let weight = f64::from(grid_camera.weigh(&holding(&grid, &corners, error))) / 1024.0;
            let facing = {
                let [a, b, c] = corners.map(|corner| DVec3::from(corner.map(f64::from)));
                (b - a).cross(c - a).dot(camera.eye - a) > 0.0
            };
            let at = Sphere::point(corners[0]);
            let offset = DVec3::from(corners[0].map(f64::from)) - camera.eye;
            let on_screen = [camera.right, camera.up].iter().zip(camera.half).all(|(axis, half)| {
                offset.dot(*axis).abs() <= half * offset.dot(camera.forward) * (1.0 - 1e-6)
            });
            if !facing || !on_screen {
                hidden += usize::from(weight == 0.0);
                continue;
            }
            let exact = (f64::from(camera.error_px(error, &at)) / 0.5).log2();
            assert!(exact <= weight.max(0.0) + 1e-6 || weight >= 63.9, "{exact}, {weight}");
            if exact > 0.0 && weight < 63.9 {
                seen += 1;
                excess += weight - exact;
            }
        }
        assert!(hidden > 10_000 && seen > 1000, "{hidden} hidden, {seen} seen");
        let mean = excess / f64::from(seen);
        assert!(mean < 0.2, "weights are {mean} octaves too large");
    }

    #[test]
    fn a_transform_changes_nothing_but_the_place() {
        let criterion = |eye, target| {
            ScreenError::new(Camera::new(eye, target, [0.0, 0.0, 1.0], 0.5, [800, 600]).unwrap(), 1.0)
        };
        let mut moved = PLACED;
        moved[12] = 100.0;
        (0..3).for_each(|axis| moved[5 * axis] = 4.0);
        let a = GridCamera::new(&criterion([3.0, 1.0, 1.0], [0.0; 3]), &PLACED, &grid()).unwrap();
        let b = GridCamera::new(&criterion([112.0, 4.0, 4.0], [100.0, 0.0, 0.0]), &moved, &grid()).unwrap();
        assert_eq!(a.scale, b.scale);
        assert_eq!(a.turn, b.turn);
        moved[5] = 3.0;
        assert_eq!(GridCamera::new(&criterion([3.0, 1.0, 1.0], [0.0; 3]), &moved, &grid()), None);
        moved[5] = f64::NAN;
        assert_eq!(GridCamera::new(&criterion([3.0, 1.0, 1.0], [0.0; 3]), &moved, &grid()), None);
    }
}
