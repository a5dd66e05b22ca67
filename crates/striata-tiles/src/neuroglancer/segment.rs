//! The fragments and the manifest of one segment.

use std::collections::BTreeMap;

use rayon::prelude::*;
use striata::ProgressFn;
use striata::mesh::IndexedMesh;
use striata_io::{WriteError, encode_draco};
use striata_paged::PagedFile;

use super::options::NeuroglancerOptions;
use crate::TileLevel;
use crate::blocks::{TileLevels, levels_of, z_order};
use crate::error::TilesError;
use crate::lattice::{Cell, TileBlock, TileLattice, TileShape, bounded};
use crate::tile_mesh::LevelMesh;

/// The fragments of a segment that have been written.
#[derive(Debug)]
pub(super) struct Segment {
    lattice: TileLattice,
    /// Origin of the mesh.
    origin: [f64; 3],
    lods: Vec<SegmentLod>,
}

/// A level of detail.
#[derive(Debug)]
struct SegmentLod {
    /// Bytes of each fragment, by its number in z-order.
    fragments: BTreeMap<u64, u32>,
    triangle_count: u64,
    error: f64,
}

/// A fragment with its number in z-order.
struct EncodedFragment {
    number: u64,
    triangle_count: u64,
    bytes: Vec<u8>,
}

impl Segment {
    /// Writes the fragments of all levels, finest first.
    pub(super) fn write(
        id: u64,
        file: &mut PagedFile,
        options: &NeuroglancerOptions,
        progress: &mut ProgressFn<'_>,
        put: &mut dyn FnMut(&[u8]) -> Result<(), TilesError>,
    ) -> Result<Self, TilesError> {
        let metadata = bounded(file.metadata());
        let name = metadata.source.clone();
        if metadata.triangle_count == 0 {
            return Err(TilesError::Empty { name });
        }
        let tiers = file.tiers(|done, total| {
            striata::Progress { phase: "read", done, total }.report(progress).map_err(TilesError::from)
        })?;
        let tile_triangles = options.fragment_triangles.max(1) as f64;
        let levels = levels_of(file, TileShape::CUBES, &tiers, tile_triangles);
        let top = levels.len() as u32 - 1;
        let lattice = TileLattice::of_cubes(&metadata, (1 << options.bits.count()) - 1, top);
        if !(lattice.tile_side(top) as f32).is_finite() {
            return Err(TilesError::Segment { id, reason: "the mesh is wider than the largest float" });
        }
        let mut lods = Vec::new();
        for (number, level) in (0..).zip(&levels) {
            // Zero would say that there is no such level.
            let error =
                if number == 0 { lattice.step(0) } else { level.error + lattice.largest_move(number) };
            lods.push(SegmentLod { fragments: BTreeMap::new(), triangle_count: 0, error });
        }
        let mut write = |block: &TileBlock<'_>, mesh: IndexedMesh| {
            let lod = &mut lods[block.number as usize];
            for fragment in fragments(block, mesh) {
                let EncodedFragment { number, triangle_count, bytes } = fragment?;
                put(&bytes)?;
                lod.fragments.insert(number, bytes.len() as u32);
                lod.triangle_count += triangle_count;
            }
            Ok(())
        };
        let all = TileLevels { tiers: &tiers, lattice: &lattice, levels: &levels, tile_triangles };
        all.for_each_block(file, 0..=top, progress, &mut write)?;
        if lods.iter().all(|lod| lod.fragments.is_empty()) {
            return Err(TilesError::Empty { name });
        }
        // Fragments are found from coarser ones, so these exist, if without content.
        for level in 1..lods.len() {
            let parents: Vec<u64> = lods[level - 1].fragments.keys().map(|number| number >> 3).collect();
            parents.into_iter().for_each(|parent| {
                lods[level].fragments.entry(parent).or_insert(0);
            });
        }
        Ok(Self { lattice, origin: metadata.origin, lods })
    }

    /// Number of bytes of all fragments.
    pub(super) fn byte_count(&self) -> u64 {
        self.lods.iter().map(SegmentLod::byte_count).sum()
    }

    /// Step of the coordinates of the finest level.
    pub(super) fn step(&self) -> f64 {
        self.lattice.step(0)
    }

    /// Numbers of all levels, finest first.
    pub(super) fn levels(&self) -> impl Iterator<Item = TileLevel> {
        self.lods.iter().map(|lod| TileLevel {
            error: lod.error,
            tiles: lod.fragments.values().filter(|&&size| size > 0).count() as u64,
            triangles: lod.triangle_count,
            bytes: lod.byte_count(),
        })
    }

    /// The manifest, with coordinates from this origin.
    pub(super) fn manifest(&self, origin: [f64; 3]) -> Vec<u8> {
        let chunk = self.lattice.tile_side(0) as f32;
        let first = [0, 1, 2].map(|a| (self.origin[a] - origin[a] + self.lattice.origin[a]) as f32);
        let lod_count = self.lods.len();
        let scales = self.lods.iter().scan(0f32, |largest, lod| {
            *largest = largest.max(lod.error as f32);
            Some(*largest)
        });
        let mut bytes: Vec<u8> = [chunk; 3].into_iter().chain(first).flat_map(f32::to_le_bytes).collect();
        bytes.extend((lod_count as u32).to_le_bytes());
        bytes.extend(scales.flat_map(f32::to_le_bytes));
        // Offsets of the vertices of each level.
        bytes.resize(bytes.len() + 12 * lod_count, 0);
        let number = |x: usize| (x as u32).to_le_bytes();
        bytes.extend(self.lods.iter().flat_map(|lod| number(lod.fragments.len())));
        for lod in &self.lods {
            for axis in 0..3 {
                let place = |&fragment: &u64| coordinate(fragment, axis).to_le_bytes();
                bytes.extend(lod.fragments.keys().flat_map(place));
            }
            bytes.extend(lod.fragments.values().flat_map(|size| size.to_le_bytes()));
        }
        bytes
    }
}

impl SegmentLod {
    fn byte_count(&self) -> u64 {
        self.fragments.values().map(|&size| u64::from(size)).sum()
    }
}

/// A coordinate of the cell with a number in z-order.
fn coordinate(number: u64, axis: u32) -> u32 {
    (0..21).map(|bit| ((number >> (3 * bit + axis) & 1) as u32) << bit).sum()
}

/// The fragments of a block in z-order.
fn fragments(block: &TileBlock<'_>, mesh: IndexedMesh) -> Vec<Result<EncodedFragment, WriteError>> {
    // Vertices that differ in other data are one.
    let IndexedMesh { positions, triangles, .. } = mesh;
    let mesh = IndexedMesh { positions, triangles, ..IndexedMesh::default() };
    let level = LevelMesh::new(&mesh, block, 0.0);
    let mut tiles: Vec<(Cell, Vec<u32>)> = level.tiles().into_iter().collect();
    tiles.sort_by_key(|&(cell, _)| z_order(cell));
    let encoded = |(cell, triangles): &(Cell, Vec<u32>)| {
        let tile = level.tile(*cell, triangles)?;
        let side = i64::from(block.lattice.side);
        let from_corner = |point: &[i64; 3]| [0, 1, 2].map(|a| (point[a] - cell[a] * side) as i32);
        let points: Vec<[i32; 3]> = tile.points.iter().map(from_corner).collect();
        let fragment = |bytes| EncodedFragment {
            number: z_order(*cell),
            triangle_count: tile.mesh.triangles.len() as u64,
            bytes,
        };
        Some(encode_draco(&points, &tile.mesh.triangles).map(fragment))
    };
    tiles.par_iter().filter_map(encoded).collect()
}
