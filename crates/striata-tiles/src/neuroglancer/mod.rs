//! Meshes of segments for Neuroglancer: the format `neuroglancer_multilod_draco`.
//!
//! ```text
//!  paged file of a segment ──> levels of cubes ──> Draco fragments in z-order ──> ID (data), ID.index (manifest)
//!                                                                             └──> shards
//! ```
//!
//! A level of detail ("lod") is a level of tiles whose sides have 2^bits − 1 steps. Neuroglancer draws the eighths of a
//! fragment one by one, next to finer fragments, so surfaces are also cut and refined at the planes of the next finer
//! level, to a quarter of the error of the level. In the integers of a fragment that plane is at 2^(bits−1), half a step above the middle.
//!
//! | file | what it does |
//! | --- | --- |
//! | `options.rs` | what can be chosen |
//! | `segment.rs` | the fragments and the manifest of one segment |
//! | `shards.rs` | many segments in a few files |

mod options;
mod segment;
mod shards;

use std::collections::BTreeSet;
use std::io::{self, BufWriter, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde_json::json;
use striata::ProgressFn;
use striata_paged::{Metadata, PagedFile};

use crate::TileLevel;
use crate::error::TilesError;
use crate::sink::{FolderSink, GENERATOR, check_folder};
pub use options::{NeuroglancerOptions, VertexBits};
use segment::Segment;
use shards::Shards;
pub use shards::{ShardHash, Sharding};

/// Numbers of meshes for Neuroglancer, and remarks on them.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct NeuroglancerReport {
    /// Number of segments.
    pub segments: u64,
    /// Number of fragments that are not empty.
    pub fragments: u64,
    /// Number of triangles of all fragments.
    pub triangles: u64,
    /// Number of bytes of all fragments and manifests.
    pub bytes: u64,
    /// The levels of detail of all segments, finest first; errors are the largest.
    pub levels: Vec<TileLevel>,
    /// Largest step of coordinates of the finest level, in mesh units.
    pub step: f64,
    /// Remarks on data of the meshes that are not written.
    pub left_out: Vec<String>,
}

/// Writes a folder of meshes for Neuroglancer, one segment after the other.
#[derive(Debug)]
pub struct NeuroglancerWriter {
    output: PathBuf,
    options: NeuroglancerOptions,
    sink: FolderSink,
    shards: Option<Shards>,
    ids: BTreeSet<u64>,
    /// Origin of the first segment, from which coordinates are stored.
    origin: [f64; 3],
    left_out: BTreeSet<String>,
    report: NeuroglancerReport,
}

impl NeuroglancerWriter {
    /// Begins a folder, which gets its name when it is finished.
    ///
    /// # Errors
    /// [`TilesError::Place`] if something else has that name, [`TilesError::Io`] if nothing can be written there.
    pub fn new(output: &Path, options: NeuroglancerOptions) -> Result<Self, TilesError> {
        check_folder(output)?;
        Ok(Self {
            output: output.to_owned(),
            sink: FolderSink::new(output)?,
            shards: options.sharding.map(Shards::new),
            options,
            ids: BTreeSet::new(),
            origin: [0.0; 3],
            left_out: BTreeSet::new(),
            report: NeuroglancerReport::default(),
        })
    }

    /// Adds a segment. After an error nothing can be added any more.
    ///
    /// # Errors
    /// [`TilesError`]; [`TilesError::Segment`] if the identifier is taken or coordinates are too large.
    pub fn add(
        &mut self,
        id: u64,
        file: &mut PagedFile,
        progress: &mut ProgressFn<'_>,
    ) -> Result<(), TilesError> {
        if !self.ids.insert(id) {
            return Err(TilesError::Segment { id, reason: "there are two meshes of this segment" });
        }
        if self.ids.len() == 1 {
            self.origin = file.metadata().origin;
        }
        self.left_out.extend(left_out(file.metadata()));
        let output = self.output.clone();
        let failed = |source| TilesError::Io { path: output.clone(), source };
        let name = match &self.shards {
            Some(shards) => shards.file_of(id),
            None => id.to_string(),
        };
        let mut data = self.sink.open(&name).map_err(failed)?;
        let mut start = data.seek(SeekFrom::End(0)).map_err(failed)?;
        if let Some(shards) = self.shards.as_ref().filter(|_| start == 0) {
            start = shards.index_bytes();
            data.seek(SeekFrom::Start(start)).map_err(failed)?;
        }
        let mut data = BufWriter::new(data);
        let segment = Segment::write(id, file, &self.options, progress, &mut |bytes| {
            data.write_all(bytes).map_err(failed)
        })?;
        let manifest = segment.manifest(self.origin);
        let size = segment.byte_count();
        let mut put = || -> io::Result<()> {
            match &mut self.shards {
                Some(shards) => {
                    data.write_all(&manifest)?;
                    shards.add(id, start + size, manifest.len() as u64);
                }
                None => self.sink.open(&format!("{id}.index"))?.write_all(&manifest)?,
            }
            data.flush()
        };
        put().map_err(failed)?;
        self.count(&segment, size + manifest.len() as u64);
        Ok(())
    }

    fn count(&mut self, segment: &Segment, byte_count: u64) {
        let report = &mut self.report;
        report.segments += 1;
        report.bytes += byte_count;
        report.step = report.step.max(segment.step());
        for (number, level) in segment.levels().enumerate() {
            report.fragments += level.tiles;
            report.triangles += level.triangles;
            match report.levels.get_mut(number) {
                None => report.levels.push(level),
                Some(all) => {
                    all.error = all.error.max(level.error);
                    all.tiles += level.tiles;
                    all.triangles += level.triangles;
                    all.bytes += level.bytes;
                }
            }
        }
    }

    /// Writes what describes all segments, and gives the folder its name.
    ///
    /// # Errors
    /// [`TilesError::Io`]; a folder that was there is then unchanged.
    pub fn finish(mut self) -> Result<NeuroglancerReport, TilesError> {
        let output = self.output.clone();
        self.finish_files().map_err(|source| TilesError::Io { path: output.clone(), source })?;
        let mut report = self.report;
        report.left_out = self.left_out.into_iter().collect();
        self.sink.finish(&output).map_err(|source| TilesError::Io { path: output, source })?;
        Ok(report)
    }

    fn finish_files(&mut self) -> io::Result<()> {
        if let Some(shards) = &self.shards {
            shards.write_indices(&mut self.sink)?;
        }
        let [x, y, z] = self.origin;
        let mut info = json!({
            "@type": "neuroglancer_multilod_draco",
            "vertex_quantization_bits": self.options.bits.count(),
            "transform": [1.0, 0.0, 0.0, x, 0.0, 1.0, 0.0, y, 0.0, 0.0, 1.0, z],
            "lod_scale_multiplier": 1.0,
            "segment_properties": "segment_properties",
            "generator": GENERATOR,
        });
        if let Some(sharding) = self.options.sharding {
            info["sharding"] = sharding.to_json();
        }
        let ids: Vec<String> = self.ids.iter().map(u64::to_string).collect();
        let properties = json!({
            "@type": "neuroglancer_segment_properties",
            "inline": { "ids": ids, "properties": [] },
        });
        self.sink.open("info")?.write_all(info.to_string().as_bytes())?;
        self.sink.open("segment_properties/info")?.write_all(properties.to_string().as_bytes())
    }
}

/// Remarks on data of a mesh that have no place in the format.
fn left_out(metadata: &Metadata) -> Vec<String> {
    const REASON: &str = "meshes of Neuroglancer are positions and triangles";
    let mut names = Vec::new();
    for layer in &metadata.empty_mesh().layers {
        if !Metadata::is_material_layer(layer) {
            names.push(format!("{} of vertices", layer.semantic));
        }
    }
    for layer in &metadata.triangle_layers {
        let name = layer.semantic.strip_prefix("generic_").unwrap_or(&layer.semantic);
        names.push(format!("the property {name} of faces"));
    }
    if metadata.groups.iter().any(|group| group.material.is_some()) {
        names.push("the materials".to_owned());
    }
    if metadata.groups.iter().any(|group| !group.name.is_empty()) {
        names.push("the names of groups".to_owned());
    }
    if !metadata.images.is_empty() {
        names.push("the images of textures".to_owned());
    }
    if metadata.georeference.is_some() {
        names.push("the georeference".to_owned());
    }
    names.into_iter().map(|name| format!("left out: {name}; {REASON}")).collect()
}
