//! The lattice of all vertices, the planes between tiles, and the levels.
//!
//! ```text
//!  level 1   |_______________|_______________|      a tile has `side` steps along each axis;
//!  level 0   |_______|_______|_______|_______|      steps double from level to level
//! ```
//!
//! All steps are powers of two, or such a power times a number of a few bits, and count from one origin. So the lattice
//! of a level contains those of coarser ones, and every plane between tiles lies on the lattices of all tiles that it bounds. Coordinates of vertices are
//! exact, as floats and as integers of 16 bits, so no format opens cracks.

use striata::mesh::Bounds;
use striata_paged::{Metadata, StepTiers};

use crate::textures::TileTextures;

/// Most levels above the finest.
const MAX_LEVEL: u32 = 14;
/// Base-2 logarithm of the number of steps of a tile's side, rounded up.
const SIDE_BITS: i32 = 15;
/// Number of bits of the steps of cubes.
const UNIT_BITS: i32 = 8;
/// Smallest exponent of a step: floats can still be divided.
const MIN_EXPONENT: i32 = -110;
/// A mesh is flat if it is this many times as wide as it is high.
const FLAT: f64 = 4.0;

/// Share of the side of a tile by which a block is made larger, so that the normals at its border are those of the next.
const MARGIN: f64 = 1.0 / 16.0;

/// Coordinates of a tile among those of its level.
pub(crate) type Cell = [i64; 3];

/// Which axis of the mesh is up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Up {
    /// The y axis, as in glTF.
    Y,
    /// The z axis, as in terrains.
    Z,
}

/// The lattice of all levels, in mesh units.
#[derive(Clone, Debug)]
pub(crate) struct TileLattice {
    /// Position of the first lattice point.
    pub origin: [f64; 3],
    /// Step of level 0: a number of at most eight bits, so that multiples are exact.
    pub unit: f64,
    /// Number of steps of a tile's side, at every level.
    pub side: u32,
    /// Largest coordinates of the mesh, from the origin.
    pub high: [f64; 3],
    /// Axes along which tiles are divided.
    pub is_divided: [bool; 3],
    /// Whether triangles are also cut at the planes between the tiles of the next finer level.
    pub is_halved: bool,
}

/// A level of the tileset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LevelTiers {
    /// Steps of at least this tier are refined.
    pub tier: u16,
    /// Steps of at least this tier are refined if they are near a plane between tiles.
    pub border_tier: u16,
    /// Estimated error, in mesh units.
    pub error: f64,
}

/// Tiles of a level that are made together, and what is refined there.
pub(crate) struct TileBlock<'a> {
    pub lattice: &'a TileLattice,
    pub level: LevelTiers,
    /// Number of the level.
    pub number: u32,
    /// First tile, and one beyond the last.
    pub cells: [Cell; 2],
}

/// How the cells of tiles are chosen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TileShape {
    pub up: Up,
    /// Axes along which tiles are divided: not the axis that is up for terrains and for what is flat.
    pub is_divided: [bool; 3],
    /// Number of tiers by which more is refined near planes.
    border_tiers: u16,
}

impl TileShape {
    /// The shape of cubes, for viewers that draw levels whose errors are about a pixel. At planes, a quarter of the
    /// error is enough then; a sixteenth costs half of the triangles again, because every eighth has planes.
    pub(crate) const CUBES: Self =
        Self { up: Up::Z, is_divided: [true; 3], border_tiers: StepTiers::PER_SIXTEENTH / 2 };

    /// The shape of a mesh whose axis that is up may be known. It is z for what has a georeference, for a height
    /// field and for what is flat along z.
    pub(crate) fn of(metadata: &Metadata, tiers: &StepTiers, up: Option<Up>) -> Self {
        let extent = extents(metadata);
        let is_flat = |axis: usize| {
            let across = (0..3).filter(|&a| a != axis).map(|a| extent[a]).fold(0.0, f64::max);
            tiers.is_height_field(axis)
                || extent[axis] * FLAT <= across && extent.iter().all(|x| extent[axis] <= *x)
        };
        let is_georeferenced = metadata.georeference.is_some();
        let up = up.unwrap_or(if is_georeferenced || is_flat(2) { Up::Z } else { Up::Y });
        let axis = if up == Up::Y { 1 } else { 2 };
        let is_terrain = is_georeferenced && up == Up::Z || is_flat(axis);
        let is_divided = [0, 1, 2].map(|a| !(is_terrain && a == axis));
        Self { up, is_divided, border_tiers: StepTiers::PER_SIXTEENTH }
    }

    /// Number of tiles of a level, about, that many levels below the coarsest.
    fn tile_count(&self, metadata: &Metadata, depth: u32) -> f64 {
        let extent = extents(metadata);
        let side =
            (0..3).filter(|&a| self.is_divided[a]).map(|a| extent[a]).fold(f64::MIN_POSITIVE, f64::max);
        let [x, y, z] = extent.map(|x| (x / side).max(1.0 / 1024.0));
        let (cells, of_surface) = match self.is_divided {
            [true, true, true] => (8f64, 1.5 * (x * y + y * z + z * x)),
            [true, true, false] => (4.0, x * y),
            _ => (4.0, x * z),
        };
        cells.powi(depth as i32).min((4f64.powi(depth as i32) * of_surface).max(1.0))
    }

    /// Number of levels above the finest, so that its tiles have about `tile_triangles` triangles.
    pub(crate) fn level_count(&self, metadata: &Metadata, tile_triangles: f64) -> u32 {
        let tiles = metadata.triangle_count as f64 / tile_triangles;
        (0..MAX_LEVEL).find(|&depth| self.tile_count(metadata, depth) >= tiles).unwrap_or(MAX_LEVEL)
    }

    /// The levels, finest first: each has about a quarter of the triangles of the one before.
    pub(crate) fn levels(
        &self,
        metadata: &Metadata,
        tiers: &StepTiers,
        base_triangle_count: u64,
        tile_triangles: f64,
    ) -> Vec<LevelTiers> {
        let base = base_triangle_count as f64;
        let removable = metadata.triangle_count as f64 - base;
        let all = tiers.step_count_from(0).max(1) as f64;
        let triangles_at = |tier: u16| base + removable * tiers.step_count_from(tier) as f64 / all;
        let count = self.level_count(metadata, tile_triangles);
        let level = |number: u32| {
            let wanted = metadata.triangle_count as f64 / 4f64.powi(number as i32);
            let wanted = wanted.min(self.tile_count(metadata, count - number) * tile_triangles);
            let is_enough = |tier: &u16| triangles_at(*tier) <= wanted;
            let tier = match number {
                0 => 0,
                _ => (1..StepTiers::NONE).find(is_enough).unwrap_or(StepTiers::NONE),
            };
            let border_tier = tier.saturating_sub(self.border_tiers);
            LevelTiers { tier, border_tier, error: tiers.error_below(tier).into() }
        };
        (0..=count).map(level).collect()
    }

    /// Lengths of the texels of all levels.
    pub(crate) fn texels(
        &self,
        metadata: &Metadata,
        textures: &TileTextures,
        levels: &[LevelTiers],
    ) -> Vec<f64> {
        let tile_counts = (0..levels.len() as u32).rev().map(|depth| self.tile_count(metadata, depth));
        levels.iter().zip(tile_counts).map(|(level, tiles)| textures.texel_of(level.error, tiles)).collect()
    }
}

/// The metadata of a file with bounds that contain all positions, also those that the grid of the file moves outside.
pub(crate) fn bounded(metadata: &Metadata) -> Metadata {
    let mut bounded = metadata.clone();
    if let Some(grid) = &metadata.grid {
        let (low, high) = (grid.snap(metadata.min), grid.snap(metadata.max));
        bounded.min = [0, 1, 2].map(|a| low[a].min(metadata.min[a]));
        bounded.max = [0, 1, 2].map(|a| high[a].max(metadata.max[a]));
    }
    bounded
}

fn extents(metadata: &Metadata) -> [f64; 3] {
    [0, 1, 2].map(|a| f64::from(metadata.max[a]) - f64::from(metadata.min[a]))
}

impl TileLattice {
    /// The lattice whose coarsest tile contains the mesh.
    pub(crate) fn new(metadata: &Metadata, is_divided: [bool; 3], level_count: u32) -> Self {
        let extent = extents(metadata);
        let widest = (0..3).filter(|&a| is_divided[a]).map(|a| extent[a]).fold(0.0, f64::max);
        let finest = MIN_EXPONENT + level_count as i32;
        let exponent = (exponent_of(widest) + 1 - SIDE_BITS).max(finest);
        let step = 2f64.powi(exponent);
        let origin = [0, 1, 2].map(|a| (f64::from(metadata.min[a]) / step).floor() * step);
        let steps = |a: usize| ((f64::from(metadata.max[a]) - origin[a]) / step).floor() as u32 + 1;
        let side = (0..3).filter(|&a| is_divided[a]).map(steps).fold(2, u32::max);
        let unit = 2f64.powi(exponent - level_count as i32);
        let high = [0, 1, 2].map(|a| f64::from(metadata.max[a]) - origin[a]);
        Self { origin, unit, side, high, is_divided, is_halved: false }
    }

    /// The lattice of cubes of `side` steps, whose levels are cut at the planes of the next finer ones. The coarsest
    /// tile is hardly larger than the mesh. With an odd `side`, a plane of a finer level is half a step off, and
    /// vertices on it move to the next point.
    pub(crate) fn of_cubes(metadata: &Metadata, side: u32, level_count: u32) -> Self {
        let origin = metadata.min.map(f64::from);
        let widest = extents(metadata).into_iter().fold(0.0, f64::max);
        let wanted = widest / (f64::from(side) * 2f64.powi(level_count as i32));
        let exponent = (exponent_of(wanted) + 1 - UNIT_BITS).max(MIN_EXPONENT);
        // Larger than wanted, because what lies on the last plane would belong to a tile beyond it.
        let unit = ((wanted / 2f64.powi(exponent)).floor() + 1.0) * 2f64.powi(exponent);
        Self { origin, unit, side, high: extents(metadata), is_divided: [true; 3], is_halved: true }
    }

    /// Distance of lattice points.
    pub(crate) fn step(&self, level: u32) -> f64 {
        self.unit * 2f64.powi(level as i32)
    }

    /// Base-2 logarithm of a step that is a power of two.
    pub(crate) fn step_log2(&self, level: u32) -> i32 {
        exponent_of(self.step(level))
    }

    /// Distance of the planes at which triangles are cut.
    fn plane_distance(&self, level: u32) -> f64 {
        self.tile_side(if self.is_halved { level.saturating_sub(1) } else { level })
    }

    /// Largest distance by which a vertex moves to the lattice.
    pub(crate) fn largest_move(&self, level: u32) -> f64 {
        0.75f64.sqrt() * self.step(level)
    }

    /// Side of a tile.
    pub(crate) fn tile_side(&self, level: u32) -> f64 {
        self.step(level) * f64::from(self.side)
    }

    /// A position of the mesh, from the origin of the lattice.
    pub(crate) fn place(&self, position: [f32; 3]) -> [f64; 3] {
        [0, 1, 2].map(|a| f64::from(position[a]) - self.origin[a])
    }

    /// The nearest lattice point, in steps of a level.
    pub(crate) fn snap(&self, place: [f64; 3], level: u32) -> [i64; 3] {
        place.map(|x| (x / self.step(level) + 0.5).floor() as i64)
    }

    /// First and last tile that a range of coordinates has a part in. A plane belongs to the tile above it.
    pub(crate) fn cells_of(&self, axis: usize, low: f64, high: f64, level: u32) -> [i64; 2] {
        if !self.is_divided[axis] {
            return [0, 0];
        }
        let side = self.tile_side(level);
        let (first, last) = (cell_of(low, side), cell_of(high, side));
        // The range ends at a plane, and has no part beyond it.
        let ends_there = last as f64 * side == high && low < high;
        [first, if ends_there { last - 1 } else { last }]
    }
}

/// The interval that a coordinate is in; divisions round, products of few bits do not.
fn cell_of(x: f64, side: f64) -> i64 {
    let cell = (x / side).floor();
    if (cell + 1.0) * side <= x {
        cell as i64 + 1
    } else if cell * side > x {
        cell as i64 - 1
    } else {
        cell as i64
    }
}

/// Largest integer whose power of two is no larger.
fn exponent_of(x: f64) -> i32 {
    if x > 0.0 { (x.to_bits() >> 52) as i32 - 1023 } else { 0 }
}

impl TileBlock<'_> {
    /// Whether a step is refined, or a page contains such a step.
    pub(crate) fn wants(&self, tier: u8, bounds: &Bounds) -> bool {
        let tier = u16::from(tier);
        if tier < self.level.border_tier {
            return false;
        }
        let side = self.lattice.tile_side(self.number);
        let (low, high) = (self.lattice.place(bounds.min), self.lattice.place(bounds.max));
        let axes = || (0..3).filter(|&a| self.lattice.is_divided[a]);
        let [first, end] = &self.cells;
        let margin = MARGIN * side;
        let is_outside =
            |a: usize| high[a] < first[a] as f64 * side - margin || low[a] > end[a] as f64 * side + margin;
        if axes().any(is_outside) {
            return false;
        }
        let distance = self.lattice.plane_distance(self.number);
        // The first plane that is not below the range is not above it either.
        let meets_plane = |a: usize| {
            let cell = cell_of(low[a], distance);
            cell as f64 * distance == low[a] || (cell + 1) as f64 * distance <= high[a]
        };
        tier >= self.level.tier || axes().any(meets_plane)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lattice(min: [f32; 3], max: [f32; 3], level_count: u32) -> TileLattice {
        TileLattice::new(&Metadata { min, max, ..Metadata::default() }, [true, true, false], level_count)
    }

    #[test]
    fn the_coarsest_tile_contains_the_mesh() {
        for (min, max) in [
            ([0.0; 3], [1.0; 3]),
            ([-7.0, 3.0, 0.0], [9.0, 4.0, 0.5]),
            ([1e6, 0.0, 0.0], [1e6 + 1.0, 2.0, 3.0]),
            ([5.0; 3], [5.0; 3]),
            ([-1e30; 3], [1e30; 3]),
            ([0.0; 3], [1e-37; 3]),
        ] {
            for level_count in [0, 3, MAX_LEVEL] {
                let lattice = lattice(min, max, level_count);
                assert!((2..=(1 << SIDE_BITS) + 1).contains(&lattice.side), "{lattice:?}");
                let (low, high) = (lattice.place(min), lattice.place(max));
                for a in (0..3).filter(|&a| lattice.is_divided[a]) {
                    assert!(low[a] >= 0.0 && high[a] < lattice.tile_side(level_count), "{lattice:?}");
                }
            }
        }
    }

    #[test]
    fn planes_belong_to_the_tile_above() {
        let lattice = lattice([0.0; 3], [100.0; 3], 3);
        let side = lattice.tile_side(0);
        assert_eq!(lattice.cells_of(0, side, side, 0), [1, 1]);
        assert_eq!(lattice.cells_of(0, 0.5 * side, side, 0), [0, 0]);
        assert_eq!(lattice.cells_of(0, side, 3.5 * side, 0), [1, 3]);
    }
}
