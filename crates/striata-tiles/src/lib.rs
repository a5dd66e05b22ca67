//! 3D Tiles 1.1 and meshes for Neuroglancer from paged files, without cracks between tiles.
//!
//! ```text
//!  paged file ──> tier of each step ──> levels and lattice ──> blocks of a level ──> tiles ──> GLB, tileset.json
//!                                                                                         └──> Draco, manifest
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
//! | `blocks.rs` | blocks of tiles, cut out of a paged file |
//! | `tile_mesh.rs` | triangles cut at planes, and the mesh of a tile |
//! | `earth.rs` | from map coordinates to earth-centered ones |
//! | `textures/` | images, and the atlases of tiles |
//! | `tileset.rs`, `sink.rs` | `tileset.json`, and the folder or archive |
//! | `neuroglancer/` | fragments, manifests and shards of Neuroglancer |
//! | `zarr/` | arrays in refinement order, which are no tiles |
//!
//! Cost: each page is read once for the tiers and about twice for each level that needs it. Memory holds a block of
//! about a million triangles with its pages, and a byte per position. Textures add a pass over the finest surface;
//! memory holds one decoded image at a time, and a file next to the output a third more than all of them.

mod blocks;
mod earth;
mod error;
mod lattice;
mod neuroglancer;
mod sink;
mod textures;
mod tile_mesh;
mod tileset;
mod zarr;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use rayon::prelude::*;
use serde::Serialize;
use striata::mesh::IndexedMesh;
use striata::{Progress, ProgressFn};
use striata_io::{Format, QuantizeOptions, WriteOptions, encode_mesh, shaded};
use striata_paged::{Metadata, PagedFile};

use blocks::{TileLevels, levels_of};
pub use error::TilesError;
pub use lattice::Up;
use lattice::{Cell, LevelTiers, TileBlock, TileLattice, TileShape, bounded};
pub use neuroglancer::{
    NeuroglancerOptions, NeuroglancerReport, NeuroglancerWriter, ShardHash, Sharding, VertexBits,
};
use sink::Sink;
pub use sink::{check_folder, check_output};
use textures::{DressedTile, TEXELS_PER_ERROR, TileTextures, without_textures};
use tile_mesh::LevelMesh;
use tileset::{Tile, TileTree, path_of, turned};
pub use zarr::{ZarrLevel, ZarrReport, write_zarr};

/// A level with a larger share of triangles that have corners in several charts is worth a remark.
const MOST_MIXED: f64 = 0.05;
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
    /// Whether tiles have the textures of the mesh; default yes.
    pub has_textures: bool,
    /// Quality of the JPEG images of textures, 1 to 100; default 90.
    pub texture_quality: u8,
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
            has_textures: true,
            texture_quality: 90,
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
    /// Number of texture atlases, each with the charts of a material of a tile.
    pub atlases: u64,
    /// Number of bytes of all images of textures.
    pub image_bytes: u64,
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
    let metadata = bounded(file.metadata());
    let name = metadata.source.clone();
    if metadata.triangle_count == 0 {
        return Err(TilesError::Empty { name });
    }
    let tiers = file.tiers(|done, total| {
        Progress { phase: "read", done, total }.report(progress).map_err(TilesError::from)
    })?;
    let mut warnings = left_out(&metadata);
    let textures = match options.has_textures && !metadata.images.is_empty() {
        true => {
            let textures = TileTextures::read(file, &tiers, output, options.texture_quality, progress)?;
            warnings.extend(textures.warnings.iter().cloned());
            Some(textures)
        }
        false => None,
    };
    let shape = TileShape::of(&metadata, &tiers, options.up);
    let up = shape.up;
    // As many tiles as textures need, if that is more.
    let tile_triangles =
        textures.as_ref().map_or(f64::INFINITY, |textures| textures.tile_triangles(&metadata));
    let tile_triangles = tile_triangles.min(options.tile_triangles.max(1) as f64);
    let levels = levels_of(file, shape, &tiers, tile_triangles);
    let texels: Vec<f64> = match &textures {
        Some(textures) => shape.texels(&metadata, textures, &levels),
        None => vec![0.0; levels.len()],
    };
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
        lattice: &lattice,
        levels: &levels,
        textures: textures.as_ref().map(|textures| (textures, &texels[..])),
        options,
        up,
        tiles: BTreeMap::new(),
        image_counts: [0; 2],
        mixed_counts: vec![[0; 2]; levels.len()],
        warnings,
    };
    let failed = |source| TilesError::Io { path: output.to_owned(), source };
    let tile_levels = TileLevels { tiers: &tiers, lattice: &lattice, levels: &levels, tile_triangles };
    tile_levels.for_each_block(file, (0..levels.len() as u32).rev(), progress, |block, mesh| {
        tiler.write_block(block, mesh, &mut sink).map_err(|error| match error {
            BlockError::Tiles(error) => error,
            BlockError::Sink(source) => failed(source),
        })
    })?;
    let Tiler { tiles, image_counts, mixed_counts, mut warnings, .. } = tiler;
    let is_smeared = |&(_, &[mixed, all]): &(usize, &[u64; 2])| mixed as f64 > MOST_MIXED * all as f64;
    if let Some((level, [mixed, all])) = mixed_counts.iter().enumerate().find(is_smeared) {
        let percent = 100 * mixed / all;
        warnings.insert(format!(
            "the charts of textures are small: {percent} % of the triangles of level {level} had corners in several, \
             which smears their colors"
        ));
    }
    if metadata.georeference.is_some() && !options.is_local && place.is_none() {
        let reason = if up == Up::Y { "the z axis is not up" } else { "it names no coordinate system" };
        warnings.insert(format!("the georeference is left out: {reason}"));
    }
    if tiles.is_empty() {
        return Err(TilesError::Empty { name });
    }
    let errors = (0u32..).zip(&levels).zip(&texels).map(|((number, level), texel)| match number {
        0 => 0.0,
        _ => (level.error + lattice.largest_move(number)).max(TEXELS_PER_ERROR * texel),
    });
    let tree =
        TileTree { lattice: &lattice, up, errors: errors.collect(), tiles, extent: metadata.diagonal() };
    let local = || {
        let [x, y, z] = turned(up, [0, 1, 2].map(|a| metadata.origin[a] + lattice.origin[a]));
        [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, x, y, z, 1.0]
    };
    for (path, value) in tree.files(place.map_or_else(local, |place| place.matrix)) {
        sink.put(&path, value.to_string().as_bytes()).map_err(failed)?;
    }
    sink.finish(output).map_err(failed)?;
    let [atlases, image_bytes] = image_counts;
    Ok(TilesReport { atlases, image_bytes, ..report(&tree, place, warnings) })
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
        atlases: 0,
        image_bytes: 0,
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
    for layer in &metadata.triangle_layers {
        let name = layer.semantic.strip_prefix("generic_").unwrap_or(&layer.semantic);
        warnings.insert(format!("the property {name} of faces is left out: tiles have none"));
    }
    if metadata.empty_mesh().layers.iter().any(|layer| layer.semantic.is_of_poses()) {
        warnings.insert("joints and morph targets of vertices are left out: tiles do not move".to_owned());
    }
    warnings
}

/// Writes the contents of all tiles.
struct Tiler<'a> {
    lattice: &'a TileLattice,
    levels: &'a [LevelTiers],
    /// The textures, and the length of their texels at each level.
    textures: Option<(&'a TileTextures, &'a [f64])>,
    options: &'a TilesOptions,
    up: Up,
    tiles: BTreeMap<(u32, Cell), Tile>,
    /// Number of atlases, and of the bytes of all images.
    image_counts: [u64; 2],
    /// Number of triangles of each level with corners in several charts, and of all.
    mixed_counts: Vec<[u64; 2]>,
    warnings: BTreeSet<String>,
}

impl Tiler<'_> {
    fn write_block(
        &mut self,
        block: &TileBlock<'_>,
        mut mesh: IndexedMesh,
        sink: &mut Sink,
    ) -> Result<(), BlockError> {
        let number = block.number;
        mesh.layers.retain(|layer| !layer.semantic.is_of_poses());
        if let Some((textures, _)) = self.textures {
            let all = mesh.triangles.len() as u64;
            self.mixed_counts[number as usize][0] += textures.unmix(&mut mesh);
            self.mixed_counts[number as usize][1] += all;
        }
        let mesh = if self.options.shading { &*shaded(&mesh) } else { &mesh };
        let skirt = match self.levels.get(number as usize + 1) {
            Some(next) if self.options.has_skirts => {
                block.level.error + next.error + self.lattice.step(number + 1)
            }
            _ => 0.0,
        };
        let level = LevelMesh::new(mesh, block, skirt);
        let tiles: Vec<(Cell, Vec<u32>)> = level.tiles().into_iter().collect();
        let options = self.write_options(number);
        for some in tiles.chunks(ENCODED_TOGETHER) {
            let encoded: Vec<Result<_, BlockError>> = some
                .par_iter()
                .filter_map(|(cell, triangles)| Some((*cell, level.tile(*cell, triangles)?)))
                .map(|(cell, tile)| {
                    let bounds = tile.bounds();
                    let tile = self.dressed(tile.mesh, number)?;
                    let encoded = encode_mesh(Format::Glb, &tile.mesh, &options, None)?;
                    Ok((cell, bounds, tile, encoded))
                })
                .collect();
            for encoded in encoded {
                let (cell, bounds, tile, encoded) = encoded?;
                sink.put(&path_of(number, cell, "glb"), &encoded.bytes).map_err(BlockError::Sink)?;
                self.warnings.extend(encoded.warnings.into_iter().map(|warning| warning.reason));
                self.warnings.extend(tile.reduced.map(|name| {
                    format!(
                        "images of the material {name} are reduced: they do not fit into an atlas of a tile"
                    )
                }));
                let DressedTile { mesh, atlas_count, image_bytes, .. } = tile;
                self.image_counts = [self.image_counts[0] + atlas_count, self.image_counts[1] + image_bytes];
                let (triangle_count, byte_count) = (mesh.triangle_count() as u64, encoded.bytes.len() as u64);
                self.tiles.insert((number, cell), Tile { bounds, triangle_count, byte_count });
            }
        }
        Ok(())
    }

    /// A tile with its textures.
    fn dressed(&self, mesh: IndexedMesh, level: u32) -> Result<DressedTile, BlockError> {
        match self.textures {
            Some((textures, texels)) => {
                let texel = if level == 0 { 0.0 } else { texels[level as usize] };
                textures.dress(&mesh, texel).map_err(BlockError::Sink)
            }
            None => {
                let mesh = IndexedMesh { appearance: without_textures(mesh.appearance), ..mesh };
                Ok(DressedTile { mesh, atlas_count: 0, image_bytes: 0, reduced: None })
            }
        }
    }

    fn write_options(&self, level: u32) -> WriteOptions {
        let options = WriteOptions::default().with_z_up(self.up == Up::Z).with_cache_order(true);
        let step = Some(self.lattice.step_log2(level));
        let quantize = QuantizeOptions::default().with_step_log2(step);
        // Twelve bits are half a texel of an atlas.
        let quantize = if self.textures.is_some() { quantize.with_texcoord_bits(14) } else { quantize };
        let quantized = || options.clone().with_quantize(quantize.clone());
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
