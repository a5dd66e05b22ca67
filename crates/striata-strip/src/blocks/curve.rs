//! Order of triangles from which blocks are cut: Hilbert's curve through their centers.
//!
//! Consecutive triangles along the curve are close together, and so are consecutive blocks, so the border
//! between the finished part and the rest stays short. The cube that the curve fills has the length of the
//! mesh's longest side, so that blocks are as wide as they are deep. Uses Skilling's transform \[Ski04\] in
//! three dimensions of 21 bits: 60 integer steps per triangle.

use striata::mesh::Bounds;

/// Bits per coordinate: three coordinates fit into a `u64`.
const BITS: u32 = 21;

/// Hilbert's curve through the bounds of a mesh.
#[derive(Clone, Copy, Debug)]
pub struct BlockCurve {
    min: [f64; 3],
    scale: f64,
}

impl BlockCurve {
    /// Creates the curve for these bounds; without bounds, all keys are equal.
    pub fn new(bounds: Option<Bounds>) -> Self {
        let Some(bounds) = bounds else { return Self { min: [0.0; 3], scale: 0.0 } };
        let min = bounds.min.map(f64::from);
        let extent = (0..3).map(|axis| f64::from(bounds.max[axis]) - min[axis]).fold(0.0, f64::max);
        let cells = f64::from((1u32 << BITS) - 1);
        Self { min, scale: if extent > 0.0 { cells / extent } else { 0.0 } }
    }

    /// Returns the position of a triangle's center along the curve.
    ///
    /// Points outside the bounds are clamped to the cube; coordinates that are not a number count as its
    /// lower end.
    pub fn key(&self, corners: [[f32; 3]; 3]) -> u64 {
        let cell = |axis: usize| {
            let sum: f64 = corners.iter().map(|corner| f64::from(corner[axis])).sum();
            // The cast saturates to the nearest cell.
            (((sum / 3.0 - self.min[axis]) * self.scale) as u32).min((1 << BITS) - 1)
        };
        along([cell(0), cell(1), cell(2)])
    }
}

/// Returns a cell's index along the curve.
fn along(mut cell: [u32; 3]) -> u64 {
    // Undoes the rotations of each level, the coarsest first.
    for level in (1..BITS).rev() {
        let (bit, below) = (1 << level, (1 << level) - 1);
        for axis in 0..3 {
            if cell[axis] & bit != 0 {
                cell[0] ^= below;
            } else {
                let swapped = (cell[0] ^ cell[axis]) & below;
                cell[0] ^= swapped;
                cell[axis] ^= swapped;
            }
        }
    }
    cell[1] ^= cell[0];
    cell[2] ^= cell[1];
    let mut flips = 0;
    for level in (1..BITS).rev() {
        if cell[2] & (1 << level) != 0 {
            flips ^= (1 << level) - 1;
        }
    }
    let mut key = 0;
    for level in (0..BITS).rev() {
        for axis in cell {
            key = key << 1 | u64::from((axis ^ flips) >> level & 1);
        }
    }
    key
}

/// Returns how many of these items form the next block: at most `longest`, and at least half as many unless
/// fewer remain.
///
/// `items` are the remaining ones, in the order of their keys along the curve; at most `longest + 1` of
/// them are examined. The block ends where the curve leaves the largest possible cube, so that borders are
/// straight and short: on grids, the extra indices due to blocks of 10,000 triangles are half of those for
/// blocks of arbitrary length.
pub fn block_length<T>(items: &[T], key: impl Fn(&T) -> u64, longest: usize) -> usize {
    let longest = longest.max(1);
    if items.len() <= longest {
        return items.len();
    }
    let step = |end: usize| key(&items[end - 1]) ^ key(&items[end]);
    let shortest = longest.div_ceil(2);
    (shortest..=longest).max_by_key(|&end| (step(end), end)).unwrap_or(longest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbors_along_the_curve_are_neighbors_in_space() {
        let mut cells: Vec<(u64, [i32; 3])> = Vec::new();
        for x in 0..8 {
            for y in 0..8 {
                for z in 0..8 {
                    cells.push((along([x, y, z]), [x as i32, y as i32, z as i32]));
                }
            }
        }
        cells.sort_unstable();
        for (index, pair) in cells.windows(2).enumerate() {
            let step: i32 = (0..3).map(|axis| (pair[0].1[axis] - pair[1].1[axis]).abs()).sum();
            assert_eq!((pair[0].0, step), (index as u64, 1), "{pair:?}");
        }
    }

    #[test]
    fn blocks_end_where_the_curve_leaves_a_large_cube() {
        let length = |keys: &[u64], longest| block_length(keys, |&key| key, longest);
        assert_eq!(length(&[], 5), 0);
        assert_eq!(length(&[1, 2, 3], 3), 3);
        assert_eq!(length(&[1, 2, 3], 0), 1);
        assert_eq!(length(&[0, 1, 2, 3, 6, 7, 8, 9, 10], 8), 6);
        assert_eq!(length(&[0, 1, 2, 3, 6, 7, 8, 9, 10], 5), 4);
        assert_eq!(length(&[5; 9], 8), 8);
    }

    #[test]
    fn points_outside_and_non_numbers_have_keys() {
        let curve = BlockCurve::new(Some(Bounds { min: [0.0; 3], max: [1.0; 3] }));
        for x in [-5.0, 0.0, 1.0, 7.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert!(curve.key([[x; 3]; 3]) < 1 << (3 * BITS), "{x}");
        }
        assert_eq!(BlockCurve::new(None).key([[3.0; 3]; 3]), 0);
    }
}
