//! Blocks of tiles, cut out of a paged file one after the other.

use striata::mesh::IndexedMesh;
use striata::{Progress, ProgressFn};
use striata_paged::{PagedFile, StepTiers};

use crate::error::TilesError;
use crate::lattice::{Cell, LevelTiers, TileBlock, TileLattice, TileShape};

/// Triangles of a block of tiles that are made together, about.
const BLOCK_TRIANGLES: f64 = (1 << 20) as f64;

/// Number of a cell in z-order: bits of x, y and z take turns, those of x are the lowest.
pub(crate) fn z_order(cell: Cell) -> u64 {
    let spread = |x: i64| (0..21).map(|bit| (x as u64 >> bit & 1) << (3 * bit)).sum::<u64>();
    spread(cell[0]) | spread(cell[1]) << 1 | spread(cell[2]) << 2
}

/// The levels of a paged file that become tiles.
pub(crate) struct TileLevels<'a> {
    pub tiers: &'a StepTiers,
    pub lattice: &'a TileLattice,
    pub levels: &'a [LevelTiers],
    /// Number of triangles of a tile, about.
    pub tile_triangles: f64,
}

/// The levels of a paged file, finest first.
pub(crate) fn levels_of(
    file: &PagedFile,
    shape: TileShape,
    tiers: &StepTiers,
    tile_triangles: f64,
) -> Vec<LevelTiers> {
    let base = file.reader().entry(0).map_or(0, |entry| u64::from(entry.triangle_count));
    shape.levels(file.metadata(), tiers, base, tile_triangles)
}

impl TileLevels<'_> {
    /// Calls a function with each block of tiles and its mesh, levels in the order given, and the blocks of a level in
    /// z-order.
    ///
    /// # Errors
    /// [`TilesError::Paged`] if a page cannot be read, and errors of the function.
    pub(crate) fn for_each_block(
        &self,
        file: &mut PagedFile,
        order: impl Iterator<Item = u32>,
        progress: &mut ProgressFn<'_>,
        mut run: impl FnMut(&TileBlock<'_>, IndexedMesh) -> Result<(), TilesError>,
    ) -> Result<(), TilesError> {
        let blocks: Vec<(u32, [Cell; 2])> = order.flat_map(|level| self.blocks(level)).collect();
        let total = blocks.len() as u64;
        for (done, (number, cells)) in (1..).zip(blocks) {
            let block =
                TileBlock { lattice: self.lattice, level: self.levels[number as usize], number, cells };
            let cut = file.cut_tiers(self.tiers, |tier, bounds| block.wants(tier, bounds))?;
            run(&block, cut.mesh)?;
            Progress { phase: "tile", done, total }.report(progress)?;
        }
        Ok(())
    }

    /// Blocks of a level that the mesh may reach, with the tiles of each.
    fn blocks(&self, level: u32) -> Vec<(u32, [Cell; 2])> {
        let top = self.levels.len() as u32 - 1;
        let mut height = 0;
        while height < top && 4f64.powi(height as i32) * self.tile_triangles.max(1.0) < BLOCK_TRIANGLES {
            height += 1;
        }
        let height = height.min(top - level);
        let last = |a: usize| {
            let high = self.lattice.high[a];
            self.lattice.cells_of(a, high, high, level + height)[0]
        };
        let side = |a: usize| if self.lattice.is_divided[a] { 1 << height } else { 1 };
        let mut places = Vec::new();
        for x in 0..=last(0) {
            for y in 0..=last(1) {
                places.extend((0..=last(2)).map(|z| [x, y, z]));
            }
        }
        places.sort_by_key(|&place| z_order(place));
        let cells = |place: Cell| {
            let first = [0, 1, 2].map(|a| place[a] * side(a));
            [first, [0, 1, 2].map(|a| first[a] + side(a))]
        };
        places.into_iter().map(|place| (level, cells(place))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn x_is_the_lowest_bit() {
        assert_eq!([[1, 0, 0], [0, 1, 0], [0, 0, 1], [2, 0, 0], [3, 3, 3]].map(z_order), [1, 2, 4, 8, 63]);
    }
}
