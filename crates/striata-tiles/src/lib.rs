//! 3D Tiles 1.1 from a paged file, without cracks between tiles.
//!
//! ```text
//!  paged file ──> tier of each step ──> levels and lattice ──> blocks of a level ──> tiles ──> GLB, tileset.json
//! ```
//!
//! Every level of the tileset has about a quarter of the triangles of the next finer one. The content of a tile is the
//! level of its error, refined to a sixteenth of that error wherever it meets a plane between tiles, and cut there. So
//! the cross-section at a plane is that of the finer level, on both sides: tiles of one level meet exactly, and the gap
//! between tiles of two levels is a fraction of a pixel when the coarser one is drawn at the limit of its error.
//! Vertices lie on a common lattice, so this also holds for integers.
//!
//! | file | what it does |
//! | --- | --- |
//! | `lattice.rs` | the lattice, the planes, the levels, and what is refined in a block of tiles |
//! | `tile_mesh.rs` | triangles cut at planes, and the mesh of a tile |
//! | `earth.rs` | from map coordinates to earth-centered ones |
//! | `tileset.rs`, `sink.rs` | `tileset.json`, and the folder or archive |
//!
//! Cost: each page is read once for the tiers and about twice for each level that needs it. Memory holds a block of
//! about a million triangles with its pages, and a byte per position.

mod earth;
mod error;
mod lattice;
mod sink;
mod tile_mesh;
mod tileset;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use rayon::prelude::*;
use serde::Serialize;
use serde_json::Value;
use striata::mesh::{Appearance, IndexedMesh};
use striata::{Progress, ProgressFn};
use striata_io::{Format, QuantizeOptions, WriteOptions, encode_mesh, shaded};
use striata_paged::{Metadata, PagedFile, StepTiers};

pub use error::TilesError;
pub use lattice::Up;
use lattice::{Cell, LevelTiers, TileBlock, TileLattice, TileShape};
use sink::Sink;
pub use sink::check_output;
use tile_mesh::{LevelMesh, TileMesh};
use tileset::{Tile, TileTree, path_of, turned};

/// Triangles of a block of tiles that are made together, about.
const BLOCK_TRIANGLES: u64 = 1 << 20;
/// Tiles that are encoded at the same time.
const ENCODED_TOGETHER: usize = 32;

/// How the vertices and triangles of tiles are stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TileFormat {
    /// Floats, which every reader knows.
    #[default]
    Float,
    /// Integers of 16 bits (`KHR_mesh_quantization`).
    Quantized,
    /// Integers, compressed with meshoptimizer (`EXT_meshopt_compression`).
    Meshopt,
    /// Integers, compressed with Draco (`KHR_draco_mesh_compression`).
    Draco,
}

/// Options of a tileset.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct TilesOptions {
    /// Triangles of a tile, about; default 16,384.
    pub tile_triangles: u64,
    /// How tiles are stored; default floats.
    pub format: TileFormat,
    /// Which axis of the mesh is up; default z for what has a georeference, is a height
    /// field or is flat along z, else y.
    pub up: Option<Up>,
    /// Whether a georeference is ignored, so that coordinates stay those of the mesh; default no.
    pub is_local: bool,
    /// Whether tiles of a terrain get vertical strips below their borders; default no.
    pub has_skirts: bool,
    /// Whether a mesh without normals gets smooth ones, and one without materials a matte one; default yes.
    pub shading: bool,
}

impl Default for TilesOptions {
    fn default() -> Self {
        Self {
            tile_triangles: 16_384,
            format: TileFormat::Float,
            up: None,
            is_local: false,
            has_skirts: false,
            shading: true,
        }
    }
}

/// Numbers of a tileset, and remarks on it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TilesReport {
    /// Number of tiles with a content.
    pub tiles: u64,
    /// Number of triangles of all tiles.
    pub triangles: u64,
    /// Number of bytes of all contents.
    pub bytes: u64,
    /// The levels, finest first.
    pub levels: Vec<TileLevel>,
    /// Geometric error of the root, in mesh units: an estimate, as errors of paged files are.
    pub error: f64,
    /// Distance of lattice points of the finest level, in mesh units.
    pub step: f64,
    /// Axis of the mesh that is up.
    pub up: &'static str,
    /// Coordinate system of the mesh, if the tileset is placed on the Earth.
    pub epsg: Option<u32>,
    /// Largest distance of a corner from its true place on the Earth, which is curved, in meters.
    pub curvature_error: Option<f64>,
    /// Remarks on data of the mesh that tiles do not contain.
    pub left_out: Vec<String>,
}

/// A level of a tileset.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TileLevel {
    /// Geometric error, in mesh units.
    pub error: f64,
    /// Number of tiles.
    pub tiles: u64,
    /// Number of triangles.
    pub triangles: u64,
    /// Number of bytes.
    pub bytes: u64,
}

/// Writes a tileset: a folder with `tileset.json`, or an archive if the path ends in `.3tz`.
///
/// # Errors
/// [`TilesError`]; an existing tileset is then unchanged.
pub fn write_tiles(
    file: &mut PagedFile,
    output: &Path,
    options: &TilesOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<TilesReport, TilesError> {
    check_output(output)?;
    let metadata = file.metadata().clone();
    let name = metadata.source.clone();
    if metadata.triangle_count == 0 {
        return Err(TilesError::Empty { name });
    }
    let tiers = file.tiers(|done, total| {
        Progress { phase: "read", done, total }.report(progress).map_err(TilesError::from)
    })?;
    let shape = TileShape::of(&metadata, &tiers, options.up);
    let up = shape.up;
    let base = file.reader().entry(0).map_or(0, |entry| u64::from(entry.triangle_count));
    let levels = shape.levels(&metadata, &tiers, base, options.tile_triangles);
    let lattice = TileLattice::new(&metadata, shape.is_divided, levels.len() as u32 - 1);
    if options.has_skirts && lattice.is_divided == [true; 3] {
        return Err(TilesError::Skirts { name });
    }
    let place = match metadata.georeference.as_ref().filter(|_| !options.is_local && up == Up::Z) {
        Some(georeference) => {
            let corner = |p: [f32; 3]| [0, 1, 2].map(|a| f64::from(p[a]) + metadata.origin[a]);
            let offset = [0, 1, 2].map(|a| metadata.origin[a] + lattice.origin[a]);
            earth::place(georeference, [corner(metadata.min), corner(metadata.max)], offset)?
        }
        None => None,
    };
    let mut sink = Sink::new(output)?;
    let mut tiler = Tiler {
        file,
        tiers: &tiers,
        lattice: &lattice,
        levels: &levels,
        options,
        up,
        tiles: BTreeMap::new(),
        warnings: left_out(&metadata),
    };
    tiler.write_all(output, &mut sink, progress)?;
    let Tiler { tiles, mut warnings, .. } = tiler;
    if metadata.georeference.is_some() && !options.is_local && place.is_none() {
        let reason = if up == Up::Y { "the z axis is not up" } else { "it names no coordinate system" };
        warnings.insert(format!("the georeference is left out: {reason}"));
    }
    if tiles.is_empty() {
        return Err(TilesError::Empty { name });
    }
    let errors = (0u32..).zip(&levels).map(|(number, level)| match number {
        0 => 0.0,
        _ => level.error + lattice.largest_move(number),
    });
    let tree =
        TileTree { lattice: &lattice, up, errors: errors.collect(), tiles, extent: metadata.diagonal() };
    let local = || {
        let [x, y, z] = turned(up, [0, 1, 2].map(|a| metadata.origin[a] + lattice.origin[a]));
        [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, x, y, z, 1.0]
    };
    let failed = |source| TilesError::Io { path: output.to_owned(), source };
    for (path, value) in tree.files(place.map_or_else(local, |place| place.matrix)) {
        sink.put(&path, value.to_string().as_bytes()).map_err(failed)?;
    }
    sink.finish(output).map_err(failed)?;
    Ok(report(&tree, place, warnings))
}

fn report(tree: &TileTree<'_>, place: Option<earth::EarthPlace>, warnings: BTreeSet<String>) -> TilesReport {
    let level = |(number, &error): (u32, &f64)| {
        let own = || tree.tiles.iter().filter(move |((level, _), _)| *level == number).map(|(_, tile)| tile);
        TileLevel {
            error,
            tiles: own().count() as u64,
            triangles: own().map(|tile| tile.triangle_count).sum(),
            bytes: own().map(|tile| tile.byte_count).sum(),
        }
    };
    let levels: Vec<TileLevel> = (0..).zip(&tree.errors).map(level).collect();
    TilesReport {
        tiles: tree.tiles.len() as u64,
        triangles: levels.iter().map(|level| level.triangles).sum(),
        bytes: levels.iter().map(|level| level.bytes).sum(),
        error: levels.last().map_or(0.0, |level| level.error),
        levels,
        step: tree.lattice.step(0),
        up: if tree.up == Up::Y { "y" } else { "z" },
        epsg: place.map(|place| place.epsg),
        curvature_error: place.map(|place| place.error),
        left_out: warnings.into_iter().collect(),
    }
}

/// Remarks on data of a mesh that tiles do not contain.
fn left_out(metadata: &Metadata) -> BTreeSet<String> {
    let mut warnings = BTreeSet::new();
    if let Some(first) = metadata.images.first() {
        let name = [&first.name, &first.uri].into_iter().find(|name| !name.is_empty());
        let name = name.map_or("without a name", String::as_str);
        let count = metadata.images.len();
        warnings.insert(format!("tiles have no textures: {count} images are left out, the first is {name}"));
    }
    for layer in &metadata.triangle_layers {
        let name = layer.semantic.strip_prefix("generic_").unwrap_or(&layer.semantic);
        warnings.insert(format!("the property {name} of faces is left out: tiles have none"));
    }
    warnings
}

/// Writes the contents of all tiles.
struct Tiler<'a> {
    file: &'a mut PagedFile,
    tiers: &'a StepTiers,
    lattice: &'a TileLattice,
    levels: &'a [LevelTiers],
    options: &'a TilesOptions,
    up: Up,
    tiles: BTreeMap<(u32, Cell), Tile>,
    warnings: BTreeSet<String>,
}

impl Tiler<'_> {
    fn write_all(
        &mut self,
        output: &Path,
        sink: &mut Sink,
        progress: &mut ProgressFn<'_>,
    ) -> Result<(), TilesError> {
        let top = self.levels.len() as u32 - 1;
        let mut height = 0;
        while height < top && 4u64.pow(height) * self.options.tile_triangles.max(1) < BLOCK_TRIANGLES {
            height += 1;
        }
        let blocks: Vec<(u32, [Cell; 2])> =
            (0..=top).rev().flat_map(|level| self.blocks(level, height)).collect();
        let total = blocks.len() as u64;
        for (done, (level, cells)) in (1..).zip(blocks) {
            self.write_block(level, cells, sink).map_err(|error| match error {
                BlockError::Tiles(error) => error,
                BlockError::Sink(source) => TilesError::Io { path: output.to_owned(), source },
            })?;
            Progress { phase: "tile", done, total }.report(progress)?;
        }
        Ok(())
    }

    /// Blocks of a level that the mesh may reach, with the tiles of each.
    fn blocks(&self, level: u32, height: u32) -> Vec<(u32, [Cell; 2])> {
        let top = self.levels.len() as u32 - 1;
        let height = height.min(top - level);
        let metadata = self.file.metadata();
        let last = |a: usize| {
            let high = self.lattice.place(metadata.max)[a];
            self.lattice.cells_of(a, high, high, level + height)[0]
        };
        let side = |a: usize| if self.lattice.is_divided[a] { 1 << height } else { 1 };
        let mut blocks = Vec::new();
        for x in 0..=last(0) {
            for y in 0..=last(1) {
                for z in 0..=last(2) {
                    let first = [0, 1, 2].map(|a| [x, y, z][a] * side(a));
                    blocks.push((level, [first, [0, 1, 2].map(|a| first[a] + side(a))]));
                }
            }
        }
        blocks
    }

    fn write_block(&mut self, number: u32, cells: [Cell; 2], sink: &mut Sink) -> Result<(), BlockError> {
        let block = TileBlock { lattice: self.lattice, level: self.levels[number as usize], number, cells };
        let cut = self.file.cut_tiers(self.tiers, |tier, bounds| block.wants(tier, bounds))?;
        let mesh = IndexedMesh { appearance: without_textures(cut.mesh.appearance), ..cut.mesh };
        let mesh = if self.options.shading { &*shaded(&mesh) } else { &mesh };
        let skirt = match self.levels.get(number as usize + 1) {
            Some(next) if self.options.has_skirts => {
                block.level.error + next.error + self.lattice.step(number + 1)
            }
            _ => 0.0,
        };
        let level = LevelMesh::new(mesh, &block, skirt);
        let tiles: Vec<(Cell, Vec<u32>)> = level.tiles().into_iter().collect();
        let options = self.write_options(number);
        for some in tiles.chunks(ENCODED_TOGETHER) {
            let encoded: Vec<_> = some
                .par_iter()
                .filter_map(|(cell, triangles)| Some((*cell, level.tile(*cell, triangles)?)))
                .map(|(cell, tile)| {
                    (
                        cell,
                        encode_mesh(Format::Glb, &tile.mesh, &options, None).map(|encoded| (encoded, tile)),
                    )
                })
                .collect();
            for (cell, encoded) in encoded {
                let (encoded, tile) = encoded?;
                sink.put(&path_of(number, cell, "glb"), &encoded.bytes).map_err(BlockError::Sink)?;
                self.warnings.extend(encoded.warnings.into_iter().map(|warning| warning.reason));
                let TileMesh { mesh } = &tile;
                let (triangle_count, byte_count) = (mesh.triangle_count() as u64, encoded.bytes.len() as u64);
                self.tiles.insert((number, cell), Tile { bounds: tile.bounds(), triangle_count, byte_count });
            }
        }
        Ok(())
    }

    fn write_options(&self, level: u32) -> WriteOptions {
        let options = WriteOptions::default().with_z_up(self.up == Up::Z).with_cache_order(true);
        let step = Some(self.lattice.exponent + level as i32);
        let quantized = || options.clone().with_quantize(QuantizeOptions::default().with_step_log2(step));
        match self.options.format {
            TileFormat::Float => options,
            TileFormat::Quantized => quantized(),
            TileFormat::Meshopt => quantized().with_meshopt(true),
            TileFormat::Draco => quantized().with_draco(true),
        }
    }
}

/// Error of a block.
enum BlockError {
    Tiles(TilesError),
    Sink(std::io::Error),
}

impl<E: Into<TilesError>> From<E> for BlockError {
    fn from(error: E) -> Self {
        Self::Tiles(error.into())
    }
}

/// Materials without what refers to textures.
fn without_textures(appearance: Appearance) -> Appearance {
    let mut appearance = Appearance {
        images: Vec::new(),
        textures_json: Vec::new(),
        samplers_json: Vec::new(),
        georeference: String::new(),
        ..appearance
    };
    for material in &mut appearance.materials {
        if let Ok(mut value) = serde_json::from_str(&material.gltf_json) {
            remove_textures(&mut value);
            material.gltf_json = value.to_string();
        }
    }
    appearance
}

/// Removes references to textures, which are objects with an index whose names end in `Texture`.
fn remove_textures(value: &mut Value) {
    if let Value::Object(members) = value {
        members.retain(|name, value| !(name.ends_with("Texture") && value.get("index").is_some()));
        members.iter_mut().for_each(|(_, value)| remove_textures(value));
    }
}
