//! A generated terrain of any size, for tests and benchmarks.

use super::{Piece, PieceGroup, PieceSource, PieceSummary};
use crate::ReadError;

/// Quads along each side of a piece.
const BLOCK: u32 = 224;
/// Octaves of noise: features from 512 samples down to one.
const OCTAVES: u32 = 10;

/// A generated terrain: value noise in ten octaves over a square of samples one unit apart.
///
/// Nothing is stored, so a terrain of a billion triangles takes no memory. Heights depend on integers and
/// multiplications only and are the same on every machine.
#[derive(Clone, Debug)]
pub struct FractalTerrain {
    side: u32,
    seed: u64,
    summary: PieceSummary,
}

impl FractalTerrain {
    /// Creates a terrain with this many samples along each side, at least 2.
    pub fn new(side: u32, seed: u64) -> Self {
        let side = side.max(2);
        let quads = u64::from(side - 1) * u64::from(side - 1);
        let summary = PieceSummary {
            name: format!("terrain of {side} by {side} samples"),
            groups: vec![PieceGroup::default()],
            triangle_count: 2 * quads,
            byte_count: 4 * u64::from(side) * u64::from(side),
            ..PieceSummary::default()
        };
        Self { side, seed, summary }
    }

    fn columns(&self) -> u32 {
        (self.side - 1).div_ceil(BLOCK)
    }

    /// Heights of a block of samples, row by row, in units of the samples' distance.
    fn heights(&self, x0: u32, y0: u32, width: u32, height: u32) -> Vec<f32> {
        let mut heights = vec![0.0f32; (width * height) as usize];
        for octave in 0..OCTAVES {
            let spacing = 1u32 << (OCTAVES - 1 - octave);
            let amplitude = 0.35 * spacing as f32;
            let (first_x, first_y) = (x0 / spacing, y0 / spacing);
            let lattice_width = (x0 + width - 1) / spacing - first_x + 2;
            let lattice_height = (y0 + height - 1) / spacing - first_y + 2;
            let lattice: Vec<f32> = (0..lattice_width * lattice_height)
                .map(|i| {
                    let (x, y) = (first_x + i % lattice_width, first_y + i / lattice_width);
                    amplitude * self.noise(octave, x, y)
                })
                .collect();
            for row in 0..height {
                let y = y0 + row;
                let v = smooth((y % spacing) as f32 / spacing as f32);
                let below = ((y / spacing - first_y) * lattice_width) as usize;
                let above = below + lattice_width as usize;
                for column in 0..width {
                    let x = x0 + column;
                    let u = smooth((x % spacing) as f32 / spacing as f32);
                    let at = (x / spacing - first_x) as usize;
                    let low = lattice[below + at] + u * (lattice[below + at + 1] - lattice[below + at]);
                    let high = lattice[above + at] + u * (lattice[above + at + 1] - lattice[above + at]);
                    heights[(row * width + column) as usize] += low + v * (high - low);
                }
            }
        }
        heights
    }

    /// Noise from -1 to 1 at a lattice point.
    fn noise(&self, octave: u32, x: u32, y: u32) -> f32 {
        let mut word = self.seed ^ (u64::from(x) << 32 | u64::from(y)) ^ (u64::from(octave) << 58);
        word = (word ^ (word >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        word ^= word >> 31;
        (word >> 40) as f32 / (1u64 << 23) as f32 - 1.0
    }
}

/// A cubic from 0 to 1 with slope 0 at both ends.
fn smooth(t: f32) -> f32 {
    t * t * (3.0 - 2.0 * t)
}

impl PieceSource for FractalTerrain {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        u64::from(self.columns()) * u64::from(self.columns())
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        let columns = u64::from(self.columns());
        let (x0, y0) = ((index % columns) as u32 * BLOCK, (index / columns) as u32 * BLOCK);
        let size = |from: u32| BLOCK.min(self.side - 1 - from) + 1;
        let (width, height) = (size(x0), size(y0));
        let heights = self.heights(x0, y0, width, height);
        let at = |i: u32| [(x0 + i % width) as f32, (y0 + i / width) as f32, heights[i as usize]];
        Ok(Piece {
            positions: (0..width * height).map(at).collect(),
            triangles: grid_triangles(width, height),
            ..Piece::default()
        })
    }
}

/// Triangles of a grid of samples, counterclockwise seen from above; each quad is divided along its diagonal from
/// the lower left.
fn grid_triangles(width: u32, height: u32) -> Vec<[u32; 3]> {
    let quads = (0..height - 1).flat_map(|y| (0..width - 1).map(move |x| y * width + x));
    quads.flat_map(|a| [[a, a + 1, a + width + 1], [a, a + width + 1, a + width]]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_agree_where_they_touch() {
        let terrain = FractalTerrain::new(500, 7);
        assert_eq!(terrain.piece_count(), 9);
        let pieces: Vec<Piece> = (0..9).map(|i| terrain.read_piece(i).unwrap()).collect();
        let triangles: usize = pieces.iter().map(|piece| piece.triangles.len()).sum();
        assert_eq!(triangles as u64, terrain.summary().triangle_count);
        let mut heights = std::collections::HashMap::new();
        for p in pieces.iter().flat_map(|piece| &piece.positions) {
            let known = *heights.entry([p[0] as u32, p[1] as u32]).or_insert(p[2]);
            assert_eq!(known, p[2]);
        }
        assert_eq!(heights.len(), 500 * 500);
    }
}
